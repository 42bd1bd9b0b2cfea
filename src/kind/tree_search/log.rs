//! Which steps of a search were needless.

use super::{SearchQuestion, Test, TestResult};
use crate::part::Tally;

/// What a search has tested so far, and which of its steps were needless.
#[derive(Clone, Debug, Default)]
pub(crate) struct SearchLog {
    /// The t of the nearest triangle that was found.
    nearest: Option<f64>,
    /// Whether each node's box was tested.
    tested: Vec<bool>,
    /// Whether anything in each node was tested.
    opened: Vec<bool>,
    /// Tests of boxes, and how many of them repeat an earlier one.
    tests: [usize; 2],
    /// Boxes that were opened, and how many of them the ray misses or enters too late.
    boxes: [usize; 3],
    /// Choices between two boxes, and how many of them were for the one that is entered later.
    choices: [usize; 2],
}

impl SearchLog {
    /// Notes a test and its result.
    pub(crate) fn note(&mut self, question: &SearchQuestion, test: Test, result: TestResult) {
        let nodes = question.tree.0.len();
        self.tested.resize(nodes, false);
        self.opened.resize(nodes, false);
        match test {
            Test::Box { node, .. } => {
                let again = std::mem::replace(&mut self.tested[node], true);
                self.tests[0] += 1;
                self.tests[1] += usize::from(again);
                if let Some(parent) = question.above(node) {
                    self.open(question, parent.node);
                }
            }
            Test::Triangle { triangle, .. } => {
                if let Some(leaf) = question.leaf_of(triangle) {
                    self.open(question, leaf);
                }
            }
        }
        if let TestResult::Triangle(Some(found)) = result {
            let nearest = self.nearest.map_or(found.t, |t| t.min(found.t));
            self.nearest = Some(nearest);
        }
    }

    /// Notes that something in a node is tested.
    fn open(&mut self, question: &SearchQuestion, node: usize) {
        if std::mem::replace(&mut self.opened[node], true) {
            return;
        }
        let entry = question.entry(node);
        let is_late = |entry: f64| self.nearest.is_some_and(|nearest| entry > nearest);
        self.boxes[0] += 1;
        self.boxes[1] += usize::from(entry.is_none());
        self.boxes[2] += usize::from(entry.is_some_and(is_late));
        let Some(above) = question.above(node) else {
            return;
        };
        if let Some((own, beside)) = entry.zip(question.entry(above.beside))
            && own != beside
            && !self.opened[above.beside]
        {
            self.choices[0] += 1;
            self.choices[1] += usize::from(own > beside);
        }
    }

    /// What was noted.
    pub(crate) fn tallies(&self) -> Vec<Tally> {
        let tally = |steps, sort, all, some| Tally {
            steps,
            sort,
            explains: None,
            some,
            all,
        };
        let [boxes, missed, late] = self.boxes;
        let looked = "boxes that you look into";
        vec![
            tally(
                "choices between two boxes that the ray enters",
                "pick the one that it enters later",
                self.choices[0],
                self.choices[1],
            ),
            tally(looked, "are not met at min_t or beyond", boxes, missed),
            tally(
                looked,
                "begin behind a triangle that you have already found",
                boxes,
                late,
            ),
            tally(
                "tests of boxes",
                "repeat an earlier one",
                self.tests[0],
                self.tests[1],
            ),
        ]
    }
}
