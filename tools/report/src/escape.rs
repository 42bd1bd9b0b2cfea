//! Untrusted text made safe to show in a terminal.

use pinhole_course::shell::in_shell;

/// One line of somebody else's text, safe to show in a terminal.
pub fn printable(text: &str) -> String {
    let safe = |c: char| match c {
        '\n' => "⏎ ".into(),
        '\t' => " ".into(),
        c if c.is_control() || is_invisible(c) => c.escape_unicode().to_string(),
        c => c.to_string(),
    };
    text.chars().map(safe).collect()
}

/// One word of a command line that people can copy from a terminal or a page.
pub fn printable_word(word: &str) -> String {
    printable(&in_shell(word))
}

/// The compiler's words, line by line; its colours pass.
pub fn printable_coloured(text: &str) -> String {
    text.lines()
        .map(|line| printable_coloured_line(line) + "\n")
        .collect()
}

fn printable_coloured_line(line: &str) -> String {
    let mut safe = String::new();
    for (k, part) in line.split('\u{1b}').enumerate() {
        let colour = part.strip_prefix('[').and_then(|rest| rest.split_once('m'));
        let is_code = |code: &str| code.chars().all(|c| c.is_ascii_digit() || c == ';');
        match colour.filter(|(code, _)| k > 0 && is_code(code)) {
            Some((code, rest)) => {
                safe.push_str(&format!("\u{1b}[{code}m"));
                safe.push_str(&printable(rest));
            }
            None => safe.push_str(&printable(part)),
        }
    }
    safe
}

/// Characters that reorder or hide their neighbours.
fn is_invisible(c: char) -> bool {
    matches!(c, '\u{200b}'..='\u{200f}' | '\u{202a}'..='\u{202e}' | '\u{2060}'..='\u{2069}' | '\u{feff}')
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_word_of_a_command_is_quoted_and_holds_no_control_character() {
        assert_eq!(printable_word("a/b.exr"), "a/b.exr");
        assert_eq!(printable_word("it's"), "'it'\\''s'");
        assert_eq!(
            printable_word("a\u{1b}[2J\u{202e}\nrm"),
            "'a\\u{1b}[2J\\u{202e}⏎ rm'"
        );
    }

    #[test]
    fn compilers_text_keeps_its_lines_and_colours_and_nothing_else() {
        assert_eq!(
            printable_coloured("\u{1b}[1;31merror\u{1b}[0m\n\u{1b}[2J\u{1b}]0;title\u{7}"),
            "\u{1b}[1;31merror\u{1b}[0m\n[2J]0;title\\u{7}\n"
        );
    }
}
