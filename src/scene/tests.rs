use std::fs;

use super::*;
use crate::camera::Projection;
use crate::shape::{Plane, Sphere, Triangle};
use crate::testing;
use glam::{DVec3, dvec3};

mod cameras;
mod objects;

const GOOD: &str = r#"# One of each shape that needs no file.
[camera]
projection = "perspective"
eye = [0.0, 1.0, 5.0]
view = [0.0, 0.0, -2.0]
up = [0.0, 3.0, 1.0]
focal_length = 1.5
width = 2.0
height = 1.25
resolution = [8, 5]

[[object]]
type = "sphere"
center = [0.0, 1.0, -1.0]
radius = 0.75

[[object]]
type = "plane"
point = [0.0, -1.0, 0.0]
normal = [0.0, 4.0, 0.0]

[[object]]
type = "triangle"
corners = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]
"#;

/// Stands before what an error must point at.
const HERE: char = '▶';

fn read(text: &str) -> Result<Scene, Error> {
    let (_folder, path) = testing::file("a scene.toml", text);
    Scene::read(&path)
}

/// The good scene with one passage replaced.
#[track_caller]
fn with(passage: &str, replacement: &str) -> String {
    assert_eq!(
        GOOD.matches(passage).count(),
        1,
        "`{passage}` is not once in the good scene"
    );
    GOOD.replace(passage, replacement)
}

/// Replaces one passage of the good scene, and expects an error that points at the
/// mark in the replacement and has these words in problem and remedy.
#[track_caller]
fn refused(passage: &str, replacement: &str, problem: &str, remedy: &str) {
    refused_text(&with(passage, replacement), problem, remedy);
}

#[track_caller]
fn refused_text(marked: &str, problem: &str, remedy: &str) {
    let (before, _) = marked.split_once(HERE).expect("a mark");
    let line = before.matches('\n').count() + 1;
    let column = before.chars().rev().take_while(|c| *c != '\n').count() + 1;
    let (_folder, path) = testing::file("a scene.toml", marked.replace(HERE, ""));

    let error = Scene::read(&path).expect_err("this scene should be refused");
    let shown = error.to_string();
    assert!(
        shown.starts_with(&format!("{}:{line}:{column}: ", path.display())),
        "expected {line}:{column}, got: {shown}"
    );
    assert!(error.problem.contains(problem), "the problem is: {shown}");
    assert!(error.remedy.contains(remedy), "the remedy is: {shown}");
    assert!(shown.contains("\n  remedy: "), "{shown}");
}

#[test]
fn a_good_file_is_the_scene_it_describes() {
    let scene = read(GOOD).unwrap();
    assert_eq!(scene.resolution, Resolution { n_x: 8, n_y: 5 });
    assert_eq!(scene.camera.eye, dvec3(0.0, 1.0, 5.0));
    assert_eq!((scene.camera.width, scene.camera.height), (2.0, 1.25));
    let projection = Projection::Perspective { focal_length: 1.5 };
    assert_eq!(scene.camera.projection, projection);
    assert_eq!(scene.camera.u, DVec3::X);
    assert_eq!(scene.camera.v, DVec3::Y);
    assert_eq!(scene.camera.w, DVec3::Z);
    assert_eq!(
        scene.objects,
        [
            Shape::Sphere(Sphere {
                center: dvec3(0.0, 1.0, -1.0),
                radius: 0.75
            }),
            Shape::Plane(Plane {
                point: dvec3(0.0, -1.0, 0.0),
                normal: dvec3(0.0, 4.0, 0.0)
            }),
            Shape::Triangle(Triangle {
                corners: [DVec3::ZERO, DVec3::X, DVec3::Y]
            }),
        ]
    );
}

#[test]
fn a_scene_may_be_empty_space() {
    let camera = GOOD.split("[[object]]").next().unwrap();
    assert_eq!(read(camera).unwrap().objects, []);
}

#[test]
fn whole_numbers_need_no_decimal_point() {
    assert_eq!(
        read(&with("radius = 0.75", "radius = 2")).unwrap(),
        read(&with("radius = 0.75", "radius = 2.0")).unwrap()
    );
}

