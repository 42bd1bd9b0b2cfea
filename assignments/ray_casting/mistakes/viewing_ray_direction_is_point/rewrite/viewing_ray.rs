use glam::{DMat3, DVec3};
use pinhole::{Camera, Pixel, Projection, Ray, Resolution};

pub fn viewing_ray(camera: &Camera, pixel: Pixel, resolution: Resolution) -> Ray {
    let to_world = DMat3::from_cols(camera.u, camera.v, camera.w);
    let x = ((pixel.i as f64 + 0.5) / resolution.n_x as f64 - 0.5) * camera.width;
    let y = ((pixel.j as f64 + 0.5) / resolution.n_y as f64 - 0.5) * camera.height;
    let on_plane = |z: f64| camera.eye + to_world * DVec3::new(x, y, z);
    match camera.projection {
        Projection::Perspective { focal_length } => Ray {
            origin: camera.eye,
            direction: on_plane(-focal_length),
        },
        Projection::Orthographic => Ray {
            origin: on_plane(0.0),
            direction: to_world * DVec3::NEG_Z,
        },
    }
}
