//! `pinhole study`: run, judged, written.

use std::fs;

use indicatif::ProgressBar;
use pinhole_course::checkout::Checkout;
use pinhole_course::error::{Error, Result};
use pinhole_report::program::Status;
use pinhole_study::family::Studied;
use pinhole_study::provenance::provenance;
use pinhole_study::result::{SCHEMA, Study};
use pinhole_study::run::{Extent, run as ask};
use pinhole_study::shape::{Plane, Sphere, Triangle};
use pinhole_study::targets::targets;
use pinhole_study::theirs::Theirs;
use pinhole_study::{plots, summary};

use crate::cli::Study as Arguments;
use crate::submission;

/// Well if all came as it was promised, times apart.
pub fn run(checkout: &Checkout, arguments: &Arguments) -> Result<Status> {
    let extent = if arguments.quick || arguments.submission.is_some() {
        Extent::QUICK
    } else {
        Extent::FULL
    };
    let bar = ProgressBar::new_spinner();
    bar.enable_steady_tick(std::time::Duration::from_millis(100));
    let say = |what: &str| match bar.is_hidden() {
        true => anstream::eprintln!("{what}"),
        false => bar.set_message(what.to_owned()),
    };
    let theirs = match &arguments.submission {
        Some(folder) => submission::answers(checkout, arguments, folder)?,
        None => Theirs::default(),
    };
    let only = arguments.only.as_deref();
    // Before a long run, during which the work tree may change.
    let provenance = provenance(extent.name, arguments.seed);
    let findings = ask(&extent, arguments.seed, only, &theirs, &say);
    bar.finish_and_clear();
    let targets = targets(&findings);
    let study = Study {
        schema: SCHEMA.into(),
        provenance,
        families: findings.families,
        meshes: findings.meshes,
        trades: findings.trades,
        tiers: findings.tiers,
        conditioning: findings.conditioning,
        secondary: findings.secondary,
        breaking: findings.breaking,
        scenes: findings.scenes,
        problems: theirs.problems(),
        plans: findings.plans,
        targets,
    };
    if study.families.is_empty()
        && study.meshes.is_empty()
        && study.secondary.is_empty()
        && study.scenes.is_empty()
        && study.plans.is_empty()
    {
        let only = arguments.only.as_deref().unwrap_or_default();
        return Err(Error::input(
            format!("there is no family {only:?}"),
            format!("name one of {}", names().join(", ")),
        ));
    }
    write(&study, arguments)?;
    let targets = &study.targets;
    Ok(
        match targets.iter().all(|target| target.met || target.is_time) {
            true => Status::Well,
            false => Status::JudgedWrong,
        },
    )
}

/// What `--only` understands.
fn names() -> Vec<&'static str> {
    let mut names = vec!["classes", "mesh", "plans", "scenes", "secondary"];
    names.extend(Sphere::families().iter().map(|family| family.name));
    names.extend(Plane::families().iter().map(|family| family.name));
    names.extend(Triangle::families().iter().map(|family| family.name));
    names.sort_unstable();
    names.dedup();
    names
}

fn write(study: &Study, arguments: &Arguments) -> Result<()> {
    let folder = &arguments.out;
    let failed = |error: &dyn std::fmt::Display| {
        let problem = format!("cannot write {}: {error}", folder.display());
        Error::input(problem, "name another folder with --out")
    };
    fs::create_dir_all(folder).map_err(|error| failed(&error))?;
    let document = serde_json::to_string(study).map_err(|error| failed(&error))?;
    fs::write(folder.join("study.json"), document.clone() + "\n")
        .map_err(|error| failed(&error))?;
    let names = plots::draw(study, folder).map_err(|error| failed(&error))?;
    let text = summary::summary(study, &names);
    fs::write(folder.join("summary.md"), &text).map_err(|error| failed(&error))?;
    match arguments.json {
        true => anstream::println!("{document}"),
        false => {
            let text = match summary::theirs::is_there(study) {
                true => summary::theirs::terminal(study),
                false => summary::terminal(study),
            };
            anstream::println!("{text}\nwritten to {}", folder.display());
        }
    }
    Ok(())
}
