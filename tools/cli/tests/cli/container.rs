//! The second kind of sandbox, for machines where namespaces are forbidden, as in a
//! container under Docker's default seccomp profile.

use std::process::Output;

use serde_json::Value;

use crate::check::{lost, task, with_body};
use crate::hostile::SECRET;
use crate::modes;
use pinhole_testing::{root, submission};

/// Runs `pinhole` where no namespace can be made. `None` if this machine cannot arrange that.
fn without_namespaces(arguments: &[&str]) -> Option<Output> {
    let run = || modes::run(modes::CONTAINER, &[SECRET], arguments);
    modes::can_be_tried(modes::CONTAINER).then(run)
}

fn json(output: &Output) -> Value {
    let text = String::from_utf8_lossy(&output.stdout);
    serde_json::from_str(&text).unwrap_or_else(|error| {
        panic!(
            "{error}\n{text}\n{}",
            String::from_utf8_lossy(&output.stderr)
        )
    })
}

#[test]
fn without_bubblewrap_nothing_is_run_and_the_remedy_is_named() {
    let mark = std::env::temp_dir().join(format!("pinhole-ran-{}", std::process::id()));
    let text = with_body("plane", &format!("let _ = std::fs::write({mark:?}, \"\");"));
    let folder = submission(
        &std::env::temp_dir(),
        "no-namespaces",
        &[("plane.rs", &text)],
    );
    let name = folder.to_str().expect("a plain name");
    let Some(refused) = without_namespaces(&["check", name, "--task", "plane"]) else {
        return;
    };
    let said = String::from_utf8_lossy(&refused.stderr);
    assert_eq!(refused.status.code(), Some(3), "{said}");
    assert!(
        said.contains("--sandbox container") && said.contains("--trust"),
        "{said}"
    );
    assert!(!mark.exists(), "the code ran anyway");
    std::fs::remove_dir_all(folder).expect("it was made");
}

#[test]
fn code_in_a_container_runs_as_a_user_who_can_read_and_reach_nothing() {
    let golden = root().join("golden/ray_casting/manifest.toml");
    let golden = golden.to_str().expect("a plain name");
    let listener = std::net::TcpListener::bind("127.0.0.1:0").expect("a port is free");
    let address = listener.local_addr().expect("it is bound");
    let reaches = [
        format!("std::fs::read({golden:?}).is_ok()"),
        "std::fs::read(\"/etc/passwd\").is_ok()".into(),
        "std::fs::read_dir(\"/tmp\").is_ok()".into(),
        "std::fs::read_dir(\"/proc\").is_ok()".into(),
        "std::fs::write(\"/tmp/pinhole-owned\", \"\").is_ok()".into(),
        "std::process::Command::new(\"/usr/bin/true\").status().is_ok()".into(),
        format!("std::net::TcpStream::connect(\"{address}\").is_ok()"),
        format!("std::env::var({:?}).is_ok()", SECRET.0),
    ];
    let body = format!(
        "static REACHED: std::sync::LazyLock<bool> = std::sync::LazyLock::new(|| {}); \
         if *REACHED {{ return None; }}",
        reaches.join(" || ")
    );
    let files = [
        ("plane.rs", with_body("plane", &body)),
        (
            "triangle.rs",
            format!("compile_error!(include_str!({golden:?}));"),
        ),
        (
            "triangle_soup.rs",
            "compile_error!(include_str!(\"/etc/passwd\"));".into(),
        ),
        (
            "viewing_ray.rs",
            with_body("viewing_ray", "loop { std::hint::black_box(0); }"),
        ),
        (
            "first_hit.rs",
            with_body(
                "first_hit",
                "loop { std::mem::forget(std::hint::black_box(Vec::<u8>::with_capacity(64 << 20))); }",
            ),
        ),
    ];
    let files: Vec<(&str, &str)> = files
        .iter()
        .map(|(name, text)| (*name, text.as_str()))
        .collect();
    let folder = submission(&std::env::temp_dir(), "container", &files);
    let name = folder.to_str().expect("a plain name");
    let tasks = pinhole_testing::TASKS
        .iter()
        .flat_map(|task| ["--task", task]);
    let tasks: Vec<&str> = tasks.collect();
    let common = [
        "check",
        name,
        "--json",
        "--no-report",
        "--timeout",
        "6",
        "--sandbox",
        "container",
    ];
    for mode in [modes::CONTAINER, modes::ROOTLESS] {
        if !modes::can_be_tried(mode) {
            continue;
        }
        let checked = modes::run(mode, &[SECRET], &[&common[..], &tasks].concat());
        let examination = json(&checked);
        assert_eq!(
            examination["sandbox"], "container (another user, Landlock)",
            "{examination:#}"
        );
        for right in ["sphere", "plane"] {
            assert_eq!(lost(&examination, right), 0, "{right}: {examination:#}");
        }
        for refused in ["triangle", "triangle_soup"] {
            assert_eq!(
                task(&examination, refused)["file"]["state"],
                "does not compile"
            );
        }
        assert_eq!(
            task(&examination, "viewing_ray")["groups"][0]["outcome"]["kind"],
            "timed out"
        );
        assert_eq!(
            task(&examination, "first_hit")["groups"][0]["outcome"]["kind"],
            "died"
        );
        let text = String::from_utf8_lossy(&checked.stdout);
        assert!(!text.contains("root:x:"), "the list of users was read");
    }
    std::fs::remove_dir_all(folder).expect("it was made");
}

#[test]
fn without_landlock_a_container_is_refused_and_nothing_is_run() {
    if !modes::can_be_tried(modes::WITHOUT_LANDLOCK) {
        return;
    }
    let folder = submission(&std::env::temp_dir(), "no-landlock", &[]);
    let name = folder.to_str().expect("a plain name");
    let check = |sandbox: &str| {
        let line = [
            "check",
            name,
            "--task",
            "plane",
            "--json",
            "--sandbox",
            sandbox,
        ];
        let ran = modes::run(modes::WITHOUT_LANDLOCK, &[SECRET], &line);
        (ran.status.code(), json(&ran))
    };
    let (code, refused) = check("container");
    assert_eq!(code, Some(3), "{refused:#}");
    let said = refused.to_string();
    assert!(
        said.contains("no Landlock") && said.contains("container-without-landlock"),
        "{said}"
    );
    let (code, accepted) = check("container-without-landlock");
    assert_eq!(code, Some(0), "{accepted:#}");
    assert_eq!(
        accepted["sandbox"], "container without Landlock (another user)",
        "{accepted:#}"
    );
    std::fs::remove_dir_all(folder).expect("it was made");
}
