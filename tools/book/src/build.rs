//! Builds the book, one edition at a time.

use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex};

use mdbook_driver::MDBook;
use mdbook_driver::config::Config;
use pinhole_course::checkout::Checkout;

use crate::edition::Edition;
use crate::error::{Problem, Result};
use crate::expand::{Expand, Sources};
use crate::interactive;

/// Files that every page loads besides mdBook's own, whose names (such as `book.js`) are already
/// taken. They are written to the book's top folder.
const ASSETS: [(&str, &[u8]); 5] = [
    ("pinhole.css", include_bytes!("../assets/pinhole.css")),
    ("pinhole.js", include_bytes!("../assets/pinhole.js")),
    ("interactive.js", interactive::BUNDLE.as_bytes()),
    (
        "fonts/stix-two-math.woff2",
        include_bytes!("../assets/fonts/stix-two-math-latin-400-normal.woff2"),
    ),
    (
        "fonts/STIX-LICENSE.txt",
        include_bytes!("../assets/fonts/LICENSE"),
    ),
];

/// A built edition.
pub struct BuiltEdition {
    /// The readers that it is for.
    pub edition: Edition,
    /// The folder of its `index.html`.
    pub folder: PathBuf,
    /// Problems in its pages. They are also marked in the pages.
    pub problems: Vec<Problem>,
}

/// Builds an edition into a folder, which is emptied first.
pub fn build(
    sources: &Arc<Sources>,
    edition: Edition,
    folder: &Path,
    checkout: &Checkout,
) -> Result<BuiltEdition> {
    let problems = Arc::new(Mutex::new(Vec::new()));
    let failed = |error: mdbook_driver::errors::Error| {
        Problem::of(
            "book",
            format!("mdBook: {error:#}"),
            "see book.toml and SUMMARY.md",
        )
    };
    let own = checkout.book().join("book.toml");
    let mut config = Config::from_disk(&own).map_err(failed)?;
    config.build.build_dir = folder.into();
    config.build.create_missing = false;
    config.build.use_default_preprocessors = false;
    if edition == Edition::Instructor {
        let title = config.book.title.unwrap_or_default();
        config.book.title = Some(format!("{title} (instructor’s edition)"));
    }
    let theme = Path::new(env!("CARGO_MANIFEST_DIR")).join("assets/theme");
    let quiet = [
        ("output.html.theme", theme.display().to_string().into()),
        ("output.html.hash-files", false.into()),
    ];
    for (key, value) in quiet {
        let value: toml::Value = value;
        config.set(key, value).map_err(failed)?;
    }
    let mut book = MDBook::load_with_config(checkout.book(), config).map_err(failed)?;
    book.with_preprocessor(Expand::new(sources.clone(), edition, problems.clone()));
    book.build().map_err(failed)?;
    for (name, content) in ASSETS {
        checkout.write(folder.join(name), content)?;
    }
    let problems =
        std::mem::take(&mut *problems.lock().expect("no thread panics while adding one"));
    Ok(BuiltEdition {
        edition,
        folder: folder.into(),
        problems,
    })
}
