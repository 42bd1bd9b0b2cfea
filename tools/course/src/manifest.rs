//! `manifest.toml`: what goldens were made from, and by which programs, so that `golden verify`
//! notices changes.

mod check;
mod hashes;

use std::fs;
use std::path::{Path, PathBuf};

use pinhole::Scene;
use serde::{Deserialize, Serialize};

use crate::assignment::Assignment;
use crate::checkout::Checkout;
use crate::diagnosis::known;
use crate::error::{Result, ResultExt};
use crate::mitsuba::{self, QuestionSet, Renderer};
use crate::seed::Seed;

pub use self::hashes::{Hashes, hash, hash_of};
use self::hashes::{mistake_hashes, relative, slashed, source_hash};

/// The file's name in a folder of goldens.
pub const FILE: &str = "manifest.toml";

/// What a folder of goldens was made from.
#[derive(Clone, Debug, Default, Deserialize, PartialEq, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Manifest {
    /// Mitsuba's version.
    pub mitsuba: String,
    /// Its variant.
    pub variant: String,
    /// The seed that the questions were drawn from.
    pub probe_seed: Option<Seed>,
    /// Fingerprints of the scripts that make the films: by scene, by task of the questions, and
    /// for the ties.
    pub scripts: Hashes,
    /// Hashes of scenes (of their content, not of comments and layout) and of meshes, relative to
    /// this folder or else to the course: see [`Assignment::course`].
    pub sources: Hashes,
    /// The known mistakes' sources, relative to the course.
    #[serde(default)]
    pub mistakes: Hashes,
    /// Every film, and the files about mistakes, relative to this folder.
    pub films: Hashes,
}

impl Manifest {
    /// The manifest in `folder`, or an empty one.
    pub fn read_or_new(folder: &Path) -> Result<Manifest> {
        match folder.join(FILE).is_file() {
            true => Manifest::read(folder),
            false => Ok(Manifest::default()),
        }
    }

    /// The manifest in `folder`.
    pub fn read(folder: &Path) -> Result<Manifest> {
        let path = folder.join(FILE);
        let text = fs::read_to_string(&path).or_input(
            format_args!("cannot read {}", path.display()),
            "name a folder of goldens, made by `cargo pinhole golden render`",
        )?;
        toml::from_str(&text).or_input(
            path.display(),
            "restore the goldens: git checkout -- golden",
        )
    }

    /// Records the renderer.
    pub fn set_renderer(&mut self, renderer: &Renderer) {
        self.mitsuba = renderer.mitsuba.clone();
        self.variant = renderer.variant.clone();
    }

    /// Records the current fingerprints of the scripts that made the films.
    pub fn set_scripts(
        &mut self,
        folder: &Path,
        assignment: &Assignment,
        checkout: &Checkout,
    ) -> Result<()> {
        self.scripts = self.script_fingerprints(folder, assignment, checkout)?;
        Ok(())
    }

    /// Current fingerprints of the scripts that make the films.
    fn script_fingerprints(
        &self,
        folder: &Path,
        assignment: &Assignment,
        checkout: &Checkout,
    ) -> Result<Hashes> {
        let mut scenes = self.scenes(folder, assignment);
        scenes.retain(|scene| scene.is_file());
        let drawn = self.probe_seed.map(|_| match self.is_fresh() {
            true => QuestionSet::Fresh(&assignment.folder),
            false => QuestionSet::Public(&assignment.folder),
        });
        mitsuba::fingerprints(checkout, &scenes, drawn)
    }

    /// Whether questions and scenes were drawn for this folder. If so, it also holds its scenes.
    fn is_fresh(&self) -> bool {
        let mut sources = self.sources.keys();
        sources.any(|source| source.starts_with("scenes/"))
    }

    /// Records a scene file and the meshes it names.
    pub fn add_scene(
        &mut self,
        scene: &Path,
        folder: &Path,
        assignment: &Assignment,
    ) -> Result<()> {
        for path in [vec![scene.to_owned()], Scene::files(scene)].concat() {
            self.sources
                .insert(relative(&path, folder, assignment), source_hash(&path)?);
        }
        Ok(())
    }

    /// Records the mistakes whose fingerprints lie in `folder`, and the files of those
    /// fingerprints. Replaces earlier records of mistakes.
    pub fn set_mistakes(
        &mut self,
        written: &[PathBuf],
        folder: &Path,
        assignment: &Assignment,
    ) -> Result<()> {
        self.mistakes = mistake_hashes(assignment)?;
        let words = Some(Path::new(known::FILE)).filter(|file| folder.join(file).is_file());
        let written = written.iter().map(PathBuf::as_path).chain(words);
        written
            .into_iter()
            .try_for_each(|file| self.add_film(file, folder))
    }

    /// The scene files the films were made from.
    pub fn scenes(&self, folder: &Path, assignment: &Assignment) -> Vec<PathBuf> {
        let scenes = self.sources.keys().filter(|path| path.ends_with(".toml"));
        scenes
            .map(|path| source(path, folder, assignment))
            .collect()
    }

    /// Records a film of `folder`.
    pub fn add_film(&mut self, film: &Path, folder: &Path) -> Result<()> {
        self.films.insert(slashed(film), hash(&folder.join(film))?);
        Ok(())
    }

    /// Writes the manifest into `folder`.
    pub fn write(&self, folder: &Path) -> Result<()> {
        fs::write(folder.join(FILE), self.text()?).or_input(
            format_args!("cannot write {}", folder.join(FILE).display()),
            "name a folder you may write to",
        )
    }

    /// The text of the file.
    pub fn text(&self) -> Result<String> {
        let text =
            toml::to_string(self).or_environment("cannot write a manifest", "report this")?;
        let head = "# Written by `pinhole golden render`; checked by `pinhole golden verify`.\n\n";
        Ok(format!("{head}{text}"))
    }
}

/// The path of a source that is recorded relative to the folder or the course.
fn source(recorded: &str, folder: &Path, assignment: &Assignment) -> PathBuf {
    let inside = folder.join(recorded);
    match inside.is_file() {
        true => inside,
        false => assignment.course().join(recorded),
    }
}
