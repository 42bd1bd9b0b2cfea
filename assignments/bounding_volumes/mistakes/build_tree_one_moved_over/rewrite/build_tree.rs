use pinhole::{BoundingBox, Tree};

pub fn build_tree(boxes: &[BoundingBox]) -> Tree {
    let centers = boxes.iter().map(BoundingBox::center).enumerate();
    let mut all: Vec<(usize, [f64; 3])> = centers.map(|(i, c)| (i, c.to_array())).collect();
    subtree(&mut all)
}

fn subtree(part: &mut [(usize, [f64; 3])]) -> Tree {
    if part.len() <= 4 {
        return Tree::Leaf(part.iter().map(|it| it.0).collect());
    }
    let mut longest = (0, -1.0, 0.0);
    for k in 0..3 {
        let least = part.iter().map(|it| it.1[k]).fold(f64::MAX, f64::min);
        let most = part.iter().map(|it| it.1[k]).fold(f64::MIN, f64::max);
        if most - least > longest.1 {
            longest = (k, most - least, (least + most) / 2.0);
        }
    }
    let (k, _, split) = longest;
    part.sort_by(|a, b| a.1[k].total_cmp(&b.1[k]));
    let below = part.iter().filter(|it| it.1[k] < split).count();
    // Each side gets at least one.
    let (a, b) = part.split_at_mut(below.clamp(1, part.len() - 1));
    Tree::Branch(Box::new([subtree(a), subtree(b)]))
}
