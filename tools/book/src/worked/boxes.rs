//! Boxes around the worked triangle, a tree over ten walls, and what boxes save in pictures.

use std::mem::size_of;

use glam::{DVec3, dvec3};
use pinhole::job::Job;
use pinhole::kind::{
    Answer, BoundsQuestion, BoxQuestion, Questions, SearchQuestion, TestResults, TreeQuestion,
};
use pinhole::tree::FlatNode;
use pinhole::{BoundingBox, Hit, Kind, Ray, Resolution, Scene, Shape, Triangle, TriangleSoup};
use pinhole_course::checkout::Checkout;

use super::shapes::{RAY, TRIANGLE};
use super::{Values, shown, vector};
use crate::boxes::{Boxed, Search, Tests, box_of, enters_in_f32, inside, meet, slab};
use crate::course::assignment_with;
use crate::error::{Error, Result};
use crate::rasterizer::{camera, strewn};
use crate::reference::Reference;

/// The middles of ten walls in a floor plan.
const MIDDLES: [[f64; 2]; 10] = [
    [1.0, 1.0],
    [2.0, 6.0],
    [4.0, 1.0],
    [4.0, 5.0],
    [5.0, 3.0],
    [2.0, 3.0],
    [9.0, 2.0],
    [10.0, 5.0],
    [12.0, 1.0],
    [13.0, 4.0],
];

/// How many walls a leaf has at most.
const LARGEST_LEAF: usize = 4;

/// The ray across the floor plan, in the plane z = 0.
pub const PLAN_RAY: Ray = Ray {
    origin: dvec3(16.0, 3.0, 0.0),
    direction: dvec3(-2.0, 0.5, 0.0),
};

/// The walls: in the plan each goes from the lower left corner of its box, which is 2 × 1, to
/// the upper right one. They are triangles on end, which the plane z = 0 cuts three quarters
/// as long.
pub fn walls() -> Vec<Triangle> {
    let wall = |[x, y]: [f64; 2]| Triangle {
        corners: [
            dvec3(x - 1.0, y - 0.5, -1.0),
            dvec3(x + 1.0, y + 0.5, -1.0),
            dvec3(x, y, 3.0),
        ],
    };
    MIDDLES.map(wall).into()
}

/// Their tree.
pub fn plan() -> Boxed {
    Boxed::new(walls(), LARGEST_LEAF)
}

/// A flat box that the worked ray meets.
const FLAT: BoundingBox = BoundingBox {
    min: dvec3(1.0, 3.0, -7.0),
    max: dvec3(5.0, 3.0, -1.0),
};

/// Adds these chapters' numbers.
pub fn add(values: &mut Values, checkout: &Checkout) -> Result<()> {
    let assignment = assignment_with(Kind::TreeSearch, checkout)?;
    let reference = Reference::of(&assignment, checkout)?;
    around(values, &reference)?;
    slabs(values, &reference)?;
    tree(values, &reference)?;
    walk(values, &reference)?;
    let scene = Scene::read(&assignment.scene("bunny"))?;
    let rays = reference.viewing_rays(scene.camera, scene.resolution)?;
    bunny(values, &scene, &rays)?;
    sizes(values, &reference)
}

/// Boxes of triangles, and a box around two.
fn around(values: &mut Values, reference: &Reference) -> Result<()> {
    let bounds = |question| match reference.ask(&Job::Ask(Questions::Bounds(vec![question])))? {
        Answer::Box(bounds) => Ok(bounds),
        _ => Err(Error::environment(
            "the reference gives no box",
            "report this",
        )),
    };
    let mut add = |name: &str, bounds: BoundingBox| {
        values.insert(format!("box_{name}_min"), vector(bounds.min));
        values.insert(format!("box_{name}_max"), vector(bounds.max));
    };
    let pushed = TRIANGLE.corners.map(|corner| corner + 3.0 * RAY.direction);
    let own = bounds(BoundsQuestion::Triangle(TRIANGLE))?;
    let pushed = bounds(BoundsQuestion::Triangle(Triangle { corners: pushed }))?;
    add("own", own);
    add("pushed", pushed);
    add("join", bounds(BoundsQuestion::Boxes(own, pushed))?);
    Ok(())
}

