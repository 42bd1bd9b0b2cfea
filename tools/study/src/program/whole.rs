//! The whole study: run, judged, written.

use std::fs;

use indicatif::ProgressBar;
use pinhole_study::family::Studied;
use pinhole_study::provenance::provenance;
use pinhole_study::result::{SCHEMA, Study};
use pinhole_study::run::{Extent, run};
use pinhole_study::shape::{Plane, Sphere, Triangle};
use pinhole_study::targets::targets;
use pinhole_study::theirs::Theirs;
use pinhole_study::{plots, summary};

use super::Arguments;

/// Whether all came as it was promised, times apart.
pub fn studied(arguments: &Arguments) -> Result<bool, String> {
    let extent = if arguments.quick {
        Extent::QUICK
    } else {
        Extent::FULL
    };
    let bar = ProgressBar::new_spinner();
    bar.enable_steady_tick(std::time::Duration::from_millis(100));
    let say = |what: &str| match bar.is_hidden() {
        true => eprintln!("{what}"),
        false => bar.set_message(what.to_owned()),
    };
    let theirs = theirs(arguments)?;
    let only = arguments.only.as_deref();
    let findings = run(&extent, arguments.seed, only, &theirs, &say);
    bar.finish_and_clear();
    let targets = targets(&findings);
    let study = Study {
        schema: SCHEMA.into(),
        provenance: provenance(extent.name, arguments.seed),
        families: findings.families,
        meshes: findings.meshes,
        spoilt: findings.spoilt,
        speed: findings.speed,
        breaking: findings.breaking,
        scenes: findings.scenes,
        problems: theirs.problems(),
        plans: findings.plans,
        crossovers: findings.crossovers,
        targets,
    };
    if study.families.is_empty()
        && study.meshes.is_empty()
        && study.spoilt.is_empty()
        && study.speed.is_empty()
        && study.scenes.is_empty()
        && study.plans.is_empty()
        && study.crossovers.is_empty()
    {
        let only = arguments.only.as_deref().unwrap_or_default();
        return Err(format!(
            "there is no family {only:?}\n  remedy: name one of {}",
            names().join(", ")
        ));
    }
    write(&study, arguments)?;
    Ok(study
        .targets
        .iter()
        .all(|target| target.met || target.is_time))
}

/// Reads what it said; nothing, if nobody was asked.
fn theirs(arguments: &Arguments) -> Result<Theirs, String> {
    let Some(file) = &arguments.answers else {
        return Ok(Theirs::default());
    };
    let cannot = |error: &dyn std::fmt::Display| format!("cannot read {}: {error}", file.display());
    let bytes = fs::read(file).map_err(|error| cannot(&error))?;
    let said = postcard::from_bytes(&bytes).map_err(|error| cannot(&error))?;
    Ok(Theirs::new(said))
}

/// What `--only` understands.
fn names() -> Vec<&'static str> {
    let mut names = vec!["crossover", "mesh", "plans", "scenes", "spoilt", "speed"];
    names.extend(Sphere::families().iter().map(|family| family.name));
    names.extend(Plane::families().iter().map(|family| family.name));
    names.extend(Triangle::families().iter().map(|family| family.name));
    names.sort_unstable();
    names.dedup();
    names
}

fn write(study: &Study, arguments: &Arguments) -> Result<(), String> {
    let folder = &arguments.out;
    let failed = |error: &dyn std::fmt::Display| {
        format!(
            "cannot write {}: {error}\n  remedy: name another folder with --out",
            folder.display()
        )
    };
    fs::create_dir_all(folder).map_err(|error| failed(&error))?;
    let document = serde_json::to_string(study).map_err(|error| failed(&error))?;
    fs::write(folder.join("study.json"), document.clone() + "\n")
        .map_err(|error| failed(&error))?;
    let names = plots::draw(study, folder).map_err(|error| failed(&error))?;
    let text = summary::summary(study, &names);
    fs::write(folder.join("summary.md"), &text).map_err(|error| failed(&error))?;
    match arguments.json {
        true => println!("{document}"),
        false => {
            let text = match summary::theirs::is_there(study) {
                true => summary::theirs::terminal(study),
                false => summary::terminal(study),
            };
            println!("{text}\nwritten to {}", folder.display());
        }
    }
    Ok(())
}
