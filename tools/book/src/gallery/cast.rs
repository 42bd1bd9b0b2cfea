//! Casts scenes as somebody with a mistake does; what was cast last time is kept, and
//! taken again as long as nothing has changed that it depends on.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use pinhole::Film;
use sha2::{Digest, Sha256};

use crate::check::pages_files;
use crate::checkout::Checkout;
use crate::error::{Error, Problem, Result};
use crate::program;
use crate::run::copy_rust;

/// What casts for all mistakes.
pub struct Caster<'a> {
    /// `pinhole`, built from this checkout.
    pinhole: PathBuf,
    /// A hash of everything but the mistake that its film depends on.
    state: Sha256,
    checkout: &'a Checkout,
}

impl Caster<'_> {
    /// Builds what casts.
    pub fn new(checkout: &Checkout) -> Result<Caster<'_>> {
        let pinhole = program::build("pinhole-cli", checkout)?;
        let mut state = Sha256::new();
        let assignment = checkout.assignment();
        for folder in [
            checkout.root().join("src"),
            assignment.join("reference"),
            assignment.join("scenes"),
        ] {
            add(&folder, &mut state)?;
        }
        Ok(Caster {
            pinhole,
            state,
            checkout,
        })
    }

    /// The film of a mistake.
    pub fn film(&self, slug: &str, scene: &str) -> Result<Film> {
        let checkout = self.checkout;
        let source = checkout.assignment().join("mistakes").join(slug);
        let mut hash = self.state.clone();
        hash.update(scene);
        add(&source, &mut hash)?;
        let key: String = hash
            .finalize()
            .iter()
            .take(8)
            .map(|byte| format!("{byte:02x}"))
            .collect();
        let films = checkout.scratch().join("films");
        let out = films.join(format!("{slug}.{key}"));
        let film = out.join("film.exr");
        if !film.is_file() {
            let answers = checkout.scratch().join("answers").join(slug);
            let _absent = fs::remove_dir_all(&answers);
            let reference = checkout.assignment().join("reference/src");
            copy_rust(&reference, &answers.join("src"))?;
            copy_rust(&source, &answers.join("src"))?;
            self.render(scene, &answers, &out)?.map_err(|said| {
                let problem = format!("it does not cast {scene}: {said}");
                let remedy = "make what is known again: cargo run --release -- golden mistakes";
                Problem::of(checkout.inside(&source), problem, remedy)
            })?;
        }
        Ok(Film::read(&film)?)
    }

    /// Casts a scene with these answers; or gives what is said instead.
    fn render(
        &self,
        scene: &str,
        answers: &Path,
        out: &Path,
    ) -> Result<std::result::Result<(), String>> {
        let output = Command::new(&self.pinhole)
            .args(["render", scene, "--submission"])
            .arg(answers)
            .arg("--out")
            .arg(out)
            .output()
            .map_err(|error| Error::file(&self.pinhole, &error))?;
        Ok(match output.status.success() {
            true => Ok(()),
            false => Err(String::from_utf8_lossy(&output.stderr).into_owned()),
        })
    }
}

/// Adds all files of a folder to a hash.
fn add(folder: &Path, hash: &mut Sha256) -> Result<()> {
    for file in pages_files(folder)? {
        hash.update(fs::read(&file).map_err(|error| Error::file(&file, &error))?);
    }
    Ok(())
}
