use glam::DVec3;
use pinhole::{Camera, Pixel, Projection, Ray, Resolution};

pub fn viewing_ray(camera: &Camera, pixel: Pixel, resolution: Resolution) -> Ray {
    let ndc_x = 2.0 * (pixel.i as f64 + 0.5) / resolution.n_x as f64 - 1.0;
    let ndc_y = 2.0 * (pixel.j as f64 + 0.5) / resolution.n_y as f64 - 1.0;
    let half_size = DVec3::new(camera.width, camera.height, 0.0) / 2.0;
    let in_plane = DVec3::new(ndc_x, ndc_y, 0.0) * half_size;
    let (start, end) = match camera.projection {
        Projection::Perspective { focal_length } => {
            (camera.eye, camera.eye + in_plane.with_z(-focal_length))
        }
        Projection::Orthographic => {
            let start = camera.eye + in_plane;
            (start, start + DVec3::NEG_Z)
        }
    };
    Ray {
        origin: start,
        direction: end - start,
    }
}
