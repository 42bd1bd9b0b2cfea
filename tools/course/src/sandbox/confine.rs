//! The inner part of both sandboxes. A new process of this program gives up every right that
//! untrusted code does not need, and then becomes that code.
//!
//! Bubblewrap has set up its namespaces by then. In a container, where there can be no
//! namespaces, another user id and Landlock replace them.

use std::fmt::Display;
use std::os::unix::process::CommandExt;
use std::path::PathBuf;
use std::process::{Command, ExitCode};

use clap::Parser;
use landlock::{
    ABI, Access, AccessFs, CompatLevel, Compatible, Ruleset, RulesetAttr, RulesetCreatedAttr,
    RulesetStatus, Scope, path_beneath_rules,
};
use rustix::process::{Resource, Rlimit, Signal, getrlimit, setrlimit};
use rustix::thread;

use super::Limits;
use super::syscalls::{self, Purpose};

/// The hidden command's name.
const CONFINE: &str = "confine";

/// The resources that the code may use; see [`Limits`].
#[derive(Parser)]
struct Confine {
    /// The user and group to become.
    #[arg(long)]
    uid: Option<u32>,
    /// Whether the program is the compiler, which may start other programs and write files. A
    /// submission may not.
    #[arg(long)]
    compiles: bool,
    #[arg(long)]
    cpu: u64,
    #[arg(long)]
    address_space: u64,
    #[arg(long)]
    processes: u64,
    #[arg(long)]
    file_size: u64,
    #[arg(long)]
    open_files: u64,
    /// Behave as on a kernel that has no Landlock, for tests.
    #[arg(long)]
    without_landlock: bool,
    /// Refuse to run where Landlock is not in force.
    #[arg(long)]
    landlocked: bool,
    /// What may be read and executed.
    #[arg(long)]
    read: Vec<PathBuf>,
    /// What may be written.
    #[arg(long)]
    write: Vec<PathBuf>,
    /// The program and its arguments.
    #[arg(last = true, required = true)]
    command: Vec<std::ffi::OsString>,
}

/// Adds the arguments that confine a program. The program and its own arguments follow.
pub fn arguments(command: &mut Command, limits: &Limits, purpose: Purpose, uid: Option<u32>) {
    command.arg(CONFINE);
    if purpose == Purpose::Compile {
        command.arg("--compiles");
    }
    // The kernel counts whole seconds of single processes, while a watchdog outside counts the
    // whole tree. On a busy machine, the watchdog may be late. With the extra seconds, the same
    // loop still always ends in the same way.
    let cpu = limits.cpu.as_secs() + 5;
    for (name, value) in [
        ("--cpu", cpu),
        ("--address-space", limits.address_space),
        ("--processes", limits.processes),
        ("--file-size", limits.file_size),
        ("--open-files", limits.open_files),
    ] {
        command.args([name, &value.to_string()]);
    }
    if let Some(uid) = uid {
        command.args(["--uid", &uid.to_string()]);
    }
}

/// Turns this process into the confined program if its arguments ask for that. Returns only if
/// they don't, or if confining it fails.
pub fn become_confined() -> Option<ExitCode> {
    let mut arguments = std::env::args_os().skip(1).peekable();
    arguments
        .next_if(|word| word == CONFINE)
        .map(|word| run(&Confine::parse_from(std::iter::once(word).chain(arguments))))
}

fn run(confine: &Confine) -> ExitCode {
    let Err(what) = give_up(confine) else {
        let error = Command::new(&confine.command[0])
            .args(&confine.command[1..])
            .exec();
        eprintln!("pinhole: the confined program cannot be started: {error}");
        return ExitCode::from(NOT_CONFINED);
    };
    eprintln!("pinhole: the sandbox could not be set up: {what}");
    ExitCode::from(NOT_CONFINED)
}

/// The exit code if the code could not be confined, and therefore did not run.
pub const NOT_CONFINED: u8 = 125;

fn give_up(confine: &Confine) -> Result<(), String> {
    if let Some(uid) = confine.uid {
        let (user, group) = (thread::Uid::from_raw(uid), thread::Gid::from_raw(uid));
        step("groups", thread::set_thread_groups(&[]))?;
        step("group", thread::set_thread_res_gid(group, group, group))?;
        step("user", thread::set_thread_res_uid(user, user, user))?;
    }
    // Otherwise, the code could write to the terminal of the person who grades. This fails in
    // bubblewrap, whose processes have a session of their own already.
    let _alone = rustix::process::setsid();
    // This comes after changing the user, which would undo it.
    let end_with_parent = rustix::process::set_parent_process_death_signal(Some(Signal::KILL));
    step("end with the parent", end_with_parent)?;
    for (resource, most) in [
        (Resource::Cpu, confine.cpu),
        (Resource::As, confine.address_space),
        (Resource::Nproc, confine.processes),
        (Resource::Fsize, confine.file_size),
        (Resource::Nofile, confine.open_files),
        // With 0, the kernel would still start a program that handles crashes: see core(5).
        (Resource::Core, 1),
        (Resource::Memlock, 0),
        (Resource::Msgqueue, 0),
        (Resource::Sigpending, 0),
    ] {
        // If a lower limit is already set, we may not be allowed to raise it.
        let most = getrlimit(resource)
            .maximum
            .map_or(most, |least| least.min(most));
        // When the time is up, the kernel sends a signal. A second later, it kills the process.
        let current = match resource {
            Resource::Cpu => most.saturating_sub(1),
            _ => most,
        };
        let limit = Rlimit {
            current: Some(current),
            maximum: Some(most),
        };
        step("limits", setrlimit(resource, limit))?;
    }
    step("no new privileges", thread::set_no_new_privs(true))?;
    fence_files(confine)?;
    let purpose = match confine.compiles {
        true => Purpose::Compile,
        false => Purpose::Answer,
    };
    step(
        "seccomp",
        syscalls::restrict(purpose, confine.without_landlock),
    )
}

/// Adds the name of a step to its error.
fn step<T, E: Display>(name: &str, result: Result<T, E>) -> Result<T, String> {
    result.map_err(|error| format!("{name}: {error}"))
}

/// Whether the kernel offers Landlock. Making a ruleset restricts nothing yet.
pub fn has_landlock() -> bool {
    let ruleset = Ruleset::default().set_compatibility(CompatLevel::HardRequirement);
    let ruleset = ruleset.handle_access(AccessFs::from_all(ABI::V1));
    ruleset.and_then(Ruleset::create).is_ok()
}

/// Uses Landlock to forbid all other files, and signals to processes outside, as far as this
/// kernel supports it.
fn fence_files(confine: &Confine) -> Result<(), String> {
    let abi = ABI::V6;
    let fence = || {
        Ruleset::default()
            .set_compatibility(CompatLevel::BestEffort)
            .handle_access(AccessFs::from_all(abi))?
            .handle_access(landlock::AccessNet::from_all(abi))?
            .scope(Scope::from_all(abi))?
            .create()?
            .add_rules(path_beneath_rules(&confine.read, AccessFs::from_read(abi)))?
            .add_rules(path_beneath_rules(&confine.write, AccessFs::from_all(abi)))?
            .restrict_self()
    };
    let status = step("Landlock", fence())?;
    if confine.landlocked && status.ruleset == RulesetStatus::NotEnforced {
        return Err("this kernel has no Landlock".into());
    }
    Ok(())
}
