//! Files and folders that nobody else on the machine can read or lock, and some that others must
//! read.

use std::fs::{self, File, Metadata, OpenOptions};
use std::io;
use std::path::Path;

/// A new file, or an old one that is emptied, that nobody else on the machine can read. An error if
/// it is a link, which another user may have put there. An old file may belong to another user, as
/// the lock of a checkout may.
pub fn private_file(path: &Path) -> io::Result<File> {
    let mut options = File::options();
    let file = private(options.create(true).truncate(true), path)?;
    // An old file keeps its mode.
    #[cfg(unix)]
    file.set_permissions(std::os::unix::fs::PermissionsExt::from_mode(0o600))?;
    Ok(file)
}

/// A new file that nobody else on the machine can read. An error if there is one already.
pub fn new_private_file(path: &Path) -> io::Result<File> {
    private(File::options().create_new(true), path)
}

fn private(options: &mut OpenOptions, path: &Path) -> io::Result<File> {
    #[cfg(unix)]
    {
        use std::os::unix::fs::OpenOptionsExt;
        options.mode(0o600).custom_flags(libc::O_NOFOLLOW);
    }
    options.write(true).open(path)
}

/// Makes a folder private, so that nobody else on the machine can look inside.
pub fn make_private(folder: &Path) -> io::Result<()> {
    #[cfg(unix)]
    {
        let mode = std::os::unix::fs::PermissionsExt::from_mode(0o700);
        fs::set_permissions(folder, mode)?;
    }
    #[cfg(not(unix))]
    let _nobody_else_is_here = folder;
    Ok(())
}

/// Whether a folder is ours, and nobody else on the machine can read it. False if it isn't there.
pub fn is_private(folder: &Path) -> bool {
    is_ours(folder) && is_closed(folder, 0o077)
}

/// Whether a file or folder belongs to us or root, and nobody else can change it.
pub fn is_ours(path: &Path) -> bool {
    fs::metadata(path).is_ok_and(|it| has_our_owner(&it)) && is_closed(path, 0o022)
}

/// Whether a file or folder belongs to us or root.
#[cfg_attr(not(unix), expect(unused_variables))]
pub fn has_our_owner(about: &Metadata) -> bool {
    #[cfg(unix)]
    {
        use std::os::unix::fs::MetadataExt;
        [0, rustix::process::geteuid().as_raw()].contains(&about.uid())
    }
    #[cfg(not(unix))]
    true
}

/// Whether no other user can replace a file: it and each folder around it belong to us or root, and
/// nobody else can change them. Others may add files of their own to a folder with the sticky bit.
#[cfg_attr(not(unix), expect(unused_variables))]
pub fn is_irreplaceable(path: &Path) -> bool {
    #[cfg(unix)]
    {
        use std::os::unix::fs::MetadataExt;
        let is_sticky = |it: &Path| {
            fs::metadata(it)
                .is_ok_and(|it| it.is_dir() && it.mode() & 0o1000 != 0 && has_our_owner(&it))
        };
        path.ancestors().all(|it| is_ours(it) || is_sticky(it))
    }
    #[cfg(not(unix))]
    true
}

/// Whether only we and root can reach a folder, because it or a folder around it is private, and no
/// other user can replace that one. False if it isn't there. In a user namespace that hides who owns
/// `/`, nobody can tell who could replace a folder, so that is not asked.
pub fn is_hidden(folder: &Path) -> bool {
    let folder = folder.canonicalize();
    let shows_owners = is_ours(Path::new("/"));
    folder.is_ok_and(|it| {
        let mut around = it.ancestors();
        around.any(|it| is_private(it) && (!shows_owners || is_irreplaceable(it)))
    })
}

/// Whether nobody but the owner has any of these permissions.
#[cfg_attr(not(unix), expect(unused_variables))]
fn is_closed(path: &Path, permissions: u32) -> bool {
    #[cfg(unix)]
    {
        use std::os::unix::fs::MetadataExt;
        fs::metadata(path).is_ok_and(|it| it.mode() & permissions == 0)
    }
    #[cfg(not(unix))]
    true
}

/// Allows at least this mode, whatever umask the path was made with, because a sandbox may run as
/// another user.
#[cfg_attr(not(unix), expect(unused_variables))]
pub fn allow(path: &Path, mode: u32) -> io::Result<()> {
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        let own = fs::metadata(path)?.permissions().mode();
        if own & mode != mode {
            return fs::set_permissions(path, PermissionsExt::from_mode(own | mode));
        }
    }
    Ok(())
}

#[cfg(all(test, unix))]
#[test]
fn no_private_file_is_written_through_a_link() {
    let folder = tempfile::tempdir().expect("there is room");
    let [victim, link] = ["victim", "link"].map(|name| folder.path().join(name));
    fs::write(&victim, "kept").expect("there is room");
    std::os::unix::fs::symlink(&victim, &link).expect("there is room");
    assert!(private_file(&link).is_err());
    assert_eq!(fs::read_to_string(&victim).expect("it is there"), "kept");
}

#[cfg(all(test, unix))]
#[test]
fn nobody_else_reaches_a_readable_folder_in_a_private_one() {
    let private = tempfile::tempdir().expect("there is room");
    let inside = private.path().join("fresh");
    fs::create_dir(&inside).expect("there is room");
    allow(&inside, 0o755).expect("it is ours");
    assert!(!is_hidden(Path::new("/")));
    assert!(!is_hidden(&private.path().join("absent")));
    make_private(private.path()).expect("it is ours");
    assert!(is_hidden(&inside) && !is_private(&inside));
    if rustix::process::geteuid().is_root() {
        std::os::unix::fs::chown(private.path(), Some(12345), None).expect("root may");
        assert!(!is_hidden(&inside));
        // Its owner may rename a folder of ours.
        make_private(&inside).expect("it is ours");
        allow(private.path(), 0o755).expect("root may");
        assert!(is_private(&inside) && !is_hidden(&inside));
    }
}
