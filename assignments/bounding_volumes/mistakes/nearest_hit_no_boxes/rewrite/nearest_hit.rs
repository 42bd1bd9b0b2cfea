use pinhole::{Hit, Node, RayTree};

pub fn nearest_hit(tree: &dyn RayTree, min_t: f64) -> Option<Hit> {
    let mut objects = all_triangles(tree);
    objects.sort_unstable();
    let hits = objects.into_iter().filter_map(|object| {
        let intersection = tree.intersect_triangle(object, min_t)?;
        Some(Hit {
            object,
            intersection,
        })
    });
    hits.min_by(|a, b| a.intersection.t.total_cmp(&b.intersection.t))
}

fn all_triangles(tree: &dyn RayTree) -> Vec<usize> {
    let (mut nodes, mut place) = (vec![0], 0);
    let mut objects = Vec::new();
    while place < nodes.len() {
        match tree.node(nodes[place]) {
            Node::Branch(children) => nodes.extend(children),
            Node::Leaf(triangles) => objects.extend_from_slice(triangles),
        }
        place += 1;
    }
    objects
}
