//! Tables that spreadsheets and learning platforms write as CSV.

use std::path::Path;

use encoding_rs::{UTF_8, WINDOWS_1252};

use super::reader::utf_16;
use pinhole_course::error::{Error, Result, ResultExt};

/// Columns of addresses. A cell without an `@` counts as empty, because a student may have filled it
/// in to look like somebody's id or login.
const EMAIL: [&str; 3] = ["email", "emailaddress", "emailadresse"];

/// A table, read as a whole.
pub struct Table {
    /// The first line, as it is in the file.
    pub first_line: String,
    /// The columns' names, in lower case and without spaces.
    header: Vec<String>,
    /// The other lines, with their numbers in the file. Cells keep the spaces around their text.
    pub rows: Vec<(u64, csv::StringRecord)>,
}

impl Table {
    /// Reads a file that should be a `what`, such as a roster.
    pub fn read<T>(
        path: &Path,
        what: &str,
        remedy: &str,
        of: impl FnOnce(Table) -> std::result::Result<T, String>,
    ) -> Result<T> {
        let wrong = Error::input(format!("{} is not a {what}", path.display()), remedy);
        let bytes = std::fs::read(path).or_fail(&wrong)?;
        Table::of(&bytes)
            .and_then(of)
            .map_err(|why| wrong.because(why))
    }

    /// The table in a file's bytes, or a message that says what is wrong.
    pub fn of(bytes: &[u8]) -> std::result::Result<Table, String> {
        if bytes.starts_with(b"PK\x03\x04") {
            return Err("it is in a spreadsheet's own format; export it as CSV".into());
        }
        let text = decoded(bytes);
        // A spreadsheet may name the separator in an extra first line.
        let body = match text.split_once('\n') {
            Some((first, rest)) if first.trim_start().starts_with("sep=") => rest,
            _ => &text,
        };
        let first_line = body.lines().next().unwrap_or_default().to_owned();
        let count = |mark: char| first_line.matches(mark).count();
        let between = [',', ';', '\t'].into_iter().max_by_key(|mark| count(*mark));
        let mut reader = csv::ReaderBuilder::new()
            .flexible(true)
            .delimiter(between.unwrap_or(',') as u8)
            .from_reader(body.as_bytes());
        let header = reader.headers().map_err(|error| error.to_string())?;
        let header: Vec<String> = header.iter().map(plain).collect();
        let mut rows = Vec::new();
        for row in reader.records() {
            let row = row.map_err(|error| error.to_string())?;
            if !row.iter().all(|cell| cell.trim().is_empty()) {
                let line = row.position().map_or(0, |position| position.line());
                let cells = row.iter().enumerate();
                let cells = cells.map(|(at, cell)| match header.get(at) {
                    Some(column) if EMAIL.contains(&&**column) && !cell.contains('@') => "",
                    _ => cell,
                });
                rows.push((line, cells.collect()));
            }
        }
        Ok(Table {
            first_line,
            header,
            rows,
        })
    }

    /// The place of the first of these columns that the table has.
    pub fn column(&self, names: &[&str]) -> Option<usize> {
        let mut names = names.iter();
        names.find_map(|name| self.header.iter().position(|it| it == name))
    }

    /// The place of the first of these columns that the table has, or an error if it has none.
    pub fn needed_column(&self, names: &[&str]) -> std::result::Result<usize, String> {
        self.column(names).ok_or(format!(
            "its first line is `{}`, which has no column `{}`",
            self.first_line,
            names.first().unwrap_or(&"")
        ))
    }

    /// The name of a column.
    pub fn name(&self, column: usize) -> &str {
        &self.header[column]
    }
}

/// A column's name in the form used for comparing names.
fn plain(name: &str) -> String {
    let letters = name.chars().filter(|c| c.is_alphanumeric());
    letters.flat_map(char::to_lowercase).collect()
}

/// The text of a spreadsheet's file: UTF-8, UTF-16, or Windows' encoding for Western Europe.
fn decoded(bytes: &[u8]) -> String {
    let others = match std::str::from_utf8(bytes) {
        Ok(_) => UTF_8,
        Err(_) => WINDOWS_1252,
    };
    let encoding = utf_16(bytes).unwrap_or(others);
    encoding.decode(bytes).0.into_owned()
}
