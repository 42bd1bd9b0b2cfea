//! Small pieces of HTML.

/// Text with the characters of HTML escaped, for an element or an attribute.
pub fn escaped(text: &str) -> String {
    text.replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('>', "&gt;")
        .replace('"', "&quot;")
}

/// Text as HTML, with what is between backticks as code.
pub fn with_code(text: &str) -> String {
    let mut shown = String::new();
    for (place, part) in text.split('`').enumerate() {
        let part = escaped(part);
        match place % 2 {
            0 => shown.push_str(&part),
            _ => shown.push_str(&format!("<code>{part}</code>")),
        }
    }
    shown
}

/// A figure with a caption; `caption` is Markdown.
pub fn figure(class: &str, content: &str, caption: &str) -> String {
    format!(
        "<figure class=\"{class}\">\n{content}\n<figcaption>\n\n{caption}\n\n</figcaption>\n</figure>\n"
    )
}

/// Words above pictures that are side by side in one file. Hidden from screen readers, because
/// the alternative text says the same.
pub fn heads(words: &[&str]) -> String {
    let columns = words.len();
    let spans: String = words
        .iter()
        .map(|word| format!("<span>{}</span>", escaped(word)))
        .collect();
    format!(
        "<div class=\"heads\" style=\"--columns: {columns}\" aria-hidden=\"true\">{spans}</div>"
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn code_is_what_is_between_backticks() {
        assert_eq!(with_code("a & `b?` c"), "a &amp; <code>b?</code> c");
        assert_eq!(with_code("none"), "none");
    }
}
