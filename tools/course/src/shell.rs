//! Command lines that people can copy into a terminal.

use crate::escape::printable;

/// How this command is run from its checkout.
pub const PINHOLE: &str = "cargo pinhole";

/// One word of a command line.
pub fn in_shell(word: &str) -> String {
    let plain = |c: char| c.is_alphanumeric() || "/._-+:\\".contains(c);
    match word.chars().all(plain) {
        true => word.into(),
        false => format!("'{}'", printable(word).replace('\'', "'\\''")),
    }
}
