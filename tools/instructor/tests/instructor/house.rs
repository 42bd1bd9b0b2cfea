//! Rules of this project that no compiler checks.

use std::fs;
use std::path::Path;
use std::process::Command;

use pinhole_testing::{TASKS, fresh, pinhole, root, trusted};

#[test]
fn the_handout_matches_the_reference_and_holds_no_answer() {
    pinhole(&["handout", "--check"]).expect_code(0);
    let course = root().join("assignments/ray_casting");
    for task in TASKS {
        let read = |package: &str| {
            let path = course.join(package).join("src").join(format!("{task}.rs"));
            fs::read_to_string(path).expect("both packages have every answer")
        };
        let (reference, handout) = (read("reference"), read("handout"));
        let answer = reference
            .split("// ANCHOR: answer")
            .nth(1)
            .expect("it has an answer");
        let answer = answer
            .split("// ANCHOR_END: answer")
            .next()
            .expect("the answer ends");
        for line in answer.lines().map(str::trim).filter(|line| line.len() > 20) {
            assert!(
                !handout.contains(line),
                "{task}: the handout holds {line:?}"
            );
        }
        assert!(handout.contains(&format!("todo!(\"{task}\")")), "{task}");
    }
}

/// Runs a snapshot test of the stubs and of the reference in a copy of their folder. It
/// passes for the reference, so the stubs alone decide.
fn handout_tests(settings: &[(&str, &str)], workspace: &Path) -> (bool, String) {
    let cargo = std::env::var("CARGO").unwrap_or("cargo".into());
    let mut command = Command::new(cargo);
    // Test the packages that `tools/test` tests together, because cargo would build others again,
    // with other features.
    let others = ["--exclude", "pinhole-book", "--exclude", "pinhole-study"];
    command
        .current_dir(root())
        .args(["test", "--release", "--workspace", "--test", "golden_films"])
        .args(others)
        .args(["--no-fail-fast", "--", "--exact", "sphere"]);
    command.env("INSTA_WORKSPACE_ROOT", workspace);
    command.env_remove("INSTA_UPDATE");
    command.envs(settings.iter().copied());
    let output = command.output().expect("cargo runs");
    let said = String::from_utf8_lossy(&output.stdout).into_owned();
    (
        output.status.success(),
        said + &String::from_utf8_lossy(&output.stderr),
    )
}

#[test]
fn no_setting_of_insta_turns_a_wrong_film_green_or_touches_a_golden() {
    let workspace = fresh(&trusted(), "insta");
    let snapshots = "assignments/ray_casting/tests/snapshots";
    let copy = workspace.join(snapshots);
    // insta's path to the folder leads through the package's folder, which must exist, too.
    for package in ["handout", "reference"] {
        let folder = workspace.join("assignments/ray_casting").join(package);
        fs::create_dir_all(folder).expect("it can be made");
    }
    fs::create_dir_all(&copy).expect("it can be made");
    for entry in fs::read_dir(root().join(snapshots))
        .expect("they are committed")
        .flatten()
    {
        fs::copy(entry.path(), copy.join(entry.file_name())).expect("it can be copied");
    }
    let perfect = fs::read_to_string(copy.join("sphere.snap")).expect("it was copied");

    for settings in [
        &[][..],
        &[("INSTA_UPDATE", "always")],
        &[("INSTA_FORCE_PASS", "1")],
        &[("INSTA_UPDATE", "no")],
    ] {
        let (green, said) = handout_tests(settings, &workspace);
        assert!(
            !green && said.contains("is not right yet\nunanswered"),
            "{settings:?} turned it green:\n{said}"
        );
    }
    let after = fs::read_to_string(copy.join("sphere.snap")).expect("it is still there");
    assert_eq!(after, perfect, "a wrong answer replaced the snapshot");
    pinhole(&["golden", "verify"]).expect_code(0);
}
