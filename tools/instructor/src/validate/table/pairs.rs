//! The table of pairs of beliefs.

use super::{QUIET, row};
use crate::validate::pairs::Pairs;
use crate::validate::sentences::Sentences;

/// Names and sentences, then the pairs without any.
pub fn table(pairs: &Pairs) -> String {
    let names = &pairs.names;
    let said = format!(
        "{} of {} failing pairs get a right name, and {} of them get both; {} false names \
         ({} pairs exist)",
        names.right + names.among,
        names.all(),
        pairs.both,
        names.wrong.len(),
        pairs.all,
    );
    let mut text = row(names.wrong.is_empty(), "pairs", said);
    text += &sentences(&pairs.sentences);
    for name in &pairs.unnamed {
        text += &format!("  {QUIET}no right name: {name}{QUIET:#}\n");
    }
    text
}

/// The row about measured sentences.
pub fn sentences(sentences: &Sentences) -> String {
    let Sentences {
        tasks,
        told,
        tested,
        ..
    } = sentences;
    let wrong = sentences.wrong.len();
    let said = format!(
        "for {told} of {tasks} wrong answers, a sentence says how or where they are wrong; \
         {wrong} of {tested} tested sentences are false"
    );
    let mut text = row(wrong == 0, "  measured", said);
    for untold in &sentences.untold {
        text += &format!("  {QUIET}no sentence: {untold}{QUIET:#}\n");
    }
    text
}
