use super::*;
use crate::testing::Random;

const SIZE: (f64, f64) = (2.0, 1.5);
const PERSPECTIVE: Projection = Projection::Perspective { focal_length: 1.5 };

fn camera(view: DVec3, up: DVec3) -> Option<Camera> {
    Camera::new(DVec3::new(1.0, 2.0, 3.0), view, up, SIZE, PERSPECTIVE)
}

/// Checks everything that a frame promises, within `tolerance` for rounding.
#[track_caller]
fn is_a_right_handed_frame(camera: &Camera, tolerance: f64) {
    let Camera { u, v, w, .. } = *camera;
    for axis in [u, v, w] {
        assert!((axis.length() - 1.0).abs() < tolerance, "{camera:?}");
    }
    for (a, b) in [(u, v), (v, w), (w, u)] {
        assert!(a.dot(b).abs() < tolerance, "{camera:?}");
    }
    assert!(u.cross(v).distance(w) < tolerance, "{camera:?}");
}

#[test]
fn any_view_and_up_make_a_right_handed_frame() {
    let mut random = Random::new(1);
    for _ in 0..2000 {
        let (view, up) = (random.vector(), random.vector());
        let sine = view.normalize().cross(up.normalize()).length();
        let camera = camera(view, up).unwrap();
        is_a_right_handed_frame(&camera, 1e-14 / sine);
    }
}

#[test]
fn a_camera_looks_along_view_with_up_above_and_never_sideways() {
    let mut random = Random::new(2);
    for _ in 0..2000 {
        let (view, up) = (random.vector(), random.vector());
        let camera = camera(view, up).unwrap();
        assert!(camera.w.distance(-view.normalize()) < 1e-14);
        assert!(camera.v.dot(up) > 0.0);
        assert!(camera.u.dot(up).abs() < 1e-12 * up.length());
    }
}

#[test]
fn a_frame_does_not_depend_on_the_lengths_of_view_and_up() {
    let mut random = Random::new(3);
    for _ in 0..500 {
        let (view, up) = (random.vector(), random.vector());
        // Powers of two, so that scaling rounds nothing.
        assert_eq!(camera(view, up), camera(64.0 * view, up / 512.0));
    }
}

#[test]
fn seen_from_the_front_right_is_x_and_up_is_y() {
    let camera = camera(DVec3::NEG_Z, DVec3::Y).unwrap();
    assert_eq!(
        [camera.u, camera.v, camera.w],
        [DVec3::X, DVec3::Y, DVec3::Z]
    );
}

#[test]
fn parallel_directions_have_no_frame() {
    let mut random = Random::new(4);
    for _ in 0..500 {
        let view = random.vector();
        for along in [2.0, -3.0, 1e-3, -1e6] {
            assert_eq!(camera(view, along * view), None);
        }
    }
}

#[test]
fn nearly_parallel_directions_make_a_frame_or_none() {
    let mut random = Random::new(5);
    for _ in 0..2000 {
        let view = random.vector();
        let off = 10f64.powf(-8.5 + random.coordinate());
        let up = view + off * view.length() * random.vector().normalize();
        if let Some(camera) = camera(view, up) {
            is_a_right_handed_frame(&camera, 1e-6);
        }
    }
}

#[test]
fn direction_of_length_zero_has_no_frame() {
    for nothing in [DVec3::ZERO, DVec3::splat(f64::NAN), DVec3::splat(1e-320)] {
        assert_eq!(camera(nothing, DVec3::Y), None);
        assert_eq!(camera(DVec3::NEG_Z, nothing), None);
    }
}

#[test]
fn depth_grows_along_the_view_and_nowhere_else() {
    let mut random = Random::new(6);
    for _ in 0..500 {
        let camera = camera(random.vector(), random.vector()).unwrap();
        let (right, up, ahead) = (
            random.coordinate(),
            random.coordinate(),
            random.coordinate(),
        );
        let point = camera.eye + right * camera.u + up * camera.v - ahead * camera.w;
        assert!((camera.depth(point) - ahead).abs() < 1e-9);
    }
}

#[test]
fn t_of_1_is_as_deep_as_the_image_plane_of_a_perspective_camera() {
    let camera = camera(DVec3::NEG_Z, DVec3::Y).unwrap();
    assert_eq!(camera.depth_per_t(), 1.5);
}

#[test]
fn t_is_depth_for_an_orthographic_camera() {
    let projection = Projection::Orthographic;
    let camera = Camera::new(DVec3::ZERO, DVec3::X, DVec3::Y, SIZE, projection).unwrap();
    assert_eq!(camera.depth_per_t(), 1.0);
}

#[test]
fn every_pixel_has_one_index_and_every_index_one_pixel() {
    for (n_x, n_y) in [(1, 1), (1, 7), (7, 1), (5, 3), (16, 9)] {
        let resolution = Resolution { n_x, n_y };
        for index in 0..resolution.pixels() {
            let pixel = resolution.pixel(index);
            assert!(pixel.i < n_x && pixel.j < n_y);
            assert_eq!(resolution.index(pixel), index);
        }
    }
}

#[test]
fn films_begin_at_the_top_left_and_end_at_the_bottom_right() {
    let resolution = Resolution { n_x: 4, n_y: 3 };
    assert_eq!(resolution.pixel(0), Pixel { i: 0, j: 2 });
    assert_eq!(resolution.pixel(11), Pixel { i: 3, j: 0 });
}
