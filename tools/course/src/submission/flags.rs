//! Finds parts of an answer that an instructor may want to look at: everything that the allow
//! list refuses, and uses of files, processes, the network or the environment. A flag costs no
//! points.
//!
//! Comments and strings are not mistaken for code, and the insides of macros are searched too.

use serde::{Deserialize, Serialize};

use super::tokens::{PATH, Token, tokens};
use super::{Submission, allow_list};

/// One thing to look at.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct Flag {
    /// The task whose file it is.
    pub task: String,
    /// The line in the task's file, from 1.
    pub line: usize,
    /// What was found, as the code names it.
    pub what: String,
}

/// The most flags that are listed for one answer.
const MOST_FLAGS: usize = 50;

/// More numbers than this look like a table of results.
const MOST_NUMBERS: usize = 300;

/// Modules of the standard library that reach outside the program or circumvent its types.
const MODULES: [&str; 11] = [
    "fs",
    "process",
    "net",
    "env",
    "thread",
    "os",
    "io",
    "arch",
    "intrinsics",
    "ptr",
    "backtrace",
];

/// Modules of the harness that no answer needs.
const HARNESS: [&str; 13] = [
    "ask", "job", "serve", "judge", "film", "Film", "kind", "Kind", "oiiotool", "scene", "Scene",
    "mesh", "AnswerFn",
];

/// All flags of a submission, in the order of its answers.
pub fn flags(submission: &Submission) -> Vec<Flag> {
    let answers = submission.answers.iter();
    let texts = answers.filter_map(|answer| Some((&answer.task, answer.text.as_ref().ok()?)));
    texts.flat_map(|(task, text)| of_text(task, text)).collect()
}

/// The flags of one answer.
pub fn of_text(task: &str, text: &str) -> Vec<Flag> {
    // The compiler also refuses a text that can't be split into tokens.
    let tokens = tokens(text).unwrap_or_default();
    let mut found = Finder {
        task,
        flags: Vec::new(),
    };
    found.look(&tokens);
    let mut flags = found.flags;
    flags.dedup();
    flags.truncate(MOST_FLAGS);
    flags
}

struct Finder<'a> {
    task: &'a str,
    flags: Vec<Flag>,
}

impl Finder<'_> {
    fn flag(&mut self, line: usize, what: impl Into<String>) {
        self.flags.push(Flag {
            task: self.task.into(),
            line,
            what: what.into(),
        });
    }

    fn look(&mut self, tokens: &[(Token, usize)]) {
        let mut path = Paths::default();
        let mut numbers = 0;
        for (at, (token, line)) in tokens.iter().enumerate() {
            let before = |steps: usize| Some(&tokens.get(at.checked_sub(steps)?)?.0);
            let after = |steps: usize| Some(&tokens.get(at + steps)?.0);
            if let Some((what, _)) = allow_list::finding(&tokens[at..]) {
                self.flag(*line, what.replace('`', ""));
            }
            match token {
                Token::Word(word) => {
                    self.word(word, *line, &before, &after);
                    let named = path.word(word, before(1) == Some(&Token::Mark(PATH)));
                    self.path(named, *line, after(1));
                }
                Token::Mark(mark) => {
                    path.mark(*mark, before(1) == Some(&Token::Mark(PATH)));
                    let named = path.current.as_slice();
                    if *mark == '*' && matches!(named, [root] if is_library(root)) {
                        self.flag(*line, format!("{}::*", named[0]));
                    }
                }
                Token::Number => numbers += 1,
                Token::Text => {}
            }
        }
        if numbers > MOST_NUMBERS {
            self.flag(1, format!("{numbers} number literals"));
        }
    }

    fn word<'t>(
        &mut self,
        word: &str,
        line: usize,
        before: &dyn Fn(usize) -> Option<&'t Token>,
        after: &dyn Fn(usize) -> Option<&'t Token>,
    ) {
        let is = |token: Option<&Token>, mark| token == Some(&Token::Mark(mark));
        match word {
            "unsafe" | "extern" => self.flag(line, word),
            "thread_local" if is(after(1), '!') => self.flag(line, "thread_local!"),
            "transmute" => self.flag(line, "transmute"),
            "mut" if before(1) == Some(&Token::Word("static".into())) => {
                self.flag(line, "static mut");
            }
            "mod" if is(after(2), ';') => self.flag(line, "mod of another file"),
            _ => {}
        }
    }

    fn path(&mut self, named: &[&str], line: usize, after: Option<&Token>) {
        match named {
            [root] if is_library(root) && after == Some(&Token::Word("as".into())) => {
                self.flag(line, format!("{root} by another name"));
            }
            [root, module] if is_library(root) && MODULES.contains(module) => {
                self.flag(line, format!("{root}::{module}"));
            }
            [root, module] if *root == "pinhole" && HARNESS.contains(module) => {
                self.flag(line, format!("{root}::{module}"));
            }
            _ => {}
        }
    }
}

fn is_library(root: &str) -> bool {
    ["std", "core", "alloc"].contains(&root)
}

/// The keywords that may come before a path that begins with `::`.
const KEYWORDS: [&str; 10] = [
    "use", "pub", "as", "in", "return", "dyn", "impl", "mut", "if", "match",
];

/// The path that a word belongs to, even inside the braces of a `use`. It borrows the words,
/// because a hostile answer may repeat long ones thousands of times.
#[derive(Default)]
struct Paths<'t> {
    current: Vec<&'t str>,
    /// The path in front of each open brace.
    behind: Vec<Vec<&'t str>>,
}

impl<'t> Paths<'t> {
    fn word(&mut self, word: &'t str, continues: bool) -> &[&'t str] {
        if KEYWORDS.contains(&word) {
            self.current.clear();
            return &self.current;
        }
        if !continues {
            self.current = self.behind.last().cloned().unwrap_or_default();
        }
        // No flag needs a longer path, and paths may be nested without limit.
        if self.current.len() < 4 {
            self.current.push(word);
        }
        &self.current
    }

    fn mark(&mut self, mark: char, continues: bool) {
        match mark {
            PATH => {}
            '{' => {
                let behind = match continues {
                    true => self.current.clone(),
                    false => Vec::new(),
                };
                self.behind.push(behind);
                self.current.clear();
            }
            '}' => {
                self.behind.pop();
                self.current.clear();
            }
            '*' if continues => {}
            _ => self.current = self.behind.last().cloned().unwrap_or_default(),
        }
    }
}

#[cfg(test)]
mod tests;
