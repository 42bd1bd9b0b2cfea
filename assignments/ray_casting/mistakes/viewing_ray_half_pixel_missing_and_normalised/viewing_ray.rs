use pinhole::{Camera, Pixel, Projection, Ray, Resolution};

pub fn viewing_ray(camera: &Camera, pixel: Pixel, resolution: Resolution) -> Ray {
    let right = camera.width / resolution.n_x as f64 * camera.u;
    let up = camera.height / resolution.n_y as f64 * camera.v;
    let corner = -0.5 * (camera.width * camera.u + camera.height * camera.v);
    let offset = corner + pixel.i as f64 * right + pixel.j as f64 * up;
    match camera.projection {
        Projection::Perspective { focal_length } => Ray {
            origin: camera.eye,
            direction: (offset - focal_length * camera.w).normalize(),
        },
        Projection::Orthographic => Ray {
            origin: camera.eye + offset,
            direction: -camera.w,
        },
    }
}
