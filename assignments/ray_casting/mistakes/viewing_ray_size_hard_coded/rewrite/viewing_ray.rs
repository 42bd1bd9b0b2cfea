use pinhole::{Camera, Pixel, Projection, Ray, Resolution};

pub fn viewing_ray(camera: &Camera, pixel: Pixel, resolution: Resolution) -> Ray {
    let ndc_x = 2.0 * (pixel.i as f64 + 0.5) / resolution.n_x as f64 - 1.0;
    let ndc_y = 2.0 * (pixel.j as f64 + 0.5) / resolution.n_y as f64 - 1.0;
    let a = camera.u * (camera.width / 2.0);
    let b = camera.v * (camera.width * 9.0 / 32.0);
    let in_plane = ndc_x * a + ndc_y * b;
    let (start, end) = match camera.projection {
        Projection::Perspective { focal_length } => {
            let plane = camera.eye - focal_length * camera.w;
            (camera.eye, plane + in_plane)
        }
        Projection::Orthographic => {
            let start = camera.eye + in_plane;
            (start, start - camera.w)
        }
    };
    Ray {
        origin: start,
        direction: end - start,
    }
}
