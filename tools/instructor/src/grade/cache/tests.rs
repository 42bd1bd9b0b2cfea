use serde_json::json;

use super::*;
use crate::grade::record::tests::graded;

#[test]
fn report_names_only_the_latest_points() {
    let folder = tempfile::tempdir().expect("there is room");
    let report = folder.path().join("report.html");
    let page = "<html>".repeat(100);
    fs::write(&report, &page).expect("there is room");
    for mark in ["7 of 8", "12 of 16"] {
        let note = format!("{NOTE}{mark}</p>");
        replace_note(&report, &note).expect("it is there");
        let now = fs::read_to_string(&report).expect("it is there");
        assert_eq!(now, format!("{page}{note}"));
    }
}

#[test]
fn no_result_is_beside_another_grades_report() {
    let folder = tempfile::tempdir().expect("there is room");
    let cache = ResultCache::open(folder.path()).expect("it is new");
    let record = graded("ada", 1, 1);
    let evidence = evidence(&record);
    cache
        .put(&record, "first", &evidence)
        .expect("there is room");
    assert_eq!(cache.get("ada"), Some(record.clone()));
    // Storing the second grade fails before or after the old report is gone.
    let report = cache.of("ada").join("report.html");
    for (blocked, old) in [
        (report, Some(record.clone())),
        (cache.path(&Evidence::file("ada")), None),
    ] {
        fs::remove_file(&blocked).expect("it is there");
        fs::create_dir(&blocked).expect("there is room");
        let failed = cache.put(&graded("ada", 0, 1), "second", &evidence);
        assert!(failed.is_err());
        assert_eq!(cache.get("ada"), old);
        fs::remove_dir(&blocked).expect("it is empty");
    }
}

#[test]
fn the_next_list_of_changes_knows_the_grade_before_a_run_that_was_stopped() {
    let folder = tempfile::tempdir().expect("there is room");
    let cache = ResultCache::open(folder.path()).expect("it is new");
    let put = |points| {
        let record = graded("ada", points, 3);
        cache
            .put(&record, "report", &evidence(&record))
            .expect("there is room");
    };
    let listed = || cache.listed("ada").map(|record| record.got.points);
    put(1);
    assert_eq!(listed(), None, "a first grade is not a change");
    // A power cut has left an empty file.
    fs::write(cache.of("ada").join(LISTED), "").expect("there is room");
    put(2);
    put(3);
    assert_eq!(listed(), Some(Some(1)));
    cache.forget_listed("ada");
    cache
        .put_points(&graded("ada", 2, 3))
        .expect("there is room");
    assert_eq!(listed(), Some(Some(3)));
}

fn evidence(record: &Record) -> Evidence {
    Evidence {
        id: record.id.clone(),
        public: record.got.clone(),
        fresh: None,
        fresh_folder: None,
        answers: Default::default(),
    }
}

#[cfg(unix)]
#[test]
fn results_that_others_may_have_written_are_not_believed() {
    use std::os::unix::fs::{PermissionsExt, chown};

    let out = tempfile::tempdir().expect("there is room");
    let open = || ResultCache::open(out.path()).map(drop);
    open().expect("it is new");
    open().expect("it is ours");
    for name in ["submissions", "evidence", "fresh", "roll.json"] {
        let path = out.path().join(name);
        if name == "fresh" {
            fs::create_dir(&path).expect("there is room");
        } else if name == "roll.json" {
            fs::write(&path, "{}").expect("there is room");
        }
        let allow = |mode| fs::set_permissions(&path, fs::Permissions::from_mode(mode));
        allow(0o770).expect("it is ours");
        let error = open().expect_err("somebody else may have written them");
        assert!(error.to_string().contains(name), "{error}");
        allow(0o755).expect("it is ours");
        open().expect("others may only read them");
        // Only root can give files away.
        if chown(&path, Some(12345), None).is_ok() {
            open().expect_err("somebody else made it");
            chown(&path, Some(0), None).expect("we are root");
        }
    }
}

