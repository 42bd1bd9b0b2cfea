//! Goldens: they can be rendered again, and match what they were made from.

use std::fs;
use std::os::unix::fs::PermissionsExt;
use std::path::Path;
use std::process::Command;

use pinhole_testing::{
    RunResult, TASKS, fresh, fresh_goldens, pinhole, pinhole_with, program_of, root, trusted,
};

fn plain(path: &Path) -> &str {
    path.to_str().expect("test folders have plain names")
}

fn verify(folder: &Path) -> RunResult {
    pinhole(&["golden", "verify", plain(folder)])
}

/// A copy of the committed goldens that a test may damage.
fn copy(name: &str) -> std::path::PathBuf {
    let folder = fresh(&trusted(), name);
    let own = root().join("golden/ray_casting");
    for place in ["", "probes", "ties"] {
        fs::create_dir_all(folder.join(place)).expect("a folder can be made");
        for entry in fs::read_dir(own.join(place))
            .expect("goldens are committed")
            .flatten()
        {
            if entry.path().is_file() {
                let to = folder.join(place).join(entry.file_name());
                fs::copy(entry.path(), to).expect("a golden can be copied");
            }
        }
    }
    folder
}

#[test]
fn committed_goldens_match_their_manifest_and_a_changed_byte_is_noticed() {
    pinhole(&["golden", "verify"])
        .expect_code(0)
        .expect_out("match their manifest");

    let folder = copy("golden-changed");
    verify(&folder).expect_code(0);
    let film = folder.join("sphere_and_plane.exr");
    let mut bytes = fs::read(&film).expect("it was copied");
    *bytes.last_mut().expect("it is not empty") ^= 1;
    fs::write(&film, bytes).expect("it can be written");
    verify(&folder)
        .expect_code(1)
        .expect_out("sphere_and_plane.exr has changed");
}

#[test]
fn missing_and_foreign_films_are_noticed() {
    let folder = copy("golden-strays");
    fs::remove_file(folder.join("bunny.tol.exr")).expect("it was copied");
    fs::copy(folder.join("bunny.exr"), folder.join("hare.exr")).expect("it can be copied");
    let ties = folder.join("ties");
    fs::rename(ties.join("plane.ask.exr"), ties.join("level.ask.exr")).expect("it was copied");
    let ran = verify(&folder).expect_code(1);
    ran.expect_out("bunny.tol.exr is missing")
        .expect_out("hare.exr is not in the manifest")
        .expect_out("ties/plane.ask.exr is missing")
        .expect_out("ties/level.ask.exr is not in the manifest");
}

#[test]
fn goldens_stay_valid_after_a_new_comment_but_not_after_another_number_or_script() {
    let folder = fresh(&trusted(), "stale");
    let scene = folder.join("mine.toml");
    let own = root().join("assignments/ray_casting/scenes/slide_example.toml");
    let text = fs::read_to_string(own).expect("it is committed");
    fs::write(&scene, &text).expect("it can be written");
    let line = ["golden", "render", plain(&scene), "--no-mistakes", "--out"];
    pinhole(&[&line, [plain(&folder)].as_slice()].concat()).expect_code(0);
    fs::write(&scene, format!("# Mine.\n\n{text}")).expect("it can be written");
    verify(&folder).expect_code(0);
    let nearer = text.replace("focal_length = 10.0", "focal_length = 9.0");
    fs::write(&scene, nearer).expect("it can be written");
    verify(&folder)
        .expect_code(1)
        .expect_out("mine.toml has changed");

    fs::write(&scene, text).expect("it can be written");
    let manifest = fs::read_to_string(folder.join("manifest.toml")).expect("it was made");
    let (head, scripts) = manifest.split_once("\nmine = \"").expect("its fingerprint");
    let other = format!("{head}\nmine = \"0{scripts}");
    fs::write(folder.join("manifest.toml"), other).expect("it can be written");
    verify(&folder)
        .expect_code(1)
        .expect_out("the scripts have changed since they made mine");
}

#[test]
fn goldens_are_not_verified_if_their_scripts_cannot_be_compared() {
    pinhole_with(&[("PATH", "")], &["golden", "verify"])
        .expect_code(3)
        .expect_err("there is no Python here");
}

#[test]
fn a_scene_renders_to_the_same_bytes_twice_and_passes_against_the_committed_golden() {
    let (first, second) = (fresh(&trusted(), "render-1"), fresh(&trusted(), "render-2"));
    for folder in [&first, &second] {
        pinhole(&[
            "golden",
            "render",
            "slide_example",
            "--no-mistakes",
            "--out",
            plain(folder),
        ])
        .expect_code(0);
        verify(folder).expect_code(0);
    }
    for film in ["", ".tol", ".rays", ".rays.tol"] {
        let name = format!("slide_example{film}.exr");
        let bytes = |folder: &Path| fs::read(folder.join(&name)).expect("it was rendered");
        assert!(
            bytes(&first) == bytes(&second),
            "{name} differs between two renders"
        );
    }
    // Another machine may make other bytes than the committed ones, but the rule must hold.
    for name in ["slide_example.exr", "slide_example.rays.exr"] {
        let committed = root().join("golden/ray_casting").join(name);
        let again = first.join(name);
        pinhole(&["diff", plain(&committed), plain(&again)]).expect_code(0);
    }
}

