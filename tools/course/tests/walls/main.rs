//! The walls of every kind of sandbox, as code inside sees them. `probe.rs` is a program that
//! reports what it can see and do. It is compiled in the sandbox, and then run twice: in place of
//! the compiler, and as an answer.
//!
//! This test has its own `main` because both sandboxes start this program again inside.

#[cfg(all(target_os = "linux", target_arch = "x86_64"))]
mod modes;
#[cfg(all(target_os = "linux", target_arch = "x86_64"))]
mod report;
#[cfg(all(target_os = "linux", target_arch = "x86_64"))]
mod walls;

// The probe makes system calls by their numbers on x86-64.
#[cfg(not(all(target_os = "linux", target_arch = "x86_64")))]
fn main() {}

#[cfg(all(target_os = "linux", target_arch = "x86_64"))]
fn main() -> std::process::ExitCode {
    use libtest_mimic::{Arguments, Trial};
    if let Some(code) = pinhole_course::sandbox::become_confined() {
        return code;
    }
    let words: Vec<String> = std::env::args().collect();
    if let [_, first, mode] = &words[..]
        && first == modes::INSIDE
    {
        walls::judge(mode);
        return std::process::ExitCode::SUCCESS;
    }
    let modes = [
        modes::BUBBLEWRAP,
        modes::USER,
        modes::CONTAINER,
        modes::WITHOUT_LANDLOCK,
        modes::UNREACHABLE,
    ];
    let is_root = rustix::process::getuid().is_root();
    let trials = modes.map(|mode| {
        let trial = Trial::test(mode, move || modes::surround(mode));
        trial.with_ignored_flag(!is_root && mode != modes::BUBBLEWRAP)
    });
    libtest_mimic::run(&Arguments::from_args(), trials.into()).exit_code()
}
