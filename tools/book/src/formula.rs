//! Converts LaTeX to MathML at build time, because browsers show MathML without a script.

use math_core::{LatexToMathML, MathCoreConfig, MathDisplay};

/// Converts formulas.
#[derive(Debug)]
pub struct Formulas(LatexToMathML);

impl Default for Formulas {
    fn default() -> Formulas {
        let config = MathCoreConfig {
            annotation: false,
            ..MathCoreConfig::default()
        };
        Formulas(LatexToMathML::new(config).expect("without macros, no macro can be wrong"))
    }
}

impl Formulas {
    /// A formula within a line, as HTML that Markdown leaves alone.
    pub fn inline(&self, latex: &str) -> Result<String, String> {
        self.convert(latex, MathDisplay::Inline)
    }

    /// A formula on a line of its own. If it is wider than the page, it scrolls.
    pub fn display(&self, latex: &str) -> Result<String, String> {
        let math = self.convert(latex, MathDisplay::Block)?;
        Ok(format!("<div class=\"formula\">{math}</div>"))
    }

    fn convert(&self, latex: &str, display: MathDisplay) -> Result<String, String> {
        match latex.trim() {
            "" => Err("an empty formula".into()),
            latex => match self.0.convert_with_local_state(latex, display) {
                Ok(converted) => Ok(inert(&converted.mathml)),
                Err(error) => Err(format!("`{latex}` cannot be typeset: {error}")),
            },
        }
    }
}

/// HTML whose text contains nothing that Markdown would interpret.
fn inert(html: &str) -> String {
    let mut out = String::with_capacity(html.len());
    let (mut in_tag, mut in_entity) = (false, false);
    for c in html.chars() {
        match c {
            '<' => in_tag = true,
            '>' => in_tag = false,
            '&' => in_entity = true,
            _ => {}
        }
        match in_tag || in_entity || !"\\`*_[]{}()#+-.!|~^$\"'".contains(c) {
            _ if c == '\n' => out.push(' '),
            true => out.push(c),
            false => out.push_str(&format!("&#{};", u32::from(c))),
        }
        in_entity &= c != ';' && !c.is_whitespace();
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn formulas_become_mathml_that_markdown_leaves_alone() {
        let formulas = Formulas::default();
        let shown = formulas.inline(r"\mathbf e + t\,\mathbf d * a_b").unwrap();
        assert!(
            shown.starts_with("<math>") && shown.ends_with("</math>"),
            "{shown}"
        );
        let texts: String = shown
            .split('<')
            .filter_map(|part| part.split('>').nth(1))
            .collect();
        assert!(!texts.contains(['*', '_', '$', '|']), "{texts}");
    }

    #[test]
    fn a_formula_that_cannot_be_typeset_is_an_error_that_quotes_it() {
        let error = Formulas::default().inline(r"\frac{1}{").unwrap_err();
        assert!(error.contains(r"`\frac{1}{` cannot be typeset"), "{error}");
        assert!(Formulas::default().display(r"\nosuchcommand").is_err());
        assert!(Formulas::default().inline(" ").is_err());
    }
}
