use pinhole::{Hit, Intersection, Node, RayTree};

pub fn nearest_hit(tree: &dyn RayTree, min_t: f64) -> Option<Hit> {
    let mut best: (usize, Option<Intersection>) = (0, None);
    let mut stack = Vec::from_iter(tree.enter_box(0, min_t, f64::MAX).map(|t| (0, t)));
    while let Some((node, t)) = stack.pop() {
        let bound = best.1.map_or(f64::MAX, |hit| hit.t);
        if bound < t {
            continue;
        }
        match tree.node(node) {
            Node::Leaf(members) => {
                let hits = members
                    .iter()
                    .map(|&it| (it, tree.intersect_triangle(it, min_t)));
                best = hits.filter(|hit| hit.1.is_some()).last().unwrap_or(best);
            }
            Node::Branch([a, b]) => {
                let enter = |child| (child, tree.enter_box(child, min_t, bound));
                match [enter(a), enter(b)] {
                    [(_, Some(x)), (_, Some(y))] if x <= y => stack.extend([(b, y), (a, x)]),
                    both => stack.extend(both.into_iter().filter_map(|(it, t)| Some((it, t?)))),
                }
            }
        }
    }
    let (object, intersection) = best;
    intersection.map(|intersection| Hit {
        object,
        intersection,
    })
}
