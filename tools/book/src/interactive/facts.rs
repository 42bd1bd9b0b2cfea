//! The numbers that interactive figures show, computed beforehand.
//!
//! Students get the script, so it must hold no formula of an answer. It looks up what the
//! reference, or the book's own programs, found for every position of a slider.

use glam::{DVec2, DVec3, dvec2};
use pinhole::{BoundingBox, Hit, Projection, Resolution};
use pinhole_course::checkout::Checkout;
use serde_json::{Value, json};

use super::slice::slice;
use crate::boxes::{Search, Step};
use crate::error::Result;
use crate::figures::colour;
use crate::reference::Reference;
use crate::silhouette::{SIDE, WAYS, on, wrong};
use crate::worked::boxes::{PLAN_RAY, plan, walls};
use crate::worked::{
    PIXEL, Quadratic, RAY, SPHERE, TRIANGLE, on_plane, shown, slide, vector, weights,
};

/// The script's file of facts: a line for each figure.
pub fn text(checkout: &Checkout) -> Result<String> {
    let [r, g, b] = pinhole::false_colour::BACKGROUND.0;
    let facts = [
        ("written_by", json!("cargo pinhole book bundle")),
        (
            "colours",
            json!((0..8).map(colour).collect::<Vec<String>>()),
        ),
        ("background", json!(format!("#{r:02x}{g:02x}{b:02x}"))),
        ("pixel_to_ray", pixel_to_ray(checkout)?),
        ("sphere_roots", sphere_roots()),
        ("triangle_weights", triangle_weights()),
        ("breaking_distance", breaking_distance()),
        ("walk_steps", walk_steps()),
    ];
    let lines = facts.map(|(name, fact)| format!("  {}: {fact}", json!(name)));
    Ok(format!("{{\n{}\n}}\n", lines.join(",\n")))
}

/// The lecture's picture: for each pixel, row by row from the top, its ray and what it hits; and
/// for each column, the slice of the scene that its rays stay in.
fn pixel_to_ray(checkout: &Checkout) -> Result<Value> {
    let scene = slide(checkout)?;
    let (camera, Resolution { n_x, n_y }) = (scene.camera, scene.resolution);
    let forward = match camera.projection {
        Projection::Perspective { focal_length } => focal_length,
        Projection::Orthographic => 0.0,
    };
    let reference = Reference::build(checkout)?;
    let film = reference.film(&scene)?;
    let rays = reference.viewing_rays(camera, scene.resolution)?;
    let hits = (0..scene.resolution.pixels()).map(|index| film.hit(index));
    let hit = |hit: Hit| json!([hit.object, rounded(hit.intersection.t)]);
    let hits: Vec<Option<Value>> = hits.map(|one| one.map(hit)).collect();
    let us = (0..n_x).map(|i| on_plane(i as f64 + 0.5, camera.width, n_x));
    let vs = (0..n_y).map(|j| on_plane(j as f64 + 0.5, camera.height, n_y));
    Ok(json!({
        "columns": n_x,
        "rows": n_y,
        "start": [PIXEL.i, PIXEL.j],
        "forward": forward,
        "height": camera.height,
        "u": us.clone().map(rounded).collect::<Vec<f64>>(),
        "v": vs.map(rounded).collect::<Vec<f64>>(),
        "e": vector(camera.eye),
        "d": rays.iter().map(|ray| vector(ray.direction)).collect::<Vec<String>>(),
        "hits": hits,
        "slices": us.map(|u| slice(&scene, u / forward)).collect::<Vec<Value>>(),
    }))
}

/// How many steps the worked ray is away from the centre, and how many it can be away at most.
const STEPS: (i32, i32) = (30, 42);

/// The worked ray moved across its sphere: the coefficients and roots at each distance.
fn sphere_roots() -> Value {
    let along = RAY.direction.normalize();
    let to_center = SPHERE.center - RAY.origin;
    let ahead = to_center.dot(along);
    let aside = to_center - ahead * along;
    let across = aside.normalize();
    let (start, most) = STEPS;
    let position = |step: i32| {
        let distance = aside.length() * f64::from(step) / f64::from(start);
        let mut ray = RAY;
        ray.origin += (aside.length() - distance) * across;
        let quadratic = Quadratic::new(&ray, &SPHERE);
        let roots = match quadratic.discriminant() < 0.0 {
            true => Value::Null,
            false => json!(quadratic.roots().map(rounded)),
        };
        json!({
            "distance": rounded(distance),
            "k": rounded(quadratic.k),
            "discriminant": rounded(quadratic.discriminant()),
            "roots": roots,
        })
    };
    let worked = Quadratic::new(&RAY, &SPHERE);
    json!({
        "start": start,
        "most": most,
        "a": rounded(worked.a),
        "h": rounded(worked.h),
        "stride": RAY.direction.length(),
        "ahead": ahead,
        "radius": SPHERE.radius,
        "positions": (-most..=most).map(position).collect::<Vec<Value>>(),
    })
}

