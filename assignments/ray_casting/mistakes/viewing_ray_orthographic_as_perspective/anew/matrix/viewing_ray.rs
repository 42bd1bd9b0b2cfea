use glam::{DMat3, DVec3};
use pinhole::{Camera, Pixel, Projection, Ray, Resolution};

pub fn viewing_ray(camera: &Camera, pixel: Pixel, resolution: Resolution) -> Ray {
    let to_world = DMat3::from_cols(camera.u, camera.v, camera.w);
    let x = ((pixel.i as f64 + 0.5) / resolution.n_x as f64 - 0.5) * camera.width;
    let y = ((pixel.j as f64 + 0.5) / resolution.n_y as f64 - 0.5) * camera.height;
    let z = if let Projection::Perspective { focal_length } = camera.projection {
        -focal_length
    } else {
        -1.0
    };
    Ray {
        origin: camera.eye,
        direction: to_world * DVec3::new(x, y, z),
    }
}
