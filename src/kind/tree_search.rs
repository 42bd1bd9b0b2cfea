mod log;

use std::ops::RangeInclusive;
use std::sync::OnceLock;

use serde::{Deserialize, Serialize};

use super::{Answer, AnswerFn, Kind, Question, Unregistered, WireAnswer};
use crate::fact::Fact;
use crate::film::Samples;
use crate::part::{Condition, Quantity};
use crate::ray::{Hit, Intersection};
use crate::tree::{FlatNode, FlatTree, Node, RayTree};
use crate::words::{self, number};
pub(crate) use log::SearchLog;

/// Which triangle of a tree does a ray meet first, from `min_t` on?
///
/// The asker knows what the ray meets; the submission doesn't. The submission asks for one test
/// after another, and the asker's process answers and counts them.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct SearchQuestion {
    /// The tree; its leaves name triangles.
    pub tree: FlatTree,
    /// In multiples of the ray's direction.
    pub min_t: f64,
    /// What the tests answer. It stays with the asker.
    #[serde(skip)]
    pub results: TestResults,
}

/// What the ray meets.
#[derive(Clone, Debug, Default)]
pub struct TestResults {
    /// For each node, the t at which the ray enters and leaves its box, if it meets it.
    pub boxes: Vec<Option<RangeInclusive<f64>>>,
    /// The triangles that the ray meets, each once.
    pub triangles: Vec<Hit>,
}

/// What a search may ask.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub enum Test {
    /// Where the ray enters a node's box, from `min_t` to `max_t`.
    Box {
        /// The node's place in the tree.
        node: usize,
        /// In multiples of the ray's direction.
        min_t: f64,
        /// In the same unit.
        max_t: f64,
    },
    /// Where the ray meets a triangle, from `min_t` on.
    Triangle {
        /// As a leaf names it.
        triangle: usize,
        /// In multiples of the ray's direction.
        min_t: f64,
    },
}

/// The result of one test.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub enum TestResult {
    /// Of a box.
    Box(Option<f64>),
    /// Of a triangle.
    Triangle(Option<Intersection>),
}

/// A description lists at most this many nodes.
const MOST_DESCRIBED: usize = 10;

impl SearchQuestion {
    pub(super) fn read(samples: Samples<'_>) -> Result<SearchQuestion, String> {
        let (mut nodes, mut boxes) = (Vec::new(), Vec::new());
        for k in 0..samples.count("nodes")? {
            let second = samples.count(&format!("{k}.second"))?;
            let size = samples.count(&format!("{k}.size"))?;
            let first = samples.count(&format!("{k}.first"))?;
            nodes.push(match second {
                0 => FlatNode::Leaf((first..first + size).collect()),
                _ => FlatNode::Branch([k + 1, second]),
            });
            let near = samples.number(&format!("{k}.near"))?;
            let far = samples.number(&format!("{k}.far"))?;
            boxes.push((near <= far).then_some(near..=far));
        }
        let tree = FlatTree(nodes);
        if !tree.is_tree() {
            return Err("its nodes don't form a tree".into());
        }
        let hit = |k| {
            Ok(Hit {
                object: samples.count(&format!("hit.{k}.triangle"))?,
                intersection: Intersection {
                    t: samples.number(&format!("hit.{k}.t"))?,
                    normal: samples.vector(&format!("hit.{k}.N"))?,
                },
            })
        };
        let triangles = (0..samples.count("hits")?).map(hit);
        Ok(SearchQuestion {
            tree,
            min_t: samples.min_t()?,
            results: TestResults {
                boxes,
                triangles: triangles.collect::<Result<_, String>>()?,
            },
        })
    }

    /// The result of a test, or `None` if it is about something that is not in the tree.
    pub(crate) fn test(&self, test: Test) -> Option<TestResult> {
        match test {
            Test::Box { node, min_t, max_t } => {
                let inside = self.results.boxes.get(node)?.as_ref();
                let t = inside.map(|inside| (inside.start().max(min_t), inside.end().min(max_t)));
                let entered = t.filter(|(enter, leave)| enter <= leave);
                Some(TestResult::Box(entered.map(|(enter, _)| enter)))
            }
            Test::Triangle { triangle, min_t } => self.leaf_of(triangle).map(|_| {
                let met = self.results.triangles.iter();
                let met = met.filter(|hit| hit.object == triangle);
                let mut met = met.filter(|hit| hit.intersection.t >= min_t);
                TestResult::Triangle(met.next().map(|hit| hit.intersection))
            }),
        }
    }

    /// The t at which the ray enters a node's box, from `min_t` on.
    fn entry(&self, node: usize) -> Option<f64> {
        let inside = self.results.boxes.get(node)?.as_ref()?;
        let t = inside.start().max(self.min_t);
        (t <= *inside.end()).then_some(t)
    }

    /// The leaf that names a triangle.
    fn leaf_of(&self, triangle: usize) -> Option<usize> {
        let mut nodes = self.tree.0.iter();
        nodes.position(|node| match node {
            FlatNode::Leaf(members) => members.contains(&triangle),
            FlatNode::Branch(_) => false,
        })
    }

