use pinhole::{Camera, Pixel, Projection, Ray, Resolution};

pub fn viewing_ray(camera: &Camera, pixel: Pixel, resolution: Resolution) -> Ray {
    let x = camera.width / resolution.n_x as f64 * (pixel.i as f64 + 0.5) - camera.width / 2.0;
    let y = camera.height / resolution.n_y as f64 * (pixel.j as f64 + 0.5) - camera.height / 2.0;
    match camera.projection {
        Projection::Perspective { .. } => Ray {
            origin: camera.eye,
            direction: x * camera.u + y * camera.v - camera.w,
        },
        Projection::Orthographic => Ray {
            origin: camera.eye + x * camera.u + y * camera.v,
            direction: -camera.w,
        },
    }
}
