use super::*;
use crate::assignment::Assignment;
use crate::checkout::Checkout;
use crate::sandbox::Sandbox;

/// The answer to `viewing_ray` without its function.
fn renamed(text: &str) -> String {
    text.replacen("pub fn viewing_ray", "pub fn unexpected", 1)
}

/// The answer to a shape without its `impl`, which only one of our files misses.
fn no_impl(text: &str) -> String {
    text.split("impl IntersectRay").next().unwrap().to_owned()
}

fn reference_of(name: &str) -> (Assignment, Submission) {
    let assignment = Assignment::read(&Checkout::find().unwrap(), name).unwrap();
    let reference = Submission::find(&assignment.reference(), &assignment).unwrap();
    (assignment, reference)
}

/// Which answers are replaced, by their positions.
fn replaced_of(submission: &Submission, assignment: &Assignment, is_done: bool) -> Vec<usize> {
    let checkout = Checkout::find().unwrap();
    let compiler = Compiler::new(assignment, &checkout, &Sandbox::Trusted).unwrap();
    let rounds = Rounds::new(&compiler, submission);
    let attempt = rounds.attempt(&|| is_done, &mut |_| false);
    let Ok(Attempt::Program(program)) = attempt else {
        panic!("a program without the bad answers")
    };
    let answers = submission.answers.iter().enumerate();
    let replaced = answers.filter(|(_, it)| program.replaced.contains_key(&it.task));
    replaced.map(|(position, _)| position).collect()
}

/// Which of the reference's answers are replaced when the first ones are edited like this.
fn replaced(edits: &[fn(&str) -> String], is_done: bool) -> Vec<usize> {
    let name = Checkout::find().unwrap().default_assignment().unwrap();
    let (assignment, mut submission) = reference_of(&name);
    for (answer, edit) in submission.answers.iter_mut().zip(edits) {
        let text = answer.text.as_ref();
        answer.text = text.map(|text| edit(text)).map_err(Clone::clone);
    }
    replaced_of(&submission, &assignment, is_done)
}

#[test]
fn answers_that_compile_stay_when_others_have_used_up_the_time() {
    let edits: [fn(&str) -> String; 3] = [
        |_| String::new(),
        |text| text.replacen("fn ", "fn fn ", 1),
        |text| format!("{text}\nfn f() {{ unknown() }}"),
    ];
    assert_eq!(replaced(&edits, true), [0, 1, 2]);
}

#[test]
fn answer_that_uses_another_one_is_not_to_blame_for_it() {
    let edits: [fn(&str) -> String; 2] = [renamed, |text| {
        format!("{text}\n#[allow(unused)]\nuse crate::viewing_ray::viewing_ray;")
    }];
    assert_eq!(replaced(&edits, false), [0]);
}

#[test]
fn answers_that_need_each_other_are_not_to_blame_for_a_third() {
    let edits: [fn(&str) -> String; 3] = [
        renamed,
        |text| format!("{text}\npub fn a() {{ crate::plane::b() }}"),
        |text| format!("{text}\npub fn b() {{ crate::sphere::a() }}"),
    ];
    assert_eq!(replaced(&edits, false), [0]);
}

#[test]
fn answers_that_need_each_other_are_not_to_blame_for_two_others() {
    let edits: [fn(&str) -> String; 4] = [
        renamed,
        |text| {
            format!(
                "// viewing_ray::b, triangle as b\n{text}\npub fn a() {{ crate::plane :: b() }}"
            )
        },
        |text| format!("use crate::sphere as s;\n{text}\npub fn b() {{ s::a() }}"),
        no_impl,
    ];
    assert_eq!(replaced(&edits, false), [0, 3]);
    assert_eq!(replaced(&edits, true), [0, 3], "after the time is up");
}

#[test]
fn an_answer_returns_after_one_that_it_needs() {
    // `plane` is tried before `sphere`, and doesn't seem to use it.
    let edits: [fn(&str) -> String; 5] = [
        renamed,
        |text| format!("{text}\npub fn a() {{ crate::triangle_soup::c() }}"),
        |text| format!("use crate::sphere\nas s;\n{text}\npub fn b() {{ s::a() }}"),
        no_impl,
        |text| format!("{text}\npub fn c() {{}}"),
    ];
    assert_eq!(replaced(&edits, false), [0, 3]);
}

#[test]
fn an_answer_that_kills_the_compiler_is_alone_to_blame() {
    let edits: [fn(&str) -> String; 3] = [
        |text| {
            format!(
                "{text}\nconst A: u8 = {}1{};",
                "(".repeat(60_000),
                ")".repeat(60_000)
            )
        },
        |text| format!("{text}\npub fn a() {{}}"),
        |text| format!("{text}\npub fn b() {{ crate::sphere::a() }}"),
    ];
    assert_eq!(replaced(&edits, false), [0]);
}

