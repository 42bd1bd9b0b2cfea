//! `pinhole golden`: makes goldens with Mitsuba, and verifies them.

pub mod arguments;
mod mistake_films;
mod test_films;
mod verify;

use std::ffi::{OsStr, OsString};
use std::fs;
use std::path::{Path, PathBuf};

use pinhole::Scene;

use arguments::{Golden, GoldenMistakes, GoldenRender};
use pinhole_course::assignment::Assignment;
use pinhole_course::checkout::Checkout;
use pinhole_course::diagnosis::known::KnownMistakes;
use pinhole_course::error::{Error, Result, ResultExt};
use pinhole_course::goldens::Goldens;
use pinhole_course::manifest::Manifest;
use pinhole_course::mitsuba::{self, RenderResult};
use pinhole_course::output;
use pinhole_course::private::{is_private, make_private};
use pinhole_course::progress::Progress;
use pinhole_course::run_options::AssignmentOption;
use pinhole_course::seed::Seed;
use pinhole_course::shell::in_shell;
use pinhole_report::program::Status;

/// The seed of the committed questions and ties.
const COMMITTED_SEED: Seed = Seed(1);

pub fn run(checkout: &Checkout, arguments: &Golden) -> Result<Status> {
    let find = |option: &AssignmentOption| option.find(checkout, None);
    match arguments {
        Golden::Setup => {
            anstream::eprintln!("installing Mitsuba and oiiotool, about 200 MB …");
            mitsuba::setup(checkout)?;
            anstream::println!("{} is ready", mitsuba::environment(checkout).display());
            Ok(Status::Well)
        }
        Golden::Render(arguments) => render(&find(&arguments.assignment)?, checkout, arguments),
        Golden::Mistakes(arguments) => mistakes(&find(&arguments.assignment)?, checkout, arguments),
        Golden::Verify(arguments) => {
            verify::verify(&find(&arguments.assignment)?, checkout, arguments)
        }
    }
}

/// Fingerprints the mistakes again. The goldens stay as they are.
fn mistakes(
    assignment: &Assignment,
    checkout: &Checkout,
    arguments: &GoldenMistakes,
) -> Result<Status> {
    let own = assignment.golden();
    let folder = arguments.dir.as_ref().unwrap_or(&own);
    output::refuse_links(folder)?;
    let mut manifest = Manifest::read(folder)?;
    let scenes = manifest.scenes(folder, assignment);
    let said = fingerprint(&mut manifest, folder, &scenes, assignment, checkout)?;
    manifest.write(folder)?;
    anstream::println!("{said}");
    Ok(Status::Well)
}

/// Stores the known mistakes' fingerprints for these scenes, and for the questions if the folder
/// has any. Also stores how many tests the reference takes for the scenes.
fn fingerprint(
    manifest: &mut Manifest,
    folder: &Path,
    scenes: &[PathBuf],
    assignment: &Assignment,
    checkout: &Checkout,
) -> Result<String> {
    let goldens = Goldens::of_scenes(folder, scenes)?;
    let progress = Progress::new();
    let probes = manifest.probe_seed.is_some();
    let written = mistake_films::make(assignment, &goldens, probes, checkout, &progress)?;
    progress.clear();
    for film in test_films::make(assignment, &goldens, checkout)? {
        manifest.add_film(&film, folder)?;
    }
    manifest.set_mistakes(&written, folder, assignment)?;
    let mistakes = KnownMistakes::read(folder)?.mistake.len();
    Ok(format!(
        "stored the changes that each of {mistakes} known mistakes makes in {} films",
        written.len()
    ))
}

fn render(
    assignment: &Assignment,
    checkout: &Checkout,
    arguments: &GoldenRender,
) -> Result<Status> {
    refuse_unforced(assignment, arguments)?;
    for said in make(assignment, checkout, arguments)? {
        anstream::println!("{said}");
    }
    Ok(Status::Well)
}

