//! Drawings of what rays meet.

use std::f64::consts::TAU;

use glam::{DVec2, dvec2, dvec3};
use pinhole::{Pixel, Scene, Shape};
use pinhole_course::checkout::Checkout;

use super::FigureFile;
use super::drawing::{Drawing, INK, Side, colour, ink, stroke};
use crate::course::assignment;
use crate::error::Result;
use crate::reference::Reference;
use crate::worked::{PLANE, Quadratic, RAY, SPHERE, TRIANGLE, on_plane, weights};

/// One object asks for its pixels; one pixel asks for its object.
pub fn two_loops(_: &Checkout) -> Result<FigureFile> {
    let mut drawing = Drawing::new(dvec2(-0.6, -1.5), dvec2(22.6, 9.2));
    let corners = [dvec2(1.3, 0.8), dvec2(8.6, 3.1), dvec2(3.2, 7.4)];
    let inside = |p: DVec2| {
        let edge = |k: usize| (corners[(k + 1) % 3] - corners[k]).perp_dot(p - corners[k]);
        edge(0) >= 0.0 && edge(1) >= 0.0 && edge(2) >= 0.0
    };
    let cell = |i: f64, j: f64, left: f64| {
        [
            dvec2(i, j),
            dvec2(i + 1.0, j),
            dvec2(i + 1.0, j + 1.0),
            dvec2(i, j + 1.0),
        ]
        .map(|p| p + dvec2(left, 0.0))
    };
    for i in 0..10 {
        for j in 0..8 {
            let (x, y) = (f64::from(i), f64::from(j));
            if inside(dvec2(x + 0.5, y + 0.5)) {
                drawing.area(&cell(x, y, 0.0), &colour(1), 0.8);
            }
            drawing.path(&cell(x, y, 0.0), true, "none", &ink().thin());
        }
    }
    drawing.path(&corners, true, "none", &stroke(colour(5)).thick());
    drawing.text(dvec2(5.0, -1.0), Side::On, "for each object: its pixels");
    // The same grid seen from the side: eye, plane, one pixel.
    let (eye, plane) = (dvec2(12.0, 4.0), 14.5);
    let s = dvec2(plane, 4.55);
    let along = s - eye;
    for j in 0..8 {
        let y = f64::from(j) * 0.5 + 2.05;
        let pixel = [
            dvec2(plane - 0.12, y),
            dvec2(plane + 0.12, y),
            dvec2(plane + 0.12, y + 0.5),
            dvec2(plane - 0.12, y + 0.5),
        ];
        let fill = if (y..y + 0.5).contains(&s.y) {
            colour(5)
        } else {
            "none".into()
        };
        drawing.path(&pixel, true, &fill, &ink().thin());
    }
    let balls = [(dvec2(18.2, 5.7), 1.1, 1), (dvec2(21.0, 5.4), 1.3, 2)];
    for (center, radius, object) in balls {
        drawing.circle(center, radius, &colour(object), 0.5, &ink());
    }
    drawing.arrow(eye, eye + 3.95 * along, &stroke(colour(5)));
    for (number, (center, radius, _)) in balls.iter().enumerate() {
        let t = entry(eye, along, *center, *radius);
        match number {
            0 => drawing.dot(eye + t * along, &colour(5)),
            _ => drawing.ring(eye + t * along),
        }
    }
    drawing.dot(eye, INK);
    drawing.text(eye, Side::Above, "*e*");
    drawing.text(dvec2(17.0, -1.0), Side::On, "for each pixel: its object");
    Ok(drawing.made())
}

/// Where a line of the plane first meets a circle: the chapter's formula.
fn entry(e: DVec2, d: DVec2, center: DVec2, radius: f64) -> f64 {
    let ray = pinhole::Ray {
        origin: e.extend(0.0),
        direction: d.extend(0.0),
    };
    let sphere = pinhole::Sphere {
        center: center.extend(0.0),
        radius,
    };
    Quadratic::new(&ray, &sphere).roots()[0]
}

