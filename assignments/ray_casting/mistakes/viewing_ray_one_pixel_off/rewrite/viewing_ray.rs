use pinhole::{Camera, Pixel, Projection, Ray, Resolution};

pub fn viewing_ray(camera: &Camera, pixel: Pixel, resolution: Resolution) -> Ray {
    let across = (pixel.i as f64 + 0.5) / resolution.n_x as f64;
    let downward = ((resolution.n_y - pixel.j) as f64 + 0.5) / resolution.n_y as f64;
    let half_u = 0.5 * camera.width * camera.u;
    let half_v = 0.5 * camera.height * camera.v;
    let bottom = (-half_u - half_v).lerp(half_u - half_v, across);
    let top = (half_v - half_u).lerp(half_v + half_u, across);
    let offset = top.lerp(bottom, downward);
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
