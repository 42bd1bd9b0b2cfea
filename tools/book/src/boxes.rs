//! A search through boxes that counts its tests, to measure what it saves.
//!
//! The judge counts tests only in searches of small trees. The book needs the counts of whole
//! pictures, and of searches that leave out one idea or the other. All of them must find the same
//! triangles.

use glam::{DVec3, Vec3};
use pinhole::tree::FlatNode;
use pinhole::{BoundingBox, FlatTree, Node, Ray, Tree, Triangle};

/// A mesh in a tree of boxes.
pub struct MeshTree {
    triangles: Vec<Triangle>,
    tree: FlatTree,
    boxes: Vec<BoundingBox>,
}

/// Which ideas a search uses.
#[derive(Clone, Copy, Debug)]
pub struct Search {
    /// It first walks into the box that the ray enters first.
    pub nearer_first: bool,
    /// It skips boxes behind the nearest triangle so far.
    pub stops: bool,
}

impl Search {
    /// All ideas.
    pub const FULL: Search = Search {
        nearer_first: true,
        stops: true,
    };
}

/// How many tests a search took.
#[derive(Clone, Copy, Debug, Default)]
pub struct Tests {
    /// Boxes.
    pub boxes: usize,
    /// Triangles.
    pub triangles: usize,
}

impl Tests {
    /// All tests together.
    pub fn sum(self) -> usize {
        self.boxes + self.triangles
    }

    fn add(&mut self, other: Tests) {
        self.boxes += other.boxes;
        self.triangles += other.triangles;
    }
}

/// What a search does next.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Step {
    /// It tests a node's box; where the ray enters it, if it does.
    Box(usize, Option<f64>),
    /// It tests a triangle; where the ray meets it, if it does.
    Triangle(usize, Option<f64>),
    /// It leaves out a node whose box the ray enters only behind the nearest triangle so far.
    Skip(usize, f64),
}

/// The smallest box around these points.
///
/// # Panics
/// If there are none.
fn around(points: impl Iterator<Item = DVec3> + Clone) -> BoundingBox {
    let corner = |pick: fn(DVec3, DVec3) -> DVec3| {
        let corner = points.clone().reduce(pick);
        corner.expect("a box is around something")
    };
    BoundingBox {
        min: corner(DVec3::min),
        max: corner(DVec3::max),
    }
}

/// The smallest box around some triangles.
pub fn box_of(triangles: &[Triangle]) -> BoundingBox {
    around(triangles.iter().flat_map(|triangle| triangle.corners))
}

impl MeshTree {
    /// Splits at the middle of the longest axis of the boxes' centres, until each leaf has at
    /// most `largest` triangles.
    pub fn new(triangles: Vec<Triangle>, largest: usize) -> MeshTree {
        let own: Vec<BoundingBox> = triangles.iter().map(|it| box_of(&[*it])).collect();
        let places = (0..triangles.len()).collect();
        let tree = FlatTree::from(split(places, &own, largest));
        let corners = |places: &[usize]| {
            let own = places.iter().map(|&place| own[place]);
            around(own.flat_map(|own| [own.min, own.max]))
        };
        let join =
            |a: &BoundingBox, b: &BoundingBox| around([a.min, a.max, b.min, b.max].into_iter());
        let boxes = tree.boxes(corners, join);
        MeshTree {
            triangles,
            tree,
            boxes,
        }
    }

    /// How many nodes its tree has.
    pub fn nodes(&self) -> usize {
        self.boxes.len()
    }

    /// How many branches are above the deepest leaf.
    pub fn depth(&self) -> usize {
        let mut depths = vec![0; self.nodes()];
        for (index, node) in self.tree.0.iter().enumerate() {
            if let FlatNode::Branch(children) = node {
                for &child in children {
                    depths[child] = depths[index] + 1;
                }
            }
        }
        depths.into_iter().max().unwrap_or(0)
    }

    /// The tree.
    pub fn tree(&self) -> &FlatTree {
        &self.tree
    }

    /// The box of each of its nodes.
    pub fn boxes(&self) -> &[BoundingBox] {
        &self.boxes
    }

