//! Finds each person's mark: which submission counts, and how the policy changes its points.

use std::collections::{BTreeMap, BTreeSet};

use super::concern::Concern;
use super::{Roll, Row};
use crate::grade::intake::Entry;
use crate::grade::intake::matching::Proof;
use crate::grade::intake::names::HandInTime;
use crate::grade::intake::roster::Person;
use crate::grade::policy::Policy;
use crate::grade::policy::mark::{JudgedPoints, Mark};
use crate::grade::policy::rules::Attempts;
use crate::grade::policy::times::Lateness;
use crate::grade::record::RecordSummary;

/// A class's rows with their marks.
#[derive(Default)]
pub struct Rows<'a> {
    /// One for each submission.
    pub own: Vec<Row<'a>>,
    /// For people whose group has handed something in for them.
    pub shared: Vec<Row<'a>>,
    /// What the policy could not decide.
    pub concerns: Vec<Concern>,
}

/// The rows of a class, before it is graded or after.
pub fn rows<'a>(roll: &'a Roll, records: &'a BTreeMap<String, RecordSummary>) -> Rows<'a> {
    let row = |entry: &'a Entry| Row {
        entry,
        person: roll.placed.of.get(&entry.id),
        record: records.get(&entry.id),
        mark: None,
        not_counted: None,
        is_shared: false,
    };
    let mut rows = Rows {
        own: roll.entries.iter().map(row).collect(),
        ..Rows::default()
    };
    // Without a policy, no points are taken off, but only one submission still counts for each
    // person.
    let nothing = Policy::default();
    apply(roll.policy.as_ref().unwrap_or(&nothing), roll, &mut rows);
    rows
}

/// What a policy could not decide, sorted by what the instructor can do about it.
#[derive(Default)]
struct Open {
    late_sometime: Vec<String>,
    later_by_name: Vec<String>,
    unknown: Vec<String>,
    contested: Vec<String>,
    undecided: Vec<String>,
    by_name: Vec<String>,
    several: Vec<String>,
}

fn apply<'a>(policy: &Policy, roll: &'a Roll, rows: &mut Rows<'a>) {
    // People who hand in together, and the places of their submissions.
    let mut teams: BTreeMap<String, (Vec<&'a Person>, Vec<usize>)> = BTreeMap::new();
    for (at, row) in rows.own.iter().enumerate() {
        let (team, people) = match row.person {
            Some(person) => (format!("person {}", person.id), roll.team_of(person)),
            None => (format!("submission {}", row.entry.id), Vec::new()),
        };
        let group = row.person.and_then(|person| policy.group_of(&person.id));
        // Two groups may have the same name.
        let team = group.map_or(team, |group| format!("group of {}", group.members[0]));
        teams.entry(team).or_insert((people, Vec::new())).1.push(at);
    }
    let people = roll.people.as_deref().unwrap_or_default();
    let mut open = Open::default();
    // What may be somebody's copies puts nobody in doubt.
    let uncertain = roll.entries.iter().filter(|it| it.at_most > Proof::Hint);
    let in_doubt = uncertain.filter_map(|it| roll.placed.ambiguous.get(&it.id));
    let in_doubt: BTreeSet<&str> = in_doubt.flatten().map(|it| it.id.as_str()).collect();
    for (team, places) in teams.values() {
        let (places, dispute) = proven(places, team, &in_doubt, roll, rows, &mut open);
        let handed_in: Vec<Attempt> = places
            .iter()
            .map(|at| Attempt::new(*at, &rows.own[*at], policy, team, people))
            .collect();
        let is_disputed = match dispute {
            Dispute::No => false,
            Dispute::UnlessSame => !are_same(&handed_in),
            Dispute::Yes => true,
        };
        let nobody = [None];
        let each: Vec<Option<&'a Person>> = team.iter().map(|it| Some(*it)).collect();
        let each = if each.is_empty() { &nobody[..] } else { &each };
        for person in each {
            give(policy, *person, &handed_in, is_disputed, rows, &mut open);
        }
    }
    let strangers = policy.strangers(people);
    let all = [
        (
            "named in the policy, but not on the roster",
            true,
            strangers,
        ),
        (
            "groups whose name is like the id or login of a person who is not in the group: work \
             handed in under that name may count as that person's; rename these groups in the \
             table of groups",
            true,
            policy.misnamed_groups(people),
        ),
        (
            "with several submissions, but it is not known when they were handed in, so there is no \
             final mark; list the times (`times` in policy.toml), or grade only the submission that \
             counts",
            true,
            open.undecided,
        ),
        (
            "in a group that may have handed in several submissions, and placed by a name that somebody \
             else may have chosen, so they don't count (unless all are the same): put the one that \
             counts into a folder named after the person's id",
            true,
            open.by_name,
        ),
        (
            "late, but nothing says by how much: no points taken off; list the times (`times` in \
             policy.toml)",
            true,
            open.late_sometime,
        ),
        (
            "later by the platform's name for the files than by the table of times: counted by the table; \
             pass a newer one (`times` in policy.toml)",
            true,
            open.later_by_name,
        ),
        (
            "in the table of times under an id or login that may be another person's: counted as on \
             time; correct that table, or put a column `id` into it",
            true,
            open.contested,
        ),
        match policy.times.is_empty() {
            false => (
                "not in the table of times: counted as on time",
                true,
                open.unknown,
            ),
            true => (
                "without a submission time, so counted as on time; list the times (`times` in \
                 policy.toml)",
                true,
                open.unknown,
            ),
        },
        (
            "with several submissions, of which one counts",
            false,
            open.several,
        ),
    ];
    let all = all.into_iter().filter(|(_, _, which)| !which.is_empty());
    rows.concerns = all
        .map(|(what, is_grave, mut which)| {
            which.sort();
            which.dedup();
            Concern {
                what,
                which,
                is_grave,
            }
        })
        .collect();
}

