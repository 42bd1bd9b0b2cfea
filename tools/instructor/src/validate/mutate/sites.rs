//! Walks through an answer and collects every change at every place.
//!
//! The walk is here; [`variables`] knows the answer's variables, [`changes`] the replacements for
//! each piece of syntax, and [`source`] writes them.

mod changes;
mod source;
mod variables;

use std::collections::BTreeSet;
use std::ops::Range;

use syn::spanned::Spanned;
use syn::visit::{self, Visit};
use syn::{Expr, ExprBinary, ExprMethodCall, Member, UnOp};

use super::operators::{is_arithmetic, neighbours, other_numbers};
use super::{Edit, Operator};
use variables::Variables;

/// Every change of every function in a file.
pub fn edits(file: &syn::File, text: &str) -> Vec<Edit> {
    let mut variables = Variables::default();
    variables.visit_file(file);
    let mut sites = Sites {
        text,
        variables,
        edits: Vec::new(),
        inside: BTreeSet::new(),
    };
    sites.visit_file(file);
    sites.edits
}

struct Sites<'a> {
    text: &'a str,
    variables: Variables,
    edits: Vec<Edit>,
    /// Places where an expression is part of a tighter-binding one, and so needs parentheses.
    inside: BTreeSet<(usize, usize)>,
}

impl<'ast> Visit<'ast> for Sites<'_> {
    fn visit_item_fn(&mut self, item: &'ast syn::ItemFn) {
        self.no_answer(&item.sig, &item.block);
        visit::visit_item_fn(self, item);
    }

    fn visit_impl_item_fn(&mut self, item: &'ast syn::ImplItemFn) {
        self.no_answer(&item.sig, &item.block);
        visit::visit_impl_item_fn(self, item);
    }

    fn visit_expr(&mut self, expression: &'ast Expr) {
        match expression {
            Expr::Binary(binary) if is_arithmetic(&binary.op) => self.sign(expression, true),
            Expr::MethodCall(_) | Expr::Field(_) => self.sign(expression, false),
            Expr::Path(path) if self.variables.holds(path) => self.sign(expression, false),
            _ => {}
        }
        visit::visit_expr(self, expression);
    }

    fn visit_local(&mut self, local: &'ast syn::Local) {
        if let Some(init) = &local.init
            && !matches!(*init.expr, Expr::Tuple(_) | Expr::Array(_))
        {
            self.sign(&init.expr, true);
        }
        visit::visit_local(self, local);
    }

    fn visit_expr_if(&mut self, expression: &'ast syn::ExprIf) {
        self.condition(&expression.cond);
        visit::visit_expr_if(self, expression);
    }

    fn visit_expr_binary(&mut self, expression: &'ast ExprBinary) {
        self.binary(expression);
        visit::visit_expr_binary(self, expression);
    }

    fn visit_expr_unary(&mut self, expression: &'ast syn::ExprUnary) {
        if matches!(expression.op, UnOp::Neg(_) | UnOp::Not(_)) {
            let bare = self.source(&expression.expr).to_owned();
            self.put(expression, bare, Operator::Unary);
        }
        self.hold(&expression.expr);
        visit::visit_expr_unary(self, expression);
    }

    fn visit_expr_lit(&mut self, expression: &'ast syn::ExprLit) {
        let number = match &expression.lit {
            syn::Lit::Float(number) => number.base10_parse(),
            _ => return,
        };
        for other in number.map(other_numbers).unwrap_or_default() {
            self.put(expression, other, Operator::Constant);
        }
    }

    fn visit_expr_path(&mut self, expression: &'ast syn::ExprPath) {
        let Some(name) = expression.path.get_ident().map(ToString::to_string) else {
            return;
        };
        if self.variables.numbers.contains(&name) {
            self.put(expression, "0.0", Operator::Constant);
            self.put(expression, "1.0", Operator::Constant);
        }
        let around: Vec<String> = self.variables.around(&name).into_iter().cloned().collect();
        for other in around {
            self.put(expression, other, Operator::Neighbour);
        }
    }

    fn visit_expr_field(&mut self, expression: &'ast syn::ExprField) {
        if let Member::Named(field) = &expression.member {
            for other in neighbours(&field.to_string()) {
                self.put(field, other, Operator::Neighbour);
            }
        }
    }

    fn visit_expr_method_call(&mut self, expression: &'ast ExprMethodCall) {
        self.method(expression);
        self.hold(&expression.receiver);
        visit::visit_expr_method_call(self, expression);
    }

    fn visit_expr_range(&mut self, expression: &'ast syn::ExprRange) {
        let other = match expression.limits {
            syn::RangeLimits::HalfOpen(_) => "..=",
            syn::RangeLimits::Closed(_) => "..",
        };
        self.put(&expression.limits, other, Operator::Range);
        visit::visit_expr_range(self, expression);
    }

    fn visit_expr_array(&mut self, expression: &'ast syn::ExprArray) {
        self.swap_pairs(expression.elems.iter());
        visit::visit_expr_array(self, expression);
    }

    fn visit_expr_tuple(&mut self, expression: &'ast syn::ExprTuple) {
        self.swap_pairs(expression.elems.iter());
        visit::visit_expr_tuple(self, expression);
    }

    fn visit_expr_struct(&mut self, expression: &'ast syn::ExprStruct) {
        let written = expression
            .fields
            .iter()
            .filter(|field| field.colon_token.is_some());
        self.swap_pairs(written.map(|field| &field.expr));
        visit::visit_expr_struct(self, expression);
    }

    fn visit_expr_match(&mut self, expression: &'ast syn::ExprMatch) {
        self.swap_pairs(expression.arms.iter().map(|arm| &*arm.body));
        visit::visit_expr_match(self, expression);
    }

    fn visit_expr_call(&mut self, expression: &'ast syn::ExprCall) {
        if self.source(&expression.func) == "Some" {
            self.put(expression, "None", Operator::Answer);
        }
        // The function's name is not a variable.
        expression
            .args
            .iter()
            .for_each(|argument| self.visit_expr(argument));
    }
}

/// The bytes of its file that a piece of syntax covers.
fn range(node: &impl Spanned) -> Range<usize> {
    node.span().byte_range()
}
