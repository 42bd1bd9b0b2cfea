//! What students are given: all they need, nothing they must not have, and a repository
//! that works on a machine with Rust alone.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use crate::course::{Ran, TASKS, fresh, pinhole, root, trusted};

/// Every file of a folder, by path inside it.
fn files(folder: &Path) -> BTreeMap<String, Vec<u8>> {
    let mut files = BTreeMap::new();
    let mut folders = vec![folder.to_owned()];
    while let Some(next) = folders.pop() {
        for entry in fs::read_dir(&next).expect("it can be read").flatten() {
            let path = entry.path();
            match path.is_dir() {
                true => folders.push(path),
                false => {
                    let name = path.strip_prefix(folder).expect("it lies inside");
                    let bytes = fs::read(&path).expect("it can be read");
                    files.insert(name.to_string_lossy().into_owned(), bytes);
                }
            }
        }
    }
    files
}

fn plain(path: &Path) -> &str {
    path.to_str().expect("test folders have plain names")
}

fn handed_out(name: &str) -> PathBuf {
    let out = fresh(&trusted(), name).join("students");
    pinhole(&["handout", "ray_casting", "--out", plain(&out)])
        .expect_code(0)
        .expect_out("files, ");
    out
}

/// The lines of the `.rs` files in a folder and below, file by file, without blank ones.
fn sources(folder: &Path) -> Vec<Vec<String>> {
    let rust = files(folder)
        .into_iter()
        .filter(|(path, _)| path.ends_with(".rs"));
    rust.map(|(_, bytes)| lines(&bytes)).collect()
}

fn lines(bytes: &[u8]) -> Vec<String> {
    let text = String::from_utf8_lossy(bytes);
    let lines = text.lines().map(|line| line.trim().to_owned());
    lines.filter(|line| !line.is_empty()).collect()
}

#[test]
fn a_students_repository_holds_no_answer_no_mistake_no_variant_and_at_most_20_megabytes() {
    let out = handed_out("handout-leaks");
    let given = files(&out);
    let bytes: usize = given.values().map(Vec::len).sum();
    assert!(bytes <= 20_000_000, "{bytes} bytes");
    for path in given.keys() {
        let ours = [
            "reference",
            "mistakes/",
            "variants/",
            "tools/mitsuba/",
            "tools/src/validate",
            "benches",
            "tests/cli",
        ];
        let found = ours.iter().find(|word| path.contains(*word));
        assert!(found.is_none(), "{path}");
    }

    let secrets = Secrets::of_the_course(&out);
    let told = given.iter().find_map(|(path, bytes)| {
        let told = secrets.told_by(bytes)?;
        Some(format!("{path} tells {told}"))
    });
    assert_eq!(told, None);

    // And the search finds what it is for, in any kind of file.
    let course = root().join("assignments/ray_casting");
    for leak in [
        "reference/src/sphere.rs",
        "mistakes/sphere_near_root_only/sphere.rs",
        "variants/triangle_qr/triangle.rs",
    ] {
        let source = fs::read(course.join(leak)).unwrap_or_else(|error| panic!("{leak}: {error}"));
        assert!(secrets.told_by(&source).is_some(), "{leak} is not found");
    }
    let picture = b"\x89PNG\xff\x00let discriminant = h * h - a * c;\x00IEND";
    assert!(secrets.told_by(picture).is_some(), "not found in a picture");
}

/// What no file for students may hold.
struct Secrets {
    /// Any one of them is a part of an answer.
    lines: Vec<String>,
    /// Two lines of a wrong or another right answer, one after the other; sorted.
    pairs: Vec<(String, String)>,
}

