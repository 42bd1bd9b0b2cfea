use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

use super::{Answer, AnswerFn, Kind, Question, Unregistered, WireAnswer};
use crate::bounds::BoundingBox;
use crate::fact::Fact;
use crate::film::Samples;
use crate::part::{Condition, Part, Quantity, Tally};
use crate::tree::{Cut, FlatTree, NodeBox, TreeMeasures};
use crate::words::number;

/// Which tree holds triangles with these boxes?
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct TreeQuestion {
    /// The box of each triangle, in the mesh's order; at least one.
    pub boxes: Vec<BoundingBox>,
    /// One of the right trees, for pictures. It stays with the asker.
    #[serde(skip)]
    pub example: FlatTree,
}

/// A pixel of a question film can hold at most this many boxes.
const MOST_BOXES: usize = 64;

/// What the expected number of tests is called.
const TESTS: &str = "the expected number of tests";

/// How many lines of a long list of boxes are shown. The report draws all boxes.
const MOST_SHOWN: usize = 6;

/// An answer has at most this many nodes and places in leaves, ten times what it needs.
const MOST_PLACES: usize = 32 * MOST_BOXES;

impl TreeQuestion {
    pub(super) fn read(samples: Samples<'_>) -> Result<TreeQuestion, String> {
        let count = samples.count("count")?;
        if !(1..=MOST_BOXES).contains(&count) {
            return Err(format!(
                "channel `count` holds {count}, but it must be from 1 to {MOST_BOXES}"
            ));
        }
        let boxes = (0..count).map(|k| samples.bounding_box(&k.to_string()));
        Ok(TreeQuestion {
            boxes: boxes.collect::<Result<_, String>>()?,
            example: example(samples, count)?,
        })
    }

    /// The boxes of a tree's upper nodes, for pictures.
    pub fn outline(&self, tree: &FlatTree) -> Vec<NodeBox> {
        super::refuse_in_submission();
        tree.outline(&self.boxes)
    }

    /// How the branches of a tree divide its triangles.
    pub(crate) fn tallies(&self, tree: &FlatTree) -> Vec<Tally> {
        let cuts = tree.cuts(&self.boxes);
        let sorts = [
            (
                Cut::OtherAxis,
                "divide the triangles along an axis other than the one along which their centres \
                 spread most",
            ),
            (
                Cut::Mixed,
                "have children whose triangles' centres aren't separated along any axis",
            ),
            (
                Cut::OffMiddle,
                "divide the triangles along the right axis, but not halfway between the \
                 least and the greatest centre",
            ),
        ];
        let tally = |(cut, sort)| Tally {
            steps: "branches of your trees",
            sort,
            explains: Some(TESTS),
            some: cuts.iter().filter(|it| **it == cut).count(),
            all: cuts.len(),
        };
        sorts.map(tally).to_vec()
    }
}

/// A tree over this many triangles. For each of them, the film says which leaf it is in and how
/// deep that leaf is.
fn example(samples: Samples<'_>, count: usize) -> Result<FlatTree, String> {
    let mut leaves: BTreeMap<usize, (usize, Vec<usize>)> = BTreeMap::new();
    for k in 0..count {
        let depth = samples.count(&format!("{k}.depth"))?;
        let leaf = leaves.entry(samples.count(&format!("{k}.leaf"))?);
        leaf.or_insert((depth, Vec::new())).1.push(k);
    }
    FlatTree::of_leaves(leaves.into_values().collect())
        .ok_or_else(|| "its leaves don't form a tree".into())
}

impl Question for TreeQuestion {
    fn answer(&self, _: usize, functions: &[AnswerFn]) -> Result<WireAnswer, Unregistered> {
        let build = AnswerFn::find(functions, Kind::Tree, |function| match function {
            AnswerFn::Tree(build) => Some(*build),
            _ => None,
        })?;
        let tree = FlatTree::from(build(&self.boxes));
        assert!(
            tree.size() <= MOST_PLACES,
            "{} nodes and leaf entries are too many for a tree over {} triangles",
            tree.size(),
            self.boxes.len()
        );
        Ok(WireAnswer::Tree(tree))
    }

