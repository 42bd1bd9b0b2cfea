//! Renders a report as HTML.

use std::path::Path;

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use hmac_sha256::Hash;
use minijinja::{Environment, HtmlEscape, UndefinedBehavior, context, value::Serde};
use pinhole::false_colour::{self, Difference};
use pinhole::film::HIT_CHANNELS;
use serde_json::{Value, json};

use super::Report;
use super::cause::Cause;
use pinhole_course::{link, output};

const TEMPLATES: [(&str, &str); 9] = [
    ("report.html", include_str!("../../templates/report.html")),
    ("name.html", include_str!("../../templates/name.html")),
    ("task.html", include_str!("../../templates/task.html")),
    ("scene.html", include_str!("../../templates/scene.html")),
    ("beliefs.html", include_str!("../../templates/beliefs.html")),
    ("read.html", include_str!("../../templates/read.html")),
    ("heat.html", include_str!("../../templates/heat.html")),
    ("ray.html", include_str!("../../templates/ray.html")),
    ("tree.html", include_str!("../../templates/tree.html")),
];

/// The style sheet of all pages.
pub const PAGE_CSS: &str = include_str!("../../templates/page.css");

const STYLE: [&str; 2] = [PAGE_CSS, include_str!("../../templates/viewer.css")];

const SCRIPT: [&str; 5] = [
    include_str!("../../templates/unpack.js"),
    include_str!("../../templates/paint.js"),
    include_str!("../../templates/words.js"),
    include_str!("../../templates/reading.js"),
    include_str!("../../templates/viewer.js"),
];

/// Our templates, by name. If a template uses a value that it was not given, that is an error.
///
/// # Panics
/// If a template has a mistake in its syntax.
pub fn environment(templates: &[(&'static str, &'static str)]) -> Environment<'static> {
    let mut environment = Environment::new();
    environment.set_undefined_behavior(UndefinedBehavior::Strict);
    environment.add_filter("code", code);
    for (name, text) in templates {
        environment
            .add_template(name, text)
            .unwrap_or_else(|error| panic!("{name}: {error:#}"));
    }
    environment
}

/// A text as HTML. Whatever is between backquotes becomes code.
fn code(text: &str) -> minijinja::Value {
    let parts = text.split('`').enumerate();
    let parts = parts.map(|(k, part)| match (k % 2, HtmlEscape(part)) {
        (0, words) => words.to_string(),
        (_, code) => format!("<code>{code}</code>"),
    });
    minijinja::Value::from_safe_string(parts.collect())
}

impl Report {
    /// Renders the page.
    pub fn html(&self) -> String {
        let environment = environment(&TEMPLATES);
        // A browser reads line ends as `\n` before it computes the hash.
        let [style, script] =
            [STYLE.concat() + &swatches(), SCRIPT.concat()].map(|text| text.replace('\r', ""));
        let page = environment.get_template("report.html").and_then(|page| {
            page.render(context! {
                report => Serde(self),
                policy => policy(&style, &script),
                palette => for_script(&palette()),
                legend => legend(),
                style,
                script,
            })
        });
        page.unwrap_or_else(|error| panic!("the report's template: {error:#}"))
    }
}

/// Allows only the page's own style and script, by their hashes, so that nothing in a student's
/// text can run or load anything.
pub fn policy(style: &str, script: &str) -> String {
    let hash = |text: &str| STANDARD.encode(Hash::hash(text.as_bytes()));
    format!(
        "default-src 'none'; script-src 'sha256-{}'; style-src 'sha256-{}'; img-src data:; \
         base-uri 'none'; form-action 'none'",
        hash(script),
        hash(style)
    )
}

/// JSON that can't end a `script` element, whatever its strings contain.
pub fn for_script(value: &Value) -> String {
    value.to_string().replace('<', "\\u003c")
}

/// The colours of pictures, so that the script uses the same.
fn palette() -> Value {
    let far = (0..=255).map(|step| false_colour::far(f64::from(step) / 255.0).0);
    let objects = (0..false_colour::OBJECT_COLOURS).map(|id| false_colour::object(id).0);
    let difference = Difference::LEGEND.map(|(kind, _)| kind.colour().0);
    json!({
        "channels": HIT_CHANNELS,
        "causes": Cause::ALL.map(Cause::words),
        "background": false_colour::BACKGROUND.0,
        "objects": objects.collect::<Vec<_>>(),
        "far": far.collect::<Vec<_>>(),
        "difference": difference,
    })
}

/// The colours of difference pictures, for the legend.
fn swatches() -> String {
    let swatch = |(kind, _): (Difference, &str)| {
        let [r, g, b] = kind.colour().0;
        format!(
            ".swatch.{} {{ background: rgb({r} {g} {b}); }}\n",
            class(kind)
        )
    };
    Difference::LEGEND.map(swatch).concat()
}

/// The style sheet's class for a kind of difference.
pub fn class(kind: Difference) -> &'static str {
    match kind {
        Difference::Object => "object",
        Difference::T => "t",
        Difference::Normal => "normal",
    }
}

fn legend() -> Vec<(&'static str, &'static str)> {
    Difference::LEGEND
        .map(|(kind, words)| (class(kind), words))
        .into()
}

/// Writes the page. See [`output`].
pub fn write(path: &Path, page: &str) -> std::io::Result<()> {
    if let Some(folder) = path.parent() {
        if folder.is_relative() {
            link::refuse(folder).map_err(std::io::Error::other)?;
        }
        std::fs::create_dir_all(folder)?;
    }
    output::write(path, page.as_bytes())
}
