//! The attributes and macros that an answer may use. All others are refused before anything is
//! compiled, because they can hold machine code, name linker sections, or make the compiler read
//! files.
//!
//! The list says what is allowed and not what is forbidden, because a new compiler may add
//! something that we don't know. It is reliable only if each name has its usual meaning, so
//! answers may not define macros, rename anything to a name on the list, or use raw names. The
//! sandbox does not rely on any of this.

use super::tokens::{PATH, Token, tokens};

/// The allowed macros. Each expands to code that any function may hold.
const MACROS: [&str; 29] = [
    "assert",
    "assert_eq",
    "assert_ne",
    "cfg",
    "column",
    "concat",
    "dbg",
    "debug_assert",
    "debug_assert_eq",
    "debug_assert_ne",
    "eprint",
    "eprintln",
    "file",
    "format",
    "format_args",
    "line",
    "matches",
    "module_path",
    "panic",
    "print",
    "println",
    "stringify",
    "thread_local",
    "todo",
    "unimplemented",
    "unreachable",
    "vec",
    "write",
    "writeln",
];

/// The allowed attributes. None names a file, a symbol or a section.
const ATTRIBUTES: [&str; 21] = [
    "allow",
    "cfg",
    "cold",
    "default",
    "deny",
    "deprecated",
    "derive",
    "doc",
    "expect",
    "forbid",
    "ignore",
    "inline",
    "must_use",
    "non_exhaustive",
    "repr",
    "rustfmt",
    "should_panic",
    "test",
    "track_caller",
    "warn",
    "clippy",
];

/// Keywords. No macro can have a keyword's name, so `return !(a && b)` calls none.
const KEYWORDS: [&str; 39] = [
    "Self", "as", "async", "await", "break", "const", "continue", "crate", "dyn", "else", "enum",
    "extern", "false", "fn", "for", "if", "impl", "in", "let", "loop", "match", "mod", "move",
    "mut", "pub", "ref", "return", "self", "static", "struct", "super", "trait", "true", "type",
    "unsafe", "use", "where", "while", "yield",
];

/// The result of checking an answer's text.
#[derive(Debug, PartialEq)]
pub enum Verdict {
    /// It uses only what is allowed.
    Allowed,
    /// It uses something else: the message, worded like one of the compiler's.
    Refused(String),
    /// We can't split it into tokens. That is fine only if the compiler can't either.
    NotTokens,
}

/// Checks an answer's text. Messages name its file by this path.
pub fn verdict(file: &str, text: &str) -> Verdict {
    let refused = |what: &str, line: usize, remedy: &str| {
        Verdict::Refused(format!(
            "error: {what} is not allowed in an answer\n --> {file}:{line}\n  = help: \
             {remedy}\n"
        ))
    };
    let bare = text.trim_start_matches('\u{feff}');
    // The compiler skips such a line, and with it the beginning of a comment.
    if bare.starts_with("#!") && !bare.starts_with("#![") {
        return refused("a first line that begins with `#!`", 1, "remove this line");
    }
    // Frontmatter: a newer compiler may skip it, and then we would not see the same tokens.
    if bare.trim_start().starts_with("---") {
        return refused("a first line that begins with `---`", 1, "remove this line");
    }
    let Ok(tokens) = tokens(text) else {
        return Verdict::NotTokens;
    };
    for at in 0..tokens.len() {
        // After an apostrophe, a word is the name of a loop or of a lifetime.
        let is_label = at > 0 && tokens[at - 1].0 == Token::Mark('\'');
        if let Some((what, remedy)) = finding(&tokens[at..]).filter(|_| !is_label) {
            return refused(&what, tokens[at].1, remedy);
        }
    }
    Verdict::Allowed
}

/// What is wrong at the beginning of these tokens, and what to do about it.
pub(super) fn finding(tokens: &[(Token, usize)]) -> Option<(String, &'static str)> {
    let token = |at: usize| tokens.get(at).map(|(token, _)| token);
    let is = |at: usize, mark: char| token(at) == Some(&Token::Mark(mark));
    match token(0)? {
        Token::Word(word) if word.starts_with("r#") => {
            Some((format!("`{}`", beginning(word)), "use a name without `r#`"))
        }
        Token::Word(word) if word == "as" => match token(1) {
            Some(Token::Word(new)) if is_listed(new) => Some((
                format!("another meaning of `{new}`"),
                "use another name after `as`",
            )),
            _ => None,
        },
        Token::Word(word) if KEYWORDS.contains(&word.as_str()) => None,
        Token::Word(word) if is(1, '!') && opens(token(2)) && !contains(&MACROS, word) => {
            let remedy = match word.as_str() {
                "macro_rules" => "write a function in its place",
                _ => "use functions, and only common macros such as `assert!`",
            };
            Some((format!("`{}!`", beginning(word)), remedy))
        }
        Token::Mark('#') => {
            let name = 2 + usize::from(is(1, '!'));
            let word = match token(name) {
                Some(Token::Word(word)) if is(name - 1, '[') => word,
                _ => return Some(("`#`".into(), "remove it")),
            };
            let is_tool = ["clippy", "rustfmt"].contains(&word.as_str());
            let is_allowed = contains(&ATTRIBUTES, word) && is(name + 1, PATH) == is_tool;
            (!is_allowed).then(|| (format!("`#[{}]`", beginning(word)), "remove the attribute"))
        }
        _ => None,
    }
}

/// The part of a word that a message shows. A hostile answer may be one long word, and its results
/// repeat the message for each group.
fn beginning(word: &str) -> &str {
    &word[..word.floor_char_boundary(100)]
}

fn opens(token: Option<&Token>) -> bool {
    matches!(token, Some(Token::Word(_) | Token::Mark('(' | '[' | '{')))
}

fn is_listed(word: &str) -> bool {
    contains(&MACROS, word) || contains(&ATTRIBUTES, word)
}

fn contains(list: &[&str], word: &str) -> bool {
    list.contains(&word)
}

#[cfg(test)]
mod tests;
