//! The parts of an assignment that students get: its stubs, tests, public scenes and
//! their goldens.

use std::fs;
use std::path::Path;

use super::leak::holds_word;
use super::sources::{read, read_text};
use super::{Files, place_of};
use pinhole::Scene;
use pinhole_course::assignment::Assignment;
use pinhole_course::diagnosis::known::{self, KnownMistakes};
use pinhole_course::error::{Error, Result, ResultExt};
use pinhole_course::manifest::{self, Manifest};
use pinhole_course::stubs;
use toml_edit::{DocumentMut, value};

/// Replaces a hint that mentions a withheld scene.
const ELSEWHERE: &str =
    "Look at the first thing that is wrong here, and follow it through your code by hand.";

/// The files of the assignment and of its goldens.
pub fn files(assignment: &Assignment) -> Result<Files> {
    let folder = place_of(assignment);
    let mut files = Files::new();
    let text = read_text(&assignment.folder.join("assignment.toml"))?;
    let text = without_withheld(&text, assignment)?;
    files.insert(format!("{folder}/assignment.toml"), text.into());
    let manifest = assignment.handout().join("Cargo.toml");
    files.insert(format!("{folder}/handout/Cargo.toml"), read(&manifest)?);
    for (path, text) in stubs::generate(assignment)? {
        let path = path.to_string_lossy().replace('\\', "/");
        // One copy is for the student to fill in. The other replaces answers that do not compile.
        files.insert(format!("{folder}/stubs/{path}"), text.clone().into());
        files.insert(format!("{folder}/handout/{path}"), text.into());
    }
    add_scenes(&mut files, assignment, &folder)?;
    add_tests(&mut files, assignment, &folder)?;
    add_goldens(&mut files, assignment)?;
    add_earlier_goldens(&mut files, assignment)?;
    Ok(files)
}

/// `assignment.toml` with the sum of the withheld scenes' points instead of those scenes.
fn without_withheld(text: &str, assignment: &Assignment) -> Result<String> {
    let withheld: u32 = assignment.withheld_scenes().map(|scene| scene.points).sum();
    if assignment.withheld_scenes().next().is_none() {
        return Ok(text.into());
    }
    let parsed: std::result::Result<DocumentMut, toml_edit::TomlError> = text.parse();
    let mut document = parsed.or_input("assignment.toml", "correct the assignment file")?;
    let mut points = value(i64::from(withheld));
    if let Some(scenes) = document["scene"].as_array_of_tables_mut() {
        scenes.retain(|scene| {
            !scene["name"]
                .as_str()
                .is_some_and(|name| assignment.withholds(name))
        });
    }
    if let Some(points) = points.as_value_mut() {
        points
            .decor_mut()
            .set_suffix(" # the points of scenes that are used only in grading");
    }
    document.insert("withheld", points);
    let finish = assignment.finish.as_ref();
    if finish.is_some_and(|finish| assignment.withholds(&finish.scene)) {
        document.remove("finish");
    }
    Ok(document.to_string())
}

fn public(assignment: &Assignment) -> impl Iterator<Item = &str> {
    let public = assignment.scenes.iter().filter(|scene| scene.public);
    public.map(|scene| scene.name.as_str())
}

/// The public scenes, the meshes they name, and the meshes' terms.
fn add_scenes(files: &mut Files, assignment: &Assignment, folder: &str) -> Result<()> {
    let scenes = assignment.folder.join("scenes");
    let mut add = |path: &Path| {
        let inside = path.strip_prefix(&assignment.folder).map_err(|_| {
            Error::input(
                format!("{} lies outside the assignment", path.display()),
                "put meshes of public scenes into the `scenes/meshes` folder",
            )
        })?;
        let inside = inside.to_string_lossy().replace('\\', "/");
        files.insert(format!("{folder}/{inside}"), read(path)?);
        Ok::<(), Error>(())
    };
    for name in public(assignment) {
        let scene = assignment.scene(name);
        add(&scene)?;
        Scene::files(&scene).iter().try_for_each(|mesh| add(mesh))?;
    }
    let terms = scenes.join("meshes").join("README.md");
    match terms.is_file() {
        true => add(&terms),
        false => Ok(()),
    }
}

/// The snapshot tests, if there are any, and the snapshots of the tasks and of the public scenes.
fn add_tests(files: &mut Files, assignment: &Assignment, folder: &str) -> Result<()> {
    let snapshots = assignment.folder.join("tests/snapshots");
    if !snapshots.is_dir() {
        return Ok(());
    }
    let tests = read(&assignment.folder.join("../golden_films.rs"))?;
    files.insert("assignments/golden_films.rs".into(), tests);
    let of_tasks = assignment.tasks.iter().map(|task| task.name.as_str());
    for name in of_tasks.chain(public(assignment)) {
        let file = format!("{name}.snap");
        let text = read(&snapshots.join(&file))?;
        files.insert(format!("{folder}/tests/snapshots/{file}"), text);
    }
    Ok(())
}

/// The goldens, as their manifest lists them, without what is withheld.
fn add_goldens(files: &mut Files, assignment: &Assignment) -> Result<()> {
    let folder = assignment.golden();
    let to = format!("golden/{}", assignment.name);
    let mut known = KnownMistakes::read(&folder)?;
    known.films.retain(|film, _| !assignment.withholds(film));
    known.panics.retain(|film, _| !assignment.withholds(film));
    for mistake in known.mistake.values_mut() {
        let look = &mut mistake.hint.look;
        if assignment
            .withheld_scenes()
            .any(|scene| holds_word(look.as_bytes(), &scene.name))
        {
            *look = ELSEWHERE.into();
        }
    }

    let mut manifest = Manifest::read(&folder)?;
    // Only `validate` asks about ties.
    let is_for_students = |film: &String| !assignment.withholds(film) && !film.starts_with("ties/");
    manifest.films.retain(|film, _| is_for_students(film));
    for film in manifest.films.keys().filter(|film| *film != known::FILE) {
        files.insert(format!("{to}/{film}"), read(&folder.join(film))?);
    }
    if manifest.films.contains_key(known::FILE) {
        let words = known.text()?.into_bytes();
        let hash = manifest::hash_of(Path::new(known::FILE), words.clone());
        manifest.films.insert(known::FILE.into(), hash);
        files.insert(format!("{to}/{}", known::FILE), words);
    }
    let is_here = |path: &String| files.contains_key(path);
    manifest.sources.retain(|path, _| is_here(path));
    manifest.mistakes.clear();
    manifest.scripts.clear();
    files.insert(format!("{to}/{}", manifest::FILE), manifest.text()?.into());
    Ok(())
}

/// Adds the goldens that the answer of an earlier assignment is judged by.
pub fn add_earlier_goldens(files: &mut Files, assignment: &Assignment) -> Result<()> {
    let Some(earlier) = &assignment.earlier else {
        return Ok(());
    };
    let folder = format!("golden/{}/probes", earlier.assignment);
    let start = format!("{}.", earlier.task.name);
    let from = assignment.course().join(&folder);
    let entries = fs::read_dir(&from).or_input(
        format_args!("cannot read {}", from.display()),
        "make the goldens of the earlier assignment first",
    )?;
    for entry in entries.flatten() {
        let name = entry.file_name().to_string_lossy().into_owned();
        if name.starts_with(&start) {
            files.insert(format!("{folder}/{name}"), read(&entry.path())?);
        }
    }
    Ok(())
}
