use pinhole::{Camera, Pixel, Projection, Ray, Resolution};

pub fn viewing_ray(camera: &Camera, pixel: Pixel, resolution: Resolution) -> Ray {
    let on_plane = |column: f64, row: f64| {
        let across = column / resolution.n_x as f64 - 0.5;
        let upward = row / resolution.n_y as f64 - 0.5;
        across * camera.width * camera.u + upward * camera.height * camera.v
    };
    let (i, j) = (pixel.i as f64, pixel.j as f64);
    let lower_left = on_plane(i - 1.0, j - 1.0);
    let upper_right = on_plane(i, j);
    let middle = lower_left.midpoint(upper_right);
    match camera.projection {
        Projection::Orthographic => Ray {
            origin: camera.eye + middle,
            direction: -camera.w,
        },
        Projection::Perspective { focal_length } => Ray {
            origin: camera.eye,
            direction: middle - focal_length * camera.w,
        },
    }
}
