//! The system calls that untrusted code may make.
//!
//! The compiler and its linker come with the machine, so a list of the calls they need would soon be
//! out of date. For them, a list says what is denied. For answers, a list says what is allowed: what
//! the standard library and the C library need to compute, to read and write, and to start threads.
//! So code can't pass messages by files, locks or counters of the kernel, nor make the kernel use
//! memory that no limit counts.
//!
//! A call that is not allowed fails as if the kernel did not have it, and libraries try an older one.
//! The rest of the sandbox still restricts what is allowed.

use std::collections::BTreeMap;

use libc::{
    CLONE_NEWCGROUP, CLONE_NEWIPC, CLONE_NEWNET, CLONE_NEWNS, CLONE_NEWPID, CLONE_NEWUSER,
    CLONE_NEWUTS, CLONE_THREAD,
};
use seccompiler::SeccompCmpArgLen::{Dword, Qword};
use seccompiler::SeccompCmpOp::{Eq, MaskedEq};
use seccompiler::{
    BackendError, BpfProgram, SeccompAction, SeccompCondition, SeccompFilter, SeccompRule,
    apply_filter,
};

/// What the code is to do.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Purpose {
    /// Run the compiler, which starts a linker.
    Compile,
    /// Answer questions. Threads are allowed, but no process, no new socket and no new file.
    Answer,
}

/// Calls that the compiler may not make, because they reach other processes, the kernel itself, new
/// namespaces, or memory that no limit counts.
const DENIED_TO_COMPILER: [libc::c_long; 48] = [
    libc::SYS_ptrace,
    libc::SYS_process_vm_readv,
    libc::SYS_process_vm_writev,
    libc::SYS_kcmp,
    libc::SYS_pidfd_getfd,
    libc::SYS_bpf,
    libc::SYS_userfaultfd,
    libc::SYS_perf_event_open,
    libc::SYS_io_uring_setup,
    libc::SYS_io_uring_enter,
    libc::SYS_io_uring_register,
    libc::SYS_io_setup,
    libc::SYS_keyctl,
    libc::SYS_add_key,
    libc::SYS_request_key,
    libc::SYS_unshare,
    libc::SYS_setns,
    // A filter can't check its flags, because they are in memory. Without it, the C library uses
    // `clone`.
    libc::SYS_clone3,
    libc::SYS_mount,
    libc::SYS_umount2,
    libc::SYS_move_mount,
    libc::SYS_open_tree,
    OPEN_TREE_ATTR,
    libc::SYS_fsopen,
    libc::SYS_fsconfig,
    libc::SYS_fsmount,
    libc::SYS_fspick,
    libc::SYS_mount_setattr,
    libc::SYS_pivot_root,
    libc::SYS_chroot,
    libc::SYS_init_module,
    libc::SYS_finit_module,
    libc::SYS_delete_module,
    libc::SYS_kexec_load,
    libc::SYS_syslog,
    libc::SYS_fanotify_init,
    libc::SYS_open_by_handle_at,
    libc::SYS_memfd_create,
    libc::SYS_memfd_secret,
    libc::SYS_shmget,
    libc::SYS_msgget,
    libc::SYS_semget,
    libc::SYS_mq_open,
    libc::SYS_setpriority,
    libc::SYS_sched_setscheduler,
    libc::SYS_sched_setattr,
    libc::SYS_ioprio_set,
    libc::SYS_capset,
];

/// `open_tree_attr`, which Linux has had since 6.15.
const OPEN_TREE_ATTR: libc::c_long = 467;

/// The system calls of Landlock itself.
const LANDLOCK: [libc::c_long; 3] = [
    libc::SYS_landlock_create_ruleset,
    libc::SYS_landlock_add_rule,
    libc::SYS_landlock_restrict_self,
];

/// The flags of `clone` that make a new namespace.
const NAMESPACES: libc::c_int = CLONE_NEWCGROUP
    | CLONE_NEWIPC
    | CLONE_NEWNET
    | CLONE_NEWNS
    | CLONE_NEWPID
    | CLONE_NEWUSER
    | CLONE_NEWUTS;

/// The flags of `clone` that a thread may have.
const OF_THREADS: libc::c_int = libc::CLONE_VM
    | libc::CLONE_FS
    | libc::CLONE_FILES
    | libc::CLONE_SIGHAND
    | libc::CLONE_SYSVSEM
    | libc::CLONE_SETTLS
    | libc::CLONE_PARENT_SETTID
    | libc::CLONE_CHILD_CLEARTID
    | libc::CLONE_DETACHED;

