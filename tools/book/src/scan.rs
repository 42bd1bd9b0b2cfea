//! Splits a page into directives, formulas, and Markdown that stays as it is.
//!
//! Skips everything that Markdown shows as code: a `$` or a `{{#` in a code block or a code span
//! is text.

/// A part of a page.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Piece<'a> {
    /// Markdown, code included.
    Text(&'a str),
    /// The text between `{{#` and `}}`.
    Directive(&'a str),
    /// LaTeX between two `$`.
    Inline(&'a str),
    /// LaTeX between two `$$`.
    Display(&'a str),
    /// Something that is opened and never closed; holds what opens it.
    Open(&'static str),
}

/// The parts of a page in order, each with the number of its first line.
pub fn pieces(page: &str) -> Vec<(usize, Piece<'_>)> {
    let mut scan = Scan {
        page,
        at: 0,
        text_from: 0,
        pieces: Vec::new(),
    };
    while scan.at < page.len() {
        scan.step();
    }
    scan.flush();
    scan.pieces
}

struct Scan<'a> {
    page: &'a str,
    at: usize,
    text_from: usize,
    pieces: Vec<(usize, Piece<'a>)>,
}

impl<'a> Scan<'a> {
    fn step(&mut self) {
        let rest = &self.page[self.at..];
        let begins_line = self.page[..self.at]
            .rsplit('\n')
            .next()
            .is_some_and(|before| before.trim().is_empty());
        let ticks = rest.len() - rest.trim_start_matches('`').len();
        if begins_line && ticks >= 3 {
            self.at += fenced(rest, ticks);
        } else if ticks > 0 {
            self.at += span(rest, ticks);
        } else if let Some(after) = rest.strip_prefix('\\') {
            let escaped = after.chars().next().map_or(0, char::len_utf8);
            self.at += 1 + escaped;
        } else if let Some(inside) = rest.strip_prefix("{{#") {
            let line = &inside[..inside.find('\n').unwrap_or(inside.len())];
            self.piece("{{#", line.find("}}"), "}}", Piece::Directive);
        } else if let Some(inside) = rest.strip_prefix("$$") {
            self.piece("$$", paragraph(inside).find("$$"), "$$", Piece::Display);
        } else if let Some(inside) = rest.strip_prefix('$') {
            self.piece("$", paragraph(inside).find('$'), "$", Piece::Inline);
        } else {
            self.at += rest.chars().next().map_or(1, char::len_utf8);
        }
    }

    fn piece(
        &mut self,
        open: &'static str,
        length: Option<usize>,
        close: &str,
        piece: fn(&'a str) -> Piece<'a>,
    ) {
        self.flush();
        let line = self.line(self.at);
        self.at += open.len();
        match length {
            Some(length) => {
                let inside = &self.page[self.at..self.at + length];
                self.pieces.push((line, piece(inside)));
                self.at += length + close.len();
            }
            None => self.pieces.push((line, Piece::Open(open))),
        }
        self.text_from = self.at;
    }

    fn flush(&mut self) {
        if self.text_from < self.at {
            let line = self.line(self.text_from);
            let text = &self.page[self.text_from..self.at];
            self.pieces.push((line, Piece::Text(text)));
        }
        self.text_from = self.at;
    }

    fn line(&self, at: usize) -> usize {
        1 + self.page[..at].matches('\n').count()
    }
}

/// The length of a code block that begins with this many backticks.
fn fenced(rest: &str, ticks: usize) -> usize {
    let mut length = 0;
    for (number, line) in rest.split_inclusive('\n').enumerate() {
        length += line.len();
        let bare = line.trim();
        if number > 0 && bare.len() >= ticks && bare.chars().all(|c| c == '`') {
            break;
        }
    }
    length
}

/// The length of a code span that begins with this many backticks. If it has no end, the length
/// of the backticks alone, because Markdown then shows them as text.
fn span(rest: &str, ticks: usize) -> usize {
    let mut at = ticks;
    let end = paragraph(rest).len();
    while let Some(found) = rest[at..end].find('`') {
        let from = at + found;
        let run = rest[from..end].len() - rest[from..end].trim_start_matches('`').len();
        at = from + run;
        if run == ticks {
            return at;
        }
    }
    ticks
}

/// The text before the next empty line.
fn paragraph(rest: &str) -> &str {
    &rest[..rest.find("\n\n").unwrap_or(rest.len())]
}

#[cfg(test)]
mod tests {
    use super::Piece::*;
    use super::*;

    #[test]
    fn formulas_directives_and_text_are_separated_with_their_lines() {
        let page = "a $x$ b\n{{#value t}}\n$$y\nz$$\n";
        let expected = vec![
            (1, Text("a ")),
            (1, Inline("x")),
            (1, Text(" b\n")),
            (2, Directive("value t")),
            (2, Text("\n")),
            (3, Display("y\nz")),
            (4, Text("\n")),
        ];
        assert_eq!(pieces(page), expected);
    }

    #[test]
    fn code_is_left_alone() {
        for page in [
            "`$x$ {{#value t}}`",
            "``a ` $x$``",
            "```sh\n$ cargo run\n{{#value t}}\n```\n",
            "price: \\$5",
            "- a\n  ````text\n  ```\n  $x$\n  ````\n",
        ] {
            assert_eq!(pieces(page), vec![(1, Text(page))], "{page}");
        }
    }

    #[test]
    fn unclosed_part_is_reported_at_its_beginning() {
        let open = |page| {
            pieces(page)
                .into_iter()
                .find(|(_, piece)| matches!(piece, Open(_)))
        };
        assert_eq!(open("a\nb $x\n\n$"), Some((2, Open("$"))));
        assert_eq!(open("a\n\n$$x\n"), Some((3, Open("$$"))));
        assert_eq!(open("{{#value t\n}}"), Some((1, Open("{{#"))));
    }
}
