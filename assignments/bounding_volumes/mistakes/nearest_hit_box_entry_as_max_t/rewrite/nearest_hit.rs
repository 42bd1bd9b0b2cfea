use pinhole::{Hit, Node, RayTree};

struct Best {
    hit: Option<Hit>,
    /// Where the ray enters the box that has the hit.
    entry: f64,
}

pub fn nearest_hit(tree: &dyn RayTree, min_t: f64) -> Option<Hit> {
    let mut best = Best {
        hit: None,
        entry: f64::INFINITY,
    };
    let entry = tree.enter_box(0, min_t, best.entry)?;
    visit(tree, (0, entry), min_t, &mut best);
    best.hit
}

fn visit(tree: &dyn RayTree, (node, entry): (usize, f64), min_t: f64, best: &mut Best) {
    if entry > best.entry {
        return;
    }
    match tree.node(node) {
        Node::Leaf(members) => {
            let hits = members.iter().filter_map(|&object| {
                let intersection = tree.intersect_triangle(object, min_t)?;
                Some(Hit {
                    object,
                    intersection,
                })
            });
            let nearest = hits.min_by(|a, b| a.intersection.t.total_cmp(&b.intersection.t));
            if let Some(hit) = nearest
                && best
                    .hit
                    .is_none_or(|old| hit.intersection.t < old.intersection.t)
            {
                *best = Best {
                    hit: Some(hit),
                    entry,
                };
            }
        }
        Node::Branch(children) => {
            let entries = children.map(|child| tree.enter_box(child, min_t, best.entry));
            let mut entered: Vec<(usize, f64)> = children
                .into_iter()
                .zip(entries)
                .rev()
                .filter_map(|(child, t)| Some((child, t?)))
                .collect();
            entered.sort_by(|a, b| a.1.total_cmp(&b.1));
            for child in entered {
                visit(tree, child, min_t, best);
            }
        }
    }
}
