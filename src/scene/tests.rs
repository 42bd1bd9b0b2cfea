//! Scene files: what is read from a good one, and how a bad one is refused.

use super::*;
use crate::camera::Projection;
use crate::shape::{Disk, Plane, Sphere, Triangle};
use crate::testing;
use glam::{DVec3, dvec3};

mod cameras;
mod keys;
mod numbers;
mod objects;
mod texts;

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

/// Marks the place that an error must point at.
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
        "`{passage}` does not occur exactly once in the good scene"
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
fn good_file_is_read_as_the_scene_it_describes() {
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
