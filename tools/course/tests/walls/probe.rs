//! Reports what it can see and do. The test adds two constants: `ROOT`, the folder of a checkout,
//! and `FOLDER`, the folder that this is compiled in.

use std::ffi::{c_int, c_long, c_ulong};
use std::fs::{self, File};
use std::os::unix::process::CommandExt;
use std::process::{Command, Stdio};

unsafe extern "C" {
    fn syscall(number: c_long, ...) -> c_long;
    fn prctl(option: c_int, ...) -> c_int;
    fn getresuid(real: *mut u32, effective: *mut u32, saved: *mut u32) -> c_int;
    fn getresgid(real: *mut u32, effective: *mut u32, saved: *mut u32) -> c_int;
    fn getgroups(size: c_int, groups: *mut u32) -> c_int;
    fn getrlimit(resource: c_int, limit: *mut [c_ulong; 2]) -> c_int;
    fn fcntl(file: c_int, command: c_int) -> c_int;
    fn getsid(pid: c_int) -> c_int;
}

const HERE: c_long = -100;
const UNKNOWN: c_int = 38;

/// Whether a call fails as if the kernel did not have it. All of these calls fail anyway.
fn denied(number: c_long, arguments: [c_long; 4]) -> bool {
    let [a, b, c, d] = arguments;
    let result = unsafe { syscall(number, a, b, c, d, -1 as c_long, 0 as c_long) };
    result == -1 && std::io::Error::last_os_error().raw_os_error() == Some(UNKNOWN)
}

