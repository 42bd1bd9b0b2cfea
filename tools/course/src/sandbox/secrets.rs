//! Checks that untrusted code can read no secret.

use std::path::{Path, PathBuf};

use crate::checkout::Checkout;
use crate::error::{Error, Result};

/// Refuses a sandbox that would show a secret: the checkout, its goldens and assignments, or one
/// of `secrets` in a folder that the code may read.
pub fn refuse_visible_secrets(
    visible: &[&Path],
    checkout: &Checkout,
    secrets: &[PathBuf],
) -> Result<()> {
    let root = checkout.root().to_owned();
    let own = [root.join("golden"), checkout.assignments(), root];
    for secret in own.iter().chain(secrets) {
        let lies_in = |folder: &&&Path| real(secret).starts_with(real(folder));
        if let Some(folder) = visible.iter().find(lies_in) {
            return Err(Error::environment(
                format!(
                    "{} lies in {}, which code in the sandbox may read",
                    secret.display(),
                    folder.display()
                ),
                "move it to another folder, for instance in your home or in /srv",
            ));
        }
    }
    Ok(())
}

/// The path with links resolved. If a folder doesn't exist yet, its parent is resolved.
fn real(path: &Path) -> PathBuf {
    let path = std::path::absolute(path).unwrap_or(path.into());
    match (path.canonicalize(), path.parent(), path.file_name()) {
        (Ok(real), ..) => real,
        (Err(_), Some(parent), Some(name)) => real(parent).join(name),
        _ => path,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn secret_in_a_folder_that_code_may_read_is_refused() {
        let folder = tempfile::tempdir().unwrap();
        let (usr, elsewhere) = (folder.path().join("usr"), folder.path().join("elsewhere"));
        for folder in [&usr, &elsewhere] {
            std::fs::create_dir(folder).unwrap();
        }
        let link = elsewhere.join("link");
        std::os::unix::fs::symlink(&usr, &link).unwrap();
        let refused = |checkout: &Path, secret: &Path| {
            let checkout = Checkout::at(checkout);
            refuse_visible_secrets(&[&usr], &checkout, &[secret.to_owned()]).is_err()
        };
        assert!(!refused(&elsewhere, &elsewhere.join("out")));
        assert!(refused(&usr.join("local/pinhole"), &elsewhere));
        for secret in [usr.join("fresh"), link.clone(), link.join("out/new")] {
            assert!(refused(&elsewhere, &secret), "{}", secret.display());
        }
    }
}
