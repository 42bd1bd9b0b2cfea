//! Pictures: films in the harness's false colours.

use glam::{DVec3, dvec3};
use image::{Rgb, Rgba, RgbaImage};
use pinhole::{Camera, Film, Plane, Projection, Resolution, Scene, Shape, Sphere, false_colour};
use pinhole_course::checkout::Checkout;

use super::FigureFile;
use super::drawing::{Drawing, Side, ink, stroke};
use crate::course::{assignment, golden};
use crate::error::{Error, Result};
use crate::png::{beside, enlarged, opaque, png};
use crate::reference::Reference;

/// Pixels between two pictures.
pub const GAP: u32 = 8;

/// The figure of a picture.
pub fn made(picture: &RgbaImage) -> Result<FigureFile> {
    Ok(FigureFile {
        extension: "png",
        content: png(picture)?,
    })
}

/// A golden film in its three false colours.
fn three(name: &str, checkout: &Checkout) -> Result<FigureFile> {
    let film = Film::read(&golden(checkout).join(format!("{name}.exr")))?;
    let scene = scene(name, checkout)?;
    let per_t = scene.camera.depth_per_t();
    let range = false_colour::depth_range(&film, per_t);
    let pictures = [
        false_colour::id(&film),
        false_colour::depth(&film, per_t, range),
        false_colour::normal(&film),
    ];
    let large = pictures.map(|picture| enlarged(&picture, 2));
    made(&beside(&large, GAP))
}

fn scene(name: &str, checkout: &Checkout) -> Result<Scene> {
    Ok(Scene::read(&assignment(checkout)?.scene(name))?)
}

/// The rabbit.
pub fn three_outputs_bunny(checkout: &Checkout) -> Result<FigureFile> {
    three("bunny", checkout)
}

/// The inside of a box.
pub fn three_outputs_boxes(checkout: &Checkout) -> Result<FigureFile> {
    three("inside_a_box", checkout)
}

/// One function, sampled twice.
pub fn image_function(checkout: &Checkout) -> Result<FigureFile> {
    let mut scene = scene("sphere_and_plane", checkout)?;
    let reference = Reference::build(checkout)?;
    let fine = false_colour::id(&reference.film(&scene)?);
    scene.resolution = Resolution { n_x: 16, n_y: 9 };
    let mut coarse = enlarged(&false_colour::id(&reference.film(&scene)?), 20);
    for (x, y, pixel) in coarse.enumerate_pixels_mut() {
        // Make the lines two pixels wide, because a phone shows about every second pixel.
        if x % 20 < 2 || y % 20 < 2 {
            let [r, g, b, _] = pixel.0.map(|value| value / 2);
            *pixel = Rgba([r, g, b, 255]);
        }
    }
    made(&beside(&[coarse, enlarged(&fine, 2)], GAP))
}

/// Balls in two rows, in perspective and orthographic.
pub fn projections_side_by_side(checkout: &Checkout) -> Result<FigureFile> {
    let reference = Reference::build(checkout)?;
    let mut objects = vec![Shape::Plane(Plane {
        point: DVec3::ZERO,
        normal: DVec3::Y,
    })];
    for k in 0..5 {
        for x in [-1.25, 1.25] {
            objects.push(Shape::Sphere(Sphere {
                center: dvec3(x, 0.6, -2.2 * f64::from(k)),
                radius: 0.6,
            }));
        }
    }
    let perspective = Projection::Perspective { focal_length: 4.0 };
    let cameras = [
        (dvec3(0.0, 3.6, 5.0), (4.8, 3.0), perspective),
        (dvec3(0.0, 4.4, 5.0), (11.2, 7.0), Projection::Orthographic),
    ];
    let mut pictures = Vec::new();
    for (eye, size, projection) in cameras {
        let scene = Scene {
            camera: camera(eye, dvec3(0.0, -0.42, -1.0), size, projection)?,
            resolution: Resolution { n_x: 320, n_y: 200 },
            min_t: 0.0,
            objects: objects.clone(),
        };
        pictures.push(opaque(&false_colour::id(&reference.film(&scene)?)));
    }
    made(&beside(&pictures, GAP))
}

fn camera(eye: DVec3, view: DVec3, size: (f64, f64), projection: Projection) -> Result<Camera> {
    Camera::new(eye, view, DVec3::Y, size, projection)
        .ok_or_else(|| Error::environment("a figure's camera has no frame", "report this"))
}

/// A sphere in the colours of its normals, as discs of one colour each, with the axes.
pub fn normal_colours(checkout: &Checkout) -> Result<FigureFile> {
    let reference = Reference::build(checkout)?;
    let n = 24;
    let scene = Scene {
        camera: camera(
            dvec3(0.0, 0.0, 3.0),
            -DVec3::Z,
            (2.0, 2.0),
            Projection::Orthographic,
        )?,
        resolution: Resolution { n_x: n, n_y: n },
        min_t: 0.0,
        objects: vec![Shape::Sphere(Sphere {
            center: DVec3::ZERO,
            radius: 1.0,
        })],
    };
    let film = reference.film(&scene)?;
    let picture = false_colour::normal(&film);
    let ids = film.channel("id").unwrap_or_default();
    let at = glam::dvec2;
    let mut drawing = Drawing::new(at(-1.8, -1.35), at(1.8, 1.65));
    let pixel = 2.0 / n as f64;
    for (x, y, Rgb([r, g, b])) in picture.enumerate_pixels() {
        if ids[y as usize * n + x as usize] >= 0.0 {
            let (x, y) = (-1.0 + f64::from(x) * pixel, 1.0 - f64::from(y) * pixel);
            // Draw it a little too wide, so that the page doesn't show through.
            let (right, below) = (x + 1.04 * pixel, y - 1.04 * pixel);
            let corners = [at(x, y), at(right, y), at(right, below), at(x, below)];
            drawing.area(&corners, &format!("#{r:02x}{g:02x}{b:02x}"), 1.0);
        }
    }
    drawing.arrow(at(1.0, 0.0), at(1.5, 0.0), &stroke("#d33").thick());
    drawing.text(at(1.5, 0.0), Side::Right, "x");
    drawing.arrow(at(0.0, 1.0), at(0.0, 1.4), &stroke("#2a2").thick());
    drawing.text(at(0.0, 1.4), Side::Right, "y");
    drawing.circle(at(0.0, 0.0), 0.09, "none", 1.0, &stroke("#000").thick());
    drawing.circle(at(0.0, 0.0), 0.025, "#000", 1.0, &stroke("#000"));
    drawing.line(at(0.1, -0.1), at(1.0, -1.0), &ink().thin());
    drawing.small(at(1.0, -1.0), Side::Below, "z, towards you");
    Ok(drawing.made())
}
