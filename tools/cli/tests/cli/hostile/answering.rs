//! Attacks by code that runs.

use std::net::TcpListener;

use super::Fate::{Harmless, Hungry, Outcome};
use super::{
    Attack, SECRET, attack, every_attack_fails_in_every_mode,
    every_attack_has_its_expected_outcome, reach, scratch,
};
use crate::modes;
use pinhole_testing::root;

/// Everything an answer must not reach. `%NAME%` stands for a value that differs from
/// run to run.
const REACHES: [(&str, &str); 35] = [
    ("golden", "std::fs::metadata(\"%GOLDEN%\").is_ok()"),
    ("read-golden", "std::fs::read(\"%GOLDEN%\").is_ok()"),
    (
        "golden-by-way-of-proc",
        "std::fs::metadata(\"/proc/self/root%GOLDEN%\").is_ok()",
    ),
    (
        "golden-of-the-grader",
        "std::fs::read(format!(\"/proc/{}/root%GOLDEN%\", std::os::unix::process::parent_id())).is_ok()",
    ),
    ("other-submission", "std::fs::read(\"%NEIGHBOUR%\").is_ok()"),
    ("reference", "std::fs::metadata(\"%REFERENCE%\").is_ok()"),
    ("etc", "std::fs::read(\"/etc/passwd\").is_ok()"),
    // The kernel's cache and, where they can change, access times could carry a message to programs
    // that run later.
    (
        "system-file",
        "std::fs::File::open(\"/usr/bin/env\").is_ok()",
    ),
    (
        "name-of-a-system-file",
        "std::fs::metadata(\"/usr/bin/env\").is_ok()",
    ),
    ("home", "std::fs::read_dir(\"%HOME%\").is_ok()"),
    (
        "top",
        "std::fs::read_dir(\"/\").is_ok_and(|top| top.flatten().any(|it| it.file_name() == \"var\"))",
    ),
    ("environment", "std::env::var(\"%SECRET%\").is_ok()"),
    (
        "environment-file",
        "std::fs::read_to_string(\"/proc/self/environ\").is_ok_and(|text| text.contains(\"%SECRET%\"))",
    ),
    (
        "environment-of-the-grader",
        "std::fs::read_to_string(format!(\"/proc/{}/environ\", std::os::unix::process::parent_id())).is_ok_and(|text| text.contains(\"%SECRET%\"))",
    ),
    (
        "other-processes",
        "std::fs::read_dir(\"/proc\").is_ok_and(|all| all.flatten().filter(|it| it.file_name().to_string_lossy().parse::<u32>().is_ok()).count() > 4)",
    ),
    (
        "own-memory",
        "std::fs::OpenOptions::new().read(true).write(true).open(\"/proc/self/mem\").is_ok()",
    ),
    (
        "memory-of-a-thread",
        "std::fs::File::open(\"/proc/thread-self/mem\").is_ok()",
    ),
    (
        "target-of-a-link",
        "std::fs::read_link(\"/proc/self/exe\").is_ok()",
    ),
    ("own-layout", "std::fs::read(\"/proc/self/maps\").is_ok()"),
    (
        "own-program",
        "std::fs::File::open(\"/proc/self/exe\").is_ok()",
    ),
    (
        "command-lines",
        "[\"1\", \"self\"].iter().any(|it| std::fs::read(format!(\"/proc/{it}/cmdline\")).is_ok())",
    ),
    (
        "network",
        "std::net::TcpStream::connect(\"%ADDRESS%\").is_ok()",
    ),
    (
        "listen",
        "std::net::TcpListener::bind(\"127.0.0.1:0\").is_ok()",
    ),
    (
        "datagram",
        "std::net::UdpSocket::bind(\"127.0.0.1:0\").is_ok()",
    ),
    ("socket", "std::os::unix::net::UnixStream::pair().is_ok()"),
    (
        "write-folder",
        "std::fs::write(\"%SCRATCH%/owned\", \"owned\").is_ok()",
    ),
    (
        "write-temp",
        "std::fs::write(\"/tmp/pinhole-owned\", \"\").map(|()| std::fs::remove_file(\"/tmp/pinhole-owned\")).is_ok()",
    ),
    (
        "write-shared-memory",
        "std::fs::write(\"/dev/shm/pinhole-owned\", \"\").map(|()| std::fs::remove_file(\"/dev/shm/pinhole-owned\")).is_ok()",
    ),
    (
        "link",
        "std::os::unix::fs::symlink(\"%GOLDEN%\", \"%SCRATCH%/link\").is_ok()",
    ),
    (
        "process",
        "std::process::Command::new(\"/usr/bin/true\").status().is_ok()",
    ),
    (
        "daemon",
        "std::process::Command::new(\"/bin/sleep\").arg(\"3\").spawn().is_ok()",
    ),
    (
        "kill",
        "std::process::Command::new(\"/bin/sh\").args([\"-c\", &format!(\"kill -0 {}\", std::os::unix::process::parent_id())]).status().is_ok_and(|status| status.success())",
    ),
    (
        "fork-bomb",
        "(0..40).filter(|_| std::process::Command::new(\"/bin/sleep\").arg(\"2\").spawn().is_ok()).count() > 20",
    ),
    (
        "thread-bomb",
        "(0..1500).map_while(|_| std::thread::Builder::new().stack_size(16384).spawn(|| std::thread::sleep(std::time::Duration::from_secs(3))).ok()).count() > 500",
    ),
    (
        "files",
        "(0..400).map_while(|_| std::fs::File::open(\"/dev/null\").ok()).collect::<Vec<_>>().len() > 300",
    ),
];

