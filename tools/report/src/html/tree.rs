//! Drawings of the expected tree and the student's, side by side: the boxes of their upper nodes
//! over those of the primitives.

use pinhole::tree::DEEPEST_DRAWN;
use pinhole::{BoundingBox, NodeBox};
use serde::Serialize;

/// Two trees over the same primitives, as paths of SVG.
#[derive(Debug, Serialize)]
pub struct TreeDrawings {
    /// The size of both drawings.
    pub width: u32,
    pub height: u32,
    /// The axis along which we look, which is the one with the least extent.
    pub along: &'static str,
    /// Whether the two visible axes have different scales.
    pub stretched: bool,
    /// The depth of the deepest nodes that are drawn.
    pub deepest: usize,
    /// The boxes of the primitives.
    pub primitives: Vec<String>,
    /// The boxes of a correct tree, from the root down, each with its depth.
    pub expected: Vec<(usize, String)>,
    /// The boxes of the student's tree.
    pub yours: Vec<(usize, String)>,
}

/// The width of a drawing.
const WIDTH: f64 = 300.0;

/// The least and the greatest height, as shares of the width.
const HEIGHTS: [f64; 2] = [0.3, 1.0];

impl TreeDrawings {
    /// Draws two trees over the same primitives; `None` if there are no primitives.
    pub fn beside(
        primitives: &[BoundingBox],
        expected: &[NodeBox],
        yours: &[NodeBox],
    ) -> Option<TreeDrawings> {
        let view = View::of(primitives)?;
        let draw = |boxes: &[NodeBox]| {
            let mut boxes = boxes.to_vec();
            // The nodes come in no order of depth. Draw the deeper, thinner ones last.
            boxes.sort_by_key(|node| node.depth);
            let path = |node: &NodeBox| (node.depth, view.path(&node.bounds));
            boxes.iter().map(path).collect()
        };
        Some(TreeDrawings {
            width: WIDTH as u32,
            height: view.height as u32,
            along: ["x", "y", "z"][view.along],
            stretched: view.stretched,
            deepest: DEEPEST_DRAWN,
            primitives: primitives.iter().map(|bounds| view.path(bounds)).collect(),
            expected: draw(expected),
            yours: draw(yours),
        })
    }
}

/// How boxes are seen along an axis.
struct View {
    /// The box around everything.
    whole: BoundingBox,
    along: usize,
    /// The axes to the right and upwards.
    axes: [usize; 2],
    height: f64,
    stretched: bool,
}

impl View {
    fn of(boxes: &[BoundingBox]) -> Option<View> {
        let whole = boxes.iter().copied().reduce(|a, b| BoundingBox {
            min: a.min.min(b.min),
            max: a.max.max(b.max),
        })?;
        let size = whole.max - whole.min;
        let along = size.min_position();
        let mut axes = [0, 1, 2].into_iter().filter(|axis| *axis != along);
        let axes = [axes.next()?, axes.next()?];
        let ratio = size[axes[1]] / size[axes[0]];
        let shown = match ratio.is_finite() {
            true => ratio.clamp(HEIGHTS[0], HEIGHTS[1]),
            false => HEIGHTS[1],
        };
        Some(View {
            whole,
            along,
            axes,
            height: (shown * WIDTH).round(),
            stretched: shown != ratio,
        })
    }

    /// The outline of a box. A flat one is a line, and is drawn too.
    fn path(&self, bounds: &BoundingBox) -> String {
        let [right, up] = self.axes;
        let place = |value: f64, axis: usize, length: f64| {
            let (from, to) = (self.whole.min[axis], self.whole.max[axis]);
            match to > from {
                true => (value - from) / (to - from) * length,
                false => 0.5 * length,
            }
        };
        let x = [bounds.min, bounds.max].map(|corner| place(corner[right], right, WIDTH));
        let y = [bounds.min, bounds.max].map(|corner| place(corner[up], up, self.height));
        let [low, high] = y.map(|y| self.height - y);
        format!("M{:.1} {low:.1}H{:.1}V{high:.1}H{:.1}Z", x[0], x[1], x[0])
    }
}

#[cfg(test)]
mod tests {
    use glam::{DVec3, dvec3};

    use super::*;

    fn bounds(min: DVec3, max: DVec3) -> BoundingBox {
        BoundingBox { min, max }
    }

    #[test]
    fn boxes_are_seen_along_the_shortest_axis_and_the_last_axis_points_up() {
        let whole = bounds(dvec3(0.0, 1.0, 0.0), dvec3(4.0, 2.0, 2.0));
        let low = bounds(dvec3(0.0, 1.0, 0.0), dvec3(1.0, 2.0, 0.5));
        let root = NodeBox {
            depth: 0,
            bounds: whole,
        };
        let child = NodeBox {
            depth: 1,
            bounds: low,
        };
        let drawn = TreeDrawings::beside(&[whole, low], &[root], &[child, root]);
        let drawn = drawn.expect("there are primitives");
        assert_eq!((drawn.along, drawn.stretched), ("y", false));
        assert_eq!((drawn.width, drawn.height), (300, 150));
        let around = "M0.0 150.0H300.0V0.0H0.0Z".to_owned();
        let corner = "M0.0 150.0H75.0V112.5H0.0Z".to_owned();
        assert_eq!(drawn.primitives, [around.clone(), corner.clone()]);
        assert_eq!(drawn.expected, [(0, around.clone())]);
        assert_eq!(drawn.yours, [(0, around), (1, corner)]);
    }

    #[test]
    fn long_and_flat_boxes_stay_visible() {
        let long = bounds(DVec3::ZERO, dvec3(100.0, 1.0, 0.0));
        let drawn = TreeDrawings::beside(&[long], &[], &[]).expect("there is a primitive");
        assert_eq!((drawn.height, drawn.stretched), (90, true));
        let point = bounds(DVec3::ONE, DVec3::ONE);
        let drawn = TreeDrawings::beside(&[point], &[], &[]).expect("there is a primitive");
        assert_eq!(drawn.primitives, ["M150.0 150.0H150.0V150.0H150.0Z"]);
        assert!(TreeDrawings::beside(&[], &[], &[]).is_none());
    }
}
