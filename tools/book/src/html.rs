//! Small pieces of HTML.

/// Text with the characters of HTML escaped, for an element or an attribute.
pub fn escaped(text: &str) -> String {
    text.replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('>', "&gt;")
        .replace('"', "&quot;")
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
