//! Counts the instructions of a kernel or a scene with callgrind. Unlike times, these counts
//! repeat exactly.

use std::env;
use std::process::Command;

/// What the program prints when it has finished all its casts.
pub const DONE: &str = "cast\n";

/// Instructions per ray of one way to cast something; `None` without valgrind.
///
/// Runs this program under valgrind twice, with different numbers of casts, and divides the
/// difference. This excludes start-up and set-up.
pub fn of_cast(what: &str, way: usize, rays: usize) -> Option<f64> {
    let with = |casts: u32| {
        let mut valgrind = Command::new("valgrind");
        valgrind.args(["--tool=callgrind", "--callgrind-out-file=/dev/null"]);
        valgrind.arg(env::current_exe().ok()?);
        valgrind.args(["cast", what, &way.to_string(), &casts.to_string()]);
        let output = valgrind.output().ok()?;
        // Valgrind reports a count even for a program that crashes half-way.
        output.stdout.ends_with(DONE.as_bytes()).then_some(())?;
        let said = String::from_utf8_lossy(&output.stderr).into_owned();
        let line = said.lines().find(|line| line.contains("Collected :"))?;
        line.rsplit(' ').next()?.parse::<f64>().ok()
    };
    Some((with(3)? - with(1)?) / (2.0 * rays as f64))
}