/// Refuses to replace the assignment's own films without `--force`, because every mark depends on
/// them.
fn refuse_unforced(assignment: &Assignment, arguments: &GoldenRender) -> Result<()> {
    if let Some(out) = &arguments.out {
        output::refuse_links(out)?;
    }
    let own = assignment.golden();
    let folder = arguments.out.as_ref().unwrap_or(&own);
    let films = Manifest::read_or_new(folder)?.films;
    let replaced: Vec<String> = match arguments.scenes.is_empty() {
        true => films.into_keys().collect(),
        false => scenes(arguments, assignment)?
            .iter()
            .filter_map(|scene| Some(format!("{}.exr", scene.file_stem()?.to_str()?)))
            .filter(|film| films.contains_key(film))
            .collect(),
    };
    if arguments.force || replaced.is_empty() || !inside(folder, &own) {
        return Ok(());
    }
    Err(Error::input(
        format!(
            "{} already contains {} films that this command would replace",
            folder.display(),
            replaced.len()
        ),
        "to replace them, pass --force; to write to another folder, pass --out DIR",
    ))
}

/// Renders what is asked for, and returns the lines to print.
pub fn make(
    assignment: &Assignment,
    checkout: &Checkout,
    arguments: &GoldenRender,
) -> Result<Vec<String>> {
    let own = assignment.golden();
    let folder = arguments.out.clone().unwrap_or_else(|| own.clone());
    let scenes = scenes(arguments, assignment)?;
    let is_own = |scene: &PathBuf| inside(scene, &assignment.folder);
    if arguments.out.is_none() && !scenes.iter().all(is_own) {
        return Err(Error::input(
            "not all of these scenes belong to the assignment, so their goldens need another folder",
            "name one with --out DIR",
        ));
    }
    for scene in &scenes {
        Scene::read(scene)?;
    }
    let cannot_make = Error::input(
        format!("cannot make {}", folder.display()),
        "name a folder you may write to",
    );
    fs::create_dir_all(&folder).or_fail(&cannot_make)?;
    // Nobody may read fresh questions before they are asked.
    if arguments.out.is_some() && arguments.seed.is_some() {
        let is_empty = fs::read_dir(&folder)
            .or_fail(&cannot_make)?
            .next()
            .is_none();
        if is_empty {
            make_private(&folder).or_fail(&cannot_make)?;
        }
        if !is_private(&folder) {
            return Err(Error::input(
                format!("others on this machine can read {}", folder.display()),
                format!(
                    "name a new folder with --out, or, if this one is yours: chmod go-rwx {}",
                    in_shell(&folder.display().to_string())
                ),
            ));
        }
    }

    let progress = Progress::new();
    progress.say("Mitsuba");
    // Move films to their places only when all are made, so that a failure leaves the old ones.
    let staging = folder.join(".rendering");
    let _left_by_a_run_that_was_stopped = fs::remove_dir_all(&staging);
    fs::create_dir_all(&staging).or_fail(&Error::file(&staging))?;
    // If all of the assignment's films are made again, none of the old ones stays in the manifest.
    let whole = arguments.scenes.is_empty() && arguments.seed.is_none();
    let mut manifest = if whole {
        Manifest::default()
    } else {
        Manifest::read_or_new(&folder)?
    };
    manifest.refuse_other_scripts(&folder, assignment, checkout)?;
    if !scenes.is_empty() {
        let mut line: Vec<OsString> = vec!["scenes".into()];
        line.extend(scenes.iter().map(OsString::from));
        let rendered = python(checkout, line, None, &staging, &progress)?;
        enter(&mut manifest, &rendered, &staging)?;
        let made = |scene: &&PathBuf| {
            let stem = scene.file_stem().unwrap_or_default();
            rendered.items.iter().any(|item| *item.name == *stem)
        };
        for scene in scenes.iter().filter(made) {
            manifest.add_scene(scene, &folder, assignment)?;
        }
        if let Some(refusal) = rendered.refusal {
            publish(&staging, &folder)?;
            manifest.set_scripts(&folder, assignment, checkout)?;
            manifest.write(&folder)?;
            return Err(refusal);
        }
    }
    if let Some(seed) = arguments.seed {
        let line = drawn("random-scenes", assignment);
        let rendered = python(checkout, line, Some(seed), &staging, &progress)?;
        enter(&mut manifest, &rendered, &staging)?;
        for item in &rendered.items {
            let scene = staging
                .join("scenes")
                .join(&item.name)
                .with_extension("toml");
            manifest.add_scene(&scene, &staging, assignment)?;
        }
    }
    if arguments.scenes.is_empty() {
        let (what, seed) = match arguments.seed {
            Some(seed) => ("fresh-questions", seed),
            None => ("questions", COMMITTED_SEED),
        };
        let line = drawn(what, assignment);
        let rendered = python(checkout, line, Some(seed), &staging, &progress)?;
        enter(&mut manifest, &rendered, &staging)?;
        manifest.probe_seed = Some(seed);
    }
    if whole {
        let line = drawn("ties", assignment);
        let rendered = python(checkout, line, Some(COMMITTED_SEED), &staging, &progress)?;
        enter(&mut manifest, &rendered, &staging)?;
    }
    publish(&staging, &folder)?;
    manifest.set_scripts(&folder, assignment, checkout)?;
    manifest.write(&folder)?;
    progress.clear();
    let mut said = vec![format!(
        "{} films in {}",
        manifest.films.len(),
        folder.display()
    )];
    if !arguments.no_mistakes {
        let scenes = match arguments.scenes.is_empty() {
            true => manifest.scenes(&folder, assignment),
            false => scenes,
        };
        said.push(fingerprint(
            &mut manifest,
            &folder,
            &scenes,
            assignment,
            checkout,
        )?);
        manifest.write(&folder)?;
    }
    Ok(said)
}