    /// The triangle that a ray meets first from `min_t` on, its t, and how many tests the search
    /// took.
    pub fn search(&self, ray: &Ray, min_t: f64, how: Search) -> (Option<(usize, f64)>, Tests) {
        let mut tests = Tests::default();
        let nearest = self.walk(ray, min_t, how, |step| match step {
            Step::Box(..) => tests.boxes += 1,
            Step::Triangle(..) => tests.triangles += 1,
            Step::Skip(..) => {}
        });
        (nearest, tests)
    }

    /// Searches like [`MeshTree::search`], and passes each step to `see`.
    pub fn walk(
        &self,
        ray: &Ray,
        min_t: f64,
        how: Search,
        mut see: impl FnMut(Step),
    ) -> Option<(usize, f64)> {
        let mut nearest: Option<(usize, f64)> = None;
        let enter = |node: usize, nearest: Option<(usize, f64)>, see: &mut dyn FnMut(Step)| {
            let max_t = match nearest {
                Some((_, t)) if how.stops => t,
                _ => f64::INFINITY,
            };
            let entered = inside(&self.boxes[node], ray, min_t, max_t).map(|[t, _]| t);
            see(Step::Box(node, entered));
            Some((node, entered?))
        };
        let mut waiting: Vec<(usize, f64)> = enter(0, None, &mut see).into_iter().collect();
        while let Some((node, t)) = waiting.pop() {
            if how.stops && nearest.is_some_and(|(_, best)| t > best) {
                see(Step::Skip(node, t));
                continue;
            }
            match self.tree.node(node) {
                Node::Branch([a, b]) => {
                    // What is pushed last is opened first. If the ray enters both boxes at the same
                    // t, that is the second, as in our answer.
                    let children = if how.nearer_first { [a, b] } else { [b, a] };
                    let mut entered: Vec<(usize, f64)> = children
                        .into_iter()
                        .filter_map(|child| enter(child, nearest, &mut see))
                        .collect();
                    if how.nearer_first {
                        entered.sort_by(|(_, one), (_, other)| other.total_cmp(one));
                    }
                    waiting.extend(entered);
                }
                Node::Leaf(places) => {
                    for &place in places {
                        let t = meet(&self.triangles[place], ray, min_t);
                        see(Step::Triangle(place, t));
                        if let Some(t) = t
                            && nearest.is_none_or(|(_, best)| t < best)
                        {
                            nearest = Some((place, t));
                        }
                    }
                }
            }
        }
        nearest
    }

    /// The tests that all these rays take.
    pub fn tests(&self, rays: &[Ray], min_t: f64, how: Search) -> Tests {
        let mut all = Tests::default();
        for ray in rays {
            all.add(self.search(ray, min_t, how).1);
        }
        all
    }
}

fn split(mut places: Vec<usize>, own: &[BoundingBox], largest: usize) -> Tree {
    if places.len() <= largest {
        return Tree::Leaf(places);
    }
    let middles = around(places.iter().map(|&place| own[place].center()));
    let axis = (middles.max - middles.min).max_position();
    let (mut low, mut high): (Vec<usize>, Vec<usize>) = places
        .iter()
        .partition(|&&place| own[place].center()[axis] < middles.center()[axis]);
    if low.is_empty() || high.is_empty() {
        high = places.split_off(places.len() / 2);
        low = places;
    }
    Tree::Branch(Box::new([
        split(low, own, largest),
        split(high, own, largest),
    ]))
}

/// The interval of t in which a ray is between the two faces of a box across an axis; `None` if it
/// never is.
pub fn slab(bounds: &BoundingBox, ray: &Ray, axis: usize) -> Option<[f64; 2]> {
    let faces = [bounds.min[axis], bounds.max[axis]].map(|face| face - ray.origin[axis]);
    match ray.direction[axis] {
        0.0 if faces[0] > 0.0 || faces[1] < 0.0 => None,
        0.0 => Some([f64::NEG_INFINITY, f64::INFINITY]),
        step => {
            let mut times = faces.map(|face| face / step);
            times.sort_by(f64::total_cmp);
            Some(times)
        }
    }
}