/// System calls that safe Rust has no function for. Safe code still gets at them: it may become
/// another program of the system, and the compiler has unsound corners.
const CALL: &str = "
    #[unsafe(naked)]
    extern \"C\" fn call(n: usize, a: usize, b: usize, c: usize, d: usize, e: usize) -> isize {
        core::arch::naked_asm!(
            \"mov rax, rdi\", \"mov rdi, rsi\", \"mov rsi, rdx\", \"mov rdx, rcx\",
            \"mov r10, r8\", \"mov r8, r9\", \"xor r9d, r9d\", \"syscall\", \"ret\"
        )
    }
    let here = usize::MAX - 99;";

/// Attacks by system calls: name, and an expression that is true if one of them works.
const CALLS: [(&str, &str); 11] = [
    // Once most of a shared mapping is unmapped, its memory is counted for no process. The other
    // call takes from a pool that the whole machine shares.
    (
        "memory-of-nobody",
        "call(9, 0, 1 << 20, 3, 0x21, usize::MAX) > 0 || { let id = 0_u64; call(206, 1, &raw const id as usize, 0, 0, 0) == 0 }",
    ),
    (
        "name-for-a-socket",
        "let mut name = vec![1, 0]; name.extend(b\"%SCRATCH%/name\\0\"); call(49, 0, name.as_ptr() as usize, name.len(), 0, 0) == 0 || { name[2] = 0; call(49, 0, name.as_ptr() as usize, 9, 0, 0) == 0 }",
    ),
    // A socket that asks for its peer's credentials gets a name when it tries to connect.
    (
        "name-for-a-socket-by-connecting",
        "let (on, to, mut name, mut size) = (1_u32, [1_u8, 0, 0], [0_u8; 110], 110_u32); call(54, 0, 1, 16, &raw const on as usize, 4); call(42, 0, to.as_ptr() as usize, 3, 0, 0); call(51, 0, name.as_mut_ptr() as usize, &raw mut size as usize, 0, 0) == 0 && size > 2 || [54, 42, 50, 43, 288].into_iter().any(|n| call(n, 0, 0, 0, 0, 0) != -38)",
    ),
    (
        "times-of-a-device",
        "let null = b\"/dev/null\\0\".as_ptr() as usize; call(280, here, null, 0, 0, 0) == 0 || call(132, null, 0, 0, 0, 0) == 0 || call(235, null, 0, 0, 0, 0) == 0 || call(261, here, null, 0, 0, 0) == 0",
    ),
    (
        "watches-a-folder",
        "call(253, 0, 0, 0, 0, 0) >= 0 || { let folder = call(2, b\"/usr/lib\\0\".as_ptr() as usize, 0o200000, 0, 0, 0); folder >= 0 && call(72, folder as usize, 1026, 1, 0, 0) == 0 }",
    ),
    // The second call exists only since Linux 6.15.
    (
        "opens-a-mount",
        "[428, 467].into_iter().any(|n| call(n, here, b\"/\\0\".as_ptr() as usize, 1, 0, 0) != -38)",
    ),
    ("empties-the-cache", "call(221, 0, 0, 0, 4, 0) != -38"),
    (
        "locks-a-file",
        "let (null, lock) = (call(2, b\"/dev/null\\0\".as_ptr() as usize, 2, 0, 0, 0), [0_u64; 4]); null >= 0 && (call(73, null as usize, 1, 0, 0, 0) == 0 || [6, 7, 37, 38].into_iter().any(|command| call(72, null as usize, command, &raw const lock as usize, 0, 0) == 0))",
    ),
    ("outlives-the-grader", "call(157, 1, 0, 0, 0, 0) == 0"),
    (
        "changes-its-priority",
        "let zero = 0_u64; call(144, 0, 3, &raw const zero as usize, 0, 0) == 0 || call(251, 1, 0, 3 << 13, 0, 0) == 0 || call(141, 0, 0, 1, 0, 0) == 0",
    ),
    // The rules of Landlock and their files take memory of the kernel's. The second call gives up
    // capabilities.
    (
        "asks-for-rules",
        "call(444, 0, 0, 1, 0, 0) > 0 || { let (head, none) = ([0x2008_0522_u64, 0], [0_u64; 3]); call(126, &raw const head as usize, &raw const none as usize, 0, 0, 0) == 0 }",
    ),
];

