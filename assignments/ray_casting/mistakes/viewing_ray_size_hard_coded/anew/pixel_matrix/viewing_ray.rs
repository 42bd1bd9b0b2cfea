use glam::{DMat3, DVec3};
use pinhole::{Camera, Pixel, Projection, Ray, Resolution};

const ASPECT: f64 = 16.0 / 9.0;

pub fn viewing_ray(camera: &Camera, pixel: Pixel, resolution: Resolution) -> Ray {
    let (n_x, n_y) = (resolution.n_x as f64, resolution.n_y as f64);
    let (right, up) = (camera.width * camera.u, camera.width / ASPECT * camera.v);
    let plane_from_pixel = DMat3::from_cols(right / n_x, up / n_y, -(right + up) / 2.0);
    let offset = plane_from_pixel * DVec3::new(pixel.i as f64 + 0.5, pixel.j as f64 + 0.5, 1.0);
    match camera.projection {
        Projection::Perspective { focal_length: d } => Ray {
            origin: camera.eye,
            direction: offset - d * camera.w,
        },
        Projection::Orthographic => Ray {
            origin: camera.eye + offset,
            direction: -camera.w,
        },
    }
}
