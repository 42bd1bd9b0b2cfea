use glam::{DMat3, DVec3};
use pinhole::{Camera, Pixel, Projection, Ray, Resolution};

pub fn viewing_ray(camera: &Camera, pixel: Pixel, resolution: Resolution) -> Ray {
    let to_world = DMat3::from_diagonal(DVec3::new(camera.u.x, camera.v.y, camera.w.z));
    let x = ((pixel.i as f64 + 0.5) / resolution.n_x as f64 - 0.5) * camera.width;
    let y = ((pixel.j as f64 + 0.5) / resolution.n_y as f64 - 0.5) * camera.height;
    let (start, forward) = match camera.projection {
        Projection::Perspective { focal_length } => {
            (DVec3::ZERO, to_world * DVec3::new(x, y, -focal_length))
        }
        Projection::Orthographic => (to_world * DVec3::new(x, y, 0.0), -camera.w),
    };
    Ray {
        origin: camera.eye + start,
        direction: forward,
    }
}
