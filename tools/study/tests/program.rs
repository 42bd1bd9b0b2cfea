//! Runs the real program on small parts of the study.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use pinhole_study::embree;
use serde_json::Value;

fn studied(part: &str) -> (Option<i32>, String, PathBuf) {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(part);
    let output = Command::new(env!("CARGO_BIN_EXE_pinhole-study"))
        .args(["study", "--quick", "--json", "--only", part, "--out"])
        .arg(&folder)
        .output()
        .expect("it runs");
    let said = String::from_utf8(output.stdout).expect("text");
    (output.status.code(), said, folder)
}

#[test]
fn each_part_is_measured_and_written() {
    for (part, list) in [
        ("mesh", "meshes"),
        ("scenes", "scenes"),
        ("plans", "plans"),
        ("secondary", "secondary"),
        (
            "embree",
            if embree::IS_INSTALLED {
                "embree"
            } else {
                "notes"
            },
        ),
    ] {
        let (code, said, folder) = studied(part);
        let document: Value = serde_json::from_str(&said).expect("one JSON document");
        let rows = document[list].as_array().map_or(0, Vec::len);
        assert!(code == Some(0) && rows > 0, "{part}: {code:?}, {rows} rows");
        let written = fs::read_to_string(folder.join("study.json")).expect("it was written");
        assert_eq!(written, said);
        let page = fs::read_to_string(folder.join("summary.md")).expect("it was written");
        for file in fs::read_dir(&folder).expect("it was written").flatten() {
            let name = file.file_name().display().to_string();
            let is_shown = !name.ends_with(".svg") || page.contains(&name);
            assert!(is_shown, "{name} is not in the summary");
        }
    }
}
