use pinhole::{BoundingBox, Tree};

pub fn build_tree(boxes: &[BoundingBox]) -> Tree {
    // Bottom up: lists that wait to be split, and what is done with the finished trees.
    enum Step {
        Split(Vec<usize>),
        Join,
    }
    let mut steps = vec![Step::Split((0..boxes.len()).collect())];
    let mut done: Vec<Tree> = Vec::new();
    while let Some(step) = steps.pop() {
        match step {
            Step::Split(list) if list.len() <= 8 => done.push(Tree::Leaf(list)),
            Step::Split(list) => {
                let (left, right) = sides(boxes, list);
                steps.extend([Step::Join, Step::Split(left), Step::Split(right)]);
            }
            Step::Join => {
                if let (Some(left), Some(right)) = (done.pop(), done.pop()) {
                    done.push(Tree::Branch(Box::new([left, right])));
                }
            }
        }
    }
    done.remove(0)
}

fn sides(boxes: &[BoundingBox], mut list: Vec<usize>) -> (Vec<usize>, Vec<usize>) {
    let centers = || list.iter().map(|&it| boxes[it].center());
    let first = boxes[list[0]].center();
    let low = centers().fold(first, |a, b| a.min(b));
    let high = centers().fold(first, |a, b| a.max(b));
    let axis = (high - low).max_position();
    let twice = low[axis] + high[axis];
    let is_left = |it: &usize| boxes[*it].min[axis] + boxes[*it].max[axis] < twice;
    let (left, right): (Vec<usize>, Vec<usize>) = list.iter().partition(|it| is_left(it));
    if left.is_empty() || right.is_empty() {
        let rest = list.split_off(list.len() / 2);
        return (list, rest);
    }
    (left, right)
}
