//! A diagnosis in the words a student reads, and where the book helps.

use serde::Serialize;

use crate::diagnosis::{Diagnosis, Explanation, Reading};

/// What somebody may believe, with hints.
#[derive(Debug, PartialEq, Serialize)]
pub struct Beliefs {
    /// How several of them are meant; none for a single one.
    pub reading: Option<String>,
    /// Each with its hints.
    pub beliefs: Vec<Belief>,
}

/// One belief and its hints.
#[derive(Debug, PartialEq, Serialize)]
pub struct Belief {
    pub belief: String,
    pub explains: Option<String>,
    pub company: Option<String>,
    pub look: String,
    pub think: String,
    pub read: Passage,
}

/// A place in the book: in words, and as the page it will have.
#[derive(Debug, PartialEq, Serialize)]
pub struct Passage {
    pub words: String,
    pub page: String,
}

impl Beliefs {
    /// `None` if nothing is named.
    pub fn of(diagnosis: &Diagnosis) -> Option<Beliefs> {
        let one_of = diagnosis.reading == Reading::OneOf && diagnosis.beliefs.len() > 1;
        let most = diagnosis
            .beliefs
            .iter()
            .map(|held| held.explained)
            .fold(0.0, f64::max);
        let reading = one_of.then(|| {
            format!(
                "One of these beliefs explains {} of what is wrong here; this picture cannot tell them apart.",
                percent(most)
            )
        });
        let belief =
            |held: &Explanation| {
                Belief {
            belief: held.mistake.belief.trim_end_matches('.').into(),
            explains: (!one_of).then(|| {
                format!("It explains {} of what is wrong here.", percent(held.explained))
            }),
            company: held.mistake.submissions.filter(|count| *count > 1).map(|count| {
                format!("It is a common one: {count} public solutions that were looked at hold it.")
            }),
            look: held.mistake.hint.look.clone(),
            think: held.mistake.hint.think.clone(),
            read: Passage::section(&held.mistake.chapter, &held.mistake.hint.read),
        }
            };
        (!diagnosis.is_empty()).then(|| Beliefs {
            reading,
            beliefs: diagnosis.beliefs.iter().map(belief).collect(),
        })
    }
}

/// Never "100 %" unless it is all.
fn percent(share: f64) -> String {
    match share {
        share if share >= 1.0 => "all".into(),
        share => format!("{} %", (share * 100.0).floor()),
    }
}

impl Passage {
    /// A whole chapter.
    pub fn chapter(title: &str) -> Passage {
        Passage {
            words: format!("the book, “{title}”"),
            page: format!("book/{}.html", anchor(title)),
        }
    }

    /// A section of a chapter.
    pub fn section(chapter: &str, section: &str) -> Passage {
        let Passage { words, page } = Passage::chapter(chapter);
        Passage {
            words: format!("{words}, section “{section}”"),
            page: format!("{page}#{}", anchor(section)),
        }
    }
}

/// A title as mdBook makes an address of it.
fn anchor(title: &str) -> String {
    let letter = |c: char| match c {
        c if c.is_whitespace() => Some('-'),
        c if c.is_alphanumeric() || c == '-' || c == '_' => Some(c),
        _ => None,
    };
    title.to_lowercase().chars().filter_map(letter).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::report::testing::belief;

    #[test]
    fn a_single_belief_says_how_much_it_explains() {
        let diagnosis = Diagnosis {
            beliefs: vec![belief("I subtract ½.", 0.989)],
            reading: Reading::Together,
        };
        let beliefs = Beliefs::of(&diagnosis).expect("there is one");
        assert_eq!(beliefs.reading, None);
        assert_eq!(beliefs.beliefs[0].belief, "I subtract ½");
        assert_eq!(
            beliefs.beliefs[0].explains.as_deref(),
            Some("It explains 98 % of what is wrong here.")
        );
    }

    #[test]
    fn beliefs_that_cannot_be_told_apart_are_one_sentence() {
        let diagnosis = Diagnosis {
            beliefs: vec![belief("A.", 1.0), belief("B.", 1.0)],
            reading: Reading::OneOf,
        };
        let beliefs = Beliefs::of(&diagnosis).expect("there are two");
        assert!(
            beliefs
                .reading
                .is_some_and(|words| words.contains("explains all of what is wrong"))
        );
        assert!(
            beliefs
                .beliefs
                .iter()
                .all(|belief| belief.explains.is_none())
        );
    }

    #[test]
    fn without_a_diagnosis_nothing_is_named() {
        assert_eq!(Beliefs::of(&Diagnosis::default()), None);
    }

    #[test]
    fn a_passage_has_the_page_it_will_have() {
        let passage = Passage::section("Viewing rays", "Which root counts?");
        assert_eq!(passage.page, "book/viewing-rays.html#which-root-counts");
        assert_eq!(
            passage.words,
            "the book, “Viewing rays”, section “Which root counts?”"
        );
    }
}
