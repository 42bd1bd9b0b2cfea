use pinhole::{Hit, Intersection, Node, RayTree};

pub fn nearest_hit(tree: &dyn RayTree, min_t: f64) -> Option<Hit> {
    let mut best: Option<(Intersection, usize)> = None;
    let mut bound = f64::INFINITY;
    let mut stack = vec![0];
    while let Some(node) = stack.pop() {
        if tree.enter_box(node, min_t, bound).is_none() {
            continue;
        }
        match tree.node(node) {
            Node::Branch(children) => stack.extend(children.iter().rev()),
            Node::Leaf(members) => {
                let hits = members
                    .iter()
                    .filter_map(|&it| Some((tree.intersect_triangle(it, min_t)?, it)));
                best = best
                    .into_iter()
                    .chain(hits)
                    .min_by(|a, b| a.0.t.total_cmp(&b.0.t));
                bound = best.map_or(bound, |(hit, _)| hit.t);
            }
        }
    }
    best.map(|(intersection, object)| Hit {
        object,
        intersection,
    })
}
