//! What foreign code may not ask the kernel for.
//!
//! A list of what is denied, not of what is allowed: the compiler and its linker
//! belong to the machine, and no list of theirs would hold for long. Whatever else
//! gets through meets the other walls.

use std::collections::BTreeMap;

use libc::{
    CLONE_NEWCGROUP, CLONE_NEWIPC, CLONE_NEWNET, CLONE_NEWNS, CLONE_NEWPID, CLONE_NEWUSER,
    CLONE_NEWUTS, CLONE_THREAD,
};
use seccompiler::SeccompCmpArgLen::Dword;
use seccompiler::SeccompCmpOp::MaskedEq;
use seccompiler::{
    BpfProgram, SeccompAction, SeccompCondition, SeccompFilter, SeccompRule, apply_filter,
};

/// What the code is to do.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Purpose {
    /// Run the compiler, which starts a linker.
    Compile,
    /// Answer questions: threads, but no process, no socket of its own, no file made.
    Answer,
}

/// Other processes, the kernel itself, new namespaces, and memory that no limit counts.
const NEVER: [libc::c_long; 42] = [
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
    libc::SYS_keyctl,
    libc::SYS_add_key,
    libc::SYS_request_key,
    libc::SYS_unshare,
    libc::SYS_setns,
    // Its flags lie in memory, where a filter cannot see them; the C library then
    // takes `clone`.
    libc::SYS_clone3,
    libc::SYS_mount,
    libc::SYS_umount2,
    libc::SYS_move_mount,
    libc::SYS_open_tree,
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
];

/// What only the compiler may do.
const NEVER_WHILE_ANSWERING: [libc::c_long; 6] = [
    libc::SYS_socket,
    libc::SYS_socketpair,
    libc::SYS_pipe2,
    libc::SYS_inotify_init1,
    libc::SYS_setsid,
    libc::SYS_setpgid,
];

/// Denies it all to this process and whatever becomes of it.
///
/// What is denied looks as if this kernel had never heard of it.
pub fn deny(purpose: Purpose) -> Result<(), Box<dyn std::error::Error>> {
    Ok(apply_filter(&program(purpose)?)?)
}

fn program(purpose: Purpose) -> Result<BpfProgram, seccompiler::BackendError> {
    let mut rules: BTreeMap<i64, Vec<SeccompRule>> = BTreeMap::new();
    rules.extend(NEVER.map(|call| (call, Vec::new())));
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
        clones.push(clone_with(namespace, true)?);
    }
    if purpose == Purpose::Answer {
        rules.extend(NEVER_WHILE_ANSWERING.map(|call| (call, Vec::new())));
        clones.push(clone_with(CLONE_THREAD, false)?);
        #[cfg(target_arch = "x86_64")]
        rules.extend(
            [libc::SYS_fork, libc::SYS_vfork, libc::SYS_pipe].map(|call| (call, Vec::new())),
        );
    }
    rules.insert(libc::SYS_clone, clones);
    // The same calls by their second set of numbers.
    #[cfg(target_arch = "x86_64")]
    for (call, of_call) in rules.clone() {
        const X32: i64 = 0x4000_0000;
        rules.insert(call | X32, of_call);
    }
    let unheard_of = SeccompAction::Errno(libc::ENOSYS as u32);
    let arch = std::env::consts::ARCH.try_into()?;
    SeccompFilter::new(rules, SeccompAction::Allow, unheard_of, arch)?.try_into()
}

/// A `clone` in whose flags this one is set, or is not.
fn clone_with(flag: libc::c_int, set: bool) -> Result<SeccompRule, seccompiler::BackendError> {
    let flag = u64::from(flag as u32);
    let expected = if set { flag } else { 0 };
    SeccompRule::new(vec![SeccompCondition::new(
        0,
        Dword,
        MaskedEq(flag),
        expected,
    )?])
}
