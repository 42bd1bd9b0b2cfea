use pinhole::{Camera, Pixel, Projection, Ray, Resolution};

fn along(index: usize, count: usize, size: f64) -> f64 {
    let step = size / (count as f64 - 1.0);
    index as f64 * step - size / 2.0
}

pub fn viewing_ray(camera: &Camera, pixel: Pixel, resolution: Resolution) -> Ray {
    let x = along(pixel.i, resolution.n_x, camera.width);
    let y = along(pixel.j, resolution.n_y, camera.height);
    let on_plane = camera.eye + camera.u * x + camera.v * y;
    match camera.projection {
        Projection::Orthographic => Ray {
            origin: on_plane,
            direction: -camera.w,
        },
        Projection::Perspective { focal_length } => Ray {
            origin: camera.eye,
            direction: on_plane - focal_length * camera.w - camera.eye,
        },
    }
}
