//! The lecture's camera, and the numbers for pixel (2, 3).

use pinhole::{Pixel, Projection, Resolution, Scene, Shape};
use pinhole_course::checkout::Checkout;

use super::{Values, shown, vector};
use crate::course::assignment;
use crate::error::Result;
use crate::reference::Reference;

/// The lecture's pixel.
pub const PIXEL: Pixel = Pixel { i: 2, j: 3 };

/// Converts a place from pixel space to an image plane of this width (or height), in scene units
/// from its middle (Marschner & Shirley, 4th ed., §4.3).
pub fn on_plane(place: f64, width: f64, pixels: usize) -> f64 {
    width / pixels as f64 * place - width / 2.0
}

/// The lecture's scene.
pub fn slide(checkout: &Checkout) -> Result<Scene> {
    Ok(Scene::read(&assignment(checkout)?.scene("slide_example"))?)
}

/// Adds this chapter's numbers.
pub fn add(values: &mut Values, reference: &Reference, checkout: &Checkout) -> Result<()> {
    let scene = slide(checkout)?;
    let (camera, Resolution { n_x, n_y }) = (scene.camera, scene.resolution);
    let mut add = |name: &str, text| values.insert(format!("slide_{name}"), text);
    add("frame_u", vector(camera.u));
    add("frame_v", vector(camera.v));
    add("frame_w", vector(camera.w));
    add(
        "u",
        shown(on_plane(PIXEL.i as f64 + 0.5, camera.width, n_x)),
    );
    add(
        "v",
        shown(on_plane(PIXEL.j as f64 + 0.5, camera.height, n_y)),
    );
    let ray = reference.viewing_ray(camera, PIXEL, scene.resolution)?;
    add("ray_origin", vector(ray.origin));
    add("ray_direction", vector(ray.direction));
    add("ray_length", shown(ray.direction.length()));
    add("ray_forward", shown(ray.direction.dot(-camera.w)));
    let min_t = match camera.projection {
        Projection::Perspective { .. } => 1.0,
        Projection::Orthographic => 0.0,
    };
    let is_plane = |shape: &&Shape| matches!(shape, Shape::Plane(_));
    if let Some(plane) = scene.objects.iter().find(is_plane) {
        let at = reference.intersect(plane, ray, min_t)?;
        add("plane_t", at.map_or("none".into(), |at| shown(at.t)));
    }
    Ok(())
}