    /// The triangles of a leaf that the ray meets, in the leaf's order.
    fn met_in(&self, leaf: usize) -> impl Iterator<Item = &Hit> {
        let members = match &self.tree.0[leaf] {
            FlatNode::Leaf(members) => members.as_slice(),
            FlatNode::Branch(_) => &[],
        };
        members.iter().filter_map(|&member| {
            let mut met = self.results.triangles.iter();
            met.find(|hit| hit.object == member && hit.intersection.t >= self.min_t)
        })
    }

    /// The first leaf in which a search meets a triangle, if it always looks first into the box
    /// that the ray enters first.
    fn first_leaf(&self) -> Option<usize> {
        let mut waiting = vec![0];
        while let Some(node) = waiting.pop() {
            if self.entry(node).is_none() {
                continue;
            }
            if let FlatNode::Branch(mut children) = self.tree.0[node] {
                let entry = |node: &usize| self.entry(*node).unwrap_or(f64::INFINITY);
                children.sort_by(|a, b| entry(b).total_cmp(&entry(a)));
                waiting.extend(children);
            } else if self.met_in(node).next().is_some() {
                return Some(node);
            }
        }
        None
    }

    /// The branch above a node; the root has none.
    fn above(&self, node: usize) -> Option<Above> {
        let branches = self.tree.0.iter().enumerate();
        branches.into_iter().find_map(|(parent, it)| {
            let (beside, is_second) = match it {
                FlatNode::Branch([a, b]) if *a == node => (*b, false),
                FlatNode::Branch([a, b]) if *b == node => (*a, true),
                _ => return None,
            };
            Some(Above {
                node: parent,
                beside,
                is_second,
            })
        })
    }

    /// The nodes that lead to a triangle, its leaf first, each with what is above it. The root is
    /// left out.
    fn way_to(&self, triangle: usize) -> impl Iterator<Item = (usize, Above)> {
        let mut next = self.leaf_of(triangle);
        std::iter::from_fn(move || {
            let node = next?;
            let above = self.above(node)?;
            next = Some(above.node);
            Some((node, above))
        })
    }

    /// The limit on the tests of one search: ten times as many as there are boxes and triangles.
    pub(crate) fn most_tests(&self) -> usize {
        10 * self.tree.size()
    }
}

/// What is above a node.
struct Above {
    /// The branch whose child it is.
    node: usize,
    /// The other child.
    beside: usize,
    /// Whether it is the second child.
    is_second: bool,
}

impl Question for SearchQuestion {
    fn answer(&self, index: usize, functions: &[AnswerFn]) -> Result<WireAnswer, Unregistered> {
        let search = AnswerFn::find(functions, Kind::TreeSearch, |function| match function {
            AnswerFn::TreeSearch(search) => Some(*search),
            _ => None,
        })?;
        let tree = TestedTree {
            tree: &self.tree,
            index,
        };
        Ok(Answer::Hit(search(&tree, self.min_t)).into())
    }

    fn describe(&self, _: &str, digits: usize) -> Vec<Fact> {
        let nodes = self.tree.0.iter().zip(&self.results.boxes).enumerate();
        let node = |(index, (node, inside)): (usize, (&FlatNode, &Option<_>))| {
            let inside = inside
                .as_ref()
                .map_or(String::new(), |inside: &RangeInclusive<f64>| {
                    let [near, far] = [inside.start(), inside.end()].map(|t| number(*t, digits));
                    format!("t from {near} to {far}")
                });
            match node {
                FlatNode::Branch([a, b]) => format!("{index}: branch to {a} and {b}, {inside}"),
                FlatNode::Leaf(members) => format!("{index}: leaf of {members:?}, {inside}"),
            }
        };
        let met = |(_, (_, inside)): &(usize, (&FlatNode, &Option<_>))| inside.is_some();
        let mut nodes: Vec<String> = nodes.filter(met).map(node).collect();
        if nodes.len() > MOST_DESCRIBED {
            let more = nodes.split_off(MOST_DESCRIBED).len();
            nodes.push(format!("… and {more} more"));
        }
        let met = self.results.triangles.iter();
        let met = met.map(|hit| {
            let t = number(hit.intersection.t, digits);
            format!("{} at t = {t}", hit.object)
        });
        let met = met.collect::<Vec<_>>().join(", ");
        vec![
            Fact::new("min_t", number(self.min_t, digits)),
            Fact::new(
                "entered",
                if nodes.is_empty() {
                    "none".into()
                } else {
                    nodes.join("\n")
                },
            ),
            Fact::new("met", if met.is_empty() { "none".into() } else { met }),
        ]
    }

    fn describe_answer(&self, answer: &Answer, digits: usize) -> String {
        words::hit(answer.hit(), digits)
    }

