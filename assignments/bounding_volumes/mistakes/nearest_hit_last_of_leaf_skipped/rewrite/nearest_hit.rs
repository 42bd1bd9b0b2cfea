use pinhole::{Hit, Node, RayTree};

pub fn nearest_hit(tree: &dyn RayTree, min_t: f64) -> Option<Hit> {
    let entry = tree.enter_box(0, min_t, f64::INFINITY)?;
    visit(tree, (0, entry), min_t, None)
}

fn visit(
    tree: &dyn RayTree,
    (node, entry): (usize, f64),
    min_t: f64,
    best: Option<Hit>,
) -> Option<Hit> {
    let bound = best.map_or(f64::INFINITY, |hit| hit.intersection.t);
    if entry > bound {
        return best;
    }
    match tree.node(node) {
        Node::Leaf([members @ .., _]) => {
            let hits = members.iter().filter_map(|&object| {
                let intersection = tree.intersect_triangle(object, min_t)?;
                Some(Hit {
                    object,
                    intersection,
                })
            });
            best.into_iter()
                .chain(hits)
                .min_by(|a, b| a.intersection.t.total_cmp(&b.intersection.t))
        }
        Node::Leaf([]) => best,
        Node::Branch(children) => {
            let mut entered: Vec<(usize, f64)> = children
                .into_iter()
                .rev()
                .filter_map(|child| Some((child, tree.enter_box(child, min_t, bound)?)))
                .collect();
            entered.sort_by(|a, b| a.1.total_cmp(&b.1));
            entered
                .into_iter()
                .fold(best, |best, child| visit(tree, child, min_t, best))
        }
    }
}
