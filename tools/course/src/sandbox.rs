//! Where a submission is compiled and run: in the open if its user trusts it, or
//! walled off.
//!
//! Inside the walls there are a read-only system, the compiler, the harness library
//! and the submission's own files: no golden, no other submission, no home, no
//! network, no environment. Only the compiler may write, into one folder. Whatever
//! runs there is bounded by [`Limits`], as one tree, and gone when its job is.

mod budget;
mod finish;
mod limits;

#[cfg(target_os = "linux")]
mod bubblewrap;
#[cfg(target_os = "linux")]
mod confine;
#[cfg(target_os = "linux")]
mod container;
#[cfg(target_os = "linux")]
mod syscalls;
#[cfg(target_os = "linux")]
mod toolchain;
#[cfg(target_os = "linux")]
mod tree;
mod watch;

use std::io;
use std::path::{Path, PathBuf};
use std::process::Command;

use clap::ValueEnum;
use pinhole::ask::{Death, Ending, Limit, Reply, Stop, ask_watched};
use pinhole::job::Job;

use crate::checkout::Checkout;
#[cfg(not(target_os = "linux"))]
use crate::error::Error;
use crate::error::Result;
#[cfg(target_os = "linux")]
use crate::error::ResultExt;
pub use finish::{Finished, finish};
pub use limits::Limits;
use watch::{Exceeded, Watch};

/// Becomes a confined program if this process was started to be one: both sandboxes start
/// the current program anew, as `confine`, inside their walls. Every binary calls this
/// before anything else. Returns only if it was not, or that failed.
pub fn become_confined() -> Option<std::process::ExitCode> {
    #[cfg(target_os = "linux")]
    return confine::become_confined();
    #[cfg(not(target_os = "linux"))]
    None
}

/// Processor time of all processes that this one has started and seen end, where the
/// system tells.
pub fn time_of_children() -> Option<std::time::Duration> {
    #[cfg(target_os = "linux")]
    return tree::time_of_children();
    #[cfg(not(target_os = "linux"))]
    None
}

/// What a user asks for.
#[derive(Clone, Copy, Debug, Default, PartialEq, ValueEnum)]
pub enum Choice {
    /// No sandbox for a folder of this checkout, bubblewrap for any other
    #[default]
    Auto,
    /// Linux namespaces, made by bubblewrap
    Bubblewrap,
    /// Another user id and Landlock; for root, in a container that is used once
    Container,
    /// No sandbox; only for your own code
    None,
}

/// How a submission's processes are started.
#[derive(Clone, Debug)]
pub enum Sandbox {
    /// Like any program of the user's: for code that lies in the checkout.
    Trusted,
    /// In namespaces of their own.
    #[cfg(target_os = "linux")]
    Bubblewrap(bubblewrap::Bubblewrap),
    /// As another user, for containers that are used once.
    #[cfg(target_os = "linux")]
    Container(container::Container),
}

impl Sandbox {
    /// The walls a user has chosen for the code in `folder`. `secrets` are folders that
    /// the code must not read, beside the goldens and answers of the checkout.
    ///
    /// # Errors
    /// If there can be no such walls here: code is never run without them instead.
    pub fn around(
        folder: &Path,
        checkout: &Checkout,
        choice: Choice,
        secrets: &[PathBuf],
    ) -> Result<Sandbox> {
        match choice {
            Choice::Auto if checkout.contains(folder) => Ok(Sandbox::Trusted),
            _ => Sandbox::for_untrusted(&folder.display().to_string(), checkout, choice, secrets),
        }
    }

    /// A sandbox for untrusted code, wherever it lies; `what` names the code in errors.
    ///
    /// # Errors
    /// See [`Sandbox::around`].
    pub fn for_untrusted(
        what: &str,
        checkout: &Checkout,
        choice: Choice,
        secrets: &[PathBuf],
    ) -> Result<Sandbox> {
        match choice {
            Choice::None => Ok(Sandbox::Trusted),
            Choice::Auto | Choice::Bubblewrap => Sandbox::bubblewrap(checkout, what),
            Choice::Container => Sandbox::container(checkout, secrets),
        }
    }

