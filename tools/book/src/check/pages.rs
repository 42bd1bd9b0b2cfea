//! The pages of a built book.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use scraper::{ElementRef, Html, Selector};

use crate::error::{Error, Result};

/// Pages by their path inside the book, without `print.html`, which repeats all of them, and the
/// page for a wrong address.
pub type Pages = BTreeMap<PathBuf, Page>;

/// The parts of a page that are checked.
#[derive(Debug, Default)]
pub struct Page {
    /// Every `id`.
    pub ids: Vec<String>,
    /// Every `href` and `src`.
    pub links: Vec<String>,
    /// The links of its text, and the word after each.
    pub followed: Vec<(String, String)>,
    /// The texts of its headings, the title first.
    pub headings: Vec<String>,
    /// For each image, drawing and canvas: its name, and its alternative text.
    pub images: Vec<(String, Option<String>)>,
    /// Its paragraphs and list items, without formulas and code.
    pub prose: Vec<String>,
    /// Directives that were not expanded.
    pub directives: Vec<String>,
}

/// Files made by mdBook that are not pages of the book.
const OTHER: [&str; 3] = ["print.html", "404.html", "toc.html"];

/// Reads all pages of a folder.
pub fn read(folder: &Path) -> Result<Pages> {
    let mut pages = Pages::new();
    for path in files(folder)? {
        let inside = path.strip_prefix(folder).unwrap_or(&path).to_owned();
        let is_page = path.extension().is_some_and(|end| end == "html");
        if is_page && !OTHER.iter().any(|other| inside == Path::new(other)) {
            let text = fs::read_to_string(&path).map_err(|error| Error::file(&path, &error))?;
            pages.insert(inside, Page::parse(&text));
        }
    }
    Ok(pages)
}

/// Every file of a folder and its subfolders.
pub fn files(folder: &Path) -> Result<Vec<PathBuf>> {
    let mut files = Vec::new();
    let entries = fs::read_dir(folder).map_err(|error| Error::file(folder, &error))?;
    for entry in entries.flatten() {
        match entry.path() {
            path if path.is_dir() => files.extend(self::files(&path)?),
            path => files.push(path),
        }
    }
    files.sort();
    Ok(files)
}

impl Page {
    /// Reads a page's HTML.
    pub fn parse(text: &str) -> Page {
        let html = Html::parse_document(text);
        let select = |selector: &str| Selector::parse(selector).expect("it is written here");
        let mut page = Page::default();
        for element in html.select(&select("[id]")) {
            page.ids.extend(element.attr("id").map(str::to_owned));
        }
        for element in html.select(&select("[href], [src]")) {
            let link = element.attr("href").or(element.attr("src"));
            page.links.extend(link.map(str::to_owned));
        }
        for element in html.select(&select("main a[href]")) {
            let after = element.next_sibling();
            let after = after.and_then(|node| node.value().as_text());
            let word = after.and_then(|text| text.split_whitespace().next());
            if let (Some(link), Some(word)) = (element.attr("href"), word) {
                page.followed.push((link.into(), word.into()));
            }
        }
        for element in html.select(&select("main h1, main h2, main h3, main h4")) {
            page.headings
                .push(element.text().collect::<String>().trim().into());
        }
        for element in html.select(&select("main img, main svg, main canvas")) {
            let named = element.attr("src").unwrap_or(element.value().name());
            let hidden = element.attr("aria-hidden") == Some("true");
            let inside_hidden = element
                .ancestors()
                .filter_map(ElementRef::wrap)
                .any(|outer| {
                    outer.attr("aria-hidden") == Some("true") || outer.value().name() == "button"
                });
            if !hidden && !inside_hidden {
                let text = element.attr("alt").or(element.attr("aria-label"));
                page.images.push((named.into(), text.map(str::to_owned)));
            }
        }
        for element in html.select(&select("main p, main li")) {
            let outside = |node: &ElementRef| matches!(node.value().name(), "code" | "math");
            let words = element.descendants().filter_map(|node| {
                let mut around = node.ancestors().filter_map(ElementRef::wrap);
                let text = node.value().as_text()?;
                (!around.any(|outer| outside(&outer))).then_some(&**text)
            });
            page.prose.push(words.collect());
        }
        for begun in text.split("{{#").skip(1) {
            let directive = begun.split("}}").next().unwrap_or_default();
            page.directives.push(directive.into());
        }
        page
    }
}
