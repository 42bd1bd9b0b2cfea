use jiff::{SignedDuration, Zoned};

use super::*;
use crate::grade::policy::rules::Rules;

fn policy(rules: &str) -> Policy {
    let rules: Rules = toml::from_str(rules).expect("they are rules");
    rules.check().expect("they make sense");
    Policy {
        rules,
        ..Policy::default()
    }
}

fn due() -> Zoned {
    "2026-11-20 23:59[Europe/Berlin]".parse().expect("a time")
}

fn late(minutes: i64) -> Lateness {
    let due = due();
    let at = &due + SignedDuration::from_mins(minutes);
    match minutes {
        ..=0 => Lateness::InTime,
        _ => Lateness::Late { due, at },
    }
}

fn judged(points: f64) -> JudgedPoints {
    JudgedPoints {
        points,
        possible: 100.0,
        extra: 0.0,
    }
}

const HOUR: i64 = 60;
const DAY: i64 = 24 * HOUR;
const DEADLINE: &str = "time_zone = 'UTC'\ndeadline = '2026-11-20 23:59'\n";

#[test]
fn a_policy_changes_marks_as_it_says() {
    let by_day = "[late]\npercent = 10\nper = 'day'\n";
    let of_earned = "[late]\npercent = 10\nper = 'day'\nof = 'earned'\nat_most = 50\n";
    let by_hour = "[late]\npercent = 0.5\nper = 'hour'\nat_most = 20\n";
    let budget = "[late_days]\nbudget = 2\n[late]\npercent = 10\nper = 'day'\n";
    let by_hand = "[[adjust]]\nid = 'ada'\npoints = 3.5\nreason = 'ours'\n\
        [[adjust]]\nid = 'bob'\npoints = -90\nreason = 'theirs'\n";
    let halves = "[rounding]\nto = 0.5\n";
    let up = "[rounding]\nto = 1\ndirection = 'up'\n";
    let capped = "[extra_credit]\nparts = ['x']\nat_most = 80\n";
    // Rules, points, minutes late, id, the mark after the policy, and the final mark.
    for (rules, points, minutes, id, policy_points, last) in [
        ("", 83.0, 0, "ada", 83.0, 83.0),
        ("", 83.0, DAY, "ada", 83.0, 83.0),
        (by_day, 83.0, 0, "ada", 83.0, 83.0),
        (by_day, 83.0, 1, "ada", 73.0, 73.0),
        (by_day, 83.0, DAY, "ada", 73.0, 73.0),
        (by_day, 83.0, DAY + 1, "ada", 63.0, 63.0),
        (by_day, 5.0, DAY, "ada", 0.0, 0.0),
        (by_day, 83.0, 99 * DAY, "ada", 0.0, 0.0),
        (of_earned, 85.0, DAY, "ada", 76.5, 76.5),
        (of_earned, 85.0, 30 * DAY, "ada", 42.5, 42.5),
        (by_hour, 90.0, HOUR, "ada", 89.5, 89.5),
        (by_hour, 90.0, 90, "ada", 89.0, 89.0),
        (by_hour, 90.0, 30 * DAY, "ada", 70.0, 70.0),
        (budget, 90.0, 2 * DAY, "ada", 90.0, 90.0),
        (budget, 90.0, 2 * DAY + 1, "ada", 80.0, 80.0),
        (by_hand, 50.0, 0, "ada", 50.0, 53.5),
        (by_hand, 50.0, 0, "bob", 50.0, 0.0),
        (by_hand, 50.0, 0, "eve", 50.0, 50.0),
        (halves, 76.25, 0, "ada", 76.25, 76.5),
        (halves, 76.2, 0, "ada", 76.2, 76.0),
        (up, 76.1, 0, "ada", 76.1, 77.0),
        (up, 77.0, 0, "ada", 77.0, 77.0),
        (capped, 90.0, 0, "ada", 80.0, 80.0),
    ] {
        let policy = policy(&format!("{DEADLINE}{rules}"));
        let mark = policy.mark(judged(points), &late(minutes), Some(id));
        let found = (mark.raw, mark.policy, mark.last);
        assert_eq!(
            found,
            (points, policy_points, last),
            "{rules} {points} {minutes} {id}: {:?}",
            mark.changes
        );
        let changed: f64 = mark.changes.iter().map(|change| change.points).sum();
        assert!((points + changed - last).abs() < 1e-9, "{:?}", mark.changes);
    }
}