/// The worked ray and the worked triangle's box.
fn slabs(values: &mut Values, reference: &Reference) -> Result<()> {
    let bounds = box_of(&[TRIANGLE]);
    for (axis, name) in ["x", "y", "z"].into_iter().enumerate() {
        let times = slab(&bounds, &RAY, axis).map_or("none".into(), |[from, to]| {
            format!("{} to {}", shown(from), shown(to))
        });
        values.insert(format!("slab_{name}"), times);
    }
    let beside = |x: f64| Ray {
        origin: dvec3(x, 1.0, 0.0),
        direction: dvec3(0.0, 2.0, -2.0),
    };
    let endless = f64::INFINITY;
    for (name, bounds, ray, min_t, max_t) in [
        ("from_1", bounds, RAY, 1.0, endless),
        ("from_2", bounds, RAY, 2.0, endless),
        ("from_3_5", bounds, RAY, 3.5, endless),
        ("to_1_2", bounds, RAY, 1.0, 1.2),
        ("to_2", bounds, RAY, 1.0, 2.0),
        ("zero_between", bounds, beside(2.0), 1.0, endless),
        ("zero_on_face", bounds, beside(1.0), 1.0, endless),
        ("zero_outside", bounds, beside(0.0), 1.0, endless),
        ("flat", FLAT, RAY, 0.0, endless),
    ] {
        let question = BoxQuestion {
            bounds,
            ray,
            min_t,
            max_t,
        };
        let t = match reference.ask(&Job::Ask(Questions::RayBox(vec![question])))? {
            Answer::Hit(Some(hit)) => shown(hit.intersection.t),
            _ => "none".into(),
        };
        values.insert(format!("enter_{name}"), t);
    }
    let at = |name: &str| Some(RAY.at(values.get(name)?.parse().ok()?));
    let point = at("enter_from_1").map_or("none".into(), vector);
    values.insert("enter_point".into(), point);
    Ok(())
}

/// The tree over the flat boxes of ten triangles.
fn tree(values: &mut Values, reference: &Reference) -> Result<()> {
    let half = dvec3(1.0, 0.5, 0.0);
    let boxes = MIDDLES.map(|[x, y]| BoundingBox {
        min: dvec3(x, y, 0.0) - half,
        max: dvec3(x, y, 0.0) + half,
    });
    let question = TreeQuestion {
        boxes: boxes.into(),
    };
    let answer = reference.ask(&Job::Ask(Questions::Tree(vec![question])))?;
    let Answer::Tree(measures) = answer else {
        return Err(Error::environment(
            "the reference gives no tree",
            "report this",
        ));
    };
    let mut add = |name: &str, text: String| values.insert(format!("tree_{name}"), text);
    add("misplaced", measures.misplaced.to_string());
    add("depth", measures.depth.to_string());
    add("largest_leaf", measures.largest_leaf.to_string());
    add("cost", shown(measures.cost));
    Ok(())
}

/// The tests that a ray across the floor plan takes.
fn walk(values: &mut Values, reference: &Reference) -> Result<()> {
    let plan = plan();
    let ray = &PLAN_RAY;
    let intervals = plan.boxes().iter();
    let intervals = intervals.map(|bounds| inside(bounds, ray, f64::NEG_INFINITY, f64::INFINITY));
    let boxes: Vec<_> = intervals
        .map(|interval| interval.map(|[from, to]| from..=to))
        .collect();
    let mut triangles = Vec::new();
    for (object, wall) in walls().into_iter().enumerate() {
        let met = reference.intersect(&Shape::Triangle(wall), *ray, 0.0)?;
        triangles.extend(met.map(|intersection| Hit {
            object,
            intersection,
        }));
    }
    let mut add = |name: String, text: String| values.insert(format!("walk_{name}"), text);
    for (node, interval) in boxes.iter().enumerate() {
        let words = interval.as_ref().map_or("missed".into(), |interval| {
            format!("{} to {}", shown(*interval.start()), shown(*interval.end()))
        });
        add(format!("box_{node}"), words);
    }
    for hit in &triangles {
        add(format!("wall_{}", hit.object), shown(hit.intersection.t));
    }
    let results = TestResults { boxes, triangles };
    for (name, min_t) in [("0", 0.0), ("2", 2.0), ("4_5", 4.5)] {
        let question = SearchQuestion {
            tree: plan.tree().clone(),
            min_t,
            results: results.clone(),
        };
        let (hit, tests) = reference.search(question)?;
        let words = hit.map_or("none".into(), |hit| {
            format!("wall {}, t = {}", hit.object, shown(hit.intersection.t))
        });
        add(format!("from_{name}"), words);
        add(format!("tests_from_{name}"), tests.to_string());
    }
    let first_child_first = Search {
        nearer_first: false,
        ..Search::FULL
    };
    let (_, tests) = plan.search(ray, 0.0, first_child_first);
    add("tests_first_child_first".into(), tests.sum().to_string());
    Ok(())
}