impl Secrets {
    /// All of the course's, but what stands in the stubs of a student's repository.
    fn of_the_course(students: &Path) -> Secrets {
        let course = root().join("assignments/ray_casting");
        let stubs: Vec<String> =
            sources(&students.join("assignments/ray_casting/handout")).concat();
        let is_secret = |line: &str| !stubs.iter().any(|stub| stub == line);
        // One line alone: `match camera.projection {` is no answer, `let h = …` is a part of one.
        let answers: Vec<String> = sources(&course.join("reference")).concat();
        let telling = |line: &&String| {
            line.len() >= 24 && !line.ends_with('{') && !line.contains("ANCHOR") && is_secret(line)
        };
        let lines: Vec<String> = answers.iter().filter(telling).cloned().collect();
        assert!(lines.len() > 20, "the search knows too little");
        // Two lines together: what wrong and other right answers are made of.
        let mut pairs = Vec::new();
        for kind in ["reference", "mistakes", "variants"] {
            for source in sources(&course.join(kind)) {
                let two = source
                    .windows(2)
                    .filter(|two| two.iter().all(|line| is_secret(line)))
                    // That there are two projections is told by the stubs as well.
                    .filter(|two| !two.iter().all(|line| line.starts_with("Projection::")));
                let long = two.filter(|two| two.concat().len() >= 48);
                pairs.extend(long.map(|two| (two[0].clone(), two[1].clone())));
            }
        }
        assert!(pairs.len() > 1000, "the search knows too little");
        pairs.sort();
        Secrets { lines, pairs }
    }

    /// What a file tells, of whatever kind it is.
    fn told_by(&self, bytes: &[u8]) -> Option<String> {
        let text = String::from_utf8_lossy(bytes);
        if let Some(line) = self.lines.iter().find(|line| text.contains(line.as_str())) {
            return Some(line.clone());
        }
        let lines = lines(bytes);
        let both = |two: &&[String]| {
            let two = (two[0].clone(), two[1].clone());
            self.pairs.binary_search(&two).is_ok()
        };
        lines.windows(2).find(both).map(|two| two.join(" / "))
    }
}

/// A file of the course with something that must not travel, and why it is refused.
#[test]
#[cfg(target_os = "linux")]
fn whatever_file_would_give_something_away_it_is_refused() {
    let folder = fresh(&trusted(), "handout-refused");
    let answer = "let discriminant = h * h - a * c;";
    let own = root().join("assignments/ray_casting/assignment.toml");
    let own = fs::read_to_string(own).expect("it is there");
    let row = "name = \"sphere_packing\"\n";
    let assignment = folder.join("assignment.toml");
    let text = own.replace(row, &format!("{row}public = false\n"));
    fs::write(&assignment, text).expect("it can be written");
    let golden = root().join("golden/ray_casting/sphere_packing.exr");
    let golden = fs::read(golden).expect("it is there");
    let hash = sha256(&golden);
    let with = |path: &str, more: &str| {
        let mut bytes = fs::read(root().join(path)).expect("it is there");
        bytes.extend_from_slice(more.as_bytes());
        bytes
    };
    let readme = fs::read_to_string(root().join("README.md")).expect("it is there");
    let heading = "## For students\n";
    let named = readme.replace(heading, &format!("{heading}\nSee `sphere_packing`.\n"));
    let line = "would give away a line of the reference";
    let cases: [(&str, Vec<u8>, &str); 5] = [
        (
            "src/ray.rs",
            with("src/ray.rs", &format!("// {answer}\n")),
            line,
        ),
        (
            "book/figures/id.png",
            with("book/figures/id.png", answer),
            line,
        ),
        ("README.md", named.into(), "the name of the withheld scene"),
        (
            "book/figures/id.png",
            with("book/figures/id.png", &hash),
            "the hash of a withheld",
        ),
        ("book/figures/id.png", golden, "a file of a withheld scene"),
    ];
    for (path, bytes, why) in cases {
        let instead = folder.join("instead");
        fs::write(&instead, bytes).expect("it can be written");
        let files = [
            (
                "assignments/ray_casting/assignment.toml",
                assignment.as_path(),
            ),
            (path, instead.as_path()),
        ];
        let out = folder.join("students");
        pinhole_where(&files, &["handout", "--out", plain(&out)])
            .expect_code(2)
            .expect_err(path)
            .expect_err(why);
        assert!(!out.exists(), "{path}");
    }
}