/// A circle as an equation and as a path.
pub fn implicit_and_parametric(_: &Checkout) -> Result<FigureFile> {
    let mut drawing = Drawing::new(dvec2(-1.9, -1.9), dvec2(5.9, 1.7));
    let at = |angle: f64| dvec2(angle.cos(), angle.sin());
    let (left, right) = (DVec2::ZERO, dvec2(4.0, 0.0));
    drawing.circle(left, 1.0, &colour(1), 0.3, &ink().thick());
    drawing.text(left, Side::On, "−");
    for place in [dvec2(-1.5, 0.9), dvec2(1.5, -0.8), dvec2(-1.4, -0.9)] {
        drawing.text(place, Side::On, "+");
    }
    for angle in [0.7, 2.1] {
        drawing.arrow(at(angle), 1.55 * at(angle), &stroke(colour(5)));
    }
    drawing.small(1.55 * at(0.7), Side::Above, "gradient");
    drawing.text(dvec2(0.0, -1.7), Side::On, "implicit: F(*p*) = 0");
    drawing.circle(right, 1.0, "none", 1.0, &ink().thin());
    for mark in 0..12 {
        drawing.dot(right + at(TAU * f64::from(mark) / 12.0), &colour(0));
    }
    let angle = TAU / 12.0;
    drawing.line(right, right + at(0.0), &ink().dashed());
    drawing.line(right, right + at(angle), &ink());
    let arc: Vec<DVec2> = (0..=8)
        .map(|k| right + 0.4 * at(angle * f64::from(k) / 8.0))
        .collect();
    drawing.path(&arc, false, "none", &ink());
    drawing.small(right + 0.55 * at(angle / 2.0), Side::On, "φ");
    drawing.text(right + dvec2(0.0, -1.7), Side::On, "parametric: *p*(φ)");
    Ok(drawing.made())
}

/// How far to the plane, how far one step goes.
pub fn plane_and_ray(_: &Checkout) -> Result<FigureFile> {
    let mut drawing = Drawing::new(dvec2(-3.7, -0.9), dvec2(6.2, 3.7));
    // The plane is the line y = 0; its normal points up.
    let (e, d, q) = (dvec2(-1.3, 3.0), dvec2(1.9, -1.2), dvec2(5.0, 0.0));
    let t = (q - e).y / d.y;
    let p = e + t * d;
    drawing.line(
        dvec2(-2.6, 0.0),
        dvec2(6.1, 0.0),
        &stroke(colour(1)).thick(),
    );
    drawing.arrow(q, q + dvec2(0.0, 1.3), &stroke(colour(2)).thick());
    drawing.text(q + dvec2(0.0, 1.3), Side::Right, "*n*");
    drawing.dot(q, INK);
    drawing.text(q, Side::Below, "*q*");
    drawing.line(e, p + 0.25 * d, &ink());
    drawing.arrow(e, e + d, &stroke(colour(5)).thick());
    drawing.text(e + 0.5 * d, Side::Above, "*d*");
    drawing.dot(p, &colour(5));
    drawing.text(
        p - dvec2(0.9, 0.0),
        Side::Below,
        &format!("*p*(t), t = {t}"),
    );
    drawing.dot(e, INK);
    drawing.text(e, Side::Above, "*e*");
    let bracket = |drawing: &mut Drawing, x: f64, from: f64, to: f64| {
        drawing.line(dvec2(x, from), dvec2(x, to), &ink());
        for y in [from, to] {
            drawing.line(dvec2(x - 0.08, y), dvec2(x + 0.08, y), &ink());
        }
    };
    bracket(&mut drawing, -1.9, e.y, 0.0);
    drawing.small(dvec2(-1.9, 0.6), Side::Left, "(*q*−*e*)·*n*");
    bracket(&mut drawing, -0.6, e.y, e.y + d.y);
    drawing.small(dvec2(-0.6, e.y + 0.8 * d.y), Side::Left, "*d*·*n*");
    drawing.line(e + d, dvec2(-0.6, e.y + d.y), &ink().dashed());
    drawing.line(e, dvec2(-1.9, e.y), &ink().dashed());
    Ok(drawing.made())
}

/// A secant, a tangent, a miss.
pub fn sphere_and_line(_: &Checkout) -> Result<FigureFile> {
    let mut drawing = Drawing::new(dvec2(-3.1, -1.5), dvec2(3.6, 2.0));
    let (center, e) = (DVec2::ZERO, dvec2(-2.6, -0.9));
    drawing.circle(center, 1.0, &colour(1), 0.3, &ink());
    let d = dvec2(1.0, 0.2);
    let ray = pinhole::Ray {
        origin: e.extend(0.0),
        direction: d.extend(0.0),
    };
    let sphere = pinhole::Sphere {
        center: dvec3(0.0, 0.0, 0.0),
        radius: 1.0,
    };
    let quadratic = Quadratic::new(&ray, &sphere);
    let [t0, t1] = quadratic.roots();
    let at = |t: f64| e + t * d;
    drawing.arrow(center, e, &stroke(colour(2)));
    drawing.small(0.62 * e, Side::Above, "*m*");
    drawing.line(e, at(5.4), &stroke(colour(5)));
    drawing.dot(at(t0), &colour(5));
    drawing.dot(at(t1), &colour(5));
    drawing.small(at(t0), Side::Below, "t₀");
    drawing.small(at(t1) + dvec2(0.06, -0.15), Side::Right, "t₁");
    let middle = at(-quadratic.h / quadratic.a);
    drawing.ring(middle);
    drawing.line(center, middle, &ink().dashed());
    drawing.small(middle, Side::Below, "−h/a");
    drawing.dot(center, INK);
    drawing.small(center, Side::Above, "*c*");
    drawing.dot(e, INK);
    drawing.text(e, Side::Below, "*e*");
    drawing.small(at(5.4), Side::Right, "Δ > 0");
    for (y, label) in [(1.0, "Δ = 0"), (1.5, "Δ < 0")] {
        drawing.line(dvec2(-2.6, y), dvec2(2.8, y), &stroke(colour(5)));
        drawing.small(dvec2(2.8, y), Side::Right, label);
    }
    drawing.dot(dvec2(0.0, 1.0), &colour(5));
    Ok(drawing.made())
}

