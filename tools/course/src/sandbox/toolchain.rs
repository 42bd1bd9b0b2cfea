//! Finds the compiler and its linker.

use std::ffi::OsString;
use std::fs;
use std::path::{Path, PathBuf};

use crate::checkout::Checkout;
use crate::error::{Error, Result};
use crate::rust_tool::rust_tool;

/// The folder that holds rustc and its libraries.
pub fn sysroot(checkout: &Checkout) -> Result<PathBuf> {
    let output = rust_tool("rustc", checkout.root())
        .args(["--print", "sysroot"])
        .output();
    match output {
        Ok(output) if output.status.success() => Ok(PathBuf::from(
            String::from_utf8_lossy(&output.stdout).trim(),
        )),
        _ => Err(Error::environment(
            "cannot ask rustc for its folder",
            "install Rust from rustup.rs",
        )),
    }
}

/// The linker to use inside. It must be gcc by name, because plain `cc` is a link through /etc,
/// which is not there. Naming a linker turns off rustc's default on Linux, its own copy of LLVM's
/// linker. With that one, compiling takes half the time, so these arguments ask for it again.
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
