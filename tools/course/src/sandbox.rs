//! Where a submission is compiled and run: in a sandbox, or unprotected if its user trusts it.
//!
//! The sandbox shows a read-only system, the compiler, the harness library and the submission's
//! own files. It shows no golden, no other submission, no home, no network and no environment.
//! Only the compiler may write, into one folder. Everything that runs there forms one tree of
//! processes, which is bounded by [`Limits`] and killed when its job ends.

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
mod host_paths;
#[cfg(target_os = "linux")]
mod seal;
#[cfg(target_os = "linux")]
mod secrets;
#[cfg(target_os = "linux")]
mod syscalls;
#[cfg(target_os = "linux")]
mod toolchain;
#[cfg(target_os = "linux")]
mod tree;
#[cfg(target_os = "linux")]
mod user_id;
mod watch;

use std::cell::Cell;
use std::io;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::rc::Rc;
use std::time::{Duration, Instant};

use clap::ValueEnum;
use pinhole::ask::{BUSY, Clock, Ending, Limit, Reply, Stop, ask_watched};
use pinhole::job::Job;

use crate::checkout::Checkout;
#[cfg(not(target_os = "linux"))]
use crate::error::Error;
use crate::error::Result;
#[cfg(target_os = "linux")]
use crate::error::ResultExt;
use crate::rust_tool::rust_tool;
use budget::Budget;
pub use finish::{CommandResult, MOST_SAID, finish};
pub use limits::Limits;
use watch::{ExceededLimit, Watch};

/// The signals by which the kernel ends a process that takes too long. The second comes a second
/// after the first.
const SIGXCPU: i32 = 24;
const SIGKILL: i32 = 9;

/// How often a program is started that ends before it reads its job. If it never reads it, the
/// program itself is to blame, for instance because it is too large to be loaded.
const MOST_STARTS: u32 = 4;

/// Turns this process into a confined program if it was started as one. Both sandboxes start this
/// program again inside, with the argument `confine`, so every binary must call this function
/// first. Returns only if the process was not started this way, or if confining it failed.
pub fn become_confined() -> Option<std::process::ExitCode> {
    #[cfg(target_os = "linux")]
    return confine::become_confined();
    #[cfg(not(target_os = "linux"))]
    None
}

/// A clock that stands still while a process and its descendants are ready to run but get no
/// processor, if the system reports that.
fn own_clock(pid: u32) -> Clock {
    #[cfg(target_os = "linux")]
    return tree::own_clock(pid);
    #[cfg(not(target_os = "linux"))]
    {
        let _nobody_tells = pid;
        pinhole::ask::wall_clock()
    }
}

/// Processor time of all processes that this one has started and seen end, if the system reports
/// it.
pub fn time_of_children() -> Option<Duration> {
    #[cfg(target_os = "linux")]
    return tree::time_of_children();
    #[cfg(not(target_os = "linux"))]
    None
}

/// The sandbox that a user asks for.
#[derive(Clone, Copy, Debug, Default, PartialEq, ValueEnum)]
pub enum Choice {
    /// Bubblewrap for `grade` and for code from outside this repository; otherwise no sandbox
    #[default]
    Auto,
    /// Linux namespaces, made by the program bubblewrap
    Bubblewrap,
    /// A separate user id, and Landlock (a security feature of the Linux kernel); only for root in
    /// a container that is thrown away afterwards
    Container,
    /// Like `container`, but for kernels without Landlock; weaker, because only file permissions
    /// protect the container's files
    ContainerWithoutLandlock,
    /// No sandbox; only for your own code
    None,
}

/// How a submission's processes are started.
#[derive(Clone, Debug)]
pub enum Sandbox {
    /// Like any program that the user starts. This is for code in the checkout.
    Trusted,
    /// In namespaces of their own.
    #[cfg(target_os = "linux")]
    Bubblewrap(bubblewrap::Bubblewrap),
    /// As another user, for containers that are used once.
    #[cfg(target_os = "linux")]
    Container(container::Container),
}

/// Whether the kernel offers Landlock.
pub fn has_landlock() -> bool {
    #[cfg(target_os = "linux")]
    return confine::has_landlock();
    #[cfg(not(target_os = "linux"))]
    false
}