/// The worked ray and its sphere in the plane of both, with the right triangle whose sides are
/// the radius, the distance of the centre from the ray, and half of the chord.
pub fn sphere_by_pythagoras(_: &Checkout) -> Result<FigureFile> {
    let stride = RAY.direction.length();
    let quadratic = Quadratic::new(&RAY, &SPHERE);
    let [t0, t1] = quadratic.roots();
    let at = |t: f64| dvec2(t * stride, 0.0);
    let middle = at(-quadratic.h / quadratic.a);
    let aside = (SPHERE.center - RAY.at(-quadratic.h / quadratic.a)).length();
    let center = middle + dvec2(0.0, aside);
    let mut drawing = Drawing::new(dvec2(2.0, -0.6), dvec2(8.0, 3.1));
    drawing.circle(center, SPHERE.radius, &colour(1), 0.3, &ink());
    drawing.line(at(0.75), at(2.6), &stroke(colour(5)));
    drawing.area(&[middle, at(t1), center], &colour(4), 0.5);
    drawing.path(&[middle, at(t1), center], true, "none", &ink());
    drawing.dot(at(t0), &colour(5));
    drawing.dot(at(t1), &colour(5));
    drawing.dot(center, INK);
    drawing.small(center, Side::Above, "*c*");
    drawing.small(0.5 * (center + middle), Side::Left, "‖*l*‖");
    drawing.small(0.5 * (center + at(t1)) + dvec2(0.05, 0.0), Side::Right, "r");
    drawing.small(at(t0), Side::Below, "t₀");
    drawing.small(at(t1) + dvec2(0.05, -0.2), Side::Right, "t₁");
    drawing.small(0.5 * (middle + at(t1)), Side::Below, "√(Δ/a)");
    Ok(drawing.made())
}

/// The worked triangle in its plane, with lines of equal α and β.
pub fn triangle_alpha_beta(_: &Checkout) -> Result<FigureFile> {
    // Along the first edge, and at right angles to it.
    let [a, b, c] = TRIANGLE.corners;
    let (first, second) = (b - a, c - a);
    let along = first.normalize();
    let across = first.cross(second).cross(first).normalize();
    let [t1, t2] = [first, second].map(|edge| dvec2(edge.dot(along), edge.dot(across)));
    let at = |alpha: f64, beta: f64| alpha * t1 + beta * t2;
    let (a, b, c) = (at(0.0, 0.0), at(1.0, 0.0), at(0.0, 1.0));
    let margin = dvec2(0.14, 0.1) * t1.x;
    let (from, to) = (a.min(c), b.max(c));
    let mut drawing = Drawing::new(from - margin, to + margin);
    drawing.area(&[a, b, c], &colour(1), 0.25);
    for quarter in 1..=3 {
        let w = f64::from(quarter) / 4.0;
        drawing.line(at(w, 0.0), at(w, 1.0 - w), &stroke(colour(5)).thin());
        drawing.line(at(0.0, w), at(1.0 - w, w), &stroke(colour(2)).thin());
        let name = ["¼", "½", "¾"][quarter as usize - 1];
        drawing.small(at(w, 0.0), Side::Below, &format!("α = {name}"));
        drawing.small(at(0.0, w), Side::Left, &format!("β = {name}"));
    }
    drawing.line(b, c, &ink());
    drawing.small(at(0.5, 0.5), Side::Right, "α + β = 1");
    drawing.arrow(a, b, &stroke(colour(5)).thick());
    drawing.arrow(a, c, &stroke(colour(2)).thick());
    drawing.text(b, Side::Right, "*b*");
    drawing.text(c, Side::Above, "*c*");
    drawing.text(a, Side::Left, "*a*");
    drawing.text(at(0.9, 0.0), Side::Below, "*t*₁");
    drawing.text(at(0.0, 0.9), Side::Left, "*t*₂");
    let [_, alpha, beta] = weights(&RAY, &TRIANGLE);
    drawing.dot(at(alpha, beta), INK);
    drawing.on_lines(at(alpha, beta), Side::Below, "α = ¼, β = ½");
    Ok(drawing.made())
}

