//! Surroundings in which one kind of sandbox works. `tools/cli/tests/cli/modes.rs` makes the same
//! ones for the command line.

use std::fs::{self, File, Permissions};
use std::os::unix::fs::PermissionsExt;
use std::path::Path;
use std::process::Command;

use libtest_mimic::Failed;

/// Bubblewrap as root, or as the user who runs the tests.
pub const BUBBLEWRAP: &str = "bubblewrap";
/// Bubblewrap as an ordinary user.
pub const USER: &str = "bubblewrap as a user";
/// Another user id and Landlock, where namespaces are forbidden.
pub const CONTAINER: &str = "container (another user, Landlock)";
/// Another user id alone.
pub const WITHOUT_LANDLOCK: &str = "container without Landlock (another user)";
/// Like [`CONTAINER`], but other users can't reach the toolchain.
pub const UNREACHABLE: &str = "container with a private toolchain";

/// The word by which this program starts itself in the surroundings of a mode.
pub const INSIDE: &str = "inside";

/// Starts this program again where only one kind of sandbox works.
pub fn surround(mode: &str) -> Result<(), Failed> {
    let folder = tempfile::tempdir()?;
    let open_to_all = |path: &Path| fs::set_permissions(path, Permissions::from_mode(0o711));
    open_to_all(folder.path())?;
    let course = folder.path().join("course");
    fs::create_dir(&course)?;
    fs::set_permissions(&course, Permissions::from_mode(0o700))?;
    fs::write(course.join("secret"), "it is secret")?;
    let program = folder.path().join("program");
    fs::copy(std::env::current_exe()?, &program)?;
    // The program will inherit an open file, as from a user's shell.
    let _open = rustix::io::dup(File::open(course.join("secret"))?)?;

    let mut command = Command::new("env");
    if mode != USER && rustix::process::getuid().is_root() {
        // A group that the code must not be in.
        command.args(["setpriv", "--groups", "1"]);
    }
    if mode != BUBBLEWRAP {
        command.args(["bwrap", "--dev-bind", "/", "/"]);
    }
    match mode {
        BUBBLEWRAP => (),
        USER => {
            command.args(["--unshare-user", "--uid", "1000", "--gid", "1000", "--"]);
        }
        _ => {
            // Lets other users reach the toolchain.
            command.args(["--cap-add", "ALL", "--ro-bind", &sysroot(), "/mnt"]);
            let path = std::env::var("PATH")?;
            command.env("PATH", format!("/mnt/bin:{path}"));
            command.env_remove("RUSTC").env_remove("LD_LIBRARY_PATH");
            // The filter that confines submissions also forbids namespaces.
            let limits = "confine --compiles --cpu 1000000 --address-space 1000000000000 \
                 --processes 100000 --file-size 100000000000 --open-files 1000 --read / --write /";
            command
                .arg("--")
                .arg(&program)
                .args(limits.split_whitespace());
            if mode == WITHOUT_LANDLOCK {
                command.arg("--without-landlock");
            }
            command.arg("--");
            if mode == UNREACHABLE {
                let rustc = course.join("rustc");
                fs::write(&rustc, format!("#!/bin/sh\ncat {course:?}/sysroot"))?;
                open_to_all(&rustc)?;
                command.env("RUSTC", rustc);
            }
        }
    }
    command.arg(&program).args([INSIDE, mode]);
    let output = command.current_dir(&course).output()?;
    match output.status.success() {
        true => Ok(()),
        false => Err(String::from_utf8_lossy(&output.stderr).into()),
    }
}

/// The folder of the toolchain.
pub fn sysroot() -> String {
    let sysroot = Command::new("rustc").args(["--print", "sysroot"]).output();
    let sysroot = String::from_utf8(sysroot.expect("there is rustc").stdout);
    sysroot.expect("it is text").trim().to_owned()
}