/// Calls that answers may make with any arguments.
const ALLOWED: [libc::c_long; 50] = [
    // The program is started after this list is in force.
    libc::SYS_execve,
    libc::SYS_exit,
    libc::SYS_exit_group,
    libc::SYS_brk,
    libc::SYS_mprotect,
    libc::SYS_mremap,
    libc::SYS_munmap,
    libc::SYS_read,
    libc::SYS_readv,
    libc::SYS_pread64,
    libc::SYS_write,
    libc::SYS_writev,
    libc::SYS_shutdown,
    libc::SYS_lseek,
    libc::SYS_close,
    libc::SYS_dup,
    libc::SYS_dup3,
    libc::SYS_ppoll,
    libc::SYS_fstat,
    libc::SYS_getcwd,
    libc::SYS_futex,
    libc::SYS_set_robust_list,
    libc::SYS_set_tid_address,
    libc::SYS_rseq,
    libc::SYS_sched_yield,
    libc::SYS_sched_getaffinity,
    libc::SYS_getcpu,
    libc::SYS_rt_sigaction,
    libc::SYS_rt_sigprocmask,
    libc::SYS_rt_sigreturn,
    libc::SYS_sigaltstack,
    libc::SYS_restart_syscall,
    libc::SYS_tgkill,
    libc::SYS_tkill,
    libc::SYS_nanosleep,
    libc::SYS_gettimeofday,
    libc::SYS_getrandom,
    libc::SYS_getrlimit,
    libc::SYS_getpid,
    libc::SYS_getppid,
    libc::SYS_gettid,
    libc::SYS_getsid,
    libc::SYS_getuid,
    libc::SYS_geteuid,
    libc::SYS_getgid,
    libc::SYS_getegid,
    libc::SYS_getresuid,
    libc::SYS_getresgid,
    libc::SYS_getgroups,
    libc::SYS_uname,
];

/// The same calls under the names that only x86-64 still has.
#[cfg(target_arch = "x86_64")]
const ALLOWED_OLD_NAMES: [libc::c_long; 4] = [
    libc::SYS_arch_prctl,
    libc::SYS_dup2,
    libc::SYS_poll,
    libc::SYS_time,
];

/// The only commands of `fcntl` that answers may use. Others watch a folder, lock a
/// file or store a number beside it, and so could pass answers to another submission.
const ALLOWED_OF_FCNTL: [u64; 6] = [
    libc::F_DUPFD as u64,
    libc::F_DUPFD_CLOEXEC as u64,
    libc::F_GETFD as u64,
    libc::F_SETFD as u64,
    libc::F_GETFL as u64,
    libc::F_SETFL as u64,
];

/// The only commands of `ioctl` that answers may use, and that the standard library uses. Others tell
/// the machine's addresses, for example.
const ALLOWED_OF_IOCTL: [u64; 3] = [libc::FIOCLEX, libc::FIONCLEX, libc::FIONBIO];

/// The only advice to `madvise` that answers may give, and that the C library gives. Other advice
/// drops pages of files that another program then has to read again.
const ALLOWED_OF_MADVISE: [u64; 6] = [
    libc::MADV_DONTNEED as u64,
    libc::MADV_FREE as u64,
    libc::MADV_HUGEPAGE as u64,
    libc::MADV_NOHUGEPAGE as u64,
    MADV_GUARD_INSTALL,
    MADV_GUARD_INSTALL + 1,
];

/// `MADV_GUARD_INSTALL`, which Linux has had since 6.13. The next number removes the guard.
const MADV_GUARD_INSTALL: u64 = 102;

/// The only options of `prctl` that answers may use. With others, it could outlive the
/// grader, give its threads names that every user of the machine can read, or make the kernel use
/// memory that no limit counts, as for filters or for the table of futexes.
const ALLOWED_OF_PRCTL: [u64; 3] = [
    libc::PR_GET_PDEATHSIG as u64,
    libc::PR_GET_NO_NEW_PRIVS as u64,
    libc::PR_GET_SECCOMP as u64,
];

/// Restricts this process and its children to these calls. `landlock_too` denies Landlock's own calls
/// to the compiler.
pub fn restrict(purpose: Purpose, landlock_too: bool) -> Result<(), Box<dyn std::error::Error>> {
    Ok(apply_filter(&program(purpose, landlock_too)?)?)
}

fn program(purpose: Purpose, landlock_too: bool) -> Result<BpfProgram, BackendError> {
    let allow = SeccompAction::Allow;
    let deny = SeccompAction::Errno(libc::ENOSYS as u32);
    let (rules, if_listed, otherwise) = match purpose {
        Purpose::Compile => (denied(landlock_too)?, deny, allow),
        Purpose::Answer => (allowed()?, allow, deny),
    };
    let arch = std::env::consts::ARCH.try_into()?;
    SeccompFilter::new(rules, otherwise, if_listed, arch)?.try_into()
}

type Rules = BTreeMap<i64, Vec<SeccompRule>>;

