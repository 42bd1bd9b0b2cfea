//! Answers that are the same but for comments, spaces and line breaks.
//!
//! Short answers may well coincide, so this is reported with how many share an answer and
//! costs no points.

use std::collections::BTreeMap;

use proc_macro2::{TokenStream, TokenTree};
use serde::Serialize;

use super::provenance::sha256;
use super::record::Record;
use pinhole_course::assignment::Assignment;
use pinhole_course::error::Result;
use pinhole_course::mistake;
use pinhole_course::stubs;

/// Answers to one task that are the same.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct SharedAnswer {
    pub task: String,
    /// "the reference", "variant sphere_half_b", "each other".
    pub to: String,
    /// Whose answers, by id.
    pub who: Vec<String>,
    /// How many in the class that is of how many.
    pub share: f64,
}

/// A hash of an answer's tokens, its documentation left out; `None` if it has none that
/// can be told apart.
pub fn tokens(text: &str) -> Option<String> {
    let stream: TokenStream = text.parse().ok()?;
    let mut flat = String::new();
    // A list of what is still to come, not recursion: a student may nest as deep as the
    // file is long.
    let mut open: Vec<(proc_macro2::token_stream::IntoIter, &str)> = vec![(stream.into_iter(), "")];
    let mut after_hash = false;
    while let Some((rest, close)) = open.last_mut() {
        let Some(token) = rest.next() else {
            flat.push_str(close);
            open.pop();
            continue;
        };
        let was_after_hash = std::mem::take(&mut after_hash);
        match token {
            TokenTree::Group(group) if was_after_hash && is_doc(&group.stream()) => {
                flat.truncate(flat.trim_end_matches(['#', '!', '\n']).len());
                if !flat.is_empty() {
                    flat.push('\n');
                }
            }
            TokenTree::Group(group) => {
                let [opening, closing] = match group.delimiter() {
                    proc_macro2::Delimiter::Parenthesis => ["(", ")\n"],
                    proc_macro2::Delimiter::Brace => ["{", "}\n"],
                    proc_macro2::Delimiter::Bracket => ["[", "]\n"],
                    proc_macro2::Delimiter::None => ["", ""],
                };
                flat.push_str(opening);
                open.push((group.stream().into_iter(), closing));
            }
            TokenTree::Punct(punct) => {
                // `#![doc]` has a `!` between.
                after_hash = punct.as_char() == '#' || (was_after_hash && punct.as_char() == '!');
                flat.push(punct.as_char());
                flat.push('\n');
            }
            other => {
                flat.push_str(&other.to_string());
                flat.push('\n');
            }
        }
    }
    (!flat.trim().is_empty()).then(|| sha256(flat.as_bytes()))
}

/// Whether an attribute is what a documentation comment becomes.
fn is_doc(stream: &TokenStream) -> bool {
    let first = stream.clone().into_iter().next();
    matches!(first, Some(TokenTree::Ident(name)) if name == "doc")
}

/// Answers that are not the students' own work: the stubs, the reference's and the variants',
/// by task and hash.
pub struct KnownAnswers {
    named: BTreeMap<(String, String), String>,
    stubs: Vec<String>,
}

impl KnownAnswers {
    /// Reads them; an assignment without solutions has none.
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

    /// Which answers of a class are the same as a known one, or as each other.
    pub fn alike(&self, records: &[&Record]) -> Vec<SharedAnswer> {
        let mut same: BTreeMap<(String, String), Vec<String>> = BTreeMap::new();
        for record in records {
            for (task, hash) in &record.tokens {
                if !self.stubs.contains(hash) {
                    let key = (task.clone(), hash.clone());
                    same.entry(key).or_default().push(record.id.clone());
                }
            }
        }
        let alike = same.into_iter().filter_map(|(key, who)| {
            let known = self.named.get(&key).cloned();
            let to = known.or_else(|| (who.len() > 1).then(|| "each other".into()))?;
            let share = who.len() as f64 / records.len().max(1) as f64;
            Some(SharedAnswer {
                task: key.0,
                to,
                who,
                share,
            })
        });
        let mut alike: Vec<SharedAnswer> = alike.collect();
        alike.sort_by(|a, b| (&a.task, &a.to, &a.who).cmp(&(&b.task, &b.to, &b.who)));
        alike
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn comments_and_layout_make_no_difference_and_tokens_do() {
        let plain = tokens("fn f(x: f64) -> f64 { x * 2.0 }");
        let noisy = "//! Mine.\n/// I wrote this.\nfn f(x:f64)->f64{\n // two\n x*2.0 /* . */ }";
        assert_eq!(tokens(noisy), plain);
        assert_ne!(tokens("fn f(x: f64) -> f64 { x * 3.0 }"), plain);
        assert_ne!(tokens("fn f(y: f64) -> f64 { y * 2.0 }"), plain);
    }

    #[test]
    fn a_file_of_brackets_is_no_danger() {
        let deep = "(".repeat(120_000) + &")".repeat(120_000);
        assert!(tokens(&deep).is_some());
        assert_eq!(tokens("((("), None);
        assert_eq!(tokens("// nothing"), None);
    }
}
