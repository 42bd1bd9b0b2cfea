use pinhole::{Camera, Pixel, Projection, Ray, Resolution};

pub fn viewing_ray(camera: &Camera, pixel: Pixel, resolution: Resolution) -> Ray {
    let across = (pixel.i as f64 + 0.5) / resolution.n_x as f64;
    let upward = (pixel.j as f64 + 0.5) / resolution.n_y as f64;
    let right = camera.width * camera.u;
    let up = camera.height * camera.v;
    let bottom = (-right - up).lerp(right - up, across);
    let top = (up - right).lerp(up + right, across);
    let offset = bottom.lerp(top, upward);
    if let Projection::Perspective { focal_length } = camera.projection {
        Ray {
            origin: camera.eye,
            direction: offset - focal_length * camera.w,
        }
    } else {
        Ray {
            origin: camera.eye + offset,
            direction: -camera.w,
        }
    }
}
