//! Splits an answer's text into tokens, as the compiler does.
//!
//! We don't parse it, because parsers recurse: an answer of 100,000 minus signs would overflow
//! the grader's stack.

use proc_macro2::{LexError, TokenStream, TokenTree};

/// A token. A delimiter is a token of its own.
#[derive(Clone, Debug, PartialEq)]
pub enum Token {
    /// A name or keyword, including `r#` in front of it.
    Word(String),
    /// One character of an operator, or a delimiter. [`PATH`] counts as one character.
    Mark(char),
    /// A number.
    Number,
    /// A string, a character, or bytes.
    Text,
}

/// Stands for `::`; no Rust source has this character outside strings.
pub const PATH: char = '∷';

/// All tokens of a text with their lines, from 1.
///
/// # Errors
/// If it can't be split into tokens.
pub fn tokens(text: &str) -> Result<Vec<(Token, usize)>, LexError> {
    let tokens = text.parse().map(flat);
    // Otherwise, the library would keep every text until this thread ends, because it remembers
    // where tokens are.
    proc_macro2::extra::invalidate_current_thread_spans();
    tokens
}

fn flat(stream: TokenStream) -> Vec<(Token, usize)> {
    // Don't recurse: delimiters may be nested without limit and would overflow the stack.
    let mut flat: Vec<(Token, usize)> = Vec::new();
    let mut open = vec![(stream.into_iter(), None)];
    while let Some((tokens, close)) = open.last_mut() {
        let Some(tree) = tokens.next() else {
            let line = flat.last().map_or(1, |(_, line)| *line);
            flat.extend(close.map(|mark| (Token::Mark(mark), line)));
            open.pop();
            continue;
        };
        let line = tree.span().start().line;
        match tree {
            TokenTree::Ident(word) => {
                flat.push((Token::Word(word.to_string()), line));
            }
            TokenTree::Punct(mark) => match (mark.as_char(), flat.last_mut()) {
                (':', Some((Token::Mark(before @ ':'), _))) => *before = PATH,
                (mark, _) => flat.push((Token::Mark(mark), line)),
            },
            TokenTree::Literal(literal) => {
                let is_number = literal
                    .to_string()
                    .starts_with(|c: char| c.is_ascii_digit());
                flat.push((
                    if is_number {
                        Token::Number
                    } else {
                        Token::Text
                    },
                    line,
                ));
            }
            TokenTree::Group(group) => {
                let (begin, end) = match group.delimiter() {
                    proc_macro2::Delimiter::Parenthesis => ('(', ')'),
                    proc_macro2::Delimiter::Bracket => ('[', ']'),
                    proc_macro2::Delimiter::Brace => ('{', '}'),
                    proc_macro2::Delimiter::None => (' ', ' '),
                };
                flat.push((Token::Mark(begin), line));
                open.push((group.stream().into_iter(), Some(end)));
            }
        }
    }
    flat
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    #[cfg(target_os = "linux")]
    fn texts_are_not_kept_in_memory() {
        let pages = || -> usize {
            let text = std::fs::read_to_string("/proc/self/statm").expect("Linux has it");
            let pages = text.split_whitespace().nth(1).expect("a second number");
            pages.parse().expect("a number")
        };
        let text = "\n".repeat(250_000);
        let before = pages();
        for _ in 0..100 {
            assert_eq!(tokens(&text).expect("they are tokens").len(), 0);
        }
        let more = pages().saturating_sub(before);
        // Other tests of this program run at the same time.
        assert!(more * 4 < 100 << 10, "{} KiB are kept", more * 4);
    }
}
