//! `pinhole golden`: makes goldens with Mitsuba, and verifies them.

pub mod arguments;
mod mistake_films;
mod rendering;
mod test_films;
mod verify;

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
use pinhole_course::mitsuba;
use pinhole_course::output;
use pinhole_course::private::{is_private, make_private};
use pinhole_course::progress::Progress;
use pinhole_course::run_options::AssignmentOption;
use pinhole_course::seed::Seed;
use pinhole_course::shell::in_shell;
use pinhole_report::program::Status;
use rendering::Rendering;

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
    let folder = arguments.out.clone().unwrap_or_else(|| assignment.golden());
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
    // Nobody may read fresh questions before they are asked.
    let is_secret = arguments.out.is_some() && arguments.seed.is_some();
    make_folder(&folder, is_secret)?;
    let whole = arguments.scenes.is_empty() && arguments.seed.is_none();
    let mut rendering = Rendering::new(assignment, checkout, &folder, whole)?.scenes(&scenes)?;
    if let Some(seed) = arguments.seed {
        rendering.random_scenes(seed)?;
    }
    if arguments.scenes.is_empty() {
        let seed = arguments.seed;
        rendering.questions(seed.unwrap_or(COMMITTED_SEED), seed.is_some())?;
    }
    if whole {
        rendering.ties(COMMITTED_SEED)?;
    }
    let mut manifest = rendering.publish()?;
    let films = manifest.films.len();
    let mut said = vec![format!("{films} films in {}", folder.display())];
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

/// Makes the folder for goldens, unless it exists. If they are secret, refuses a folder that others can
/// read.
fn make_folder(folder: &Path, is_secret: bool) -> Result<()> {
    let cannot_make = Error::input(
        format!("cannot make {}", folder.display()),
        "name a folder you may write to",
    );
    fs::create_dir_all(folder).or_fail(&cannot_make)?;
    if !is_secret {
        return Ok(());
    }
    let mut files = fs::read_dir(folder).or_fail(&cannot_make)?;
    if files.next().is_none() {
        make_private(folder).or_fail(&cannot_make)?;
    }
    if is_private(folder) {
        return Ok(());
    }
    Err(Error::input(
        format!("others on this machine can read {}", folder.display()),
        format!(
            "name a new folder with --out, or, if this one is yours: chmod go-rwx {}",
            in_shell(&folder.display().to_string())
        ),
    ))
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

/// Whether a path is inside a folder, however both are spelt.
fn inside(path: &Path, folder: &Path) -> bool {
    let real = |path: &Path| path.canonicalize().unwrap_or(path.into());
    real(path).starts_with(real(folder))
}
