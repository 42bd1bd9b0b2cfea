//! `pinhole study`: runs the study, judges it, and writes the report.

use std::fs;

use pinhole_course::error::{Error, Result};
use pinhole_course::progress::Progress;
use pinhole_report::program::Status;
use pinhole_study::extent::Extent;
use pinhole_study::provenance::provenance;
use pinhole_study::result::{SCHEMA, Study};
use pinhole_study::run::run as ask;
use pinhole_study::targets::targets;
use pinhole_study::{plots, summary};

use crate::cli::Study as Arguments;

/// Succeeds if all promises are kept, not counting times.
pub fn run(arguments: &Arguments) -> Result<Status> {
    let whole = match arguments.quick {
        true => Extent::QUICK,
        false => Extent::FULL,
    };
    let extent = Extent {
        only: arguments.only,
        seed: arguments.seed,
        ..whole
    };
    let progress = Progress::new();
    // Record this before the run, because the work tree may change during it.
    let provenance = provenance(&extent);
    let findings = ask(&extent, &|what| progress.say(what));
    progress.clear();
    let study = Study {
        schema: SCHEMA.into(),
        provenance,
        targets: targets(&findings),
        findings,
    };
    write(&study, arguments)?;
    let mut targets = study.targets.iter();
    Ok(match targets.all(|target| target.met || target.is_time) {
        true => Status::Well,
        false => Status::JudgedWrong,
    })
}

fn write(study: &Study, arguments: &Arguments) -> Result<()> {
    let folder = &arguments.out;
    let document = serde_json::to_string(study).expect("all map keys are strings");
    let files = || {
        fs::create_dir_all(folder)?;
        fs::write(folder.join("study.json"), document.clone() + "\n")?;
        let names = plots::draw(study, folder)?;
        fs::write(folder.join("summary.md"), summary::summary(study, &names))
    };
    files().map_err(|error: std::io::Error| {
        let problem = format!("cannot write {}: {error}", folder.display());
        Error::input(problem, "name another folder with --out")
    })?;
    match arguments.json {
        true => anstream::println!("{document}"),
        false => anstream::println!(
            "{}written to {}",
            summary::terminal(study),
            folder.display()
        ),
    }
    Ok(())
}
