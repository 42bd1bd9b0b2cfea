//! Where the compiler lives.

use std::ffi::OsString;
use std::fs;
use std::path::{Path, PathBuf};
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

/// What links inside: gcc by name, for plain `cc` would go through /etc, which is not
/// there. To name any linker turns off rustc's own default for Linux, the LLVM linker that
/// comes with it; with that one compiling takes half the time, so it is asked for again.
pub fn linker(sysroot: &Path) -> Vec<OsString> {
    let mut arguments = vec!["-Clinker=gcc".into()];
    let targets = fs::read_dir(sysroot.join("lib/rustlib"))
        .into_iter()
        .flatten()
        .flatten();
    let mut folders = targets.map(|target| target.path().join("bin/gcc-ld"));
    if let Some(folder) = folders.find(|folder| folder.join("ld.lld").is_file()) {
        let mut place = OsString::from("-Clink-arg=-B");
        place.push(folder);
        arguments.extend(["-Clink-arg=-fuse-ld=lld".into(), place]);
    }
    arguments
}

/// A user id that no system gives to people or services. Each sandbox of this program gets
/// a different one, so that none can starve or signal another.
pub fn next_uid() -> u32 {
    use std::sync::atomic::{AtomicU32, Ordering};

    static NEXT: AtomicU32 = AtomicU32::new(0);
    const FIRST: u32 = 61_200;
    const BLOCKS: u32 = 40;
    const BLOCK: u32 = 100;
    let block = std::process::id() % BLOCKS;
    FIRST + block * BLOCK + NEXT.fetch_add(1, Ordering::Relaxed) % BLOCK
}