fn denied(landlock_too: bool) -> Result<Rules, BackendError> {
    let mut rules = Rules::from(DENIED_TO_COMPILER.map(|call| (call, Vec::new())));
    if landlock_too {
        rules.extend(LANDLOCK.map(|call| (call, Vec::new())));
    }
    let flags = (0..libc::c_int::BITS).map(|bit| 1 << bit);
    let flags = flags.filter(|flag| NAMESPACES & flag != 0);
    let clones = flags.map(|flag| with_flags(0, flag, flag));
    rules.insert(libc::SYS_clone, clones.collect::<Result<_, _>>()?);
    // On x86-64 the same calls have a second set of numbers (x32), and some have a third one.
    #[cfg(target_arch = "x86_64")]
    {
        const X32: i64 = 0x4000_0000;
        for (call, of_call) in rules.clone() {
            rules.insert(call | X32, of_call);
        }
        rules.extend((512..=547).map(|call| (call | X32, Vec::new())));
    }
    Ok(rules)
}

fn allowed() -> Result<Rules, BackendError> {
    let mut rules = Rules::from(ALLOWED.map(|call| (call, Vec::new())));
    // Threads as the C library makes them, but no process. A descriptor of a thread would tell how
    // many the machine has started, and a thread that waits for another would seem to be busy.
    rules.insert(
        libc::SYS_clone,
        vec![with_flags(0, !OF_THREADS, CLONE_THREAD)?],
    );
    // No new file, with or without a name, none that is emptied, and no link itself.
    let nameless = libc::O_TMPFILE & !libc::O_DIRECTORY;
    let opened = libc::O_CREAT | nameless | libc::O_TRUNC | libc::O_PATH;
    rules.insert(libc::SYS_openat, vec![with_flags(2, opened, 0)?]);
    // Standard input is a socket. Its other flags are seldom used, so their code in the kernel is
    // seldom tested.
    rules.insert(libc::SYS_recvfrom, vec![with_flags(3, !0, 0)?]);
    let signal = libc::MSG_NOSIGNAL;
    rules.insert(libc::SYS_sendto, vec![with_flags(3, !signal, 0)?]);
    // With this flag, the path is usually empty. By path, safe code could read when somebody first
    // looked for a file in `/proc`.
    let by_descriptor = libc::AT_EMPTY_PATH;
    rules.insert(
        libc::SYS_newfstatat,
        vec![with_flags(3, by_descriptor, by_descriptor)?],
    );
    // Unmapped pages of a shared mapping no longer count as the process's own, but stay in memory
    // until the last page of the mapping is unmapped. Huge pages don't count at all.
    let kinds = libc::MAP_TYPE | libc::MAP_HUGETLB;
    rules.insert(
        libc::SYS_mmap,
        vec![with_flags(3, kinds, libc::MAP_PRIVATE)?],
    );
    rules.insert(libc::SYS_madvise, one_of(2, &ALLOWED_OF_MADVISE)?);
    // Only the clocks with the numbers 0 to 7. Others are those of other processes.
    for call in [libc::SYS_clock_gettime, libc::SYS_clock_nanosleep] {
        rules.insert(call, vec![with_flags(0, !7, 0)?]);
    }
    // Limits may be read, but not changed.
    let of_itself = SeccompCondition::new(0, Dword, Eq, 0)?;
    let to_nothing = SeccompCondition::new(2, Qword, Eq, 0)?;
    let read_limit = SeccompRule::new(vec![of_itself, to_nothing])?;
    rules.insert(libc::SYS_prlimit64, vec![read_limit]);
    rules.insert(libc::SYS_fcntl, one_of(1, &ALLOWED_OF_FCNTL)?);
    rules.insert(libc::SYS_ioctl, one_of(1, &ALLOWED_OF_IOCTL)?);
    rules.insert(libc::SYS_prctl, one_of(0, &ALLOWED_OF_PRCTL)?);
    #[cfg(target_arch = "x86_64")]
    {
        rules.extend(ALLOWED_OLD_NAMES.map(|call| (call, Vec::new())));
        rules.insert(libc::SYS_open, vec![with_flags(1, opened, 0)?]);
    }
    Ok(rules)
}

/// A call that has `set` of these flags in one of its arguments, and none of the others.
fn with_flags(
    argument: u8,
    flags: libc::c_int,
    set: libc::c_int,
) -> Result<SeccompRule, BackendError> {
    let [flags, set] = [flags, set].map(|flags| u64::from(flags as u32));
    let condition = SeccompCondition::new(argument, Dword, MaskedEq(flags), set)?;
    SeccompRule::new(vec![condition])
}

/// A call with one of these values of an argument.
fn one_of(argument: u8, values: &[u64]) -> Result<Vec<SeccompRule>, BackendError> {
    let is = |value: &u64| {
        let condition = SeccompCondition::new(argument, Dword, Eq, *value)?;
        SeccompRule::new(vec![condition])
    };
    values.iter().map(is).collect()
}
