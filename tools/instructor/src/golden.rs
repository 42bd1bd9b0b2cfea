//! `pinhole golden`: make goldens with Mitsuba, and verify them.

pub mod arguments;
mod mistake_films;

use std::ffi::{OsStr, OsString};
use std::fs;
use std::path::{Path, PathBuf};

use pinhole::Scene;
use pinhole::judge::Golden as GoldenFilm;
use serde_json::json;

use arguments::{Golden, GoldenMistakes, GoldenRender, GoldenVerify};
use pinhole_course::assignment::Assignment;
use pinhole_course::checkout::Checkout;
use pinhole_course::diagnosis::known::KnownMistakes;
use pinhole_course::error::{Error, Result, ResultExt};
use pinhole_course::goldens::Goldens;
use pinhole_course::manifest::Manifest;
use pinhole_course::mitsuba::{self, Rendered};
use pinhole_course::progress::Progress;
use pinhole_course::run_options::AssignmentOption;
use pinhole_report::program::Status;

/// The seed of the committed probes and ties.
const COMMITTED_SEED: u64 = 1;

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
        Golden::Verify(arguments) => verify(&find(&arguments.assignment)?, checkout, arguments),
    }
}

/// Fingerprints the mistakes anew on goldens that stay as they are.
fn mistakes(
    assignment: &Assignment,
    checkout: &Checkout,
    arguments: &GoldenMistakes,
) -> Result<Status> {
    let own = assignment.golden();
    let folder = arguments.dir.as_ref().unwrap_or(&own);
    let mut manifest = Manifest::read(folder)?;
    let scenes = manifest.scenes(folder, assignment);
    let said = fingerprint(&mut manifest, folder, &scenes, assignment, checkout)?;
    manifest.write(folder)?;
    anstream::println!("{said}");
    Ok(Status::Well)
}

/// Keeps the known mistakes' fingerprints on these scenes, and on the probes if the
/// folder has any.
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
    manifest.set_mistakes(&written, folder, assignment)?;
    let mistakes = KnownMistakes::read(folder)?.mistake.len();
    Ok(format!(
        "{mistakes} mistakes show in {} films",
        written.len()
    ))
}

fn render(
    assignment: &Assignment,
    checkout: &Checkout,
    arguments: &GoldenRender,
) -> Result<Status> {
    for said in make(assignment, checkout, arguments)? {
        anstream::println!("{said}");
    }
    Ok(Status::Well)
}

/// Renders what is asked for; what there is to say of it, line by line.
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
            "goldens of scenes that are not the assignment's need a folder of their own",
            "say where: --out DIR",
        ));
    }
    for scene in &scenes {
        Scene::read(scene)?;
    }
    fs::create_dir_all(&folder).or_input(
        format_args!("cannot make {}", folder.display()),
        "name a folder you may write to",
    )?;

    let progress = Progress::new();
    progress.say("Mitsuba");
    // All of the assignment's at once leave nothing of the old ones.
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
        let rendered = python(checkout, line, &folder, &progress)?;
        enter(&mut manifest, &rendered, &folder)?;
        let made = |scene: &&PathBuf| {
            let stem = scene.file_stem().unwrap_or_default();
            rendered.items.iter().any(|item| *item.name == *stem)
        };
        for scene in scenes.iter().filter(made) {
            manifest.add_scene(scene, &folder, assignment)?;
        }
        if let Some(refusal) = rendered.refusal {
            manifest.set_scripts(&folder, assignment, checkout)?;
            manifest.write(&folder)?;
            return Err(refusal);
        }
    }
    if let Some(seed) = arguments.seed {
        let line = drawn("random-scenes", assignment, seed);
        let rendered = python(checkout, line, &folder, &progress)?;
        enter(&mut manifest, &rendered, &folder)?;
        for item in &rendered.items {
            let scene = folder
                .join("scenes")
                .join(&item.name)
                .with_extension("toml");
            manifest.add_scene(&scene, &folder, assignment)?;
        }
    }
    if arguments.scenes.is_empty() {
        let seed = arguments.seed.unwrap_or(COMMITTED_SEED);
        let line = drawn("questions", assignment, seed);
        let rendered = python(checkout, line, &folder, &progress)?;
        enter(&mut manifest, &rendered, &folder)?;
        manifest.probe_seed = Some(seed);
    }
    if whole {
        let line = drawn("ties", assignment, COMMITTED_SEED);
        let rendered = python(checkout, line, &folder, &progress)?;
        enter(&mut manifest, &rendered, &folder)?;
    }
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
                    "name a TOML file or a scene",
                )
            })
    };
    arguments.scenes.iter().map(find).collect()
}

