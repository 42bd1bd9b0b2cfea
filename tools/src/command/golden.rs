//! `pinhole golden`: make goldens with Mitsuba, and verify them.

use std::ffi::{OsStr, OsString};
use std::fs;
use std::path::{Path, PathBuf};

use pinhole::Scene;
use pinhole::judge::Golden as GoldenFilm;
use serde_json::json;

use super::Outcome;
use crate::assignment::Assignment;
use crate::checkout::Checkout;
use crate::cli::{Golden, GoldenRender, GoldenVerify};
use crate::error::{Error, Result};
use crate::manifest::Manifest;
use crate::mitsuba::{self, Item, Renderer};
use crate::progress::Progress;

/// The seed of the committed probes.
const COMMITTED_SEED: u64 = 1;

pub fn run(checkout: &Checkout, arguments: &Golden) -> Result<Outcome> {
    match arguments {
        Golden::Setup => {
            anstream::eprintln!("installing Mitsuba and oiiotool, about 200 MB …");
            mitsuba::setup(checkout)?;
            anstream::println!("{} is ready", mitsuba::environment(checkout).display());
            Ok(Outcome::Well)
        }
        Golden::Render(arguments) => render(checkout, arguments),
        Golden::Verify(arguments) => verify(checkout, arguments),
    }
}

fn render(checkout: &Checkout, arguments: &GoldenRender) -> Result<Outcome> {
    let assignment = Assignment::around(checkout, &std::env::current_dir().unwrap_or_default())?;
    let own = checkout.golden(&assignment.name);
    let folder = arguments.out.clone().unwrap_or_else(|| own.clone());
    let scenes = scenes(arguments, &assignment)?;
    let is_own = |scene: &PathBuf| scene.starts_with(&assignment.folder);
    if arguments.out.is_none() && !scenes.iter().all(is_own) {
        return Err(Error::input(
            "goldens of scenes that are not the assignment's need a folder of their own",
            "say where: --out DIR",
        ));
    }
    for scene in &scenes {
        Scene::read(scene)?;
    }
    fs::create_dir_all(&folder).map_err(|error| {
        let problem = format!("cannot make {}: {error}", folder.display());
        Error::input(problem, "name a folder you may write to")
    })?;

    let progress = Progress::new();
    progress.say("Mitsuba");
    let mut manifest = Manifest::read_or_new(&folder)?;
    if !scenes.is_empty() {
        let mut line: Vec<OsString> = vec!["scenes".into()];
        line.extend(scenes.iter().map(OsString::from));
        let (renderer, items) = python(checkout, line, &folder, &progress)?;
        enter(&mut manifest, &renderer, &items, &folder, checkout)?;
        for scene in &scenes {
            manifest.add_scene(scene, &folder, checkout)?;
        }
    }
    if let Some(seed) = arguments.seed {
        let line = vec![
            "random-scenes".into(),
            "--seed".into(),
            seed.to_string().into(),
        ];
        let (renderer, items) = python(checkout, line, &folder, &progress)?;
        enter(&mut manifest, &renderer, &items, &folder, checkout)?;
        for item in &items {
            let scene = folder
                .join("scenes")
                .join(&item.name)
                .with_extension("toml");
            manifest.add_scene(&scene, &folder, checkout)?;
        }
    }
    if arguments.scenes.is_empty() {
        let seed = arguments.seed.unwrap_or(COMMITTED_SEED);
        let line = vec!["probes".into(), "--seed".into(), seed.to_string().into()];
        let (renderer, items) = python(checkout, line, &folder, &progress)?;
        enter(&mut manifest, &renderer, &items, &folder, checkout)?;
        manifest.probe_seed = Some(seed);
    }
    manifest.write(&folder)?;
    progress.clear();
    anstream::println!("{} films in {}", manifest.films.len(), folder.display());
    Ok(Outcome::Well)
}

