use pinhole::{Hit, Node, RayTree};

pub fn nearest_hit(tree: &dyn RayTree, min_t: f64) -> Option<Hit> {
    let mut best: Option<Hit> = None;
    let mut bound = f64::INFINITY;
    let mut stack = vec![(0, tree.enter_box(0, min_t, bound)?)];
    while let Some((node, entry)) = stack.pop() {
        if entry > bound {
            continue;
        }
        match tree.node(node) {
            Node::Branch([a, b]) => {
                let ahead = |child| match tree.enter_box(child, min_t, bound) {
                    // Not ahead of us.
                    Some(t) if t <= min_t => f64::INFINITY,
                    Some(t) => t,
                    None => f64::INFINITY,
                };
                let mut both = [(a, ahead(a)), (b, ahead(b))];
                if both[0].1 <= both[1].1 {
                    both.swap(0, 1);
                }
                stack.extend(both.iter().filter(|it| it.1 < f64::INFINITY));
            }
            Node::Leaf(members) => {
                let hits = members.iter().filter_map(|&object| {
                    let intersection = tree.intersect_triangle(object, min_t)?;
                    Some(Hit {
                        object,
                        intersection,
                    })
                });
                let all = hits.chain(best);
                best = all.min_by(|x, y| x.intersection.t.total_cmp(&y.intersection.t));
                bound = best.map_or(bound, |hit| hit.intersection.t);
            }
        }
    }
    best
}
