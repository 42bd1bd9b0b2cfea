//! The sandbox made by bubblewrap from Linux namespaces: files that are not bound
//! inside don't exist there.

use std::io;
use std::os::unix::fs::chown;
use std::path::{Path, PathBuf};
use std::process::Command;

use super::Limits;
use super::budget::Budget;
use super::confine;
use super::host_paths::HostPaths;
use super::syscalls::Purpose;
use super::toolchain::{linker, sysroot};
use super::user_id::UserId;
use crate::checkout::Checkout;
use crate::error::Result;

/// What is needed to make the sandbox.
#[derive(Clone, Debug)]
pub struct Bubblewrap {
    /// The toolchain, bound read-only.
    sysroot: PathBuf,
    /// This program, which confines the code further once it is inside.
    pinhole: PathBuf,
    /// The user that the code runs as if we are root. Otherwise the code runs as our
    /// own user, under another number.
    uid: Option<UserId>,
    /// What is not shown to the code's author.
    pub host_paths: HostPaths,
    /// The limits run into so far.
    pub budget: Budget,
}

/// Bubblewrap's absolute path. A search in `PATH` could find a program in a folder that a user
/// may write to. Also, if we start a program by name with another `PATH` than ours, the
/// standard library uses `fork`, which copies our page tables for every start: that took a
/// third of the time of grading.
const BWRAP: &str = "/usr/bin/bwrap";

/// Where this program lies inside.
const PINHOLE_INSIDE: &str = "/pinhole";

/// More processes than one user can own, so that this limit never applies.
const UNCOUNTED: u64 = 1 << 20;

impl Bubblewrap {
    /// Tries whether bubblewrap works here; if not, returns its message.
    pub fn new(checkout: &Checkout) -> io::Result<Bubblewrap> {
        let is_root = rustix::process::getuid().is_root();
        let uid = is_root.then(UserId::reserve).transpose();
        let sysroot = sysroot(checkout).map_err(|error| io::Error::other(error.problem))?;
        let walls = Bubblewrap {
            host_paths: HostPaths::new(checkout, &sysroot, None),
            sysroot,
            pinhole: std::env::current_exe()?,
            uid: uid.map_err(|error| io::Error::other(error.problem))?,
            budget: Budget::default(),
        };
        walls.self_test()?;
        // Otherwise, files that the user's shell has open would be open inside as well.
        close_fds::set_fds_cloexec(3, &[]);
        Ok(walls)
    }

    /// See [`Sandbox::new_instance`](super::Sandbox::new_instance).
    pub fn new_instance(&self) -> Result<Bubblewrap> {
        Ok(Bubblewrap {
            uid: self.uid.as_ref().map(|_| UserId::reserve()).transpose()?,
            budget: Budget::default(),
            ..self.clone()
        })
    }

    fn uid(&self) -> Option<u32> {
        self.uid.as_ref().map(UserId::number)
    }

    /// What of the system the code may read, wherever it lies.
    pub fn visible(&self) -> [&Path; 2] {
        [Path::new("/usr"), &self.sysroot]
    }

    /// The toolchain.
    pub fn sysroot(&self) -> &Path {
        &self.sysroot
    }

    /// Whether a program can be run inside.
    pub fn self_test(&self) -> io::Result<()> {
        let limits = Limits::of_compiler();
        let mut command = self.walled(&limits, Purpose::Answer);
        command.args(["--", "/usr/bin/true"]);
        let output = command.output()?;
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
        if let Some(uid) = self.uid() {
            chown(&out, Some(uid), Some(uid))?;
        }
        let mut command = self.bare();
        // rustc and its linker find their own files by the link /proc/self/exe. Landlock keeps
        // them from reading anything there.
        command.args(["--proc", "/proc"]);
        // Before what may lie in it.
        command.args(["--size", "67108864", "--perms", "1777", "--tmpfs", "/tmp"]);
        bind(&mut command, "--ro-bind", &self.sysroot);
        bind(&mut command, "--ro-bind", harness);
        bind(&mut command, "--ro-bind", &folder.join("src"));
        bind(&mut command, "--bind", &out);
        command.args(["--setenv", "PATH", "/usr/bin"]);
        command.arg("--chdir").arg(folder);
        self.confine(&mut command, limits, Purpose::Compile);
        for read in [&self.sysroot, harness, folder] {
            command.arg("--read").arg(read);
        }
        command.arg("--write").arg(&out).args(["--write", "/tmp"]);
        command
            .arg("--")
            .arg(self.sysroot.join("bin").join("rustc"));
        command.args(linker(&self.sysroot));
        Ok(command)
    }

