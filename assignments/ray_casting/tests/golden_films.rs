//! Your answers against Mitsuba's: one test for each task alone, one for each scene.
//!
//! The golden films decide, whatever insta is told: accepting a snapshot or setting
//! `INSTA_UPDATE` or `INSTA_FORCE_PASS` never turns a wrong film green, and nothing
//! here writes to `golden/`. The committed snapshots hold the verdict of a perfect
//! film, so that insta shows what keeps yours from being one.

use std::env;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::Duration;

use insta::{Comparator, Settings, Snapshot, assert_snapshot};
use pinhole::ask::{Ending, Reply, ask};
use pinhole::job::Job;
use pinhole::judge::{Golden, judge};
use pinhole::kind::{CameraQuestion, Questions};
use pinhole::oiiotool::Oiiotool;
use pinhole::{Kind, Resolution, Scene, ShapeKind};

#[test]
fn viewing_ray_agrees_with_mitsuba() {
    assert_task("viewing_ray", Kind::ViewingRay, None);
}

#[test]
fn viewing_ray_agrees_with_mitsuba_in_every_scene() {
    assert_viewing_rays_of_scenes();
}

#[test]
fn sphere_agrees_with_mitsuba() {
    assert_task("sphere", Kind::Intersect, Some(ShapeKind::Sphere));
}

#[test]
fn plane_agrees_with_mitsuba() {
    assert_task("plane", Kind::Intersect, Some(ShapeKind::Plane));
}

#[test]
fn triangle_agrees_with_mitsuba() {
    assert_task("triangle", Kind::Intersect, Some(ShapeKind::Triangle));
}

#[test]
fn triangle_soup_agrees_with_mitsuba() {
    assert_task("triangle_soup", Kind::Soup, None);
}

#[test]
fn first_hit_agrees_with_mitsuba() {
    assert_task("first_hit", Kind::FirstHit, None);
}

#[test]
fn sphere_and_plane_is_cast_right() {
    assert_scene("sphere_and_plane");
}

#[test]
fn two_spheres_and_plane_is_cast_right() {
    assert_scene("two_spheres_and_plane");
}

#[test]
fn slide_example_is_cast_right() {
    assert_scene("slide_example");
}

#[test]
fn lone_triangle_is_cast_right() {
    assert_scene("lone_triangle");
}

#[test]
fn inside_a_box_is_cast_right() {
    assert_scene("inside_a_box");
}

#[test]
fn inside_a_sphere_is_cast_right() {
    assert_scene("inside_a_sphere");
}

#[test]
fn tilted_camera_is_cast_right() {
    assert_scene("tilted_camera");
}

#[test]
fn in_front_of_the_image_plane_is_cast_right() {
    assert_scene("in_front_of_the_image_plane");
}

#[test]
fn soup_order_is_cast_right() {
    assert_scene("soup_order");
}

#[test]
fn sphere_packing_is_cast_right() {
    assert_scene("sphere_packing");
}

#[test]
fn teapot_orthographic_is_cast_right() {
    assert_scene("teapot_orthographic");
}

#[test]
fn bunny_is_cast_right() {
    assert_scene("bunny");
}

/// Longer than any answer should take.
const WALL: Duration = Duration::from_secs(120);

/// What is said of an answer that is still `todo!`.
const UNANSWERED: &str = "is unanswered";

/// What came of one film: whether it is as good as Mitsuba's, and in words.
struct Verdict {
    passes: bool,
    words: String,
}

/// Casts a scene and compares its film with the golden.
#[track_caller]
fn assert_scene(name: &str) {
    let scene = Scene::read(&course().join("scenes").join(name).with_extension("toml"))
        .unwrap_or_else(|error| panic!("{error}"));
    let golden = golden().join(name).with_extension("exr");
    let verdict = verdict(&Job::Film(scene.clone()), scene.resolution, &golden);
    assert_perfect(name, verdict, &format!("check --scene {name}"));
}

/// Asks for the viewing rays of every scene.
#[track_caller]
fn assert_viewing_rays_of_scenes() {
    let scenes = fs::read_dir(course().join("scenes")).expect("the scenes can be read");
    let files = scenes.flatten().map(|entry| entry.path());
    let mut files: Vec<PathBuf> = files
        .filter(|path| path.extension().is_some_and(|end| end == "toml"))
        .collect();
    files.sort();
    let films = files.into_iter().map(|file| {
        let scene = Scene::read(&file).unwrap_or_else(|error| panic!("{error}"));
        let resolution = scene.resolution;
        let question = |index| CameraQuestion::of_scene(&scene, index);
        let questions = (0..resolution.pixels()).map(question).collect();
        let job = Job::Ask(Questions::ViewingRay(questions));
        let name = file
            .file_stem()
            .expect("scenes have names")
            .to_string_lossy()
            .into_owned();
        let golden = golden().join(&name).with_extension("rays.exr");
        (name, job, resolution, golden)
    });
    assert_all("viewing_ray_in_scenes", "check --task viewing_ray", films);
}

