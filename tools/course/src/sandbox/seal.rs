//! Makes compiled programs the grader's own, so that the code that compiled or runs them can't
//! change them.

use std::fs::{self, Permissions};
use std::io;
use std::os::unix::fs::{MetadataExt, PermissionsExt, chown};
use std::path::Path;

/// Makes a program and its folder ours. Others may run it, but only we may read it. If there is a
/// `group`, only its members may enter the folder.
pub fn seal(folder: &Path, group: Option<u32>, program: &Path) -> io::Result<()> {
    let own = rustix::process::geteuid();
    if !own.is_root() {
        // We made everything ourselves.
        return fs::set_permissions(program, Permissions::from_mode(0o700));
    }
    chown(program, Some(0), Some(0))?;
    fs::set_permissions(program, Permissions::from_mode(0o711))?;
    if let Some(group) = group {
        chown(folder, Some(0), Some(group))?;
        fs::set_permissions(folder, Permissions::from_mode(0o710))?;
    }
    Ok(())
}

/// Whether a program is a file of ours with a single name, which nobody else may write.
pub fn is_ours(program: &Path) -> bool {
    let own = rustix::process::geteuid().as_raw();
    fs::symlink_metadata(program).is_ok_and(|about| {
        about.is_file() && about.uid() == own && about.nlink() == 1 && about.mode() & 0o022 == 0
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sandbox::Sandbox;

    #[test]
    fn program_that_another_could_have_changed_is_not_ours() {
        let folder = tempfile::tempdir().unwrap();
        let program = folder.path().join("program");
        assert!(!is_ours(&program), "it is not there");
        fs::write(&program, "").unwrap();
        seal(folder.path(), None, &program).unwrap();
        assert!(is_ours(&program));
        let mode = |mode| fs::set_permissions(&program, Permissions::from_mode(mode)).unwrap();
        mode(0o772);
        assert!(!is_ours(&program), "anybody may write it");
        assert!(
            Sandbox::Trusted.is_sealed(&program),
            "trusted code needs no seal"
        );
        mode(0o711);
        let link = folder.path().join("link");
        std::os::unix::fs::symlink(&program, &link).unwrap();
        assert!(!is_ours(&link), "it is a link");
        fs::hard_link(&program, folder.path().join("other")).unwrap();
        assert!(!is_ours(&program), "it has another name");
        if rustix::process::geteuid().is_root() {
            let theirs = folder.path().join("theirs");
            fs::write(&theirs, "").unwrap();
            chown(&theirs, Some(1000), Some(1000)).unwrap();
            assert!(!is_ours(&theirs), "it is somebody else's");
        }
    }
}
