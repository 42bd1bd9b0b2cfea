use glam::DVec3;
use pinhole::{Camera, Pixel, Projection, Ray, Resolution};

pub fn viewing_ray(camera: &Camera, pixel: Pixel, resolution: Resolution) -> Ray {
    let axes = [
        (pixel.i, resolution.n_x, camera.width, camera.u),
        (pixel.j, resolution.n_y, camera.height, camera.v),
    ];
    let offset: DVec3 = axes
        .into_iter()
        .map(|(index, count, size, axis)| {
            let share = (index as f64 + 0.5) / count as f64;
            size * (share - 0.5) * axis
        })
        .sum();
    match camera.projection {
        Projection::Perspective { focal_length } => Ray {
            origin: camera.eye,
            direction: offset - focal_length * camera.w,
        },
        Projection::Orthographic => Ray {
            origin: camera.eye,
            direction: offset - camera.w,
        },
    }
}
