use glam::DVec3;
use pinhole::{Camera, Pixel, Projection, Ray, Resolution};

pub fn viewing_ray(camera: &Camera, pixel: Pixel, resolution: Resolution) -> Ray {
    let across = (pixel.i as f64 + 0.5) / resolution.n_x as f64;
    let upward = (pixel.j as f64 + 0.5) / resolution.n_y as f64;
    let x = across.mul_add(camera.width, -camera.width / 2.0);
    let y = upward.mul_add(camera.height, -camera.height / 2.0);
    let add = |axis: DVec3, length: f64, to: DVec3| axis.mul_add(DVec3::splat(length), to);
    match camera.projection {
        Projection::Perspective { focal_length } => {
            let forward = -focal_length * camera.w;
            Ray {
                origin: camera.eye,
                direction: add(camera.u, x, add(camera.v, y, forward)),
            }
        }
        Projection::Orthographic => Ray {
            origin: add(camera.u, x, add(camera.v, y, camera.eye)),
            direction: -camera.w,
        },
    }
}