    /// A new sandbox of the same kind for another submission. It has another user id, so that
    /// neither can signal or starve the other, and a time budget of its own.
    pub fn new_instance(&self) -> Sandbox {
        match self {
            Sandbox::Trusted => Sandbox::Trusted,
            #[cfg(target_os = "linux")]
            Sandbox::Bubblewrap(walls) => Sandbox::Bubblewrap(walls.new_instance()),
            #[cfg(target_os = "linux")]
            Sandbox::Container(walls) => Sandbox::Container(walls.new_instance()),
        }
    }

    #[cfg(target_os = "linux")]
    fn bubblewrap(checkout: &Checkout, what: &str) -> Result<Sandbox> {
        let walls = bubblewrap::Bubblewrap::new(checkout).or_environment(
            format_args!("{what} must run in a sandbox, and bubblewrap does not work here"),
            "install it (Debian: apt-get install bubblewrap); in a container that is used once, \
             pass --sandbox container; or pass --trust if the code is your own",
        )?;
        Ok(Sandbox::Bubblewrap(walls))
    }

    #[cfg(target_os = "linux")]
    fn container(checkout: &Checkout, secrets: &[PathBuf]) -> Result<Sandbox> {
        container::Container::new(checkout, secrets).map(Sandbox::Container)
    }

    #[cfg(not(target_os = "linux"))]
    fn bubblewrap(_: &Checkout, what: &str) -> Result<Sandbox> {
        Err(Error::environment(
            format!("{what} must run in a sandbox, and there is none for this system"),
            "use a Linux machine, or pass --trust if the code is your own",
        ))
    }

    #[cfg(not(target_os = "linux"))]
    fn container(checkout: &Checkout, _: &[PathBuf]) -> Result<Sandbox> {
        Sandbox::bubblewrap(checkout, "the code")
    }

