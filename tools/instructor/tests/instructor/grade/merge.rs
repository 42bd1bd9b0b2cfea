//! Parts of a class that are graded apart are merged without losing a grade.

use std::fs;
use std::time::{Duration, SystemTime};

use serde_json::json;

use super::{Class, on_small_assignment, wrong_plane};
use pinhole_testing::{fresh, pinhole, small_assignment, trusted};

#[test]
fn merge_gives_the_points_that_the_parts_are_worth_now() {
    let class = Class::new("worth");
    class.grade("whole", &[]).expect_code(1);
    let report = "submissions/dora/report.html";
    let graded = class.read(&format!("whole/{report}"));
    let dearer = small_assignment(&fresh(&trusted(), "dearer"));
    let file = dearer.join("assignment.toml");
    let text = fs::read_to_string(&file).expect("it was copied");
    let points_of_scene = |points: u32| format!("name = \"sphere_and_plane\"\npoints = {points}");
    let changed = text.replace(&points_of_scene(8), &points_of_scene(13));
    assert_ne!(changed, text);
    fs::write(&file, changed).expect("writable");
    let (ada, whole, merged) = (
        class.path("class/ada"),
        class.path("whole"),
        class.path("merged"),
    );
    let now = ["--assignment", dearer.to_str().expect("a plain name")];
    let merge = ["merge", &whole, "--out", &merged];
    pinhole(&[&merge[..], &now].concat())
        .expect_code(1)
        .expect_out("ada: 100 → 105 (scenes");
    let merged_report = class.read(&format!("merged/{report}"));
    assert!(merged_report.contains("of 105 points"));
    assert_eq!(class.read(&format!("whole/{report}")), graded);
    // Grading one submission into a class gives all others their points too.
    let grade = ["grade", &ada, "--out", &whole, "--no-fresh"];
    pinhole(&[&grade[..], &now].concat()).expect_code(1);
    assert_eq!(
        class.read("merged/grades.csv"),
        class.read("whole/grades.csv")
    );
    // The points of groups and scenes that have changed can't be computed again, and neither can
    // those of answers that ran among other code.
    let code = dearer.join("reference/src/main.rs");
    for (file, was, is) in [
        (&code, "//! ", "//! Again: "),
        (&file, "title = \"", "title = \"Another "),
    ] {
        let text = fs::read_to_string(file).expect("it was copied");
        let other = text.replacen(was, is, 1);
        assert_ne!(other, text);
        fs::write(file, other).expect("writable");
        let again = pinhole(&[&merge[..], &now].concat()).expect_code(1);
        let old = "graded with another version of the assignment";
        assert!(again.err.contains(old), "{}", again.err);
        if file == &code {
            fs::write(file, text).expect("writable");
        }
    }
    let old = "graded with other questions or goldens";
    pinhole(&[&grade[..], &now].concat())
        .expect_code(3)
        .expect_out(&format!("the old mark remains: dora: it was {old}"));
}