/// Moves everything that was made into its place.
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

/// The scene files to render: those named, or all of the assignment's.
fn scenes(arguments: &GoldenRender, assignment: &Assignment) -> Result<Vec<PathBuf>> {
    if arguments.seed.is_some() {
        return Ok(Vec::new());
    }
    if arguments.scenes.is_empty() {
        return Ok(assignment
            .scenes
            .iter()
            .map(|scene| assignment.scene(&scene.name))
            .collect());
    }
    let find = |named: &String| {
        let candidates = [PathBuf::from(named), assignment.scene(named)];
        candidates
            .into_iter()
            .find(|path| path.is_file())
            .ok_or_else(|| {
                Error::input(
                    format!("there is no scene {named}"),
                    "name a scene file, or a scene of the assignment",
                )
            })
    };
    arguments.scenes.iter().map(find).collect()
}

/// The arguments that make the scripts draw scenes, questions or ties from a seed.
fn drawn(what: &str, assignment: &Assignment) -> Vec<OsString> {
    vec![what.into(), assignment.folder.clone().into()]
}

fn python(
    checkout: &Checkout,
    mut line: Vec<OsString>,
    seed: Option<Seed>,
    folder: &Path,
    progress: &Progress,
) -> Result<RenderResult> {
    line.extend(["--out".into(), folder.into()]);
    let line: Vec<&OsStr> = line.iter().map(OsString::as_os_str).collect();
    mitsuba::render(checkout, &line, seed, progress)
}

fn enter(manifest: &mut Manifest, rendered: &RenderResult, folder: &Path) -> Result<()> {
    manifest.set_renderer(&rendered.renderer);
    let films = rendered.items.iter().flat_map(|item| &item.files);
    let films = films.filter(|file| file.extension().is_some_and(|extension| extension == "exr"));
    films
        .into_iter()
        .try_for_each(|film| manifest.add_film(film, folder))
}

/// Whether a path is inside a folder, however both are spelt.
fn inside(path: &Path, folder: &Path) -> bool {
    let real = |path: &Path| path.canonicalize().unwrap_or(path.into());
    real(path).starts_with(real(folder))
}