#[test]
fn a_built_book_travels_and_one_that_shows_an_answer_does_not() {
    let folder = fresh(&trusted(), "handout-book");
    let (book, out) = (folder.join("built"), folder.join("students"));
    let hand_out = || pinhole(&["handout", "--out", plain(&out), "--book", plain(&book)]);
    fs::create_dir_all(&book).expect("there is room");
    let sphere = fs::read_to_string(root().join("assignments/ray_casting/reference/src/sphere.rs"));
    let sphere = sphere.expect("it is there");
    let answer = sphere.lines().find(|line| line.contains("discriminant ="));
    fs::write(book.join("sphere.html"), answer.expect("it has one")).expect("there is room");
    hand_out()
        .expect_code(2)
        .expect_err("book/sphere.html would give away a line of the reference");
    fs::write(book.join("sphere.html"), "<h1>Sphere</h1>").expect("there is room");
    hand_out().expect_code(0);
    let page = fs::read_to_string(out.join("book/sphere.html")).expect("it came along");
    assert_eq!(page, "<h1>Sphere</h1>");
}

/// Runs `pinhole` where files of the checkout are others, without touching the checkout.
#[cfg(target_os = "linux")]
fn pinhole_where(files: &[(&str, &Path)], arguments: &[&str]) -> Ran {
    let mut walled = Command::new("bwrap");
    walled.args(["--dev-bind", "/", "/"]);
    for (path, instead) in files {
        walled.arg("--ro-bind").arg(instead).arg(root().join(path));
    }
    let output = walled
        .arg(env!("CARGO_BIN_EXE_pinhole"))
        .args(arguments)
        .current_dir(root())
        .output()
        .expect("bubblewrap is installed");
    crate::course::ran(output)
}

#[test]
#[cfg(target_os = "linux")]
fn nothing_of_a_withheld_scene_travels_but_its_points() {
    let folder = fresh(&trusted(), "handout-withheld");
    let own = root().join("assignments/ray_casting/assignment.toml");
    let text = fs::read_to_string(own).expect("it is there");
    let row = "name = \"sphere_packing\"\n";
    assert!(text.contains(row));
    let withheld = folder.join("assignment.toml");
    let text = text.replace(row, &format!("{row}public = false\n"));
    fs::write(&withheld, text).expect("it can be written");
    let out = folder.join("students");
    let path = "assignments/ray_casting/assignment.toml";
    let ran = pinhole_where(
        &[(path, &withheld)],
        &["handout", "--out", plain(&out), "--json"],
    );
    let document = ran.expect_code(0).json();
    assert_eq!(document["withheld"], serde_json::json!(["sphere_packing"]));

    let hashes: Vec<String> = files(&root().join("golden/ray_casting"))
        .into_iter()
        .filter(|(path, _)| path.starts_with("sphere_packing"))
        .map(|(_, bytes)| sha256(&bytes))
        .collect();
    assert!(hashes.len() >= 6, "{hashes:?}");
    for (path, bytes) in files(&out) {
        assert!(!path.contains("sphere_packing"), "{path}");
        let text = String::from_utf8_lossy(&bytes);
        let is_ours = path.starts_with("src/") || path.starts_with("tools/");
        assert!(
            is_ours || !text.contains("sphere_packing"),
            "{path} names it"
        );
        let told = hashes.iter().find(|hash| text.contains(hash.as_str()));
        assert!(
            told.is_none() && !hashes.contains(&sha256(&bytes)),
            "{path} holds its hash"
        );
    }
    // What is public is all there, and in step.
    let given = out.join(path);
    pinhole_where(
        &[(path, &given)],
        &["check", "assignments/ray_casting/reference", "--no-report"],
    )
    .expect_code(0)
    .expect_out("99 of 100 points can be seen here");
    pinhole(&["golden", "verify", plain(&out.join("golden/ray_casting"))]).expect_code(0);
}

