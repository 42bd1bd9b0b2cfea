//! A class as it really arrives, from Canvas, Moodle, GitHub and by e-mail, and its grades.

use std::fs;
use std::path::Path;

use super::{Class, mistake, on_small_assignment};
use pinhole_testing::{TASKS, fresh, root, zip};

/// Right answers by file name. If `sphere` is given, it replaces that answer.
fn answers(folder: &str, sphere: Option<&str>) -> Vec<(String, Vec<u8>)> {
    let reference = root().join("assignments/ray_casting/reference/src");
    let file = |task: &&str| {
        let name = format!("{task}.rs");
        let text = fs::read(reference.join(&name)).expect("it is there");
        let text = match (*task, sphere) {
            ("sphere", Some(sphere)) => sphere.as_bytes().to_vec(),
            _ => text,
        };
        (format!("{folder}{name}"), text)
    };
    TASKS.iter().map(file).collect()
}

fn put(folder: &Path, files: &[(String, Vec<u8>)]) {
    for (name, bytes) in files {
        let path = folder.join(name);
        fs::create_dir_all(path.parent().expect("it has one")).expect("there is room");
        fs::write(path, bytes).expect("there is room");
    }
}

/// A roster with semicolons and one byte per letter, as a spreadsheet in Germany writes it.
const ROSTER: &str = "id;name;section;github\r\n1;Ada Lovelace;A\r\n2;Yu Yang;A\r\n\
    3;Grace Hopper;A\r\n4;Zoë Müller;B\r\n5;Alan Turing;B;alan-turing\r\n\
    e@uni.example;Emmy Noether;B\r\n7;Gus Ghost;B\r\n";

