use pinhole::{Camera, Pixel, Projection, Ray, Resolution};

pub fn viewing_ray(camera: &Camera, pixel: Pixel, resolution: Resolution) -> Ray {
    let (n_x, n_y) = (resolution.n_x as f64, resolution.n_y as f64);
    let row_from_top = n_y - pixel.j as f64;
    let x = camera.width / n_x * (pixel.i as f64 + 0.5) - camera.width / 2.0;
    let y = camera.height / 2.0 - camera.height / n_y * (row_from_top + 0.5);
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