#[test]
fn a_merge_lists_marks_for_answers_that_were_handed_in_again() {
    let class = Class::new("again");
    for part in ["1", "2"] {
        class.grade(part, &["--shard", &format!("{part}/2")]);
    }
    let (one, two, merged) = (class.path("1"), class.path("2"), class.path("merged"));
    let merge = ["merge", &one, &two, "--out", &merged, "--json"];
    let told = on_small_assignment(&merge).expect_code(1).json();
    assert_eq!(told["faults"], json!([]), "{told}");
    // The job that should grade the second part again dies before it starts.
    class.hand_in("ada", &[("plane.rs", &wrong_plane())]);
    class.grade("1", &["--shard", "1/2"]);
    // The second part may look newer: it was copied later, or its machine's clock is fast.
    let roll = fs::File::options()
        .append(true)
        .open(class.folder.join("2/roll.json"));
    let later = SystemTime::now() + Duration::from_secs(600);
    roll.and_then(|roll| roll.set_modified(later))
        .expect("it is ours");
    let told = on_small_assignment(&merge).expect_code(3).json();
    assert_eq!(told["faults"][0][0], "ada", "{told}");
    class.grade("2", &["--shard", "2/2"]);
    let told = on_small_assignment(&merge).expect_code(1).json();
    assert_eq!(told["faults"], json!([]), "{told}");
    assert_eq!(told["changes"][0]["id"], "ada", "{told}");
    let told = on_small_assignment(&merge).expect_code(1).json();
    assert_eq!(told["changes"], json!([]), "it was listed");
    // What is passed alone afterwards is newer.
    class.hand_in("ada", &[]);
    let alone = [
        "grade",
        &class.path("class/ada"),
        "--out",
        &merged,
        "--no-fresh",
    ];
    on_small_assignment(&alone).expect_code(1);
    on_small_assignment(&merge[..5])
        .expect_code(1)
        .expect_out("not those that you passed alone");
    // So is what is passed alone to a part, even if that is not the person's part.
    on_small_assignment(&[&alone[..3], &[&one, "--no-fresh"]].concat()).expect_code(3);
    class.hand_in("ada", &[("plane.rs", &wrong_plane())]);
    class.grade("1", &["--shard", "1/2"]);
    class.grade("2", &["--shard", "2/2"]);
    fs::remove_dir_all(class.folder.join("1/submissions/ada")).expect("it has a result");
    let other = class.path("other");
    on_small_assignment(&["merge", &one, &two, "--out", &other])
        .expect_code(1)
        .expect_out("not those that you passed alone");
}

#[test]
fn a_merge_without_groups_lists_those_who_handed_in_nothing_themselves() {
    let class = Class::new("merge-without-groups");
    let (entry, out) = (class.path("class/ada"), class.path("out"));
    let put = |name: &str, text: &str| {
        fs::write(class.folder.join(name), text).expect("there is room");
        class.path(name)
    };
    let roster = put("roster.csv", "id,name\nada,Ada Lovelace\nbob,Bob Brown\n");
    put("groups.csv", "id,group\nada,T\nbob,T\n");
    let groups = put("groups.toml", "time_zone = 'UTC'\ngroups = 'groups.csv'\n");
    let alone = put("alone.toml", "time_zone = 'UTC'\n");
    let line = ["grade", &entry, "--no-fresh", "--out", &out];
    on_small_assignment(&[&line[..], &["--roster", &roster, "--policy", &groups]].concat())
        .expect_code(0)
        .expect_out("0 handed in nothing");
    let merged = class.path("merged");
    on_small_assignment(&["merge", &out, "--policy", &alone, "--out", &merged])
        .expect_code(0)
        .expect_out("1 handed in nothing");
    let grades = class.read("merged/grades.csv");
    assert!(
        grades.contains("bob,Bob Brown,,,,,nothing handed in"),
        "{grades}"
    );
}

#[test]
fn a_merge_takes_lateness_from_the_submission_that_was_graded() {
    let class = Class::new("merge-late");
    let folder = class.folder.join("few");
    let put = |name: &str| {
        fs::create_dir_all(folder.join(name)).expect("there is room");
        fs::write(folder.join(name).join("plane.rs"), "// mine").expect("there is room");
    };
    put("lovelaceada_2001_501_hw");
    put("boolebob_2002_502_hw");
    let policy = class.folder.join("policy.toml");
    let rules = "time_zone = 'UTC'\ndeadline = '2026-11-20 23:59'\n";
    fs::write(policy, rules).expect("there is room");
    let (few, policy) = (class.path("few"), class.path("policy.toml"));
    let (one, two, merged) = (class.path("one"), class.path("two"), class.path("merged"));
    let grade = |out: &str, shard: &str| {
        let line = ["grade", &few, "--no-fresh", "--out", out, "--shard", shard];
        on_small_assignment(&[&line[..], &["--policy", &policy]].concat()).expect_code(1);
    };
    grade(&two, "2/2");
    // Bob hands in again, late, before the first part is graded.
    fs::remove_dir_all(folder.join("boolebob_2002_502_hw")).expect("it is there");
    put("boolebob_LATE_2002_503_hw");
    grade(&one, "1/2");
    for parts in [[&one, &two], [&two, &one]] {
        on_small_assignment(&["merge", parts[0], parts[1], "--out", &merged])
            .expect_code(1)
            .expect_out("late, but nothing says by how much");
    }
}
