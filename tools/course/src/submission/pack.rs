//! Packs the answers, and nothing else, into a ZIP file to hand in.

use std::fs::Metadata;
use std::io::{Cursor, Write};
use std::path::Path;

use zip::ZipWriter;
use zip::write::SimpleFileOptions;

use super::Submission;
use crate::assignment::Assignment;
use crate::error::{Error, Result, ResultExt};
use crate::output;

impl Submission {
    /// Writes the answers and the examples to a ZIP file, and returns how many files they are.
    /// Replaces an existing file only if it holds answers too.
    ///
    /// # Errors
    /// If the path holds something else, or the file cannot be written.
    pub fn pack(&self, path: &Path, assignment: &Assignment) -> Result<usize> {
        let there = path.symlink_metadata();
        let is_ours =
            |about: &Metadata| about.is_file() && Submission::find(path, assignment).is_ok();
        if there.is_ok_and(|about| !is_ours(&about)) {
            return Err(Error::input(
                format!(
                    "{} already exists, and is a link or holds no answers",
                    path.display()
                ),
                "name another file with --pack",
            ));
        }
        let failed = Error::input(
            format!("cannot write {}", path.display()),
            "name a file in a folder you may write to",
        );
        let files = self.files();
        let files = files.filter_map(|(name, text)| Some((name, text.as_ref().ok()?)));
        let files: Vec<(String, &String)> = files.collect();
        let mut zip = ZipWriter::new(Cursor::new(Vec::new()));
        for (name, text) in &files {
            zip.start_file(name, SimpleFileOptions::default())
                .or_fail(&failed)?;
            zip.write_all(text.as_bytes()).or_fail(&failed)?;
        }
        let bytes = zip.finish().or_fail(&failed)?.into_inner();
        output::write(path, &bytes).or_fail(&failed)?;
        Ok(files.len())
    }
}

#[cfg(test)]
mod tests {
    use std::fs;

    use super::*;
    use crate::checkout::Checkout;

    #[test]
    fn a_packed_submission_is_found_again_and_nothing_else_is_overwritten() {
        let checkout = Checkout::find().unwrap();
        let name = checkout.default_assignment().unwrap();
        let assignment = Assignment::read(&checkout, &name).unwrap();
        let submission = Submission::find(&assignment.handout(), &assignment).unwrap();
        let folder = tempfile::tempdir().unwrap();
        let zip = folder.path().join("answers.zip");
        for _ in 0..2 {
            let packed = submission.pack(&zip, &assignment).unwrap();
            assert_eq!(packed, assignment.tasks.len());
        }
        let found = Submission::find(&zip, &assignment).unwrap();
        assert_eq!(found.answers, submission.answers);
        let notes = folder.path().join("notes.txt");
        fs::write(&notes, "mine").unwrap();
        assert!(submission.pack(&notes, &assignment).is_err());
        assert_eq!(fs::read_to_string(notes).unwrap(), "mine");
        #[cfg(unix)]
        {
            let link = folder.path().join("link.zip");
            std::os::unix::fs::symlink(&zip, &link).unwrap();
            assert!(submission.pack(&link, &assignment).is_err());
        }
    }
}
