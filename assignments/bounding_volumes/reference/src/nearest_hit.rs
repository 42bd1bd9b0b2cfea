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
    // ANCHOR: answer
    use pinhole::Node;

    let mut nearest: Option<Hit> = None;
    let root = tree.enter_box(0, min_t, f64::INFINITY);
    let mut waiting: Vec<(usize, f64)> = root.into_iter().map(|t| (0, t)).collect();
    while let Some((node, t)) = waiting.pop() {
        let max_t = nearest.map_or(f64::INFINITY, |hit| hit.intersection.t);
        if t > max_t {
            continue;
        }
        match tree.node(node) {
            Node::Branch(children) => {
                let enter = |child| Some((child, tree.enter_box(child, min_t, max_t)?));
                let mut entered: Vec<(usize, f64)> =
                    children.into_iter().filter_map(enter).collect();
                // Put the nearer child last, because the last is taken first.
                entered.sort_by(|(_, a), (_, b)| b.total_cmp(a));
                waiting.extend(entered);
            }
            Node::Leaf(triangles) => {
                for &object in triangles {
                    let max_t = nearest.map_or(f64::INFINITY, |hit| hit.intersection.t);
                    if let Some(intersection) = tree.intersect_triangle(object, min_t)
                        && intersection.t < max_t
                    {
                        nearest = Some(Hit {
                            object,
                            intersection,
                        });
                    }
                }
            }
        }
    }
    nearest
    // ANCHOR_END: answer
}
// ANCHOR_END: stub
