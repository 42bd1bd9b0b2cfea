//! Drawings of cameras, pixels and rays.

use glam::{DVec2, DVec3, dvec2, dvec3};
use pinhole::Resolution;
use pinhole_course::checkout::Checkout;

use super::FigureFile;
use super::drawing::{Drawing, INK, Side, Space, colour, ink, stroke};
use crate::error::Result;
use crate::worked::{PIXEL, on_plane, slide};

/// A tree in silhouette, its foot at `foot`; upside down if `size.y` is negative.
fn tree(drawing: &mut Drawing, foot: DVec2, size: DVec2) {
    let at = |x: f64, y: f64| foot + size * dvec2(x, y);
    drawing.line(foot, at(0.0, 0.4), &ink().thick());
    let crown = [at(-0.5, 0.3), at(0.5, 0.3), at(0.0, 1.0)];
    drawing.area(&crown, &colour(2), 1.0);
}

/// A dark box with a hole.
pub fn camera_obscura(_: &Checkout) -> Result<FigureFile> {
    let mut drawing = Drawing::new(dvec2(-5.2, -2.2), dvec2(4.0, 2.2));
    let (hole, wall) = (DVec2::ZERO, 3.2);
    let (foot, top) = (dvec2(-4.2, -1.5), dvec2(-4.2, 1.5));
    let room = [
        dvec2(0.0, -2.0),
        dvec2(wall, -2.0),
        dvec2(wall, 2.0),
        dvec2(0.0, 2.0),
    ];
    drawing.area(&room, INK, 0.12);
    for side in [-1.0, 1.0] {
        let border = [
            dvec2(0.0, 0.07 * side),
            dvec2(0.0, 2.0 * side),
            dvec2(wall, 2.0 * side),
        ];
        drawing.path(&border, false, "none", &ink().thick());
    }
    drawing.line(room[1], room[2], &ink().thick());
    tree(&mut drawing, foot, dvec2(1.4, top.y - foot.y));
    // Through the hole by similar triangles.
    let through = |p: DVec2| hole + (hole - p) * wall / -p.x;
    for end in [foot, top] {
        drawing.line(end, through(end), &stroke(colour(0)));
    }
    // On the wall the picture is seen from its side, so it is drawn narrow.
    let (image_foot, image_top) = (through(foot), through(top));
    let aside = dvec2(-0.17, 0.0);
    tree(
        &mut drawing,
        image_foot + aside,
        dvec2(0.35, image_top.y - image_foot.y),
    );
    drawing.text(dvec2(-0.5, -0.75), Side::On, "hole");
    drawing.text(dvec2(1.4, 1.55), Side::On, "dark box");
    Ok(drawing.made())
}

/// A line with t = −1, 0, 1, 2.
pub fn ray_parameter(_: &Checkout) -> Result<FigureFile> {
    let mut drawing = Drawing::new(dvec2(-1.7, -0.5), dvec2(2.7, 1.05));
    let (e, d) = (dvec2(0.0, 0.16), dvec2(1.0, 0.22));
    let at = |t: f64| e + t * d;
    drawing.line(at(-1.5), at(2.5), &ink().dashed());
    drawing.line(at(0.0), at(2.5), &ink());
    drawing.arrow(at(0.0), at(1.0), &stroke(colour(4)).thick());
    for (t, label) in [
        (-1.0, "t = −1"),
        (0.0, "t = 0"),
        (1.0, "t = 1"),
        (2.0, "t = 2"),
    ] {
        drawing.dot(at(t), if t == 0.0 || t == 1.0 { INK } else { "none" });
        drawing.text(at(t), Side::Below, label);
    }
    drawing.text(at(0.0), Side::Above, "*e*");
    drawing.text(at(1.0), Side::Above, "*s*");
    drawing.text(at(0.5), Side::Above, "*d* = *s* − *e*");
    Ok(drawing.made())
}

