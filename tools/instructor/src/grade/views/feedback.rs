//! Everyone's report, in archives that course systems distribute to students.

use std::io::{Cursor, Write};

use zip::ZipWriter;
use zip::write::SimpleFileOptions;

use super::report;
use crate::grade::cache::ResultCache;
use crate::grade::class::{Class, Row};
use crate::grade::intake::names::PlatformName;
use pinhole_course::error::{Error, Result, ResultExt};

/// The archives for Canvas, for Moodle, and for other ways of sending.
pub const NAMES: [&str; 3] = ["feedback-canvas.zip", "feedback-moodle.zip", "feedback.zip"];

/// An archive, if any report goes into it.
pub type Archive = (&'static str, Option<Vec<u8>>);

/// The archives by name.
pub fn archives(class: &Class, cache: &ResultCache) -> Result<[Archive; 3]> {
    let [canvas, moodle, others] = NAMES;
    Ok([
        (canvas, archive(class, cache, for_canvas)?),
        (moodle, archive(class, cache, for_moodle)?),
        (others, archive(class, cache, for_anybody)?),
    ])
}

/// Canvas's “Upload submissions” matches a file by the numbers of the user and of a file that the
/// user uploaded, as the names from Canvas give them.
fn for_canvas(row: &Row) -> Option<String> {
    let name = row.entry.given.last()?;
    let platform = PlatformName::canvas(name).filter(|_| !row.is_shared)?;
    let own = name.strip_suffix(platform.rest)?;
    Some(format!("{own}report.html"))
}

/// Moodle's “Upload multiple feedback files in a zip”: folders as in its export.
fn for_moodle(row: &Row) -> Option<String> {
    let names = row.entry.given.iter();
    let mut names = names.filter_map(|name| PlatformName::moodle(name));
    let PlatformName { person, number, .. } = names.next().filter(|_| !row.is_shared)?;
    Some(format!(
        "{person}_{number}_assignsubmission_file/report.html"
    ))
}

/// For other ways of sending. Each report is named after the person's id.
fn for_anybody(row: &Row) -> Option<String> {
    let name = row.person.map_or(&row.entry.id, |person| &person.id);
    let is_plain = |c: char| c.is_alphanumeric() || "._-@".contains(c);
    let name = name.replace(|c| !is_plain(c), "_");
    Some(format!("{name}/report.html"))
}

fn archive(
    class: &Class,
    cache: &ResultCache,
    name: fn(&Row) -> Option<String>,
) -> Result<Option<Vec<u8>>> {
    let failed = Error::environment("cannot pack the reports", "free some memory");
    let mut zip = ZipWriter::new(Cursor::new(Vec::new()));
    let mut is_empty = true;
    // Only attempts that count have a report in the archives.
    let rows = class.all_rows().filter(|row| row.mark.is_some());
    for row in rows {
        let Some(name) = name(row) else { continue };
        let path = cache.of(&row.entry.id).join("report.html");
        let page = std::fs::read_to_string(&path).or_environment(
            format_args!("cannot read {}", path.display()),
            "run `pinhole grade` again",
        )?;
        let page = report::with_mark_of(&page, row);
        let options = SimpleFileOptions::default();
        zip.start_file(name, options).or_fail(&failed)?;
        zip.write_all(page.as_bytes()).or_fail(&failed)?;
        is_empty = false;
    }
    let bytes = zip.finish().or_fail(&failed)?.into_inner();
    Ok((!is_empty).then_some(bytes))
}