/// The arguments with which the scripts draw something of the assignment from a seed.
fn drawn(what: &str, assignment: &Assignment, seed: u64) -> Vec<OsString> {
    let folder = assignment.folder.clone().into();
    let seed = seed.to_string().into();
    vec![what.into(), folder, "--seed".into(), seed]
}

fn python(
    checkout: &Checkout,
    mut line: Vec<OsString>,
    folder: &Path,
    progress: &Progress,
) -> Result<Rendered> {
    line.extend(["--out".into(), folder.into()]);
    let line: Vec<&OsStr> = line.iter().map(OsString::as_os_str).collect();
    mitsuba::render(checkout, &line, progress)
}

fn enter(manifest: &mut Manifest, rendered: &Rendered, folder: &Path) -> Result<()> {
    manifest.set_renderer(&rendered.renderer);
    let films = rendered.items.iter().flat_map(|item| &item.files);
    let films = films.filter(|file| file.extension().is_some_and(|extension| extension == "exr"));
    films
        .into_iter()
        .try_for_each(|film| manifest.add_film(film, folder))
}

fn verify(
    assignment: &Assignment,
    checkout: &Checkout,
    arguments: &GoldenVerify,
) -> Result<Status> {
    let own = assignment.golden();
    let folder = arguments.dir.as_ref().unwrap_or(&own);
    let manifest = Manifest::read(folder)?;
    let mut problems = manifest.out_of_step(folder, assignment, checkout)?;
    problems.extend(unusable(&manifest, folder));
    if inside(folder, &own) {
        problems.extend(absent(&manifest, assignment));
    }
    let films = manifest.films.len();
    if arguments.json {
        anstream::println!(
            "{:#}",
            json!({ "films": films, "mitsuba": manifest.mitsuba, "problems": problems })
        );
    } else {
        for problem in &problems {
            anstream::println!("{problem}");
        }
        match problems.len() {
            0 => anstream::println!("{films} films by Mitsuba {} are in step", manifest.mitsuba),
            _ => anstream::println!("make them again: cargo pinhole golden render"),
        }
    }
    Ok(if problems.is_empty() {
        Status::Well
    } else {
        Status::JudgedWrong
    })
}

/// Goldens that cannot judge: unreadable, not fitting their tolerance, or too lenient.
fn unusable(manifest: &Manifest, folder: &Path) -> Vec<String> {
    let others = [".tol.exr", ".ask.exr", ".mistakes.exr", ".toml"];
    let is_golden = |name: &&String| !others.iter().any(|end| name.ends_with(end));
    let goldens = manifest.films.keys().filter(is_golden);
    goldens
        .filter_map(|name| GoldenFilm::read(&folder.join(name)).err())
        .map(|error| error.to_string())
        .collect()
}

/// Whether two ways of writing a path lead into the same folder.
fn inside(path: &Path, folder: &Path) -> bool {
    let real = |path: &Path| path.canonicalize().unwrap_or(path.into());
    real(path).starts_with(real(folder))
}

/// Goldens the assignment needs and the manifest lacks.
fn absent(manifest: &Manifest, assignment: &Assignment) -> Vec<String> {
    let scenes = assignment
        .scenes
        .iter()
        .map(|scene| format!("{}.exr", scene.name));
    let groups = assignment.tasks.iter().flat_map(|task| {
        let groups = task.points.iter().map(|points| &points.group);
        groups
            .filter(|group| *group != "scenes")
            .map(|group| format!("probes/{}.{group}.exr", task.name))
    });
    let needed = scenes
        .chain(groups)
        .filter(|name| !manifest.films.contains_key(name));
    needed
        .map(|name| format!("{name} is needed by assignment.toml, but was never made"))
        .collect()
}
