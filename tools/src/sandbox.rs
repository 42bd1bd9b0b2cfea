//! Where a submission is compiled and run: in the open if its user trusts it, or
//! walled off by bubblewrap.
//!
//! Inside the walls there are a read-only system, the compiler, the harness library
//! and the submission's own files: no golden, no other submission, no home, no
//! network, no environment. Only the compiler may write, into one folder.

use std::path::{Path, PathBuf};
use std::process::Command;

use crate::checkout::Checkout;
use crate::error::{Error, Result};

/// How a submission's processes are started.
#[derive(Clone, Debug)]
pub enum Sandbox {
    /// Like any program of the user's: for code that lies in the checkout.
    Trusted,
    /// In namespaces of their own.
    Bubblewrap {
        /// The toolchain, bound read-only.
        sysroot: PathBuf,
    },
}

/// Address space of one process: 1 GiB is enough for rustc, half of it is not.
const MEMORY: u64 = 2 << 30;

/// No file a submission writes may be longer, its executable included.
const FILE_SIZE: u64 = 64 << 20;

/// Seconds of processor time for the compiler.
const COMPILE_SECONDS: u64 = 60;

/// Seconds after which a compiler that waits for something is stopped.
const COMPILE_WALL_SECONDS: u64 = 90;

impl Sandbox {
    /// None for a folder of the checkout or with `trust`; bubblewrap otherwise.
    pub fn around(folder: &Path, checkout: &Checkout, trust: bool) -> Result<Sandbox> {
        if trust || checkout.contains(folder) {
            return Ok(Sandbox::Trusted);
        }
        let works = Command::new("bwrap")
            .args(["--unshare-all", "--ro-bind", "/", "/", "true"])
            .output();
        if !works.is_ok_and(|output| output.status.success()) {
            return Err(Error::environment(
                format!(
                    "{} lies outside this checkout, so its code must run in a sandbox, and \
                     bubblewrap does not work here",
                    folder.display()
                ),
                "install it (Debian: apt-get install bubblewrap), or pass --trust if the code is \
                 your own",
            ));
        }
        // What the user's shell has open would be open inside as well.
        #[cfg(target_os = "linux")]
        close_fds::set_fds_cloexec(3, &[]);
        Ok(Sandbox::Bubblewrap {
            sysroot: sysroot()?,
        })
    }

    /// A compiler that runs in `folder`, reads its `src` and the harness, and writes
    /// only to `out`.
    pub fn compiler(&self, folder: &Path, out: &Path, harness: &Path) -> Result<Command> {
        match self {
            Sandbox::Trusted => {
                let mut rustc = Command::new(std::env::var_os("RUSTC").unwrap_or("rustc".into()));
                rustc.current_dir(folder);
                Ok(rustc)
            }
            Sandbox::Bubblewrap { sysroot } => {
                let mut walled = limited(COMPILE_SECONDS, COMPILE_WALL_SECONDS);
                walled.args(walls()).args(["--setenv", "PATH", "/usr/bin"]);
                bind(&mut walled, "--ro-bind", sysroot);
                bind(&mut walled, "--ro-bind", harness);
                bind(&mut walled, "--ro-bind", &folder.join("src"));
                bind(&mut walled, "--bind", out);
                walled.arg("--chdir").arg(folder);
                walled.args(["--remount-ro", "/"]);
                walled.arg("--").arg(sysroot.join("bin").join("rustc"));
                // Plain `cc` would go through /etc, which is not there.
                walled.arg("-Clinker=gcc");
                Ok(walled)
            }
        }
    }

    /// A built program, allowed `seconds` of processor time.
    pub fn runner(&self, executable: &Path, seconds: u64) -> Command {
        match self {
            Sandbox::Trusted => Command::new(executable),
            Sandbox::Bubblewrap { .. } => {
                // The asker looks at the clock; this is for a child that outlives it.
                let mut walled = limited(seconds, seconds);
                walled.args(walls());
                bind(&mut walled, "--ro-bind", executable);
                walled.args(["--remount-ro", "/", "--"]).arg(executable);
                walled
            }
        }
    }
}

/// `timeout` and `prlimit` with bounds that every process inside inherits, then bubblewrap.
fn limited(seconds: u64, wall: u64) -> Command {
    let mut command = Command::new("timeout");
    command.env_clear().env("PATH", "/usr/bin:/bin");
    command.args([
        "--signal=KILL",
        "--foreground",
        &wall.to_string(),
        "prlimit",
    ]);
    command.args([
        format!("--cpu={seconds}"),
        format!("--as={MEMORY}"),
        format!("--fsize={FILE_SIZE}"),
    ]);
    command.args(["--core=0", "--nofile=256", "--", "bwrap"]);
    command
}

fn walls() -> impl Iterator<Item = &'static str> {
    let fixed = "--unshare-all --unshare-user --disable-userns --uid 1000 --gid 1000 \
         --die-with-parent --new-session --clearenv --cap-drop ALL \
         --ro-bind /usr /usr --symlink usr/lib /lib --symlink usr/lib64 /lib64 \
         --symlink usr/bin /bin --proc /proc --dev /dev --size 16777216 --tmpfs /tmp \
         --remount-ro /dev";
    fixed.split_whitespace()
}

fn bind(command: &mut Command, how: &str, path: &Path) {
    command.arg(how).arg(path).arg(path);
}

fn sysroot() -> Result<PathBuf> {
    let output = Command::new("rustc").args(["--print", "sysroot"]).output();
    match output {
        Ok(output) if output.status.success() => Ok(PathBuf::from(
            String::from_utf8_lossy(&output.stdout).trim(),
        )),
        _ => Err(Error::environment(
            "cannot ask rustc where it lives",
            "install Rust from rustup.rs",
        )),
    }
}