fn reaches() -> (Vec<Attack>, TcpListener) {
    let listener = TcpListener::bind("127.0.0.1:0").expect("a port is free");
    let address = listener.local_addr().expect("it is bound").to_string();
    let scratch = scratch("hostile-scratch");
    std::fs::write(scratch.join("neighbour.rs"), "fn f() {}").expect("it can be written");
    let path = |path: std::path::PathBuf| path.to_str().expect("a plain name").to_owned();
    let known = [
        (
            "%GOLDEN%",
            path(root().join("golden/ray_casting/manifest.toml")),
        ),
        (
            "%REFERENCE%",
            path(root().join("assignments/ray_casting/reference/src/plane.rs")),
        ),
        ("%NEIGHBOUR%", path(scratch.join("neighbour.rs"))),
        ("%SCRATCH%", path(scratch)),
        ("%HOME%", std::env::var("HOME").expect("HOME is set")),
        ("%SECRET%", SECRET.0.into()),
        ("%ADDRESS%", address),
    ];
    let calls = CALLS.map(|(name, expression)| (name, format!("{CALL} {expression}")));
    let calls = calls.into_iter().filter(|_| cfg!(target_arch = "x86_64"));
    let others = REACHES.map(|(name, expression)| (name, expression.to_owned()));
    let attacks = others.into_iter().chain(calls).map(|(name, expression)| {
        let expression = known
            .iter()
            .fold(expression, |text, (mark, value)| text.replace(mark, value));
        reach(name, &expression)
    });
    (attacks.collect(), listener)
}

/// The attacks that succeed without namespaces. A user who owns nothing may still do what the modes
/// of the container's files allow. The kernel does not count root's processes, and the ordinary user
/// in these tests is root under another number, so it has no limit on processes.
fn succeeds(mode: &str, attack: &str) -> bool {
    match mode {
        modes::WITHOUT_LANDLOCK => [
            // The file is in a folder that everyone may read. `grade` refuses such folders.
            "other-submission",
            "etc",
            "system-file",
            "home",
            "top",
            "other-processes",
            "own-layout",
            "command-lines",
        ]
        .contains(&attack),
        modes::USER => attack == "thread-bomb",
        _ => false,
    }
}

#[test]
fn sandboxed_code_reaches_nothing() {
    let (attacks, _listener) = reaches();
    every_attack_fails_in_every_mode(&attacks, succeeds);
}

#[test]
fn same_code_reaches_everything_without_a_sandbox() {
    let (attacks, _listener) = reaches();
    every_attack_has_its_expected_outcome(&attacks, "none");
}

/// The stream to the grader, which is the program's standard input.
const STREAM: &str = "use std::{io::Write, os::fd::AsFd}; \
    let fd = std::io::stdin().as_fd().try_clone_to_owned().unwrap(); \
    let mut stream = std::os::unix::net::UnixStream::from(fd);";

