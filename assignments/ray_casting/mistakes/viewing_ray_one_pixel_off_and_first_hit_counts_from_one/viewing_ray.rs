use pinhole::{Camera, Pixel, Projection, Ray, Resolution};

pub fn viewing_ray(camera: &Camera, pixel: Pixel, resolution: Resolution) -> Ray {
    let pixel_width = camera.width / resolution.n_x as f64;
    let pixel_height = camera.height / resolution.n_y as f64;
    let from_left = pixel.i as f64 + 0.5;
    let from_top = (resolution.n_y - pixel.j) as f64 + 0.5;
    let x = from_left * pixel_width - camera.width / 2.0;
    let y = camera.height / 2.0 - from_top * pixel_height;
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
