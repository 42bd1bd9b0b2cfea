//! Untrusted text made safe to show in a terminal.

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
