//! What the probe should report in each mode.

use pinhole_course::sandbox::Limits;

use crate::modes::{BUBBLEWRAP, CONTAINER, USER, WITHOUT_LANDLOCK};

/// Compares a report with the expected one, and shows the first lines that differ.
#[track_caller]
pub fn expect(report: &str, expected: &str) {
    let differ = |(line, other): &(&str, &str)| line != other;
    let first = report.lines().zip(expected.lines()).find(differ);
    assert!(report == expected, "{first:?} in\n{report}");
}

/// What the probe should say in place of the compiler. It may write in `/tmp`, which is empty and
/// its own in bubblewrap, and ours has `FOLDER` in it.
pub fn while_compiling(mode: &str, user: u32, limits: &Limits) -> String {
    let (environment, may) = match mode {
        BUBBLEWRAP => ("PWD", "writes out, writes tmp"),
        USER => ("PWD", "writes out, writes folder, writes tmp"),
        CONTAINER => ("TMPDIR", "writes out"),
        _ => (
            "TMPDIR",
            "writes out, writes folder, writes tmp, writes shm",
        ),
    };
    let (rules, passwd, processes) = match mode {
        WITHOUT_LANDLOCK => (
            ", \"rules\"",
            "reads passwd, ",
            "reads processes, reads terminals, ",
        ),
        _ => ("", "", ""),
    };
    confined(user, limits)
        + &format!(
            "environment [\"PATH\", \"{environment}\"]\n\
             unknown calls [\"ptrace\", \"clone a namespace\"{rules}]\n"
        )
        + &format!(
            "{passwd}reads program, {processes}reads source, reads itself, {may}, \
             starts a program, the secret is in pinhole/secret, "
        )
        .replace(", ", "\n")
}

/// The calls of the probe that answers may not make.
const UNKNOWN: [&str; 42] = [
    "ptrace",
    "clone a namespace",
    "add a filter",
    "add a filter by its old name",
    "rules",
    "clone a process",
    "clone a thread that is waited for",
    "clone a watched thread",
    "socket",
    "ask a socket",
    "make a folder",
    "openat a new file",
    "openat to empty a file",
    "openat a link",
    "openat a file without a name",
    "open a new file",
    "open to empty a file",
    "open a file without a name",
    "share memory",
    "use huge pages",
    "lock",
    "store a number",
    "ask for addresses",
    "look at a file",
    "look at a file by its old name",
    "look at a link",
    "look at a link by its old name",
    "look at a link by its new name",
    "ask whether there is a file",
    "send a byte out of order",
    "look at what was sent",
    "store an attribute",
    "cut a file",
    "make a timer",
    "drop pages",
    "ask for the clock of a process",
    "change a limit",
    "change the limit of another",
    "watch a process",
    "outlive the parent",
    "take a name",
    "make a table of futexes",
];

/// What the probe should say as an answer.
pub fn while_answering(mode: &str, user: u32, limits: &Limits) -> String {
    let environment = match mode {
        BUBBLEWRAP | USER => "PWD",
        _ => "PATH",
    };
    let may = match mode {
        WITHOUT_LANDLOCK => {
            "reads passwd, reads program, reads processes, reads terminals, reads source, "
        }
        _ => "",
    };
    confined(user, limits)
        + &format!(
            "environment [\"{environment}\"]\n\
             unknown calls {UNKNOWN:?}\n"
        )
        + &format!("{may}the secret is in pinhole/secret, ").replace(", ", "\n")
}

/// What the probe should say about its user and limits.
fn confined(user: u32, limits: &Limits) -> String {
    // The kernel's limit comes five seconds after the watchdog's, and warns a second before.
    let most = limits.cpu.as_secs() + 5;
    let cpu = most - 1;
    let Limits {
        file_size,
        processes,
        open_files,
        address_space,
        ..
    } = limits;
    format!(
        "user [{user}, {user}, {user}] group [{user}, {user}, {user}] and 0 more\n\
         cpu [{cpu}, {most}]\n\
         file size [{file_size}, {file_size}]\n\
         core [1, 1]\n\
         processes [{processes}, {processes}]\n\
         open files [{open_files}, {open_files}]\n\
         locked memory [0, 0]\n\
         address space [{address_space}, {address_space}]\n\
         pending signals [0, 0]\n\
         message queues [0, 0]\n\
         no new privileges 1, filter 2, dies with parent by 9\n\
         leads its session true\n\
         open files []\n"
    )
}
