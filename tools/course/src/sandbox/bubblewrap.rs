//! The sandbox that bubblewrap makes from Linux namespaces. Files that are not bound inside don't
//! exist there.

use std::os::unix::fs::chown;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::Duration;
use std::{fs, io};

use super::Limits;
use super::budget::Budget;
use super::confine;
use super::host_paths::HostPaths;
use super::syscalls::Purpose;
use super::toolchain::{libraries, library_names, linker};
use super::user_id::UserId;
use crate::checkout::Checkout;
use crate::error::Result;
use crate::private::is_irreplaceable;
use crate::rust_tool::programs;

/// What is needed to make the sandbox.
#[derive(Clone, Debug)]
pub struct Bubblewrap {
    /// Bubblewrap's absolute path. If we started it by name with another `PATH`, the standard
    /// library would use `fork`, which copies our page tables. That took a third of the time of
    /// grading.
    bwrap: PathBuf,
    /// The toolchain, which is bound read-only.
    sysroot: PathBuf,
    /// This program. Inside, it confines the code further.
    pinhole: PathBuf,
    /// The user that the code runs as if we are root. Otherwise, the code runs as our own user,
    /// which has another number inside.
    uid: Option<UserId>,
    /// The files of `/usr` that a program that answers can see, each with its name inside. If it
    /// could look for other files, it could leave messages in the kernel's cache of names.
    libraries: Vec<(PathBuf, PathBuf)>,
    /// Paths that the code's author must not see.
    pub host_paths: HostPaths,
    /// What the submission may still take.
    pub budget: Budget,
}

/// Where bubblewrap usually is. This folder is the system's, even where a user namespace shows
/// another owner.
const USUAL: &str = "/usr/bin/bwrap";

/// The path of this program inside.
const PINHOLE_INSIDE: &str = "/pinhole";

/// More processes than any user can own, so this limit never applies.
const UNCOUNTED: u64 = 1 << 20;

/// What to do if bubblewrap does not work here.
pub fn remedy() -> &'static str {
    match find().is_ok() && are_user_namespaces_restricted() {
        true => {
            "AppArmor keeps bubblewrap from creating user namespaces: run `sudo sysctl \
             kernel.apparmor_restrict_unprivileged_userns=0`, or give bwrap a profile that \
             allows `userns`"
        }
        false => {
            "install it (Debian: apt-get install bubblewrap); in a container that is used once, \
             pass --sandbox container; or pass --trust if the code is your own"
        }
    }
}

/// Ubuntu 24.04 and later allow user namespaces only to programs with an AppArmor profile.
fn are_user_namespaces_restricted() -> bool {
    let setting = "/proc/sys/kernel/apparmor_restrict_unprivileged_userns";
    fs::read_to_string(setting).is_ok_and(|text| text.trim() == "1")
}

/// The first bubblewrap in `PATH` that no other user can replace, or else the usual one.
fn find() -> io::Result<PathBuf> {
    safest(programs("bwrap").chain([USUAL.into()]).collect())
}

fn safest(programs: Vec<PathBuf>) -> io::Result<PathBuf> {
    let mut found = programs.into_iter().filter(|it| it.is_file()).peekable();
    let first = found.peek().cloned();
    // What was checked is what is started, and not a link to it.
    let safe = |program: PathBuf| {
        let program = program.canonicalize().ok()?;
        let is_safe = program == Path::new(USUAL) || is_irreplaceable(&program);
        is_safe.then_some(program)
    };
    found.find_map(safe).ok_or_else(|| {
        io::Error::other(match first {
            Some(first) => format!("other users can replace {}", first.display()),
            None => format!("there is no bwrap in PATH, and no {USUAL}"),
        })
    })
}

impl Bubblewrap {
    /// Checks that bubblewrap works here. If not, returns its message.
    pub fn new(checkout: &Checkout, sysroot: PathBuf) -> io::Result<Bubblewrap> {
        let bwrap = find()?;
        let is_root = rustix::process::getuid().is_root();
        let uid = is_root.then(UserId::reserve).transpose();
        let walls = Bubblewrap {
            bwrap,
            host_paths: HostPaths::new(checkout, &sysroot, None),
            sysroot,
            libraries: library_names(),
            pinhole: std::env::current_exe()?,
            uid: uid.map_err(|error| io::Error::other(error.problem))?,
            budget: Budget::default(),
        };
        walls.self_test()?;
        // Without this, files that the user's shell has open would be open inside too.
        close_fds::set_fds_cloexec(3, &[]);
        Ok(walls)
    }

    /// See [`Sandbox::new_instance`](super::Sandbox::new_instance).
    pub fn new_instance(&self, whole: Duration) -> Result<Bubblewrap> {
        Ok(Bubblewrap {
            uid: self.uid.as_ref().map(|_| UserId::reserve()).transpose()?,
            budget: Budget::of(whole),
            ..self.clone()
        })
    }

    fn uid(&self) -> Option<u32> {
        self.uid.as_ref().map(UserId::number)
    }

    /// The folders of the system that the code may read.
    pub fn visible(&self) -> [&Path; 2] {
        [Path::new("/usr"), &self.sysroot]
    }

    /// The toolchain.
    pub fn sysroot(&self) -> &Path {
        &self.sysroot
    }

