//! Question films: one for each task, and how they are asked about.

use super::*;
use crate::testing::{self, row};
use glam::dvec3;

mod asked;
mod refused;

/// Channels of one pixel each.
type Question<'a> = Vec<(&'a str, f32)>;

fn read_film(film: &Film, task: &str) -> Result<(Job, Resolution), Error> {
    let (_folder, path) = testing::file("probe.ask.exr", "");
    film.write(&path).unwrap();
    read(&path, task)
}

fn ask(task: &str, question: &[(&str, f32)]) -> Result<Job, Error> {
    let channels: Vec<(&str, [f32; 1])> = question.iter().map(|(n, x)| (*n, [*x])).collect();
    let channels: Vec<(&str, &[f32])> = channels.iter().map(|(n, x)| (*n, &x[..])).collect();
    read_film(&row(&channels), task).map(|(job, _)| job)
}

fn ray() -> Question<'static> {
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

fn sphere() -> Question<'static> {
    let own = [
        ("center.X", 4.0),
        ("center.Y", 5.0),
        ("center.Z", 6.0),
        ("radius", 0.75),
    ];
    [ray(), own.into()].concat()
}

fn plane() -> Question<'static> {
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

fn triangle() -> Question<'static> {
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
fn canned() -> Question<'static> {
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

fn camera() -> Question<'static> {
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

/// The question with one channel holding something else.
#[track_caller]
fn with(mut question: Question<'static>, name: &str, value: f32) -> Question<'static> {
    let mut channels = question.iter_mut();
    channels.find(|(own, _)| *own == name).unwrap().1 = value;
    question
}
