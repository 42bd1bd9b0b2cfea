use std::fs;

use super::*;
use crate::checkout::Checkout;
use crate::compile::Replacement;
use crate::error::Fault;
use crate::outcome::{Outcome, TaskOutcome};
use crate::submission::{Answer, Submission};

#[test]
fn every_public_answer_is_right_when_rounded_to_three_digits() {
    let rounded = |number: &f64| format!("{number:.2e}").parse().expect("a number");
    let mut count = 0;
    let assignments = Assignment::read_all(&Checkout::find().unwrap()).unwrap();
    for assignment in &assignments {
        let goldens = Goldens::read(&assignment.golden(), assignment).unwrap();
        for task in &assignment.tasks {
            for group in groups(task) {
                let Ok(asked) = Asked::read(&goldens, task, &group.group) else {
                    continue; // It has many right answers.
                };
                for place in &asked.places {
                    let mut claim = asked.right_answer(*place);
                    for (_, numbers) in &mut claim.parts {
                        *numbers = numbers.iter().map(rounded).collect();
                    }
                    let right = |channel: usize| asked.golden(channel, *place);
                    let wrong = asked.contradictions(*place, &claim, &right);
                    let named = format!("{} {} {place}", task.name, group.group);
                    assert!(wrong.is_empty(), "{named}: {:?} for {wrong:?}", claim.parts);
                    count += 1;
                }
            }
        }
    }
    assert!(count > 5000, "only {count} answers were rounded");
}

#[test]
fn answer_off_by_more_than_its_third_digit_is_wrong() {
    let assignment = Assignment::read(&Checkout::find().unwrap(), "ray_casting").unwrap();
    let goldens = Goldens::read(&assignment.golden(), &assignment).unwrap();
    let task = assignment.task("sphere").unwrap();
    let asked = Asked::read(&goldens, task, "inside").unwrap();
    let right = |channel: usize| asked.golden(channel, asked.places[0]);
    for (t, wrong) in [(7.62, false), (7.60, true), (7.64, true)] {
        let claim = Claim {
            hit: Some(true),
            parts: vec![("t", vec![t])],
        };
        let contradictions = asked.contradictions(asked.places[0], &claim, &right);
        assert_eq!(!contradictions.is_empty(), wrong, "{t}");
    }
}

#[test]
fn rays_of_ones_own_need_mitsuba_and_a_task_about_one_shape() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("mine.toml");
    let assignment = Assignment::read(&Checkout::find().unwrap(), "ray_casting").unwrap();
    for (task, more, problem) in [
        ("plane", "", "only Mitsuba can judge rays of your own"),
        ("plane", ", type = 'plane'", "must not have a `type`"),
        (
            "first_hit",
            "",
            ":3: rays of your own can only be used in a task",
        ),
    ] {
        let ray = "ray = { e = [0, 0, 4], d = [0, 0, -2], min_t = 0 }";
        let shape = format!("shape = {{ point = [0, 0, 0], normal = [0, 0, 1]{more} }}");
        let text = format!("task = \"{task}\"\n[[example]]\n{ray}\n{shape}\n");
        fs::write(&file, text).unwrap();
        let nowhere = Checkout::at(folder.path());
        let error = judge_file(&file, &assignment, &nowhere).unwrap_err();
        assert!(error.problem.contains(problem), "{error}");
    }
}

#[test]
fn examples_that_need_mitsuba_get_no_zero_without_it() {
    let folder = tempfile::tempdir().unwrap();
    let mut assignment = Assignment::read(&Checkout::find().unwrap(), "ray_casting").unwrap();
    let mut submission = Submission::find(&assignment.reference(), &assignment).unwrap();
    let task = &mut assignment.tasks[2];
    let text = "examples = { points = 2, catch = 0.5 }";
    task.examples = toml::from_str::<BTreeMap<String, _>>(text)
        .unwrap()
        .remove("examples");
    let missing = Replacement::Unusable(AnswerFileProblem::Missing);
    let got = TaskOutcome::replaced(task, &missing);
    let mut judge = |text: &str, interactive| {
        let mut outcome = Outcome::new("", String::new(), "");
        outcome.tasks.push(got.clone());
        let (task, text) = (got.name.clone(), Ok(text.into()));
        submission.examples = vec![Answer { task, text }];
        let nowhere = Checkout::at(folder.path());
        let added = add_handed_in(
            &mut outcome,
            &submission,
            &assignment,
            &nowhere,
            interactive,
        );
        added.map(|()| format!("{:?}", outcome.tasks[0].groups.last()))
    };
    let ray = "ray = { e = [0, 0, 4], d = [0, 0, -2], min_t = 0 }";
    let shape = "shape = { point = [0, 0, 0], normal = [0, 0, 1] }";
    let own = format!("task = \"plane\"\n[[example]]\n{ray}\n{shape}\n");
    assert_eq!(judge(&own, false).unwrap_err().fault, Fault::Environment);
    let said = judge(&own, true).unwrap();
    assert!(
        said.contains("only Mitsuba can judge rays of your own"),
        "{said}"
    );
    // The student's fault is judged in any case.
    let said = judge("task = \"sphere\"", false).unwrap();
    assert!(
        said.contains("plane.examples.toml is about `sphere`"),
        "{said}"
    );
}

#[test]
fn deeply_nested_tables_are_refused_without_overflowing_the_stack() {
    let checkout = Checkout::find().unwrap();
    let assignment = Assignment::read(&checkout, "ray_casting").unwrap();
    let key = vec!["a"; 80].join(".");
    let text = format!(
        "{key} = {}1{}",
        format!("{{{key} = ").repeat(79),
        "}".repeat(79)
    );
    let file = (Path::new("sphere.examples.toml"), text.as_str());
    let error = judge(file, &assignment, &checkout, false).unwrap_err();
    assert!(error.problem.contains("TOML parse error"), "{error}");
}
