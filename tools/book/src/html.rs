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
