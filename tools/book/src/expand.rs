//! Expands the directives of a page.

use std::fmt::Write as _;
use std::fs;
use std::path::Path;
use std::sync::{Arc, Mutex};

use mdbook_preprocessor::book::{Book, BookItem, Chapter};
use mdbook_preprocessor::errors;
use mdbook_preprocessor::{Preprocessor, PreprocessorContext};
use pinhole_course::assignment::Assignment;
use pinhole_course::checkout::Checkout;

use crate::course::assignments;
use crate::directive::Directive;
use crate::edition::Edition;
use crate::error::{Problem, ProblemAndRemedy, Result};
use crate::formula::Formulas;
use crate::html::{escaped, figure};
use crate::run::{self, Runs};
use crate::scan::{Piece, pieces};
use crate::worked::Values;
use crate::{figures, gallery, interactive, listing};

/// The sources that pages quote, read or computed once for both editions.
pub struct Sources {
    checkout: Checkout,
    assignments: Vec<Assignment>,
    formulas: Formulas,
    runs: Runs,
    values: Values,
}

impl Sources {
    /// Reads the sources. The numbers are those of [`worked::values`](crate::worked::values).
    pub fn read(values: Values, checkout: &Checkout) -> Result<Sources> {
        Ok(Sources {
            checkout: checkout.clone(),
            assignments: assignments(checkout)?,
            formulas: Formulas::default(),
            runs: run::read(checkout)?,
            values,
        })
    }
}

/// Expands the pages of one edition, as a preprocessor of mdBook.
pub struct Expand {
    sources: Arc<Sources>,
    edition: Edition,
    problems: Arc<Mutex<Vec<Problem>>>,
}

impl Expand {
    /// Expands for one edition. Adds errors in the pages to `problems`.
    pub fn new(
        sources: Arc<Sources>,
        edition: Edition,
        problems: Arc<Mutex<Vec<Problem>>>,
    ) -> Expand {
        Expand {
            sources,
            edition,
            problems,
        }
    }

    fn keep_own(&self, items: &mut Vec<BookItem>) {
        let own = |chapter: &Chapter| {
            chapter
                .path
                .as_ref()
                .is_none_or(|path| self.edition.has(path))
        };
        items.retain(|item| !matches!(item, BookItem::Chapter(chapter) if !own(chapter)));
        // Remove the title of a part without chapters.
        let mut kept: Vec<BookItem> = Vec::new();
        for item in items.drain(..) {
            let is_title = matches!(item, BookItem::PartTitle(_));
            if is_title && matches!(kept.last(), Some(BookItem::PartTitle(_))) {
                kept.pop();
            }
            kept.push(item);
        }
        if matches!(kept.last(), Some(BookItem::PartTitle(_))) {
            kept.pop();
        }
        *items = kept;
        for item in items {
            if let BookItem::Chapter(chapter) = item {
                self.keep_own(&mut chapter.sub_items);
            }
        }
    }

    /// The page's Markdown with its directives expanded. `path` is the one in `SUMMARY.md`.
    pub fn page(&self, text: &str, path: &Path) -> String {
        let file = Path::new("book/src").join(path);
        let mut problems = self
            .problems
            .lock()
            .expect("no thread panics while adding one");
        let text = match self.edition.lines(text, &file) {
            Ok(lines) => lines,
            Err(problem) => {
                problems.push(problem);
                return String::new();
            }
        };
        let to_root = "../".repeat(path.components().count().saturating_sub(1));
        let mut page = String::new();
        for (line, piece) in pieces(&text) {
            match self.piece(piece, &to_root) {
                Ok(put_in) => page.push_str(&put_in),
                Err((problem, remedy)) => {
                    let _infallible = write!(page, "<mark>{}</mark>", escaped(&problem));
                    problems.push(Problem::at(&file, line, problem, remedy));
                }
            }
        }
        page
    }

    fn piece(
        &self,
        piece: Piece<'_>,
        to_root: &str,
    ) -> std::result::Result<String, ProblemAndRemedy> {
        let formulas = &self.sources.formulas;
        let latex = |problem| (problem, "write plain LaTeX, as in other chapters".into());
        match piece {
            Piece::Text(text) => Ok(text.into()),
            Piece::Inline(text) => formulas.inline(text).map_err(latex),
            Piece::Display(text) => formulas.display(text).map_err(latex),
            Piece::Directive(inside) => self.directive(Directive::parse(inside)?, to_root),
            Piece::Open(opening) => Err((
                format!("`{opening}` is never closed"),
                format!("close it in the same paragraph, or write \\{opening} if it is text"),
            )),
        }
    }

    fn directive(
        &self,
        directive: Directive,
        to_root: &str,
    ) -> std::result::Result<String, ProblemAndRemedy> {
        let Sources {
            checkout,
            assignments,
            runs,
            values,
            ..
        } = &*self.sources;
        match directive {
            Directive::Listing { path, anchor } => {
                listing::listing(&path, &anchor, self.edition, checkout)
            }
            Directive::Value(name) => values.get(&name).cloned().ok_or_else(|| {
                let remedy = "compute it in tools/book/src/worked.rs, or correct the name";
                (format!("there is no value `{name}`"), remedy.into())
            }),
            Directive::Run(id) => {
                let run = runs.get(&id).ok_or_else(|| {
                    let remedy = "add it to book/commands.toml";
                    (format!("there is no command `{id}`"), remedy.into())
                })?;
                let output = fs::read_to_string(run::captured(&id, checkout)).map_err(|_| {
                    let remedy = format!("cargo pinhole book capture {id}");
                    (format!("the output of `{id}` was never captured"), remedy)
                })?;
                Ok(run.shown(&output))
            }
            Directive::Figure {
                name,
                alternative,
                caption,
            } => {
                let shown = figures::shown(&name, &alternative, to_root, checkout)?;
                Ok(figure("figure", &shown, &self.caption(&caption)?))
            }
            Directive::Gallery(task) => {
                match assignments.iter().find(|it| it.task(&task).is_some()) {
                    Some(assignment) => gallery::shown(&task, to_root, assignment, checkout),
                    None => Err((
                        format!("there is no task `{task}`"),
                        "name a task of an assignment.toml".into(),
                    )),
                }
            }
            Directive::Interactive { name, alternative } => {
                interactive::shown(&name, &alternative, to_root, checkout)
            }
        }
    }

    /// A caption, which may hold formulas but no directives.
    fn caption(&self, text: &str) -> std::result::Result<String, ProblemAndRemedy> {
        let put_in = pieces(text).into_iter().map(|(_, piece)| match piece {
            Piece::Directive(_) => Err((
                "a directive in a caption".to_owned(),
                "put it into the text".to_owned(),
            )),
            other => self.piece(other, ""),
        });
        put_in.collect()
    }
}

impl Preprocessor for Expand {
    fn name(&self) -> &str {
        "pinhole"
    }

    fn run(&self, _: &PreprocessorContext, mut book: Book) -> errors::Result<Book> {
        self.keep_own(&mut book.items);
        book.for_each_chapter_mut(|chapter| {
            let path = chapter.source_path.clone().unwrap_or_default();
            chapter.content = self.page(&chapter.content, &path);
        });
        Ok(book)
    }
}