fn sha256(bytes: &[u8]) -> String {
    use sha2::{Digest, Sha256};

    let hash = Sha256::digest(bytes);
    hash.iter().map(|byte| format!("{byte:02x}")).collect()
}

#[test]
fn nobodys_own_files_are_overwritten() {
    let out = handed_out("handout-force");
    let again = |force: &[&str]| {
        let arguments = [&["handout", "--out", plain(&out)], force].concat();
        pinhole(&arguments)
    };
    again(&[]).expect_code(2).expect_err("not empty");
    // What is not the handout's stays; what is comes back.
    fs::write(out.join("notes.txt"), "mine").expect("it can be written");
    fs::remove_file(out.join("src/lib.rs")).expect("it was written");
    again(&["--force"]).expect_code(0);
    assert_eq!(
        fs::read_to_string(out.join("notes.txt")).expect("it stays"),
        "mine"
    );
    assert!(out.join("src/lib.rs").is_file());

    let before = files(&out);
    let answer = "assignments/ray_casting/handout/src/sphere.rs";
    fs::write(out.join(answer), "// my answer").expect("it can be written");
    fs::remove_file(out.join("src/lib.rs")).expect("it was written");
    again(&["--force"]).expect_code(2).expect_err(answer);
    assert_eq!(
        fs::read(out.join(answer)).expect("it stays"),
        b"// my answer"
    );
    assert!(!out.join("src/lib.rs").is_file(), "half of it was replaced");
    assert_eq!(
        files(&out).len(),
        before.len() - 1,
        "something was left behind"
    );

    let foreign = fresh(&trusted(), "handout-foreign");
    fs::write(foreign.join("thesis.tex"), "mine").expect("it can be written");
    pinhole(&["handout", "--out", plain(&foreign), "--force"])
        .expect_code(2)
        .expect_err("no handout of this assignment wrote");
    let parent = out.parent().expect("it has one");
    let beside = fs::read_dir(parent).expect("it can be read").count();
    assert_eq!(beside, 1, "a folder was left beside");
}

#[test]
fn a_record_that_names_files_elsewhere_is_refused() {
    let out = handed_out("handout-record");
    let outside = out.with_file_name("precious");
    fs::write(&outside, "mine").expect("it can be written");
    let record = out.join("handout.toml");
    let text = fs::read_to_string(&record).expect("it was written");
    let hash = sha256(b"mine");
    fs::write(&record, format!("{text}\"../precious\" = \"{hash}\"\n")).expect("it can be written");
    pinhole(&["handout", "--out", plain(&out), "--force"])
        .expect_code(2)
        .expect_err("../precious lies outside the repository");
    assert!(outside.is_file());
}

#[test]
fn an_autograder_holds_both_scripts_and_every_golden() {
    let folder = fresh(&trusted(), "handout-gradescope");
    let file = folder.join("autograder.zip");
    let ran = pinhole(&["handout", "--gradescope", plain(&file), "--json"]).expect_code(0);
    let bytes = ran.json()["gradescope"]["bytes"].as_u64().expect("a size");
    assert_eq!(bytes, fs::metadata(&file).expect("it was written").len());
    let archive = fs::File::open(&file).expect("it was written");
    let mut archive = zip::ZipArchive::new(archive).expect("it is an archive");
    for script in ["setup.sh", "run_autograder"] {
        let entry = archive.by_name(script).expect("it is there");
        assert_eq!(
            entry.unix_mode().map(|mode| mode & 0o777),
            Some(0o755),
            "{script}"
        );
    }
    for golden in files(&root().join("golden")).keys() {
        let name = format!("pinhole/golden/{golden}");
        assert!(archive.by_name(&name).is_ok(), "no {name}");
    }
    archive.extract(&folder).expect("it can be unpacked");
    for script in ["setup.sh", "run_autograder"] {
        let checked = Command::new("bash")
            .arg("-n")
            .arg(folder.join(script))
            .status();
        assert!(checked.expect("bash starts").success(), "{script}");
    }
    // Cargo can read the workspace in it, as it must to build it.
    let cargo = std::env::var("CARGO").unwrap_or("cargo".into());
    let metadata = Command::new(cargo)
        .args(["metadata", "--no-deps", "--offline", "--format-version=1"])
        .current_dir(folder.join("pinhole"))
        .output()
        .expect("cargo starts");
    let said = String::from_utf8_lossy(&metadata.stderr);
    assert!(metadata.status.success(), "{said}");
}