/// An upright arrow, the image plane in front of the eye, the film behind.
pub fn pinhole_and_image_plane(_: &Checkout) -> Result<FigureFile> {
    let mut drawing = Drawing::new(dvec2(-3.2, -1.9), dvec2(6.6, 2.1));
    let (f, eye) = (2.0, DVec2::ZERO);
    let (foot, top) = (dvec2(5.6, -0.9), dvec2(5.6, 1.5));
    let image = |p: DVec2, x: f64| p * x / p.x;
    for end in [foot, top] {
        drawing.line(end, image(end, -f), &stroke(colour(0)));
    }
    for (x, name) in [(f, "image plane"), (-f, "film")] {
        drawing.line(dvec2(x, -1.3), dvec2(x, 1.3), &ink().thin());
        drawing.arrow(image(foot, x), image(top, x), &stroke(colour(2)).thick());
        drawing.text(dvec2(x, 1.35), Side::Above, name);
    }
    drawing.arrow(foot, top, &stroke(colour(2)).thick());
    drawing.dot(eye, INK);
    drawing.text(eye + dvec2(0.0, 0.1), Side::Above, "*e*");
    for x in [f, -f] {
        drawing.line(dvec2(0.0, -1.55), dvec2(x, -1.55), &ink().thin());
        drawing.line(dvec2(x, -1.65), dvec2(x, -1.45), &ink().thin());
        drawing.text(dvec2(x / 2.0, -1.55), Side::Above, "f");
    }
    drawing.line(dvec2(0.0, -1.65), dvec2(0.0, -1.45), &ink().thin());
    Ok(drawing.made())
}

/// u, v, w, and an up vector that leans.
pub fn camera_frame(_: &Checkout) -> Result<FigureFile> {
    let mut drawing = Drawing::new(dvec2(-1.9, -1.1), dvec2(2.2, 1.6));
    let space = Space::slanted();
    let point = |x, y, z| space.at(dvec3(x, y, z));
    let eye = point(0.0, 0.0, 0.0);
    let up = point(0.0, 1.1, -0.75);
    drawing.arrow(eye, point(0.0, 0.0, -2.2), &ink().dashed());
    drawing.small(point(0.0, 0.0, -2.2), Side::Right, "view, −*w*");
    drawing.arrow(eye, up, &stroke(colour(6)));
    drawing.text(up, Side::Right, "up");
    drawing.line(up, point(0.0, 1.1, 0.0), &ink().dashed());
    let axes = [
        (point(1.3, 0.0, 0.0), "*u*, right", 5, Side::Right),
        (point(0.0, 1.3, 0.0), "*v*, top", 2, Side::Above),
        (point(0.0, 0.0, 1.9), "*w*, backwards", 4, Side::Below),
    ];
    for (end, name, object, side) in axes {
        drawing.arrow(eye, end, &stroke(colour(object)).thick());
        drawing.text(end, side, name);
    }
    drawing.dot(eye, INK);
    drawing.text(eye, Side::Left, "*e*");
    Ok(drawing.made())
}

/// Five rays of an image plane, in three projections.
pub fn projection_rays(_: &Checkout) -> Result<FigureFile> {
    let mut drawing = Drawing::new(dvec2(-2.3, -2.7), dvec2(13.2, 2.9));
    let slant = 30.0_f64.to_radians().tan();
    let panels = [
        (0.0, "perspective"),
        (5.0, "orthographic"),
        (10.0, "oblique"),
    ];
    for (left, name) in panels {
        let plane = dvec2(left, 0.0);
        drawing.line(
            plane - dvec2(0.0, 1.35),
            plane + dvec2(0.0, 1.35),
            &ink().thick(),
        );
        for step in -2..=2 {
            let s = plane + dvec2(0.0, 0.5 * f64::from(step));
            let eye = plane - dvec2(1.8, 0.0);
            let (from, to) = match name {
                "perspective" => (eye, s + 1.4 * (s - eye) / 1.8),
                "orthographic" => (s, s + dvec2(2.4, 0.0)),
                _ => (s, s + 2.4 * dvec2(1.0, slant)),
            };
            drawing.arrow(from, to, &stroke(colour(0)));
            drawing.dot(from, INK);
        }
        drawing.text(plane + dvec2(0.4, -2.3), Side::On, name);
    }
    drawing.text(dvec2(-1.8, 0.0), Side::Above, "*e*");
    drawing.line(dvec2(-1.8, -1.2), dvec2(0.0, -1.2), &ink().thin());
    drawing.small(dvec2(-0.9, -1.2), Side::Below, "f");
    Ok(drawing.made())
}

