//! Random scenes to test plans on.
//!
//! Their sizes range from 1e-30 to 1e30, and they are made to be hard: shapes of very different
//! sizes, far from the origin, nearly or exactly coincident, slivers, closed boxes, and grids
//! of small integers, whose edges and tangents the rays hit exactly.

use pinhole::{Camera, Projection, Resolution, Scene, Shape, Triangle, TriangleSoup};

use crate::random::Random;
use crate::vector::Vector;

/// The scene of a seed, and the accuracy to plan for.
pub fn drawn(seed: u64) -> (Scene, f64) {
    let mut random = Random::new(seed, "plans");
    let scene = match random.below(3) {
        0 => on_a_grid(&mut random),
        _ => anywhere(&mut random),
    };
    (scene, power(&mut random, -14.5, -4.0))
}

/// A random power of ten, with an exponent from `low` to `high`.
fn power(random: &mut Random, low: f64, high: f64) -> f64 {
    10f64.powf(random.within(low, high))
}

fn shape(corners: [Vector<f64>; 3]) -> Triangle {
    Triangle {
        corners: corners.map(|corner| corner.into()),
    }
}

/// A scene with objects of any size, in front of the camera or around it.
fn anywhere(random: &mut Random) -> Scene {
    let scale = power(random, -30.0, 30.0);
    let far = [0.0, power(random, 0.0, 7.0)][random.below(2)];
    let middle = random.unit() * (scale * far);
    let away = scale * power(random, -1.0, 4.0);
    let (back, size) = (random.unit(), scale * random.within(0.5, 3.0));
    // The image plane may be at any distance, but the same part of the scene fills the picture.
    let focal_length = away * power(random, -5.0, 2.0);
    let projection = match random.below(3) {
        0 => Projection::Orthographic,
        _ => Projection::Perspective { focal_length },
    };
    let width = match projection {
        Projection::Orthographic => size,
        Projection::Perspective { focal_length } => size * focal_length / away,
    };
    let count = 1 + random.below(18);
    let mut objects = Vec::new();
    for _ in 0..count {
        let at = middle + random.unit() * (scale * random.within(0.0, 1.0));
        let own = scale * power(random, -4.0, 0.5);
        objects.push(match random.below(6) {
            0 | 1 => sphere(at, own),
            2 => plane(at, random.unit() * power(random, -20.0, 20.0)),
            3 => crate_of(random, at, own),
            4 => sliver(random, at, own),
            _ => Shape::Triangle(shape([0; 3].map(|_| at + random.unit() * own))),
        });
    }
    for _ in 0..random.below(4) {
        let at = middle + random.unit() * scale;
        objects.push(edge_on(random, at, scale, back));
    }
    let eye = middle + back * away;
    if random.below(2) == 0 {
        objects.push(at_the_eye(random, eye, scale));
    }
    repeat(random, &mut objects, scale);
    let up = random.unit_across(back);
    let size = (width, width * random.within(0.5, 2.0));
    let min_t = [0.0, 0.0, 1.0, power(random, -2.0, 5.0)][random.below(4)];
    seen_from([eye, back, up], size, projection, min_t, objects)
}

/// A scene with a camera at the eye that looks away from `back`.
fn seen_from(
    frame: [Vector<f64>; 3],
    size: (f64, f64),
    projection: Projection,
    min_t: f64,
    objects: Vec<Shape>,
) -> Scene {
    let [eye, back, up] = frame.map(glam::DVec3::from);
    let camera = Camera::new(eye, -back, up, size, projection);
    Scene {
        camera: camera.expect("up is perpendicular to the view"),
        resolution: Resolution { n_x: 8, n_y: 8 },
        min_t,
        objects,
    }
}

/// The scene of small integers with this number.
pub fn grid(seed: u64) -> Scene {
    on_a_grid(&mut Random::new(seed, "grid"))
}

/// A scene of small integers times a power of two, so that rays hit edges, corners and tangents
/// exactly.
fn on_a_grid(random: &mut Random) -> Scene {
    let unit = 2f64.powi(random.below(200) as i32 - 100);
    let whole = |random: &mut Random, most: usize| {
        let number = |random: &mut Random| random.below(2 * most + 1) as f64 - most as f64;
        Vector::new(number(random), number(random), number(random)) * unit
    };
    let mut objects = Vec::new();
    for _ in 0..1 + random.below(18) {
        let at = whole(random, 4);
        objects.push(match random.below(5) {
            0 => sphere(at, unit * (1 + random.below(4)) as f64),
            1 => plane(
                at,
                [whole(random, 2), Vector::new(0.0, 0.0, unit)][random.below(2)],
            ),
            2 => soup(box_of(at, [0, 1, 2].map(|axis| along(axis, unit * 2.0)))),
            _ => Shape::Triangle(shape([at, whole(random, 4), whole(random, 4)])),
        });
    }
    repeat(random, &mut objects, unit);
    let projection = match random.below(2) {
        0 => Projection::Orthographic,
        _ => Projection::Perspective {
            focal_length: 8.0 * unit,
        },
    };
    let frame = [along(2, 8.0 * unit), along(2, 1.0), along(1, 1.0)];
    let min_t = random.below(3) as f64 * unit.min(1.0);
    seen_from(frame, (8.0 * unit, 8.0 * unit), projection, min_t, objects)
}

