//! The variables of an answer, in the order they are bound.

use syn::visit::Visit;

/// The variables of an answer.
#[derive(Default)]
pub struct Variables {
    /// The variables, in the order they are bound.
    bound: Vec<String>,
    /// Parameters that are numbers.
    pub numbers: Vec<String>,
}

impl<'ast> Visit<'ast> for Variables {
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

impl Variables {
    /// Whether this path names one of them.
    pub fn holds(&self, path: &syn::ExprPath) -> bool {
        let name = path.path.get_ident();
        name.is_some_and(|name| self.bound.iter().any(|bound| name == bound))
    }

    /// The variables bound just before and just after `name`.
    pub fn around(&self, name: &str) -> Vec<&String> {
        let Some(at) = self.bound.iter().position(|bound| bound == name) else {
            return Vec::new();
        };
        let before = at.checked_sub(1).and_then(|at| self.bound.get(at));
        let around = before.into_iter().chain(self.bound.get(at + 1));
        around.filter(|other| *other != name).collect()
    }
}
