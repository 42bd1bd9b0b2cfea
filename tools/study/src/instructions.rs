//! How many instructions a kernel or a scene takes, by callgrind: unlike times, they repeat.

use std::env;
use std::process::Command;

/// What the program says when it has cast all it was asked to.
pub const DONE: &str = "cast\n";

/// Instructions of one way to cast something, for each of so many rays; `None` if there is no
/// valgrind.
///
/// This program is run under valgrind twice, with a different number of casts; the difference
/// is what the casts took, without everything around them.
pub fn of_cast(what: &str, way: usize, rays: usize) -> Option<f64> {
    let with = |casts: u32| {
        let mut valgrind = Command::new("valgrind");
        valgrind.args(["--tool=callgrind", "--callgrind-out-file=/dev/null"]);
        valgrind.arg(env::current_exe().ok()?);
        valgrind.args(["cast", what, &way.to_string(), &casts.to_string()]);
        let output = valgrind.output().ok()?;
        // Instructions are counted even of a program that crashes half-way.
        output.stdout.ends_with(DONE.as_bytes()).then_some(())?;
        let said = String::from_utf8_lossy(&output.stderr).into_owned();
        let line = said.lines().find(|line| line.contains("Collected :"))?;
        line.rsplit(' ').next()?.parse::<f64>().ok()
    };
    Some((with(3)? - with(1)?) / (2.0 * rays as f64))
}
