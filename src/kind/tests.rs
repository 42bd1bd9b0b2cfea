//! Question films: how each task's film is read and asked.

use super::*;
use crate::camera::{Pixel, Projection, Resolution};
use crate::error::Error;
use crate::film::Film;
use crate::ray::Intersection;
use crate::shape::{Disk, Plane, Shape, Sphere, Triangle, TriangleSoup};
use crate::testing::{self, row};
use glam::{DVec3, dvec3};

mod reading;
mod refusals;
mod words;

/// Channels of one pixel each.
type Channels<'a> = Vec<(&'a str, f32)>;

/// Kind and shape of a task of this name.
#[track_caller]
fn of_task(task: &str) -> (Kind, Option<ShapeKind>) {
    match task {
        "viewing_ray" => (Kind::ViewingRay, None),
        "first_hit" => (Kind::FirstHit, None),
        "triangle_soup" => (Kind::Soup, None),
        "sphere" => (Kind::Intersect, Some(ShapeKind::Sphere)),
        "plane" => (Kind::Intersect, Some(ShapeKind::Plane)),
        "triangle" => (Kind::Intersect, Some(ShapeKind::Triangle)),
        "disk" => (Kind::Intersect, Some(ShapeKind::Disk)),
        "bounds" => (Kind::Bounds, None),
        "ray_box" => (Kind::RayBox, None),
        "tree" => (Kind::Tree, None),
        "tree_search" => (Kind::TreeSearch, None),
        other => panic!("there is no task `{other}`"),
    }
}

#[track_caller]
fn read_film(film: &Film, task: &str) -> Result<(Questions, Resolution), Error> {
    let (_folder, path) = testing::file("probe.ask.exr", "");
    film.write(&path).unwrap();
    let (kind, shape) = of_task(task);
    Questions::read(&path, task, kind, shape)
}

#[track_caller]
fn ask(task: &str, question: &[(&str, f32)]) -> Result<Questions, Error> {
    read_film(&film(question), task).map(|(questions, _)| questions)
}

/// A film of one pixel.
fn film(question: &[(&str, f32)]) -> Film {
    let channels: Vec<(&str, [f32; 1])> = question.iter().map(|(n, x)| (*n, [*x])).collect();
    let channels: Vec<(&str, &[f32])> = channels.iter().map(|(n, x)| (*n, &x[..])).collect();
    row(&channels)
}

fn ray() -> Channels<'static> {
    vec![
        ("O.X", 1.0),
        ("O.Y", 2.0),
        ("O.Z", 3.0),
        ("D.X", 0.5),
        ("D.Y", 0.25),
        ("D.Z", -2.0),
        ("min_t", 0.125),
    ]
}

fn sphere() -> Channels<'static> {
    let own = [
        ("center.X", 4.0),
        ("center.Y", 5.0),
        ("center.Z", 6.0),
        ("radius", 0.75),
    ];
    [ray(), own.into()].concat()
}

fn bounding_box(number: usize) -> Channels<'static> {
    let names = [
        [
            "0.min.X", "0.min.Y", "0.min.Z", "0.max.X", "0.max.Y", "0.max.Z",
        ],
        [
            "1.min.X", "1.min.Y", "1.min.Z", "1.max.X", "1.max.Y", "1.max.Z",
        ],
    ];
    let values = [4.0, 5.0, 6.0, 7.0, 8.0, 9.0];
    names[number].into_iter().zip(values).collect()
}

fn two_boxes() -> Channels<'static> {
    [vec![("boxes", 2.0)], bounding_box(0), bounding_box(1)].concat()
}

fn ray_and_box() -> Channels<'static> {
    [ray(), vec![("max_t", 2.5)], bounding_box(0)].concat()
}

fn boxes_for_a_tree() -> Channels<'static> {
    let places = vec![
        ("count", 2.0),
        ("0.leaf", 1.0),
        ("0.depth", 1.0),
        ("1.leaf", 0.0),
        ("1.depth", 1.0),
    ];
    [places, bounding_box(0), bounding_box(1)].concat()
}

/// A branch with a leaf of two triangles, of which the second is met, and one that is missed.
fn search() -> Channels<'static> {
    vec![
        ("min_t", 0.125),
        ("nodes", 3.0),
        ("0.second", 2.0),
        ("0.size", 0.0),
        ("0.first", 0.0),
        ("0.near", 1.0),
        ("0.far", 4.0),
        ("1.second", 0.0),
        ("1.size", 2.0),
        ("1.first", 1.0),
        ("1.near", 1.0),
        ("1.far", 3.0),
        ("2.second", 0.0),
        ("2.size", 1.0),
        ("2.first", 0.0),
        ("2.near", 1.0),
        ("2.far", 0.0),
        ("hits", 1.0),
        ("hit.0.triangle", 2.0),
        ("hit.0.t", 2.5),
        ("hit.0.N.X", 0.0),
        ("hit.0.N.Y", 1.0),
        ("hit.0.N.Z", 0.0),
    ]
}