/// The worked triangle in its plane, and the matrix from a place there to α and β.
fn triangle_weights() -> Value {
    let [a, b, c] = TRIANGLE.corners;
    let (first, second) = (b - a, c - a);
    let along = first.normalize();
    let across = first.cross(second).cross(first).normalize();
    let flat = |edge: DVec3| dvec2(edge.dot(along), edge.dot(across));
    let (t1, t2) = (flat(first), flat(second));
    let to_weights = glam::DMat2::from_cols(t1, t2).inverse();
    let [_, alpha, beta] = weights(&RAY, &TRIANGLE);
    let pair = |DVec2 { x, y }: DVec2| [x, y];
    json!({
        "t1": pair(t1),
        "t2": pair(t2),
        "to_weights": [pair(to_weights.row(0)), pair(to_weights.row(1))],
        "start": [alpha, beta],
    })
}

/// The silhouettes at every half power of ten, a hexadecimal digit for four pixels.
fn breaking_distance() -> Value {
    let powers: Vec<f64> = (2..=24).map(|half| f64::from(half) / 2.0).collect();
    let way = |(name, meets): (&str, crate::silhouette::Meets)| {
        let pictures = powers.iter().map(|power| {
            let far = 10f64.powf(*power);
            let pixels = (0..SIDE).flat_map(|j| (0..SIDE).map(move |i| (i, j)));
            let bits: Vec<bool> = pixels.map(|(i, j)| meets(on(i), on(j), far)).collect();
            let digit = |four: &[bool]| {
                let value = four
                    .iter()
                    .fold(0, |value, bit| 2 * value + u32::from(*bit));
                char::from_digit(value, 16).expect("four bits are below 16")
            };
            let digits: String = bits.chunks(4).map(digit).collect();
            json!({ "pixels": digits, "wrong": wrong(meets, far) })
        });
        json!({ "way": name, "pictures": pictures.collect::<Vec<Value>>() })
    };
    json!({ "side": SIDE, "ways": WAYS.map(way) })
}

/// The floor plan, and a search along each of some rays: the worked one, and others from the
/// same place that lean more or less.
fn walk_steps() -> Value {
    let plan = plan();
    let flat = |bounds: &BoundingBox| [bounds.min.x, bounds.min.y, bounds.max.x, bounds.max.y];
    let lines = walls().into_iter().map(|wall| {
        let [from, to, _] = wall.corners;
        [from.x, from.y, to.x, to.y]
    });
    let (start, most) = LEANS;
    let search = |lean: i32| {
        let mut ray = PLAN_RAY;
        ray.direction.y *= f64::from(lean) / f64::from(start);
        let mut steps = Vec::new();
        plan.walk(&ray, 0.0, Search::FULL, |step| {
            let (what, place, t) = match step {
                Step::Box(node, t) => ("box", node, t),
                Step::Triangle(wall, t) => ("wall", wall, t),
                Step::Skip(node, t) => ("skip", node, Some(t)),
            };
            steps.push(json!([what, place, t.map(rounded)]));
        });
        json!({
            "d": vector(ray.direction),
            "lean": ray.direction.y / ray.direction.x,
            "steps": steps,
        })
    };
    json!({
        "e": [PLAN_RAY.origin.x, PLAN_RAY.origin.y],
        "stride": PLAN_RAY.direction.x,
        "start": start,
        "least": -most,
        "walls": lines.collect::<Vec<[f64; 4]>>(),
        "boxes": plan.boxes().iter().map(flat).collect::<Vec<[f64; 4]>>(),
        "rays": (-most..=most).map(search).collect::<Vec<Value>>(),
    })
}

/// How many steps the worked ray leans, and how many the rays lean at most.
const LEANS: (i32, i32) = (5, 8);

/// As many digits as the page shows.
fn rounded(value: f64) -> f64 {
    shown(value).replace('−', "-").parse().unwrap_or(f64::NAN)
}
