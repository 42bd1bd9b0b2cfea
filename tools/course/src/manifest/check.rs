//! Checks that goldens are as their manifest says, and that what they were made from has not
//! changed.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

use super::hashes::{hash, is_film, mistake_hashes, slashed, source_hash};
use super::{Manifest, source};
use crate::assignment::Assignment;
use crate::checkout::Checkout;
use crate::error::{Error, Result};

impl Manifest {
    /// Refuses to add films to goldens that other versions of the scripts made.
    pub fn refuse_other_scripts(
        &self,
        folder: &Path,
        assignment: &Assignment,
        checkout: &Checkout,
    ) -> Result<()> {
        if self
            .of_other_scripts(folder, assignment, checkout)?
            .is_empty()
        {
            return Ok(());
        }
        Err(Error::input(
            format!(
                "the goldens in {} were made by other versions of the scripts",
                folder.display()
            ),
            "render all of them again, or name another folder with --out",
        ))
    }

    /// Refuses to grade with goldens that have changed.
    ///
    /// # Errors
    /// If a film or a scene has changed since the manifest was written.
    pub fn refuse_changed(&self, folder: &Path, assignment: &Assignment) -> Result<()> {
        let changed = self.changed_files(folder, assignment);
        let Some(first) = changed.first() else {
            return Ok(());
        };
        let more = match changed.len() {
            1 => String::new(),
            count => format!(", and {} more", count - 1),
        };
        Err(Error::input(
            format!(
                "the goldens in {} can't be used for grading: {first}{more}",
                folder.display()
            ),
            "restore them: git checkout -- golden",
        ))
    }

    /// Everything that differs from the manifest.
    ///
    /// # Errors
    /// If the scripts are there but cannot be compared.
    pub fn out_of_step(
        &self,
        folder: &Path,
        assignment: &Assignment,
        checkout: &Checkout,
    ) -> Result<Vec<String>> {
        let mut problems = Vec::new();
        // Students have the fingerprints without the mistakes, and goldens can be made without
        // either.
        let mistakes = mistake_hashes(assignment).unwrap_or_default();
        if !mistakes.is_empty() && !self.mistakes.is_empty() && mistakes != self.mistakes {
            problems.push(
                "the mistakes have changed since the goldens were made; run: cargo pinhole golden \
                 mistakes"
                    .into(),
            );
        }
        // Students have neither the scripts nor their fingerprints.
        let others = match self.scripts.is_empty() {
            true => Vec::new(),
            false => self.of_other_scripts(folder, assignment, checkout)?,
        };
        if !others.is_empty() {
            let others = others.join(", ");
            problems.push(format!("the scripts have changed since they made {others}"));
        }
        problems.extend(self.changed_files(folder, assignment));
        let known: BTreeSet<&String> = self.films.keys().collect();
        for place in ["", "probes", "ties"] {
            let entries = fs::read_dir(folder.join(place))
                .into_iter()
                .flatten()
                .flatten();
            for path in entries
                .map(|entry| entry.path())
                .filter(|path| is_film(path))
            {
                let name = slashed(path.strip_prefix(folder).unwrap_or(&path));
                if !known.contains(&name) {
                    problems.push(format!("{name} is not in the manifest"));
                }
            }
        }
        Ok(problems)
    }

    /// The scenes and tasks whose films were made by other versions of the scripts.
    fn of_other_scripts(
        &self,
        folder: &Path,
        assignment: &Assignment,
        checkout: &Checkout,
    ) -> Result<Vec<String>> {
        let now = self.script_fingerprints(folder, assignment, checkout)?;
        let is_other = |(name, now): &(String, String)| self.scripts.get(name) != Some(now);
        Ok(now
            .into_iter()
            .filter(is_other)
            .map(|(name, _)| name)
            .collect())
    }

    /// Films and scenes that have changed since the films were made.
    fn changed_files(&self, folder: &Path, assignment: &Assignment) -> Vec<String> {
        let sources = self.sources.iter().map(|(path, recorded)| {
            let source = source(path, folder, assignment);
            changed(source_hash(&source), path, recorded)
        });
        let films = self.films.iter();
        let films = films.map(|(path, recorded)| changed(hash(&folder.join(path)), path, recorded));
        sources.chain(films).flatten().collect()
    }
}

fn changed(hash: Result<String>, name: &str, recorded: &str) -> Option<String> {
    match hash {
        Err(_) => Some(format!("{name} is missing")),
        Ok(now) if now != recorded => {
            Some(format!("{name} has changed since the goldens were made"))
        }
        Ok(_) => None,
    }
}
