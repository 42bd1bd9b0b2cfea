//! How many instructions a kernel takes, by callgrind: unlike times, they repeat.
//!
//! This program is run under valgrind twice for a kernel, with a different number of
//! casts; the difference is what the casts took, without everything around them.

use std::env;
use std::process::Command;

use crate::contestants::Contested;
use crate::family::Studied;
use crate::shape::{Plane, Sphere, Triangle};
use crate::speed::{PAIRS, workload};

/// Instructions for each ray and shape; `None` if there is no valgrind.
pub fn count<S: Contested>(kernel: usize) -> Option<f64> {
    let with = |casts: u32| {
        let mut valgrind = Command::new("valgrind");
        valgrind.args(["--tool=callgrind", "--callgrind-out-file=/dev/null"]);
        valgrind.arg(env::current_exe().ok()?);
        valgrind.args(["cast", S::NAME, &kernel.to_string(), &casts.to_string()]);
        let output = valgrind
            .output()
            .ok()
            .filter(|output| output.status.success())?;
        let said = String::from_utf8_lossy(&output.stderr).into_owned();
        let line = said.lines().find(|line| line.contains("Collected :"))?;
        line.rsplit(' ').next()?.parse::<f64>().ok()
    };
    Some((with(3)? - with(1)?) / (2.0 * PAIRS as f64))
}

/// What runs under valgrind: so many casts of one kernel's workload.
pub fn cast(shape: &str, kernel: usize, casts: u32, seed: u64) {
    fn of<S: Studied>(kernel: usize, casts: u32, seed: u64) {
        if let Some(kernel) = S::contestants().get(kernel) {
            let mut cast = workload(kernel, seed);
            (0..casts).for_each(|_| cast());
        }
    }
    match shape {
        Plane::NAME => of::<Plane<f64>>(kernel, casts, seed),
        Triangle::NAME => of::<Triangle<f64>>(kernel, casts, seed),
        _ => of::<Sphere<f64>>(kernel, casts, seed),
    }
}
