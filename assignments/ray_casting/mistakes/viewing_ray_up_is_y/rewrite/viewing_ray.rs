use glam::{DVec2, DVec3};
use pinhole::{Camera, Pixel, Projection, Ray, Resolution};

pub fn viewing_ray(camera: &Camera, pixel: Pixel, resolution: Resolution) -> Ray {
    let size = DVec2::new(camera.width, camera.height);
    let pixels = DVec2::new(resolution.n_x as f64, resolution.n_y as f64);
    let place = DVec2::new(pixel.i as f64, pixel.j as f64) + 0.5;
    let p = (place - pixels / 2.0) * size / pixels;
    let offset = p.x * camera.u + DVec3::new(0.0, p.y, 0.0);
    let (origin, direction) = match camera.projection {
        Projection::Perspective { focal_length } => (camera.eye, offset - focal_length * camera.w),
        Projection::Orthographic => (camera.eye + offset, -camera.w),
    };
    Ray { origin, direction }
}