/// Pixel (2, 3) of the lecture's picture, in three spaces.
pub fn three_spaces(checkout: &Checkout) -> Result<FigureFile> {
    let scene = slide(checkout)?;
    let Resolution { n_x, n_y } = scene.resolution;
    let camera = scene.camera;
    let mut drawing = Drawing::new(dvec2(-0.9, -7.6), dvec2(15.1, 6.9));
    let (i, j) = (PIXEL.i as f64, PIXEL.j as f64);
    // Pixel space: the lower left corner of the picture, a unit for each pixel.
    let (columns, rows) = (6_u8, 5_u8);
    let (right, top) = (f64::from(columns), f64::from(rows));
    let corners = [
        dvec2(i, j),
        dvec2(i + 1.0, j),
        dvec2(i + 1.0, j + 1.0),
        dvec2(i, j + 1.0),
    ];
    drawing.area(&corners, &colour(5), 0.5);
    for column in (0..=columns).map(f64::from) {
        drawing.line(dvec2(column, 0.0), dvec2(column, top + 0.3), &ink().thin());
        drawing.small(dvec2(column, 0.0), Side::Below, &column.to_string());
    }
    for row in (0..=rows).map(f64::from) {
        drawing.line(dvec2(0.0, row), dvec2(right + 0.3, row), &ink().thin());
        drawing.small(dvec2(0.1, row), Side::Left, &row.to_string());
    }
    drawing.dot(dvec2(i + 0.5, j + 0.5), INK);
    drawing.small(dvec2(i + 0.9, j + 0.5), Side::Right, "(2.5, 3.5)");
    drawing.text(dvec2(3.0, 6.2), Side::On, "pixel space");
    // The image plane, two by one scene units.
    let middle = dvec2(11.2, 2.5);
    let on = |u: f64, v: f64| middle + 3.4 * dvec2(u, v);
    let (w, h) = (camera.width / 2.0, camera.height / 2.0);
    let border = [on(-w, -h), on(w, -h), on(w, h), on(-w, h)];
    drawing.path(&border, true, "none", &ink());
    drawing.arrow(on(0.0, 0.0), on(0.6, 0.0), &stroke(colour(5)).thick());
    drawing.arrow(on(0.0, 0.0), on(0.0, 0.4), &stroke(colour(2)).thick());
    drawing.text(on(0.6, 0.0), Side::Right, "*u*");
    drawing.text(on(0.0, 0.33), Side::Right, "*v*");
    let u = on_plane(i + 0.5, camera.width, n_x);
    let v = on_plane(j + 0.5, camera.height, n_y);
    drawing.dot(on(u, v), INK);
    drawing.small(on(u + 0.42, -h), Side::Below, "(−0.9, −0.36, −10)");
    drawing.text(dvec2(11.2, 6.2), Side::On, "camera space");
    // The world from the side of positive x: z to the left, y up.
    let side = |p: DVec3| dvec2(1.4, -6.3) + 0.4 * dvec2(-p.z, p.y);
    let eye = camera.eye;
    let plane = eye - 10.0 * camera.w;
    let s = plane + u * camera.u + v * camera.v;
    let ends = [plane - 1.6 * camera.v, plane + 1.6 * camera.v];
    drawing.line(side(ends[0]), side(ends[1]), &ink().thick());
    drawing.arrow(
        side(eye),
        side(eye + 1.6 * (s - eye)),
        &stroke(colour(5)).thick(),
    );
    drawing.arrow(
        side(eye),
        side(eye + 3.2 * camera.v),
        &stroke(colour(2)).thick(),
    );
    drawing.arrow(
        side(eye),
        side(eye + 2.6 * camera.w),
        &stroke(colour(4)).thick(),
    );
    drawing.dot(side(s), INK);
    drawing.dot(side(eye), INK);
    drawing.text(side(eye), Side::Right, "*e*, t = 0");
    drawing.text(side(eye + 3.2 * camera.v), Side::Above, "*v*");
    drawing.text(
        side(eye + 2.6 * camera.w) + dvec2(0.1, 0.0),
        Side::Below,
        "*w*",
    );
    drawing.text(side(s) + dvec2(0.3, 0.0), Side::Right, "*s*, t = 1");
    drawing.text(dvec2(11.2, -3.6), Side::On, "world space,");
    drawing.text(dvec2(11.2, -4.5), Side::On, "from the side");
    Ok(drawing.made())
}

