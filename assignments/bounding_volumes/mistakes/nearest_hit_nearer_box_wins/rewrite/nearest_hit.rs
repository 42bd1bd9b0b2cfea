use pinhole::{Hit, Node, RayTree};

pub fn nearest_hit(tree: &dyn RayTree, min_t: f64) -> Option<Hit> {
    let mut waiting = Vec::new();
    if tree.enter_box(0, min_t, f64::INFINITY).is_some() {
        waiting.push(0);
    }
    while let Some(node) = waiting.pop() {
        match tree.node(node) {
            Node::Branch(children) => {
                let enter = |child: &usize| tree.enter_box(*child, min_t, f64::INFINITY);
                let mut entered: Vec<(f64, usize)> = children
                    .iter()
                    .rev()
                    .filter_map(|child| Some((enter(child)?, *child)))
                    .collect();
                entered.sort_by(|x, y| y.0.total_cmp(&x.0));
                waiting.extend(entered.into_iter().map(|(_, child)| child));
            }
            Node::Leaf(triangles) => {
                let hits = triangles
                    .iter()
                    .filter_map(|&it| tree.intersect_triangle(it, min_t).map(|hit| (it, hit)));
                let first = hits.reduce(|a, b| if b.1.t < a.1.t { b } else { a });
                if let Some((object, intersection)) = first {
                    return Some(Hit {
                        object,
                        intersection,
                    });
                }
            }
        }
    }
    None
}