#[cfg(unix)]
#[test]
fn nobody_else_sees_how_large_the_files_of_a_class_are() {
    use pinhole_course::private::{allow, is_private};

    let folder = tempfile::tempdir().expect("there is room");
    // Either folder may be new: the class's, or those inside.
    let [new, old] = ["new", "old"].map(|name| folder.path().join(name));
    fs::create_dir(&old).expect("there is room");
    allow(&old, 0o755).expect("it is ours");
    let put = |out: &Path| {
        let cache = ResultCache::open(out).expect("it is ours");
        let record = graded("ada", 1, 1);
        let put = cache.put(&record, "report", &evidence(&record));
        put.expect("there is room");
    };
    put(&new);
    assert!(is_private(&new));
    put(&old);
    for name in ["submissions", "evidence"] {
        assert!(is_private(&old.join(name)), "{name}");
    }
}

#[test]
fn unreadable_submission_has_no_grade() {
    use crate::grade::class::marks::tests::entry;

    let folder = tempfile::tempdir().expect("there is room");
    let cache = ResultCache::open(folder.path()).expect("it is new");
    let mut entry = entry("ada", "ada", "ada");
    let record = graded("ada", 1, 1);
    write(
        &cache.of("ada").join("result.json"),
        &pretty(&record).expect("JSON").into_bytes(),
    )
    .expect("there is room");
    let grade = |entry: &Entry| standing(&cache.of("ada"), entry).map(|it| it.is_graded());
    assert_eq!(grade(&entry), Some(false));
    entry.answers = Some(record.provenance.answers.clone());
    assert_eq!(grade(&entry), Some(true));
    // A later upload can't be read either, and the reason is shown.
    entry.answers = None;
    cache
        .put_fault(&record.not_graded("it is encrypted".into()))
        .expect("there is room");
    fs::remove_file(cache.of("ada").join("result.json")).expect("it is there");
    assert!(standing(&cache.of("ada"), &entry).is_none_or(|it| !it.is_graded()));
}

#[test]
fn result_of_an_older_version_is_ignored() {
    let any = crate::grade::class::marks::tests::entry("ada", "ada", "ada");
    let folder = tempfile::tempdir().expect("there is room");
    let cache = ResultCache::open(folder.path()).expect("it is new");
    let path = cache.of("ada").join("result.json");
    let mut record = serde_json::to_value(graded("ada", 1, 1)).expect("it can be written");
    let is_there = |record: &serde_json::Value| {
        write(&path, record.to_string().as_bytes()).expect("there is room");
        (
            cache.get("ada").is_some(),
            standing(&cache.of("ada"), &any).is_some(),
        )
    };
    assert_eq!(is_there(&record), (true, true));
    record["schema"] = 1.into();
    assert_eq!(is_there(&record), (false, false));
    let oldest = json!({ "schema": 1, "id": "ada", "name": "ada", "points": 1 });
    assert_eq!(is_there(&oldest), (false, false));
}

#[test]
fn a_fault_of_an_earlier_run_hides_no_valid_grade() {
    use crate::grade::class::marks::tests::entry;

    let folder = tempfile::tempdir().expect("there is room");
    let cache = ResultCache::open(folder.path()).expect("it is new");
    let mut record = graded("ada", 1, 1);
    record.provenance.answers = vec![("task".into(), "hash".into())];
    cache
        .put(&record, "report", &evidence(&record))
        .expect("there is room");
    let mut fault = record
        .clone()
        .not_graded("the file could not be read".into());
    fault.provenance.answers.clear();
    cache.put_fault(&fault).expect("there is room");
    let entry = Entry {
        answers: Some(record.provenance.answers.clone()),
        ..entry("ada", "ada", "ada")
    };
    assert_eq!(standing(&cache.of("ada"), &entry), Some(record));
}