    fn quantities(&self, right: &Answer) -> Vec<Quantity> {
        let entry = self.entry(0).unwrap_or(f64::NAN);
        let exit = |node: usize| {
            let inside = self.results.boxes.get(node)?.as_ref()?;
            Some(*inside.end())
        };
        let leaf = right.hit().and_then(|hit| self.leaf_of(hit.object));
        let [of_root, of_leaf] = [Some(0), leaf].map(|node| node.and_then(exit));
        vec![
            Quantity::new("min_t", self.min_t),
            Quantity::new("the t at which the ray enters the root's box", entry),
            Quantity::new(
                "the t at which the ray leaves the root's box",
                of_root.unwrap_or(f64::NAN),
            ),
            Quantity::new(
                "the t at which the ray leaves the leaf's box",
                of_leaf.unwrap_or(f64::NAN),
            ),
        ]
    }

    fn conditions(&self, answer: &Answer) -> Vec<Condition> {
        let t = answer.hit().map_or(f64::NAN, |hit| hit.intersection.t);
        let root = matches!(self.tree.0[0], FlatNode::Leaf(_));
        let boxes = self.results.boxes.first();
        let way = || {
            let hit = answer.hit().into_iter();
            hit.flat_map(|hit| self.way_to(hit.object))
        };
        let is_later = |(node, above): (usize, Above)| {
            let entries = self.entry(node).zip(self.entry(above.beside));
            entries.is_some_and(|(own, beside)| own > beside)
        };
        vec![
            Condition::new("t is below min_t", "t is min_t or more", t < self.min_t),
            Condition::new("t is below 1", "t is 1 or more", t < 1.0),
            Condition::new("the root is a leaf", "the root is a branch", root),
            Condition::new(
                "the ray misses the root's box",
                "the ray meets the root's box",
                boxes.is_none_or(Option::is_none),
            ),
            Condition::new(
                "the path to the triangle goes through a second child",
                "the path to the triangle goes only through first children",
                way().any(|(_, above)| above.is_second),
            ),
            Condition::new(
                "a box with the triangle is entered after its sibling",
                "each box with the triangle is entered before its sibling",
                way().any(is_later),
            ),
        ]
    }

    fn others(&self, right: &Answer) -> Vec<(&'static str, Answer)> {
        let met = &self.results.triangles;
        let by_t = |a: &&Hit, b: &&Hit| a.intersection.t.total_cmp(&b.intersection.t);
        let farthest = met.iter().max_by(by_t);
        let nearest = met.iter().min_by(by_t);
        let own_leaf = right.hit().and_then(|hit| self.leaf_of(hit.object));
        let met_in = |leaf: usize| self.met_in(leaf);
        let all = [
            ("that of the farthest triangle", farthest),
            ("that of the nearest triangle, whatever min_t is", nearest),
            (
                "that of the last triangle met in the leaf",
                own_leaf.and_then(|leaf| met_in(leaf).last()),
            ),
            (
                "that of the nearest triangle in the first leaf where the ray meets one",
                self.first_leaf().and_then(|leaf| met_in(leaf).min_by(by_t)),
            ),
        ];
        let answer = |(name, hit): (_, Option<&Hit>)| Some((name, Answer::Hit(Some(*hit?))));
        let of_leaf = right.hit().and_then(|mut hit| {
            hit.intersection.t = self.entry(self.leaf_of(hit.object)?)?;
            Some((
                "the t at which the ray enters the leaf's box",
                Answer::Hit(Some(hit)),
            ))
        });
        all.into_iter().filter_map(answer).chain(of_leaf).collect()
    }
}

/// Asks for a test of the question at this place in the job.
type AskTest = Box<dyn Fn(usize, Test) -> TestResult + Send + Sync>;

/// How this process asks for tests, if it is a submission.
static ASK_TEST: OnceLock<AskTest> = OnceLock::new();

/// Says how this process asks for tests. Only the first call counts.
#[cfg(unix)]
pub(crate) fn ask_tests_with(ask: impl Fn(usize, Test) -> TestResult + Send + Sync + 'static) {
    let _already = ASK_TEST.set(Box::new(ask));
}

/// The tree of a question. This process knows its nodes, but not what the ray meets.
struct TestedTree<'a> {
    tree: &'a FlatTree,
    index: usize,
}

impl TestedTree<'_> {
    fn test(&self, test: Test) -> TestResult {
        match ASK_TEST.get() {
            Some(ask) => ask(self.index, test),
            None => {
                panic!("this process can't test boxes and triangles itself, and has nobody to ask")
            }
        }
    }
}

impl RayTree for TestedTree<'_> {
    fn node(&self, node: usize) -> Node<'_> {
        self.tree.node(node)
    }

    fn enter_box(&self, node: usize, min_t: f64, max_t: f64) -> Option<f64> {
        match self.test(Test::Box { node, min_t, max_t }) {
            TestResult::Box(t) => t,
            TestResult::Triangle(_) => None,
        }
    }

    fn intersect_triangle(&self, triangle: usize, min_t: f64) -> Option<Intersection> {
        match self.test(Test::Triangle { triangle, min_t }) {
            TestResult::Triangle(intersection) => intersection,
            TestResult::Box(_) => None,
        }
    }
}
