use pinhole::{Hit, Intersection, Node, RayTree};

struct Search<'a> {
    tree: &'a dyn RayTree,
    min_t: f64,
    max_t: f64,
    found: Option<(usize, Intersection)>,
}

impl Search<'_> {
    fn enter(&self, node: usize) -> f64 {
        let entry = self.tree.enter_box(node, self.min_t, self.max_t);
        // A box that is missed is entered infinitely far away.
        entry.unwrap_or(f64::INFINITY)
    }

    fn visit(&mut self, node: usize) {
        match self.tree.node(node) {
            Node::Leaf(triangles) => triangles.iter().for_each(|&it| self.test(it)),
            Node::Branch(children) => {
                let entries = children.map(|child| self.enter(child));
                let near = usize::from(entries[1] < entries[0]);
                for k in [near, 1 - near] {
                    if entries[k] == f64::INFINITY || entries[k] > self.max_t {
                        return;
                    }
                    self.visit(children[k]);
                }
            }
        }
    }

    fn test(&mut self, triangle: usize) {
        let Some(hit) = self.tree.intersect_triangle(triangle, self.min_t) else {
            return;
        };
        if hit.t >= self.max_t {
            return;
        }
        self.max_t = hit.t;
        self.found = Some((triangle, hit));
    }
}

pub fn nearest_hit(tree: &dyn RayTree, min_t: f64) -> Option<Hit> {
    let mut search = Search {
        tree,
        min_t,
        max_t: f64::INFINITY,
        found: None,
    };
    if search.enter(0) < f64::INFINITY {
        search.visit(0);
    }
    let (object, intersection) = search.found?;
    Some(Hit {
        object,
        intersection,
    })
}