impl Sandbox {
    /// The sandbox that the user has chosen for the code that was read from `folder`, a path without
    /// links. The code must not read the folders of `secrets`, nor the goldens and answers of the
    /// checkout.
    ///
    /// # Errors
    /// If this machine can't provide that sandbox. Code never runs unprotected instead.
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
            Choice::Auto | Choice::Bubblewrap => Sandbox::bubblewrap(checkout, what, secrets),
            Choice::Container => Sandbox::container(checkout, secrets, false),
            Choice::ContainerWithoutLandlock => Sandbox::container(checkout, secrets, true),
        }
    }

    /// A new sandbox of the same kind for another submission. It has another user id, so that
    /// neither can signal or starve the other, and may take `whole` on the clock from now on.
    ///
    /// # Errors
    /// If no user id is left.
    #[cfg_attr(not(target_os = "linux"), expect(unused_variables))]
    pub fn new_instance(&self, whole: Duration) -> Result<Sandbox> {
        Ok(match self {
            Sandbox::Trusted => Sandbox::Trusted,
            #[cfg(target_os = "linux")]
            Sandbox::Bubblewrap(walls) => Sandbox::Bubblewrap(walls.new_instance(whole)?),
            #[cfg(target_os = "linux")]
            Sandbox::Container(walls) => Sandbox::Container(walls.new_instance(whole)?),
        })
    }

    #[cfg(target_os = "linux")]
    fn bubblewrap(checkout: &Checkout, what: &str, secrets: &[PathBuf]) -> Result<Sandbox> {
        let walls = bubblewrap::Bubblewrap::new(checkout, toolchain::sysroot(checkout)?);
        let walls = walls.or_environment(
            format_args!("{what} must run in a sandbox, and bubblewrap does not work here"),
            bubblewrap::remedy(),
        )?;
        secrets::refuse_visible_secrets(&walls.visible(), checkout, secrets)?;
        Ok(Sandbox::Bubblewrap(walls))
    }

    #[cfg(target_os = "linux")]
    fn container(checkout: &Checkout, secrets: &[PathBuf], accepts_modes: bool) -> Result<Sandbox> {
        container::Container::new(checkout, secrets, accepts_modes).map(Sandbox::Container)
    }

    #[cfg(not(target_os = "linux"))]
    fn bubblewrap(_: &Checkout, what: &str, _: &[PathBuf]) -> Result<Sandbox> {
        Err(Error::environment(
            format!("{what} must run in a sandbox, and Pinhole has none for this system"),
            "use a Linux machine, or pass --trust if the code is your own",
        ))
    }

    #[cfg(not(target_os = "linux"))]
    fn container(checkout: &Checkout, secrets: &[PathBuf], _: bool) -> Result<Sandbox> {
        Sandbox::bubblewrap(checkout, "the code", secrets)
    }

    /// The folder for the harness and the programs. If sandboxed code needs this folder, it lies
    /// where the code can reach it.
    pub fn scratch(&self, checkout: &Checkout) -> PathBuf {
        match self {
            #[cfg(target_os = "linux")]
            Sandbox::Container(walls) => walls.scratch().to_owned(),
            _ => checkout.scratch(),
        }
    }

    /// Whether another user of the machine must be able to reach programs and their sources.
    pub fn needs_access(&self) -> bool {
        match self {
            #[cfg(target_os = "linux")]
            Sandbox::Container(_) => true,
            _ => false,
        }
    }

    /// The sandbox's name, for results.
    pub fn name(&self) -> &'static str {
        match self {
            Sandbox::Trusted => "none",
            #[cfg(target_os = "linux")]
            Sandbox::Bubblewrap(_) => "bubblewrap",
            #[cfg(target_os = "linux")]
            Sandbox::Container(walls) => walls.name(),
        }
    }

    /// What a compiled program depends on besides its sources. A program that was compiled where
    /// more files were readable must not be reused in a sandbox that hides them.
    pub fn fingerprint(&self) -> String {
        match self {
            Sandbox::Trusted => "none".into(),
            #[cfg(target_os = "linux")]
            Sandbox::Bubblewrap(walls) => format!("bubblewrap {}", walls.sysroot().display()),
            // Each program's file belongs to one user id.
            #[cfg(target_os = "linux")]
            Sandbox::Container(walls) => format!("container {}", walls.uid()),
        }
    }

    /// A compiler that runs in `folder`, reads its `src` and the harness, and writes
    /// only to its `out`.
    ///
    /// # Errors
    /// If the folder cannot be handed over to the user id that compiles.
    // The other arguments are for sandboxes, which only Linux has.
    #[cfg_attr(not(target_os = "linux"), expect(unused_variables))]
    pub fn compiler(&self, folder: &Path, harness: &Path, limits: &Limits) -> io::Result<Command> {
        match self {
            Sandbox::Trusted => Ok(rust_tool("rustc", folder)),
            #[cfg(target_os = "linux")]
            Sandbox::Bubblewrap(walls) => walls.compiler(folder, harness, limits),
            #[cfg(target_os = "linux")]
            Sandbox::Container(walls) => walls.compiler(folder, harness, limits),
        }
    }

    /// Runs a command made by [`compiler`](Sandbox::compiler) to its end.
    pub fn compile(&self, compiler: Command, limits: &Limits) -> io::Result<CommandResult> {
        let finished = finish(compiler, limits, |pid| self.watch(pid, limits));
        self.sweep();
        let finished = finished?;
        if let Some(budget) = self.budget() {
            budget.add_starved(finished.waited);
        }
        if finished.is_late() {
            self.charge(false);
        }
        #[cfg(target_os = "linux")]
        if let Some(paths) = self.host_paths() {
            let text = String::from_utf8_lossy(&finished.stderr);
            return Ok(CommandResult {
                stderr: paths.hide(&text).into_bytes(),
                ..finished
            });
        }
        Ok(finished)
    }

    /// Takes a compiled program and its folder from the user id that compiled it. Foreign code may
    /// then run the program but not read it. If a program's file can't be read, the kernel also
    /// denies the program access to its own memory in `/proc`.
    ///
    /// # Errors
    /// If they cannot be handed over.
    #[cfg_attr(not(target_os = "linux"), expect(unused_variables))]
    pub fn seal(&self, folder: &Path, program: &Path) -> io::Result<()> {
        match self {
            Sandbox::Trusted => Ok(()),
            #[cfg(target_os = "linux")]
            Sandbox::Bubblewrap(_) => seal::seal(folder, None, program),
            #[cfg(target_os = "linux")]
            Sandbox::Container(walls) => seal::seal(folder, Some(walls.uid()), program),
        }
    }

    /// Whether the program exists and nobody but us could have changed it.
    pub fn is_sealed(&self, program: &Path) -> bool {
        match self {
            Sandbox::Trusted => program.is_file(),
            #[cfg(target_os = "linux")]
            _ => seal::is_ours(program),
        }
    }

    /// Asks a built program. The reply reports anything that its code does wrong.
    ///
    /// # Errors
    /// If it could not be started, or the sandbox could not be made.
    pub fn ask(
        &self,
        executable: &Path,
        job: &Job,
        limits: &Limits,
        stop: Stop,
        progress: &mut dyn FnMut(usize),
    ) -> io::Result<Reply> {
        let mut ask = || self.ask_once(executable, job, limits, stop.clone(), progress);
        for _ in 1..MOST_STARTS {
            let reply = ask()?;
            if reply.start.is_some() || !matches!(reply.ending, Ending::Died(_)) {
                return Ok(reply);
            }
            // Perhaps the machine could not make another sandbox at that moment.
            self.self_test()?;
        }
        ask()
    }

    fn ask_once(
        &self,
        executable: &Path,
        job: &Job,
        limits: &Limits,
        stop: Stop,
        progress: &mut dyn FnMut(usize),
    ) -> io::Result<Reply> {
        let mut limits = self.within_budget(limits);
        match self.time_left() {
            Ok(left) => limits.wall = limits.wall.min(left),
            Err(whole) => return Ok(Reply::unasked(job, Ending::OutOfTime(whole))),
        }
        #[cfg(target_os = "linux")]
        if !matches!(self, Sandbox::Trusted) {
            toolchain::load(executable);
        }
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
        let (asked_at, before) = (Instant::now(), time_of_children());
        // How long it was kept from running.
        let starved = Rc::new(Cell::new(Duration::ZERO));
        let asked = ask_watched(command, job, limit, progress, &mut |pid| {
            watch = Some(self.watch(pid, &limits));
            let (mut clock, begun, starved) = (own_clock(pid), Instant::now(), starved.clone());
            Box::new(move || {
                let had = clock();
                starved.set(begun.elapsed().saturating_sub(had));
                had
            })
        });
        let exceeded = watch.and_then(Watch::stop);
        if let Some(budget) = self.budget() {
            budget.add_starved(starved.get());
        }
        self.sweep();
        let mut reply = asked?;
        #[cfg(target_os = "linux")]
        if let Some(paths) = self.host_paths() {
            paths.hide_in(&mut reply);
        }
        if let Ending::Died(death) = &reply.ending {
            let took = before.zip(time_of_children());
            let took = took.map_or(Duration::ZERO, |(before, now)| now.saturating_sub(before));
            match exceeded {
                Some(ExceededLimit::Cpu(most) | ExceededLimit::Idle(most)) => {
                    reply.ending = Ending::TimedOut(most)
                }
                Some(ExceededLimit::Memory(most)) => reply.ending = Ending::OutOfMemory(most),
                // The watchdog was late, and the kernel's own limit ended the process. Code can
                // send itself the same signal, so look at the processor time of everything that we
                // have started since then. That includes other submissions that ran at the same
                // time, but a late submission is graded again, alone.
                None if matches!(death.possible_signal(), Some(SIGXCPU | SIGKILL))
                    && took > limits.cpu =>
                {
                    reply.ending = Ending::TimedOut(limits.cpu);
                }
                None => {}
            }
        }
        if let Ending::TimedOut(_) = reply.ending {
            self.charge(asked_at.elapsed() >= limits.wall * BUSY);
            if let Err(whole) = self.time_left() {
                reply.ending = Ending::OutOfTime(whole);
            }
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

    /// Kills processes that were left behind, if no process namespace does it.
    fn sweep(&self) {
        #[cfg(target_os = "linux")]
        if let Sandbox::Container(walls) = self {
            tree::end_all_of(walls.uid());
        }
    }

    /// Whether the sandbox still works, so that no student is blamed for a fault of the machine.
    fn self_test(&self) -> io::Result<()> {
        match self {
            Sandbox::Trusted => Ok(()),
            #[cfg(target_os = "linux")]
            Sandbox::Bubblewrap(walls) => walls.self_test(),
            #[cfg(target_os = "linux")]
            Sandbox::Container(walls) => walls.self_test(),
        }
    }

    /// Paths that the author of untrusted code must not see.
    #[cfg(target_os = "linux")]
    fn host_paths(&self) -> Option<&host_paths::HostPaths> {
        match self {
            Sandbox::Trusted => None,
            Sandbox::Bubblewrap(walls) => Some(&walls.host_paths),
            Sandbox::Container(walls) => Some(&walls.host_paths),
        }
    }

    /// The limits that remain for a submission that has exceeded some before.
    pub fn within_budget(&self, limits: &Limits) -> Limits {
        match self.budget() {
            Some(budget) => budget.bound(*limits),
            None => *limits,
        }
    }

    /// See [`Budget::is_starved`].
    pub fn is_starved(&self) -> bool {
        self.budget().is_some_and(Budget::is_starved)
    }

    /// Whether compiling has used up its share of the submission's time.
    pub fn is_done_compiling(&self) -> bool {
        self.budget().is_some_and(Budget::is_done_compiling)
    }

    fn charge(&self, is_starved: bool) {
        if let Some(budget) = self.budget() {
            budget.charge(is_starved);
        }
    }

    /// See [`Budget::forgive`].
    pub fn forgive(&self) {
        if let Some(budget) = self.budget() {
            budget.forgive();
        }
    }

    /// See [`Budget::left`].
    fn time_left(&self) -> std::result::Result<Duration, Duration> {
        self.budget().map_or(Ok(Duration::MAX), Budget::left)
    }

    fn budget(&self) -> Option<&Budget> {
        match self {
            Sandbox::Trusted => None,
            #[cfg(target_os = "linux")]
            Sandbox::Bubblewrap(walls) => Some(&walls.budget),
            #[cfg(target_os = "linux")]
            Sandbox::Container(walls) => Some(&walls.budget),
        }
    }
}

#[cfg(all(test, target_os = "linux"))]
mod tests;
