//! The changes at one place: what may replace the syntax there.

use syn::spanned::Spanned;
use syn::{Expr, ExprBinary, ExprMethodCall};

use super::{Sites, range};
use crate::validate::mutate::Operator;
use crate::validate::mutate::operators::{
    detours, is_arithmetic, is_logical, is_one_sided, may_be_forgotten, other_methods, others,
};

impl Sites<'_> {
    /// −x for x; also |x| and −|x| if `absolute` is set.
    pub fn sign(&mut self, expression: &Expr, absolute: bool) {
        let operand = self.operand(expression);
        let negative = self.closed(expression, format!("-{operand}"));
        self.put(expression, negative, Operator::Unary);
        if absolute {
            let receiver = self.receiver(expression);
            self.put(expression, format!("{receiver}.abs()"), Operator::Absolute);
            let negative = self.closed(expression, format!("-{receiver}.abs()"));
            self.put(expression, negative, Operator::Absolute);
        }
    }

    /// A condition that is always true, one that is never true, and the negated one.
    pub fn condition(&mut self, expression: &impl Spanned) {
        self.put(expression, "true", Operator::Relation);
        self.put(expression, "false", Operator::Relation);
        let source = self.source(expression);
        if !source.starts_with('!') {
            let negated = format!("!({source})");
            self.put(expression, negated, Operator::Unary);
        }
    }

    /// Swaps each pair of neighbours.
    pub fn swap_pairs<'e>(&mut self, elements: impl Iterator<Item = &'e Expr>) {
        let elements: Vec<&Expr> = elements.collect();
        for pair in elements.windows(2) {
            self.swap(pair[0], pair[1]);
        }
    }

    fn swap(&mut self, first: &Expr, second: &Expr) {
        let (a, b) = (range(first), range(second));
        let between = &self.text[a.end..b.start];
        let text = [self.source(second), between, self.source(first)].concat();
        self.replace(a.start..b.end, text, Operator::Swap);
    }

    /// Another operator. For a logical one, also each side alone; for a comparison, also `true`,
    /// `false` and the negation.
    pub fn binary(&mut self, expression: &ExprBinary) {
        let ExprBinary {
            left, op, right, ..
        } = expression;
        // Comparisons and logical operators bind less tightly than any operand here.
        let (a, b) = match is_arithmetic(op) {
            true => (self.operand(left), self.operand(right)),
            false => (self.source(left).into(), self.source(right).into()),
        };
        let operator = match op {
            op if is_arithmetic(op) => Operator::Arithmetic,
            op if is_logical(op) => Operator::Logical,
            _ => Operator::Relation,
        };
        for other in others(op) {
            let changed = self.closed(expression, format!("{a} {other} {b}"));
            self.put(expression, changed, operator);
        }
        match operator {
            Operator::Arithmetic => {
                self.hold(left);
                self.hold(right);
            }
            Operator::Logical => {
                self.put(expression, self.source(left).to_owned(), operator);
                self.put(expression, self.source(right).to_owned(), operator);
            }
            _ => self.condition(expression),
        }
    }

    /// Another method or none, a detour, or the call with argument and receiver swapped.
    pub fn method(&mut self, expression: &ExprMethodCall) {
        let method = expression.method.to_string();
        for other in other_methods(&method) {
            self.put(&expression.method, *other, Operator::Method);
        }
        let (receiver, end) = (range(&expression.receiver), range(expression).end);
        if may_be_forgotten(&method) {
            self.replace(receiver.end..end, "", Operator::Method);
        }
        for detour in detours(&method) {
            self.replace(end..end, *detour, Operator::Method);
        }
        if is_one_sided(&method)
            && let Some(argument) = expression.args.first()
        {
            let bare = match argument {
                Expr::Reference(reference) => &reference.expr,
                other => other,
            };
            let reference = if matches!(argument, Expr::Reference(_)) {
                "&"
            } else {
                ""
            };
            let receiver = self.source(&expression.receiver).to_owned();
            let swapped = format!("{}.{method}({reference}{receiver})", self.receiver(bare));
            self.put(expression, swapped, Operator::Swap);
        }
    }

    /// `None` for the whole body of a function that returns an `Option`.
    pub fn no_answer(&mut self, signature: &syn::Signature, block: &syn::Block) {
        let syn::ReturnType::Type(_, returned) = &signature.output else {
            return;
        };
        let may_say_none = self.source(returned).starts_with("Option<");
        if let (true, Some(first), Some(last)) =
            (may_say_none, block.stmts.first(), block.stmts.last())
        {
            let body = range(first).start..range(last).end;
            self.replace(body, "None", Operator::Answer);
        }
    }
}
