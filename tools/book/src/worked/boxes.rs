//! Boxes around the worked triangle, and a tree over ten walls.

use glam::dvec3;
use pinhole::job::Job;
use pinhole::kind::{
    Answer, BoundsQuestion, BoxQuestion, Questions, SearchQuestion, TestResults, TreeQuestion,
};
use pinhole::{BoundingBox, Hit, Kind, Ray, Shape, Triangle};
use pinhole_course::checkout::Checkout;

use super::shapes::{RAY, TRIANGLE};
use super::{Values, savings, shown, vector};
use crate::boxes::{MeshTree, Search, box_of, inside, slab};
use crate::course::assignment_with;
use crate::error::{Error, Result};
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
pub const LARGEST_LEAF: usize = 4;

/// The ray across the floor plan, in the plane z = 0.
pub const PLAN_RAY: Ray = Ray {
    origin: dvec3(16.0, 3.0, 0.0),
    direction: dvec3(-2.0, 0.5, 0.0),
};

/// The walls: in the plan each goes from the lower left corner of its box, which is 2 × 1, to the
/// upper right one. They are upright triangles. Where the plane z = 0 cuts them, they are three
/// quarters as long.
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
pub fn plan() -> MeshTree {
    MeshTree::new(walls(), LARGEST_LEAF)
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
    savings::add(values, &reference, &assignment)
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
        example: Default::default(),
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
