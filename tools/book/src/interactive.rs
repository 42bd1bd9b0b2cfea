//! Interactive figures, and their static pictures.
//!
//! The static picture is an ordinary figure in the page, and a script makes it interactive. The
//! script is TypeScript in `book/interactive`. Its bundle is stored in this package, so that
//! building the book needs no Node.js. The script computes nothing that an assignment asks for,
//! but looks everything up in `facts.json`, which `facts` writes.

mod facts;
mod slice;

use std::path::PathBuf;
use std::process::Command;

use pinhole_course::checkout::Checkout;

use crate::error::{Error, Problem, ProblemAndRemedy, Result};
use crate::figures;

/// The bundle that pages load.
pub const BUNDLE: &str = include_str!("../assets/interactive.js");

/// The bundle's file.
const KEPT: &str = "tools/book/assets/interactive.js";

/// The facts about the course that the script uses.
const FACTS: &str = "book/interactive/src/facts.json";

const AGAIN: &str = "make it again: cargo pinhole book bundle";

/// HTML of a figure: its static picture, which the script replaces where it can.
pub fn shown(
    name: &str,
    alternative: &str,
    to_root: &str,
    checkout: &Checkout,
) -> std::result::Result<String, ProblemAndRemedy> {
    let still = figures::shown(name, alternative, to_root, checkout)?;
    Ok(format!(
        "<figure class=\"interactive\" data-figure=\"{name}\">\n<div class=\"stage\">\n{still}\n</div>\n</figure>\n"
    ))
}

/// Writes the facts, and bundles the script.
pub fn bundle(checkout: &Checkout) -> Result<()> {
    checkout.write(FACTS, facts::text(checkout)?)?;
    let bundle = npm(&["run", "--silent", "bundle"], checkout)?;
    let bundle = bundle.map_err(|said| Problem::of("book/interactive", said, "fix the script"))?;
    Ok(checkout.write(KEPT, bundle)?)
}

/// What is wrong with the figures: stale facts or a stale bundle, types, mathematics.
pub fn check(checkout: &Checkout) -> Result<Vec<Problem>> {
    let mut problems = Vec::new();
    let kept = checkout.read(FACTS).unwrap_or_default();
    if let Some(problem) = stale(FACTS, &kept, &facts::text(checkout)?) {
        return Ok(vec![problem]);
    }
    for script in ["types", "test"] {
        if let Err(said) = npm(&["run", "--silent", script], checkout)? {
            problems.push(Problem::of("book/interactive", said, "fix the script"));
        }
    }
    match npm(&["run", "--silent", "bundle"], checkout)? {
        Ok(bundle) => problems.extend(stale(KEPT, BUNDLE, &bundle)),
        Err(said) => problems.push(Problem::of("book/interactive", said, "fix the script")),
    }
    Ok(problems)
}

/// A problem if the stored file differs from the new one.
fn stale(file: &str, kept: &str, made: &str) -> Option<Problem> {
    (kept != made).then(|| Problem::of(file, "it is out of date", AGAIN))
}

/// Runs npm in the script's folder, after installing what the lock file names. Returns its
/// output, as an error if it failed.
pub fn npm(arguments: &[&str], checkout: &Checkout) -> Result<std::result::Result<String, String>> {
    let folder = folder(checkout);
    if !folder.join("node_modules/.package-lock.json").is_file() {
        started(&folder, &["ci", "--silent", "--no-audit", "--no-fund"])?.map_err(|said| {
            Error::environment(
                format!("npm ci: {said}"),
                "make sure that npm can reach its registry",
            )
        })?;
    }
    started(&folder, arguments)
}

/// The folder of the script.
pub fn folder(checkout: &Checkout) -> PathBuf {
    checkout.book().join("interactive")
}

fn started(
    folder: &std::path::Path,
    arguments: &[&str],
) -> Result<std::result::Result<String, String>> {
    let remedy = "install Node.js 20 or newer with npm";
    let output = Command::new("npm")
        .args(arguments)
        .current_dir(folder)
        .output()
        .map_err(|error| Error::environment(format!("cannot start npm: {error}"), remedy))?;
    let out = String::from_utf8_lossy(&output.stdout).into_owned();
    Ok(match output.status.success() {
        true => Ok(out),
        false => Err(format!("{out}{}", String::from_utf8_lossy(&output.stderr))),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A page's script must not contain what students are asked to find.
    #[test]
    fn the_script_holds_no_formula_of_an_answer() {
        let formulas = [
            "sqrt",
            "hypot",
            "**.5",
            "cross",
            "determinant",
            "dot(",
            "normal",
        ];
        let in_script = |script: &str| -> Vec<&str> {
            let held = formulas.into_iter().filter(|it| script.contains(it));
            held.collect()
        };
        assert_eq!(in_script(BUNDLE), Vec::<&str>::new());
        assert_eq!(in_script("let t=(-h-Math.sqrt(D))/a"), ["sqrt"]);
    }

    #[test]
    fn a_file_that_would_be_made_differently_now_is_a_problem() {
        assert_eq!(stale(KEPT, BUNDLE, BUNDLE), None);
        let newer = format!("{BUNDLE};");
        let problem = stale(KEPT, BUNDLE, &newer).expect("it is told");
        assert_eq!(problem.file, PathBuf::from(KEPT));
    }
}
