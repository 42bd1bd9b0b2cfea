use pinhole::{Hit, Intersection, Node, RayTree};

struct Search<'a> {
    tree: &'a dyn RayTree,
    min_t: f64,
    best: Option<(usize, Intersection)>,
}

impl Search<'_> {
    fn bound(&self) -> f64 {
        self.best.map_or(f64::INFINITY, |(_, hit)| hit.t)
    }

    fn enter(&self, node: usize) -> f64 {
        let entry = self.tree.enter_box(node, self.min_t, self.bound());
        entry.unwrap_or(f64::INFINITY)
    }

    fn visit(&mut self, node: usize, entry: f64) {
        if entry == f64::INFINITY || entry > self.bound() {
            return;
        }
        match self.tree.node(node) {
            Node::Branch([a, b]) => {
                let (ta, tb) = (self.enter(a), self.enter(b));
                let order = match ta < tb {
                    true => [(a, ta), (b, tb)],
                    false => [(b, tb), (a, ta)],
                };
                for (child, t) in order {
                    self.visit(child, t);
                }
            }
            Node::Leaf(members) => {
                let all = members.iter();
                // The boxes before min_t are left out already.
                let hits = all.filter_map(|&it| Some((it, self.tree.intersect_triangle(it, 0.0)?)));
                let nearest = hits.min_by(|x, y| x.1.t.total_cmp(&y.1.t));
                if let Some(found) = nearest
                    && found.1.t < self.bound()
                {
                    self.best = Some(found);
                }
            }
        }
    }
}

pub fn nearest_hit(tree: &dyn RayTree, min_t: f64) -> Option<Hit> {
    let best = None;
    let mut search = Search { tree, min_t, best };
    let root = search.enter(0);
    search.visit(0, root);
    search.best.map(|(object, intersection)| Hit {
        object,
        intersection,
    })
}
