//! A place in the book that helps with a mistake.

use std::fmt;
use std::path::{Path, PathBuf};

use serde::Serialize;

use crate::desktop;
use pinhole_course::checkout::Checkout;
use pinhole_course::diagnosis::Diagnosis;
use pinhole_course::shell::from_here;

/// A chapter of the book, or a section of one. It holds the words that name it, and its page
/// relative to the top of a student's repository. In the course's checkout, pages are in
/// `book/build/student`.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Passage {
    /// The passage in words.
    pub words: String,
    /// The page, with its anchor.
    pub page: String,
}

impl Passage {
    /// A whole chapter.
    pub fn chapter(title: &str) -> Passage {
        Passage {
            words: format!("the book's chapter “{title}”"),
            // The file's name has `_` for each space.
            page: format!("book/{}.html", anchor(title).replace('-', "_")),
        }
    }

    /// A section of a chapter.
    pub fn section(chapter: &str, section: &str) -> Passage {
        let Passage { words, page } = Passage::chapter(chapter);
        Passage {
            words: format!("section “{section}” in {words}"),
            page: format!("{page}#{}", anchor(section)),
        }
    }

    /// Opens the page if there is a desktop, and returns a message about it. `root` is the top
    /// of the checkout, or of a student's repository.
    pub fn open(&self, root: &Path) -> String {
        let Some(book) = built(root) else {
            return match has_sources(root) {
                true => {
                    "the book is not built yet; to build it, run: cargo pinhole book build".into()
                }
                false => "the book is not in this repository: ask your instructor for it".into(),
            };
        };
        let address = format!("{book}{}", self.page.trim_start_matches("book"));
        match desktop::open(&address) {
            true => format!("opened {address}"),
            false => format!("open {address} in a browser"),
        }
    }

    /// The sections that help with these beliefs, each listed once. If there are no beliefs, the
    /// chapter.
    pub fn against(diagnosis: &Diagnosis, chapter: &str) -> Vec<Passage> {
        let mut passages: Vec<Passage> = Vec::new();
        for held in &diagnosis.beliefs {
            let passage = Passage::section(&held.mistake.chapter, &held.mistake.hint.read);
            if !passages.contains(&passage) {
                passages.push(passage);
            }
        }
        match passages.is_empty() {
            true => vec![Passage::chapter(chapter)],
            false => passages,
        }
    }
}

impl Passage {
    /// The file in which to read the passage. In a student's repository, this is the page; in the
    /// course's checkout, it is the chapter's source. `None` if there is no book.
    fn file(&self, root: &Path) -> Option<PathBuf> {
        let (page, _) = self.page.split_once('#').unwrap_or((&self.page, ""));
        let source = Path::new(page).with_extension("md");
        let source = Path::new("book/src").join(source.file_name()?);
        let mut files = [root.join(page), root.join(source)].into_iter();
        files.find(|file| file.is_file())
    }
}

impl fmt::Display for Passage {
    /// In words, with a path that opens from the current folder.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let checkout = Checkout::find().ok();
        match checkout.and_then(|checkout| self.file(checkout.root())) {
            Some(file) => write!(f, "{} ({})", self.words, from_here(&file).display()),
            None => write!(f, "{}", self.words),
        }
    }
}

/// Whether the book can be built here.
pub fn has_sources(root: &Path) -> bool {
    root.join("book/src").is_dir()
}

/// The address of the book in a browser: in a student's repository, or as `book build` leaves it.
pub fn built(root: &Path) -> Option<String> {
    let folders = [root.join("book"), root.join("book/build/student")];
    let has_pages = |folder: &&std::path::PathBuf| folder.join("index.html").is_file();
    folders
        .iter()
        .find(has_pages)
        .map(|it| desktop::address(it))
}

/// A title as an anchor, in mdBook's way.
fn anchor(title: &str) -> String {
    let letter = |c: char| match c {
        c if c.is_whitespace() => Some('-'),
        c if c.is_alphanumeric() || c == '-' || c == '_' => Some(c),
        _ => None,
    };
    title.to_lowercase().chars().filter_map(letter).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use pinhole_course::assignment::Assignment;
    use pinhole_course::diagnosis::known::KnownMistakes;

    #[test]
    fn a_passage_names_the_page_and_its_anchor() {
        let passage = Passage::section("Viewing rays", "Which root counts?");
        assert_eq!(passage.page, "book/viewing_rays.html#which-root-counts");
        assert_eq!(
            passage.words,
            "section “Which root counts?” in the book's chapter “Viewing rays”"
        );
    }

    #[test]
    fn the_path_that_is_printed_opens() {
        let folder = tempfile::tempdir().expect("there is room");
        let passage = Passage::section("Viewing rays", "Which root counts?");
        assert_eq!(passage.file(folder.path()), None);
        for file in ["book/src/viewing_rays.md", "book/viewing_rays.html"] {
            let file = folder.path().join(file);
            std::fs::create_dir_all(file.parent().expect("a folder")).expect("there is room");
            std::fs::write(&file, "").expect("there is room");
            assert_eq!(passage.file(folder.path()), Some(file));
        }
    }

    #[test]
    fn only_a_built_book_has_an_address() {
        let folder = tempfile::tempdir().expect("there is room");
        assert_eq!(built(folder.path()), None);
        for book in ["book/build/student", "book"] {
            let book = folder.path().join(book);
            std::fs::create_dir_all(&book).expect("there is room");
            std::fs::write(book.join("index.html"), "").expect("there is room");
            assert_eq!(built(folder.path()), Some(desktop::address(&book)));
        }
    }

    #[test]
    fn every_task_and_every_known_mistake_refers_to_a_heading_of_the_book() {
        let checkout = Checkout::find().expect("tests run in a checkout");
        let chapters = checkout.root().join("book/src");
        if !chapters.is_dir() {
            return; // A student's repository has the built book at most.
        }
        let assignment = Assignment::read(&checkout, "ray_casting").expect("it is there");
        let known = KnownMistakes::read(&assignment.golden()).expect("it is there");
        let tasks = assignment.tasks.iter().map(|task| (&task.chapter, None));
        let mistakes = known.mistake.values();
        let mistakes = mistakes.map(|mistake| (&mistake.chapter, Some(&mistake.hint.read)));
        for (chapter, section) in tasks.chain(mistakes) {
            let page = Passage::chapter(chapter).page;
            let page = page.replace("book/", "").replace(".html", ".md");
            let text = std::fs::read_to_string(chapters.join(&page)).expect(&page);
            assert!(text.starts_with(&format!("# {chapter}\n")), "{page}");
            if let Some(section) = section {
                assert!(
                    text.contains(&format!("\n## {section}\n")),
                    "{page}: {section}"
                );
            }
        }
    }
}