fn main() {
    let (mut users, mut groups) = ([0; 3], [0; 3]);
    let [a, b, c] = &mut users;
    unsafe { getresuid(a, b, c) };
    let [a, b, c] = &mut groups;
    unsafe { getresgid(a, b, c) };
    let others = unsafe { getgroups(0, std::ptr::null_mut()) };
    eprintln!("user {users:?} group {groups:?} and {others} more");

    for (name, resource) in [
        ("cpu", 0),
        ("file size", 1),
        ("core", 4),
        ("processes", 6),
        ("open files", 7),
        ("locked memory", 8),
        ("address space", 9),
        ("pending signals", 11),
        ("message queues", 12),
    ] {
        let mut limit = [0; 2];
        unsafe { getrlimit(resource, &mut limit) };
        eprintln!("{name} {limit:?}");
    }

    let mut signal: c_int = 0;
    let (new, filter) = unsafe { (prctl(39, 0, 0, 0, 0), prctl(21, 0, 0, 0, 0)) };
    unsafe { prctl(2, &raw mut signal) };
    eprintln!("no new privileges {new}, filter {filter}, dies with parent by {signal}");
    let leads = unsafe { getsid(0) } == std::process::id() as c_int;
    eprintln!("leads its session {leads}");
    let open = (3..1000).filter(|file| unsafe { fcntl(*file, 1) } >= 0);
    eprintln!("open files {:?}", open.collect::<Vec<_>>());
    let names = std::env::vars().map(|(name, _)| name);
    eprintln!("environment {:?}", names.collect::<Vec<_>>());

    let (dev, new) = (c"/dev".as_ptr() as c_long, c"/dev/new".as_ptr() as c_long);
    let calls = [
        ("ptrace", 101, [-1, 0, 0, 0]),
        ("clone a namespace", 56, [0x1000_0200, 0, 0, 0]),
        ("add a filter", 317, [-1, 0, 0, 0]),
        ("add a filter by its old name", 157, [22, -1, 0, 0]),
        ("rules", 444, [0, 0, 1, 0]),
        ("clone a process", 56, [0x800, 0, 0, 0]),
        ("clone a thread", 56, [0x1_0000, 0, 0, 0]),
        ("clone a thread that is waited for", 56, [0x1_4000, 0, 0, 0]),
        ("clone a watched thread", 56, [0x1_1000, 0, 0, 0]),
        ("socket", 41, [-1, -1, -1, 0]),
        ("ask a socket", 55, [0, 1, 57, 0]),
        ("make a folder", 83, [0, 0, 0, 0]),
        ("openat a new file", 257, [HERE, new, 0o101, 0]),
        ("openat to empty a file", 257, [HERE, 0, 0o1001, 0]),
        ("openat a link", 257, [HERE, 0, 0o1000_0000, 0]),
        ("openat a file without a name", 257, [HERE, dev, 0o2020_0001, 0]),
        ("openat a folder", 257, [HERE, 0, 0o20_0000, 0]),
        ("open a new file", 2, [new, 0o101, 0, 0]),
        ("open to empty a file", 2, [0, 0o1001, 0, 0]),
        ("open a file without a name", 2, [dev, 0o2020_0001, 0, 0]),
        ("open a folder", 2, [0, 0o20_0000, 0, 0]),
        ("share memory", 9, [0, 0, 0, 1]),
        ("use huge pages", 9, [0, 0, 0, 0x4_0002]),
        ("keep memory", 9, [0, 0, 0, 2]),
        ("lock", 72, [-1, 6, 0, 0]),
        ("store a number", 72, [-1, 1036, 0, 0]),
        ("ask for flags", 72, [-1, 3, 0, 0]),
        ("ask for addresses", 16, [-1, 0x8912, 0, 0]),
        ("do not wait", 16, [-1, 0x5421, 0, 0]),
        ("look at a file", 262, [HERE, 0, 0, 0]),
        ("look at a file by its old name", 4, [0, 0, 0, 0]),
        ("look at an open file", 262, [0, 0, 0, 0x1000]),
        ("look at a link", 262, [HERE, 0, 0, 0x100]),
        ("look at a link by its old name", 6, [0, 0, 0, 0]),
        ("look at a link by its new name", 332, [HERE, 0, 0x100, 0]),
        ("ask whether there is a file", 21, [0, 0, 0, 0]),
        ("send a byte out of order", 44, [-1, 0, 0, 1]),
        ("send no signal", 44, [-1, 0, 0, 0x4000]),
        ("look at what was sent", 45, [-1, 0, 0, 2]),
        ("receive", 45, [-1, 0, 0, 0]),
        ("store an attribute", 188, [0, 0, 0, 0]),
        ("cut a file", 76, [0, -1, 0, 0]),
        ("make a timer", 222, [-1, 0, 0, 0]),
        ("drop pages", 28, [0, 0, 21, 0]),
        ("free pages", 28, [0, 0, 4, 0]),
        ("ask for the clock of a process", 228, [-10, 0, 0, 0]),
        ("ask for the time", 228, [1, -1, 0, 0]),
        ("change a limit", 302, [0, 4, 1, 0]),
        ("change the limit of another", 302, [1, 4, 0, 0]),
        ("watch a process", 434, [-1, 0, 0, 0]),
        ("outlive the parent", 157, [1, -1, 0, 0]),
        ("take a name", 157, [15, 0, 0, 0]),
        ("make a table of futexes", 157, [78, -1, 0, 0]),
        ("ask for a signal", 157, [2, 0, 0, 0]),
    ];
    let mut all = Vec::new();
    for (name, number, arguments) in calls {
        if denied(number, arguments) {
            all.push(name);
        }
    }
    eprintln!("unknown calls {all:?}");

    let itself = std::env::current_exe();
    let folder = FOLDER.to_owned();
    for (name, path) in [
        ("secret", ROOT.to_owned() + "/secret"),
        ("passwd", "/etc/passwd".into()),
        ("program", "/usr/bin/env".into()),
        ("home", "/root".into()),
        ("processes", "/proc/1/stat".into()),
        ("terminals", "/dev/ptmx".into()),
        ("source", folder.clone() + "/src/probe.rs"),
        ("itself", itself.map_or("?".into(), |path| path.display().to_string())),
    ] {
        if File::open(&path).is_ok() {
            eprintln!("reads {name}");
        }
    }
    for (name, path) in [
        ("out", folder.clone() + "/out/new"),
        ("folder", folder.clone() + "/new"),
        ("source", folder + "/src/new"),
        ("tmp", "/tmp/pinhole-new".into()),
        ("top", "/pinhole-new".into()),
        ("dev", "/dev/pinhole-new".into()),
        ("shm", "/dev/shm/pinhole-new".into()),
    ] {
        if fs::write(&path, "").is_ok() {
            eprintln!("writes {name}");
            let _ = fs::remove_file(path);
        }
    }
    // This process tries to stay.
    let mut sleep = Command::new("/usr/bin/sleep");
    sleep.arg("600").process_group(0);
    for set in [Command::stdin, Command::stdout, Command::stderr] {
        set(&mut sleep, Stdio::null());
    }
    if sleep.spawn().is_ok() {
        eprintln!("starts a program");
    }
    eprintln!("the secret is in {ROOT}/secret");
}

