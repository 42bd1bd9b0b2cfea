//! Opens files and addresses in the desktop's own programs, if there is a desktop.

use std::path::Path;

/// Opens a file or an address, if there is a desktop and nothing else would be started.
pub fn open(what: impl AsRef<std::ffi::OsStr>) -> bool {
    is_there() && has_absolute_path() && open::that_detached(what).is_ok()
}

/// Whether all folders in `PATH` are absolute. Others are folders in the current folder, which may be a
/// student's, with programs named like the desktop's.
fn has_absolute_path() -> bool {
    let path = std::env::var_os("PATH").unwrap_or_default();
    std::env::split_paths(&path).all(|folder| folder.is_absolute())
}

fn is_there() -> bool {
    let is_set = |name| std::env::var_os(name).is_some_and(|value| !value.is_empty());
    let needs_display = cfg!(all(unix, not(target_os = "macos")));
    !needs_display || is_set("DISPLAY") || is_set("WAYLAND_DISPLAY")
}

/// A path as a browser's address, to which the name of a place on the page may be added.
pub fn address(path: &Path) -> String {
    let path = path.display().to_string().replace('\\', "/");
    let path = path.replace('%', "%25").replace('#', "%23");
    let path = path.replace('?', "%3F").replace(' ', "%20");
    let root = if path.starts_with('/') { "" } else { "/" };
    format!("file://{root}{path}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn special_characters_of_a_path_mean_nothing_in_its_address() {
        let path = Path::new("/home/ada/100% #1");
        assert_eq!(address(path), "file:///home/ada/100%25%20%231");
        assert_eq!(address(Path::new("C:\\book")), "file:///C:/book");
    }
}
