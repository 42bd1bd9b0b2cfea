use glam::DVec3;
use pinhole::{Camera, Pixel, Projection, Ray, Resolution};

pub fn viewing_ray(camera: &Camera, pixel: Pixel, resolution: Resolution) -> Ray {
    let middle = match camera.projection {
        Projection::Perspective { focal_length } => -focal_length * camera.w,
        Projection::Orthographic => DVec3::ZERO,
    };
    let (right, up) = (camera.u * camera.width, camera.v * camera.height);
    // A point divides its row of the plane as its index divides the row of pixels.
    let between = |from: DVec3, to: DVec3, index: usize, count: usize| {
        let after = (2 * index + 1) as f64;
        let before = (2 * count) as f64 - after;
        (before * from + after * to) / (2 * count) as f64
    };
    let left_edge = between(-up / 2.0, up / 2.0, pixel.j, resolution.n_y) - right / 2.0;
    let s = middle + between(left_edge, left_edge + right, pixel.i, resolution.n_x);
    match camera.projection {
        Projection::Perspective { .. } => Ray {
            origin: camera.eye,
            direction: s,
        },
        Projection::Orthographic => Ray {
            origin: camera.eye + s,
            direction: -camera.w,
        },
    }
}
