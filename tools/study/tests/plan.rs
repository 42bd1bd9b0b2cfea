//! Tests that plans reach the requested accuracy, and that they are reproducible.

use std::path::{Path, PathBuf};

use pinhole::{Camera, Film, Projection, Scene};
use pinhole_study::plan::casting::{PlannedCaster, film};
use pinhole_study::plan::{EXACT_FILM, EXACT_OBJECTS, plan};
use pinhole_study::plans::kept;
use pinhole_study::scenes::{named, names, read};

/// The file of a test scene.
fn file(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/scenes");
    folder.join(format!("{name}.toml"))
}

/// Reads a test scene, many of which a plan once got wrong.
fn hostile(name: &str) -> Scene {
    read(&file(name)).expect("it is a scene")
}

/// The film of a test scene.
fn filmed(name: &str, accuracy: f64) -> Film {
    let scene = hostile(name);
    let casting = PlannedCaster::new(&scene, accuracy).expect("a plan");
    film(scene.resolution, casting.hits().0)
}

#[track_caller]
fn keeps_its_promise(scene: &Scene, accuracies: &[f64]) {
    for accuracy in accuracies {
        let casting = PlannedCaster::new(scene, *accuracy).expect("a plan");
        let (kept, _) = kept(&casting, &casting.truths());
        let is_kept = kept.violations + kept.wrong_ids == 0;
        assert!(is_kept, "{accuracy:e}: {kept:#?}");
    }
}

#[test]
fn hostile_scenes_keep_their_promise() {
    for name in [
        "five_balls_1e11",
        "crate",
        "closed_edge",
        "slivers",
        "far_edge",
        "endless_triangle",
        "endless_edge",
        "far_eye",
        "inside_huge_sphere",
        "nearly_a_line",
        "corners_of_boxes",
        "tiny_sphere_from_within",
    ] {
        let accuracies = [EXACT_OBJECTS, 1e-2, 1e-6, 1e-9, 1e-12, 1e-13];
        keeps_its_promise(&hostile(name), &accuracies);
    }
}

#[test]
fn t_is_proven_whatever_the_accuracy() {
    let scene = hostile("eye_at_corner");
    let t = |accuracy| {
        let casting = PlannedCaster::new(&scene, accuracy).expect("a plan");
        let hits = casting.hits().0.into_iter().flatten();
        hits.map(|hit| hit.intersection.t).collect::<Vec<_>>()
    };
    assert_eq!(t(EXACT_FILM), [0.0; 16]);
    assert_eq!(t(EXACT_OBJECTS), [0.0; 16]);
}

#[test]
fn boxes_in_which_the_eye_lies_are_entered_first() {
    keeps_its_promise(&hostile("box_at_eye"), &[EXACT_FILM]);
}

#[test]
fn scene_with_a_shape_without_kernel_is_rejected() {
    let error = read(&file("disk")).expect_err("there is no kernel for a disk");
    let problem = "shape not supported: object 0 is a disk";
    assert!(error.problem.starts_with(problem), "{error}");
}

/// The triangle's hypotenuse runs exactly through the centres of 8 pixels.
#[test]
fn edges_are_hits() {
    let film = filmed("closed_edge", EXACT_FILM);
    let ids = film.channel("id").expect("objects");
    let hits = ids.iter().filter(|id| **id >= 0.0).count();
    assert_eq!(hits, 20, "{ids:?}");
}

#[test]
fn all_samples_of_a_film_are_finite() {
    let names = [
        "slivers",
        "far_triangle",
        "endless_triangle",
        "endless_edge",
    ];
    for (name, accuracy) in names
        .into_iter()
        .flat_map(|name| [(name, 1e-2), (name, 1e-12)])
    {
        let film = filmed(name, accuracy);
        for channel in film.channels() {
            let are_finite = channel.samples.iter().all(|sample| sample.is_finite());
            assert!(are_finite, "{name} {}: {:?}", channel.name, channel.samples);
        }
    }
}

#[test]
fn hit_beyond_the_largest_f32_is_seen_at_that_depth() {
    let film = filmed("far_triangle", EXACT_FILM);
    let [id, t] = ["id", "t"].map(|name| film.channel(name).expect("it is there"));
    assert!(id.iter().all(|id| *id == 0.0), "{id:?}");
    assert!(t.iter().all(|t| *t == f32::MAX), "{t:?}");
}

#[test]
fn hit_beyond_the_largest_f64_is_on_the_far_side() {
    let film = filmed("far_root", EXACT_FILM);
    let normals = film.channel("N.Z").expect("it is there");
    assert!(normals.iter().all(|z| *z < -0.98), "{normals:?}");
}

/// Slightly above the bound that it prints, the plan still watches hits, because it allows for the
/// rounding of its own bounds.
#[test]
fn plan_says_that_the_caster_watches_hits() {
    let mut scene = hostile("five_balls_1e11");
    scene.camera.projection = Projection::Orthographic;
    let spheres = |accuracy| {
        let casting = PlannedCaster::new(&scene, accuracy).expect("a plan");
        plan(&casting).kinds[0].clone()
    };
    let worst = spheres(1e-4).worst_normal.expect("a bound");
    let watched = [0.9, 1.1, 10.0].map(|times| spheres(times * worst).watched);
    assert_eq!(watched, [true, true, false]);
    assert!(!spheres(1.0).watched, "the bounds are for small errors");
}

/// From a distant eye, all boxes are the same in a frame of `f32` numbers around the eye.
#[test]
fn distant_eye_opens_as_few_boxes_as_a_near_one() {
    let mut scene = named("bunny");
    (scene.camera.width, scene.camera.height) = (16.0, 9.0);
    let mut tests = |distance| {
        scene.camera.eye = glam::DVec3::new(0.0, 3.5, 0.0) + distance * scene.camera.w;
        scene.camera.projection = Projection::Perspective {
            focal_length: distance,
        };
        let casting = PlannedCaster::new(&scene, 1e-6).expect("a plan");
        casting.hits().1.tests
    };
    let (near, far) = (tests(20.0), tests(2e8));
    assert!(far < 2 * near, "{near} tests from near, {far} from afar");
}

#[test]
fn planning_a_scene_twice_gives_the_same_plan() {
    for name in names() {
        let scene = named(&name);
        let [one, other] = [0; 2].map(|_| {
            let casting = PlannedCaster::new(&scene, 1e-6).expect("a plan");
            serde_json::to_string(&plan(&casting)).expect("JSON")
        });
        assert_eq!(one, other, "{name}");
    }
}

/// The image plane is so far away that the directions to its corners overflow.
#[test]
fn rays_that_overflow_are_rejected() {
    let mut scene = hostile("closed_edge");
    let view = glam::DVec3::new(1.0, 2.0, -3.0);
    let focal_length = f64::MAX;
    let perspective = Projection::Perspective { focal_length };
    let size = (f64::MAX, f64::MAX);
    let camera = Camera::new(scene.camera.eye, view, glam::DVec3::Y, size, perspective);
    scene.camera = camera.expect("up is not parallel to the view");
    let why = PlannedCaster::new(&scene, EXACT_FILM)
        .err()
        .unwrap_or_default();
    assert!(
        why.starts_with("the ray of pixel (0, 2) overflows"),
        "{why}"
    );
}