/// A validator from the Python package index, with the schema of GitHub's workflows.
fn check_jsonschema() -> PathBuf {
    let environment = trusted().join("check-jsonschema");
    let program = environment.join("bin").join("check-jsonschema");
    if !program.is_file() {
        let python = Command::new("python3")
            .args(["-m", "venv"])
            .arg(&environment)
            .status();
        assert!(python.expect("python3 starts").success());
        let pip = Command::new(environment.join("bin").join("pip"))
            .args(["install", "--quiet", "check-jsonschema==0.39.0"])
            .status();
        assert!(pip.expect("pip starts").success());
    }
    program
}

#[test]
fn the_workflow_is_one_to_github_pins_its_actions_and_covers_three_systems() {
    let workflow = root().join("tools/templates/handout/check.yml");
    let text = fs::read_to_string(&workflow).expect("it is there");
    for system in ["ubuntu-", "macos-", "windows-"] {
        assert!(text.contains(system), "{system}");
    }
    for line in text.lines().filter(|line| line.contains("uses:")) {
        let commit = line.split('@').nth(1).expect("a version").split(' ').next();
        let is_commit =
            |text: &str| text.len() == 40 && text.chars().all(|c| c.is_ascii_hexdigit());
        assert!(commit.is_some_and(is_commit), "{line}");
    }
    let validate = |file: &Path| {
        let arguments = ["--builtin-schema", "vendor.github-workflows"];
        let mut command = Command::new(check_jsonschema());
        command
            .args(arguments)
            .arg(file)
            .output()
            .expect("it starts")
    };
    let output = validate(&workflow);
    assert!(
        output.status.success(),
        "{}",
        String::from_utf8_lossy(&output.stdout)
    );
    let broken = fresh(&trusted(), "workflow").join("check.yml");
    fs::write(&broken, text.replace("runs-on:", "runs_on:")).expect("it can be written");
    assert!(
        !validate(&broken).status.success(),
        "the schema lets everything pass"
    );
}

/// Runs a command line in a student's repository, on a machine that has Rust, a linker and
/// cargo's cache of the registry, and neither a network nor this checkout.
#[cfg(target_os = "linux")]
fn on_a_fresh_machine(repository: &Path, command_line: &str) -> Ran {
    let home = std::env::var("HOME").expect("there is a home");
    let folder = |variable: &str, default: &str| {
        let default = format!("{home}/{default}");
        std::env::var(variable).unwrap_or(default)
    };
    let registry = format!("{}/registry", folder("CARGO_HOME", ".cargo"));
    let asked = Command::new("rustc").args(["--print", "sysroot"]).output();
    let asked = asked.expect("rustc starts").stdout;
    let sysroot = String::from_utf8(asked).expect("a plain path");
    let sysroot = sysroot.trim();
    let place = "/home/student/pinhole";
    let cache = repository.with_file_name("cargo-home");
    fs::create_dir_all(&cache).expect("it can be made");
    let mut walled = Command::new("bwrap");
    walled.args(["--unshare-all", "--die-with-parent", "--clearenv"]);
    walled.args("--ro-bind /usr /usr --symlink usr/lib /lib --symlink usr/lib64 /lib64".split(' '));
    walled.args("--symlink usr/bin /bin --proc /proc --dev /dev --tmpfs /tmp".split(' '));
    walled.args("--ro-bind-try /etc/alternatives /etc/alternatives".split(' '));
    walled.args(["--ro-bind", sysroot, sysroot]);
    walled.args([
        "--bind",
        plain(&cache),
        "/cargo",
        "--ro-bind",
        &registry,
        "/cargo/registry",
    ]);
    walled.args(["--bind", plain(repository), place, "--chdir", place]);
    walled.args("--setenv HOME /home/student --setenv CARGO_HOME /cargo".split(' '));
    walled.args([
        "--setenv",
        "CARGO_NET_OFFLINE",
        "true",
        "--setenv",
        "CI",
        "true",
    ]);
    walled.args(["--setenv", "PATH", &format!("{sysroot}/bin:/usr/bin")]);
    walled.args(["--", "sh", "-c", command_line]);
    crate::course::ran(walled.output().expect("bubblewrap is installed"))
}