/// Two answers that are edited like this don't compile together.
fn clash(text: &str) -> String {
    format!(
        "{text}\nimpl crate::intersect_ray::IntersectRay for () {{
            fn intersect_ray(&self, _: &pinhole::Ray, _: f64) -> Option<pinhole::Intersection> {{
                None
            }}
        }}"
    )
}

#[test]
fn only_one_of_two_answers_that_clash_is_replaced() {
    assert_eq!(replaced(&[clash, clash], false).len(), 1);
}

#[test]
fn an_answer_with_a_module_named_like_one_that_clashes_returns() {
    let other: fn(&str) -> String = |text| clash(text).replace("for ()", "for [u8; 2]");
    let own: fn(&str) -> String = |text| {
        format!("{text}\nmod sphere {{ pub const X: u8 = 0; }} pub const Y: u8 = sphere::X;")
    };
    let replaced = replaced(&[own, clash, clash, other, other], true);
    assert!(
        !replaced.contains(&0) && replaced.len() == 2,
        "{replaced:?}"
    );
}

#[test]
fn a_flood_of_warnings_hides_no_error() {
    let flood: fn(&str) -> String = |text| {
        let unused = |k| format!("fn f{k}() {{ let x = ((1)); }}\n");
        clash(text) + &(0..1500).map(unused).collect::<String>()
    };
    assert_eq!(replaced(&[clash, flood], false).len(), 1);
}

/// A right submission of a later assignment, with an answer to a task of an earlier one at its end.
fn with_earlier_answer() -> (Assignment, Submission) {
    let (assignment, mut submission) = reference_of("bounding_volumes");
    let earlier = &assignment.earlier.as_ref().unwrap().task;
    let given = assignment.reference().join("src").join(earlier.file());
    submission.answers.push(Answer {
        task: earlier.name.clone(),
        text: Ok(std::fs::read_to_string(given).unwrap()),
    });
    (assignment, submission)
}

#[test]
fn an_answer_that_gives_no_points_is_to_blame_for_errors_in_all_others() {
    let (assignment, mut submission) = with_earlier_answer();
    let last = submission.answers.len() - 1;
    for (position, answer) in submission.answers.iter_mut().enumerate() {
        // With two ways to compare, the compiler doesn't know which type `into` makes.
        answer
            .text
            .as_mut()
            .unwrap()
            .push_str(match position == last {
                true => {
                    "struct S; impl PartialEq<S> for f64 { fn eq(&self, _: &S) -> bool { false } }"
                }
                false => "#[allow(unused)] fn is_one(x: f64) -> bool { 1.0 == x.into() }",
            });
    }
    assert_eq!(replaced_of(&submission, &assignment, false), [last]);
    // The compiler finds the second error only when there is none of the first kind.
    for wrong in [
        "fn wrong() -> u8 { 1.5 }",
        "fn wrong() -> &'static u8 { let x = 1; &x }",
    ] {
        let mut submission = submission.clone();
        submission.answers[1].text.as_mut().unwrap().push_str(wrong);
        assert_eq!(
            replaced_of(&submission, &assignment, false),
            [1, last],
            "{wrong}"
        );
    }
}

#[test]
fn an_answer_that_gives_no_points_is_to_blame_for_a_clash() {
    let (assignment, submission) = with_earlier_answer();
    let last = submission.answers.len() - 1;
    for clashing in 0..last {
        let mut submission = submission.clone();
        for position in [clashing, last] {
            let text = &mut submission.answers[position].text;
            *text = Ok(clash(text.as_ref().unwrap()));
        }
        assert_eq!(replaced_of(&submission, &assignment, false), [last]);
    }
}

#[cfg(unix)]
#[test]
fn no_folder_that_could_change_the_terminal_is_named() {
    let name = Checkout::find().unwrap().default_assignment().unwrap();
    let (assignment, _) = reference_of(&name);
    let above = tempfile::tempdir().expect("there is room");
    let is_named = |name: &str| {
        let folder = above.path().join(name);
        std::fs::create_dir(&folder).expect("there is room");
        let answer = folder.join(assignment.tasks[0].file());
        std::fs::write(answer, "").expect("there is room");
        let submission = Submission::find(&folder, &assignment).unwrap();
        place_from_here(&submission).is_some()
    };
    assert!(is_named("ada"));
    assert!(!is_named("a=b"));
    assert!(!is_named("\u{1b}[8meve"));
}