/// Borders at whole numbers, centres between them.
pub fn pixel_space(_: &Checkout) -> Result<FigureFile> {
    let (n, width) = (4_usize, 2.0);
    let mut drawing = Drawing::new(dvec2(-0.7, -0.75), dvec2(4.7, 1.55));
    for (i, object) in [1, 0, 1, 0].iter().enumerate() {
        let x = i as f64;
        let cell = [
            dvec2(x, 0.0),
            dvec2(x + 1.0, 0.0),
            dvec2(x + 1.0, 0.35),
            dvec2(x, 0.35),
        ];
        drawing.area(&cell, &colour(*object), 0.35);
        drawing.text(dvec2(x + 0.5, 0.17), Side::On, &format!("i = {i}"));
        drawing.line(dvec2(x + 0.5, 0.0), dvec2(x + 0.5, -0.1), &ink());
        let centre = if i == 0 {
            "½".into()
        } else {
            format!("{i}½")
        };
        drawing.small(dvec2(x + 0.5, -0.1), Side::Below, &centre);
        let u = on_plane(x + 0.5, width, n);
        drawing.dot(dvec2(x + 0.5, 0.95), &colour(*object));
        let u = u.to_string().replace('-', "−");
        drawing.small(dvec2(x + 0.5, 0.95), Side::Above, &format!("u = {u}"));
    }
    drawing.line(dvec2(0.0, 0.0), dvec2(n as f64, 0.0), &ink());
    drawing.line(dvec2(0.0, 0.95), dvec2(n as f64, 0.95), &ink().thick());
    for border in 0..=n {
        let x = border as f64;
        drawing.line(dvec2(x, 0.35), dvec2(x, -0.16), &ink());
        drawing.text(dvec2(x, -0.22), Side::Below, &border.to_string());
    }
    drawing.small(dvec2(0.0, 0.95), Side::Below, "−width/2");
    drawing.small(dvec2(n as f64, 0.95), Side::Below, "width/2");
    Ok(drawing.made())
}

/// The eye, the image plane with a coarse grid, and the ray of pixel (2, 3).
pub fn viewing_ray(_: &Checkout) -> Result<FigureFile> {
    let mut drawing = Drawing::new(dvec2(-5.2, -2.3), dvec2(5.2, 3.0));
    // To the right of the picture is towards the reader, forward is to the right.
    let space = Space {
        axes: [dvec2(0.66, -0.36), dvec2(0.0, 1.0), dvec2(-1.0, 0.0)],
    };
    let Resolution { n_x, n_y } = Resolution { n_x: 10, n_y: 5 };
    let (width, height, f) = (4.0, 2.0, 3.6);
    let eye = dvec3(0.0, 0.0, 4.2);
    let on = |i: f64, j: f64| {
        let (u, v) = (on_plane(i, width, n_x), on_plane(j, height, n_y));
        space.at(eye + dvec3(u, v, -f))
    };
    let (i, j) = (PIXEL.i as f64, PIXEL.j as f64);
    let (e, s) = (space.at(eye), on(i + 0.5, j + 0.5));
    // In the drawing too, t = 1 is at the plane.
    let (p, radius) = (e + 2.0 * (s - e), 0.75);
    let center = p + radius * (s - e).normalize();
    drawing.circle(center, radius, &colour(0), 0.6, &ink());
    let corners = [on(0.0, 0.0), on(10.0, 0.0), on(10.0, 5.0), on(0.0, 5.0)];
    drawing.area(&corners, &colour(1), 0.25);
    for column in 0..=n_x {
        let x = column as f64;
        drawing.line(on(x, 0.0), on(x, n_y as f64), &ink().thin());
    }
    for row in 0..=n_y {
        let y = row as f64;
        drawing.line(on(0.0, y), on(n_x as f64, y), &ink().thin());
    }
    let cell = [
        on(i, j),
        on(i + 1.0, j),
        on(i + 1.0, j + 1.0),
        on(i, j + 1.0),
    ];
    drawing.area(&cell, &colour(5), 0.8);
    drawing.line(e, s, &stroke(colour(5)).thick());
    drawing.arrow(s, p, &stroke(colour(5)).thick());
    drawing.dot(s, INK);
    drawing.dot(e, INK);
    drawing.text(e, Side::Below, "*e*, t = 0");
    drawing.text(on(0.0, 5.0) + dvec2(-0.3, 0.25), Side::Above, "*s*, t = 1");
    drawing.line(on(0.0, 5.0) + dvec2(-0.3, 0.25), s, &ink().dashed());
    drawing.text(on(10.0, 0.0), Side::Right, "image plane");
    Ok(drawing.made())
}
