//! Drawings of boxes, and of a walk through their tree.

use glam::{DVec2, DVec3, dvec2};
use image::RgbImage;
use pinhole::{BoundingBox, Film, Kind, Node, Scene, Shape, false_colour};
use pinhole_course::checkout::Checkout;

use super::FigureFile;
use super::drawing::{Drawing, INK, Side, colour, ink, stroke};
use super::loops::{Lines, plot};
use super::pictures::{GAP, made};
use crate::boxes::{MeshTree, Search, Step, box_of, inside, meet, slab};
use crate::course::assignment_with;
use crate::error::{Error, Result};
use crate::png::{beside, enlarged};
use crate::rasterizer::camera;
use crate::reference::Reference;
use crate::worked::boxes::{LARGEST_LEAF, PLAN_RAY, plan, walls};
use crate::worked::savings::{SCATTERED_RESOLUTION, scattered};
use crate::worked::{RAY, TRIANGLE};

/// The corners of a box, seen along z.
fn outline(bounds: &BoundingBox) -> [DVec2; 4] {
    let (min, max) = (bounds.min, bounds.max);
    [
        dvec2(min.x, min.y),
        dvec2(max.x, min.y),
        dvec2(max.x, max.y),
        dvec2(min.x, max.y),
    ]
}

/// The worked ray and box seen along z with two slabs, and the intervals of t of all three.
pub fn slabs(_: &Checkout) -> Result<FigureFile> {
    let bounds = box_of(&[TRIANGLE]);
    let mut drawing = Drawing::new(dvec2(-1.2, -0.7), dvec2(18.4, 9.9));
    let (min, max) = (bounds.min, bounds.max);
    // The slab across x, then that across y, each from one border of the panel to the other.
    let (low, high) = (DVec2::ZERO, dvec2(7.8, 9.2));
    let across = [
        [
            dvec2(min.x, low.y),
            dvec2(max.x, low.y),
            dvec2(max.x, high.y),
            dvec2(min.x, high.y),
        ],
        [
            dvec2(low.x, min.y),
            dvec2(high.x, min.y),
            dvec2(high.x, max.y),
            dvec2(low.x, max.y),
        ],
    ];
    for (axis, area) in across.iter().enumerate() {
        drawing.area(area, &colour(axis + 1), 0.2);
    }
    drawing.path(&outline(&bounds), true, "none", &ink());
    drawing.small(dvec2(3.1, 0.35), Side::On, "slab across x");
    drawing.small(dvec2(4.95, 5.4), Side::Right, "slab");
    drawing.small(dvec2(4.95, 4.7), Side::Right, "across y");
    let seen = |p: DVec3| dvec2(p.x, p.y);
    let at = |t: f64| seen(RAY.at(t));
    drawing.arrow(at(0.0), at(4.0), &stroke(colour(5)));
    drawing.dot(at(0.0), INK);
    drawing.text(at(0.0), Side::Left, "*e*");
    for t in [1.0, 2.0, 3.0] {
        drawing.ring(at(t));
        drawing.on_lines(at(t) - dvec2(0.0, 0.4), Side::Right, &format!("t = {t}"));
    }
    // The intervals side by side, t upward as in the picture.
    let place = |column: f64, t: f64| dvec2(10.1 + 2.1 * column, 1.0 + 2.0 * t);
    let left = place(0.0, 0.0).x - 0.9;
    for t in 0..=4 {
        let t = f64::from(t);
        drawing.line(dvec2(left, place(0.0, t).y), place(3.6, t), &ink().thin());
        drawing.small(dvec2(left, place(0.0, t).y), Side::Left, &t.to_string());
    }
    let mut bar = |column: f64, [from, to]: [f64; 2], name: &str, fill: &str| {
        let [a, b] = [place(column, from), place(column, to)];
        let half = dvec2(0.45, 0.0);
        drawing.area(&[a - half, a + half, b + half, b - half], fill, 0.8);
        drawing.small(dvec2(a.x, 0.0), Side::On, name);
    };
    for (axis, name) in ["x", "y", "z"].into_iter().enumerate() {
        if let Some(times) = slab(&bounds, &RAY, axis) {
            bar(axis as f64, times, name, &colour(axis + 1));
        }
    }
    if let Some(times) = inside(&bounds, &RAY, 0.0, f64::INFINITY) {
        bar(3.0, times, "box", &colour(5));
    }
    drawing.small(dvec2(left, 9.45), Side::On, "t");
    Ok(drawing.made())
}

