//! `manifest.toml`: what goldens were made from and by, so that nothing can fall out
//! of step unnoticed.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

use pinhole::Scene;
use serde::{Deserialize, Serialize};
use sha2::{Digest, Sha256};

use crate::assignment::Assignment;
use crate::checkout::Checkout;
use crate::diagnosis::known;
use crate::error::{Error, Result, ResultExt};
use crate::mistake;
use crate::mitsuba::{self, Renderer};

/// The file's name in a folder of goldens.
pub const FILE: &str = "manifest.toml";

/// SHA-256 of files, in hexadecimal, by path.
pub type Hashes = BTreeMap<String, String>;

/// What a folder of goldens was made from.
#[derive(Clone, Debug, Default, Deserialize, PartialEq, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Manifest {
    /// Mitsuba's version.
    pub mitsuba: String,
    /// Its variant.
    pub variant: String,
    /// What the probes were drawn from.
    pub probe_seed: Option<u64>,
    /// Fingerprints of the scripts behind the films, by scene, by task of the probes, and
    /// of the ties.
    pub scripts: Hashes,
    /// Hashes of scenes (of what they say, not of comments and layout) and of meshes,
    /// relative to this folder or else to the course: see [`Assignment::course`].
    pub sources: Hashes,
    /// The known mistakes' sources, relative to the course.
    #[serde(default)]
    pub mistakes: Hashes,
    /// Every film, and what is known of mistakes, relative to this folder.
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
        toml::from_str(&text).map_err(|error| {
            let problem = format!("{}: {}", path.display(), error.message());
            Error::input(
                problem,
                "make the goldens again: cargo pinhole golden render",
            )
        })
    }

    /// Refuses to add to goldens that other scripts made.
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
                "the goldens in {} were made by other scripts",
                folder.display()
            ),
            "render all of them again, or name another folder with --out",
        ))
    }

    /// Enters who rendered.
    pub fn set_renderer(&mut self, renderer: &Renderer) {
        self.mitsuba = renderer.mitsuba.clone();
        self.variant = renderer.variant.clone();
    }

    /// Enters the scripts that made the films, as they are now.
    pub fn set_scripts(
        &mut self,
        folder: &Path,
        assignment: &Assignment,
        checkout: &Checkout,
    ) -> Result<()> {
        self.scripts = self.script_fingerprints(folder, assignment, checkout)?;
        Ok(())
    }

    /// The scenes and tasks whose films were made by other scripts than these.
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

    /// What the scripts behind the films are now.
    fn script_fingerprints(
        &self,
        folder: &Path,
        assignment: &Assignment,
        checkout: &Checkout,
    ) -> Result<Hashes> {
        let mut scenes = self.scenes(folder, assignment);
        scenes.retain(|scene| scene.is_file());
        let questions = self.probe_seed.map(|_| assignment.folder.as_path());
        mitsuba::fingerprints(checkout, &scenes, questions)
    }

    /// Enters a scene file and the meshes it names.
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

    /// Enters the mistakes whose fingerprints lie in `folder`, in place of any others,
    /// and what was written of them.
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

    /// Enters a film of `folder`.
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

    /// What stands in the file.
    pub fn text(&self) -> Result<String> {
        let text =
            toml::to_string(self).or_environment("cannot write a manifest", "report this")?;
        let head = "# Written by `pinhole golden render`; checked by `pinhole golden verify`.\n\n";
        Ok(format!("{head}{text}"))
    }

    /// Films and scenes that are not what they were when the films were made.
    fn changed_files(&self, folder: &Path, assignment: &Assignment) -> Vec<String> {
        let sources = self.sources.iter().map(|(path, recorded)| {
            let source = source(path, folder, assignment);
            changed(source_hash(&source), path, recorded)
        });
        let films = self.films.iter();
        let films = films.map(|(path, recorded)| changed(hash(&folder.join(path)), path, recorded));
        sources.chain(films).flatten().collect()
    }

    /// Refuses goldens that marks must not be made from.
    ///
    /// # Errors
    /// If a film or a scene has changed since.
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
                "goldens in {} cannot be judged by: {first}{more}",
                folder.display()
            ),
            "restore them (git checkout), or make them again: cargo pinhole golden render",
        ))
    }

    /// Everything that is not as the manifest says.
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
        // Students have the fingerprints without the mistakes, and goldens can be made
        // without either.
        let mistakes = mistake_hashes(assignment).unwrap_or_default();
        if !mistakes.is_empty() && !self.mistakes.is_empty() && mistakes != self.mistakes {
            problems.push(
                "the mistakes are not those that were fingerprinted: cargo pinhole golden mistakes"
                    .into(),
            );
        }
        // Students have neither the scripts nor what is recorded of them.
        let others = match self.scripts.is_empty() {
            true => Vec::new(),
            false => self.of_other_scripts(folder, assignment, checkout)?,
        };
        if !others.is_empty() {
            let others = others.join(", ");
            problems.push(format!("the scripts are not those that made {others}"));
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
}