/// The commands that the README tells students to run.
fn commands(readme: &str) -> Vec<String> {
    let mut commands = Vec::new();
    for block in readme.split("```sh\n").skip(1) {
        let block = block.split("```").next().unwrap_or_default();
        let lines = block
            .lines()
            .map(|line| line.split('#').next().unwrap_or_default());
        commands.extend(lines.map(|line| line.trim().to_owned()));
    }
    commands.retain(|command| !command.is_empty());
    commands
}

#[test]
#[cfg(target_os = "linux")]
fn a_machine_with_rust_alone_runs_every_command_red_until_filled_and_green_when_filled() {
    let out = handed_out("handout-fresh");
    let run = |command: &str| on_a_fresh_machine(&out, command);
    run("cargo run --release --locked -- check")
        .expect_code(1)
        .expect_out("unanswered");
    let red = run("cargo test --locked").expect_code(101);
    red.expect_out("is unanswered").expect_out("0 passed");

    // What students do not have is said, not stumbled over.
    for command in [
        "golden render bunny",
        "golden mistakes",
        "golden setup",
        "handout --check",
    ] {
        run(&format!("cargo run --release -- {command}"))
            .expect_code(2)
            .expect_err("this is a student's repository");
    }
    let course = "assignments/ray_casting";
    let stub = out.join(course).join("stubs/src/sphere.rs");
    let text = fs::read_to_string(&stub).expect("it came along");
    fs::write(&stub, text.replace("todo!", "panic!")).expect("it can be written");
    run("cargo run --release -- check --task sphere")
        .expect_code(2)
        .expect_err("stubs/src/sphere.rs is not as it was handed out");
    fs::write(&stub, text).expect("it can be written");

    // An answer that does not compile stops neither the command nor the other answers.
    let answers = out.join(course).join("handout/src");
    let reference = root().join(course).join("reference/src");
    for task in TASKS {
        let name = format!("{task}.rs");
        fs::copy(reference.join(&name), answers.join(&name)).expect("it can be copied");
    }
    let sphere = fs::read_to_string(answers.join("sphere.rs")).expect("it was copied");
    fs::write(answers.join("sphere.rs"), "fn fails(").expect("it can be written");
    run("cargo run --release -- check")
        .expect_code(1)
        .expect_out("does not compile")
        .expect_out("✓ plane");
    fs::write(answers.join("sphere.rs"), sphere).expect("it can be written");

    run("cargo test --locked").expect_code(0);
    let readme = fs::read_to_string(out.join("README.md")).expect("it came along");
    let commands = commands(&readme);
    assert!(commands.len() >= 6, "{commands:?}");
    // `film.exr` is whatever program's: here, our own.
    run("cargo run --release -- render bunny && cp render/film.exr film.exr").expect_code(0);
    for command in commands
        .iter()
        .filter(|command| !command.contains("--watch"))
    {
        run(command).expect_code(0);
    }
    run("cargo run --release -- golden verify").expect_code(0);
    run("cd assignments/ray_casting/handout && cargo run --release -- check")
        .expect_code(0)
        .expect_out("100 / 100");
}
