//! Writes the report, and opens it if there is a desktop.

use std::path::Path;

use super::Course;
use pinhole_course::error::Result;
use pinhole_course::outcome::Examination;
use pinhole_course::shell::in_shell;
use pinhole_report::desktop;
use pinhole_report::escape::printable;
use pinhole_report::finish::Finish;
use pinhole_report::html::{FinishSection, Report};
use pinhole_report::passage;

/// Writes and opens the report of the verdicts so far. Returns a message for the screen.
pub fn show(course: &Course, known: &Examination) -> String {
    match write(course, known) {
        Ok(()) => open(&course.report),
        Err(error) => printable(&error.problem),
    }
}

fn write(course: &Course, known: &Examination) -> Result<()> {
    let mut report = Report::of_examination(known, &course.goldens.folder, &course.again)?;
    report.book = passage::built(course.checkout.root());
    report.finish =
        Finish::of(known, &course.assignment, &course.again.part).map(FinishSection::of);
    report.write(&course.report)
}

/// Opens a file in the desktop's program for it, or says how to reach it.
fn open(path: &Path) -> String {
    let shown = printable(&path.display().to_string());
    if let Some(copy) = copy_command(path) {
        return format!("the report is {shown}; to copy it, run this on your own machine:\n{copy}");
    }
    match desktop::open(path) {
        true => format!("opened {shown}"),
        false => format!("the report is {shown}; open it in a browser"),
    }
}

/// The command that copies a file to the machine from which the user has logged in by ssh.
fn copy_command(path: &Path) -> Option<String> {
    let connection = std::env::var("SSH_CONNECTION").ok()?;
    // Client's address and port, server's address and port.
    let mut parts = connection.split(' ').skip(2);
    let (server, port) = (parts.next()?, parts.next()?);
    let port = match port {
        "22" => String::new(),
        other => format!("-P {other} "),
    };
    let user = std::env::var("USER")
        .map(|user| user + "@")
        .unwrap_or_default();
    let server = match server.contains(':') {
        true => format!("[{server}]"),
        false => server.into(),
    };
    let path = path.canonicalize().ok()?;
    // `scp` starts in the home folder on the other machine.
    let home = std::env::home_dir().unwrap_or_default();
    let path = path.strip_prefix(home).unwrap_or(&path);
    let path = in_shell(&path.display().to_string());
    Some(printable(&format!("scp {port}{user}{server}:{path} .")))
}