/// A ray among the triangles of a teapot.
pub fn soup_of_triangles(checkout: &Checkout) -> Result<FigureFile> {
    let scene = Scene::read(&assignment(checkout)?.scene("teapot_orthographic"))?;
    let camera = scene.camera;
    let pixel = Pixel { i: 75, j: 45 };
    let reference = Reference::build(checkout)?;
    let ray = reference.viewing_ray(camera, pixel, scene.resolution)?;
    let soup = scene.objects.iter().find_map(|object| match object {
        Shape::Soup(soup) => Some(soup),
        _ => None,
    });
    let triangles = soup.map(|soup| soup.triangles.clone()).unwrap_or_default();
    let mut met: Vec<f64> = reference.each(&triangles, ray, scene.min_t)?;
    met.sort_by(f64::total_cmp);
    met.dedup_by(|one, other| (*one - *other).abs() < 1e-9);

    let mut drawing = Drawing::new(dvec2(-19.0, -14.5), dvec2(45.0, 13.5));
    let front = |p: glam::DVec3| {
        dvec2(
            (p - camera.eye).dot(camera.u),
            (p - camera.eye).dot(camera.v),
        )
    };
    // From the left of the picture: depth to the right.
    let depth = |p: glam::DVec3| dvec2(camera.depth(p) + 19.0, front(p).y);
    for view in [&front as &dyn Fn(glam::DVec3) -> DVec2, &depth] {
        let outlines: Vec<[DVec2; 3]> = triangles.iter().map(|one| one.corners.map(view)).collect();
        drawing.mesh(&outlines, &stroke(colour(1)).thin());
    }
    let place = dvec2(
        on_plane(pixel.i as f64 + 0.5, camera.width, scene.resolution.n_x),
        on_plane(pixel.j as f64 + 0.5, camera.height, scene.resolution.n_y),
    );
    drawing.dot(place, &colour(5));
    drawing.small(dvec2(0.0, -12.3), Side::On, "as the camera sees it");
    drawing.small(dvec2(29.0, -12.3), Side::On, "from the side");
    drawing.arrow(depth(ray.at(-1.0)), depth(ray.at(25.0)), &stroke(colour(5)));
    for (number, t) in met.iter().enumerate().rev() {
        let p = depth(ray.at(*t));
        match number {
            0 => drawing.dot(p, &colour(5)),
            _ => drawing.ring(p),
        }
    }
    Ok(drawing.made())
}

/// The worked ray as an axis of t.
pub fn first_hit_along_ray(checkout: &Checkout) -> Result<FigureFile> {
    let reference = Reference::build(checkout)?;
    let mut drawing = Drawing::new(dvec2(-0.5, -0.7), dvec2(6.7, 1.6));
    let at = |t: f64| dvec2(t, 0.0);
    drawing.arrow(at(0.0), at(6.4), &ink());
    drawing.small(at(6.3), Side::Below, "t");
    for t in 0..=6 {
        let t = f64::from(t);
        drawing.line(dvec2(t, -0.06), dvec2(t, 0.06), &ink());
        drawing.small(dvec2(t, -0.06), Side::Below, &t.to_string());
    }
    drawing.line(
        dvec2(1.0, -0.25),
        dvec2(1.0, 1.1),
        &stroke(colour(4)).thick(),
    );
    drawing.small(dvec2(1.0, 1.1), Side::Above, "min_t = 1");
    let list = [
        (Shape::Plane(PLANE), "plane", 1, 0.3),
        (Shape::Triangle(TRIANGLE), "triangle", 2, 0.75),
        (Shape::Sphere(SPHERE), "sphere", 0, 0.3),
    ];
    let shapes: Vec<Shape> = list.iter().map(|(shape, ..)| shape.clone()).collect();
    let first = reference.first_hit(&shapes, RAY, 1.0)?;
    let first = first.map_or(f64::NAN, |hit| hit.intersection.t);
    for (shape, name, object, height) in list {
        let mut from = 0.0;
        let mut named = false;
        while let Some(met) = reference.intersect(&shape, RAY, from)? {
            let fill = match met.t == first {
                true => colour(object),
                false => "none".into(),
            };
            let border = stroke(colour(object)).thick();
            drawing.circle(at(met.t), 0.09, &fill, 1.0, &border);
            if !named {
                drawing.line(dvec2(met.t, 0.1), dvec2(met.t, height), &ink().thin());
                drawing.small(dvec2(met.t, height - 0.05), Side::Above, name);
            }
            named = true;
            // The next one, just beyond.
            from = met.t + 1e-9;
        }
    }
    Ok(drawing.made())
}
