//! Writes the marks into students' reports. A policy may change after grading, so a report is
//! first written without a mark. The mark is inserted whenever the class's files are written.

use std::fs;

use rayon::prelude::*;

use crate::grade::atomic::write_unflushed;
use crate::grade::cache::ResultCache;
use crate::grade::class::{Class, Row};
use crate::grade::policy::mark::number;
use pinhole_course::error::Result;
use pinhole_report::html::mark::{FinalMark, with_mark};

/// Writes everyone's mark into the report; without a policy, none.
pub fn write_marks(class: &Class, cache: &ResultCache) -> Result<()> {
    let is_policy = class.roll.policy.is_some();
    let marked = |page: &str, row: &Row| match is_policy {
        true => with_mark_of(page, row),
        false => with_mark(page, None).unwrap_or_else(|| page.to_owned()),
    };
    class.rows.par_iter().try_for_each(|row| {
        let path = cache.of(&row.entry.id).join("report.html");
        let Ok(page) = fs::read_to_string(&path) else {
            return Ok(());
        };
        let page_with_mark = marked(&page, row);
        match page_with_mark == page {
            true => Ok(()),
            false => write_unflushed(&path, page_with_mark.as_bytes()),
        }
    })
}

/// A report with a row's mark.
pub fn with_mark_of(page: &str, row: &Row) -> String {
    let mark = row.mark.as_ref().map(|mark| FinalMark {
        points: number(mark.last),
        possible: number(mark.possible),
        judged: number(mark.raw),
        why: mark.changes.iter().map(|it| it.in_words()).collect(),
    });
    with_mark(page, mark.as_ref()).unwrap_or_else(|| page.to_owned())
}
