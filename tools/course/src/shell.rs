//! Command lines that people can copy into a terminal.

/// How this command is run from its checkout.
pub const PINHOLE: &str = "cargo pinhole";

/// One word of a command line, quoted where the shell would split or expand it. What it
/// holds is as untrusted as before.
pub fn in_shell(word: &str) -> String {
    let plain = |c: char| c.is_alphanumeric() || "/._-+:\\".contains(c);
    match word.chars().all(plain) {
        true => word.into(),
        false => format!("'{}'", word.replace('\'', "'\\''")),
    }
}
