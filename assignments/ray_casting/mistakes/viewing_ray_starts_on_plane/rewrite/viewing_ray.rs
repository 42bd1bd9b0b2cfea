use pinhole::{Camera, Pixel, Projection, Ray, Resolution};

pub fn viewing_ray(camera: &Camera, pixel: Pixel, resolution: Resolution) -> Ray {
    let step_right = camera.width / resolution.n_x as f64 * camera.u;
    let step_up = camera.height / resolution.n_y as f64 * camera.v;
    let centre = match camera.projection {
        Projection::Perspective { focal_length } => camera.eye - focal_length * camera.w,
        Projection::Orthographic => camera.eye,
    };
    let corner = centre - camera.width / 2.0 * camera.u - camera.height / 2.0 * camera.v;
    let s = corner + (pixel.i as f64 + 0.5) * step_right + (pixel.j as f64 + 0.5) * step_up;
    let direction = match camera.projection {
        Projection::Perspective { .. } => s - camera.eye,
        Projection::Orthographic => -camera.w,
    };
    Ray {
        origin: s,
        direction,
    }
}
