//! The directives that writers put between `{{#` and `}}`.

use crate::error::ProblemAndRemedy;

/// A directive: something to insert.
#[derive(Clone, Debug, PartialEq)]
pub enum Directive {
    /// Code between two anchors of a file.
    Listing {
        /// The file, from the top of the checkout.
        path: String,
        /// The anchor's name.
        anchor: String,
    },
    /// A command and its output.
    Run(String),
    /// One number.
    Value(String),
    /// A figure.
    Figure {
        /// Its name.
        name: String,
        /// The alternative text, for readers who can't see it.
        alternative: String,
        /// The caption below the figure.
        caption: String,
    },
    /// Pictures of a task's mistakes.
    Gallery(String),
    /// An interactive figure.
    Interactive {
        /// Its name.
        name: String,
        /// The alternative text, for readers who can't see it.
        alternative: String,
    },
}

/// The syntax of each directive, for error messages.
const USES: [(&str, &str); 6] = [
    ("listing", "{{#listing PATH:ANCHOR}}"),
    ("run", "{{#run ID}}"),
    ("value", "{{#value NAME}}"),
    (
        "figure",
        "{{#figure NAME \"alternative text\" \"caption\"}}",
    ),
    ("gallery", "{{#gallery TASK}}"),
    ("interactive", "{{#interactive NAME \"alternative text\"}}"),
];

impl Directive {
    /// Reads the text between `{{#` and `}}`. The error says what is wrong, and the remedy.
    pub fn parse(inside: &str) -> Result<Directive, ProblemAndRemedy> {
        let mut words = words(inside).into_iter();
        let kind = words.next().unwrap_or_default();
        let Some((_, usage)) = USES.iter().find(|(name, _)| *name == kind.as_str()) else {
            let known = USES.map(|(name, _)| name).join(", ");
            return Err((
                format!("there is no directive `{kind}`"),
                format!("use one of: {known}, or `instructor` alone on its line"),
            ));
        };
        let wrong = || {
            (
                format!("`{{{{#{inside}}}}}` is not complete"),
                format!("write {usage}"),
            )
        };
        let words: Vec<String> = words.collect();
        let directive = match (kind.as_str(), words.as_slice()) {
            ("listing", [place]) => {
                let (path, anchor) = place.rsplit_once(':').ok_or_else(wrong)?;
                Directive::Listing {
                    path: path.into(),
                    anchor: anchor.into(),
                }
            }
            ("run", [id]) => Directive::Run(id.clone()),
            ("value", [name]) => Directive::Value(name.clone()),
            ("gallery", [task]) => Directive::Gallery(task.clone()),
            ("figure", [name, alternative, caption]) => Directive::Figure {
                name: name.clone(),
                alternative: alternative.clone(),
                caption: caption.clone(),
            },
            ("interactive", [name, alternative]) => Directive::Interactive {
                name: name.clone(),
                alternative: alternative.clone(),
            },
            _ => return Err(wrong()),
        };
        let blank = |text: &String| text.trim().is_empty();
        match words.iter().any(blank) {
            true => Err(wrong()),
            false => Ok(directive),
        }
    }
}

/// Words, and texts in quotation marks.
fn words(inside: &str) -> Vec<String> {
    let mut words = Vec::new();
    let mut rest = inside.trim();
    while !rest.is_empty() {
        let (word, after) = match rest.strip_prefix('"') {
            Some(quoted) => quoted.split_once('"').unwrap_or((quoted, "")),
            None => rest.split_once(char::is_whitespace).unwrap_or((rest, "")),
        };
        words.push(word.to_owned());
        rest = after.trim_start();
    }
    words
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_figure_has_a_name_an_alternative_text_and_a_caption() {
        let read = Directive::parse("figure ray \"A ray\" \"Its *t*.\"");
        let expected = Directive::Figure {
            name: "ray".into(),
            alternative: "A ray".into(),
            caption: "Its *t*.".into(),
        };
        assert_eq!(read, Ok(expected));
    }

    #[test]
    fn an_error_shows_the_directives_syntax() {
        for (inside, remedy) in [
            ("figure ray", "write {{#figure NAME"),
            ("figure ray \"\" \"caption\"", "write {{#figure NAME"),
            ("listing src/ray.rs", "write {{#listing PATH:ANCHOR}}"),
            ("include src/ray.rs", "use one of"),
            ("value", "write {{#value NAME}}"),
        ] {
            let (_, said) = Directive::parse(inside).unwrap_err();
            assert!(said.starts_with(remedy), "{inside}: {said}");
        }
    }
}