#[test]
fn no_mark_is_below_zero_and_none_rises_with_lateness() {
    let units = ["hour", "day"];
    let bases = ["possible", "earned"];
    for (per, of, percent, at_most, budget, to) in units.into_iter().flat_map(|per| {
        bases.into_iter().flat_map(move |of| {
            [(0.3, 100, 0, 0.5), (7.0, 40, 1, 1.0), (33.0, 100, 3, 10.0)]
                .map(|(percent, at_most, budget, to)| (per, of, percent, at_most, budget, to))
        })
    }) {
        let policy = policy(&format!(
            "{DEADLINE}[late]\npercent = {percent}\nper = '{per}'\nof = '{of}'\nat_most = {at_most}\n\
             [late_days]\nbudget = {budget}\n[rounding]\nto = {to}\n"
        ));
        for points in [0.0, 1.0, 47.0, 100.0] {
            let mut before = f64::INFINITY;
            for minutes in (-90..12 * DAY).step_by(47) {
                let mark = policy.mark(judged(points), &late(minutes), Some("ada"));
                let is_no_rise = mark.last <= before && mark.policy <= mark.raw;
                assert!(
                    mark.last >= 0.0 && is_no_rise,
                    "{per} {of} {minutes}: {mark:?}"
                );
                before = mark.last;
            }
        }
    }
}

#[test]
fn a_day_late_ends_at_the_same_time_tomorrow_even_when_clocks_change() {
    // In Berlin, 25 October 2026 has 25 hours.
    let due: Zoned = "2026-10-24 23:59[Europe/Berlin]".parse().expect("a time");
    let next: Zoned = "2026-10-25 23:59[Europe/Berlin]".parse().expect("a time");
    assert_eq!(begun(&due, &next, LatenessUnit::Hour), 25);
    assert_eq!(begun(&due, &next, LatenessUnit::Day), 1);
    let after = &next + SignedDuration::from_mins(1);
    assert_eq!(begun(&due, &after, LatenessUnit::Day), 2);
    assert_eq!(begun(&due, &due, LatenessUnit::Day), 0);
}

#[test]
fn extra_credit_does_not_count_as_possible_points() {
    let judged = JudgedPoints {
        points: 90.0,
        possible: 100.0,
        extra: 20.0,
    };
    let mark = policy("").mark(judged, &Lateness::InTime, None);
    assert_eq!((mark.last, mark.possible), (90.0, 80.0));
}

#[test]
fn rules_that_make_no_sense_are_refused_with_a_reason() {
    for (rules, why) in [
        ("[late]\npercent = 10\nper = 'day'\n", "no `deadline`"),
        (
            "deadline = 'x'\n[late]\npercent = 110\nper = 'day'\n",
            "not between 0 and 100",
        ),
        (
            "time_zone = 'UTC'\ndeadline = 'x'\ngrace = 'soon'\n",
            "not a time like",
        ),
        ("deadline = '2026-11-20T23:59:00Z'\n", "needs `time_zone`"),
        ("[rounding]\nto = 0\n", "not between 0.001 and 1000"),
        ("[rounding]\nto = 5e-324\n", "rounding.to is 5e-324"),
        ("[rounding]\nto = 1e308\n", "rounding.to is 1e308"),
        (
            "[[adjust]]\nid = 'a'\npoints = 1\nreason = ' '\n",
            "a reason",
        ),
    ] {
        let rules: Rules = toml::from_str(rules).expect("it is TOML");
        let said = rules.check().expect_err(why);
        assert!(said.contains(why), "{said}");
    }
    toml::from_str::<Rules>("dedline = '2026-11-20 23:59'\n").expect_err("it is misspelt");
}

#[test]
fn times_are_read_in_the_formats_of_people_and_platforms() {
    use super::super::times::{timestamp, zone};
    let berlin = zone(Some("Europe/Berlin")).expect("it is a zone");
    for text in [
        "2026-11-20 23:59",
        "2026-11-20T23:59:00",
        "2026-11-20T22:59:00Z",
        "2026-11-20 17:59:00 -0500",
        "Friday, 20 November 2026, 11:59 PM",
    ] {
        let time = timestamp(text, berlin.as_ref()).expect(text);
        assert_eq!(time.to_string(), "2026-11-20T22:59:00Z", "{text}");
    }
    for text in ["2026-11-20", "soon", "20.11.2026 23:59"] {
        timestamp(text, berlin.as_ref()).expect_err(text);
    }
    let said = timestamp("2026-11-20 23:59", None).expect_err("it needs a zone");
    assert!(said.contains("time_zone"), "{said}");
    zone(Some("Europe/Nowhere")).expect_err("there is no such zone");
}
