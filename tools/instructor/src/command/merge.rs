//! `pinhole merge`: combines the shards of a class, wherever they were graded.

use std::collections::{BTreeMap, BTreeSet};
use std::ffi::{OsStr, OsString};
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::OnceLock;

use rayon::prelude::*;

use crate::cli::Merge;
use crate::grade::atomic::{link, write_unflushed};
use crate::grade::cache::{ResultCache, pretty, refuse_foreign, standing};
use crate::grade::class::{Change, ROLL, Roll, change, replace};
use crate::grade::evidence::Evidence;
use crate::grade::intake::Entry;
use crate::grade::policy::Policy;
use crate::grade::provenance::{self, GradingInputs};
use crate::grade::queue::QueueResult;
use crate::grade::record::Record;
use crate::grade::stored::kept;
use crate::grade::views::summary::{ClassOutput, RunSummary};
use pinhole_course::checkout::Checkout;
use pinhole_course::error::{Error, Result};
use pinhole_report::program::Status;

pub fn run(checkout: &Checkout, arguments: &Merge) -> Result<Status> {
    let assignment = arguments.assignment.find(checkout, None)?;
    let (mut roll, parts, handed_in_again) = read(&arguments.shards)?;
    replace::refuse_other_assignment(&assignment.name, &roll)?;
    if let Some(path) = &arguments.policy {
        roll.policy = Some(Policy::read(path, &assignment)?);
        roll.place();
    }
    let earlier = arguments.out.join(ROLL);
    replace::refuse_partial_class(&roll, &earlier, "name another folder with --out")?;
    let cache = ResultCache::open(&arguments.out)?;
    let is_out =
        |part: &&PathBuf| fs::canonicalize(part).ok() == fs::canonicalize(&arguments.out).ok();
    if let Some(part) = arguments.shards.iter().find(is_out) {
        return Err(Error::input(
            format!("{} can't be merged into itself", part.display()),
            "name another folder with --out",
        ));
    }
    let made_with = OnceLock::new();
    let version = provenance::of_assignment(&assignment, checkout)?;
    let results = roll.entries.par_iter_mut().map(|entry| {
        let Some(Merged {
            record,
            entry: graded,
            others,
        }) = merged(&entry.id, &parts, &cache, &made_with)?
        else {
            return Ok(None);
        };
        // Another part may list an earlier or a later submission of this name.
        *entry = graded.clone();
        let is_old = record.provenance.made_with.assignment != version;
        let is_doubtful = record.is_graded() && handed_in_again.contains(&entry.id);
        let result = kept(record, &cache, &assignment, is_old)?;
        Ok(Some((result, others, is_doubtful)))
    });
    let results: Vec<Option<(QueueResult, Vec<Change>, bool)>> = results.collect::<Result<_>>()?;
    let mut records = BTreeMap::new();
    let mut run = RunSummary::default();
    let mut are_old = false;
    for (result, others, is_doubtful) in results.into_iter().flatten() {
        if is_doubtful {
            let why = "it may be for earlier answers, because the parts have different answers; \
                       grade all parts again";
            run.faults.push((result.record.id.clone(), why.into()));
        }
        run.changes.extend(others);
        run.changes.extend(result.change);
        are_old |= result.fault.is_some();
        records.insert(result.record.id.clone(), result.record);
    }
    if are_old {
        anstream::eprintln!(
            "some submissions were graded with another version of the assignment, and keep the \
             points that they had then"
        );
    }
    change::sort(&mut run.changes);
    // A class of another version is merged again.
    if let Ok(class) = Roll::read(&earlier) {
        roll.remember_times(&class);
        roll.remember_alone(&class);
    }
    roll.doubt_earlier_answers();
    roll.note_times();
    cache.write(ROLL, &pretty(&roll)?)?;
    let output = ClassOutput {
        cache: &cache,
        assignment: &assignment,
        formats: &arguments.format,
        as_json: arguments.json,
    };
    output.write(&roll, &records, &run)
}

/// One of the folders that are merged.
struct Part<'a> {
    folder: &'a Path,
    /// The submissions whose results it has, by id. The folder is listed only once, because looking
    /// for each submission in each part is slow on a shared file system.
    entries: BTreeMap<String, Entry>,
}

/// A submission's result in the merged class.
struct Merged<'a> {
    record: Record,
    /// The submission that the result is for.
    entry: &'a Entry,
    /// How the mark differs from those in later parts.
    others: Vec<Change>,
}

impl<'a> Merged<'a> {
    fn new(record: Record, entry: &'a Entry) -> Self {
        let others = Vec::new();
        Merged {
            record,
            entry,
            others,
        }
    }
}