fn sphere(center: Vector<f64>, radius: f64) -> Shape {
    Shape::Sphere(pinhole::Sphere {
        center: center.into(),
        radius,
    })
}

fn plane(point: Vector<f64>, normal: Vector<f64>) -> Shape {
    let is_any = normal.largest() > 0.0;
    let normal = if is_any { normal } else { along(2, 1.0) };
    Shape::Plane(pinhole::Plane {
        point: point.into(),
        normal: normal.into(),
    })
}

fn soup(triangles: Vec<Triangle>) -> Shape {
    Shape::Soup(TriangleSoup { triangles })
}

fn along(axis: usize, length: f64) -> Vector<f64> {
    let component = |at| if at == axis { length } else { 0.0 };
    Vector::new(component(0), component(1), component(2))
}

/// The twelve triangles of a box.
fn box_of(corner: Vector<f64>, edges: [Vector<f64>; 3]) -> Vec<Triangle> {
    let mut triangles = Vec::new();
    for axis in 0..3 {
        let (p, q) = (edges[(axis + 1) % 3], edges[(axis + 2) % 3]);
        for a in [corner, corner + edges[axis]] {
            triangles.extend([shape([a, a + p, a + p + q]), shape([a, a + p + q, a + q])]);
        }
    }
    triangles
}

/// A rotated box, which may be very thin.
fn crate_of(random: &mut Random, at: Vector<f64>, size: f64) -> Shape {
    let x = random.unit();
    let y = random.unit_across(x);
    let thin = [1.0, power(random, -12.0, 0.0)][random.below(2)];
    soup(box_of(at, [x * size, y * size, x.cross(y) * (size * thin)]))
}

/// A triangle that may be 1e13 times as long as it is wide.
fn sliver(random: &mut Random, at: Vector<f64>, size: f64) -> Shape {
    let long = random.unit() * size;
    let wide = random.unit() * (size * power(random, -13.0, 0.0));
    let third = at + long * random.within(-1.0, 2.0) + wide;
    soup(vec![shape([at, at + long, third])])
}

/// A plane or a triangle that is seen nearly edge-on.
fn edge_on(random: &mut Random, at: Vector<f64>, size: f64, view: Vector<f64>) -> Shape {
    let across = random.unit_across(view);
    let tilted = view + across * power(random, -15.0, -1.0);
    match random.below(2) {
        0 => plane(at, tilted.cross(view.cross(across))),
        _ => Shape::Triangle(shape([
            at + tilted * size,
            at + view.cross(across) * size,
            at - tilted * size,
        ])),
    }
}

/// A sphere or a plane very close to the eye.
fn at_the_eye(random: &mut Random, eye: Vector<f64>, size: f64) -> Shape {
    let (to, hair) = (random.unit(), size * power(random, -14.0, 0.0));
    let radius = size * power(random, -2.0, 2.0);
    match random.below(3) {
        0 => plane(eye + to * hair, to),
        1 => sphere(eye + to * (radius + hair), radius),
        _ => sphere(eye + to * (radius - hair).abs(), radius),
    }
}

/// Repeats some objects, exactly or moved by a tiny distance, so that it is hard to tell which
/// is first.
fn repeat(random: &mut Random, objects: &mut Vec<Shape>, size: f64) {
    for _ in 0..random.below(4) {
        let mut again = objects[random.below(objects.len())].clone();
        let hair = [0.0, size * power(random, -17.0, -3.0)][random.below(2)];
        let by: glam::DVec3 = (random.unit() * hair).into();
        match &mut again {
            Shape::Sphere(sphere) => sphere.center += by,
            Shape::Plane(plane) => plane.point += by,
            Shape::Triangle(triangle) => move_by(triangle, by),
            Shape::Soup(soup) => {
                for triangle in &mut soup.triangles {
                    move_by(triangle, by);
                }
            }
            _ => (),
        }
        objects.push(again);
    }
}

fn move_by(triangle: &mut Triangle, by: glam::DVec3) {
    triangle.corners = triangle.corners.map(|corner| corner + by);
}
