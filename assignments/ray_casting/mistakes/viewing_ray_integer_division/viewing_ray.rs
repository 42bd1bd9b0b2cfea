use pinhole::{Camera, Pixel, Projection, Ray, Resolution};

pub fn viewing_ray(camera: &Camera, pixel: Pixel, resolution: Resolution) -> Ray {
    let across = (pixel.i / resolution.n_x) as f64 + 0.5 / resolution.n_x as f64;
    let upward = (pixel.j / resolution.n_y) as f64 + 0.5 / resolution.n_y as f64;
    let x = camera.width * (across - 0.5);
    let y = camera.height * (upward - 0.5);
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
