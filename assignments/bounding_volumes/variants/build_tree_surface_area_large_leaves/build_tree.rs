use pinhole::{BoundingBox, Tree};

pub fn build_tree(boxes: &[BoundingBox]) -> Tree {
    best(boxes, (0..boxes.len()).collect())
}

fn best(boxes: &[BoundingBox], triangles: Vec<usize>) -> Tree {
    let count = triangles.len();
    if count <= 8 {
        return Tree::Leaf(triangles);
    }
    // The order along the best axis, where to split it, and what that costs.
    let mut cheapest = (triangles.clone(), count / 2, f64::INFINITY);
    for axis in 0..3 {
        let mut order = triangles.clone();
        order.sort_by(|&a, &b| boxes[a].center()[axis].total_cmp(&boxes[b].center()[axis]));
        let left = half_areas(boxes, order.iter());
        let right = half_areas(boxes, order.iter().rev());
        for first in 1..count {
            let cost =
                left[first - 1] * first as f64 + right[count - first - 1] * (count - first) as f64;
            if cost < cheapest.2 {
                cheapest = (order.clone(), first, cost);
            }
        }
    }
    let (mut order, first, _) = cheapest;
    let rest = order.split_off(first);
    Tree::Branch(Box::new([best(boxes, order), best(boxes, rest)]))
}

/// Half of the surface of the box around the first, the first two, and so on.
fn half_areas<'a>(boxes: &[BoundingBox], order: impl Iterator<Item = &'a usize>) -> Vec<f64> {
    let mut around: Option<BoundingBox> = None;
    let area = order.map(|&triangle| {
        let old = around.unwrap_or(boxes[triangle]);
        let min = old.min.min(boxes[triangle].min);
        let max = old.max.max(boxes[triangle].max);
        around = Some(BoundingBox { min, max });
        let size = max - min;
        size.x * size.y + size.y * size.z + size.z * size.x
    });
    area.collect()
}
