use glam::{DMat3, DVec3};
use pinhole::{Camera, Pixel, Projection, Ray, Resolution};

pub fn viewing_ray(camera: &Camera, pixel: Pixel, resolution: Resolution) -> Ray {
    let (n_x, n_y) = (resolution.n_x as f64, resolution.n_y as f64);
    let (right, up) = (camera.width * camera.u, camera.height * camera.v);
    let to_corner = -(right + up) / 2.0;
    let plane_from_pixel = DMat3::from_cols(right / n_x, up / n_y, to_corner);
    let offset = plane_from_pixel * DVec3::new(pixel.i as f64, pixel.j as f64, 1.0)
        + (camera.u + camera.v) / 2.0;
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
