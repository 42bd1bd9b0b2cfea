//! Untrusted text made safe to show in a terminal or a spreadsheet.

use pinhole_course::shell::in_shell;

/// One line of untrusted text, made safe for a terminal.
///
/// ```
/// use pinhole_report::escape::printable;
///
/// assert_eq!(printable("red: \u{1b}[31m"), r"red: \u{1b}[31m");
/// ```
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

/// One cell of a table, made safe for a terminal and for a spreadsheet, which could take a name for
/// a formula. If the spreadsheet splits cells at semicolons, there may be a formula after a
/// semicolon, too, perhaps in quotes.
///
/// ```
/// use pinhole_report::escape::printable_cell;
///
/// assert_eq!(printable_cell("=1+1"), "'=1+1");
/// ```
pub fn printable_cell(cell: &str) -> String {
    let cell = printable(cell);
    let is_blank = |c: char| c.is_whitespace() || c == '"';
    let part = |part: &str| match part.trim_start_matches(is_blank).starts_with(is_formulas) {
        true => format!("'{part}"),
        false => part.to_owned(),
    };
    cell.split(';').map(part).collect::<Vec<_>>().join(";")
}

/// Whether a formula may begin with this character. Full-width characters count too.
fn is_formulas(c: char) -> bool {
    "=+-@|＝＋－＠｜".contains(c)
}

/// The compiler's messages, line by line. Its colours are kept, but no code that hides text.
pub fn printable_coloured(text: &str) -> String {
    text.lines()
        .map(|line| printable_coloured_line(line) + "\n")
        .collect()
}

fn printable_coloured_line(line: &str) -> String {
    let mut safe = String::new();
    for (k, part) in line.split('\u{1b}').enumerate() {
        let colour = part.strip_prefix('[').and_then(|rest| rest.split_once('m'));
        let is_kept = |code: &str| match code.as_bytes() {
            b"0" | b"1" => true,
            [b'3' | b'9', colour] => (b'1'..=b'7').contains(colour),
            _ => false,
        };
        match colour.filter(|(code, _)| k > 0 && is_kept(code)) {
            Some((code, rest)) => {
                safe.push_str(&format!("\u{1b}[{code}m"));
                safe.push_str(&printable(rest));
            }
            None => safe.push_str(&printable(part)),
        }
    }
    if safe.contains('\u{1b}') {
        safe.push_str("\u{1b}[0m");
    }
    safe
}

/// Characters that reorder or hide the characters beside them, or cannot be seen: those with
/// Unicode's property Default_Ignorable_Code_Point (DerivedCoreProperties.txt, 17.0), the separators
/// of lines and paragraphs, the marks of interlinear annotations, and noncharacters, which HTML doesn't
/// allow.
fn is_invisible(c: char) -> bool {
    matches!(c,
        '\u{ad}' | '\u{34f}' | '\u{61c}' | '\u{115f}'..='\u{1160}' | '\u{17b4}'..='\u{17b5}'
        | '\u{180b}'..='\u{180f}' | '\u{200b}'..='\u{200f}' | '\u{2028}'..='\u{202e}'
        | '\u{2060}'..='\u{206f}' | '\u{3164}' | '\u{fe00}'..='\u{fe0f}' | '\u{feff}'
        | '\u{fdd0}'..='\u{fdef}' | '\u{ffa0}' | '\u{fff0}'..='\u{fffb}' | '\u{1bca0}'..='\u{1bca3}'
        | '\u{1d173}'..='\u{1d17a}' | '\u{e0000}'..='\u{e0fff}')
        || u32::from(c) & 0xfffe == 0xfffe
}

/// A JSON document in which every character that could harm a terminal is written as an escape of
/// the same meaning.
pub fn printable_json(document: &str) -> String {
    let mut safe = String::with_capacity(document.len());
    let mut rest = document;
    // Such characters occur only in strings. Control characters below U+0020 are escaped already.
    let is_unsafe = |c: char| is_invisible(c) || matches!(c, '\u{7f}'..='\u{9f}');
    let is_plain = |c: char| c.is_ascii() && c != '\u{7f}';
    while let Some(at) = rest.find(|c| !is_plain(c) && is_unsafe(c)) {
        let (before, after) = rest.split_at(at);
        safe.push_str(before);
        let mut characters = after.chars();
        let mut units = [0; 2];
        for unit in characters
            .next()
            .map(|c| c.encode_utf16(&mut units))
            .into_iter()
            .flatten()
        {
            safe.push_str(&format!("\\u{unit:04x}"));
        }
        rest = characters.as_str();
    }
    safe.push_str(rest);
    safe
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_cell_is_a_formula_or_holds_a_control_character() {
        for cell in [
            "=1+1",
            " =1",
            "+1",
            "-1",
            "@A1",
            "\t=1",
            "\r=1",
            "＝1+1",
            "＋1",
            "－1",
            "＠x",
            "\u{a0}=1",
            "\u{3000}=1",
            "|calc",
            "x;=HYPERLINK(\"http\",\"a\")",
            "x; =1",
            "x;\"=1+1;y",
        ] {
            let safe = printable_cell(cell);
            let is_skipped = |c: char| c.is_whitespace() || c == '"';
            let is_formula =
                |part: &str| part.trim_start_matches(is_skipped).starts_with(is_formulas);
            assert!(!safe.split(';').any(is_formula), "{safe}");
            assert!(!safe.contains(char::is_control), "{safe}");
        }
        assert_eq!(printable_cell("Ada; Bob"), "Ada; Bob");
    }

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
    fn invisible_characters_are_shown_by_number() {
        for c in
            "\u{ad}\u{61c}\u{180e}\u{200b}\u{202e}\u{3164}\u{fe0f}\u{feff}\u{fffe}\u{e0001}".chars()
        {
            let shown = printable(&format!("a{c}b"));
            assert!(!shown.contains(c), "{shown:?}");
            assert_eq!(shown, format!("a{}b", c.escape_unicode()));
            let json = serde_json::to_string(&format!("a{c}b")).expect("it is text");
            let safe = printable_json(&json);
            assert!(safe.is_ascii(), "{safe:?}");
            let read: String = serde_json::from_str(&safe).expect("it is JSON");
            assert_eq!(read, format!("a{c}b"));
        }
        assert_eq!(printable("Zoë, 李"), "Zoë, 李");
    }

    #[test]
    fn compilers_text_keeps_its_lines_and_colours_and_nothing_else() {
        assert_eq!(
            printable_coloured("\u{1b}[1m\u{1b}[91merror\n\u{1b}[8m\u{1b}[2J\u{1b}]0;title\u{7}"),
            "\u{1b}[1m\u{1b}[91merror\u{1b}[0m\n[8m[2J]0;title\\u{7}\n"
        );
    }
}
