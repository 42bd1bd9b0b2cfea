//! Figures that answer to a hand, and their static pictures.
//!
//! The static picture is a figure as any other, and stands in the page; a script wakes it.
//! The script is TypeScript in `book/interactive`, kept bundled beside this package so
//! that building the book needs no Node.js. What it must know of the course, it reads
//! from `facts.json`, which is written here. Its mathematics is tested against the
//! goldens of the probes.

mod probes;

use std::path::PathBuf;
use std::process::Command;

use pinhole::{Projection, Resolution, Scene};
use pinhole_course::checkout::Checkout;
use serde_json::{Value, json};

use crate::course::scratch;
use crate::error::{Error, Problem, Result, Wrong};
use crate::figures;
use crate::figures::colour;
use crate::silhouette::{DISTANCES, Meets, WAYS, wrong};
use crate::worked::{PIXEL, RAY, SPHERE, TRIANGLE, slide};

/// The bundle that pages load.
pub const BUNDLE: &str = include_str!("../assets/interactive.js");

/// Where the bundle is kept.
const KEPT: &str = "tools/book/assets/interactive.js";

/// What the script knows of the course.
const FACTS: &str = "book/interactive/src/facts.json";

const AGAIN: &str = "make them again: cargo pinhole book bundle";

/// HTML of a figure: its static picture, which the script replaces if it can.
pub fn shown(
    name: &str,
    alternative: &str,
    to_root: &str,
    checkout: &Checkout,
) -> std::result::Result<String, Wrong> {
    let still = figures::shown(name, alternative, to_root, checkout)?;
    Ok(format!(
        "<figure class=\"interactive\" data-figure=\"{name}\">\n<div class=\"stage\">\n{still}\n</div>\n</figure>\n"
    ))
}

/// The facts: the lecture's scene, the worked ray and shapes, and the objects' colours.
fn facts(checkout: &Checkout) -> Result<Value> {
    let Scene {
        camera,
        resolution: Resolution { n_x, n_y },
        min_t,
        objects,
    } = slide(checkout)?;
    let forward = match camera.projection {
        Projection::Perspective { focal_length } => focal_length,
        Projection::Orthographic => 0.0,
    };
    let [r, g, b] = pinhole::false_colour::BACKGROUND.0;
    Ok(json!({
        "written_by": "cargo pinhole book bundle",
        "slide": {
            "camera": camera,
            "forward": forward,
            "resolution": { "n_x": n_x, "n_y": n_y },
            "pixel": { "i": PIXEL.i, "j": PIXEL.j },
            "min_t": min_t,
            "objects": objects,
        },
        "worked": { "ray": RAY, "sphere": SPHERE, "triangle": TRIANGLE },
        "afar": afar(),
        "colours": (0..8).map(colour).collect::<Vec<String>>(),
        "background": format!("#{r:02x}{g:02x}{b:02x}"),
    }))
}

/// In how many pixels each way is wrong about a sphere from afar.
fn afar() -> Vec<Value> {
    let all = WAYS.iter().flat_map(|way| DISTANCES.map(|far| (*way, far)));
    let one = |((way, meets), far): ((&str, Meets), f64)| json!({ "way": way, "far": far, "wrong": wrong(meets, far) });
    all.map(one).collect()
}

fn facts_text(checkout: &Checkout) -> Result<String> {
    Ok(format!("{:#}\n", facts(checkout)?))
}

/// Writes the facts, and bundles the script.
pub fn bundle(checkout: &Checkout) -> Result<()> {
    checkout.write(FACTS, facts_text(checkout)?)?;
    let bundle = npm(&["run", "--silent", "bundle"], &[], checkout)?;
    let bundle = bundle.map_err(|said| Problem::of("book/interactive", said, "mend the script"))?;
    Ok(checkout.write(KEPT, bundle)?)
}

/// What is wrong with the figures: stale facts or bundle, types, mathematics.
pub fn check(checkout: &Checkout) -> Result<Vec<Problem>> {
    let mut problems = Vec::new();
    if checkout.read(FACTS).ok() != Some(facts_text(checkout)?) {
        let stale = "the facts are not those of the course";
        problems.push(Problem::of(FACTS, stale, AGAIN));
        return Ok(problems);
    }
    let file = scratch(checkout).join("probes.json");
    checkout.write(&file, probes::probes(checkout)?.to_string())?;
    let probes = ("PINHOLE_PROBES", file.display().to_string());
    for script in ["types", "test"] {
        if let Err(said) = npm(
            &["run", "--silent", script],
            std::slice::from_ref(&probes),
            checkout,
        )? {
            problems.push(Problem::of("book/interactive", said, "mend the script"));
        }
    }
    match npm(&["run", "--silent", "bundle"], &[], checkout)? {
        Ok(bundle) => problems.extend(stale(BUNDLE, &bundle)),
        Err(said) => problems.push(Problem::of("book/interactive", said, "mend the script")),
    }
    Ok(problems)
}

/// The bundle that pages load, if it is not the one that was made now.
fn stale(kept: &str, made: &str) -> Option<Problem> {
    (kept != made).then(|| Problem::of(KEPT, "the bundle is not of this script", AGAIN))
}

/// Runs npm in the script's folder, with what the lock file names installed. Gives what
/// it prints; as an error, if it fails.
pub fn npm(
    arguments: &[&str],
    environment: &[(&str, String)],
    checkout: &Checkout,
) -> Result<std::result::Result<String, String>> {
    let folder = folder(checkout);
    if !folder.join("node_modules/.package-lock.json").is_file() {
        started(&folder, &["ci", "--silent", "--no-audit", "--no-fund"], &[])?.map_err(|said| {
            Error::environment(
                format!("npm ci: {said}"),
                "see that npm reaches its registry",
            )
        })?;
    }
    started(&folder, arguments, environment)
}

/// Where the script lies.
pub fn folder(checkout: &Checkout) -> PathBuf {
    checkout.book().join("interactive")
}

fn started(
    folder: &std::path::Path,
    arguments: &[&str],
    environment: &[(&str, String)],
) -> Result<std::result::Result<String, String>> {
    let remedy = "install Node.js 20 or newer with npm";
    let output = Command::new("npm")
        .args(arguments)
        .envs(environment.iter().map(|(name, value)| (name, value)))
        .current_dir(folder)
        .output()
        .map_err(|error| Error::environment(format!("npm does not start: {error}"), remedy))?;
    let out = String::from_utf8_lossy(&output.stdout).into_owned();
    Ok(match output.status.success() {
        true => Ok(out),
        false => Err(format!("{out}{}", String::from_utf8_lossy(&output.stderr))),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_bundle_of_another_script_is_a_problem() {
        assert_eq!(stale(BUNDLE, BUNDLE), None);
        let newer = format!("{BUNDLE};");
        let problem = stale(BUNDLE, &newer).expect("it is told");
        assert_eq!(problem.problem, "the bundle is not of this script");
    }
}
