use pinhole::{Hit, Node, RayTree};

/// A segment of the ray, which begins at min_t and ends at the end of its direction.
struct Segment<'a> {
    tree: &'a dyn RayTree,
    from: f64,
    to: f64,
    found: Option<Hit>,
}

pub fn nearest_hit(tree: &dyn RayTree, min_t: f64) -> Option<Hit> {
    let mut segment = Segment {
        tree,
        from: min_t,
        to: 1.0,
        found: None,
    };
    let entry = segment.enter(0)?;
    segment.visit(0, entry);
    segment.found
}

impl Segment<'_> {
    fn enter(&self, node: usize) -> Option<f64> {
        self.tree.enter_box(node, self.from, self.to)
    }

    fn visit(&mut self, node: usize, entry: f64) {
        if entry > self.to {
            return;
        }
        match self.tree.node(node) {
            Node::Leaf(members) => members.iter().for_each(|&it| self.test(it)),
            Node::Branch([a, b]) => match (self.enter(a), self.enter(b)) {
                (Some(x), Some(y)) if x < y => {
                    self.visit(a, x);
                    self.visit(b, y);
                }
                (x, y) => {
                    y.into_iter().for_each(|y| self.visit(b, y));
                    x.into_iter().for_each(|x| self.visit(a, x));
                }
            },
        }
    }

    fn test(&mut self, object: usize) {
        let hit = self.tree.intersect_triangle(object, self.from);
        if let Some(intersection) = hit.filter(|hit| hit.t < self.to) {
            self.to = intersection.t;
            self.found = Some(Hit {
                object,
                intersection,
            });
        }
    }
}