/// Asks one answer every question film of its task.
#[track_caller]
fn assert_task(task: &str, kind: Kind, shape: Option<ShapeKind>) {
    let probes = golden().join("probes");
    let entries = fs::read_dir(&probes).expect("golden/ray_casting/probes can be read");
    let names = entries
        .flatten()
        .filter_map(|entry| entry.file_name().into_string().ok());
    let mut groups: Vec<String> = names
        .filter_map(|name| Some(name.strip_prefix(task)?.strip_prefix('.')?.to_owned()))
        .filter_map(|name| Some(name.strip_suffix(".ask.exr")?.to_owned()))
        .collect();
    groups.sort();
    assert!(
        !groups.is_empty(),
        "there are no probes of {task} in {}",
        probes.display()
    );

    let films = groups.into_iter().map(|group| {
        let film = probes.join(format!("{task}.{group}.ask.exr"));
        let (questions, resolution) =
            Questions::read(&film, task, kind, shape).unwrap_or_else(|error| panic!("{error}"));
        let golden = probes.join(format!("{task}.{group}.exr"));
        (group, Job::Ask(questions), resolution, golden)
    });
    assert_all(task, &format!("check --task {task}"), films);
}

/// Asks for several films of one answer: name, questions, size and golden of each.
#[track_caller]
fn assert_all(
    name: &str,
    see_it: &str,
    films: impl Iterator<Item = (String, Job, Resolution, PathBuf)>,
) {
    let mut all = Verdict {
        passes: true,
        words: String::new(),
    };
    for (film, job, resolution, golden) in films {
        let verdict = verdict(&job, resolution, &golden);
        if verdict.words == UNANSWERED {
            all = verdict;
            break;
        }
        all.passes &= verdict.passes;
        all.words.push_str(&format!("{film} {}\n", verdict.words));
    }
    assert_perfect(name, all, see_it);
}

fn verdict(job: &Job, resolution: Resolution, golden_path: &Path) -> Verdict {
    let reply = ask(Command::new(program()), job, WALL, &mut |_| {})
        .expect("the program that was built can be started");
    let judged = Golden::read(golden_path).unwrap_or_else(|error| panic!("{error}"));
    let film = reply.film(resolution);
    let verdict = match (&reply.ending, judge(&judged, &film)) {
        (Ending::Complete, Ok(verdict)) => Verdict {
            passes: verdict.passes(),
            words: verdict.to_string(),
        },
        (Ending::Complete, Err(refusal)) => Verdict {
            passes: false,
            words: format!("is refused: {refusal}"),
        },
        _ => {
            return Verdict {
                passes: false,
                words: failure(&reply),
            };
        }
    };
    let film_path = scratch().join(golden_path.file_name().expect("goldens have names"));
    film.write(&film_path)
        .unwrap_or_else(|error| panic!("{error}"));
    confirm(golden_path, &film_path, verdict.passes);
    verdict
}

/// Why there is no film, in words.
fn failure(reply: &Reply) -> String {
    match &reply.ending {
        Ending::Panicked(panic) if panic.is_unanswered() => UNANSWERED.into(),
        Ending::Panicked(panic) => {
            format!(
                "panicked at {}:{}: {}",
                panic.file, panic.line, panic.message
            )
        }
        ending => format!("has no film: {ending:?}"),
    }
}

/// Asks oiiotool too. It may be absent from a student's machine, and from a student's
/// repository altogether; not from the course's own CI.
fn confirm(golden: &Path, film: &Path, passes: bool) {
    let scripts = course().join("../../tools/mitsuba");
    let Some(tool) = Oiiotool::find(&scripts.join(".venv")) else {
        let needed = scripts.is_dir() && env::var_os("CI").is_some();
        assert!(!needed, "CI has no oiiotool to ask");
        return;
    };
    let second = tool
        .judge(golden, film)
        .unwrap_or_else(|problem| panic!("{problem}"));
    let judges = (passes, second.passes);
    assert!(
        passes == second.passes,
        "the judges disagree on {}: {judges:?}",
        golden.display()
    );
}

#[track_caller]
fn assert_perfect(name: &str, verdict: Verdict, see_it: &str) {
    let mut settings = Settings::clone_current();
    settings.set_snapshot_path("snapshots");
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    settings.set_comparator(Box::new(GoldenDecides {
        passes: verdict.passes,
    }));
    let summary = format!(
        "{name} {}\nto see more: cargo pinhole {see_it}",
        verdict.words
    );
    // Printed as well: a wrong verdict that was accepted shows no difference in insta.
    println!("{summary}");
    settings.bind(|| assert_snapshot!(name, verdict.words));
    // insta can be told to let everything pass; this cannot.
    assert!(verdict.passes, "{summary}");
}

/// Matches if the golden says so, whatever text was accepted as a snapshot.
#[derive(Clone)]
struct GoldenDecides {
    passes: bool,
}

impl Comparator for GoldenDecides {
    fn matches(&self, _: &Snapshot, _: &Snapshot) -> bool {
        self.passes
    }

    fn dyn_clone(&self) -> Box<dyn Comparator> {
        Box::new(self.clone())
    }
}

/// The program that cargo built from the answers beside this test's manifest.
fn program() -> &'static str {
    option_env!("CARGO_BIN_EXE_ray-casting-handout")
        .or(option_env!("CARGO_BIN_EXE_ray-casting-reference"))
        .expect("cargo builds the answers before their tests")
}

/// `assignments/ray_casting`.
fn course() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// `golden/ray_casting`.
fn golden() -> PathBuf {
    course().join("../../golden/ray_casting")
}

/// A folder for films, one for each package.
fn scratch() -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(env!("CARGO_PKG_NAME"));
    fs::create_dir_all(&folder).expect("the target folder can be written");
    folder
}