#[test]
fn windows_line_ends_change_nothing() {
    assert_eq!(
        read(&GOOD.replace('\n', "\r\n")).unwrap(),
        read(GOOD).unwrap()
    );
}

#[test]
fn an_unknown_key_is_pointed_at() {
    refused(
        "radius = 0.75",
        "radius = 0.75\n▶radios = 1.0",
        "unknown field `radios`",
        "correct its spelling",
    );
    refused(
        "width = 2.0",
        "▶widht = 2.0\nwidth = 2.0",
        "unknown field `widht`",
        "correct its spelling",
    );
    refused(
        "# One of each shape that needs no file.",
        "▶title = \"shapes\"",
        "unknown field `title`",
        "remove the key",
    );
}

#[test]
fn who_adds_a_light_learns_why_there_is_none() {
    let why = "scenes have no lights, materials or lenses";
    refused(
        "[[object]]\ntype = \"plane\"",
        "[[▶light]]\nposition = [0.0, 9.0, 0.0]\n\n[[object]]\ntype = \"plane\"",
        why,
        "remove `light`",
    );
    refused(
        "radius = 0.75",
        "radius = 0.75\n▶material = \"glass\"",
        why,
        "remove `material`",
    );
    refused(
        "width = 2.0",
        "width = 2.0\n▶lens = 0.1",
        why,
        "remove `lens`",
    );
}

#[test]
fn a_missing_key_is_missed_where_its_table_begins() {
    let object = "[[object]]\ntype = \"sphere\"\ncenter = [0.0, 1.0, -1.0]\nradius = 0.75";
    refused(
        object,
        "▶[[object]]\ntype = \"sphere\"\ncenter = [0.0, 1.0, -1.0]",
        "this sphere has no `radius`",
        "a sphere needs: center, radius",
    );
    refused(
        object,
        "▶[[object]]\ncenter = [0.0, 1.0, -1.0]\nradius = 0.75",
        "missing field `type`",
        "README.md",
    );
    refused(
        "[camera]\nprojection = \"perspective\"\neye = [0.0, 1.0, 5.0]",
        "▶[camera]\nprojection = \"perspective\"",
        "missing field `eye`",
        "README.md",
    );
}

#[test]
fn a_scene_without_a_camera_is_told_so() {
    let objects = &GOOD[GOOD.find("[[object]]").unwrap()..];
    refused_text(&format!("▶{objects}"), "missing field `camera`", "README");
}

#[test]
fn a_value_of_the_wrong_kind_is_pointed_at() {
    refused(
        "radius = 0.75",
        "radius = ▶\"big\"",
        "invalid type: string \"big\", expected f64",
        "README.md",
    );
    refused(
        "center = [0.0, 1.0, -1.0]",
        "center = ▶[0.0, 1.0]",
        "invalid length 2",
        "README.md",
    );
}

#[test]
fn nan_and_inf_are_no_numbers() {
    let remedy = "replace nan or inf by a number";
    refused(
        "radius = 0.75",
        "radius = ▶nan",
        "`radius` is not a finite",
        remedy,
    );
    refused(
        "width = 2.0",
        "width = ▶inf",
        "`width` is not a finite",
        remedy,
    );
    refused(
        "eye = [0.0, 1.0, 5.0]",
        "eye = ▶[0.0, nan, 5.0]",
        "`eye` is not a finite",
        remedy,
    );
    refused(
        "[[0.0, 0.0, 0.0], [1.0,",
        "▶[[0.0, 0.0, 0.0], [-inf,",
        "`corners` is not a finite",
        remedy,
    );
    refused(
        "width = 2.0",
        "width = 2.0\nmin_t = ▶nan",
        "`min_t` is not a finite",
        remedy,
    );
}

#[test]
fn a_vector_of_length_zero_has_no_direction() {
    for (key, value) in [
        ("view", "[0.0, 0.0, -2.0]"),
        ("up", "[0.0, 3.0, 1.0]"),
        ("normal", "[0.0, 4.0, 0.0]"),
    ] {
        refused(
            &format!("{key} = {value}"),
            &format!("{key} = ▶[0.0, 0.0, 0.0]"),
            &format!("`{key}` has no direction: its length is 0"),
            "it need not be unit",
        );
    }
}