/// The boxes of a tree and their depths, the root's first.
fn by_depth(boxed: &MeshTree) -> Vec<(BoundingBox, usize, bool)> {
    let mut all = Vec::new();
    let mut waiting = vec![(0, 0)];
    while let Some((node, depth)) = waiting.pop() {
        let children = match boxed.tree().node(node) {
            Node::Branch(children) => children.to_vec(),
            Node::Leaf(_) => Vec::new(),
        };
        all.push((boxed.boxes()[node], depth, children.is_empty()));
        waiting.extend(children.into_iter().map(|child| (child, depth + 1)));
    }
    all
}

fn draw_walls(drawing: &mut Drawing, by: DVec2) {
    for (number, wall) in walls().iter().enumerate() {
        let [from, to, _] = wall.corners.map(|corner| dvec2(corner.x, corner.y) + by);
        drawing.line(from, to, &ink().thick());
        let beside = 0.5 * (from + to) + dvec2(0.4, -0.1);
        drawing.on_lines(beside, Side::Below, &number.to_string());
    }
}

/// Ten walls in one box, in two, in three.
pub fn boxes_by_depth(_: &Checkout) -> Result<FigureFile> {
    let boxed = plan();
    let mut drawing = Drawing::new(dvec2(-0.6, -2.0), dvec2(30.6, 15.6));
    let places = [dvec2(8.0, 9.0), dvec2(0.0, 0.0), dvec2(16.0, 0.0)];
    for (panel, by) in places.into_iter().enumerate() {
        for (bounds, depth, is_leaf) in by_depth(&boxed) {
            if depth == panel || (depth < panel && is_leaf) {
                let corners = outline(&bounds).map(|corner| corner + by);
                drawing.area(&corners, &colour(depth + 1), 0.25);
                drawing.path(&corners, true, "none", &stroke(colour(depth + 1)));
            }
        }
        draw_walls(&mut drawing, by);
        let words = format!("depth {panel}");
        drawing.small(by + dvec2(7.0, -0.9), Side::On, &words);
    }
    Ok(drawing.made())
}

/// A ray across the walls, and the boxes that it enters.
pub fn tree_walk(_: &Checkout) -> Result<FigureFile> {
    let boxed = plan();
    let mut drawing = Drawing::new(dvec2(-1.2, -0.2), dvec2(17.2, 8.0));
    let at = |t: f64| {
        let p = PLAN_RAY.at(t);
        dvec2(p.x, p.y)
    };
    let (nearest, _) = boxed.search(&PLAN_RAY, 0.0, Search::FULL);
    let nearest = nearest.map_or(f64::INFINITY, |(_, t)| t);
    for (bounds, depth, _) in by_depth(&boxed) {
        let entered = inside(&bounds, &PLAN_RAY, 0.0, nearest);
        let corners = outline(&bounds);
        if entered.is_some() {
            drawing.area(&corners, &colour(depth + 1), 0.2);
        }
        let look = stroke(colour(depth + 1));
        let look = if entered.is_some() {
            look
        } else {
            look.dashed()
        };
        drawing.path(&corners, true, "none", &look);
    }
    draw_walls(&mut drawing, DVec2::ZERO);
    drawing.arrow(at(0.0), at(8.0), &stroke(colour(5)));
    drawing.dot(at(0.0), INK);
    drawing.text(at(0.0), Side::Above, "*e*");
    for wall in walls() {
        match meet(&wall, &PLAN_RAY, 0.0) {
            Some(t) if t == nearest => drawing.dot(at(t), &colour(5)),
            Some(t) => drawing.ring(at(t)),
            None => {}
        }
    }
    Ok(drawing.made())
}

