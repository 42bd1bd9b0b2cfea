//! Gradescope's autograder, and the workflow for GitHub.

use std::fs;
use std::io::Read;
use std::path::Path;
use std::process::Command;

use super::{files, plain};
use crate::grade::check_jsonschema;
use pinhole_testing::{fresh, pinhole, root, trusted};

#[test]
fn an_autograder_holds_both_scripts_and_every_golden() {
    let folder = fresh(&trusted(), "handout-gradescope");
    let file = folder.join("autograder.zip");
    let arguments = [
        "handout",
        "--gradescope",
        plain(&file),
        "--reveal",
        "points",
        "--json",
    ];
    let ran = pinhole(&arguments).expect_code(0);
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
    let mut reveal = String::new();
    let mut entry = archive.by_name("pinhole/reveal").expect("it is there");
    entry.read_to_string(&mut reveal).expect("it is a word");
    assert_eq!(reveal, "points");
    drop(entry);
    for golden in files(&root().join("golden/ray_casting")).keys() {
        let name = format!("pinhole/golden/ray_casting/{golden}");
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
    // Cargo must be able to read the workspace in the archive to build it.
    let cargo = std::env::var("CARGO").unwrap_or("cargo".into());
    let metadata = Command::new(cargo)
        .args(["metadata", "--no-deps", "--offline", "--format-version=1"])
        .current_dir(folder.join("pinhole"))
        .output()
        .expect("cargo starts");
    let said = String::from_utf8_lossy(&metadata.stderr);
    assert!(metadata.status.success(), "{said}");
}

#[test]
fn a_question_for_prairielearn_holds_its_grader_and_every_stub() {
    let out = fresh(&trusted(), "handout-prairielearn").join("question");
    let write = || pinhole(&["handout", "--prairielearn", plain(&out), "--json"]);
    write().expect_code(0);
    let info = fs::read(out.join("question/info.json")).expect("it was written");
    let info: serde_json::Value = serde_json::from_slice(&info).expect("it is JSON");
    assert_eq!(info["gradingMethod"], "External", "{info:#}");
    let image = out.join("image");
    assert!(image.join("Dockerfile").is_file());
    assert!(
        image
            .join("pinhole/golden/ray_casting/manifest.toml")
            .is_file()
    );
    let script = files(&out)
        .into_keys()
        .find(|name| name.ends_with("run.sh"));
    let script = out.join(script.expect("there is a script"));
    let checked = Command::new("bash").arg("-n").arg(script).status();
    assert!(checked.expect("bash starts").success());
    write().expect_code(2).expect_err("is not empty");
    #[cfg(unix)]
    {
        fs::remove_dir_all(&out).expect("it is there");
        fs::create_dir(&out).expect("there is room");
        // Only root can give files away.
        if std::os::unix::fs::chown(&out, Some(12345), None).is_ok() {
            write().expect_code(2).expect_err("another user has made");
        }
    }
}

#[test]
fn the_workflow_is_valid_pins_its_actions_and_covers_three_systems() {
    let workflow = root().join("tools/instructor/templates/handout/check.yml");
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
        check_jsonschema()
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
