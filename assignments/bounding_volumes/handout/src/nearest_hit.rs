use pinhole::{Hit, RayTree};

// ANCHOR: stub
/// The nearest triangle of a tree along a ray, from `min_t` on: `object` is the triangle's
/// number, as a leaf names it. `None` if the ray meets no triangle.
///
/// Node 0 is the root. Every call to `tree.enter_box` and `tree.intersect_triangle` is a
/// test, and the tests are counted. So of two boxes, look first into the one that the ray
/// enters first. Don't look into a box that the ray misses, or that it enters behind a
/// triangle that you have already found.
///
/// Book: Walking the tree.
pub fn nearest_hit(tree: &dyn RayTree, min_t: f64) -> Option<Hit> {
    todo!("nearest_hit")
}
// ANCHOR_END: stub
