//! The system calls that untrusted code may not make.
//!
//! This list says what is denied and not what is allowed. The compiler and its linker come with the
//! machine, so a list of the calls they need would soon be out of date. The rest of the sandbox
//! still restricts all other calls.

use std::collections::BTreeMap;

use libc::{
    CLONE_NEWCGROUP, CLONE_NEWIPC, CLONE_NEWNET, CLONE_NEWNS, CLONE_NEWPID, CLONE_NEWUSER,
    CLONE_NEWUTS, CLONE_PIDFD, CLONE_THREAD,
};
use seccompiler::SeccompCmpArgLen::Dword;
use seccompiler::SeccompCmpOp::{MaskedEq, Ne};
use seccompiler::{
    BpfProgram, SeccompAction, SeccompCondition, SeccompFilter, SeccompRule, apply_filter,
};

/// What the code is to do.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Purpose {
    /// Run the compiler, which starts a linker.
    Compile,
    /// Answer questions. Threads are allowed, but no process, no new socket and no new file.
    Answer,
}

/// Calls that are always denied, because they reach other processes, the kernel itself, new
/// namespaces, or memory that no limit counts.
const NEVER: [libc::c_long; 48] = [
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

/// The only commands of `fcntl` that code may use while answering. Others watch a folder, lock a
/// file or store a number beside it, and so could pass answers to another submission.
const ALLOWED_OF_FCNTL: [u64; 6] = [
    libc::F_DUPFD as u64,
    libc::F_DUPFD_CLOEXEC as u64,
    libc::F_GETFD as u64,
    libc::F_SETFD as u64,
    libc::F_GETFL as u64,
    libc::F_SETFL as u64,
];

/// The only commands of `ioctl` that code may use while answering, and that the standard library
/// uses. Others tell the machine's addresses, for example.
const ALLOWED_OF_IOCTL: [u64; 3] = [libc::FIOCLEX, libc::FIONCLEX, libc::FIONBIO];

/// The only options of `prctl` that code may use while answering. With others, it could outlive the
/// grader, give its threads names that every user of the machine can read, or make the kernel use
/// memory that no limit counts, as for filters or for the table of futexes.
const ALLOWED_OF_PRCTL: [u64; 3] = [
    libc::PR_GET_PDEATHSIG as u64,
    libc::PR_GET_NO_NEW_PRIVS as u64,
    libc::PR_GET_SECCOMP as u64,
];

/// Calls that only the compiler may make. Without namespaces and Landlock, one submission could
/// pass answers to another by the names of files in a folder like `/tmp`, even if no file may be
/// written. It could also use the times of a file that everyone may write, such as `/dev/null`.
const NEVER_WHILE_ANSWERING: [libc::c_long; 26] = [
    // Filters take memory that no limit counts.
    libc::SYS_seccomp,
    libc::SYS_socket,
    libc::SYS_socketpair,
    // Makes a file if standard input, a socket, gets a path as its name.
    libc::SYS_bind,
    // `connect` gives it a name too, if `setsockopt` asks for its peer's credentials.
    libc::SYS_connect,
    libc::SYS_listen,
    libc::SYS_accept,
    libc::SYS_accept4,
    libc::SYS_setsockopt,
    libc::SYS_pipe2,
    libc::SYS_inotify_init1,
    libc::SYS_setsid,
    libc::SYS_setpgid,
    libc::SYS_mkdirat,
    libc::SYS_mknodat,
    libc::SYS_linkat,
    libc::SYS_symlinkat,
    libc::SYS_renameat,
    libc::SYS_renameat2,
    libc::SYS_unlinkat,
    libc::SYS_utimensat,
    // Its flags lie in memory. The C library uses `openat`.
    libc::SYS_openat2,
    // Drops a file's pages from the kernel's cache, and the next program could see that.
    libc::SYS_fadvise64,
    // All submissions have the C library's file open, and each would notice another one's lock.
    libc::SYS_flock,
    // Gives a cookie, which counts the processes that have asked for one.
    libc::SYS_getsockopt,
    // Its inode's number tells how many processes and threads the machine has started.
    libc::SYS_pidfd_open,
];

/// The same calls under the names that only x86-64 still has.
#[cfg(target_arch = "x86_64")]
const OLD_NAMES: [libc::c_long; 15] = [
    libc::SYS_fork,
    libc::SYS_vfork,
    libc::SYS_pipe,
    libc::SYS_inotify_init,
    libc::SYS_creat,
    libc::SYS_mkdir,
    libc::SYS_mknod,
    libc::SYS_link,
    libc::SYS_symlink,
    libc::SYS_rename,
    libc::SYS_rmdir,
    libc::SYS_unlink,
    libc::SYS_utime,
    libc::SYS_utimes,
    libc::SYS_futimesat,
];

/// The flags that make `open` create a file: one with a name, and one without.
const MAKES_FILE: [libc::c_int; 2] = [libc::O_CREAT, libc::O_TMPFILE & !libc::O_DIRECTORY];

/// The system calls of Landlock itself.
const LANDLOCK: [libc::c_long; 3] = [
    libc::SYS_landlock_create_ruleset,
    libc::SYS_landlock_add_rule,
    libc::SYS_landlock_restrict_self,
];

/// Denies these calls to this process and its children.
///
/// A denied call fails as if the kernel did not have it.
pub fn deny(purpose: Purpose, landlock_too: bool) -> Result<(), Box<dyn std::error::Error>> {
    Ok(apply_filter(&program(purpose, landlock_too)?)?)
}

fn program(purpose: Purpose, landlock_too: bool) -> Result<BpfProgram, seccompiler::BackendError> {
    let mut rules: BTreeMap<i64, Vec<SeccompRule>> = BTreeMap::new();
    rules.extend(NEVER.map(|call| (call, Vec::new())));
    // Landlock's rules take memory that no limit counts.
    if landlock_too || purpose == Purpose::Answer {
        rules.extend(LANDLOCK.map(|call| (call, Vec::new())));
    }
    let mut clones = Vec::new();
    for namespace in [
        CLONE_NEWCGROUP,
        CLONE_NEWIPC,
        CLONE_NEWNET,
        CLONE_NEWNS,
        CLONE_NEWPID,
        CLONE_NEWUSER,
        CLONE_NEWUTS,
    ] {
        clones.push(with_flag(0, namespace, true)?);
    }
    if purpose == Purpose::Answer {
        rules.extend(NEVER_WHILE_ANSWERING.map(|call| (call, Vec::new())));
        clones.push(with_flag(0, CLONE_THREAD, false)?);
        // The same as `pidfd_open`.
        clones.push(with_flag(0, CLONE_PIDFD, true)?);
        let making = |argument| -> Result<Vec<SeccompRule>, _> {
            let rules = MAKES_FILE.into_iter();
            rules.map(|flag| with_flag(argument, flag, true)).collect()
        };
        rules.insert(libc::SYS_openat, making(2)?);
        #[cfg(target_arch = "x86_64")]
        {
            rules.extend(OLD_NAMES.map(|call| (call, Vec::new())));
            rules.insert(libc::SYS_open, making(1)?);
        }
        // Unmapped pages of a shared mapping no longer count as the process's own, but stay in
        // memory until the last page of the mapping is unmapped. Huge pages don't count at all.
        let shared = with_flag(3, libc::MAP_SHARED, true)?;
        let huge = with_flag(3, libc::MAP_HUGETLB, true)?;
        rules.insert(libc::SYS_mmap, vec![shared, huge]);
        rules.insert(libc::SYS_fcntl, vec![other_than(1, &ALLOWED_OF_FCNTL)?]);
        rules.insert(libc::SYS_ioctl, vec![other_than(1, &ALLOWED_OF_IOCTL)?]);
        rules.insert(libc::SYS_prctl, vec![other_than(0, &ALLOWED_OF_PRCTL)?]);
    }
    rules.insert(libc::SYS_clone, clones);
    // On x86-64 the same calls have a second set of numbers (x32), and some have a third one.
    #[cfg(target_arch = "x86_64")]
    {
        const X32: i64 = 0x4000_0000;
        for (call, of_call) in rules.clone() {
            rules.insert(call | X32, of_call);
        }
        rules.extend((512..=547).map(|call| (call | X32, Vec::new())));
    }
    let unheard_of = SeccompAction::Errno(libc::ENOSYS as u32);
    let arch = std::env::consts::ARCH.try_into()?;
    SeccompFilter::new(rules, SeccompAction::Allow, unheard_of, arch)?.try_into()
}

/// A call that has this flag set, or not set, in one of its arguments.
fn with_flag(
    argument: u8,
    flag: libc::c_int,
    set: bool,
) -> Result<SeccompRule, seccompiler::BackendError> {
    let flag = u64::from(flag as u32);
    let expected = if set { flag } else { 0 };
    SeccompRule::new(vec![SeccompCondition::new(
        argument,
        Dword,
        MaskedEq(flag),
        expected,
    )?])
}

/// A call with any other value of an argument.
fn other_than(argument: u8, allowed: &[u64]) -> Result<SeccompRule, seccompiler::BackendError> {
    let is_not = |value: &u64| SeccompCondition::new(argument, Dword, Ne, *value);
    SeccompRule::new(allowed.iter().map(is_not).collect::<Result<_, _>>()?)
}