#[test]
fn a_pixel_centre_on_an_edge_is_refused() {
    let folder = fresh(&trusted(), "edge");
    let scene = folder.join("edge.toml");
    // The edge from (0, −1, −2) to (0, 1, −2) passes through the middle column's centres.
    let text = r#"
[camera]
projection = "perspective"
eye = [0, 0, 0]
view = [0, 0, -1]
up = [0, 1, 0]
focal_length = 1
width = 2
height = 2
resolution = [5, 5]

[[object]]
type = "soup"
obj = "edge.obj"
"#;
    let mesh = "v 0 -1 -2\nv 0 1 -2\nv -2 0 -2\nv 2 0 -2\nf 1 2 3\nf 2 1 4\n";
    fs::write(&scene, text).expect("it can be written");
    fs::write(folder.join("edge.obj"), mesh).expect("it can be written");
    let out = folder.join("out");
    // A good scene in the same run is still rendered, and its goldens are complete.
    let good = root().join("assignments/ray_casting/scenes/slide_example.toml");
    let line = [
        "golden",
        "render",
        plain(&good),
        plain(&scene),
        "--no-mistakes",
        "--out",
        plain(&out),
    ];
    let ran = pinhole(&line).expect_code(2);
    verify(&out).expect_code(0).expect_out("4 films");
    ran.expect_err("edge.toml")
        .expect_err("pixel (2, ")
        .expect_err("shift the camera a little");
}

#[test]
fn fresh_questions_and_scenes_are_a_complete_set_of_goldens() {
    let folder = fresh_goldens();
    verify(&folder).expect_code(0);
    let tasks = TASKS
        .iter()
        .flat_map(|task| ["--task", task])
        .collect::<Vec<_>>();
    let reference = "assignments/ray_casting/reference";
    let line = ["check", reference, "--golden", plain(&folder), "--json"];
    let examination = pinhole(&[&line, tasks.as_slice()].concat())
        .expect_code(0)
        .json();
    assert_eq!(examination["passes"], true);
    let same = |name: &str| {
        let bytes =
            |folder: &Path| fs::read(folder.join("probes").join(name)).expect("it is there");
        bytes(&folder) == bytes(&root().join("golden/ray_casting"))
    };
    assert!(
        !same("sphere.outside.ask.exr"),
        "another seed asks the same questions"
    );
}

#[test]
fn goldens_of_other_scenes_need_a_folder_of_their_own() {
    let folder = fresh(&trusted(), "own-folder");
    let scene = folder.join("mine.toml");
    let text = root().join("assignments/ray_casting/scenes/slide_example.toml");
    fs::copy(text, &scene).expect("it can be copied");
    pinhole(&["golden", "render", plain(&scene)])
        .expect_code(2)
        .expect_err("--out DIR");
    pinhole(&["golden", "render", "no_such_scene"])
        .expect_code(2)
        .expect_err("there is no scene");
}

#[test]
fn fresh_questions_are_not_made_where_others_can_read_them() {
    let folder = fresh(&trusted(), "readable");
    fs::set_permissions(&folder, fs::Permissions::from_mode(0o755)).expect("it is ours");
    fs::write(folder.join("notes"), "").expect("there is room");
    let render = ["golden", "render", "--seed", "1", "--out", plain(&folder)];
    pinhole(&render)
        .expect_code(2)
        .expect_err("others on this machine can read");
}

#[test]
fn python_is_started_in_no_folder_that_may_be_a_students() {
    // As the programs of asdf: they run what a file of the current folder names.
    let folder = tempfile::tempdir().expect("there is room");
    let shims = folder.path().join("shims");
    fs::create_dir(&shims).expect("there is room");
    let (shim, mark) = (shims.join("python3"), folder.path().join("mark"));
    let script = format!(
        "#!/bin/sh\n[ -e .tool-versions ] && touch {}\nPATH=${{PATH#*:}} exec python3 \"$@\"\n",
        mark.display()
    );
    fs::write(&shim, script).expect("there is room");
    fs::set_permissions(&shim, fs::Permissions::from_mode(0o755)).expect("it is ours");
    fs::write(folder.path().join(".tool-versions"), "python path:py").expect("there is room");
    let path = std::env::var("PATH").expect("it is set");
    let ran = Command::new(program_of("golden"))
        .args(["golden", "verify"])
        .current_dir(folder.path())
        .env("PATH", format!("{}:{path}", shims.display()))
        .output()
        .expect("it starts");
    assert!(ran.status.success(), "{ran:?}");
    assert!(!mark.exists(), "Python was started in the current folder");
}

#[test]
fn goldens_are_not_written_through_links() {
    let folder = fresh(&trusted(), "golden-links");
    std::os::unix::fs::symlink(folder.join("absent"), folder.join("mistakes.toml"))
        .expect("there is room");
    for arguments in [
        &["golden", "mistakes", plain(&folder)][..],
        &["golden", "render", "slide_example", "--out", plain(&folder)],
    ] {
        pinhole(arguments)
            .expect_code(2)
            .expect_err("mistakes.toml is a link");
    }
    assert!(!folder.join("absent").exists());
}