/// The scene files to render: those named, or all of the assignment's.
fn scenes(arguments: &GoldenRender, assignment: &Assignment) -> Result<Vec<PathBuf>> {
    if arguments.seed.is_some() {
        return Ok(Vec::new());
    }
    if arguments.scenes.is_empty() {
        return Ok(assignment
            .scenes
            .iter()
            .map(|scene| assignment.scene(&scene.name))
            .collect());
    }
    let find = |named: &String| {
        let candidates = [PathBuf::from(named), assignment.scene(named)];
        candidates
            .into_iter()
            .find(|path| path.is_file())
            .ok_or_else(|| {
                Error::input(
                    format!("there is no scene {named}"),
                    "name a TOML file or a scene",
                )
            })
    };
    arguments.scenes.iter().map(find).collect()
}

fn python(
    checkout: &Checkout,
    mut line: Vec<OsString>,
    folder: &Path,
    progress: &Progress,
) -> Result<(Renderer, Vec<Item>)> {
    line.extend(["--out".into(), folder.into()]);
    let line: Vec<&OsStr> = line.iter().map(OsString::as_os_str).collect();
    mitsuba::render(checkout, &line, progress)
}

fn enter(
    manifest: &mut Manifest,
    renderer: &Renderer,
    items: &[Item],
    folder: &Path,
    checkout: &Checkout,
) -> Result<()> {
    manifest.set_renderer(renderer, checkout)?;
    let films = items.iter().flat_map(|item| &item.files);
    let films = films.filter(|file| file.extension().is_some_and(|extension| extension == "exr"));
    films
        .into_iter()
        .try_for_each(|film| manifest.add_film(film, folder))
}

fn verify(checkout: &Checkout, arguments: &GoldenVerify) -> Result<Outcome> {
    let assignment = Assignment::around(checkout, &std::env::current_dir().unwrap_or_default())?;
    let own = checkout.golden(&assignment.name);
    let folder = arguments.dir.as_ref().unwrap_or(&own);
    let manifest = Manifest::read(folder)?;
    let mut problems = manifest.out_of_step(folder, checkout);
    problems.extend(unusable(&manifest, folder));
    if *folder == own {
        problems.extend(absent(&manifest, &assignment));
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
            0 => anstream::println!("{films} films by Mitsuba {} are in step", manifest.mitsuba),
            _ => anstream::println!("make them again: cargo run --release -- golden render"),
        }
    }
    Ok(if problems.is_empty() {
        Outcome::Well
    } else {
        Outcome::JudgedWrong
    })
}

/// Goldens that cannot judge: unreadable, not fitting their tolerance, or too lenient.
fn unusable(manifest: &Manifest, folder: &Path) -> Vec<String> {
    let is_golden = |name: &&String| !name.ends_with(".tol.exr") && !name.ends_with(".ask.exr");
    let mut problems = Vec::new();
    for name in manifest.films.keys().filter(is_golden) {
        match GoldenFilm::read(&folder.join(name)) {
            Err(error) => problems.push(error.to_string()),
            Ok(golden) => {
                let pixels = golden.film().resolution().pixels();
                let exempt = (0..pixels).filter(|index| golden.is_exempt(*index)).count();
                // One pixel or 0.05 %, whichever is more.
                if exempt > (pixels / 2000).max(1) {
                    problems.push(format!("{name} exempts {exempt} of {pixels} pixels"));
                }
            }
        }
    }
    problems
}

/// Goldens the assignment needs and the manifest lacks.
fn absent(manifest: &Manifest, assignment: &Assignment) -> Vec<String> {
    let scenes = assignment
        .scenes
        .iter()
        .map(|scene| format!("{}.exr", scene.name));
    let groups = assignment.tasks.iter().flat_map(|task| {
        let groups = task.points.iter().filter(|(group, _)| group != "scenes");
        groups.map(|(group, _)| format!("probes/{}.{group}.exr", task.name))
    });
    let needed = scenes
        .chain(groups)
        .filter(|name| !manifest.films.contains_key(name));
    needed
        .map(|name| format!("{name} is needed by assignment.toml, but was never made"))
        .collect()
}
