//! Where the compiler lives.

use std::path::PathBuf;
use std::process::Command;

use crate::error::{Error, Result};

/// The folder that holds rustc and its libraries.
pub fn sysroot() -> Result<PathBuf> {
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

/// User ids that no system gives to people or services; those of one program's
/// sandboxes differ, so that none can starve or signal another.
pub fn next_uid() -> u32 {
    use std::sync::atomic::{AtomicU32, Ordering};

    static NEXT: AtomicU32 = AtomicU32::new(0);
    const FIRST: u32 = 61_200;
    const BLOCKS: u32 = 40;
    const BLOCK: u32 = 100;
    let block = std::process::id() % BLOCKS;
    FIRST + block * BLOCK + NEXT.fetch_add(1, Ordering::Relaxed) % BLOCK
}