#[test]
fn a_class_from_four_places_is_matched_judged_and_summed_up() {
    let class = Class {
        folder: fresh(&std::env::temp_dir(), "exports"),
    };
    let near = mistake("sphere_near_root_only", "sphere");
    let mut canvas = Vec::new();
    let mut built = answers("hw1/src/", None);
    built.push(("hw1/target/release/sphere.rs".into(), b"built".to_vec()));
    canvas.push(("lovelaceada_11_501_hw1.zip".into(), zip(&built)));
    for (k, (name, bytes)) in answers("", None).into_iter().enumerate() {
        canvas.push((format!("yangyu_LATE_1025_{}_{name}", 99_001 + k), bytes));
    }
    put(&class.folder, &[("submissions.zip".into(), zip(&canvas))]);
    let moodle = |name: &str| format!("moodle/{name}_assignsubmission_file");
    let archive = zip(&answers("", Some(&near)));
    put(
        &class.folder.join(moodle("Grace Hopper_2001")),
        &[("hw1.zip".into(), archive)],
    );
    let mut files = answers("", None);
    files[1].0 = "Sphere (1).rs".into();
    // macOS decomposes letters with accents.
    put(
        &class.folder.join(moodle("Zoe\u{308} Mu\u{308}ller_2002")),
        &files,
    );
    let layout = "hw1-alan-turing/assignments/ray_casting/handout/src/";
    put(&class.folder.join("github"), &answers(layout, None));
    let mut files = answers("e@uni.example/My files/CG/src/", None);
    files.remove(2);
    put(&class.folder.join("mail"), &files);
    fs::write(class.folder.join("mail/notes.txt"), "mine").expect("there is room");
    let roster: Vec<u8> = ROSTER.chars().map(|c| c as u32 as u8).collect();
    fs::write(class.folder.join("roster.csv"), roster).expect("there is room");

    fs::write(class.folder.join("policy.toml"), POLICY).expect("there is room");
    fs::write(class.folder.join("times.csv"), TIMES).expect("there is room");

    let paths = ["submissions.zip", "moodle", "github", "mail"].map(|name| class.path(name));
    let (roster, out) = (class.path("roster.csv"), class.path("out"));
    let mut line = vec!["grade", "--roster", &roster, "--no-fresh"];
    line.extend(["--named", "hw1-{github}"]);
    line.extend(paths.iter().map(String::as_str));
    on_small_assignment(&[&line[..], &["--dry-run"]].concat())
        .expect_code(1)
        .expect_out("lovelaceada_11: Ada Lovelace [1]: 6 of 6 answer files")
        .expect_out("of 7 people on the roster, 6 are ready to be graded; 1 handed in nothing; ")
        .expect_out("; 1 submission lacks answer files; ");
    assert!(!Path::new(&out).exists(), "nothing is graded");

    let policy = class.path("policy.toml");
    let formats = ["csv", "canvas", "moodle", "feedback"].map(|format| ["--format", format]);
    let more = ["--out", &out, "--policy", &policy];
    let ran = on_small_assignment(&[&line[..], &more, &formats.concat()].concat());
    ran.expect_code(1)
        .expect_out("6 are graded; 1 handed in nothing; 1 submission lacks answer files; ")
        .expect_out("(Emmy Noether [e@uni.example]): plane.rs is missing")
        .expect_out("`Sphere (1).rs` was taken as `sphere.rs`")
        .expect_out("Gus Ghost [7]")
        .expect_out("not in canvas.csv, because")
        .expect_out("not in moodle.csv, because");
    let csv = class.read("out/grades.csv");
    let marks = marks_by_id(&csv);
    let of = |id: &str| marks.iter().find(|(who, ..)| who == id).expect("a line");
    for id in ["1", "2", "4", "5"] {
        assert_eq!(of(id).1, "100", "{csv}");
    }
    assert!(
        of("3").1.parse::<u32>().is_ok_and(|points| points < 100),
        "{csv}"
    );
    assert_eq!(of("e@uni.example").2, "missing file");
    assert_eq!(of("7").2, "nothing handed in");
    let groups = class.read("out/groups.csv");
    assert!(groups.contains("\n4,Zoë Müller,"), "{groups}");
    let page = class.read("out/class.html");
    let top = page
        .split("id=\"points\"")
        .next()
        .expect("it has a beginning");
    for words in [
        "of 7 people on the roster, 6 are graded",
        "plane.rs is missing",
        "notes.txt",
    ] {
        assert!(top.contains(words), "no {words:?} above the points:\n{top}");
    }
    policy_reaches_every_way_out(&class);
    let (merged, milder) = (class.path("merged"), class.path("milder.toml"));
    fs::write(&milder, POLICY.replace("percent = 10", "percent = 5")).expect("there is room");
    on_small_assignment(&["merge", &out, "--policy", &milder, "--out", &merged]).expect_code(1);
    let csv = class.read("merged/grades.csv");
    assert_eq!(cell(&csv, "2", "final"), "95", "{csv}");
    // A single submission doesn't change the policy for everyone, and no run forgets it.
    let one = class.path("github/hw1-alan-turing");
    let single = [
        "grade",
        "--no-fresh",
        "--out",
        &out,
        &one,
        "--policy",
        &milder,
    ];
    for line in [&single[..], &[&line[..], &["--out", &out]].concat()] {
        on_small_assignment(line)
            .expect_code(2)
            .expect_err("graded with another --policy");
    }
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        for file in [
            "grades.csv",
            "class.html",
            "submissions/lovelaceada_11/result.json",
        ] {
            let metadata = fs::metadata(Path::new(&out).join(file)).expect("it is there");
            assert_eq!(metadata.permissions().mode() & 0o777, 0o600, "{file}");
        }
    }

    // Grade one of them again: the others keep their marks.
    let grace = class.folder.join(moodle("Grace Hopper_2001"));
    put(&grace, &[("hw1.zip".into(), zip(&answers("", None)))]);
    let grace = grace.to_str().expect("a plain name");
    on_small_assignment(&["grade", grace, "--no-fresh", "--out", &out])
        .expect_code(1)
        .expect_out("of 7 people on the roster, 6 are graded")
        .expect_out(OLD_TIMES);
    let again = class.read("out/grades.csv");
    assert_eq!(marks_by_id(&again).len(), 7);
    let grace = marks_by_id(&again).into_iter().find(|(id, ..)| id == "3");
    assert_eq!(grace.expect("a line").1, "100", "{again}");
    assert_eq!(cell(&again, "2", "final"), "90", "the policy stays");
    assert!(
        !class.folder.join("out/groups.csv").exists(),
        "nobody asked for it"
    );
    old_times_are_listed_wherever_marks_are(&class, &[&line[..], &more].concat());
}

const OLD_TIMES: &str = "with the same time in the table";

/// Checks that Grace's new answers are listed until there is a newer table of times. `whole` grades
/// the class.
fn old_times_are_listed_wherever_marks_are(class: &Class, whole: &[&str]) {
    on_small_assignment(whole)
        .expect_code(1)
        .expect_out(OLD_TIMES);
    // One part has noticed the change, and the other has not.
    let roll = class.read("out/roll.json");
    let mut unaware: serde_json::Value = serde_json::from_str(&roll).expect("it is JSON");
    unaware["timed"] = serde_json::json!([]);
    put(
        &class.folder,
        &[("part/roll.json".into(), unaware.to_string().into_bytes())],
    );
    let [out, part, merged] = ["out", "part", "merged"].map(|name| class.path(name));
    let [policy, new] = ["policy.toml", "new"].map(|name| class.path(name));
    let merge = |more: &[&str]| {
        let ran = on_small_assignment(&[&["merge"], more, &["--policy", &policy]].concat());
        ran.expect_code(1).out.contains(OLD_TIMES)
    };
    assert!(merge(&[&out, &part, "--out", &new]));
    // No part has noticed the change, but the class was merged before.
    fs::write(class.folder.join("out/roll.json"), unaware.to_string()).expect("there is room");
    assert!(merge(&[&out, "--out", &merged]));
    let newer = TIMES.replace("3,2026-11-20", "3,2026-11-19");
    fs::write(class.folder.join("times.csv"), newer).expect("there is room");
    assert!(!merge(&[&merged, "--out", &new]));
}