/// The interval of t in which a ray is in a box, from `min_t` to `max_t`: three slabs (Kay & Kajiya
/// 1986).
pub fn inside(bounds: &BoundingBox, ray: &Ray, min_t: f64, max_t: f64) -> Option<[f64; 2]> {
    let mut inside = [min_t, max_t];
    for axis in 0..3 {
        let [from, to] = slab(bounds, ray, axis)?;
        inside = [inside[0].max(from), inside[1].min(to)];
    }
    (inside[0] <= inside[1]).then_some(inside)
}

/// Where a ray meets a triangle, edges included: the chapter's two cross products (Möller &
/// Trumbore 1997).
pub fn meet(triangle: &Triangle, ray: &Ray, min_t: f64) -> Option<f64> {
    let [a, b, c] = triangle.corners;
    let (t1, t2, s, d) = (b - a, c - a, ray.origin - a, ray.direction);
    let (first, second) = (d.cross(t2), s.cross(t1));
    let determinant = t1.dot(first);
    let [alpha, beta, t] = [s.dot(first), d.dot(second), t2.dot(second)].map(|it| it / determinant);
    let is_inside = alpha >= 0.0 && beta >= 0.0 && alpha + beta <= 1.0;
    (is_inside && t >= min_t).then_some(t)
}

/// Whether a ray meets a box from t = 0 on, computed in `f32` with the box's faces moved outward
/// by `padding`.
pub fn enters_in_f32(bounds: &BoundingBox, ray: &Ray, padding: f32) -> bool {
    let [min, max] = [bounds.min, bounds.max].map(|corner| corner.as_vec3());
    let (min, max) = (min - padding, max + padding);
    let (e, d): (Vec3, Vec3) = (ray.origin.as_vec3(), ray.direction.as_vec3());
    let (mut enter, mut leave) = (0.0_f32, f32::INFINITY);
    for axis in 0..3 {
        let (a, b) = (
            (min[axis] - e[axis]) / d[axis],
            (max[axis] - e[axis]) / d[axis],
        );
        enter = enter.max(a.min(b));
        leave = leave.min(a.max(b));
    }
    enter <= leave
}

#[cfg(test)]
mod tests {
    use pinhole::{Scene, Shape};
    use pinhole_course::checkout::Checkout;

    use super::*;
    use crate::course::assignments;
    use crate::reference::Reference;

    /// Every search must cast the reference's film, and the slower ones must take more tests.
    #[test]
    fn all_searches_find_what_the_reference_finds() {
        let checkout = Checkout::find().expect("tests run in a checkout");
        let mut assignments = assignments(&checkout).expect("they are there").into_iter();
        let assignment = assignments.find(|it| it.scene("same_centre").is_file());
        let assignment = assignment.expect("one has this scene");
        let reference = Reference::of(&assignment, &checkout).expect("it builds");
        let scene = Scene::read(&assignment.scene("teapot")).expect("it is there");
        let Some(Shape::Soup(soup)) = scene.objects.first() else {
            panic!("the scene is one mesh");
        };
        let rays = reference.viewing_rays(scene.camera, scene.resolution);
        let rays: Vec<Ray> = rays.unwrap().into_iter().step_by(7).collect();
        let met = reference.intersect_all(&scene.objects[0], &rays, scene.min_t);
        let met = met.unwrap();
        let mut sums = Vec::new();
        for (largest, how) in [
            (4, Search::FULL),
            (
                4,
                Search {
                    nearer_first: false,
                    ..Search::FULL
                },
            ),
            (
                4,
                Search {
                    nearer_first: false,
                    stops: false,
                },
            ),
            (soup.triangles.len(), Search::FULL),
        ] {
            let boxed = MeshTree::new(soup.triangles.clone(), largest);
            let mut sum = 0;
            for (ray, met) in rays.iter().zip(&met) {
                let (found, tests) = boxed.search(ray, scene.min_t, how);
                let [found, met] = [found.map(|(_, t)| t), met.map(|met| met.t)];
                assert_eq!(found.is_some(), met.is_some(), "{how:?}");
                let apart = found.zip(met).map_or(0.0, |(found, met)| found / met - 1.0);
                assert!(apart.abs() < 1e-12, "{how:?}: {found:?} is {met:?}");
                sum += tests.sum();
            }
            sums.push(sum);
        }
        assert!(sums.is_sorted_by(|one, next| one < next), "{sums:?}");
    }
}
