//! The sandbox for machines without namespaces, such as containers with Docker's default seccomp
//! profile. The code runs as a user that owns nothing, restricted by Landlock.
//!
//! If the kernel has no Landlock, only file modes keep the code from reading files. Then this
//! sandbox is refused unless the user asks for it by name, and even then, the checkout and
//! everything else that is secret must be closed to the code's user. So the files that the code
//! needs are in a folder outside the checkout.

use std::fs::{self, DirBuilder, File, Permissions};
use std::io;
use std::os::unix::fs::{DirBuilderExt, MetadataExt, PermissionsExt, chown};
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::Arc;
use std::sync::atomic::{AtomicU32, Ordering};
use std::time::Duration;

use super::Limits;
use super::budget::Budget;
use super::confine;
use super::host_paths::HostPaths;
use super::secrets::refuse_visible_secrets;
use super::syscalls::Purpose;
use super::toolchain::{libraries, linker, sysroot};
use super::user_id::UserId;
use crate::checkout::Checkout;
use crate::error::{Error, Result, ResultExt};
use crate::private::private_file;

/// The sandbox for one submission in a container.
#[derive(Clone, Debug)]
pub struct Container {
    sysroot: PathBuf,
    pinhole: PathBuf,
    uid: UserId,
    /// Whether Landlock restricts the code, and not only file modes.
    landlocked: bool,
    /// The folder of the libraries that the code is compiled against, and of the programs.
    scratch: Arc<Scratch>,
    /// Paths that the code's author must not see.
    pub host_paths: HostPaths,
    /// What the submission may still take.
    pub budget: Budget,
}

impl Container {
    /// Checks that this sandbox works here. A missing Landlock is an error unless the user accepts
    /// file modes alone (`accepts_modes`).
    pub fn new(checkout: &Checkout, secrets: &[PathBuf], accepts_modes: bool) -> Result<Container> {
        if !rustix::process::getuid().is_root() {
            return Err(Error::environment(
                "--sandbox container runs code as another user, and only root can do that",
                "run this as root inside the container, or use --sandbox bubblewrap",
            ));
        }
        let (sysroot, scratch) = (sysroot(checkout)?, Scratch::new()?);
        let mut walls = Container {
            host_paths: HostPaths::new(checkout, &sysroot, Some(&scratch.folder)),
            sysroot,
            pinhole: std::env::current_exe()
                .or_environment("cannot find this program's own file", "run this again")?,
            uid: UserId::reserve()?,
            landlocked: true,
            scratch: Arc::new(scratch),
            budget: Budget::default(),
        };
        walls.landlocked = walls.self_test().is_ok();
        walls.self_test().or_environment(
            "code cannot be confined here",
            "use --sandbox bubblewrap, or another machine",
        )?;
        walls.refuse_unreachable()?;
        let visible: Vec<&Path> = SYSTEM
            .iter()
            .map(Path::new)
            .chain([&*walls.sysroot])
            .collect();
        refuse_visible_secrets(&visible, checkout, secrets)?;
        if !walls.landlocked {
            if !accepts_modes {
                return Err(Error::environment(
                    "this kernel has no Landlock, so only file permissions could stop code in \
                     this container from reading secrets",
                    "use bubblewrap, or a kernel with Landlock (Linux 5.13 or newer); in a \
                     container that holds nothing else of value, you may pass --sandbox \
                     container-without-landlock, and every result will say so",
                ));
            }
            walls.refuse_readable(checkout, secrets)?;
        }
        close_fds::set_fds_cloexec(3, &[]);
        Ok(walls)
    }

    /// See [`Sandbox::new_instance`](super::Sandbox::new_instance).
    pub fn new_instance(&self, whole: Duration) -> Result<Container> {
        Ok(Container {
            uid: UserId::reserve()?,
            budget: Budget::of(whole),
            ..self.clone()
        })
    }

    /// The sandbox's name, for results.
    pub fn name(&self) -> &'static str {
        match self.landlocked {
            true => "container (another user, Landlock)",
            false => "container without Landlock (another user)",
        }
    }

    /// The folder for the harness and the programs.
    pub fn scratch(&self) -> &Path {
        &self.scratch.folder
    }

    /// The user that the code runs as.
    pub fn uid(&self) -> u32 {
        self.uid.number()
    }

    /// Checks that a program can run inside.
    pub fn self_test(&self) -> io::Result<()> {
        let mut command = self.confined(&Limits::of_compiler(), Purpose::Answer);
        let program = "/usr/bin/true";
        let output = command.args(["--read", program, "--", program]).output();
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
        // Keeps other submissions from looking inside.
        fs::set_permissions(folder, Permissions::from_mode(0o700))?;
        chown(folder, Some(self.uid()), Some(self.uid()))?;
        chown(&out, Some(self.uid()), Some(self.uid()))?;
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

    /// A built program, ready to be asked.
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
        confine::arguments(&mut command, limits, purpose, Some(self.uid()));
        if self.landlocked {
            command.arg("--landlocked");
        }
        // Don't add /proc, because it shows every process of the container.
        match purpose {
            Purpose::Compile => command.args(SYSTEM.iter().flat_map(|read| ["--read", *read])),
            Purpose::Answer => {
                let read = libraries();
                command.args(
                    read.iter()
                        .flat_map(|read| [Path::new("--read"), read.as_path()]),
                )
            }
        };
        command.args(["--write", "/dev/null"]);
        command
    }

    /// Whether the code's user may do this to a file or folder, where `-r`, for instance, means
    /// reading.
    fn may(&self, how: &[&str], path: &Path) -> bool {
        how.iter().any(|how| {
            let mut command = self.confined(&Limits::of_compiler(), Purpose::Compile);
            command.arg("--read").arg(path);
            let program = "/usr/bin/test";
            command
                .args(["--read", program, "--", program, how])
                .arg(path);
            command.status().is_ok_and(|status| status.success())
        })
    }

    fn refuse_unreachable(&self) -> Result<()> {
        let rustc = self.sysroot.join("bin").join("rustc");
        if !self.may(&["-r"], &rustc) {
            return Err(Error::environment(
                format!("another user cannot reach {}", rustc.display()),
                "install Rust where everyone may read it (for example, with RUSTUP_HOME=/opt/rustup), or let \
                 everyone pass through the folders above it (chmod a+x)",
            ));
        }
        match self.may(&["-x"], self.scratch()) {
            true => Ok(()),
            false => Err(Error::environment(
                format!("another user cannot reach {}", self.scratch().display()),
                "set TMPDIR to a folder that everyone may pass through, such as /tmp",
            )),
        }
    }

    /// Refuses if the code's user can read something secret. A folder that the user can enter
    /// counts as readable, because names inside can be guessed.
    fn refuse_readable(&self, checkout: &Checkout, secrets: &[PathBuf]) -> Result<()> {
        let own = [checkout.root().to_owned()];
        let mut all = own.iter().chain(secrets);
        match all.find(|secret| self.may(&["-r", "-x"], secret)) {
            None => Ok(()),
            Some(secret) => Err(Error::environment(
                format!(
                    "every user may read {}, and this kernel has no Landlock to forbid it",
                    secret.display()
                ),
                format!(
                    "chmod go-rwx {}",
                    crate::shell::in_shell(&secret.display().to_string())
                ),
            )),
        }
    }
}

