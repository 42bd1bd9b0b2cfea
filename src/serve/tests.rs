//! A submission as a process: this test program, started again to answer.

use std::hint::black_box;
use std::process::Command;

use super::*;
use crate::bounds::BoundingBox;
use crate::camera::{Camera, Pixel, Resolution};
use crate::kind::{Answer, CameraQuestion, Questions};
use crate::ray::{Hit, Intersection, Ray};
use crate::shape::{Canned, Plane, Shape, Sphere, TriangleSoup};
use crate::tree::{Node, RayTree, Tree};
use glam::{DVec3, dvec3};

#[cfg(unix)]
mod answers;

/// Set when this program is started as a submission; the value says which kind.
const KIND: &str = "PINHOLE_TEST_SUBMISSION";

/// Starts this program as a submission of this kind.
pub(crate) fn submission(kind: &str) -> Command {
    let this = std::env::current_exe().expect("the test program's own path");
    let mut command = Command::new(this);
    let test = "serve::tests::started_as_a_submission_it_answers";
    command
        .args([test, "--exact", "--nocapture"])
        .env(KIND, kind);
    command
}

#[cfg(unix)]
#[test]
fn started_as_a_submission_it_answers() {
    let Ok(kind) = std::env::var(KIND) else {
        return;
    };
    let viewing_ray = match kind.as_str() {
        "able" | "unregistered" => pixel_as_origin,
        "testing" => pixel_as_origin,
        "unanswered" => |_: &_, _, _| todo!("a ray through the pixel"),
        "stumbling" => |_: &_, pixel: Pixel, _| {
            let of_three = [1.0, 2.0, 3.0];
            let index = if pixel.i == 7 { pixel.j } else { 0 };
            Ray {
                origin: DVec3::splat(of_three[index]),
                direction: DVec3::X,
            }
        },
        "long-winded" => |_: &_, _, _| panic!("{}", "é".repeat(50 * MOST_PANIC_TEXT)),
        "bottomless" => |_: &_, _, _| Ray {
            origin: DVec3::splat(depth(0)),
            direction: DVec3::X,
        },
        "leaving" => |_: &_, _, _| std::process::exit(7),
        "endless" => |_: &_, _, _| loop {
            std::hint::spin_loop();
        },
        "stuck" => |camera: &_, pixel: Pixel, resolution| {
            if pixel.i == 7 {
                loop {
                    std::hint::spin_loop();
                }
            }
            pixel_as_origin(camera, pixel, resolution)
        },
        "talkative" => |camera: &_, pixel, resolution| {
            println!("an honest line");
            eprintln!("an honest complaint");
            pixel_as_origin(camera, pixel, resolution)
        },
        "prying" => |camera: &_, pixel, resolution| {
            let question = CameraQuestion {
                camera: Camera::clone(camera),
                pixel,
                resolution,
            };
            let ray = pixel_as_origin(camera, pixel, resolution);
            let asked = Questions::ViewingRay(vec![question]);
            let told = asked.conditions(0, &Answer::Ray(ray));
            panic!("the library says {}", told.len());
        },
        other => panic!("no submission is `{other}`"),
    };
    let functions = [
        AnswerFn::ViewingRay(viewing_ray),
        AnswerFn::Intersect(|shape, _, _| met_at(shape.words(6).len() as f64)),
        AnswerFn::FirstHit {
            shapes: |ray, min_t, objects| nearest(ray, min_t, objects.len()),
            canned: |ray, min_t, objects| nearest(ray, min_t, objects.len()),
        },
        AnswerFn::Soup(|soup, ray, min_t| soup.triangles[0].intersect(ray, min_t)),
        AnswerFn::Tree(|boxes| chain(0, boxes.len())),
        AnswerFn::TreeSearch(match kind.as_str() {
            "testing" => |tree, min_t| loop {
                tree.enter_box(0, min_t, f64::INFINITY);
            },
            _ => test_everything,
        }),
    ];
    let registered = match kind.as_str() {
        "unregistered" => &functions[..1],
        _ => &functions[..],
    };
    serve_through_stdin(registered).expect("an asker at the other end");
}

/// A ray that says which pixel it belongs to.
fn pixel_as_origin(_: &Camera, pixel: Pixel, _: Resolution) -> Ray {
    Ray {
        origin: dvec3(pixel.i as f64, pixel.j as f64, 0.0),
        direction: DVec3::NEG_Z,
    }
}

/// A hit that says which ray, `min_t` and number of objects the question had.
fn nearest(ray: &Ray, min_t: f64, objects: usize) -> Option<Hit> {
    let met = |intersection| Hit {
        object: objects,
        intersection,
    };
    let normal = dvec3(ray.origin.x, ray.origin.y, 0.0);
    let intersection = Intersection { t: min_t, normal };
    (ray.origin.x > 0.0).then_some(met(intersection))
}

fn met_at(t: f64) -> Option<Intersection> {
    let normal = DVec3::Y;
    Some(Intersection { t, normal })
}

/// A tree in which one child of each branch is a leaf of one triangle, and the other child holds
/// the rest.
fn chain(first: usize, end: usize) -> Tree {
    match end - first {
        1 => Tree::Leaf(vec![first]),
        _ => Tree::Branch(Box::new([Tree::Leaf(vec![first]), chain(first + 1, end)])),
    }
}

/// The nearest triangle of a tree, found without using its boxes.
fn test_everything(tree: &dyn RayTree, min_t: f64) -> Option<Hit> {
    fn collect(tree: &dyn RayTree, min_t: f64, node: usize, hits: &mut Vec<Hit>) {
        tree.enter_box(node, min_t, f64::INFINITY);
        match tree.node(node) {
            Node::Branch([a, b]) => {
                collect(tree, min_t, a, hits);
                collect(tree, min_t, b, hits);
            }
            Node::Leaf(triangles) => hits.extend(triangles.iter().filter_map(|&object| {
                let intersection = tree.intersect_triangle(object, min_t)?;
                Some(Hit {
                    object,
                    intersection,
                })
            })),
        }
    }
    let mut hits = Vec::new();
    collect(tree, min_t, 0, &mut hits);
    let by_t = |a: &Hit, b: &Hit| a.intersection.t.total_cmp(&b.intersection.t);
    hits.into_iter().min_by(by_t)
}

/// Calls itself until there is no stack left.
fn depth(n: u64) -> f64 {
    match black_box(n) {
        u64::MAX => 0.0,
        n => black_box(depth(n + 1)) + 1.0,
    }
}
