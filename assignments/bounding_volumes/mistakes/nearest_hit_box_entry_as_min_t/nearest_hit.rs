use pinhole::{Hit, Node, RayTree};

pub fn nearest_hit(tree: &dyn RayTree, min_t: f64) -> Option<Hit> {
    let mut nearest: Option<Hit> = None;
    let root = tree.enter_box(0, min_t, f64::INFINITY)?;
    let mut waiting = vec![(root, 0)];
    while let Some((t, node)) = waiting.pop() {
        let max_t = nearest.map_or(f64::INFINITY, |hit| hit.intersection.t);
        if t > max_t {
            continue;
        }
        match tree.node(node) {
            Node::Leaf(triangles) => {
                for &object in triangles {
                    if let Some(intersection) = tree.intersect_triangle(object, t)
                        && nearest.is_none_or(|hit| intersection.t < hit.intersection.t)
                    {
                        nearest = Some(Hit {
                            object,
                            intersection,
                        });
                    }
                }
            }
            Node::Branch(children) => {
                let mut entered = Vec::new();
                for child in children {
                    if let Some(t) = tree.enter_box(child, t, max_t) {
                        entered.push((t, child));
                    }
                }
                entered.sort_by(|a, b| b.0.total_cmp(&a.0));
                waiting.extend(entered);
            }
        }
    }
    nearest
}