    /// Checks that a program can run inside.
    pub fn self_test(&self) -> io::Result<()> {
        let limits = Limits::of_compiler();
        let mut command = self.bare(Purpose::Answer);
        let program = "/usr/bin/true";
        bind(&mut command, "--ro-bind", Path::new(program));
        self.confine(&mut command, &limits, Purpose::Answer);
        command.args(["--read", program, "--", program]);
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
        let mut command = self.bare(Purpose::Compile);
        // rustc and its linker find their own files through the link /proc/self/exe. Landlock
        // keeps them from reading anything else there.
        command.args(["--proc", "/proc"]);
        // This must come before mounts that may lie in it.
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

    /// A built program, ready to be asked. It gets no `/proc`, where safe Rust could write to its
    /// own memory.
    pub fn runner(&self, executable: &Path, limits: &Limits) -> Command {
        let mut command = self.bare(Purpose::Answer);
        command.arg("--ro-bind").arg(executable).arg(PROGRAM_INSIDE);
        self.confine(&mut command, limits, Purpose::Answer);
        command.args(["--read", PROGRAM_INSIDE, "--", PROGRAM_INSIDE]);
        command
    }

    /// Bubblewrap with the arguments that every program needs. Callers add more.
    fn bare(&self, purpose: Purpose) -> Command {
        let mut command = Command::new(&self.bwrap);
        command.env_clear();
        let own = match self.uid {
            // Root may bind folders that other users cannot reach, such as a toolchain in its
            // home; the code becomes another user inside. With bubblewrap's own mapping, the code
            // would still be root outside, and the kernel doesn't count root's processes.
            Some(_) => "--cap-add CAP_SETUID --cap-add CAP_SETGID",
            None => "--unshare-user --disable-userns --uid 1000 --gid 1000",
        };
        let fixed = "--unshare-ipc --unshare-pid --unshare-net --unshare-uts \
             --unshare-cgroup-try --hostname submission --die-with-parent --new-session \
             --cap-drop ALL";
        let files = "--symlink usr/lib /lib --symlink usr/lib64 /lib64 --symlink usr/bin /bin \
             --dev /dev --remount-ro /dev";
        command.args(fixed.split_whitespace());
        command.args(own.split_whitespace());
        match purpose {
            Purpose::Compile => bind(&mut command, "--ro-bind", Path::new("/usr")),
            Purpose::Answer => {
                for (file, name) in &self.libraries {
                    bind_as(&mut command, "--ro-bind", file, name);
                }
            }
        }
        command.args(files.split_whitespace());
        command
            .arg("--ro-bind")
            .arg(&self.pinhole)
            .arg(PINHOLE_INSIDE);
        command
    }

    /// Makes the file system read-only and confines the program, whose command line must follow.
    fn confine(&self, command: &mut Command, limits: &Limits, purpose: Purpose) {
        command.args(["--remount-ro", "/", "--", PINHOLE_INSIDE]);
        let mut limits = *limits;
        if self.uid.is_none() && !counts_by_namespace() {
            limits.processes = UNCOUNTED;
        }
        confine::arguments(command, &limits, purpose, self.uid());
        let system = match purpose {
            Purpose::Compile => vec!["/usr".into()],
            Purpose::Answer => libraries(),
        };
        for read in system {
            command.arg("--read").arg(read);
        }
        command.args(["--write", "/dev/null"]);
    }
}

/// The path of a built program inside.
const PROGRAM_INSIDE: &str = "/submission";

/// Since Linux 5.14, a namespace's processes are counted separately from the user's processes
/// outside, which may already exceed the limit.
fn counts_by_namespace() -> bool {
    let release = std::fs::read_to_string("/proc/sys/kernel/osrelease").unwrap_or_default();
    let mut numbers = release
        .split(['.', '-'])
        .map_while(|part| part.parse().ok());
    (numbers.next(), numbers.next()) >= (Some(5), Some(14_u32))
}

fn bind(command: &mut Command, how: &str, path: &Path) {
    bind_as(command, how, path, path);
}

fn bind_as(command: &mut Command, how: &str, path: &Path, inside: &Path) {
    // Without this, bubblewrap would make parent folders that only root may enter. It leaves
    // existing folders alone.
    let above: Vec<&Path> = inside.ancestors().skip(1).collect();
    for folder in above.into_iter().rev() {
        command.args(["--perms", "0755", "--dir"]).arg(folder);
    }
    command.arg(how).arg(path).arg(inside);
}

#[cfg(test)]
#[test]
fn a_bubblewrap_that_other_users_can_replace_is_not_started() {
    use crate::private::allow;
    let [ours, open] = [(); 2].map(|()| tempfile::tempdir().unwrap());
    let program = |folder: &tempfile::TempDir| {
        let program = folder.path().join("bwrap");
        fs::write(&program, "").unwrap();
        program
    };
    let (own, other) = (program(&ours), program(&open));
    allow(open.path(), 0o777).unwrap();
    let real = own.canonicalize().unwrap();
    assert_eq!(safest(vec![other.clone(), own.clone()]).unwrap(), real);
    // What is started is what was checked, and not a link to it.
    fs::remove_file(&other).unwrap();
    std::os::unix::fs::symlink(&own, &other).unwrap();
    assert_eq!(safest(vec![other.clone()]).unwrap(), real);
    allow(ours.path(), 0o777).unwrap();
    let refused = safest(vec![other]).unwrap_err().to_string();
    assert!(refused.contains("other users can replace"), "{refused}");
}
