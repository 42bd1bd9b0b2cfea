//! Finds answers that are the same except for comments, spaces, line breaks and names.
//!
//! All names but those of types and variants count as equal, so that no renaming hides a copy. This
//! also makes `b - a` equal to `a - b`. So two answers count as the same only if they get the same
//! points, too.
//!
//! Short answers may coincide by chance, so rare matches count more. A match counts in bits: log₂
//! of the number of right answers divided by the number of those that match. Six equal loops over
//! triangles in a class of ten are worth less than one bit. A match never costs points.

use std::collections::{BTreeMap, BTreeSet};

use proc_macro2::{Delimiter, Group, Ident, TokenStream, TokenTree};
use serde::Serialize;

use super::provenance::sha256;
use super::record::RecordSummary;
use pinhole_course::assignment::{Assignment, EXAMPLES};
use pinhole_course::error::Result;
use pinhole_course::mistake;
use pinhole_course::stubs;

/// Answers to one task that are the same and get the same points.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct SharedAnswer {
    pub task: String,
    /// What they are equal to: "the reference", "the variant sphere_half_b", or "each other".
    pub to: String,
    /// The ids of the submissions with this answer.
    pub who: Vec<String>,
    /// Their share of the class.
    pub share: f64,
    /// How rare it is: log₂ of the number of right answers divided by the number of these.
    pub bits: f64,
}

/// Two submissions that share several answers.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct SharedPair {
    pub who: [String; 2],
    pub tasks: Vec<String>,
    /// The sum of the answers' bits.
    pub bits: f64,
}

/// A hash of an answer's tokens, without documentation and with one sign for every name except those
/// of types. `None` if the text can't be split into tokens.
pub fn tokens(text: &str) -> Option<String> {
    let words = text.parse().map(words);
    // Otherwise, the library would keep every text until this thread ends, because tokens refer to
    // places in it.
    proc_macro2::extra::invalidate_current_thread_spans();
    let words = words.ok()?;
    (!words.is_empty()).then(|| sha256(words.join("\n").as_bytes()))
}

/// The sign for a name.
const NAME: &str = "#name";

/// The tokens one by one, without documentation.
fn words(stream: TokenStream) -> Vec<String> {
    let mut words: Vec<String> = Vec::new();
    // Use a list instead of recursion, because a student's file may consist of nothing but nested
    // brackets.
    let mut open = vec![(stream.into_iter(), "")];
    while let Some((rest, close)) = open.last_mut() {
        let Some(token) = rest.next() else {
            let close = *close;
            words.extend((!close.is_empty()).then(|| close.to_owned()));
            open.pop();
            continue;
        };
        match token {
            TokenTree::Group(group) if is_doc(&words, &group) => {
                // `#[doc]`, or `#![doc]` with a `!` in between.
                while words.last().is_some_and(|word| word == "#" || word == "!") {
                    words.pop();
                }
            }
            TokenTree::Group(group) => {
                let [opening, closing] = match group.delimiter() {
                    Delimiter::Parenthesis => ["(", ")"],
                    Delimiter::Brace => ["{", "}"],
                    Delimiter::Bracket => ["[", "]"],
                    Delimiter::None => ["", ""],
                };
                words.extend((!opening.is_empty()).then(|| opening.to_owned()));
                open.push((group.stream().into_iter(), closing));
            }
            TokenTree::Ident(name) if is_replaced(&name) => match &words[..] {
                // `Hit { t: x }` is `Hit { t }` with another name for the variable.
                [.., before, colon] if before == NAME && colon == ":" => drop(words.pop()),
                _ => words.push(NAME.into()),
            },
            other => words.push(other.to_string()),
        }
    }
    words
}

/// Whether this is a name, but neither that of a type nor of a variant, such as `Hit` or `Some`.
fn is_replaced(name: &Ident) -> bool {
    let text = name.to_string();
    let is_type = text.starts_with(char::is_uppercase) && text.contains(char::is_lowercase);
    // Keywords are no names.
    !is_type && syn::parse2::<syn::Ident>(TokenTree::from(name.clone()).into()).is_ok()
}

/// Whether this group, in brackets, ends an attribute that a documentation comment became. A block
/// of code may also begin with the name `doc`, and must not be left out.
fn is_doc(before: &[String], group: &Group) -> bool {
    let before = before.iter().rev().find(|word| *word != "!");
    let first = group.stream().into_iter().next();
    before.is_some_and(|word| word == "#")
        && matches!(first, Some(TokenTree::Ident(name)) if name == "doc")
}

