//! A slice through a scene: the plane that the viewing rays of one column stay in.
//!
//! A point in the slice is (depth, height), and p = e + depth g + height v, where g is the
//! column's direction, one unit forward. A ray meets the same objects in the slice as in space.

use glam::{DVec2, DVec3, dvec2};
use pinhole::{Scene, Shape};
use serde_json::{Value, json};

/// The objects in the slice of the column whose rays lean to the right by `lean` for each unit
/// forward: ellipses as [depth, height, and their radii], lines as two points.
pub fn slice(scene: &Scene, lean: f64) -> Value {
    let camera = &scene.camera;
    let (g, v) = (lean * camera.u - camera.w, camera.v);
    let outlines = scene
        .objects
        .iter()
        .enumerate()
        .filter_map(|(object, shape)| {
            let outline = match shape {
                Shape::Sphere(sphere) => {
                    let m = camera.eye - sphere.center;
                    let (depth, height) = (-g.dot(m) / g.length_squared(), -v.dot(m));
                    let aside = m + depth * g + height * v;
                    let radius = (sphere.radius * sphere.radius - aside.length_squared()).sqrt();
                    let numbers = [depth, height, radius / g.length(), radius];
                    (!radius.is_nan()).then(|| json!({ "ellipse": numbers.map(short) }))
                }
                Shape::Triangle(triangle) => {
                    let corners = triangle.corners.map(|corner| corner - camera.eye);
                    cut(corners, g, v).map(line)
                }
                Shape::Plane(plane) => {
                    let (from_eye, n) = (plane.point - camera.eye, plane.normal);
                    let depth = |height: f64| (from_eye - height * v).dot(n) / g.dot(n);
                    let ends = [-10.0, 10.0].map(|height| dvec2(depth(height), height));
                    Some(line(ends))
                }
                _ => None,
            };
            outline.map(|mut outline| {
                outline["object"] = json!(object);
                outline
            })
        });
    outlines.collect()
}

/// Where a triangle's border crosses the slice; corners are seen from the eye.
fn cut(corners: [DVec3; 3], g: DVec3, v: DVec3) -> Option<[DVec2; 2]> {
    let aside = g.cross(v);
    let flat = |p: DVec3| dvec2(p.dot(g) / g.length_squared(), p.dot(v));
    let crossings = (0..3).filter_map(|k| {
        let (from, to) = (corners[k], corners[(k + 1) % 3]);
        let (one, other) = (from.dot(aside), to.dot(aside));
        ((one < 0.0) != (other < 0.0)).then(|| flat(from.lerp(to, one / (one - other))))
    });
    crossings.collect::<Vec<DVec2>>().try_into().ok()
}

fn line([from, to]: [DVec2; 2]) -> Value {
    let numbers = [from.x, from.y, to.x, to.y].map(short);
    json!({ "line": numbers })
}

/// Rounds to more digits than a drawing shows.
fn short(value: f64) -> f64 {
    (value * 1000.0).round() / 1000.0
}
