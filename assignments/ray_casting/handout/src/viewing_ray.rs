use pinhole::{Camera, Pixel, Projection, Ray, Resolution};

// ANCHOR: stub
/// The ray through the centre of a pixel, in world space.
///
/// Pixel (i, j) is column i from the left and row j from the **bottom**; its centre
/// is (i + ½, j + ½) in pixel space. The image plane is `camera.width` ×
/// `camera.height` scene units, centred on the line of sight, and holds
/// `resolution.n_x` × `resolution.n_y` pixels, which need not be square.
///
/// `camera.u`, `camera.v`, `camera.w` are unit, world space; the camera looks
/// along −w.
///
/// - `Projection::Perspective { focal_length }`: the origin is the eye, and the
///   direction leads from it to the point s on the image plane, which stands
///   `focal_length` in front of the eye. Its length is |s − e|, **not** 1: t = 1 is
///   on the image plane.
/// - `Projection::Orthographic`: the origin is the point on the image plane, which
///   contains the eye; the direction is −w.
///
/// Book: Viewing rays.
pub fn viewing_ray(camera: &Camera, pixel: Pixel, resolution: Resolution) -> Ray {
    todo!("viewing_ray")
}
// ANCHOR_END: stub
