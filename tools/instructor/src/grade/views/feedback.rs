//! Everyone's report, in archives that course systems distribute to students.

use std::collections::{BTreeMap, BTreeSet};
use std::io::{Cursor, Write};

use zip::ZipWriter;
use zip::write::SimpleFileOptions;

use super::gradebook::has_number_of;
use super::report;
use crate::grade::cache::ResultCache;
use crate::grade::class::{Class, Row};
use crate::grade::intake::names::{Platform, platforms};
use pinhole_course::error::{Error, Result, ResultExt};

/// The archives for Canvas, for Moodle, and for other ways of sending.
pub const NAMES: [&str; 3] = ["feedback-canvas.zip", "feedback-moodle.zip", "feedback.zip"];

/// An archive, if any report goes into it.
pub type Archive = (&'static str, Option<Vec<u8>>);

/// The archives by name.
pub fn archives(class: &Class, cache: &ResultCache) -> Result<[Archive; 3]> {
    let [canvas, moodle, others] = NAMES;
    Ok([
        (canvas, archive(class, cache, &for_canvas)?),
        (moodle, archive(class, cache, &for_moodle)?),
        (others, archive(class, cache, &for_others)?),
    ])
}

/// Whether a submission's report may be sent. With a roster, submissions that belong to nobody are
/// left out, because their names or numbers may be somebody's.
fn may_be_sent(row: &Row, has_roster: bool) -> bool {
    // Only attempts that count have a report in the archives.
    row.mark.is_some() && (row.person.is_some() || !has_roster)
}

/// Canvas's “Upload submissions” matches a file by the numbers of the user and of a file that the
/// user uploaded, as the names from Canvas give them: the first two parts between underscores that
/// are numbers (`infer_comment_context_from_filename` in Canvas's source).
fn for_canvas(row: &Row) -> Option<String> {
    let name = row.entry.given.last()?;
    let ways = platforms(name);
    let given = ways
        .first()
        .filter(|_| row.person.is_some() || ways.len() == 1);
    let given = given.filter(|it| it.platform == Platform::Canvas && it.upload > 0)?;
    if row.is_shared || row.entry.platform != Some(Platform::Canvas) {
        return None;
    }
    // Display names can hold numbers, too.
    let mut numbers = name.split('_').filter(|it| it.parse::<u64>().is_ok());
    let is_read_so = numbers.next() == Some(given.number)
        && numbers.next().and_then(|it| it.parse().ok()) == Some(given.upload);
    let own = name.strip_suffix(given.rest).filter(|_| is_read_so)?;
    Some(format!("{own}report.html"))
}

/// Moodle's “Upload multiple feedback files in a zip”: folders as in its export. Their numbers say
/// whose they are (`mod/assign/feedback/file/importziplib.php` in Moodle's source). A group's
/// number may be somebody else's (`mod/assign/classes/downloader.php`), so it gets no folder, and
/// without a roster, nobody knows whether it is a group's.
fn for_moodle(row: &Row) -> Option<String> {
    let mut names = row.entry.named_by(Platform::Moodle);
    let name = names.next().filter(|_| !row.is_shared)?;
    let is_own = row.person.is_some_and(|it| has_number_of(&name, it));
    is_own.then(|| format!("{}_assignsubmission_file/report.html", name.submission))
}

/// For sending in other ways: the report is named by the person's id. Characters that are not safe
/// in file names are written as in a URL. So no two people share a folder, even if their ids are
/// addresses that they chose themselves.
fn for_others(row: &Row) -> Option<String> {
    let id = row.person.map_or(&row.entry.id, |person| &person.id);
    // A folder called `..` is the one above, and Windows leaves out a dot at the end.
    let is_inner = |at: usize| at > 0 && at + 1 < id.len();
    let is_plain =
        |at: usize, c: char| c.is_alphanumeric() || "_-@".contains(c) || c == '.' && is_inner(at);
    Some(format!("{}/report.html", percent_encoded(id, is_plain)))
}

/// Writes all other characters as in a URL.
fn percent_encoded(text: &str, is_plain: impl Fn(usize, char) -> bool) -> String {
    let encoded = text.char_indices().map(|(at, c)| match is_plain(at, c) {
        true => c.to_string(),
        false => {
            let bytes = c.to_string().into_bytes().into_iter();
            bytes.map(|byte| format!("%{byte:02X}")).collect()
        }
    });
    encoded.collect()
}

/// Makes all names differ. Writes the capitals of names that differ in nothing else as in a URL,
/// because Windows would unpack two folders with such names into one. Numbers the reports of equal
/// names, which two exports without a roster may have.
fn distinguish(names: Vec<&mut String>) {
    let mut counts: BTreeMap<String, usize> = BTreeMap::new();
    for name in &names {
        *counts.entry(name.to_lowercase()).or_default() += 1;
    }
    let mut taken = BTreeSet::new();
    for name in names {
        if counts[&name.to_lowercase()] > 1 {
            *name = percent_encoded(name, |_, c| !c.is_uppercase());
        }
        let stem = name.trim_end_matches(".html").to_owned();
        let mut number = 2;
        while !taken.insert(name.clone()) {
            *name = format!("{stem}-{number}.html");
            number += 1;
        }
    }
}

fn archive(
    class: &Class,
    cache: &ResultCache,
    name: &dyn Fn(&Row) -> Option<String>,
) -> Result<Option<Vec<u8>>> {
    let failed = Error::environment("cannot pack the reports", "free some memory");
    let mut zip = ZipWriter::new(Cursor::new(Vec::new()));
    let has_roster = class.roll.people.is_some();
    let rows = class.all_rows().filter(|row| may_be_sent(row, has_roster));
    let mut named: Vec<(String, &Row)> = rows.filter_map(|row| Some((name(row)?, row))).collect();
    distinguish(named.iter_mut().map(|(name, _)| name).collect());
    let is_empty = named.is_empty();
    for (name, row) in named {
        let path = cache.of(&row.entry.id).join("report.html");
        let page = std::fs::read_to_string(&path).or_environment(
            format_args!("cannot read {}", path.display()),
            "run `pinhole grade` again",
        )?;
        let page = report::with_mark_of(&page, row);
        let options = SimpleFileOptions::default();
        zip.start_file(name, options).or_fail(&failed)?;
        zip.write_all(page.as_bytes()).or_fail(&failed)?;
    }
    let bytes = zip.finish().or_fail(&failed)?.into_inner();
    Ok((!is_empty).then_some(bytes))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grade::intake::Entry;
    use crate::grade::intake::matching::Proof;
    use crate::grade::intake::roster::Person;
    use crate::grade::policy::mark::{JudgedPoints, Mark};

    #[test]
    fn a_groups_report_has_no_folder_with_the_groups_number() {
        use crate::grade::class::marks::tests::entry;

        let person = Person {
            name: "Ada Lovelace".into(),
            ..Person::default()
        };
        let folder = |name: &str, person| {
            let entry = entry("one", "ada", &format!("{name}_assignsubmission_file"));
            for_moodle(&Row {
                entry: &entry,
                person,
                record: None,
                mark: None,
                not_counted: None,
                is_shared: false,
            })
        };
        let own = "Ada Lovelace_2001_assignsubmission_file/report.html";
        assert_eq!(
            folder("Ada Lovelace_2001", Some(&person)).as_deref(),
            Some(own)
        );
        assert_eq!(folder("Team A_3001", Some(&person)), None);
        // It may be a group's, too.
        assert_eq!(folder("Ada Lovelace_2001", None), None);
    }

    #[test]
    fn a_name_that_may_hold_anothers_number_is_sent_only_to_a_known_person() {
        use crate::grade::class::marks::tests::entry;

        let person = Person::default();
        let file = |name: &str, person| {
            for_canvas(&Row {
                entry: &entry("one", "ada", name),
                person,
                record: None,
                mark: None,
                not_counted: None,
                is_shared: false,
            })
        };
        let plain = "lovelaceada_11_501_hw.zip";
        assert_eq!(
            file(plain, None).as_deref(),
            Some("lovelaceada_11_501_report.html")
        );
        let dated = "lovelaceada_11_501_hw_2026_11_20.zip";
        assert_eq!(file(dated, None), None);
        let sent = file(dated, Some(&person));
        assert_eq!(sent.as_deref(), Some("lovelaceada_11_501_report.html"));
        // Somebody's display name holds Ada's number and that of her file.
        let chosen = "mann_11_x_501_y_13_503_hw.zip";
        assert_eq!(file(chosen, Some(&person)), None);
    }

    #[test]
    fn a_submission_that_belongs_to_nobody_is_not_sent_to_anybody() {
        let entry = Entry {
            id: "7".into(),
            name: "7.zip".into(),
            given: Vec::new(),
            platform: None,
            signs: Vec::new(),
            at_most: Proof::Name,
            notes: Vec::new(),
            doubts: Vec::new(),
            unusable: Vec::new(),
            answers: None,
            submission: Err("not asked".into()),
        };
        let mut row = Row {
            entry: &entry,
            person: None,
            record: None,
            mark: None,
            not_counted: None,
            is_shared: false,
        };
        assert!(!may_be_sent(&row, false));
        let judged = JudgedPoints {
            points: 0.0,
            possible: 1.0,
            extra: 0.0,
        };
        row.mark = Some(Mark::judged(judged));
        assert!(!may_be_sent(&row, true) && may_be_sent(&row, false));
        assert_eq!(for_others(&row).as_deref(), Some("7/report.html"));
        let own = |id: &str| {
            let person = Person {
                id: id.into(),
                ..Person::default()
            };
            let row = Row {
                person: Some(&person),
                ..row.clone()
            };
            assert!(may_be_sent(&row, true));
            for_others(&row).expect("it has a name")
        };
        assert_eq!(own("ada"), "ada/report.html");
        assert_eq!(own(".."), "%2E%2E/report.html");
        assert_eq!(own("ada."), "ada%2E/report.html");
        assert_eq!(own("a.l@x.org"), "a.l@x.org/report.html");
        // Nobody can choose an address that has somebody else's folder.
        let addresses = [
            "a+b@x.org",
            "a_b@x.org",
            "a%2Bb@x.org",
            "a b@x.org",
            "a’b@x.org",
            "a 19b@x.org",
        ];
        let folders: BTreeSet<String> = addresses.map(own).into();
        assert_eq!(folders.len(), addresses.len(), "{folders:?}");
    }

    #[test]
    fn no_two_reports_share_a_folder_on_windows() {
        let mut names = ["ADA", "bob", "Ada", "ada", "Bo"].map(str::to_owned);
        distinguish(names.each_mut().into());
        assert_eq!(names, ["%41%44%41", "bob", "%41da", "ada", "Bo"]);
        let mut equal = ["a/report.html", "a/report.html"].map(str::to_owned);
        distinguish(equal.each_mut().into());
        assert_eq!(equal, ["a/report.html", "a/report-2.html"]);
    }
}
