use pinhole::{Camera, Pixel, Projection, Ray, Resolution};

pub fn viewing_ray(camera: &Camera, pixel: Pixel, resolution: Resolution) -> Ray {
    let columns = pixel.i as f64 + 0.5 - (resolution.n_x / 2) as f64;
    let rows = pixel.j as f64 + 0.5 - (resolution.n_y / 2) as f64;
    let x = camera.width / resolution.n_x as f64 * columns;
    let y = camera.height / resolution.n_y as f64 * rows;
    match camera.projection {
        Projection::Perspective { focal_length } => Ray {
            origin: camera.eye,
            direction: x * camera.u + y * camera.v - focal_length * camera.w,
        },
        Projection::Orthographic => Ray {
            origin: camera.eye + x * camera.u + y * camera.v,
            direction: -camera.w,
        },
    }
}