/// Why a submission of a group doesn't count beside others.
const IS_NAMED: &str = "not counted: only a name, which anybody may have chosen, says whose it is";

/// Whether somebody may have chosen the name of a member of a team.
enum Dispute {
    No,
    /// Unless all its submissions are the same.
    UnlessSame,
    Yes,
}

/// The places of a team's submissions that may count. If names place submissions for several of its
/// members, or for one beside another who is known by an id or is `in_doubt` (may have handed in
/// something else), somebody may have chosen a member's name.
fn proven(
    places: &[usize],
    team: &[&Person],
    in_doubt: &BTreeSet<&str>,
    roll: &Roll,
    rows: &mut Rows,
    open: &mut Open,
) -> (Vec<usize>, Dispute) {
    let is_by_name = |at: &&usize| roll.placed.by_name.contains(&rows.own[**at].entry.id);
    let (by_name, proven): (Vec<usize>, Vec<usize>) = places.iter().partition(is_by_name);
    let person = |at: &usize| rows.own[*at].person.map(|it| &it.id);
    let dispute = match () {
        () if !proven.is_empty() => Dispute::No,
        () if team.iter().any(|it| in_doubt.contains(&*it.id)) => Dispute::Yes,
        () if by_name.iter().any(|at| person(at) != person(&by_name[0])) => Dispute::UnlessSame,
        () => return (by_name, Dispute::No),
    };
    for at in &by_name {
        open.by_name.push(rows.own[*at].entry.id.clone());
        rows.own[*at].not_counted = Some(IS_NAMED.into());
    }
    match proven.is_empty() {
        true => (by_name, dispute),
        false => (proven, dispute),
    }
}

/// One submission of a team.
struct Attempt {
    /// Its place among the class's rows.
    at: usize,
    id: String,
    lateness: Lateness,
    /// How late it is according to the names of its files, whatever the table of times says.
    by_name: Lateness,
    time: Option<HandInTime<jiff::Timestamp>>,
    judged: Option<JudgedPoints>,
    /// An id or login that the table of times may list for another person; see
    /// [`Policy::handed_in`].
    contested: Option<String>,
    /// See [`RecordSummary::tokens`].
    tokens: Box<[(String, String)]>,
}

impl Attempt {
    fn new(at: usize, row: &Row, policy: &Policy, team: &[&Person], people: &[Person]) -> Attempt {
        let extra = policy.rules.extra_credit.as_ref();
        let extra = extra.map_or(&[][..], |it| &it.parts);
        let handed_in = policy.handed_in(row.entry, row.person, people);
        let contested = handed_in.as_ref().err().cloned();
        let time = handed_in.unwrap_or_default();
        Attempt {
            at,
            id: row.entry.id.clone(),
            lateness: policy.lateness(time, team),
            by_name: policy.lateness(policy.named(row.entry), team),
            time,
            contested,
            judged: row
                .record
                .and_then(|record| JudgedPoints::of(record, extra)),
            tokens: row.record.map_or_else(Box::default, |it| it.tokens.clone()),
        }
    }

    /// Whether both are the same answers with the same points, so that it doesn't matter which of
    /// them counts. Platforms may export a group's submission once for each member.
    fn is_same(&self, other: &Attempt) -> bool {
        let points = |it: &Attempt| it.judged.map(|judged| (judged.points, judged.extra));
        !self.tokens.is_empty()
            && self.tokens == other.tokens
            && self.lateness == other.lateness
            && points(self) == points(other)
    }

    fn mark(&self, policy: &Policy, person: Option<&Person>) -> Option<Mark> {
        self.mark_if(&self.lateness, policy, person)
    }

    fn mark_if(&self, late: &Lateness, policy: &Policy, person: Option<&Person>) -> Option<Mark> {
        let id = person.map(|person| person.id.as_str());
        Some(policy.mark(self.judged?, late, id))
    }