#[test]
fn a_length_is_more_than_nothing() {
    for (key, value) in [
        ("width", "2.0"),
        ("height", "1.25"),
        ("radius", "0.75"),
        ("focal_length", "1.5"),
    ] {
        for bad in ["0", "-0", "-2"] {
            refused(
                &format!("{key} = {value}"),
                &format!("{key} = ▶{bad}.0"),
                &format!("`{key}` is {bad}"),
                "greater than 0",
            );
        }
    }
}

#[test]
fn nothing_behind_the_eye_is_seen() {
    refused(
        "width = 2.0",
        "width = 2.0\nmin_t = ▶-0.5",
        "`min_t` is -0.5, behind the eye",
        "give 0 (the eye) or more",
    );
}

#[test]
fn what_is_no_toml_is_pointed_at() {
    refused("width = 2.0", "width = ▶two", "invalid", "README.md");
    refused(
        "eye = [0.0, 1.0, 5.0]",
        "eye = [0.0, ▶1.0 5.0]",
        "",
        "README.md",
    );
    refused(
        "width = 2.0",
        "width = 2.0\n▶width = 3.0",
        "duplicate key",
        "README.md",
    );
}

#[test]
fn columns_count_characters_and_not_bytes() {
    refused(
        "[[object]]\ntype = \"sphere\"\ncenter = [0.0, 1.0, -1.0]\nradius = 0.75",
        "[[object]]\ntype = \"soup\"\nobj = \"größte.obj\" ▶oops",
        "",
        "README.md",
    );
}

#[test]
fn a_scene_that_is_not_there_is_told_so() {
    let folder = tempfile::tempdir().unwrap();
    for path in [folder.path().join("absent.toml"), folder.path().into()] {
        let error = Scene::read(&path).unwrap_err();
        assert_eq!(error.path, path);
        assert!(
            error.problem.starts_with("cannot read this scene"),
            "{error}"
        );
    }
}

#[test]
fn no_text_makes_the_reader_panic() {
    let mut random = testing::Random(1);
    let signs: Vec<char> = "[]{}=\"'.,#\n -0123e nan inf é\u{2028}\0".chars().collect();
    let path = Path::new("a scene.toml");
    for _ in 0..2000 {
        let mut text: Vec<char> = GOOD.chars().collect();
        for _ in 0..1 + random.below(4) {
            let place = random.below(text.len());
            match random.below(3) {
                0 => text[place] = *random.one_of(&signs),
                1 => text.insert(place, *random.one_of(&signs)),
                _ => drop(text.remove(place)),
            }
        }
        let text = String::from_iter(text);
        let read = Document::parse(&text, path).and_then(Document::into_scene);
        if let Err(error) = read {
            assert!(error.position.is_some(), "{error}");
        }
    }
}

#[test]
fn no_spoilt_scene_harms_its_reader() {
    let folder = concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/assignments/ray_casting/scenes"
    );
    let files = fs::read_dir(folder)
        .unwrap()
        .flatten()
        .map(|entry| entry.path());
    let scenes = files.filter(|path| path.extension().is_some_and(|end| end == "toml"));
    let seeds: Vec<Vec<u8>> = scenes.map(|path| fs::read(path).unwrap()).collect();
    let words: [&[u8]; 14] = [
        b"[[object]]",
        b"[camera]",
        b"type = ",
        b"nan",
        b"inf",
        b"-",
        b"1e999",
        b"[",
        b"]",
        b"\"",
        b"resolution = [1, 1]",
        b"99999999999999999999",
        b"\n",
        b"obj = \"/dev/zero\"",
    ];
    // One file for all: a folder for each would fill the disk's list of changes.
    let (_folder, path) = testing::file("scene.toml", "");
    testing::fuzz::fuzz("scene", &seeds, &words, |bytes| {
        fs::write(&path, bytes).unwrap();
        if let Ok(scene) = Scene::read(&path) {
            assert!(scene.resolution.pixels() <= MOST_PIXELS);
        }
    });
}
