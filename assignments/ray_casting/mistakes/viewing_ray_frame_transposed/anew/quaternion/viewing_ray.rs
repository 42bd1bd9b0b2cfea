use glam::{DMat3, DQuat, DVec3};
use pinhole::{Camera, Pixel, Projection, Ray, Resolution};

pub fn viewing_ray(camera: &Camera, pixel: Pixel, resolution: Resolution) -> Ray {
    let ndc_x = 2.0 * (pixel.i as f64 + 0.5) / resolution.n_x as f64 - 1.0;
    let ndc_y = 2.0 * (pixel.j as f64 + 0.5) / resolution.n_y as f64 - 1.0;
    let frame = DMat3::from_cols(camera.u, camera.v, camera.w);
    let rotation = DQuat::from_mat3(&frame).inverse();
    let x = ndc_x * camera.width / 2.0;
    let y = ndc_y * camera.height / 2.0;
    match camera.projection {
        Projection::Perspective { focal_length } => Ray {
            origin: camera.eye,
            direction: rotation * DVec3::new(x, y, -focal_length),
        },
        Projection::Orthographic => Ray {
            origin: camera.eye + rotation * DVec3::new(x, y, 0.0),
            direction: rotation * DVec3::NEG_Z,
        },
    }
}
