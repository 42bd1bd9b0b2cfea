//! One run of the scripts that make goldens.

use std::ffi::{OsStr, OsString};
use std::fs;
use std::path::{Path, PathBuf};

use pinhole_course::assignment::Assignment;
use pinhole_course::checkout::Checkout;
use pinhole_course::error::{Error, Result, ResultExt};
use pinhole_course::manifest::Manifest;
use pinhole_course::mitsuba::{self, Item, RenderResult};
use pinhole_course::progress::Progress;
use pinhole_course::seed::Seed;

/// Makes goldens beside their folder, and moves them there only when all are made, so that a failure
/// leaves the old ones.
pub struct Rendering<'a> {
    assignment: &'a Assignment,
    checkout: &'a Checkout,
    folder: &'a Path,
    staging: PathBuf,
    /// Whether all goldens of the folder are made again.
    whole: bool,
    manifest: Manifest,
    progress: Progress,
}

impl<'a> Rendering<'a> {
    /// Begins with the films of `folder`, unless the `whole` folder is made again: then none of the
    /// old ones stays in its manifest.
    pub fn new(
        assignment: &'a Assignment,
        checkout: &'a Checkout,
        folder: &'a Path,
        whole: bool,
    ) -> Result<Rendering<'a>> {
        let manifest = match whole {
            true => Manifest::default(),
            false => Manifest::read_or_new(folder)?,
        };
        manifest.refuse_other_scripts(folder, assignment, checkout)?;
        let progress = Progress::new();
        progress.say("Mitsuba");
        let staging = folder.join(".rendering");
        let _left_by_a_run_that_was_stopped = fs::remove_dir_all(&staging);
        fs::create_dir_all(&staging).or_fail(&Error::file(&staging))?;
        Ok(Rendering {
            assignment,
            checkout,
            folder,
            staging,
            whole,
            manifest,
            progress,
        })
    }

    /// Renders scene files. If the scripts refuse one, keeps the goldens of the others, unless the whole
    /// folder is made again.
    pub fn scenes(mut self, scenes: &[PathBuf]) -> Result<Rendering<'a>> {
        if scenes.is_empty() {
            return Ok(self);
        }
        let named = scenes.iter().map(OsString::from);
        let rendered = self.run("scenes", named.collect(), None)?;
        let made = |scene: &&PathBuf| {
            let stem = scene.file_stem().unwrap_or_default();
            rendered.items.iter().any(|item| *item.name == *stem)
        };
        for scene in scenes.iter().filter(made) {
            self.manifest
                .add_scene(scene, self.folder, self.assignment)?;
        }
        match rendered.refusal {
            None => Ok(self),
            Some(refusal) if self.whole => Err(refusal),
            Some(refusal) => self.publish().and(Err(refusal)),
        }
    }

    /// Draws scenes, and renders them.
    pub fn random_scenes(&mut self, seed: Seed) -> Result<()> {
        for item in self.draw("random-scenes", seed)? {
            let scenes = self.staging.join("scenes");
            let scene = scenes.join(&item.name).with_extension("toml");
            self.manifest
                .add_scene(&scene, &self.staging, self.assignment)?;
        }
        Ok(())
    }

    /// Draws questions, which are public or `fresh`.
    pub fn questions(&mut self, seed: Seed, fresh: bool) -> Result<()> {
        let what = match fresh {
            true => "fresh-questions",
            false => "questions",
        };
        self.draw(what, seed)?;
        self.manifest.probe_seed = Some(seed);
        Ok(())
    }

    /// Draws ties.
    pub fn ties(&mut self, seed: Seed) -> Result<()> {
        self.draw("ties", seed).map(drop)
    }

    /// Moves everything that was made into its place, and writes the manifest.
    pub fn publish(mut self) -> Result<Manifest> {
        publish(&self.staging, self.folder)?;
        self.manifest
            .set_scripts(self.folder, self.assignment, self.checkout)?;
        self.manifest.write(self.folder)?;
        self.progress.clear();
        Ok(self.manifest)
    }

    fn draw(&mut self, what: &str, seed: Seed) -> Result<Vec<Item>> {
        let assignment = self.assignment.folder.clone().into();
        let rendered = self.run(what, vec![assignment], Some(seed))?;
        rendered.refusal.map_or(Ok(rendered.items), Err)
    }

    /// Runs the scripts, and lists their films in the manifest.
    fn run(&mut self, what: &str, of: Vec<OsString>, seed: Option<Seed>) -> Result<RenderResult> {
        let mut line: Vec<&OsStr> = vec![OsStr::new(what)];
        line.extend(of.iter().map(OsString::as_os_str));
        line.extend([OsStr::new("--out"), self.staging.as_os_str()]);
        let rendered = mitsuba::render(self.checkout, &line, seed, &self.progress)?;
        self.manifest.set_renderer(&rendered.renderer);
        let files = rendered.items.iter().flat_map(|item| &item.files);
        for film in files.filter(|file| file.extension() == Some(OsStr::new("exr"))) {
            self.manifest.add_film(film, &self.staging)?;
        }
        Ok(rendered)
    }
}

fn publish(from: &Path, to: &Path) -> Result<()> {
    let failed = Error::file(to);
    fs::create_dir_all(to).or_fail(&failed)?;
    for entry in fs::read_dir(from).or_fail(&failed)? {
        let entry = entry.or_fail(&failed)?;
        let place = to.join(entry.file_name());
        match entry.path().is_dir() {
            true => publish(&entry.path(), &place)?,
            false => fs::rename(entry.path(), &place).or_fail(&failed)?,
        }
    }
    fs::remove_dir(from).or_fail(&failed)
}