/// Puts a submission's result into the merged class: the mark in the first part that has one or, if
/// no part has a mark, the reason. `None` if no part has the submission. All marks must be made
/// with the same goldens, fresh questions and assignment.
fn merged<'a>(
    id: &str,
    parts: &'a [Part],
    cache: &ResultCache,
    made_with: &OnceLock<GradingInputs>,
) -> Result<Option<Merged<'a>>> {
    let to = cache.of(id);
    let mut merged: Option<Merged> = None;
    for part in parts {
        let from = part.folder.join("submissions").join(id);
        let entry = part.entries.get(id);
        let found = entry.and_then(|entry| Some((standing(&from, entry)?, entry)));
        let Some((record, entry)) = found else {
            continue;
        };
        if !record.is_graded() {
            merged.get_or_insert(Merged::new(record, entry));
            continue;
        }
        let own = &record.provenance.made_with;
        let with = made_with.get_or_init(|| own.clone());
        // Each machine may have built the program itself, so the hash of the program may differ.
        if with.goldens != own.goldens
            || with.fresh != own.fresh
            || with.assignment != own.assignment
        {
            return Err(Error::input(
                format!(
                    "{} was not graded with the same goldens, fresh questions and version of the \
                     assignment as the other parts",
                    part.folder.display()
                ),
                "grade all parts with the same assignment, and with the same values of --golden, \
                 --fresh and --seed",
            ));
        }
        if let Some(merged) = merged.as_mut().filter(|it| it.record.is_graded()) {
            merged
                .others
                .extend(Change::between(&record, &merged.record));
            continue;
        }
        if !put_in_place(&record, part.folder, &from, cache)? {
            return self::merged(id, parts, cache, made_with);
        }
        cache.forget_fault(id);
        merged = Some(Merged::new(record, entry));
    }
    if let Some(merged) = merged.as_ref().filter(|it| !it.record.is_graded()) {
        cache.keep_listed(id)?;
        write_unflushed(&to.join("result.json"), pretty(&merged.record)?.as_bytes())?;
    }
    Ok(merged)
}

/// Puts the files of a part's result into the merged class. False if the part has stored another
/// result meanwhile.
fn put_in_place(record: &Record, part: &Path, from: &Path, cache: &ResultCache) -> Result<bool> {
    let report = from.join("report.html");
    if !report.is_file() {
        return Err(Error::input(
            format!("{} has no report", from.display()),
            "grade that part again",
        ));
    }
    let to = cache.of(&record.id);
    cache.keep_listed(&record.id)?;
    // If this process is killed meanwhile, no result is beside another one's report.
    let _is_first = fs::remove_file(to.join("result.json"));
    let evidence = Evidence::file(&record.id);
    match part.join(&evidence).is_file() {
        true => link(&part.join(&evidence), &cache.path(&evidence))?,
        false => {
            let _of_an_earlier_result = fs::remove_file(cache.path(&evidence));
        }
    }
    link(&report, &to.join("report.html"))?;
    let result = from.join("result.json");
    if !result.is_file() {
        return Ok(false);
    }
    link(&result, &to.join("result.json"))?;
    Ok(cache.get(&record.id).as_ref() == Some(record))
}

/// The roll of the class, on which all parts must agree, the parts, and the ids of submissions whose
/// answers are not the same in all of them. Nothing says which answers are newer: files may have been
/// copied, and the clocks of two machines may differ.
fn read(shards: &[PathBuf]) -> Result<(Roll, Vec<Part<'_>>, BTreeSet<String>)> {
    let mut common: Option<Roll> = None;
    let mut handed_in_again = BTreeSet::new();
    let mut parts = Vec::new();
    for shard in shards {
        refuse_foreign(shard, "merge only results of your own")?;
        let path = shard.join(ROLL);
        if !path.exists() && shards.len() > 1 {
            anstream::eprintln!(
                "{} has no results yet: its submissions are listed as not graded",
                shard.display()
            );
            continue;
        }
        let roll = Roll::read(&path)?;
        if common
            .as_ref()
            .is_some_and(|it| !it.has_same_submissions(&roll))
        {
            return Err(Error::input(
                format!(
                    "{} does not have the same submissions, roster and policy as the other parts",
                    shard.display()
                ),
                "grade all parts with the same paths, roster and policy",
            ));
        }
        let others = common.iter().flat_map(|common| &common.entries);
        let pairs = others
            .zip(&roll.entries)
            .filter(|(a, b)| a.answers != b.answers);
        handed_in_again.extend(pairs.map(|(entry, _)| entry.id.clone()));
        let submissions = fs::read_dir(shard.join("submissions"));
        let names = submissions.into_iter().flatten().flatten();
        let ids: BTreeSet<OsString> = names.map(|it| it.file_name()).collect();
        let entries = roll.entries.iter();
        let entries = entries.filter(|entry| ids.contains(OsStr::new(&entry.id)));
        parts.push(Part {
            folder: shard,
            entries: entries.map(|it| (it.id.clone(), it.clone())).collect(),
        });
        let earlier = common.take();
        let roll = common.insert(roll);
        if let Some(earlier) = earlier {
            roll.remember_alone(&earlier);
            roll.remember_times(&earlier);
        }
    }
    let common =
        common.ok_or_else(|| Error::input("no part has results", "name the parts' --out folders"));
    Ok((common?, parts, handed_in_again))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grade::atomic::write;
    use crate::grade::record::tests::graded;

    #[test]
    fn result_that_a_part_has_replaced_is_not_merged() {
        let folder = tempfile::tempdir().expect("there is room");
        let part = folder.path().join("part");
        let from = part.join("submissions/ada");
        let cache = ResultCache::open(&folder.path().join("merged")).expect("it is new");
        let (old, new) = (graded("ada", 0, 1), graded("ada", 1, 1));
        write(&from.join("report.html"), b"new").expect("there is room");
        let merge = |record: &Record| put_in_place(record, &part, &from, &cache);
        // The part is storing its new result.
        assert!(!merge(&old).expect("there is room"));
        let text = pretty(&new).expect("JSON");
        write(&from.join("result.json"), text.as_bytes()).expect("there is room");
        assert!(!merge(&old).expect("there is room"));
        assert!(merge(&new).expect("there is room"));
    }
}
