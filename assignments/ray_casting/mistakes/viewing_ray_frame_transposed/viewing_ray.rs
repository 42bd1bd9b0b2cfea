use glam::DVec3;
use pinhole::{Camera, Pixel, Projection, Ray, Resolution};

pub fn viewing_ray(camera: &Camera, pixel: Pixel, resolution: Resolution) -> Ray {
    let x = camera.width / resolution.n_x as f64 * (pixel.i as f64 + 0.5) - camera.width / 2.0;
    let y = camera.height / resolution.n_y as f64 * (pixel.j as f64 + 0.5) - camera.height / 2.0;
    let to_world = |p: DVec3| DVec3::new(camera.u.dot(p), camera.v.dot(p), camera.w.dot(p));
    match camera.projection {
        Projection::Perspective { focal_length } => Ray {
            origin: camera.eye,
            direction: to_world(DVec3::new(x, y, -focal_length)),
        },
        Projection::Orthographic => Ray {
            origin: camera.eye + to_world(DVec3::new(x, y, 0.0)),
            direction: to_world(DVec3::NEG_Z),
        },
    }
}
