//! The table of times beside new answers, and beside the names of files.

use super::*;

#[test]
fn new_answers_with_the_same_time_in_the_table_are_listed_until_either_changes() {
    let line = |id: &str, day: u32, hour: u32| TimeLine {
        keys: vec![(TimeKey::Id, id.into())],
        at: format!("2026-11-{day}T{hour}:00:00Z").parse().ok(),
        said: format!("2026-11-{day}"),
    };
    let class = |all: &[(&str, &str)], times: &[TimeLine]| {
        let entries = all.iter().map(|(id, answers)| Entry {
            answers: Some(vec![("any".into(), (*answers).into())]),
            ..entry(id, id, id)
        });
        let mut roll = roll(entries.collect(), RULES, &[]);
        roll.policy.as_mut().expect("it has one").times = times.to_vec();
        roll
    };
    let listed = |roll: &Roll| {
        let concerns = roll.concerns().into_iter();
        let mut of_times = concerns.filter(|it| it.what.contains("same time in the table"));
        of_times.next().map_or_else(Vec::new, |it| it.which)
    };
    let after = |earlier: &[&Roll], mut next: Roll| {
        for earlier in earlier {
            next.remember_times(earlier);
        }
        next.note_times();
        next
    };
    // The other line says something about somebody who has not handed in anything yet.
    let old = [line("ada", 20, 11), line("eve", 20, 11)];
    let before = [("ada", "a"), ("bob", "b")];
    let now = [("ada", "new"), ("bob", "b"), ("eve", "e")];
    let first = after(&[], class(&before, &old));
    assert_eq!(listed(&first), [""; 0]);
    assert_eq!(listed(&after(&[&first], class(&before, &old))), [""; 0]);
    let ada = || class(&now[..1], &old);
    let whole = after(&[&first], class(&now, &old));
    for (whole, ids) in [
        (&whole, &["ada", "eve"][..]),
        (&ada().into_class(first.clone()), &["ada"]),
    ] {
        assert_eq!(listed(whole), ids);
        // They are listed in later runs, too.
        let bob = class(&[("bob", "b")], &old);
        assert_eq!(listed(&bob.into_class(whole.clone())), ids);
        let ada = class(&before[..1], &old);
        assert_eq!(listed(&ada.into_class(whole.clone())), ids[1..]);
    }
    let both = &["ada", "eve"][..];
    let without = after(&[&whole], class(&now, &[]));
    let newer = [line("ada", 25, 11), line("eve", 25, 11)];
    for (times, ids) in [
        (&old[..], both),
        (&[], &[]),
        (&newer, &[]),
        // One of the lines is newer, or they stand elsewhere, or the time zone was wrong.
        (&[line("ada", 20, 11), line("eve", 25, 11)], &both[..1]),
        (&[line("eve", 20, 11), line("ada", 20, 11)], both),
        (&[line("ada", 20, 12), line("eve", 20, 12)], both),
    ] {
        for earlier in [
            &[&whole][..],
            &[&without],
            &[&without, &first],
            &[&first, &without],
        ] {
            assert_eq!(
                listed(&after(earlier, class(&now, times))),
                ids,
                "{times:?}"
            );
        }
    }
    assert_eq!(listed(&after(&[&whole], class(&before, &old))), [""; 0]);
    // Two submissions may have come within one minute.
    let named = |name: &str| TimeLine {
        keys: vec![
            (TimeKey::Id, "ada".into()),
            (TimeKey::Submission, name.into()),
        ],
        ..line("ada", 20, 11)
    };
    let twice = || class(&before, &[named("ada"), named("ada.2")]);
    let once = after(&[], twice());
    assert_eq!(listed(&after(&[&once], twice())), [""; 0]);
    // Each line is about few submissions, so what is stored stays small.
    assert!(first.timed[0].1.keys().eq(["ada"]), "{first:?}");
    // The class may be passed as `class/*`.
    let again = class(&before, &newer).into_class(first.clone());
    assert_eq!(listed(&again), [""; 0]);
    let again = class(&now[..2], &newer).into_class(again);
    assert_eq!(listed(&again), both[..1]);
    // Two runs have seen different answers first.
    let other = after(&[], class(&now, &old));
    for parts in [[&first, &other], [&other, &first]] {
        assert_eq!(listed(&after(&parts, class(&now, &old))), both);
    }
}

#[test]
fn files_that_are_earlier_by_the_table_of_times_than_by_their_names_are_listed() {
    let canvas = "ada_LATE_1_2_a.zip";
    let extended = format!("{RULES}\n[extensions]\nada = '2026-11-25 12:00'\n");
    let days_late = "x_attempt_2026-11-24-13-00-00_a.zip";
    for (name, time, rules, is_listed) in [
        (days_late, "13:00", RULES, true),
        (days_late, "13:00", &extended, false),
        (LATE, "11:00", RULES, true),
        (canvas, "11:00", RULES, true),
        (EARLY, "11:00", RULES, false),
        (LATE, "13:00", RULES, false),
        (LATE, "12:59", RULES, false),
        // Canvas knows nothing of the extension.
        (canvas, "13:00", &extended, false),
        (canvas, "11:00", &extended, true),
    ] {
        let mut roll = roll(vec![entry("one", "ada", name)], rules, &[]);
        let policy = roll.policy.as_mut().expect("it has one");
        policy.times.push(TimeLine {
            keys: vec![(TimeKey::Id, "ada".into())],
            at: format!("2026-11-20T{time}:00Z").parse().ok(),
            said: String::new(),
        });
        let concerns = rows(&roll, &records(&[("one", 60)])).concerns;
        let of_name = concerns
            .iter()
            .filter(|it| it.what.contains("name for the files"));
        let which: Vec<&String> = of_name.flat_map(|it| &it.which).collect();
        assert_eq!(which == ["one"], is_listed, "{name} {time}");
    }
}
