//! Points for examples, in a copy of the small assignment that gives some.

use std::fs;
use std::path::{Path, PathBuf};

use pinhole_testing::{RunResult, fresh, pinhole, trusted};

use super::fixture::copy;

/// Both examples are right, and together they catch both mistakes.
const RIGHT: &str = "task = \"disk\"
[[example]]
group = \"min_t\"
question = 1
hit = true
[[example]]
group = \"min_t\"
question = 4
hit = false
";

/// A line break in an inline table is TOML 1.1, which Python doesn't read.
const OWN: &str = "[[example]]
ray = { e = [0, 0, 4], d = [0, 0, -2],
        min_t = 0 }
shape = { center = [0, 0, 0], normal = [0, 0, 1], radius = 1 }
t = 2
";

struct Class {
    assignment: PathBuf,
    folder: PathBuf,
}

impl Class {
    /// A class whose only task has this line about examples.
    fn new(name: &str, examples: &str) -> Class {
        let assignment = copy(&format!("{name}-course"));
        let folder = fresh(&trusted(), name);
        let class = Class { assignment, folder };
        class.change("[[scene]]", &format!("{examples}\n[[scene]]"));
        class
    }

    fn change(&self, from: &str, to: &str) {
        let path = self.assignment.join("assignment.toml");
        let text = fs::read_to_string(&path).expect("it was copied");
        assert!(text.contains(from), "{text}");
        fs::write(path, text.replacen(from, to, 1)).expect("it can be written");
    }

    /// Hands in the right answer and these examples, if there are any.
    fn hand_in(&self, who: &str, examples: &str) {
        let to = self.folder.join("class").join(who);
        fs::create_dir_all(&to).expect("a folder can be made");
        let answer = self.assignment.join("reference/src/disk.rs");
        fs::copy(answer, to.join("disk.rs")).expect("it can be copied");
        if !examples.is_empty() {
            fs::write(to.join("disk.examples.toml"), examples).expect("it can be written");
        }
    }

    fn run(&self, arguments: &[&str]) -> RunResult {
        pinhole(&[arguments, &["--assignment", plain(&self.assignment)]].concat())
    }

    /// Grades the class. Returns how many submissions were graded now, and the points of examples.
    fn grade(&self) -> (u64, String) {
        let (class, out) = (self.folder.join("class"), self.folder.join("out"));
        let line = ["grade", plain(&class), "--out", plain(&out), "--no-fresh"];
        let more = ["--json", "--format", "csv", "--format", "gradescope"];
        let told = self.run(&[&line[..], &more].concat()).json();
        let groups = self.read("groups.csv");
        let lines = groups.lines().map(|line| line.split(',').collect());
        let lines = lines.filter(|line: &Vec<&str>| line[4] == "examples");
        let points: Vec<String> = lines
            .map(|line| format!("{} {}", line[2], line[5]))
            .collect();
        let now = told["graded_now"].as_u64().expect("a number");
        (now, points.join(", "))
    }

    fn read(&self, file: &str) -> String {
        fs::read_to_string(self.folder.join("out").join(file)).expect("it was written")
    }
}

fn plain(path: &Path) -> &str {
    path.to_str().expect("test folders have plain names")
}

#[test]
fn examples_earn_all_their_points_or_none() {
    let class = Class::new("examples", "examples = { points = 2, catch = 0.8 }");
    let few = &RIGHT[..RIGHT.rfind("[[").expect("two examples")];
    let wrong = RIGHT.replace("false", "true");
    let evil = format!("<script>alert(1)</script>\u{202e}{}", "x".repeat(2000));
    // More own rays than fit into one row of a film, each with another t.
    let many: String = (1..=40)
        .map(|t| {
            OWN.replace("4]", &format!("{}]", 2 * t))
                .replace("t = 2", &format!("t = {t}"))
        })
        .collect();
    // The ray hits, but its t is too large for single precision.
    let beyond = OWN
        .replace("4], d = [0, 0, -2]", "3.4e38], d = [0, 0, -1]")
        .replace("0], n", "-3.4e38], n")
        .replace("t = 2", "hit = false");
    for (who, examples) in [
        ("beyond", &*format!("{RIGHT}{beyond}")),
        ("evil", &few.replace("min_t", &evil)),
        ("few", few),
        ("huge", &"#".repeat(300_000)),
        ("many", &format!("{RIGHT}{many}")),
        ("none", ""),
        ("own", &format!("{RIGHT}{OWN}")),
        ("right", RIGHT),
        ("wrong", &wrong),
    ] {
        class.hand_in(who, examples);
    }
    let points = "beyond 0, evil 0, few 0, huge 0, many 2, none 0, own 2, right 2, wrong 0";
    assert_eq!(class.grade(), (9, points.into()));
    let report = class.read("submissions/beyond/report.html");
    assert!(report.contains("precision is too low for own ray 0"));
    let report = class.read("submissions/evil/report.html");
    let shown = |part: &str| report.contains(part);
    assert!(shown("alert(1)") && !shown("<script>alert") && !shown("\u{202e}"));
    assert!(!shown(&"x".repeat(1000)), "a long message is cut");
    let report = class.read("submissions/few/report.html");
    assert!(report.contains("they catch 1 of 2 mistakes, and must catch 2"));
    let tests = class.read("submissions/wrong/gradescope.json");
    assert!(tests.contains("1 example is wrong\\nexample   min_t 4\\n"));
    assert!(class.read("grades.csv").contains(",right,22,22,graded,"));

    class.change("points = 2, catch", "points = 5, catch");
    class.hand_in("right", &wrong);
    class.hand_in("none", RIGHT);
    let points = "beyond 0, evil 0, few 0, huge 0, many 5, none 5, own 5, right 0, wrong 0";
    assert_eq!(class.grade(), (2, points.into()));
    class.change("catch = 0.8", "catch = 0.5");
    let points = "beyond 0, evil 0, few 5, huge 0, many 5, none 5, own 5, right 0, wrong 0";
    assert_eq!(class.grade(), (9, points.into()));
    class.change("catch = 0.5", "catch = 5");
    let problem = "assignment.toml:19: `disk` can't have these `examples`";
    class.run(&["check"]).expect_code(2).expect_err(problem);
}

#[test]
fn check_judges_and_packs_examples_only_if_they_earn_points() {
    for (examples, total, packed) in [
        ("examples = { points = 2, catch = 1 }", "22 / 22", "2 files"),
        ("", "20 / 20", "1 answer"),
    ] {
        let class = Class::new("examples-packed", examples);
        class.hand_in("ada", RIGHT);
        let (ada, zip) = (class.folder.join("class/ada"), class.folder.join("ada.zip"));
        let pack = ["check", plain(&ada), "--no-report", "--pack", plain(&zip)];
        class.run(&pack).expect_code(0).expect_out(packed);
        let again = class.run(&["check", plain(&zip), "--no-report"]);
        again.expect_code(0).expect_out(total);
        class.hand_in("ada", "nonsense");
        let stub = class.assignment.join("handout/src/disk.rs");
        fs::copy(stub, ada.join("disk.rs")).expect("it can be copied");
        let said = class.run(&pack).expect_code(1).expect_out("unanswered").out;
        class.grade();
        let graded = ["result.json", "report.html"]
            .map(|file| class.read(&format!("submissions/ada/{file}")));
        let [result, report] = graded;
        for text in [said, result, report] {
            let is_judged = text.contains("disk.examples.toml: TOML parse error at line 1");
            assert_eq!(is_judged, !examples.is_empty(), "{text}");
        }
    }
}
