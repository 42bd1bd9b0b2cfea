use super::*;
use crate::checkout::Checkout;

#[test]
fn every_public_answer_is_right_when_rounded_to_three_digits() {
    let rounded = |number: &f64| format!("{number:.2e}").parse().expect("a number");
    let mut count = 0;
    let assignments = Assignment::read_all(&Checkout::find().unwrap()).unwrap();
    for assignment in &assignments {
        let goldens = Goldens::read(&assignment.golden(), assignment).unwrap();
        for task in &assignment.tasks {
            for group in groups(task) {
                let Ok(asked) = Asked::read(&goldens, task, group) else {
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
    let group = task.points.iter().find(|it| it.group == "inside").unwrap();
    let asked = Asked::read(&goldens, task, group).unwrap();
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