/// Answers that are not the students' own work.
#[derive(Default)]
pub struct KnownAnswers {
    /// The reference's and the variants', by task and hash. All of them are right.
    named: BTreeMap<(String, String), String>,
    stubs: Vec<String>,
}

impl KnownAnswers {
    /// Reads the known answers. An assignment without solutions has none.
    pub fn read(assignment: &Assignment) -> Result<KnownAnswers> {
        let mut named = BTreeMap::new();
        let variants = mistake::folders(&assignment.folder.join("variants"));
        for (slug, folder) in variants {
            for task in &assignment.tasks {
                let text = std::fs::read_to_string(folder.join(task.file()));
                if let Some(hash) = text.ok().and_then(|text| tokens(&text)) {
                    named.insert((task.name.clone(), hash), format!("the variant {slug}"));
                }
            }
        }
        let reference = assignment.reference().join("src");
        for task in &assignment.tasks {
            let text = std::fs::read_to_string(reference.join(task.file()));
            if let Some(hash) = text.ok().and_then(|text| tokens(&text)) {
                named.insert((task.name.clone(), hash), "the reference".into());
            }
        }
        let stubs = stubs::generate(assignment)?;
        let stubs = stubs.values().filter_map(|text| tokens(text));
        Ok(KnownAnswers {
            named,
            stubs: stubs.collect(),
        })
    }

    /// Answers of a class that are equal to a known one or to each other, the rarest first.
    pub fn shared_answers(&self, records: &[&RecordSummary]) -> Vec<SharedAnswer> {
        let mut same: BTreeMap<(&str, &str, u32, bool), Vec<String>> = BTreeMap::new();
        let mut right: BTreeMap<&str, usize> = BTreeMap::new();
        for record in records {
            for (name, hash) in &*record.tokens {
                // An answer to an earlier assignment's task has no points.
                let mut tasks = record.tasks.iter().filter(|it| *it.task.name == **name);
                let groups = tasks.next().map_or(&[][..], |task| &task.groups);
                // Examples belong to another file.
                let groups = groups.iter().filter(|group| *group.name != *EXAMPLES);
                let is_right = groups.clone().all(|group| group.points == group.possible);
                let points = groups.map(|group| group.points).sum();
                *right.entry(name).or_default() += usize::from(is_right);
                if !self.stubs.contains(hash) {
                    let who = same.entry((name, hash, points, is_right)).or_default();
                    who.push(record.id.clone());
                }
            }
        }
        let alike = same
            .into_iter()
            .filter_map(|((task, hash, _, is_right), who)| {
                let known = self.named.get(&(task.to_owned(), hash.to_owned()));
                let known = known.filter(|_| is_right).cloned();
                let to = known.or_else(|| (who.len() > 1).then(|| "each other".into()))?;
                let of = right.get(task).copied().unwrap_or(0).max(who.len()) as f64;
                Some(SharedAnswer {
                    task: task.into(),
                    to,
                    share: who.len() as f64 / records.len().max(1) as f64,
                    bits: (of / who.len() as f64).log2(),
                    who,
                })
            });
        let mut alike: Vec<SharedAnswer> = alike.collect();
        alike.sort_by(|a, b| {
            let names = |it: &SharedAnswer| (it.task.clone(), it.to.clone(), it.who.clone());
            b.bits.total_cmp(&a.bits).then(names(a).cmp(&names(b)))
        });
        alike
    }
}