fn plane() -> Channels<'static> {
    let own = [
        ("point.X", 4.0),
        ("point.Y", 5.0),
        ("point.Z", 6.0),
        ("normal.X", 0.0),
        ("normal.Y", 2.0),
        ("normal.Z", 1.0),
    ];
    [ray(), own.into()].concat()
}

fn disk() -> Channels<'static> {
    let normal = [("normal.X", 0.0), ("normal.Y", 2.0), ("normal.Z", 1.0)];
    [sphere(), normal.into()].concat()
}

fn triangle() -> Channels<'static> {
    let own = [
        ("a.X", 1.0),
        ("a.Y", 2.0),
        ("a.Z", 3.0),
        ("b.X", 4.0),
        ("b.Y", 5.0),
        ("b.Z", 6.0),
        ("c.X", 7.0),
        ("c.Y", 8.0),
        ("c.Z", 0.0),
    ];
    [ray(), own.into()].concat()
}

/// Two objects: the first is met twice, the second never.
fn canned() -> Channels<'static> {
    let own = [
        ("count", 2.0),
        ("0.hits", 2.0),
        ("0.0.t", 1.5),
        ("0.0.N.X", 1.0),
        ("0.0.N.Y", 0.0),
        ("0.0.N.Z", 0.0),
        ("0.1.t", 2.5),
        ("0.1.N.X", 0.0),
        ("0.1.N.Y", -1.0),
        ("0.1.N.Z", 0.0),
        ("1.hits", 0.0),
    ];
    [ray(), own.into()].concat()
}

fn camera() -> Channels<'static> {
    vec![
        ("eye.X", 1.0),
        ("eye.Y", 2.0),
        ("eye.Z", 3.0),
        ("view.X", 0.0),
        ("view.Y", 0.0),
        ("view.Z", -2.0),
        ("up.X", 0.0),
        ("up.Y", 1.0),
        ("up.Z", 0.0),
        ("focal_length", 1.5),
        ("width", 2.0),
        ("height", 1.0),
        ("n_x", 8.0),
        ("n_y", 4.0),
        ("i", 7.0),
        ("j", 1.0),
    ]
}

/// The question, with one channel changed.
#[track_caller]
fn with(mut question: Channels<'static>, name: &str, value: f32) -> Channels<'static> {
    let mut channels = question.iter_mut();
    channels.find(|(own, _)| *own == name).unwrap().1 = value;
    question
}

#[test]
fn a_camera_travels_once_for_all_its_pixels() {
    let camera = |eye| {
        let projection = Projection::Orthographic;
        crate::Camera::new(eye, -DVec3::Z, DVec3::Y, (1.0, 1.0), projection).unwrap()
    };
    let resolution = Resolution { n_x: 50, n_y: 20 };
    let ask = |eye: DVec3, index: usize| CameraQuestion {
        camera: camera(eye),
        pixel: resolution.pixel(index),
        resolution,
    };
    let mut questions: Vec<_> = (0..1000).map(|index| ask(DVec3::X, index)).collect();
    questions.push(ask(DVec3::Y, 3));
    questions.push(ask(DVec3::X, 4));
    let bytes = postcard::to_stdvec(&Questions::ViewingRay(questions.clone())).unwrap();
    assert!(bytes.len() < 4000, "{} bytes", bytes.len());
    let Questions::ViewingRay(received) = postcard::from_bytes(&bytes).unwrap() else {
        panic!("other questions came");
    };
    assert_eq!(received, questions);
}

#[test]
fn a_scene_needs_the_tasks_of_every_ray_and_of_its_shapes() {
    let soup = Shape::Soup(TriangleSoup {
        triangles: Vec::new(),
    });
    let disk = Shape::Disk(Disk {
        center: DVec3::ZERO,
        normal: DVec3::Z,
        radius: 1.0,
    });
    for (object, shapes) in [
        (soup, &["triangle", "triangle_soup"][..]),
        (disk, &["disk"]),
    ] {
        let projection = Projection::Orthographic;
        let size = (1.0, 1.0);
        let camera = crate::Camera::new(DVec3::Z, -DVec3::Z, DVec3::Y, size, projection);
        let scene = Scene {
            camera: camera.unwrap(),
            resolution: Resolution { n_x: 1, n_y: 1 },
            min_t: 0.0,
            objects: vec![object],
        };
        for task in ["sphere", "plane", "triangle", "triangle_soup", "disk"] {
            let (kind, shape) = of_task(task);
            let needed = kind.is_needed_by(shape, &scene);
            assert_eq!(needed, shapes.contains(&task), "{task}");
        }
        for task in ["viewing_ray", "first_hit"] {
            assert!(of_task(task).0.is_needed_by(None, &scene), "{task}");
        }
    }
}
