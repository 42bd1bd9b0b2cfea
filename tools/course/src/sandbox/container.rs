//! Walls where no namespace can be had, as under Docker's default seccomp profile: the
//! code runs as a user that owns nothing, behind Landlock where the kernel has it.
//!
//! Weaker than bubblewrap: what everyone may read in this container can be read unless
//! Landlock forbids it. So it is for containers that hold one submission and are
//! thrown away.

use std::fs::{self, Permissions};
use std::io;
use std::os::unix::fs::{PermissionsExt, chown};
use std::path::{Path, PathBuf};
use std::process::Command;

use super::Limits;
use super::budget::Budget;
use super::confine;
use super::syscalls::Purpose;
use super::toolchain::{linker, next_uid, sysroot};
use crate::checkout::Checkout;
use crate::error::{Error, Result, ResultExt};

/// What is needed to draw them.
#[derive(Clone, Debug)]
pub struct Container {
    sysroot: PathBuf,
    pinhole: PathBuf,
    uid: u32,
    /// Whether the kernel guards files beyond what their modes say.
    landlocked: bool,
    /// What timeouts have cost so far.
    pub budget: Budget,
}

impl Container {
    /// Tries whether walls can be drawn here.
    pub fn new(checkout: &Checkout, secrets: &[PathBuf]) -> Result<Container> {
        if !rustix::process::getuid().is_root() {
            return Err(Error::environment(
                "only root can run code as another user, and --sandbox container needs that",
                "run this as root inside the container, or use --sandbox bubblewrap",
            ));
        }
        let mut walls = Container {
            sysroot: sysroot()?,
            pinhole: std::env::current_exe()
                .or_environment("cannot find this program's own file", "run this again")?,
            uid: next_uid(),
            landlocked: true,
            budget: Budget::default(),
        };
        walls.landlocked = walls.self_test().is_ok();
        walls.self_test().or_environment(
            "code cannot be confined here",
            "let every user read the checkout's target folder, or use --sandbox bubblewrap",
        )?;
        walls.refuse_unreachable_toolchain()?;
        if !walls.landlocked {
            walls.refuse_readable(checkout, secrets)?;
        }
        close_fds::set_fds_cloexec(3, &[]);
        Ok(walls)
    }

    /// See [`Sandbox::anew`](super::Sandbox::anew).
    pub fn new_instance(&self) -> Container {
        Container {
            uid: next_uid(),
            budget: Budget::default(),
            ..self.clone()
        }
    }

    /// Which walls these are, for results.
    pub fn name(&self) -> &'static str {
        match self.landlocked {
            true => "container (another user, Landlock)",
            false => "container (another user)",
        }
    }

    /// Whom the code runs as.
    pub fn uid(&self) -> u32 {
        self.uid
    }

    /// Whether a program can be run inside.
    pub fn self_test(&self) -> io::Result<()> {
        let mut command = self.confined(&Limits::of_compiler(), Purpose::Answer);
        let output = command.args(["--", "/usr/bin/true"]).output();
        let output = output?;
        match output.status.success() {
            true => Ok(()),
            false => Err(io::Error::other(
                String::from_utf8_lossy(&output.stderr).trim(),
            )),
        }
    }

    /// See [`Sandbox::compiler`](super::Sandbox::compiler).
    pub fn compiler(&self, folder: &Path, harness: &Path, limits: &Limits) -> io::Result<Command> {
        let out = folder.join("out");
        // Nobody else's code may look inside, or find the program there later.
        fs::set_permissions(folder, Permissions::from_mode(0o700))?;
        chown(folder, Some(self.uid), Some(self.uid))?;
        chown(&out, Some(self.uid), Some(self.uid))?;
        let mut command = self.confined(limits, Purpose::Compile);
        command.current_dir(folder);
        command.env("TMPDIR", &out);
        for read in [&self.sysroot, harness, folder] {
            command.arg("--read").arg(read);
        }
        command.arg("--write").arg(&out);
        command
            .arg("--")
            .arg(self.sysroot.join("bin").join("rustc"));
        command.args(linker(&self.sysroot));
        Ok(command)
    }

    /// A built program, to be asked.
    pub fn runner(&self, executable: &Path, limits: &Limits) -> Command {
        let mut command = self.confined(limits, Purpose::Answer);
        command.current_dir("/");
        command.arg("--read").arg(executable);
        command.arg("--").arg(executable);
        command
    }

    fn confined(&self, limits: &Limits, purpose: Purpose) -> Command {
        let mut command = Command::new(&self.pinhole);
        command.env_clear().env("PATH", "/usr/bin:/bin");
        confine::arguments(&mut command, limits, purpose, Some(self.uid));
        if self.landlocked {
            command.arg("--landlocked");
        }
        // Not /proc: it shows every process of the container.
        for read in [
            "/usr",
            "/lib",
            "/lib64",
            "/bin",
            "/etc/ld.so.cache",
            "/dev/null",
        ] {
            command.args(["--read", read]);
        }
        command.args(["--write", "/dev/null"]);
        command
    }

    /// Whether the code's user may read a file or folder.
    fn reads(&self, path: &Path) -> bool {
        let mut command = self.confined(&Limits::of_compiler(), Purpose::Answer);
        command.arg("--read").arg(path);
        command.args(["--", "/usr/bin/test", "-r"]).arg(path);
        command.status().is_ok_and(|status| status.success())
    }

    fn refuse_unreachable_toolchain(&self) -> Result<()> {
        let rustc = self.sysroot.join("bin").join("rustc");
        match self.reads(&rustc) {
            true => Ok(()),
            false => Err(Error::environment(
                format!("another user cannot reach {}", rustc.display()),
                "install Rust where everyone may read it (RUSTUP_HOME=/opt/rustup, say), or let \
                 everyone pass through the folders above it (chmod a+x)",
            )),
        }
    }

    fn refuse_readable(&self, checkout: &Checkout, secrets: &[PathBuf]) -> Result<()> {
        let own = [checkout.root().join("golden"), checkout.assignments()];
        match own.iter().chain(secrets).find(|secret| self.reads(secret)) {
            None => Ok(()),
            Some(secret) => Err(Error::environment(
                format!(
                    "every user may read {}, and this kernel has no Landlock to forbid it",
                    secret.display()
                ),
                format!(
                    "chmod -R go-rwx {}",
                    crate::shell::in_shell(&secret.display().to_string())
                ),
            )),
        }
    }
}
