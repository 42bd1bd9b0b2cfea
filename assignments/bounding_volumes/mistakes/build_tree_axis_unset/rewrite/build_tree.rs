use pinhole::{BoundingBox, Tree};

/// How far some centres reach in x, y and z.
#[derive(Clone, Copy, Default)]
struct Extent {
    low: [f64; 3],
    high: [f64; 3],
}

impl Extent {
    fn longest(&self) -> usize {
        let size = |k: usize| self.high[k] - self.low[k];
        (0..3).fold(0, |best, k| if size(k) >= size(best) { k } else { best })
    }

    fn around(mut self, boxes: &[BoundingBox], part: &[usize]) -> Extent {
        self.low = boxes[part[0]].center().to_array();
        self.high = self.low;
        for &it in part {
            for k in 0..3 {
                self.low[k] = self.low[k].min(boxes[it].center()[k]);
                self.high[k] = self.high[k].max(boxes[it].center()[k]);
            }
        }
        self
    }
}

pub fn build_tree(boxes: &[BoundingBox]) -> Tree {
    let mut order: Vec<usize> = (0..boxes.len()).collect();
    subtree(boxes, &mut order)
}

fn subtree(boxes: &[BoundingBox], part: &mut [usize]) -> Tree {
    if part.len() < 5 {
        return Tree::Leaf(part.to_vec());
    }
    let extent = Extent::default();
    let grown = extent.around(boxes, part);
    let axis = extent.longest();
    let along = |it: usize| boxes[it].center()[axis];
    part.sort_by(|&a, &b| along(a).total_cmp(&along(b)));
    let split = (grown.low[axis] + grown.high[axis]) / 2.0;
    let mut place = part.partition_point(|&it| along(it) < split);
    if place == 0 || place == part.len() {
        place = part.len() / 2;
    }
    let (a, b) = part.split_at_mut(place);
    Tree::Branch(Box::new([subtree(boxes, a), subtree(boxes, b)]))
}
