use glam::dvec3;
use pinhole::{Pixel, Resolution, Shape};

use super::camera::{on_plane, slide};
use super::shapes::{Quadratic, RAY, SPHERE, TRIANGLE, weights};
use super::*;

fn checkout() -> Checkout {
    Checkout::find().expect("tests run in a checkout")
}

#[test]
fn every_number_is_what_the_writer_expects() {
    let checkout = checkout();
    let values = values(&checkout).expect("the reference answers");
    let list = checkout.read("book/values.md").expect("the list is there");
    let mut compared = 0;
    for line in list.lines().filter_map(|line| line.strip_prefix("- `")) {
        let parts: Vec<&str> = line.split(" — ").collect();
        let (names, expected) = (parts[0], parts[parts.len() - 1]);
        let names: Vec<&str> = names
            .split('`')
            .step_by(2)
            .filter(|name| !name.is_empty())
            .collect();
        if names[0].starts_with("study_") {
            continue;
        }
        let shown: Vec<&str> = names.iter().map(|name| values[*name].as_str()).collect();
        assert_eq!(shown.join(", "), expected, "{names:?}");
        compared += 1;
    }
    assert!(
        compared > 30,
        "only {compared} numbers were found in the list"
    );
}

#[test]
fn the_chapters_formulas_agree_with_the_reference() {
    let reference = Reference::build(&checkout()).expect("it builds");
    let [t0, t1] = Quadratic::new(&RAY, &SPHERE).roots();
    let sphere = Shape::Sphere(SPHERE);
    for (min_t, t) in [(1.0, t0), (1.6, t1)] {
        let met = reference
            .intersect(&sphere, RAY, min_t)
            .unwrap()
            .expect("it is met");
        assert!((met.t - t).abs() < 1e-15, "{t} is {}", met.t);
    }
    let met = reference
        .intersect(&Shape::Triangle(TRIANGLE), RAY, 1.0)
        .unwrap();
    let [_, alpha, beta] = weights(&RAY, &TRIANGLE);
    let [a, b, c] = TRIANGLE.corners;
    let point = a + alpha * (b - a) + beta * (c - a);
    assert!(point.distance(RAY.at(met.expect("it is met").t)) < 1e-14);
}

#[test]
fn the_four_corners_of_pixel_space_are_the_corners_of_the_image_plane() {
    let scene = slide(&checkout()).expect("the scene is there");
    let Resolution { n_x, n_y } = scene.resolution;
    let (width, height) = (scene.camera.width, scene.camera.height);
    assert_eq!(on_plane(0.0, width, n_x), -width / 2.0);
    assert_eq!(on_plane(n_x as f64, width, n_x), width / 2.0);
    assert_eq!(on_plane(0.0, height, n_y), -height / 2.0);
    assert_eq!(on_plane(n_y as f64, height, n_y), height / 2.0);
}

#[test]
fn the_middle_of_nine_pixels_looks_along_the_worked_ray() {
    let camera = nine_pixels::camera().expect("it is a camera");
    let reference = Reference::build(&checkout()).expect("it builds");
    let middle = Pixel { i: 1, j: 1 };
    let ray = reference.viewing_ray(camera, middle, nine_pixels::RESOLUTION);
    assert!(ray.unwrap().direction.distance(RAY.direction) < 1e-14);
    for (axis, thirds) in [
        (camera.u, dvec3(2.0, -2.0, -1.0)),
        (camera.v, dvec3(2.0, 1.0, 2.0)),
        (camera.w, dvec3(-1.0, -2.0, 2.0)),
    ] {
        assert!(axis.distance(thirds / 3.0) < 1e-15, "{axis}");
    }
}
