//! Mutants: the reference with one small fault each, written by a program.
//!
//! If the goldens catch every mutant, they test every operator, constant and argument of
//! the reference (DeMillo, Lipton & Sayward, "Hints on Test Data Selection", 1978). The
//! five operators that Offutt et al. found sufficient are here (ABS, AOR, LCR, ROR, UOI:
//! "An Experimental Determination of Sufficient Mutant Operators", 1996), the ones of
//! cargo-mutants for Rust, and those of this subject: a component or vector taken for
//! its neighbour, a cross product the other way round, a length left squared.
//!
//! Only the text of the change is replaced, so that a mutant reads like the reference.

mod operators;
mod sites;

use std::collections::BTreeSet;
use std::ops::Range;

use serde::Serialize;

/// One small fault.
#[derive(Clone, Debug, Serialize)]
pub struct Mutant {
    /// The task whose answer it changes.
    pub task: String,
    /// The line where the change begins, from 1.
    pub line: usize,
    /// The column where the change begins, in characters, from 1.
    pub column: usize,
    /// What kind of change it is.
    pub operator: Operator,
    /// The line, or lines, as the reference has them, without indentation.
    pub was: String,
    /// What the mutant has in their place.
    pub becomes: String,
    /// The whole file.
    #[serde(skip)]
    pub text: String,
}

/// Kinds of change.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Operator {
    /// |x| or −|x| for x (Offutt's ABS).
    Absolute,
    /// One of + − × ÷ for another (AOR).
    Arithmetic,
    /// `&&` for `||` and the other way round, or one side alone (LCR).
    Logical,
    /// Another comparison, or always, or never (ROR).
    Relation,
    /// A sign or a `!` put in or left out (UOI).
    Unary,
    /// Another number.
    Constant,
    /// Another method, or none.
    Method,
    /// Two arguments, elements, fields or arms for each other.
    Swap,
    /// A variable or a field for its neighbour.
    Neighbour,
    /// A range with its end, or without.
    Range,
    /// No answer instead of this one (cargo-mutants' function bodies).
    Answer,
}

impl Mutant {
    /// `sphere.rs:31:9`.
    pub fn name(&self) -> String {
        format!("{}.rs:{}:{}", self.task, self.line, self.column)
    }

    /// Its lines before and after, as `diff` shows them.
    pub fn diff(&self) -> String {
        let marked = |mark, lines: &str| {
            let lines = lines.lines().map(|line| format!("  {mark} {line}"));
            lines.collect::<Vec<_>>().join("\n")
        };
        format!("{}\n{}", marked('-', &self.was), marked('+', &self.becomes))
    }
}

/// A change of some bytes of a file.
struct Edit {
    range: Range<usize>,
    text: String,
    operator: Operator,
}

/// All mutants of one answer: `text` is its file, and what lies between the anchors of
/// the answer is changed.
///
/// # Errors
/// If the file is not Rust.
pub fn mutants(task: &str, text: &str) -> Result<Vec<Mutant>, syn::Error> {
    let file = syn::parse_file(text)?;
    let starts = text.match_indices("// ANCHOR: answer");
    let ends = text.match_indices("// ANCHOR_END: answer");
    let answers: Vec<_> = starts
        .zip(ends)
        .map(|((start, _), (end, _))| start..end)
        .collect();
    let mut edits = sites::edits(&file, text);
    let is_in = |answer: &Range<usize>, edit: &Edit| {
        answer.start <= edit.range.start && edit.range.end <= answer.end
    };
    edits.retain(|edit| answers.is_empty() || answers.iter().any(|answer| is_in(answer, edit)));
    edits.sort_by_key(|edit| (edit.range.start, edit.range.end, edit.operator));
    let mut seen = BTreeSet::from([text.to_owned()]);
    let mutants = edits.iter().map(|edit| edit.apply(task, text));
    Ok(mutants
        .filter(|mutant| seen.insert(mutant.text.clone()))
        .collect())
}

impl Edit {
    fn apply(&self, task: &str, text: &str) -> Mutant {
        let (before, after) = (&text[..self.range.start], &text[self.range.end..]);
        let line_start = before.rfind('\n').map_or(0, |at| at + 1);
        let line_end = self.range.end + after.find('\n').unwrap_or(after.len());
        let was = &text[line_start..line_end];
        let becomes = [
            &text[line_start..self.range.start],
            &self.text,
            &text[self.range.end..line_end],
        ];
        Mutant {
            task: task.into(),
            line: before.matches('\n').count() + 1,
            column: before[line_start..].chars().count() + 1,
            operator: self.operator,
            was: without_indent(was),
            becomes: without_indent(&becomes.concat()),
            text: [before, &self.text, after].concat(),
        }
    }
}

/// Removes the indentation that lines have in common.
fn without_indent(lines: &str) -> String {
    let indent = |line: &str| line.len() - line.trim_start().len();
    let least = lines
        .lines()
        .filter(|line| !line.trim().is_empty())
        .map(indent)
        .min();
    let moved = lines
        .lines()
        .map(|line| line.get(least.unwrap_or(0)..).unwrap_or_default());
    moved.collect::<Vec<_>>().join("\n")
}

#[cfg(test)]
mod tests;