/// What the bunny costs.
fn bunny(values: &mut Values, scene: &Scene, rays: &[Ray]) -> Result<()> {
    let Some(Shape::Soup(TriangleSoup { triangles })) = scene.objects.first() else {
        return Err(Error::environment(
            "the bunny's scene has no bunny",
            "report this",
        ));
    };
    let mut add = |name: &str, text: String| values.insert(format!("bunny_{name}"), text);
    let per_ray = |tests: usize| format!("{:.1}", tests as f64 / rays.len() as f64);
    add("triangles", grouped(triangles.len()));
    add("rays", grouped(rays.len()));
    add("brute", grouped(triangles.len() * rays.len()));
    let tests = |largest: usize, how: Search| -> (usize, usize, Tests) {
        let boxed = Boxed::new(triangles.clone(), largest);
        (
            boxed.nodes(),
            boxed.depth(),
            boxed.tests(rays, scene.min_t, how),
        )
    };
    let unordered = Search {
        nearer_first: false,
        ..Search::FULL
    };
    let endless = Search {
        stops: false,
        ..Search::FULL
    };
    for (name, how) in [
        ("full", Search::FULL),
        ("unordered", unordered),
        ("endless", endless),
    ] {
        let (_, _, tests) = tests(LARGEST_LEAF, how);
        add(&format!("{name}_tests"), grouped(tests.sum()));
        add(&format!("{name}_boxes_per_ray"), per_ray(tests.boxes));
        add(
            &format!("{name}_triangles_per_ray"),
            per_ray(tests.triangles),
        );
        add(&format!("{name}_per_ray"), per_ray(tests.sum()));
        let saved = (triangles.len() * rays.len()) as f64 / tests.sum() as f64;
        add(&format!("{name}_fewer"), format!("{saved:.0}"));
    }
    let root = box_of(triangles);
    let meet_root = |ray: &&Ray| inside(&root, ray, scene.min_t, f64::INFINITY).is_some();
    add(
        "rays_at_root",
        grouped(rays.iter().filter(meet_root).count()),
    );
    for largest in [1, 2, 4, 8, 16] {
        let (nodes, depth, tests) = tests(largest, Search::FULL);
        add(&format!("leaf_{largest}_nodes"), grouped(nodes));
        add(&format!("leaf_{largest}_depth"), depth.to_string());
        add(&format!("leaf_{largest}_boxes"), per_ray(tests.boxes));
        add(
            &format!("leaf_{largest}_triangles"),
            per_ray(tests.triangles),
        );
        add(&format!("leaf_{largest}_per_ray"), per_ray(tests.sum()));
    }
    // A ray to each corner of each triangle, all of which lie on their boxes' faces.
    let eye = scene.camera.eye;
    let aimed = triangles.iter().flat_map(|triangle| {
        let ray = |corner: DVec3| Ray {
            origin: eye,
            direction: corner - eye,
        };
        triangle.corners.map(|corner| (*triangle, ray(corner)))
    });
    let met: Vec<(Triangle, Ray)> = aimed
        .filter(|(triangle, ray)| meet(triangle, ray, 0.0).is_some())
        .collect();
    add("corner_rays", grouped(met.len()));
    let lost = |enters: &dyn Fn(&BoundingBox, &Ray) -> bool| {
        let lost = met
            .iter()
            .filter(|(triangle, ray)| !enters(&box_of(&[*triangle]), ray));
        grouped(lost.count())
    };
    let whole = (root.max - root.min).max_element() as f32;
    let f64_slabs =
        |bounds: &BoundingBox, ray: &Ray| inside(bounds, ray, 0.0, f64::INFINITY).is_some();
    add("lost_f64", lost(&f64_slabs));
    add(
        "lost_f32",
        lost(&|bounds, ray| enters_in_f32(bounds, ray, 0.0)),
    );
    add(
        "lost_f32_padded",
        lost(&|bounds, ray| enters_in_f32(bounds, ray, 1e-6 * whole)),
    );
    Ok(())
}

/// Meshes of ever more triangles, each covering the same part of the picture.
fn sizes(values: &mut Values, reference: &Reference) -> Result<()> {
    let resolution = Resolution { n_x: 160, n_y: 90 };
    let rays = reference.viewing_rays(camera(), resolution)?;
    for exponent in 1..=5 {
        let count = 10_usize.pow(exponent);
        let triangles = strewn(count, 10.0 / (count as f64).sqrt());
        let boxed = Boxed::new(triangles, LARGEST_LEAF);
        let tests = boxed.tests(&rays, 1.0, Search::FULL).sum() as f64 / rays.len() as f64;
        let bytes = boxed.nodes() * (size_of::<FlatNode>() + size_of::<BoundingBox>())
            + count * size_of::<usize>();
        let mut add = |name: &str, text| values.insert(format!("size_1e{exponent}_{name}"), text);
        add("tests", format!("{tests:.1}"));
        add("fewer", format!("{:.0}", count as f64 / tests));
        add("nodes", grouped(boxed.nodes()));
        add("depth", boxed.depth().to_string());
        add("kilobytes", grouped(bytes.div_ceil(1000)));
    }
    Ok(())
}

/// A whole number with its thousands set apart.
fn grouped(number: usize) -> String {
    let digits = number.to_string();
    let mut text = String::new();
    for (place, digit) in digits.chars().enumerate() {
        if place > 0 && (digits.len() - place) % 3 == 0 {
            text.push(',');
        }
        text.push(digit);
    }
    text
}
