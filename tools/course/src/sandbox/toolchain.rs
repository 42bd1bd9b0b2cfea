//! Finds the compiler and its linker.

use std::collections::BTreeSet;
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

/// The names of [`libraries`] below `/usr`, each with the file that it stands for. Programs load
/// libraries by names that may be links.
pub fn library_names() -> Vec<(PathBuf, PathBuf)> {
    let files = libraries().into_iter();
    let files: BTreeSet<PathBuf> = files.filter(|file| file.starts_with("/usr")).collect();
    let folders = files.iter().filter_map(|file| file.parent());
    let mut folders: BTreeSet<&Path> = folders.collect();
    // The dynamic linker's name is there.
    folders.insert(Path::new("/usr/lib64"));
    let entries = folders.into_iter().flat_map(fs::read_dir).flatten();
    let names = entries.flatten().map(|entry| entry.path());
    let named = names.filter_map(|name| Some((fs::canonicalize(&name).ok()?, name)));
    named.filter(|(file, _)| files.contains(file)).collect()
}

/// The libraries that a program needs to start. They are those that this program uses, because it
/// is written in Rust, too. Reading any other file of the system would leave a trace for programs
/// that run later: the file's pages are in the kernel's cache and, where files may change, the time
/// of the last access is new.
pub fn libraries() -> Vec<PathBuf> {
    let maps = fs::read_to_string("/proc/self/maps").unwrap_or_default();
    let mapped = maps.lines().filter_map(|line| line.split_once(" /"));
    let mapped = mapped.map(|(_, path)| PathBuf::from(format!("/{path}")));
    let is_library = |path: &PathBuf| path.to_string_lossy().contains(".so");
    let mut files: Vec<PathBuf> = mapped.filter(is_library).collect();
    files.push("/etc/ld.so.cache".into());
    files.push("/dev/null".into());
    files.dedup();
    files
}

/// Reads a program and the libraries that it needs, so that all their pages are in the kernel's
/// cache. Otherwise, the program could read some pages and leave out others, and programs that run
/// later could measure which pages were read.
pub fn load(program: &Path) {
    for file in libraries().iter().map(PathBuf::as_path).chain([program]) {
        if file.is_file() {
            let _absent = fs::read(file);
        }
    }
}

#[cfg(test)]
mod tests {
    use std::fs::File;
    use std::io::IoSliceMut;

    use rustix::fs::Advice;
    use rustix::io::{ReadWriteFlags, preadv2};

    use super::*;

    /// How many pages of a file the kernel has in its cache.
    fn cached_pages(file: &File, pages: u64) -> usize {
        let mut byte = [0];
        let is_cached = |page: &u64| {
            let into = &mut [IoSliceMut::new(&mut byte)];
            preadv2(file, into, page * 4096, ReadWriteFlags::NOWAIT).is_ok()
        };
        (0..pages).filter(is_cached).count()
    }

    #[test]
    fn no_page_of_a_program_tells_whether_it_was_read_before() {
        let beside = std::env::current_exe().unwrap();
        let folder = tempfile::tempdir_in(beside.parent().unwrap()).unwrap();
        let program = folder.path().join("submission");
        let pages = 1024;
        fs::write(&program, vec![7; 4096 * pages]).unwrap();
        let file = File::open(&program).unwrap();
        file.sync_all().unwrap();
        // Without effect if the folder is in memory.
        rustix::fs::fadvise(&file, 0, None, Advice::DontNeed).unwrap();
        load(&program);
        assert_eq!(cached_pages(&file, pages as u64), pages);
    }
}
