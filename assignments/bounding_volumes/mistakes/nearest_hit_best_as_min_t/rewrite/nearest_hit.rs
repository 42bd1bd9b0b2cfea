use pinhole::{Hit, Node, RayTree};

pub fn nearest_hit(tree: &dyn RayTree, min_t: f64) -> Option<Hit> {
    let mut found: Option<Hit> = None;
    let mut nodes = vec![0];
    while let Some(node) = nodes.pop() {
        // Only what lies between the best hit and infinity is of interest.
        let bound = |found: &Option<Hit>| match found {
            Some(hit) => hit.intersection.t,
            None => min_t,
        };
        let Some(_) = tree.enter_box(node, bound(&found), f64::INFINITY) else {
            continue;
        };
        match tree.node(node) {
            Node::Branch([a, b]) => nodes.extend([b, a]),
            Node::Leaf(members) => {
                for &object in members {
                    let hit = tree.intersect_triangle(object, bound(&found));
                    let hit = hit.map(|intersection| Hit {
                        object,
                        intersection,
                    });
                    found = hit.or(found);
                }
            }
        }
    }
    found
}
