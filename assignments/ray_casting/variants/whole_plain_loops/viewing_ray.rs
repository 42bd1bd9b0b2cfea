use glam::DVec3;
use pinhole::{Camera, Pixel, Projection, Ray, Resolution};

pub fn viewing_ray(camera: &Camera, pixel: Pixel, resolution: Resolution) -> Ray {
    let pixel_width = camera.width / resolution.n_x as f64;
    let pixel_height = camera.height / resolution.n_y as f64;
    let left = -camera.width / 2.0;
    let bottom = -camera.height / 2.0;
    let x = left + pixel.i as f64 * pixel_width + pixel_width / 2.0;
    let y = bottom + pixel.j as f64 * pixel_height + pixel_height / 2.0;

    let mut origin = [0.0; 3];
    let mut direction = [0.0; 3];
    for k in 0..3 {
        let on_plane = camera.u[k] * x + camera.v[k] * y;
        match camera.projection {
            Projection::Perspective { focal_length } => {
                origin[k] = camera.eye[k];
                direction[k] = on_plane - camera.w[k] * focal_length;
            }
            Projection::Orthographic => {
                origin[k] = camera.eye[k] + on_plane;
                direction[k] = -camera.w[k];
            }
        }
    }
    Ray {
        origin: DVec3::from_array(origin),
        direction: DVec3::from_array(direction),
    }
}