/// The end of the same walk: what it left out, and the part of the ray that still counted.
pub fn walk_steps(_: &Checkout) -> Result<FigureFile> {
    let boxed = plan();
    let mut drawing = Drawing::new(dvec2(-1.2, -0.2), dvec2(17.2, 8.0));
    let at = |t: f64| {
        let p = PLAN_RAY.at(t);
        dvec2(p.x, p.y)
    };
    let mut nearest = f64::INFINITY;
    let mut is_lit = vec![false; boxed.nodes()];
    boxed.walk(&PLAN_RAY, 0.0, Search::FULL, |step| match step {
        Step::Box(node, entered) => is_lit[node] = entered.is_some(),
        Step::Skip(node, _) => is_lit[node] = false,
        Step::Triangle(_, Some(t)) => nearest = nearest.min(t),
        Step::Triangle(_, None) => {}
    });
    for (bounds, is_lit) in boxed.boxes().iter().zip(is_lit) {
        let corners = outline(bounds);
        let look = if is_lit {
            drawing.area(&corners, &colour(0), 0.2);
            stroke(colour(5))
        } else {
            stroke(colour(4)).dashed()
        };
        drawing.path(&corners, true, "none", &look);
    }
    draw_walls(&mut drawing, DVec2::ZERO);
    drawing.line(at(0.0), at(nearest), &stroke(colour(5)).thick());
    drawing.line(at(nearest), at(8.0), &ink().dashed());
    drawing.dot(at(0.0), INK);
    drawing.text(at(0.0), Side::Above, "*e*");
    drawing.dot(at(nearest), &colour(5));
    drawing.on_lines(at(nearest) + dvec2(0.0, 0.2), Side::Above, "max_t");
    Ok(drawing.made())
}

/// The bunny, and how many tests each of its pixels takes: with one box around it, and with a
/// tree of boxes. Bright means many; the brightest pixels test every triangle and the box.
pub fn tests_per_pixel(checkout: &Checkout) -> Result<FigureFile> {
    let assignment = assignment_with(Kind::TreeSearch, checkout)?;
    let film = Film::read(&assignment.golden().join("bunny.exr"))?;
    let scene = Scene::read(&assignment.scene("bunny"))?;
    let Some(Shape::Soup(soup)) = scene.objects.first() else {
        return Err(Error::environment(
            "the bunny's scene has no bunny",
            "report this",
        ));
    };
    let reference = Reference::of(&assignment, checkout)?;
    let rays = reference.viewing_rays(scene.camera, scene.resolution)?;
    let most = (soup.triangles.len() as f64 + 1.0).ln();
    let heat = |largest_leaf: usize| {
        let boxed = MeshTree::new(soup.triangles.clone(), largest_leaf);
        let resolution = scene.resolution;
        RgbImage::from_fn(resolution.n_x as u32, resolution.n_y as u32, |x, y| {
            let ray = &rays[y as usize * resolution.n_x + x as usize];
            let (_, tests) = boxed.search(ray, scene.min_t, Search::FULL);
            false_colour::far(1.0 - (tests.sum() as f64).ln() / most)
        })
    };
    let pictures = [
        false_colour::normal(&film),
        heat(soup.triangles.len()),
        heat(LARGEST_LEAF),
    ];
    made(&beside(&pictures.map(|picture| enlarged(&picture, 2)), GAP))
}

/// Tests for each ray, as triangles are added, with boxes and without.
pub fn tests_by_triangles(checkout: &Checkout) -> Result<FigureFile> {
    let reference = Reference::of(&assignment_with(Kind::TreeSearch, checkout)?, checkout)?;
    let rays = reference.viewing_rays(camera(), SCATTERED_RESOLUTION)?;
    let points = (1..=5).map(|exponent| {
        let count = 10_usize.pow(exponent);
        let (_, tests) = scattered(count, &rays);
        (count as f64, [tests, count as f64])
    });
    let lines = Lines {
        names: ["a tree of boxes", "no boxes"],
        side: Side::Above,
        at: 3,
        counted: "tests",
    };
    Ok(plot("triangles", lines, points.collect()))
}
