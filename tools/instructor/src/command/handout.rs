//! `pinhole handout`: makes stubs from the reference, and a repository or an autograder
//! around them.

use std::path::PathBuf;

use serde_json::json;

use crate::cli::Handout;
use crate::handout::{HandoutSize, Repository, vendor, write_gradescope, write_prairielearn};
use pinhole_course::assignment::Assignment;
use pinhole_course::checkout::Checkout;
use pinhole_course::error::{Error, Result};
use pinhole_course::progress::Progress;
use pinhole_course::stubs;
use pinhole_report::escape::printable_word;
use pinhole_report::program::Status;

pub fn run(checkout: &Checkout, arguments: &Handout) -> Result<Status> {
    let assignment = arguments
        .assignment
        .or(arguments.positional.as_deref(), checkout)?;
    match (
        &arguments.out,
        &arguments.gradescope,
        &arguments.prairielearn,
    ) {
        (None, None, None) => stubs_in_place(&assignment, arguments),
        _ => hand_out(&assignment, checkout, arguments),
    }
}

/// A student's repository, an autograder, or both.
fn hand_out(assignment: &Assignment, checkout: &Checkout, arguments: &Handout) -> Result<Status> {
    let progress = Progress::new();
    progress.say("gathering");
    let mut document = json!({ "assignment": assignment.name });
    let mut words = String::new();
    if let Some(out) = &arguments.out {
        let mut repository = Repository::of(assignment, checkout, arguments.book.as_deref())?;
        repository.vendored = arguments.vendor;
        let written = repository.write(out, checkout, arguments.force)?;
        if arguments.vendor {
            progress.say("vendoring");
            vendor(out, checkout)?;
        }
        let withheld: Vec<&str> = assignment
            .withheld_scenes()
            .map(|scene| scene.name.as_str())
            .collect();
        let path = out.display().to_string();
        document["repository"] = sizes(&path, &written);
        document["withheld"] = json!(withheld);
        words.push_str(&format!("wrote {path}: {}\n", in_words(&written)));
        if !withheld.is_empty() {
            words.push_str(&format!("withheld scenes: {}\n", withheld.join(", ")));
        }
        if arguments.book.is_none() {
            words.push_str(
                "without the book; to include it: cargo pinhole book build, then run this command \
                 again with --book book/build/student\n",
            );
        }
        words.push_str(&format!(
            "\ntry it as students will:\n\n    cd {}\n    cargo pinhole check\n    \
             cargo test\n\nthen hand it out: as a git repository (git init, git add . and git \
             commit in this folder), or as an archive of the folder\n",
            printable_word(&path)
        ));
    }
    if let Some(file) = &arguments.gradescope {
        let fresh = arguments.fresh.as_deref();
        let written = write_gradescope(assignment, checkout, fresh, arguments.reveal, file)?;
        let path = file.display().to_string();
        document["gradescope"] = sizes(&path, &written);
        words.push_str(&format!(
            "wrote {path}: {}\n\nupload it to Gradescope (Configure Autograder), but don't share \
             it, because it contains every golden and our answers\n",
            in_words(&written)
        ));
    }
    if let Some(folder) = &arguments.prairielearn {
        let fresh = arguments.fresh.as_deref();
        let written = write_prairielearn(assignment, checkout, fresh, arguments.reveal, folder)?;
        let path = folder.display().to_string();
        document["prairielearn"] = sizes(&path, &written);
        words.push_str(&format!(
            "wrote {path}: {}\n\nits README says how to build the container; don't share the \
             container, because it contains every golden and our answers\n",
            in_words(&written)
        ));
    }
    progress.clear();
    match arguments.json {
        true => anstream::println!("{document:#}"),
        false => anstream::print!("{words}"),
    }
    Ok(Status::Well)
}

fn sizes(path: &str, written: &HandoutSize) -> serde_json::Value {
    json!({ "path": path, "files": written.files, "bytes": written.bytes })
}

fn in_words(written: &HandoutSize) -> String {
    let megabytes = written.bytes as f64 / 1e6;
    format!("{} files, {megabytes:.1} MB", written.files)
}

/// A file that differs from what we would write may contain someone's answer.
fn refuse_unforced(stale: &[PathBuf], assignment: &Assignment, arguments: &Handout) -> Result<()> {
    let there = stale
        .iter()
        .filter(|path| assignment.handout().join(path).exists());
    let there: Vec<String> = there.map(|path| path.display().to_string()).collect();
    if there.is_empty() || arguments.force {
        return Ok(());
    }
    Err(Error::input(
        format!(
            "{} would be overwritten in {}",
            there.join(", "),
            assignment.handout().display()
        ),
        "these files may contain someone's answers; if nobody needs them, pass --force",
    ))
}

/// Generates the handout in the checkout, or compares it with the reference.
fn stubs_in_place(assignment: &Assignment, arguments: &Handout) -> Result<Status> {
    let package = stubs::generate(assignment)?;
    let stale = stubs::out_of_step(&package, &assignment.handout());
    if !arguments.check {
        refuse_unforced(&stale, assignment, arguments)?;
        stubs::write(&package, &assignment.handout())?;
    }
    let in_step = stale.is_empty() || !arguments.check;
    if arguments.json {
        let names: Vec<String> = stale
            .iter()
            .map(|path| path.display().to_string())
            .collect();
        anstream::println!(
            "{:#}",
            json!({ "assignment": assignment.name, "out_of_step": names, "in_step": in_step })
        );
    } else if !arguments.check {
        let (stale, all) = (stale.len(), package.len());
        anstream::println!(
            "all {all} files match the reference now; {stale} of them had to be written"
        );
    } else if stale.is_empty() {
        anstream::println!("the handout matches the reference");
    } else {
        for path in &stale {
            anstream::println!("this file does not match the reference: {}", path.display());
        }
        anstream::println!(
            "if these files contain none of your work, write them again: cargo pinhole handout {} \
             --force",
            assignment.name
        );
    }
    Ok(match in_step {
        true => Status::Well,
        false => Status::JudgedWrong,
    })
}
