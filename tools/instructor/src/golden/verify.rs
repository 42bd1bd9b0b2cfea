//! `pinhole golden verify`: checks that the goldens, and the scenes and scripts that they were made
//! from, match the manifest.

use std::path::Path;

use pinhole::judge::Golden as GoldenFilm;
use serde_json::json;

use super::arguments::GoldenVerify;
use super::inside;
use pinhole_course::assignment::Assignment;
use pinhole_course::checkout::Checkout;
use pinhole_course::error::Result;
use pinhole_course::manifest::Manifest;
use pinhole_report::program::Status;

pub fn verify(
    assignment: &Assignment,
    checkout: &Checkout,
    arguments: &GoldenVerify,
) -> Result<Status> {
    let own = assignment.golden();
    let folder = arguments.dir.as_ref().unwrap_or(&own);
    let manifest = Manifest::read(folder)?;
    let mut problems = manifest.out_of_step(folder, assignment, checkout)?;
    problems.extend(unusable(&manifest, folder));
    if inside(folder, &own) {
        problems.extend(absent(&manifest, assignment));
    }
    let films = manifest.films.len();
    if arguments.json {
        anstream::println!(
            "{:#}",
            json!({ "films": films, "mitsuba": manifest.mitsuba, "problems": problems })
        );
    } else {
        for problem in &problems {
            anstream::println!("{problem}");
        }
        match problems.len() {
            0 => anstream::println!(
                "{films} films by Mitsuba {} match their manifest",
                manifest.mitsuba
            ),
            _ => anstream::println!(
                "restore the files (git checkout); or, if they should change, make them again: \
                 cargo pinhole golden render --force"
            ),
        }
    }
    Ok(if problems.is_empty() {
        Status::Well
    } else {
        Status::JudgedWrong
    })
}

/// Goldens that can't be used: unreadable, without a matching tolerance film, or with too many
/// exempt pixels.
fn unusable(manifest: &Manifest, folder: &Path) -> Vec<String> {
    let others = [
        ".tol.exr",
        ".ask.exr",
        ".mistakes.exr",
        ".tests.exr",
        ".toml",
    ];
    let is_golden = |name: &&String| !others.iter().any(|end| name.ends_with(end));
    let goldens = manifest.films.keys().filter(is_golden);
    goldens
        .filter_map(|name| GoldenFilm::read(&folder.join(name)).err())
        .map(|error| error.to_string())
        .collect()
}

/// Goldens that the assignment needs but the manifest doesn't have.
fn absent(manifest: &Manifest, assignment: &Assignment) -> Vec<String> {
    let scenes = assignment
        .scenes
        .iter()
        .map(|scene| format!("{}.exr", scene.name));
    let groups = assignment.tasks.iter().flat_map(|task| {
        let groups = task.points.iter().map(|points| &points.group);
        groups
            .filter(|group| *group != "scenes")
            .map(|group| format!("probes/{}.{group}.exr", task.name))
    });
    let needed = scenes
        .chain(groups)
        .filter(|name| !manifest.films.contains_key(name));
    needed
        .map(|name| format!("{name} is needed by assignment.toml, but was never made"))
        .collect()
}
