use pinhole::{Camera, Pixel, Projection, Ray, Resolution};

pub fn viewing_ray(camera: &Camera, pixel: Pixel, resolution: Resolution) -> Ray {
    let x = ((pixel.i as f64 + 0.5) / resolution.n_x as f64 - 0.5) * camera.height;
    let y = ((pixel.j as f64 + 0.5) / resolution.n_y as f64 - 0.5) * camera.width;
    let offset = x * camera.u + y * camera.v;
    match camera.projection {
        Projection::Perspective { .. } => Ray {
            origin: camera.eye,
            direction: offset - camera.w,
        },
        Projection::Orthographic => Ray {
            origin: camera.eye + offset,
            direction: -camera.w,
        },
    }
}
