//! Searches any file for many texts at once. Even pictures are searched, because they may contain
//! source text too.

use std::collections::HashMap;

/// Texts, indexed by their first bytes.
pub struct Search {
    by_beginning: HashMap<[u8; BEGINNING], Vec<String>>,
}

/// The rest of a text is compared only where this many bytes agree.
const BEGINNING: usize = 8;

impl Search {
    /// Each text must be at least [`BEGINNING`] bytes long.
    pub fn new(texts: impl IntoIterator<Item = String>) -> Search {
        let mut by_beginning: HashMap<_, Vec<String>> = HashMap::new();
        for text in texts {
            let beginning = text.as_bytes().first_chunk();
            let beginning = *beginning.expect("each text has that many bytes");
            by_beginning.entry(beginning).or_default().push(text);
        }
        Search { by_beginning }
    }

    /// The first of the texts that these bytes contain.
    pub fn first_in(&self, bytes: &[u8]) -> Option<&str> {
        (0..bytes.len()).find_map(|at| {
            let rest = &bytes[at..];
            let candidates = self.by_beginning.get(rest.first_chunk::<BEGINNING>()?)?;
            let found = candidates
                .iter()
                .find(|text| rest.starts_with(text.as_bytes()));
            found.map(String::as_str)
        })
    }
}

#[cfg(test)]
mod tests {
    use super::Search;

    #[test]
    fn a_text_is_found_anywhere_in_any_bytes() {
        let search = Search::new(["let root = d".to_owned(), "let root = e".to_owned()]);
        assert_eq!(
            search.first_in(b"\xff\x00let root = e"),
            Some("let root = e")
        );
        assert_eq!(search.first_in(b"let root = d;"), Some("let root = d"));
        assert_eq!(search.first_in(b"let root = f; let root ="), None);
        assert_eq!(search.first_in(b""), None);
    }
}
