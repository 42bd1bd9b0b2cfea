//! Writes a mutant's source, with parentheses where they are needed.

use std::ops::Range;

use syn::Expr;
use syn::spanned::Spanned;

use super::{Sites, range};
use crate::validate::mutate::{Edit, Operator};

impl Sites<'_> {
    /// The source of a piece of syntax in the reference.
    pub fn source(&self, node: &impl Spanned) -> &str {
        &self.text[range(node)]
    }

    /// A mutant with `text` in place of a piece of syntax.
    pub fn put(&mut self, node: &impl Spanned, text: impl Into<String>, operator: Operator) {
        self.replace(range(node), text, operator);
    }

    /// A mutant with `text` in place of these bytes.
    pub fn replace(&mut self, range: Range<usize>, text: impl Into<String>, operator: Operator) {
        self.edits.push(Edit {
            range,
            text: text.into(),
            operator,
        });
    }

    /// Records that a piece of syntax is part of a tighter-binding expression.
    pub fn hold(&mut self, node: &impl Spanned) {
        let Range { start, end } = range(node);
        self.inside.insert((start, end));
    }

    /// A text, in parentheses if it is part of a tighter-binding expression.
    pub fn closed(&self, node: &impl Spanned, text: String) -> String {
        let Range { start, end } = range(node);
        match self.inside.contains(&(start, end)) {
            true => format!("({text})"),
            false => text,
        }
    }

    /// The source of an expression that becomes part of a tighter-binding one.
    pub fn operand(&self, expression: &Expr) -> String {
        match expression {
            Expr::Binary(_) | Expr::Range(_) | Expr::Cast(_) => {
                format!("({})", self.source(expression))
            }
            _ => self.source(expression).to_owned(),
        }
    }

    /// The source of an expression on which a method is called.
    pub fn receiver(&self, expression: &Expr) -> String {
        match expression {
            Expr::Unary(_) => format!("({})", self.source(expression)),
            _ => self.operand(expression),
        }
    }
}
