//! Walks through an answer and writes down every change at every place.

use std::collections::BTreeSet;
use std::ops::Range;

use syn::spanned::Spanned;
use syn::visit::{self, Visit};
use syn::{Expr, ExprBinary, ExprMethodCall, Member, UnOp};

use super::operators::{
    detours, is_arithmetic, is_logical, is_one_sided, may_be_forgotten, neighbours, other_methods,
    other_numbers, others,
};
use super::{Edit, Operator};

/// Every change of every function in a file.
pub fn edits(file: &syn::File, text: &str) -> Vec<Edit> {
    let mut names = Names::default();
    names.visit_file(file);
    let mut sites = Sites {
        text,
        names,
        edits: Vec::new(),
        inside: BTreeSet::new(),
    };
    sites.visit_file(file);
    sites.edits
}

/// The variables of an answer.
#[derive(Default)]
struct Names {
    /// In the order they are bound.
    bound: Vec<String>,
    /// Parameters that are numbers.
    numbers: Vec<String>,
}

impl<'ast> Visit<'ast> for Names {
    fn visit_pat_ident(&mut self, pattern: &'ast syn::PatIdent) {
        self.bound.push(pattern.ident.to_string());
    }

    fn visit_pat_type(&mut self, typed: &'ast syn::PatType) {
        if let (syn::Pat::Ident(pattern), syn::Type::Path(path)) = (&*typed.pat, &*typed.ty)
            && path.path.is_ident("f64")
        {
            self.numbers.push(pattern.ident.to_string());
        }
    }
}

impl Names {
    fn holds(&self, path: &syn::ExprPath) -> bool {
        let name = path.path.get_ident();
        name.is_some_and(|name| self.bound.iter().any(|bound| name == bound))
    }

    /// What is bound just before and just after `name`.
    fn around(&self, name: &str) -> Vec<&String> {
        let Some(at) = self.bound.iter().position(|bound| bound == name) else {
            return Vec::new();
        };
        let before = at.checked_sub(1).and_then(|at| self.bound.get(at));
        let around = before.into_iter().chain(self.bound.get(at + 1));
        around.filter(|other| *other != name).collect()
    }
}

struct Sites<'a> {
    text: &'a str,
    names: Names,
    edits: Vec<Edit>,
    /// Where an expression is part of a closer-binding one and so needs parentheses.
    inside: BTreeSet<(usize, usize)>,
}

impl Sites<'_> {
    fn source(&self, node: &impl Spanned) -> &str {
        &self.text[range(node)]
    }

    fn put(&mut self, node: &impl Spanned, text: impl Into<String>, operator: Operator) {
        self.replace(range(node), text, operator);
    }

    fn replace(&mut self, range: Range<usize>, text: impl Into<String>, operator: Operator) {
        self.edits.push(Edit {
            range,
            text: text.into(),
            operator,
        });
    }

    fn hold(&mut self, node: &impl Spanned) {
        let Range { start, end } = range(node);
        self.inside.insert((start, end));
    }

    /// As it is, or in parentheses if it stands inside a closer-binding expression.
    fn closed(&self, node: &impl Spanned, text: String) -> String {
        let Range { start, end } = range(node);
        match self.inside.contains(&(start, end)) {
            true => format!("({text})"),
            false => text,
        }
    }

    /// The source of what is to be part of a closer-binding expression.
    fn operand(&self, expression: &Expr) -> String {
        match expression {
            Expr::Binary(_) | Expr::Range(_) | Expr::Cast(_) => {
                format!("({})", self.source(expression))
            }
            _ => self.source(expression).to_owned(),
        }
    }

    /// The source of what is to be asked for a method.
    fn receiver(&self, expression: &Expr) -> String {
        match expression {
            Expr::Unary(_) => format!("({})", self.source(expression)),
            _ => self.operand(expression),
        }
    }

    /// −x for x; |x| and −|x| too where `absolute` says so.
    fn sign(&mut self, expression: &Expr, absolute: bool) {
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

    /// Always, never, and the other way round.
    fn condition(&mut self, expression: &impl Spanned) {
        self.put(expression, "true", Operator::Relation);
        self.put(expression, "false", Operator::Relation);
        let source = self.source(expression);
        if !source.starts_with('!') {
            let negated = format!("!({source})");
            self.put(expression, negated, Operator::Unary);
        }
    }

    /// Each pair of neighbours for each other.
    fn swap_pairs<'e>(&mut self, elements: impl Iterator<Item = &'e Expr>) {
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
            Expr::Path(path) if self.names.holds(path) => self.sign(expression, false),
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
        let ExprBinary {
            left, op, right, ..
        } = expression;
        // Comparisons and logic bind less than any operand here.
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
        if self.names.numbers.contains(&name) {
            self.put(expression, "0.0", Operator::Constant);
            self.put(expression, "1.0", Operator::Constant);
        }
        let around: Vec<String> = self.names.around(&name).into_iter().cloned().collect();
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
        // The function's name is no variable.
        expression
            .args
            .iter()
            .for_each(|argument| self.visit_expr(argument));
    }
}

impl Sites<'_> {
    /// `None` for the whole body of a function that may say so.
    fn no_answer(&mut self, signature: &syn::Signature, block: &syn::Block) {
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

/// Where a piece of syntax stands in its file, in bytes.
fn range(node: &impl Spanned) -> Range<usize> {
    node.span().byte_range()
}
