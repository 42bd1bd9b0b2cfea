use pinhole::{BoundingBox, Tree};

/// The plane through the middle of the mesh that cuts its longest axis.
struct Plane {
    axis: usize,
    place: f64,
}

impl Plane {
    fn new(boxes: &[BoundingBox]) -> Plane {
        let ends = |axis: usize| {
            let along = boxes.iter().map(|bounds| bounds.center()[axis]);
            let least = along.clone().fold(f64::INFINITY, f64::min);
            (least, along.fold(f64::NEG_INFINITY, f64::max))
        };
        let size = |axis: usize| ends(axis).1 - ends(axis).0;
        let axis = (1..3).fold(0, |a, b| if size(b) > size(a) { b } else { a });
        let (least, most) = ends(axis);
        Plane {
            axis,
            place: (least + most) / 2.0,
        }
    }
}

pub fn build_tree(boxes: &[BoundingBox]) -> Tree {
    let plane = Plane::new(boxes);
    let below = |it: &usize| boxes[*it].center()[plane.axis] < plane.place;
    let (left, right): (Vec<usize>, Vec<usize>) = (0..boxes.len()).partition(below);
    let whole = [left.clone(), right.clone()].concat();
    match boxes.len() > 4 && !left.is_empty() && !right.is_empty() {
        // Within one side, the plane no longer separates anything.
        true => Tree::Branch(Box::new([halves(&left), halves(&right)])),
        false => halves(&whole),
    }
}

fn halves(part: &[usize]) -> Tree {
    if part.len() < 5 {
        return Tree::Leaf(part.to_vec());
    }
    let (a, b) = part.split_at(part.len() / 2);
    Tree::Branch(Box::new([halves(a), halves(b)]))
}
