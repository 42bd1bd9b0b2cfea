use glam::{DVec2, DVec3};
use pinhole::{Camera, Pixel, Projection, Ray, Resolution};

pub fn viewing_ray(camera: &Camera, pixel: Pixel, resolution: Resolution) -> Ray {
    let size = DVec2::new(camera.width, camera.height);
    let pixels = DVec2::new(resolution.n_x as f64, resolution.n_y as f64);
    let place = DVec2::new(pixel.i as f64, pixel.j as f64) + 0.5;
    let p = (place - pixels / 2.0) * size / pixels;
    let rows = [camera.u, camera.v, camera.w];
    let turn = |p: DVec3| DVec3::from_array(rows.map(|row| row.dot(p)));
    let (origin, direction) = match camera.projection {
        Projection::Perspective { focal_length } => (camera.eye, turn(p.extend(-focal_length))),
        Projection::Orthographic => (camera.eye + turn(p.extend(0.0)), turn(DVec3::NEG_Z)),
    };
    Ray { origin, direction }
}