    /// A built program, to be asked. There is no `/proc`: with it, safe Rust could write to
    /// its own memory.
    pub fn runner(&self, executable: &Path, limits: &Limits) -> Command {
        let mut command = self.bare();
        command.arg("--ro-bind").arg(executable).arg(PROGRAM_INSIDE);
        self.confine(&mut command, limits, Purpose::Answer);
        command.args(["--read", PROGRAM_INSIDE, "--", PROGRAM_INSIDE]);
        command
    }

    fn walled(&self, limits: &Limits, purpose: Purpose) -> Command {
        let mut command = self.bare();
        self.confine(&mut command, limits, purpose);
        command
    }

    /// Bubblewrap with the arguments that every program needs. Callers add more.
    fn bare(&self) -> Command {
        let mut command = Command::new(BWRAP);
        command.env_clear();
        let own = match self.uid {
            // Root may bind what others cannot reach, a toolchain in its home, say; the
            // code becomes another user inside. Bubblewrap's own mapping would leave it
            // root outside, for whom processes are not counted.
            Some(_) => "--cap-add CAP_SETUID --cap-add CAP_SETGID",
            None => "--unshare-user --disable-userns --uid 1000 --gid 1000",
        };
        let fixed = "--unshare-ipc --unshare-pid --unshare-net --unshare-uts \
             --unshare-cgroup-try --hostname submission --die-with-parent --new-session \
             --clearenv --cap-drop ALL";
        let files = "--ro-bind /usr /usr --symlink usr/lib /lib --symlink usr/lib64 /lib64 \
             --symlink usr/bin /bin --dev /dev --remount-ro /dev";
        command.args(fixed.split_whitespace());
        command.args(own.split_whitespace());
        command.args(files.split_whitespace());
        command
            .arg("--ro-bind")
            .arg(&self.pinhole)
            .arg(PINHOLE_INSIDE);
        command
    }

    /// Makes the file system read-only and confines the program, whose command line is
    /// to follow.
    fn confine(&self, command: &mut Command, limits: &Limits, purpose: Purpose) {
        command.args(["--remount-ro", "/", "--", PINHOLE_INSIDE]);
        let mut limits = *limits;
        if self.uid.is_none() && !counts_by_namespace() {
            limits.processes = UNCOUNTED;
        }
        confine::arguments(command, &limits, purpose, self.uid());
        for read in ["/usr", "/dev"] {
            command.args(["--read", read]);
        }
        command.args(["--write", "/dev/null"]);
    }
}

/// Where a built program lies inside.
const PROGRAM_INSIDE: &str = "/submission";

/// Since Linux 5.14 a namespace's processes are counted apart from those their user has
/// outside, which may be more than the limit already.
fn counts_by_namespace() -> bool {
    let release = std::fs::read_to_string("/proc/sys/kernel/osrelease").unwrap_or_default();
    let mut numbers = release
        .split(['.', '-'])
        .map_while(|part| part.parse().ok());
    (numbers.next(), numbers.next()) >= (Some(5), Some(14_u32))
}

fn bind(command: &mut Command, how: &str, path: &Path) {
    // By itself, bubblewrap would make parent folders that only root may enter.
    let mut above: Vec<&Path> = path.ancestors().skip(1).collect();
    above.retain(|folder| !folder.starts_with("/usr") && folder.parent().is_some());
    for folder in above
        .into_iter()
        .rev()
        .filter(|folder| *folder != Path::new("/tmp"))
    {
        command.args(["--perms", "0755", "--dir"]).arg(folder);
    }
    command.arg(how).arg(path).arg(path);
}
