use pinhole::{Hit, Node, RayTree};

pub fn nearest_hit(tree: &dyn RayTree, min_t: f64) -> Option<Hit> {
    let mut stack = vec![0];
    while let Some(top) = stack.pop() {
        if tree.enter_box(top, min_t, f64::INFINITY).is_none() {
            continue;
        }
        match tree.node(top) {
            Node::Branch([a, b]) => {
                stack.push(b);
                stack.push(a);
            }
            Node::Leaf(members) => {
                let mut found: Option<Hit> = None;
                for &member in members {
                    if let Some(hit) = tree.intersect_triangle(member, min_t)
                        && found.is_none_or(|best| hit.t < best.intersection.t)
                    {
                        found = Some(Hit {
                            object: member,
                            intersection: hit,
                        });
                    }
                }
                if found.is_some() {
                    return found;
                }
            }
        }
    }
    None
}