    fn receive(&self, sent: &WireAnswer) -> Option<Answer> {
        match sent {
            // Describing a tree of thousands of nodes takes us seconds.
            WireAnswer::Tree(tree) if tree.size() <= MOST_PLACES && tree.is_tree() => {
                Some(Answer::Tree(tree.measure(&self.boxes)))
            }
            _ => None,
        }
    }

    fn describe(&self, _: &str, digits: usize) -> Vec<Fact> {
        let all = self.boxes.iter().enumerate();
        let mut lines: Vec<String> = all
            .map(|(index, bounds)| format!("{index}: {}", bounds.words(digits)))
            .collect();
        if lines.len() > MOST_SHOWN {
            let more = lines.split_off(MOST_SHOWN - 1).len();
            lines.push(format!("and {more} more"));
        }
        vec![Fact::new("boxes", lines.join("\n"))]
    }

    fn parts(&self, answer: &Answer) -> Option<Vec<Part>> {
        let Answer::Tree(measures) = answer else {
            return None;
        };
        Some(measures.parts())
    }

    fn quantities(&self, _: &Answer) -> Vec<Quantity> {
        vec![Quantity::count("the number of triangles", self.boxes.len())]
    }

    fn conditions(&self, _: &Answer) -> Vec<Condition> {
        let first = self.boxes[0].center();
        let equal = self.boxes.iter().all(|bounds| bounds.center() == first);
        vec![
            Condition::new(
                "there is one triangle",
                "there are several triangles",
                self.boxes.len() == 1,
            ),
            Condition::new(
                "all boxes have the same centre",
                "the boxes have different centres",
                equal && self.boxes.len() > 1,
            ),
        ]
    }

    fn others(&self, _: &Answer) -> Vec<(&'static str, Answer)> {
        Vec::new()
    }
}

impl TreeMeasures {
    /// "a tree with depth 5, at most 4 triangles in a leaf, and an expected 12.3 tests per ray".
    ///
    /// A golden's own measures are all 0, which no tree has.
    pub(super) fn words(&self, digits: usize) -> String {
        let TreeMeasures {
            misplaced,
            depth,
            largest_leaf,
            cost,
        } = *self;
        if largest_leaf == 0 && misplaced == 0 {
            return "a tree that has each triangle in exactly one leaf and exceeds no limit".into();
        }
        let triangles = match largest_leaf {
            1 => "triangle",
            _ => "triangles",
        };
        let shape = format!("depth {depth}, at most {largest_leaf} {triangles} in a leaf");
        match misplaced {
            0 => format!(
                "a tree with {shape}, and an expected {} tests per ray",
                number(cost, digits)
            ),
            1 => format!("a tree with {shape}, and 1 triangle missing, repeated or unknown"),
            some => {
                format!("a tree with {shape}, and {some} triangles missing, repeated or unknown")
            }
        }
    }

    /// What can be right or wrong in a tree. A tree with misplaced triangles has no expected number
    /// of tests.
    fn parts(&self) -> Vec<Part> {
        let part = |name, value, channels| Part {
            name,
            values: vec![value],
            axes: &[],
            unit: "",
            channels,
            scale: 1.0,
            is_limit: true,
        };
        let mut parts = vec![
            part(
                "the number of missing, repeated or unknown triangles",
                self.misplaced as f64,
                &["misplaced"],
            ),
            part("the depth", self.depth as f64, &["depth"]),
            part("the largest leaf", self.largest_leaf as f64, &["leaf"]),
        ];
        if self.misplaced == 0 {
            parts.push(part(TESTS, self.cost, &["cost"]));
        }
        parts
    }
}