#[test]
fn code_that_never_answers_costs_only_its_own_task() {
    let attacks = [
        attack("exit", Outcome("died"), "std::process::exit(0);"),
        attack(
            "exit-like-our-own",
            Outcome("died"),
            "eprintln!(\"pinhole: the sandbox could not be set up\"); std::process::exit(125);",
        ),
        // This is how a shell reports that a limit of the kernel ended a process.
        attack(
            "exit-like-a-limit",
            Outcome("died"),
            "std::process::exit(152);",
        ),
        attack(
            "exit-like-full-memory",
            Outcome("died"),
            "eprintln!(\"memory allocation of 7 bytes failed\"); std::process::exit(1);",
        ),
        attack("abort", Outcome("died"), "std::process::abort();"),
        attack(
            "abort-like-full-memory",
            Outcome("died"),
            "eprintln!(\"memory allocation of 7 bytes failed\"); std::process::abort();",
        ),
        attack(
            "killed-like-a-limit",
            Outcome("died"),
            "use std::os::unix::process::CommandExt; let _ = std::process::Command::new(\"/bin/sh\").args([\"-c\", \"kill -XCPU $$\"]).exec(); std::process::exit(1);",
        ),
        attack(
            "exec",
            Outcome("died"),
            "use std::os::unix::process::CommandExt; let _ = std::process::Command::new(\"/usr/bin/true\").exec(); std::process::exit(1);",
        ),
        attack(
            "recursion",
            Outcome("died"),
            "return self.intersect_ray(ray, min_t).map(|at| Intersection { t: at.t + 1.0, ..at });",
        ),
        attack(
            "loop",
            Outcome("timed out"),
            "loop { std::hint::black_box(0); }",
        ),
        attack(
            "sleep",
            Outcome("timed out"),
            "std::thread::sleep(std::time::Duration::from_secs(3600));",
        ),
        attack(
            "deadlock",
            Outcome("timed out"),
            "static M: std::sync::Mutex<()> = std::sync::Mutex::new(()); let _a = M.lock(); let _b = M.lock();",
        ),
        attack("panic", Outcome("panicked"), "panic!(\"no\");"),
        attack(
            "panic-in-panic",
            Outcome("died"),
            "struct A; impl Drop for A { fn drop(&mut self) { panic!(\"two\") } } let _a = A; panic!(\"one\");",
        ),
        attack(
            "panic-with-a-flood",
            Outcome("panicked"),
            "panic!(\"{}\", \"x\".repeat(5_000_000));",
        ),
        attack(
            "panic-of-no-text",
            Outcome("panicked"),
            "std::panic::panic_any(7);",
        ),
        attack(
            "panic-hook",
            Outcome("panicked"),
            "std::panic::set_hook(Box::new(|_| ())); panic!(\"no\");",
        ),
        attack(
            "panic-like-todo",
            Outcome("unanswered"),
            "panic!(\"not yet implemented: plane\");",
        ),
        // This is how a panic is reported. Its file belongs to another answer, which is right.
        attack(
            "panic-like-todo-elsewhere",
            Outcome("panicked"),
            &format!(
                "{STREAM} stream.write_all(b\"\\x25\\0\\0\\0\\x02\\x13not yet implemented\\x0dsrc/sphere.rs\\x01\\0\").unwrap(); loop {{ std::thread::park(); }}"
            ),
        ),
    ];
    every_attack_fails_in_every_mode(&attacks, |_, _| false);
}

