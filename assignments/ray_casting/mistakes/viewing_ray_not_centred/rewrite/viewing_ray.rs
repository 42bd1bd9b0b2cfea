use pinhole::{Camera, Pixel, Projection, Ray, Resolution};

pub fn viewing_ray(camera: &Camera, pixel: Pixel, resolution: Resolution) -> Ray {
    let on_plane = |column: usize, row: usize| {
        let across = column as f64 / resolution.n_x as f64;
        let upward = row as f64 / resolution.n_y as f64;
        across * camera.width * camera.u + upward * camera.height * camera.v
    };
    let lower_left = on_plane(pixel.i, pixel.j);
    let upper_right = on_plane(pixel.i + 1, pixel.j + 1);
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
