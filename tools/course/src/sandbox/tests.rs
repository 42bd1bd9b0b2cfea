use glam::DVec3;
use pinhole::Ray;
use pinhole::ask::Death;

use super::*;

/// How often a program was started that ran these shell commands, and how it ended.
fn starts(lines: &str) -> (usize, Ending) {
    let folder = tempfile::tempdir().expect("there is room");
    let count = folder.path().join("count");
    let lines = format!("echo >> {0}; {lines}", count.display());
    let ending = ending(&lines, Duration::from_secs(30));
    let count = std::fs::read_to_string(&count).expect("it was started");
    (count.len(), ending)
}

#[test]
fn program_that_never_read_its_job_is_started_again() {
    let died = |code| Ending::Died(Death::Exit(code));
    assert_eq!(starts("exit 1"), (MOST_STARTS as usize, died(1)));
    // It reads a byte, so that the job is sent. The bytes that it writes are Message::Started.
    let read = "dd bs=1 count=1 of=/dev/null; printf '\\001\\0\\0\\0\\005' >&0; exit 3";
    assert_eq!(starts(read), (1, died(3)));
}

/// How a program ends if it runs these shell commands instead of answering, with this limit on its
/// processor time.
fn ending(lines: &str, cpu: Duration) -> Ending {
    let folder = tempfile::tempdir().expect("there is room");
    let program = folder.path().join("program");
    // Another process writes it, because a program that is open for writing can't be started.
    let written = Command::new("sh")
        .args([
            "-c",
            "printf '#!/bin/sh\\n%s' \"$1\" > \"$0\" && chmod +x \"$0\"",
        ])
        .arg(&program)
        .arg(lines)
        .status();
    assert!(written.expect("there is a shell").success());
    let limits = Limits {
        cpu,
        ..Limits::of_answers(Duration::from_secs(60))
    };
    let ray = Ray {
        origin: DVec3::ZERO,
        direction: DVec3::Z,
    };
    let job = Job::Cast(ray, 0.0, Vec::new());
    let reply = Sandbox::Trusted.ask(&program, &job, &limits, Stop::default(), &mut |_| {});
    reply.expect("it can be started").ending
}

#[test]
fn only_a_program_that_took_its_processor_time_is_late_by_the_kernels_limit() {
    let long = Duration::from_secs(30);
    for (signal, name) in [(SIGXCPU, "XCPU"), (SIGKILL, "KILL")] {
        let kills_itself = ending(&format!("kill -{name} $$"), long);
        assert_eq!(kills_itself, Ending::Died(Death::Signal(signal)));
    }
    let short = Duration::from_millis(500);
    // Without a sandbox nothing watches the program, and the kernel ends it after a second.
    for limit in ["ulimit -S -t 1", "ulimit -t 1"] {
        let loops = ending(&format!("{limit}; while :; do :; done"), short);
        assert_eq!(loops, Ending::TimedOut(short), "{limit}");
    }
    let ends_itself = ending(
        "ulimit -S -t 1; trap 'exit 3' XCPU; while :; do :; done",
        short,
    );
    assert_eq!(ends_itself, Ending::Died(Death::Exit(3)));
}

#[test]
fn a_compiler_that_something_else_killed_blames_nobody() {
    let compile = |lines: &str| {
        let mut command = Command::new("sh");
        command.args(["-c", lines]);
        let compiled = Sandbox::Trusted.compile(command, &Limits::of_compiler());
        compiled.expect("there is a shell")
    };
    let killed = compile("kill -KILL $$");
    assert!(killed.is_late());
    let why = killed.disturbed_by().expect("nothing of the student's");
    assert!(why.contains("killed the compiler"), "{why}");
    for of_its_own in ["exit 1", "kill -SEGV $$", "kill -XCPU $$"] {
        assert_eq!(compile(of_its_own).disturbed_by(), None, "{of_its_own}");
    }
}
