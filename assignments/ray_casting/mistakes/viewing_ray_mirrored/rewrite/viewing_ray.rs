use pinhole::{Camera, Pixel, Projection, Ray, Resolution};

pub fn viewing_ray(camera: &Camera, pixel: Pixel, resolution: Resolution) -> Ray {
    // In half pixels from the middle of the picture.
    let right = resolution.n_x as i64 - 1 - 2 * pixel.i as i64;
    let up = 2 * pixel.j as i64 + 1 - resolution.n_y as i64;
    let half_width = camera.width / (2 * resolution.n_x) as f64;
    let half_height = camera.height / (2 * resolution.n_y) as f64;
    let offset = camera.u * (half_width * right as f64) + camera.v * (half_height * up as f64);
    let mut ray = Ray {
        origin: camera.eye,
        direction: -camera.w,
    };
    match camera.projection {
        Projection::Perspective { focal_length } => {
            ray.direction = offset + focal_length * ray.direction;
        }
        Projection::Orthographic => ray.origin += offset,
    }
    ray
}
