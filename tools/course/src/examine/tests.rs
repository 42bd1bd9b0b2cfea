use std::collections::BTreeSet;
use std::sync::Mutex;
use std::time::Duration;

use pinhole::ask::{Reply, Stop};

use super::{Examiner, KnownReplies, Selection};
use crate::assignment::Assignment;
use crate::checkout::Checkout;
use crate::compile::Program;
use crate::goldens::Goldens;
use crate::sandbox::Sandbox;
use crate::submission::Submission;

/// Knows no reply, but records what it is asked for.
#[derive(Default)]
struct Asked(Mutex<Vec<(String, usize)>>);

impl KnownReplies for Asked {
    fn get(&self, what: &str, questions: usize) -> Option<Reply> {
        self.0.lock().unwrap().push((what.into(), questions));
        None
    }

    fn keep(&self, _: &str, _: &Reply) {}
}

#[test]
fn everything_withheld_is_asked_last() {
    let checkout = Checkout::find().unwrap();
    let assignment = Assignment::read(&checkout, "ray_casting").unwrap();
    let goldens = Goldens::read(&assignment.golden(), &assignment).unwrap();
    let hidden = "tilted_camera";
    let asked = Asked::default();
    let program = Program {
        executable: "/usr/bin/false".into(),
        replaced: Default::default(),
        stubs: BTreeSet::new(),
        with_ours: Default::default(),
        warnings: Default::default(),
        stop: Stop::default(),
    };
    let examiner = Examiner {
        assignment: &assignment,
        goldens: &goldens,
        program: &program,
        sandbox: &Sandbox::Trusted,
        wall: Duration::from_secs(60),
        interactive: false,
        second_judge: None,
        clock: None,
        withheld: &[hidden.to_owned()],
        known: Some(&asked),
        progress: &|_, _| {},
    };
    let submission = Submission::find(&assignment.reference(), &assignment).unwrap();
    let everything = Selection::default();
    let begun = examiner.begin(&submission, &everything).unwrap();
    // Nothing passes, but one task has a group that is not asked yet.
    assert_eq!(begun.promising_tasks(), ["viewing_ray"]);
    let examination = begun.finish().unwrap();
    let order = asked.0.into_inner().unwrap();
    let names: Vec<&str> = order.iter().map(|(what, _)| what.as_str()).collect();
    let rays: usize = goldens
        .scenes
        .iter()
        .map(|scene| goldens.cached_scene(scene).unwrap().job.len())
        .sum();
    let last = order.len() - 2;
    assert_eq!(order[last], ("viewing_ray".into(), rays));
    assert_eq!(names[last + 1], hidden);
    let public = |name: &&str| **name != *hidden && **name != *"viewing_ray";
    let others = assignment.tasks.len() - 1 + assignment.scenes.len() - 1;
    assert_eq!(
        names[1..last].iter().filter(|it| public(it)).count(),
        others
    );
    // The results are in the assignment's order.
    let scenes = examination.outcome.scenes.iter().map(|scene| &scene.name);
    let expected = assignment.scenes.iter().map(|scene| &scene.name);
    assert!(scenes.eq(expected));
    let groups = examination.outcome.tasks[0].groups.iter();
    let expected = assignment.tasks[0].points.iter();
    assert!(
        groups
            .map(|it| &it.name)
            .eq(expected.map(|points| &points.group))
    );
}