    /// Which walls these are, for results.
    pub fn name(&self) -> &'static str {
        match self {
            Sandbox::Trusted => "none",
            #[cfg(target_os = "linux")]
            Sandbox::Bubblewrap(_) => "bubblewrap",
            #[cfg(target_os = "linux")]
            Sandbox::Container(walls) => walls.name(),
        }
    }

    /// What a finished program depends on beside its sources: one that was compiled
    /// where more could be read must not pass for another.
    pub fn fingerprint(&self) -> String {
        match self {
            Sandbox::Trusted => "none".into(),
            #[cfg(target_os = "linux")]
            Sandbox::Bubblewrap(walls) => format!("bubblewrap {}", walls.sysroot().display()),
            // Its file belongs to one user id.
            #[cfg(target_os = "linux")]
            Sandbox::Container(walls) => format!("container {}", walls.uid()),
        }
    }

    /// A compiler that runs in `folder`, reads its `src` and the harness, and writes
    /// only to its `out`.
    ///
    /// # Errors
    /// If the folder cannot be handed over to the user id that compiles.
    // Only Linux has walls, which want to know more.
    #[cfg_attr(not(target_os = "linux"), expect(unused_variables))]
    pub fn compiler(&self, folder: &Path, harness: &Path, limits: &Limits) -> io::Result<Command> {
        match self {
            Sandbox::Trusted => {
                let mut rustc = Command::new(std::env::var_os("RUSTC").unwrap_or("rustc".into()));
                rustc.current_dir(folder);
                Ok(rustc)
            }
            #[cfg(target_os = "linux")]
            Sandbox::Bubblewrap(walls) => walls.compiler(folder, harness, limits),
            #[cfg(target_os = "linux")]
            Sandbox::Container(walls) => walls.compiler(folder, harness, limits),
        }
    }

    /// Runs a command of [`compiler`](Sandbox::compiler) to its end.
    pub fn compile(&self, compiler: Command, limits: &Limits) -> io::Result<Finished> {
        let finished = finish(compiler, limits, |pid| self.watch(pid, limits));
        self.sweep();
        finished
    }

    /// Asks a built program. What its code does wrong is in the reply.
    ///
    /// # Errors
    /// If it could not be started, or the walls could not be drawn.
    pub fn ask(
        &self,
        executable: &Path,
        job: &Job,
        limits: &Limits,
        stop: Stop,
        progress: &mut dyn FnMut(usize),
    ) -> io::Result<Reply> {
        let limits = self.within_budget(limits);
        let command = match self {
            Sandbox::Trusted => Command::new(executable),
            #[cfg(target_os = "linux")]
            Sandbox::Bubblewrap(walls) => walls.runner(executable, &limits),
            #[cfg(target_os = "linux")]
            Sandbox::Container(walls) => walls.runner(executable, &limits),
        };
        let mut watch = None;
        let limit = Limit {
            wall: limits.wall,
            silence: limits.silence,
            stop,
        };
        let asked = ask_watched(command, job, limit, progress, &mut |pid| {
            watch = Some(self.watch(pid, &limits));
        });
        let exceeded = watch.and_then(Watch::stop);
        self.sweep();
        let mut reply = asked?;
        if let Ending::Died(death) = &reply.ending {
            match exceeded {
                Some(Exceeded::Cpu(most)) => reply.ending = Ending::TimedOut(most),
                Some(Exceeded::Memory(most)) => reply.ending = Ending::OutOfMemory(most),
                // The kernel's own limit, where a busy machine looks too seldom.
                None if *death == Death::OutOfProcessorTime => {
                    reply.ending = Ending::TimedOut(limits.cpu);
                }
                // Rust itself prints this; otherwise the process ends like any other that aborts.
                None if reply.printed.contains("memory allocation of ") => {
                    reply.ending = Ending::OutOfMemory(limits.memory);
                }
                // Perhaps it was never started.
                None => self.self_test()?,
            }
        }
        if let Ending::TimedOut(lost) = reply.ending {
            self.charge(lost);
        }
        Ok(reply)
    }

    #[cfg_attr(not(target_os = "linux"), expect(unused_variables))]
    fn watch(&self, pid: u32, limits: &Limits) -> Watch {
        match self {
            Sandbox::Trusted => Watch::nothing(),
            #[cfg(target_os = "linux")]
            _ => Watch::tree(pid, *limits),
        }
    }

    /// Ends what was left behind where no namespace of processes ends with its first.
    fn sweep(&self) {
        #[cfg(target_os = "linux")]
        if let Sandbox::Container(walls) = self {
            tree::end_all_of(walls.uid());
        }
    }

    /// Whether the walls can still be drawn, so that no fault of the machine passes for
    /// a student's.
    fn self_test(&self) -> io::Result<()> {
        match self {
            Sandbox::Trusted => Ok(()),
            #[cfg(target_os = "linux")]
            Sandbox::Bubblewrap(walls) => walls.self_test(),
            #[cfg(target_os = "linux")]
            Sandbox::Container(walls) => walls.self_test(),
        }
    }

    fn within_budget(&self, limits: &Limits) -> Limits {
        match self {
            Sandbox::Trusted => *limits,
            #[cfg(target_os = "linux")]
            Sandbox::Bubblewrap(walls) => walls.budget.bound(*limits),
            #[cfg(target_os = "linux")]
            Sandbox::Container(walls) => walls.budget.bound(*limits),
        }
    }

    fn charge(&self, _lost: std::time::Duration) {
        match self {
            Sandbox::Trusted => {}
            #[cfg(target_os = "linux")]
            Sandbox::Bubblewrap(walls) => walls.budget.charge(_lost),
            #[cfg(target_os = "linux")]
            Sandbox::Container(walls) => walls.budget.charge(_lost),
        }
    }
}