/// Pairs that share more than one answer, those with the most bits first. `alike` begins with the
/// rarest answers.
pub fn pairs(alike: &[SharedAnswer]) -> Vec<SharedPair> {
    /// The most pairs that are listed.
    const MOST: usize = 20;
    /// The most pairs of groups that are compared. A class of thousands may have too many to
    /// compare them all; those with the rarest answers come first.
    const COMPARED: usize = 100_000;
    // An answer that half of the class has says nothing about a pair.
    let rare: Vec<&SharedAnswer> = alike.iter().filter(|shared| shared.bits >= 1.0).collect();
    let mut answers: BTreeMap<&String, Vec<usize>> = BTreeMap::new();
    for (answer, shared) in rare.iter().enumerate() {
        for id in &shared.who {
            answers.entry(id).or_default().push(answer);
        }
    }
    // Pairs are listed by the sum of their bits and then by their ids. So of a group with the
    // same rare answers, only the first members can be among the first pairs.
    let mut groups: BTreeMap<&Vec<usize>, Vec<&String>> = BTreeMap::new();
    for (id, answers) in &answers {
        let members = groups.entry(answers).or_default();
        if members.len() <= MOST {
            members.push(id);
        }
    }
    let groups: Vec<(&Vec<usize>, Vec<&String>)> = groups.into_iter().collect();
    let mut with_answer = vec![Vec::new(); rare.len()];
    for (group, (answers, _)) in groups.iter().enumerate() {
        answers
            .iter()
            .for_each(|answer| with_answer[*answer].push(group));
    }
    let both = with_answer.iter().flat_map(|groups| {
        let each = groups.iter().enumerate();
        each.flat_map(|(k, one)| groups[k..].iter().map(|other| [*one, *other]))
    });
    let compared: BTreeSet<[usize; 2]> = both.take(COMPARED).collect();
    let compared = compared.into_iter().filter_map(|both| {
        let [own, others] = both.map(|group| groups[group].0);
        let shared = own.iter().filter(|answer| others.contains(answer));
        let shared: Vec<&SharedAnswer> = shared.map(|answer| rare[*answer]).collect();
        let bits: f64 = shared.iter().map(|it| it.bits).sum();
        (shared.len() > 1).then_some((bits, shared, both))
    });
    let mut compared: Vec<_> = compared.collect();
    compared.sort_by(|a, b| b.0.total_cmp(&a.0));
    let mut pairs: Vec<SharedPair> = Vec::new();
    for (bits, shared, [one, other]) in compared {
        if pairs.len() >= MOST && pairs[pairs.len() - 1].bits > bits {
            break;
        }
        for (k, first) in groups[one].1.iter().enumerate() {
            let rest = if one == other { k + 1 } else { 0 };
            for second in &groups[other].1[rest..] {
                let mut who = [(*first).clone(), (*second).clone()];
                who.sort();
                pairs.push(SharedPair {
                    who,
                    tasks: shared.iter().map(|it| it.task.clone()).collect(),
                    bits,
                });
            }
        }
    }
    pairs.sort_by(|a, b| b.bits.total_cmp(&a.bits).then(a.who.cmp(&b.who)));
    pairs.truncate(MOST);
    pairs
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn comments_layout_and_names_make_no_difference_but_operations_and_types_do() {
        let plain =
            tokens("fn f(x: f64) -> Hit { let y = x * 2.0; g(y).map(|i| Hit { t: i, y }) }");
        for same in [
            "//! Mine.\n/// I wrote this.\nfn f(x:f64)->Hit{\n // two\n let y=x*2.0;g(y).map(|i|Hit{t:i,y}) /* . */ }",
            "fn f(a: f64) -> Hit { let b = a * 2.0; g(b).map(|k| Hit { t: k, y: b }) }",
            "fn f(x: f64) -> Hit { let x = x * 2.0; g(x).map(|t| Hit { t, y: x }) }",
            "fn f(x: f64) -> Hit { let r#box = x * 2.0; h(r#box).all(|i| Hit { t: i, y: r#box }) }",
        ] {
            assert_eq!(tokens(same), plain, "{same}");
        }
        for other in [
            "fn f(x: f64) -> Hit { let y = x * 3.0; g(y).map(|i| Hit { t: i, y }) }",
            "fn f(x: f64) -> Hit { let y = x + 2.0; g(y).map(|i| Hit { t: i, y }) }",
            "fn f(x: f64) -> Hit { let mut y = x * 2.0; g(y).map(|i| Hit { t: i, y }) }",
            "fn f(x: f64) -> Hit { let y = x * 2.0; g(y).map(|i| Hit { t: -i, y }) }",
            "fn f(x: f64) -> Box { let y = x * 2.0; g(y).map(|i| Hit { t: i, y }) }",
        ] {
            assert_ne!(tokens(other), plain, "{other}");
        }
        assert_eq!(
            tokens("const EPSILON: f64 = 1e-9;"),
            tokens("const TINY: f64 = 1e-9;")
        );
        assert_ne!(tokens("if x { y }"), tokens("while x { y }"));
    }

    #[test]
    fn equal_tokens_with_other_points_are_not_the_same_answer() {
        use crate::grade::record::PartSummary;
        use crate::grade::record::tests::graded;
        let known = KnownAnswers {
            named: BTreeMap::from([(("plane".into(), "a".into()), "the reference".into())]),
            stubs: Vec::new(),
        };
        let record = |id: &str, points: u32, examples: u32| {
            let mut record = graded(id, 1, 1);
            record.tokens.insert("plane".into(), "a".into());
            record.got.tasks.push(right("plane"));
            let mut record = RecordSummary::from(record);
            let group = |name: &str, points| PartSummary {
                name: name.into(),
                points,
                possible: 2,
                status: pinhole_course::outcome::Status::Graded,
            };
            record.tasks[0].groups = Box::new([group("near", points), group(EXAMPLES, examples)]);
            record
        };
        let records = [
            record("ada", 2, 2),
            record("bob", 2, 0),
            record("cy", 0, 2),
            record("dan", 0, 0),
            record("eve", 1, 0),
        ];
        let alike = known.shared_answers(&records.iter().collect::<Vec<_>>());
        let alike: Vec<String> = alike
            .iter()
            .map(|it| format!("{} are {}", it.who.join(" "), it.to))
            .collect();
        assert_eq!(
            alike,
            ["cy dan are each other", "ada bob are the reference"]
        );
    }

    #[test]
    fn answer_inside_a_block_that_begins_with_doc_is_not_taken_for_the_stub() {
        let stub = tokens("fn f(x: f64) -> f64 { todo!() }");
        let hidden = "fn f(x: f64) -> f64 { { doc(); fn doc() {} return x * 2.0; } todo!() }";
        assert_ne!(tokens(hidden), stub);
    }

    #[test]
    fn answers_to_an_earlier_assignments_task_are_compared() {
        use crate::grade::record::tests::graded;
        let record = |id: &str| {
            let mut record = graded(id, 1, 1);
            record.tokens.insert("earlier".into(), "a".into());
            RecordSummary::from(record)
        };
        let records = [record("ada"), record("bob")];
        let known = KnownAnswers::default();
        let alike = known.shared_answers(&records.iter().collect::<Vec<_>>());
        assert_eq!(alike[0].who, ["ada", "bob"]);
    }

    #[test]
    fn rare_matches_count_more() {
        use crate::grade::record::tests::graded;
        let known = KnownAnswers {
            named: BTreeMap::new(),
            stubs: Vec::new(),
        };
        // All have the same loop over triangles; two also share a sphere and a plane.
        let record = |k: usize| {
            let mut record = graded(&format!("s{k}"), 1, 1);
            let own = |task: &str| match k {
                0 | 1 => format!("{task} of two"),
                _ => format!("{task} of {k}"),
            };
            for (task, form) in [
                ("soup", "soup".into()),
                ("sphere", own("sphere")),
                ("plane", own("plane")),
            ] {
                record.tokens.insert(task.into(), form);
                record.got.tasks.push(right(task));
            }
            record
        };
        let records: Vec<RecordSummary> = (0..16).map(|k| record(k).into()).collect();
        let alike = known.shared_answers(&records.iter().collect::<Vec<_>>());
        let bits: Vec<(&str, f64)> = alike.iter().map(|it| (it.task.as_str(), it.bits)).collect();
        assert_eq!(bits, [("plane", 3.0), ("sphere", 3.0), ("soup", 0.0)]);
        let pairs = pairs(&alike);
        assert_eq!(pairs.len(), 1, "{pairs:?}");
        assert_eq!((pairs[0].bits, pairs[0].tasks.len()), (6.0, 2));
    }

    #[test]
    fn a_crowd_with_the_same_answers_does_not_hide_a_rarer_pair() {
        let shared = |task: &str, who: &[usize], bits| SharedAnswer {
            task: task.into(),
            to: "each other".into(),
            who: who.iter().map(|k| format!("s{k:04}")).collect(),
            share: 0.0,
            bits,
        };
        let crowd: Vec<usize> = (100..1100).collect();
        let alike = [
            shared("plane", &[1, 2], 9.0),
            shared("sphere", &crowd, 1.5),
            shared("triangle", &[&[1, 2], &crowd[..]].concat(), 1.4),
        ];
        let pairs = pairs(&alike);
        let first: Vec<String> = pairs
            .iter()
            .map(|pair| pair.who.join(" "))
            .take(3)
            .collect();
        assert_eq!(first, ["s0001 s0002", "s0100 s0101", "s0100 s0102"]);
        assert_eq!((pairs.len(), pairs[0].bits), (20, 10.4));
    }

    fn right(task: &str) -> pinhole_course::outcome::TaskOutcome {
        serde_json::from_value(serde_json::json!({
            "name": task, "chapter": "", "points": 1, "possible": 1,
            "file": { "state": "compiled" }, "groups": [], "diagnosis": null, "measured": [],
        }))
        .expect("it is a task's outcome")
    }

    #[test]
    fn deeply_nested_brackets_do_no_harm() {
        let deep = "(".repeat(120_000) + &")".repeat(120_000);
        assert!(tokens(&deep).is_some());
        assert_eq!(tokens("((("), None);
        assert_eq!(tokens("// nothing"), None);
    }
}
