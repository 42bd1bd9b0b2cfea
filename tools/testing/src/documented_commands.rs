//! The commands that the documentation prints.

use std::fs;
use std::path::{Path, PathBuf};

use clap::error::ErrorKind;

use crate::root;

/// A command as a page prints it.
#[derive(Clone, Debug)]
pub struct DocumentedCommand {
    /// The page, from the top of the checkout.
    pub page: String,
    /// Its line there, from 1.
    pub line: usize,
    /// Its words. `cargo pinhole` and `pinhole` both become `pinhole`.
    pub words: Vec<String>,
    /// Whether it is in a code block, to be typed as it is. In a sentence, a command may be
    /// incomplete.
    pub is_block: bool,
}

impl DocumentedCommand {
    /// The command in one line.
    pub fn text(&self) -> String {
        self.words.join(" ")
    }
}

/// Checks that a program's command line accepts every documented command that has one of its
/// subcommands, and that there are at least `least` of them. Commands with one of the options in
/// `others` belong to another program.
pub fn assert_all_parse(program: &clap::Command, others: &[&str], least: usize) {
    let subcommands = program.get_subcommands().map(clap::Command::get_name);
    let subcommands: Vec<&str> = subcommands.collect();
    let mut count = 0;
    for command in documented_commands(&subcommands) {
        let words = &command.words;
        let is_own = words[0] == "pinhole" && subcommands.contains(&&*words[1]);
        if !is_own || words.iter().any(|word| others.contains(&&**word)) {
            continue;
        }
        count += 1;
        let Err(error) = program.clone().try_get_matches_from(words) else {
            continue;
        };
        // In a sentence, a command may be incomplete and have a placeholder for a value.
        let is_short = matches!(
            error.kind(),
            ErrorKind::MissingRequiredArgument
                | ErrorKind::MissingSubcommand
                | ErrorKind::DisplayHelpOnMissingArgumentOrSubcommand
                | ErrorKind::InvalidValue
                | ErrorKind::ValueValidation
        );
        let place = format!("{}:{}", command.page, command.line);
        assert!(!command.is_block && is_short, "{place}: {error}");
    }
    assert!(count >= least, "only {count} commands were found");
}

/// Every command in README, CONTRIBUTING, ARCHITECTURE, SECURITY and the book.
///
/// In sentences, these are pieces of code that begin with `cargo` or `pinhole`, or with one
/// of `subcommands` and a space.
pub fn documented_commands(subcommands: &[&str]) -> Vec<DocumentedCommand> {
    let top = [
        "README.md",
        "CONTRIBUTING.md",
        "ARCHITECTURE.md",
        "SECURITY.md",
    ];
    let mut pages: Vec<PathBuf> = top.iter().map(|page| root().join(page)).collect();
    pages.extend(markdown(&root().join("book/src")));
    let mut found = Vec::new();
    for path in pages {
        let page = path.strip_prefix(root()).expect("it lies in the checkout");
        let page = page.to_string_lossy().replace('\\', "/");
        let text = fs::read_to_string(&path).expect("pages are text");
        found.extend(on_page(&page, &text, subcommands));
    }
    found
}

/// The Markdown files in a folder and below.
fn markdown(folder: &Path) -> Vec<PathBuf> {
    let mut found = Vec::new();
    for entry in fs::read_dir(folder).expect("it can be read").flatten() {
        let path = entry.path();
        if path.is_dir() {
            found.extend(markdown(&path));
        } else if path.extension().is_some_and(|end| end == "md") {
            found.push(path);
        }
    }
    found.sort();
    found
}

fn on_page(page: &str, text: &str, subcommands: &[&str]) -> Vec<DocumentedCommand> {
    let mut found = Vec::new();
    // The language of the current block.
    let mut block: Option<&str> = None;
    for (line, number) in text.lines().zip(1..) {
        if let Some(language) = line.trim_start().strip_prefix("```") {
            block = match block {
                None => Some(language),
                Some(_) => None,
            };
            continue;
        }
        let commands: Vec<&str> = match block {
            Some("sh") => line
                .split(" #")
                .take(1)
                .flat_map(|it| it.split("&&"))
                .collect(),
            Some(_) => line.strip_prefix("$ ").into_iter().collect(),
            None => line.split('`').skip(1).step_by(2).collect(),
        };
        for command in commands {
            let mut words: Vec<String> = command.split_whitespace().map(str::to_owned).collect();
            if words.starts_with(&["cargo".into(), "pinhole".into()]) {
                words.remove(0);
            } else if block.is_none() && words.len() > 1 && subcommands.contains(&&*words[0]) {
                words.insert(0, "pinhole".into());
            }
            let is_command = block.is_some()
                || matches!(words.first().map(|it| &**it), Some("cargo" | "pinhole"));
            if is_command && words.len() > 1 || block.is_some() && !words.is_empty() {
                found.push(DocumentedCommand {
                    page: page.into(),
                    line: number,
                    words,
                    is_block: block.is_some(),
                });
            }
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn commands_are_found_in_blocks_and_in_sentences() {
        let page = "Run `cargo pinhole check --watch`, `golden verify` or `cargo test`; not `check`.\n\
                    ```sh\n\
                    cd there && cargo pinhole check   # everything\n\
                    ```\n\
                    ```text\n\
                    $ cargo pinhole diff A B\n\
                    it prints this\n\
                    ```\n";
        let found = on_page("page.md", page, &["check", "golden"]);
        let lines: Vec<(usize, String, bool)> = found
            .iter()
            .map(|it| (it.line, it.text(), it.is_block))
            .collect();
        let expected = [
            (1, "pinhole check --watch", false),
            (1, "pinhole golden verify", false),
            (1, "cargo test", false),
            (3, "cd there", true),
            (3, "pinhole check", true),
            (6, "pinhole diff A B", true),
        ];
        assert_eq!(
            lines,
            expected.map(|(line, text, block)| (line, text.to_owned(), block))
        );
    }
}
