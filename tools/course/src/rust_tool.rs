//! Starts cargo, rustc and git away from the current folder.
//!
//! All three obey files in the folder where they start: `rust-toolchain.toml` can name any
//! program as the compiler, and the settings of cargo and git any program to run. The current
//! folder may be a student's, so we start them in one of ours, and by their full path.

use std::env;
use std::ffi::OsStr;
use std::path::{Path, PathBuf};
use std::process::Command;

/// `cargo` or `rustc`, started in `folder`, which must be ours. Uses the one that cargo names in
/// the environment of the programs it runs, or else the first in `PATH`.
pub fn rust_tool(name: &str, folder: &Path) -> Command {
    let named = env::var_os(name.to_uppercase()).map(PathBuf::from);
    match named.filter(|program| program.is_absolute()) {
        Some(program) => in_folder(program, folder),
        None => tool(name, folder),
    }
}

/// The first program of this name in `PATH`, started in `folder`, which must be ours.
pub fn tool(name: &str, folder: &Path) -> Command {
    in_folder(programs(name).next().unwrap_or(name.into()), folder)
}

/// All programs of this name in `PATH`, in its order.
pub fn programs(name: &str) -> impl Iterator<Item = PathBuf> {
    let path = env::var_os("PATH").unwrap_or_default();
    in_path(&path, name).into_iter()
}

/// A program, started in `folder`, which must be ours.
pub fn in_folder(program: PathBuf, folder: &Path) -> Command {
    let mut command = Command::new(program);
    command.current_dir(folder);
    command
}

/// Finds programs in a search path. Skips relative folders, because they are relative to the
/// current folder.
fn in_path(path: &OsStr, name: &str) -> Vec<PathBuf> {
    let name = format!("{name}{}", env::consts::EXE_SUFFIX);
    env::split_paths(path)
        .filter(|folder| Path::is_absolute(folder))
        .map(|folder| folder.join(&name))
        .filter(|program| is_executable(program))
        .collect()
}

fn is_executable(program: &Path) -> bool {
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        program
            .metadata()
            .is_ok_and(|it| it.is_file() && it.permissions().mode() & 0o111 != 0)
    }
    #[cfg(not(unix))]
    program.is_file()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn program_of_the_current_folder_is_never_found() {
        let here = env::current_dir().unwrap();
        let folder = tempfile::tempdir_in(&here).unwrap();
        let file = format!("tool{}", env::consts::EXE_SUFFIX);
        std::fs::write(folder.path().join(&file), "").unwrap();
        crate::private::allow(&folder.path().join(&file), 0o755).unwrap();
        let relative = folder.path().strip_prefix(&here).unwrap();
        assert!(in_path(relative.as_os_str(), "tool").is_empty());
        let both = env::join_paths([relative, folder.path()]).unwrap();
        assert_eq!(in_path(&both, "tool"), [folder.path().join(file)]);
    }
}
