use pinhole::{Camera, Pixel, Projection, Ray, Resolution};

pub fn viewing_ray(camera: &Camera, pixel: Pixel, resolution: Resolution) -> Ray {
    let step_right = camera.width / resolution.n_x as f64 * camera.u;
    let step_up = camera.height / resolution.n_y as f64 * camera.v;
    let centre = match camera.projection {
        Projection::Perspective { focal_length } => camera.eye - focal_length * camera.w,
        Projection::Orthographic => camera.eye,
    };
    let (middle_i, middle_j) = ((resolution.n_x >> 1) as f64, (resolution.n_y >> 1) as f64);
    let corner = centre - middle_i * step_right - middle_j * step_up;
    let s = corner + (pixel.i as f64 + 0.5) * step_right + (pixel.j as f64 + 0.5) * step_up;
    match camera.projection {
        Projection::Perspective { .. } => Ray {
            origin: camera.eye,
            direction: s - camera.eye,
        },
        Projection::Orthographic => Ray {
            origin: s,
            direction: -camera.w,
        },
    }
}
