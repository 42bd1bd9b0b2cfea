//! Hides the folders of the grader's machine from students.

use std::env;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use pinhole::ask::{Ending, Reply};

use crate::checkout::Checkout;

/// Folders of this machine that the compiler and the harness name, and the names that are shown
/// instead.
#[derive(Clone, Debug)]
pub struct HostPaths(Arc<[(String, &'static str)]>);

impl HostPaths {
    /// The folders of a checkout, a toolchain and cargo, and the `scratch` folder if there is
    /// one.
    pub fn new(checkout: &Checkout, sysroot: &Path, scratch: Option<&Path>) -> HostPaths {
        let home = env::var_os("HOME").map(PathBuf::from);
        let of_home = |name| home.as_ref().map(|home| home.join(name));
        let cargo = env::var_os("CARGO_HOME").map(PathBuf::from);
        let folders = [
            (scratch.map(Path::to_owned), "grading"),
            (Some(checkout.root().to_owned()), "pinhole"),
            (Some(sysroot.to_owned()), "rust"),
            (cargo.or_else(|| of_home(".cargo")), "cargo"),
            (of_home(".cargo"), "cargo"),
        ];
        let mut all = Vec::new();
        for (folder, name) in folders {
            let Some(folder) = folder else { continue };
            let real = folder.canonicalize().unwrap_or(folder.clone());
            for path in [folder, real] {
                let path = path.display().to_string();
                if !path.is_empty() && path != "/" {
                    all.push((path, name));
                }
            }
        }
        // One folder may contain another, so replace the longest paths first.
        all.sort_by_key(|(path, _)| std::cmp::Reverse(path.len()));
        HostPaths(all.into())
    }

    /// The text, with these folders replaced.
    pub fn hide(&self, text: &str) -> String {
        let hidden = self.0.iter();
        hidden.fold(text.to_owned(), |text, (path, name)| {
            match text.contains(path.as_str()) {
                true => text.replace(path.as_str(), name),
                false => text,
            }
        })
    }

    /// Replaces these folders in a reply: in what was printed, and in the place and message of a
    /// panic.
    pub fn hide_in(&self, reply: &mut Reply) {
        reply.printed = self.hide(&reply.printed);
        if let Ending::Panicked(panic) = &mut reply.ending {
            panic.message = self.hide(&panic.message);
            panic.file = self.hide(&panic.file);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn folders_are_named_and_those_inside_others_first() {
        let checkout = Checkout::at(Path::new("/srv/course"));
        let (sysroot, scratch) = (Path::new("/opt/rust"), Path::new("/srv/course/target/x"));
        let paths = HostPaths::new(&checkout, sysroot, Some(scratch));
        let text = "--> /srv/course/src/ray.rs:3, -L/srv/course/target/x/harness, /opt/rust/lib";
        assert_eq!(
            paths.hide(text),
            "--> pinhole/src/ray.rs:3, -Lgrading/harness, rust/lib"
        );
    }
}
