//! Searches the files to be handed out for anything that students must not get.
//!
//! The files are chosen so that nothing secret is among them. This check helps if someone quotes
//! an answer in a comment, or names a withheld scene in a README.

mod search;

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

use search::Search;

use super::Files;
use super::sources::{read, read_text};
use pinhole::Scene;
use pinhole_course::assignment::Assignment;
use pinhole_course::error::{Error, Result};
use pinhole_course::{manifest, stubs};

/// Shorter lines of an answer, such as `return None;`, give nothing away.
const LEAST_LINE: usize = 24;

/// Refuses files that contain a line of one of our answers, or anything of a withheld scene.
pub fn refuse(files: &Files, assignment: &Assignment) -> Result<()> {
    let answers = Search::new(answer_lines(assignment)?);
    let withheld = WithheldScenes::of(assignment)?;
    for (path, bytes) in files {
        if let Some(line) = answers.first_in(bytes) {
            return Err(Error::input(
                format!("{path} would give away a line of the reference: `{line}`"),
                "rewrite that line, or leave it out",
            ));
        }
        if let Some(what) = withheld.shown_by(path, bytes) {
            return Err(Error::input(
                format!("{path} would give away {what}"),
                "remove it from that file, or withhold another scene",
            ));
        }
    }
    Ok(())
}

/// The lines of the reference's answers that are not in its stubs.
fn answer_lines(assignment: &Assignment) -> Result<BTreeSet<String>> {
    let public: String = stubs::generate(assignment)?.into_values().collect();
    let public: BTreeSet<&str> = public.lines().map(str::trim).collect();
    let mut lines = BTreeSet::new();
    for task in &assignment.tasks {
        let text = read_text(&assignment.reference().join("src").join(task.file()))?;
        let own = text.lines().map(str::trim);
        // A line that opens a block, such as `match camera.projection {`, gives no answer away.
        let tells = |line: &&str| {
            line.len() >= LEAST_LINE && !line.ends_with('{') && !line.starts_with("// ANCHOR")
        };
        let own = own.filter(tells);
        lines.extend(own.filter(|line| !public.contains(line)).map(str::to_owned));
    }
    Ok(lines)
}

/// What would give withheld scenes away.
struct WithheldScenes {
    names: Vec<String>,
    /// The hashes of their files, in hexadecimal.
    hashes: BTreeSet<String>,
    /// The hashes again, to be searched for in other files.
    hash_search: Search,
}

impl WithheldScenes {
    fn of(assignment: &Assignment) -> Result<WithheldScenes> {
        let mut hashes = BTreeSet::new();
        let public = assignment.scenes.iter().filter(|scene| scene.public);
        let public_meshes: Vec<_> = public
            .flat_map(|scene| Scene::files(&assignment.scene(&scene.name)))
            .collect();
        for scene in assignment.withheld_scenes() {
            let file = assignment.scene(&scene.name);
            let mut meshes = Scene::files(&file);
            meshes.retain(|mesh| !public_meshes.contains(mesh));
            for path in meshes.into_iter().chain([file]) {
                hashes.insert(manifest::hash_of(&path, read(&path)?));
            }
        }
        let entries = fs::read_dir(assignment.golden());
        for path in entries
            .into_iter()
            .flatten()
            .flatten()
            .map(|entry| entry.path())
        {
            let name = path.file_name().unwrap_or_default().to_string_lossy();
            if assignment.withholds(&name) {
                hashes.insert(manifest::hash_of(&path, read(&path)?));
            }
        }
        let names = assignment.withheld_scenes().map(|scene| scene.name.clone());
        let names = names.collect();
        let hash_search = Search::new(hashes.clone());
        Ok(WithheldScenes {
            names,
            hashes,
            hash_search,
        })
    }

    /// What a file gives away, as a sentence for the instructor.
    fn shown_by(&self, path: &str, bytes: &[u8]) -> Option<String> {
        if self.names.is_empty() {
            return None;
        }
        let own = manifest::hash_of(Path::new(path), bytes.to_vec());
        if self.hashes.contains(&own) {
            return Some("a file of a withheld scene".into());
        }
        if self.hash_search.first_in(bytes).is_some() {
            return Some("the hash of a withheld scene's file".into());
        }
        // Sources may use a scene's name as any word, but files about scenes may not.
        let is_source = path.starts_with("src/") || path.starts_with("tools/");
        let words = |name: &str| path.contains(name) || !is_source && holds_word(bytes, name);
        let name = self.names.iter().find(|name| words(name));
        name.map(|name| format!("the name of the withheld scene `{name}`"))
    }
}

/// Whether a file of any kind contains this word.
pub fn holds_word(bytes: &[u8], word: &str) -> bool {
    let mut words = bytes.split(|byte| !byte.is_ascii_alphanumeric() && *byte != b'_');
    words.any(|found| found == word.as_bytes())
}
