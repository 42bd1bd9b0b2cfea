use glam::DVec3;
use pinhole::{Camera, Pixel, Projection, Ray, Resolution};

pub fn viewing_ray(camera: &Camera, pixel: Pixel, resolution: Resolution) -> Ray {
    let step_right = camera.width / resolution.n_x as f64 * DVec3::X;
    let step_up = camera.height / resolution.n_y as f64 * DVec3::Y;
    let centre = match camera.projection {
        Projection::Perspective { focal_length } => camera.eye - focal_length * DVec3::Z,
        Projection::Orthographic => camera.eye,
    };
    let corner = centre - DVec3::new(camera.width, camera.height, 0.0) / 2.0;
    let s = corner + (pixel.i as f64 + 0.5) * step_right + (pixel.j as f64 + 0.5) * step_up;
    match camera.projection {
        Projection::Perspective { .. } => Ray {
            origin: camera.eye,
            direction: s - camera.eye,
        },
        Projection::Orthographic => Ray {
            origin: s,
            direction: -DVec3::Z,
        },
    }
}