const POLICY: &str = "time_zone = 'Europe/Berlin'\ndeadline = '2026-11-20 23:59'\n\
    times = 'times.csv'\ngradebook_column = 'Homework 1 (22)'\n\
    [late]\npercent = 10\nper = 'day'\nof = 'earned'\n\
    [[adjust]]\nid = '4'\npoints = -1.5\nreason = 'as agreed <on Monday>'\n";

const TIMES: &str = "id,time\n1,2026-11-20 12:00\n2,2026-11-21 12:00\n3,2026-11-20 12:00\n\
    4,2026-11-20 12:00\n5,2026-11-20 12:00\ne@uni.example,2026-11-20 12:00\n";

/// Checks the raw, policy and final marks in the list, on the page, in reports and in files for
/// platforms.
fn policy_reaches_every_way_out(class: &Class) {
    let csv = class.read("out/grades.csv");
    for (id, marks) in [
        ("1", ["100"; 3]),
        ("2", ["100", "90", "90"]),
        ("4", ["100", "100", "98.5"]),
    ] {
        let found = ["raw", "policy", "final"].map(|name| cell(&csv, id, name));
        assert_eq!(found, marks, "{csv}");
    }
    let late = "−10: handed in 2026-11-21 12:00, 1 day late: 10 percent of the points earned";
    assert_eq!(cell(&csv, "2", "changes"), late);
    assert!(class.read("out/class.html").contains(late));
    // A section may be a single person, who would be named with their points.
    let sections = "<h2 id=\"sections\">";
    assert!(class.read("out/class.html").contains(sections));
    let names = class.read("out/class_without_names.html");
    for name in [
        "Lovelace",
        "Hopper",
        "lovelaceada",
        "submissions/",
        sections,
    ] {
        assert!(!names.contains(name), "{name} is named");
    }
    let canvas = class.read("out/canvas.csv");
    let head = "Student,ID,SIS User ID,SIS Login ID,Section,Homework 1 (22)\n    Points Possible,,,,,100\n";
    assert!(canvas.starts_with(head), "{canvas}");
    assert!(canvas.contains("\nYu Yang,,2,,A,90\n"), "{canvas}");
    let moodle = class.read("out/moodle.csv");
    assert!(
        moodle.contains("\n,4,98.5,,Changes to your mark: −1.5: as agreed <on Monday>\n"),
        "{moodle}"
    );
    let unpack = |name: &str, file: &str| {
        let archive = fs::File::open(class.folder.join("out").join(name)).expect(name);
        let mut archive = zip::ZipArchive::new(archive).expect("it is an archive");
        let mut file = archive.by_name(file).expect(file);
        std::io::read_to_string(&mut file).expect("it is text")
    };
    let yu = unpack("feedback-canvas.zip", "yangyu_LATE_1025_99006_report.html");
    assert!(yu.contains("Your mark: 90 of 100") && yu.contains(late));
    let zoe = "Zoe\u{308} Mu\u{308}ller_2002_assignsubmission_file/report.html";
    let zoe = unpack("feedback-moodle.zip", zoe);
    assert!(zoe.contains("−1.5: as agreed &lt;on Monday&gt;"));
    assert_eq!(unpack("feedback.zip", "4/report.html"), zoe);
}

/// A cell of `grades.csv` by the person's id and the column's name.
fn cell(csv: &str, id: &str, name: &str) -> String {
    let mut reader = csv::Reader::from_reader(csv.trim_start_matches('\u{feff}').as_bytes());
    let header = reader.headers().expect("it has a first line").clone();
    let column = header.iter().position(|it| it == name).expect(name);
    let mut rows = reader.records().map(|row| row.expect("it is CSV"));
    rows.find(|row| &row[0] == id).expect(id)[column].to_owned()
}

/// Lines of `grades.csv` by the person's id: points and outcome.
fn marks_by_id(csv: &str) -> Vec<(String, String, String)> {
    let mut reader = csv::Reader::from_reader(csv.as_bytes());
    let rows = reader.records().map(|row| row.expect("it is CSV"));
    rows.map(|row| (row[0].to_owned(), row[4].to_owned(), row[6].to_owned()))
        .collect()
}
