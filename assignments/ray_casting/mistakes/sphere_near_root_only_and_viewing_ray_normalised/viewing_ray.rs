use pinhole::{Camera, Pixel, Projection, Ray, Resolution};

pub fn viewing_ray(camera: &Camera, pixel: Pixel, resolution: Resolution) -> Ray {
    let right = camera.width * ((pixel.i as f64 + 0.5) / resolution.n_x as f64 - 0.5);
    let up = camera.height * ((pixel.j as f64 + 0.5) / resolution.n_y as f64 - 0.5);
    let offset = right * camera.u + up * camera.v;
    let (origin, direction) = match camera.projection {
        Projection::Perspective { focal_length } => (camera.eye, offset - focal_length * camera.w),
        Projection::Orthographic => (camera.eye + offset, -camera.w),
    };
    Ray {
        origin,
        direction: direction.normalize(),
    }
}