/// Where a source lies that is recorded relative to the folder or the course.
fn source(recorded: &str, folder: &Path, assignment: &Assignment) -> PathBuf {
    let inside = folder.join(recorded);
    match inside.is_file() {
        true => inside,
        false => assignment.course().join(recorded),
    }
}

/// The answer files and words of every mistake that is fingerprinted.
fn mistake_hashes(assignment: &Assignment) -> Result<Hashes> {
    let mut hashes = Hashes::new();
    for mistake in mistake::read_all(assignment)? {
        let entries = fs::read_dir(&mistake.folder)
            .into_iter()
            .flatten()
            .flatten();
        let files = entries
            .map(|entry| entry.path())
            .filter(|path| path.is_file());
        for file in files.filter(|_| mistake.mistake.is_single()) {
            hashes.insert(
                relative(&file, assignment.course(), assignment),
                hash(&file)?,
            );
        }
    }
    Ok(hashes)
}

fn is_film(path: &Path) -> bool {
    path.extension().is_some_and(|extension| extension == "exr")
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

/// The hash of a file.
pub fn hash(path: &Path) -> Result<String> {
    let bytes = fs::read(path).or_input(
        format_args!("cannot read {}", path.display()),
        "restore the file",
    )?;
    Ok(hash_of(path, bytes))
}

/// The hash of a scene or a mesh. A scene is hashed as it is understood: its comments and
/// layout make no film stale.
fn source_hash(path: &Path) -> Result<String> {
    let scene = path
        .extension()
        .is_some_and(|extension| extension == "toml");
    let text = fs::read_to_string(path).ok().filter(|_| scene);
    match text.and_then(|text| text.parse::<toml::Table>().ok()) {
        Some(table) => Ok(hash_of(path, table.to_string().into())),
        None => hash(path),
    }
}

/// The hash of what a file holds. Text is hashed with `\n` line ends, as git may check it
/// out with others.
pub fn hash_of(path: &Path, mut bytes: Vec<u8>) -> String {
    let is_picture = path.extension().is_some_and(|extension| extension == "png");
    if !is_film(path) && !is_picture {
        bytes.retain(|byte| *byte != b'\r');
    }
    hex::encode(Sha256::digest(&bytes))
}

fn relative(path: &Path, folder: &Path, assignment: &Assignment) -> String {
    let absolute = path.canonicalize().unwrap_or(path.into());
    let within = |root: &Path| {
        let root = root.canonicalize().ok()?;
        absolute.strip_prefix(root).ok().map(slashed)
    };
    within(folder)
        .or_else(|| within(assignment.course()))
        .unwrap_or_else(|| slashed(&absolute))
}

fn slashed(path: &Path) -> String {
    path.to_string_lossy().replace('\\', "/")
}