/// What the compiler may read of the system.
const SYSTEM: [&str; 6] = [
    "/usr",
    "/lib",
    "/lib64",
    "/bin",
    "/etc/ld.so.cache",
    "/dev/null",
];

/// A folder that belongs to root. Everyone may pass through it, but only root may list it.
#[derive(Debug)]
pub(super) struct Scratch {
    folder: PathBuf,
    /// Held as long as the folder is in use. The kernel releases it when this process ends.
    _lock: File,
}

impl Scratch {
    fn new() -> Result<Scratch> {
        static NEXT: AtomicU32 = AtomicU32::new(0);
        let parent = std::env::temp_dir();
        Scratch::remove_left_behind(&parent);
        let number = NEXT.fetch_add(1, Ordering::Relaxed);
        let name = format!("{SCRATCH}{}-{number}", std::process::id());
        // Under this name, nobody removes the folder before it is locked.
        let (new, folder) = (parent.join(format!(".{name}")), parent.join(name));
        let make = || -> io::Result<File> {
            let _absent = fs::remove_dir_all(&new);
            DirBuilder::new().mode(0o711).create(&new)?;
            fs::set_permissions(&new, Permissions::from_mode(0o711))?;
            let lock = private_file(&new.join(LOCK))?;
            lock.lock()?;
            fs::rename(&new, &folder)?;
            Ok(lock)
        };
        let _lock = make().or_fail(&Error::environment(
            format!("cannot make {}", folder.display()),
            "remove it, or set TMPDIR to another folder",
        ))?;
        Ok(Scratch { folder, _lock })
    }

    /// Removes the folders of processes that were killed. They may hold answers that later code,
    /// which gets the same user id, could read. A folder without a lock is somebody else's.
    pub(super) fn remove_left_behind(parent: &Path) {
        for entry in fs::read_dir(parent).into_iter().flatten().flatten() {
            let is_scratch = entry.file_name().to_string_lossy().starts_with(SCRATCH);
            let is_own = || {
                entry
                    .metadata()
                    .is_ok_and(|it| it.is_dir() && it.uid() == 0)
            };
            // Open it only in a folder of ours. Elsewhere it could be a FIFO, which never opens.
            let is_free = || {
                let lock = File::open(entry.path().join(LOCK));
                lock.is_ok_and(|lock| lock.try_lock().is_ok())
            };
            if is_scratch && is_own() && is_free() {
                let _tried_again_next_time = fs::remove_dir_all(entry.path());
            }
        }
    }
}

/// How the names of scratch folders begin.
const SCRATCH: &str = "pinhole-container-";

/// The file whose lock shows that a scratch folder is in use.
const LOCK: &str = ".lock";

impl Drop for Scratch {
    fn drop(&mut self) {
        let _left_in_the_container = fs::remove_dir_all(&self.folder);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_scratch_folders_of_processes_that_have_ended_are_removed() {
        let parent = tempfile::tempdir().expect("there is room");
        let folders = ["used", "left", "other"];
        let folders = folders.map(|name| parent.path().join(format!("{SCRATCH}{name}")));
        for folder in &folders {
            fs::create_dir(folder).expect("there is room");
        }
        let [used, left, other] = &folders;
        let [held, _left] =
            [used, left].map(|folder| File::create(folder.join(LOCK)).expect("there is room"));
        held.lock().expect("nobody else has it");
        // Nobody writes to this FIFO, so opening it would take for ever.
        let foreign = parent.path().join("foreign");
        fs::create_dir(&foreign).expect("there is room");
        let mkfifo = Command::new("mkfifo").arg(foreign.join(LOCK)).status();
        assert!(mkfifo.expect("it is installed").success());
        Scratch::remove_left_behind(parent.path());
        // Only root has scratch folders.
        let is_root = rustix::process::getuid().is_root();
        assert_eq!((used.exists(), left.exists()), (true, !is_root));
        assert!(other.exists(), "a folder without a lock was removed");
    }
}
