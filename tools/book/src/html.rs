//! Small pieces of HTML.

/// Text that stands for itself, in an element or an attribute.
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

/// Words above pictures that stand beside each other in one file; its alternative text
/// says the same.
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