#[test]
fn hostile_answers_and_floods_cost_only_their_own_task() {
    let stream = |statements: &str| format!("{STREAM} {statements}");
    let attacks = [
        attack(
            "not-a-number",
            Outcome("refused"),
            "return Some(Intersection { t: f64::NAN, normal: ray.direction });",
        ),
        attack(
            "infinity",
            Outcome("refused"),
            "return Some(Intersection { t: f64::INFINITY, normal: ray.direction });",
        ),
        attack(
            "beyond-f32",
            Outcome("refused"),
            "return Some(Intersection { t: 1e300, normal: ray.direction });",
        ),
        attack(
            "closes-the-stream",
            Outcome("died"),
            &stream("stream.shutdown(std::net::Shutdown::Both).unwrap(); std::process::exit(0);"),
        ),
        attack(
            "garbage",
            Outcome("garbled"),
            &stream("loop { stream.write_all(&[255; 4096]).unwrap(); }"),
        ),
        attack(
            "four-gigabytes",
            Outcome("garbled"),
            &stream(
                "stream.write_all(&[255, 255, 255, 255]).unwrap(); loop { std::thread::park(); }",
            ),
        ),
        attack(
            "nothing-without-end",
            Outcome("garbled"),
            &stream("loop { stream.write_all(&[3, 0, 0, 0, 0, 0, 0]).unwrap(); }"),
        ),
        attack(
            "half-a-message",
            Outcome("timed out"),
            &stream(
                "static ONCE: std::sync::Once = std::sync::Once::new(); ONCE.call_once(|| stream.write_all(&[9, 0, 0]).unwrap()); loop { std::thread::park(); }",
            ),
        ),
        attack(
            "a-drip",
            Outcome("timed out"),
            &stream(
                "stream.write_all(&[255, 10, 0, 0]).unwrap(); loop { let _ = stream.write_all(&[0]); std::thread::sleep(std::time::Duration::from_millis(50)); }",
            ),
        ),
        // A miss for question 0, then the right answer to it.
        attack(
            "answers-twice",
            Outcome("garbled"),
            &stream("stream.write_all(&[5, 0, 0, 0, 0, 0, 1, 0, 0]).unwrap();"),
        ),
        attack(
            "answers-what-nobody-asked",
            Outcome("garbled"),
            &stream(
                "stream.write_all(&[9, 0, 0, 0, 0, 255, 255, 255, 127, 1, 0, 0, 0]).unwrap(); loop { std::thread::park(); }",
            ),
        ),
        attack(
            "a-million-answers-in-a-word",
            Outcome("garbled"),
            &stream(
                "stream.write_all(&[6, 0, 0, 0, 0, 0, 255, 255, 255, 127]).unwrap(); loop { std::thread::park(); }",
            ),
        ),
        attack(
            "memory",
            Hungry,
            "loop { std::mem::forget(std::hint::black_box(vec![1_u8; 64 << 20])); }",
        ),
        attack(
            "memory-by-threads",
            Hungry,
            "for _ in 0..8 { let _ = std::thread::Builder::new().spawn(|| loop { std::mem::forget(std::hint::black_box(vec![1_u8; 16 << 20])); }); } loop { std::mem::forget(std::hint::black_box(vec![1_u8; 16 << 20])); }",
        ),
        // The memory is zeroed but never touched, so it fills only addresses.
        attack(
            "addresses",
            Outcome("died"),
            "loop { std::mem::forget(std::hint::black_box(vec![0_u8; 64 << 20])); }",
        ),
        attack(
            "memory-at-once",
            Outcome("died"),
            "std::hint::black_box(vec![1_u8; 1 << 40]);",
        ),
        attack(
            "floods-output",
            Harmless,
            "static ONCE: std::sync::Once = std::sync::Once::new(); ONCE.call_once(|| for _ in 0..20_000 { println!(\"{}\", \"x\".repeat(1000)); });",
        ),
        attack(
            "floods-errors",
            Harmless,
            "static ONCE: std::sync::Once = std::sync::Once::new(); ONCE.call_once(|| for _ in 0..20_000 { eprintln!(\"{}\", \"x\".repeat(1000)); });",
        ),
        attack(
            "no-text-in-output",
            Harmless,
            "use std::io::Write; std::io::stdout().write_all(&[255, 0, 254, 10]).unwrap();",
        ),
        attack(
            "prints-a-verdict",
            Outcome("judged"),
            "println!(\"{{\\\"points\\\": 100, \\\"passes\\\": true}}\\n✓ plane 12 / 12\"); return Some(Intersection { t: min_t, normal: pinhole::Ray::clone(ray).direction });",
        ),
        attack(
            "leaves-a-thread",
            Harmless,
            "static ONCE: std::sync::Once = std::sync::Once::new(); ONCE.call_once(|| { std::thread::spawn(|| loop { std::hint::black_box(0); }); });",
        ),
        attack(
            "ends-the-others",
            Outcome("died"),
            "std::thread::spawn(|| { std::thread::sleep(std::time::Duration::from_millis(1)); std::process::exit(0) }); std::thread::sleep(std::time::Duration::from_secs(9));",
        ),
    ];
    every_attack_fails_in_every_mode(&attacks, |_, _| false);
}
