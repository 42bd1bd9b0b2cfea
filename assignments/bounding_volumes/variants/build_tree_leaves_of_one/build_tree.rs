use pinhole::{BoundingBox, Tree};

pub fn build_tree(boxes: &[BoundingBox]) -> Tree {
    let all: Vec<usize> = (0..boxes.len()).collect();
    split(boxes, &all)
}

fn split(boxes: &[BoundingBox], triangles: &[usize]) -> Tree {
    if let [triangle] = triangles {
        return Tree::Leaf(vec![*triangle]);
    }
    let mut axis = 0;
    let mut middle = 0.0;
    let mut longest = -1.0;
    for k in 0..3 {
        let mut low = f64::INFINITY;
        let mut high = f64::NEG_INFINITY;
        for &triangle in triangles {
            let center = (boxes[triangle].min[k] + boxes[triangle].max[k]) / 2.0;
            low = low.min(center);
            high = high.max(center);
        }
        if high - low > longest {
            longest = high - low;
            axis = k;
            middle = low + (high - low) / 2.0;
        }
    }
    let mut left = Vec::new();
    let mut right = Vec::new();
    for &triangle in triangles {
        let center = (boxes[triangle].min[axis] + boxes[triangle].max[axis]) / 2.0;
        if center > middle {
            right.push(triangle);
        } else {
            left.push(triangle);
        }
    }
    if left.is_empty() || right.is_empty() {
        let (a, b) = triangles.split_at(triangles.len() / 2);
        left = a.to_vec();
        right = b.to_vec();
    }
    Tree::Branch(Box::new([split(boxes, &left), split(boxes, &right)]))
}
