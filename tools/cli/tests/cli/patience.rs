//! How long `check` waits for answers.

use pinhole_testing::{TASKS, submission, trusted};

use crate::check::{check, lost, task, with_body};

#[test]
fn an_endless_loop_costs_its_own_task() {
    let text = with_body("plane", "loop { std::hint::black_box(0); }");
    let folder = submission(&trusted(), "endless", &[("plane.rs", &text)]);
    let examination = check(&folder, &["--timeout", "2"]).expect_code(1).json();
    let groups = task(&examination, "plane")["groups"]
        .as_array()
        .expect("a list")
        .clone();
    assert!(
        groups
            .iter()
            .all(|group| group["outcome"]["kind"] == "timed out"),
        "{groups:?}"
    );
    for name in TASKS.into_iter().filter(|name| *name != "plane") {
        assert_eq!(lost(&examination, name), 0, "{name}");
    }
}

#[test]
fn scenes_that_need_an_endless_answer_are_not_cast() {
    let text = with_body("plane", "loop { std::hint::black_box(0); }");
    let folder = submission(&trusted(), "endless-scenes", &[("plane.rs", &text)]);
    let examination = check(
        &folder,
        &[
            "--task",
            "plane",
            "--scene",
            "lone_triangle",
            "--scene",
            "sphere_and_plane",
        ],
    );
    let examination = examination.expect_code(1).json();
    let outcomes = examination["scenes"].as_array().expect("a list").iter();
    let outcomes: Vec<_> = outcomes.map(|scene| &scene["outcome"]).collect();
    assert_eq!(outcomes[0]["kind"], "blocked", "{examination:#}");
    assert_eq!(outcomes[0]["by"], "plane");
    assert_eq!(outcomes[1]["passes"], true);
}

#[test]
fn a_loop_in_one_group_costs_that_group() {
    let slow = "if ray.direction.dot(self.normal) == 0.0 { loop { std::hint::black_box(0); } }";
    let folder = submission(
        &trusted(),
        "loop-in-group",
        &[("plane.rs", &with_body("plane", slow))],
    );
    let examination = check(&folder, &["--task", "plane", "--timeout", "3"])
        .expect_code(1)
        .json();
    // Only the group `parallel`, which is worth one point, has rays that never meet the plane.
    assert_eq!(lost(&examination, "plane"), 1, "{examination:#}");
}

#[cfg(target_os = "linux")]
#[test]
fn output_beyond_the_limit_is_discarded() {
    let text = with_body(
        "plane",
        "for _ in 0..100 { println!(\"{}\", \"x\".repeat(1000)); }
         for _ in 0..1000 {
             let to = std::fs::read_link(\"/proc/self/fd/1\").unwrap();
             if to.starts_with(\"/dev\") { panic!(\"prints to {}\", to.display()); }
             std::thread::sleep(std::time::Duration::from_millis(1));
         }",
    );
    let folder = submission(&trusted(), "prints", &[("plane.rs", &text)]);
    let examination = check(&folder, &["--task", "plane"]).expect_code(1).json();
    let outcome = &task(&examination, "plane")["groups"][0]["outcome"];
    assert_eq!(outcome["message"], "prints to /dev/null", "{outcome:#}");
    let printed = examination["printed"].as_str().expect("it printed");
    assert!(printed.len() >= 10_000, "{}", printed.len());
}

#[test]
fn timings_show_what_each_stage_took() {
    let folder = submission(&trusted(), "timings", &[]);
    let examination = check(&folder, &["--task", "plane", "--timings"]).json();
    let stages = examination["timings"].as_array().expect("a list");
    for name in ["find the harness", "read goldens", "ask plane", "judge"] {
        let mut same = stages.iter().filter(|stage| stage["name"] == name);
        let stage = same
            .next()
            .unwrap_or_else(|| panic!("no {name} in {stages:?}"));
        assert!(stage["seconds"].as_f64() > Some(0.0), "{stage}");
    }
}