    /// Whether it is later by the names of its files than by the table of times, and that matters.
    fn is_later_by_name(&self, policy: &Policy, person: Option<&Person>) -> bool {
        match (&self.by_name, &self.lateness, self.time) {
            (Lateness::Late { .. }, Lateness::InTime, _) => true,
            (Lateness::Late { at: named, .. }, Lateness::Late { at, .. }, _) => {
                let of = |late| self.mark_if(late, policy, person);
                let cost = |late| of(late).map(|mark| (mark.last, mark.late_days));
                named > at && cost(&self.by_name) != cost(&self.lateness)
            }
            // The platform knows no extension and no grace period.
            (Lateness::LateSometime, Lateness::InTime, Some(HandInTime::At(time))) => {
                policy.is_early(time)
            }
            _ => false,
        }
    }
}

fn are_same(attempts: &[Attempt]) -> bool {
    attempts.iter().skip(1).all(|it| attempts[0].is_same(it))
}

/// Which attempt counts for a person; `None` if that can't be decided.
fn counted<'a>(
    policy: &Policy,
    person: Option<&Person>,
    attempts: &'a [Attempt],
) -> Option<&'a Attempt> {
    if are_same(attempts) {
        return attempts.first();
    }
    match policy.rules.attempts {
        // Of two equally good ones, the one that spends fewer late days counts. Otherwise, one
        // member of a group could spend those of the others.
        Attempts::Best => attempts.iter().max_by(|a, b| {
            let [a, b] = [a, b].map(|it| it.mark(policy, person));
            let points = |mark: &Option<Mark>| mark.as_ref().map_or(-1.0, |mark| mark.last);
            let late_days = |mark: &Option<Mark>| mark.as_ref().map_or(0, |mark| mark.late_days);
            let by_points = points(&a).total_cmp(&points(&b));
            by_points.then(late_days(&b).cmp(&late_days(&a)))
        }),
        Attempts::Last => {
            let time = |it: &Attempt| match it.time {
                Some(HandInTime::At(time)) => Some(time),
                _ => None,
            };
            let times: Option<Vec<_>> = attempts.iter().map(time).collect();
            let last = times?.into_iter().max();
            let mut last = attempts.iter().filter(|it| time(it) == last);
            last.next().filter(|_| last.next().is_none())
        }
    }
}

/// Gives a person the mark of the attempt that counts.
fn give<'a>(
    policy: &Policy,
    person: Option<&'a Person>,
    attempts: &[Attempt],
    is_disputed: bool,
    rows: &mut Rows<'a>,
    open: &mut Open,
) {
    let counts = counted(policy, person, attempts).filter(|_| !is_disputed);
    let ids: Vec<&str> = attempts.iter().map(|it| it.id.as_str()).collect();
    match counts {
        None if is_disputed => {}
        None => open.undecided.push(ids.join(" and ")),
        Some(counts) => {
            if ids.len() > 1 {
                open.several
                    .push(format!("{} (counts: {})", ids.join(" and "), counts.id));
            }
            match counts.lateness {
                Lateness::LateSometime => open.late_sometime.push(counts.id.clone()),
                Lateness::Unknown => match &counts.contested {
                    Some(key) => open.contested.push(format!("{}: {key}", counts.id)),
                    None => open.unknown.push(counts.id.clone()),
                },
                Lateness::InTime | Lateness::Late { .. } => {
                    if counts.is_later_by_name(policy, person) {
                        open.later_by_name.push(counts.id.clone());
                    }
                }
            }
        }
    }
    let why_not = match counts {
        None if is_disputed => IS_NAMED.to_owned(),
        None => "not counted, because nothing says whether it is the last".to_owned(),
        Some(counts) => format!("not counted: the submission that counts is {}", counts.id),
    };
    let is_own = |row: &Row| row.person.map(|it| &it.id) == person.map(|it| &it.id);
    let mut has_row = false;
    for attempt in attempts {
        let does_count = counts.is_some_and(|counts| counts.at == attempt.at);
        let mark = attempt.mark(policy, person).filter(|_| does_count);
        let not_counted = (!does_count).then(|| why_not.clone());
        let row = &mut rows.own[attempt.at];
        if is_own(row) {
            (row.mark, row.not_counted) = (mark, not_counted);
            has_row |= does_count || counts.is_none();
        }
    }
    let shown = counts.or(attempts.first()).filter(|_| !has_row);
    if let (Some(shown), Some(person)) = (shown, person) {
        let shared = Row {
            person: Some(person),
            is_shared: true,
            mark: shown
                .mark(policy, Some(person))
                .filter(|_| counts.is_some()),
            not_counted: counts.is_none().then_some(why_not),
            ..rows.own[shown.at].clone()
        };
        rows.shared.push(shared);
    }
}

#[cfg(test)]
pub mod tests;
