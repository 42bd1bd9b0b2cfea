//! `pinhole handout`: stubs from the reference, and what students get around them.

use serde_json::json;

use crate::cli::Handout;
use crate::handout::{Repository, Written, write_gradescope};
use pinhole_course::assignment::Assignment;
use pinhole_course::checkout::Checkout;
use pinhole_course::error::Result;
use pinhole_course::progress::Progress;
use pinhole_course::stubs;
use pinhole_report::escape::printable_word;
use pinhole_report::program::Status;

pub fn run(checkout: &Checkout, arguments: &Handout) -> Result<Status> {
    let assignment = arguments
        .assignment
        .or(arguments.positional.as_deref(), checkout)?;
    match (&arguments.out, &arguments.gradescope) {
        (None, None) => stubs_in_place(&assignment, arguments),
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
        let repository = Repository::of(assignment, checkout, arguments.book.as_deref())?;
        let written = repository.write(out, arguments.force)?;
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
        words.push_str(&format!(
            "\nsee it as students will:\n\n    cd {}\n    cargo pinhole check\n    \
             cargo test\n\nthen give it to them: git init, git add . and git commit there, or an \
             archive of the folder\n",
            printable_word(&path)
        ));
    }
    if let Some(file) = &arguments.gradescope {
        let fresh = arguments.fresh.as_deref();
        let written = write_gradescope(assignment, checkout, fresh, arguments.reveal, file)?;
        let path = file.display().to_string();
        document["gradescope"] = sizes(&path, &written);
        words.push_str(&format!(
            "wrote {path}: {}\n\nit holds every golden and our answers: upload it to Gradescope \
             (Configure Autograder), and give it to nobody\n",
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

fn sizes(path: &str, written: &Written) -> serde_json::Value {
    json!({ "path": path, "files": written.files, "bytes": written.bytes })
}

fn in_words(written: &Written) -> String {
    let megabytes = written.bytes as f64 / 1e6;
    format!("{} files, {megabytes:.1} MB", written.files)
}

/// The handout inside the checkout, generated anew or compared.
fn stubs_in_place(assignment: &Assignment, arguments: &Handout) -> Result<Status> {
    let package = stubs::generate(assignment)?;
    let stale = stubs::out_of_step(&package, &assignment.handout());
    if !arguments.check {
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
        anstream::println!("{stale} of {all} files were out of step");
    } else if stale.is_empty() {
        anstream::println!("the handout is in step with the reference");
    } else {
        for path in &stale {
            anstream::println!("out of step with the reference: {}", path.display());
        }
        anstream::println!("mend it: cargo pinhole handout {}", assignment.name);
    }
    Ok(match in_step {
        true => Status::Well,
        false => Status::JudgedWrong,
    })
}
