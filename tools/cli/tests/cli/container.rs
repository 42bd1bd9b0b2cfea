//! Where namespaces are forbidden, as in a container under Docker's default seccomp
//! profile, there is a second kind of walls.

use std::process::{Command, Output};

use serde_json::Value;

use crate::check::{lost, task, with_body};
use crate::hostile::SECRET;
use pinhole_testing::{root, submission};

/// Runs `pinhole` where no namespace can be made, with the toolchain where every user
/// can reach it. `None` if this machine cannot arrange that: not as root, say.
fn without_namespaces(arguments: &[&str]) -> Option<Output> {
    let sysroot = Command::new("rustc").args(["--print", "sysroot"]).output();
    let sysroot = String::from_utf8(sysroot.expect("there is rustc").stdout).expect("text");
    let pinhole = env!("CARGO_BIN_EXE_pinhole");
    let mut outer = Command::new("bwrap");
    outer.args(["--dev-bind", "/", "/", "--cap-add", "ALL"]);
    outer.args(["--ro-bind", sysroot.trim(), "/mnt"]);
    // The same filter that confines submissions forbids them.
    let limits = "--compiles --cpu 1000000 --memory 1000000000000 --processes 100000 \
         --file-size 100000000000 --open-files 1000 --read / --write /";
    outer
        .args(["--", pinhole, "confine"])
        .args(limits.split_whitespace());
    outer.args(["--", pinhole]).args(arguments);
    let path = std::env::var("PATH").expect("there is a PATH");
    outer
        .env("PATH", format!("/mnt/bin:{path}"))
        .env_remove("RUSTUP_TOOLCHAIN")
        .env_remove("CARGO")
        .env_remove("RUSTC")
        // Cargo puts the toolchain's own libraries here, and rustc looks beside them.
        .env_remove("LD_LIBRARY_PATH")
        .env(SECRET.0, SECRET.1)
        .current_dir(root());
    let id = Command::new("id")
        .arg("-u")
        .output()
        .expect("there is `id`");
    if id.stdout != b"0\n" {
        eprintln!("only root can be another user: not tried");
        return None;
    }
    Some(outer.output().expect("bubblewrap starts"))
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
fn where_bubblewrap_cannot_work_the_remedy_is_named_and_nothing_is_run() {
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
    assert!(!mark.exists(), "the code was run all the same");
    std::fs::remove_dir_all(folder).expect("it was made");
}

#[test]
fn in_a_container_code_runs_as_somebody_who_reads_and_reaches_nothing() {
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
    let Some(checked) = without_namespaces(&[&common[..], &tasks].concat()) else {
        return;
    };
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
        "out of memory"
    );
    let text = String::from_utf8_lossy(&checked.stdout);
    assert!(!text.contains("root:x:"), "the users were told");
    std::fs::remove_dir_all(folder).expect("it was made");
}
