//! The four kinds of sandbox on one machine. Each attack must fail in all of them.
//!
//! The tests use bubblewrap to imitate a container: root keeps its rights inside but can't
//! make a namespace, as under Docker's default seccomp profile, and the toolchain lies where
//! every user can reach it. To imitate an ordinary user, they run as another user id.

use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use pinhole_course::shell::in_shell;
use pinhole_testing::{program_of, root};

/// Bubblewrap as root, or as the user who runs the tests.
pub const BUBBLEWRAP: &str = "bubblewrap";
/// Bubblewrap as an ordinary user.
pub const USER: &str = "bubblewrap as a user";
/// Another user id and Landlock.
pub const CONTAINER: &str = "container";
/// Another user id alone.
pub const WITHOUT_LANDLOCK: &str = "container-without-landlock";

/// The sandbox of containers, by root of a user namespace with a range of ids, as Apptainer's
/// `--fakeroot --writable-tmpfs` makes it.
pub const ROOTLESS: &str = "container without root";

/// All that differ in what confines the code.
pub const ALL: [&str; 4] = [BUBBLEWRAP, USER, CONTAINER, WITHOUT_LANDLOCK];

/// The mode's value of `--sandbox`.
pub fn sandbox(mode: &str) -> &str {
    match mode {
        USER => BUBBLEWRAP,
        ROOTLESS => CONTAINER,
        mode => mode,
    }
}

/// Whether this machine can try a mode. Only root can become another user.
pub fn can_be_tried(mode: &str) -> bool {
    let id = Command::new("id").arg("-u").output();
    let is_root = id.expect("there is `id`").stdout == b"0\n";
    let is_tried = is_root || mode == BUBBLEWRAP;
    if !is_tried {
        eprintln!("{mode} needs root: not tried");
    }
    is_tried
}

/// Runs `pinhole` at the top of the checkout in one of the modes, or without one.
pub fn run(mode: &str, environment: &[(&str, &str)], arguments: &[&str]) -> Output {
    let mut command = command(mode, environment, arguments);
    command.output().expect("it starts")
}

/// Like [`run`], but in a terminal of its own.
pub fn run_in_a_terminal(mode: &str, arguments: &[&str]) -> Output {
    let command = command(mode, &[], arguments);
    let words = [command.get_program()]
        .into_iter()
        .chain(command.get_args());
    let words = words.map(|word| in_shell(word.to_str().expect("plain words")));
    let line = words.collect::<Vec<_>>().join(" ");
    let mut script = Command::new("script");
    script.args(["--quiet", "--return", "--command", &line, "/dev/null"]);
    for (name, value) in command.get_envs() {
        match value {
            Some(value) => script.env(name, value),
            None => script.env_remove(name),
        };
    }
    script
        .current_dir(root())
        .output()
        .expect("there is `script`")
}

fn command(mode: &str, environment: &[(&str, &str)], arguments: &[&str]) -> Command {
    let mut command = match mode {
        USER => as_a_user(),
        CONTAINER => in_a_container(true),
        WITHOUT_LANDLOCK => in_a_container(false),
        ROOTLESS => as_root_of_a_namespace(),
        _ => Command::new("env"),
    };
    command.arg(program_of(arguments[0])).args(arguments);
    command.envs(environment.iter().copied());
    command.current_dir(root());
    command
}

fn as_a_user() -> Command {
    let mut outer = Command::new("bwrap");
    outer.args(["--dev-bind", "/", "/", "--unshare-user"]);
    outer.args(["--uid", "1000", "--gid", "1000", "--"]);
    outer
}

/// The folder of the toolchain.
fn sysroot() -> String {
    let sysroot = Command::new("rustc").args(["--print", "sysroot"]).output();
    let sysroot = String::from_utf8(sysroot.expect("there is rustc").stdout).expect("text");
    sysroot.trim().to_owned()
}

/// Real root writes the maps of ids, where Apptainer would call `newuidmap`. Inside, root keeps its
/// id, so that it can read the checkout, but has no rights outside.
fn as_root_of_a_namespace() -> Command {
    const MAKE: &str = r#"
        exec 3>&1
        coproc inside {
            exec unshare --user --mount --pid --fork --kill-child bash -c '
                read -r
                mount -t proc proc /proc
                mount -t tmpfs tmpfs /run
                mount --bind "$0" /mnt
                exec "$@"' "$@" >&3
        }
        pid=$inside_PID
        until [ "$(readlink "/proc/$pid/ns/user")" != "$(readlink /proc/self/ns/user)" ]; do
            sleep 0.01
        done
        for map in uid_map gid_map; do
            # The kernel wants both lines at once.
            cat <<<$'0 0 1\n1 100000 65535' >"/proc/$pid/$map"
        done
        echo >&"${inside[1]}"
        wait "$pid"
    "#;
    let mut outer = Command::new("bash");
    outer.args(["-c", MAKE, "bash", &sysroot()]);
    with_toolchain_in_mnt(&mut outer);
    outer
}

fn in_a_container(landlock: bool) -> Command {
    let mut outer = Command::new("bwrap");
    outer.args(["--dev-bind", "/", "/", "--cap-add", "ALL"]);
    outer.args(["--ro-bind", &sysroot(), "/mnt"]);
    if !landlock {
        close_checkout(&mut outer);
    }
    // The filter that confines submissions also forbids namespaces.
    let limits = "--compiles --cpu 1000000 --address-space 1000000000000 \
         --processes 100000 --file-size 100000000000 --open-files 1000 --read / --write /";
    outer.arg("--").arg(env!("CARGO_BIN_EXE_pinhole"));
    outer.arg("confine").args(limits.split_whitespace());
    if !landlock {
        outer.arg("--without-landlock");
    }
    outer.arg("--");
    with_toolchain_in_mnt(&mut outer);
    outer
}

/// Lets programs find the toolchain where every user can reach it.
fn with_toolchain_in_mnt(outer: &mut Command) {
    let path = std::env::var("PATH").expect("there is a PATH");
    outer
        .env("PATH", format!("/mnt/bin:{path}"))
        .env_remove("RUSTUP_TOOLCHAIN")
        .env_remove("CARGO")
        .env_remove("RUSTC")
        // Cargo sets this to the folder of the toolchain's libraries, and rustc looks beside
        // them.
        .env_remove("LD_LIBRARY_PATH");
}

/// Imitates `chmod 700` of the checkout for programs inside: only root may enter a folder above
/// it. Cargo's own folder may be in there too.
fn close_checkout(outer: &mut Command) {
    let root = root();
    let above = root.parent().expect("it is not the top").to_owned();
    outer.args(["--perms", "0700", "--tmpfs"]).arg(&above);
    let home = std::env::var_os("HOME")
        .map(PathBuf::from)
        .unwrap_or_default();
    let cargo = std::env::var_os("CARGO_HOME").map_or(home.join(".cargo"), PathBuf::from);
    let again = [root.as_path(), cargo.as_path()];
    for folder in again.iter().filter(|folder| Path::is_dir(folder)) {
        outer.arg("--dev-bind").args([folder, folder]);
    }
}
