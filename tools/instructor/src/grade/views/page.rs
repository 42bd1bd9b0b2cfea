//! `class.html`: the whole class on one page.

use std::collections::BTreeMap;

use minijinja::{context, value::Serde};
use serde::Serialize;

use crate::grade::class::concern::Concern;
use crate::grade::class::{Class, Row, SharedBelief};
use crate::grade::intake::roster::Person;
use crate::grade::policy::mark::number;
use crate::grade::record::{PartSummary, explained};
use crate::grade::shared_answers::{SharedAnswer, SharedPair};
use crate::grade::unexplained_groups::{self, UnexplainedGroup};
use pinhole_course::assignment::Assignment;
use pinhole_course::outcome::Status;
use pinhole_report::escape::printable;
use pinhole_report::html::{PAGE_CSS, environment, policy};

const TEMPLATES: [(&str, &str); 2] = [
    ("class.html", include_str!("../../../templates/class.html")),
    (
        "people.html",
        include_str!("../../../templates/people.html"),
    ),
];

/// The contents of the page. Names come from students, so invisible characters are shown as
/// codes, and the template escapes the rest.
#[derive(Serialize)]
struct Page<'a> {
    title: &'a str,
    judged_on: String,
    count: usize,
    possible: u32,
    mean: Option<String>,
    median: Option<u32>,
    not_graded: Vec<(String, String)>,
    bins: Vec<Bin>,
    most_in_bin: usize,
    outcomes: Vec<StatusRow>,
    tasks: Vec<Part>,
    mistakes: Vec<SharedBelief>,
    unexplained: Vec<UnexplainedGroup>,
    alike: Vec<SharedAnswer>,
    pairs: Vec<SharedPair>,
    sections: Vec<SectionRow>,
    /// Whether there is a policy, which may change marks.
    has_policy: bool,
    /// Whether the page is to be shown to the class, without names and without rows for single
    /// people.
    is_anonymous: bool,
    slowest: Vec<(String, String)>,
    /// How many people are graded, in a sentence.
    headline: String,
    concerns: Vec<Concern>,
    is_grave: bool,
    rows: Vec<Line>,
}

/// How many submissions have `from` to `to` points.
#[derive(Serialize)]
struct Bin {
    from: u32,
    to: u32,
    count: usize,
}

#[derive(Serialize)]
struct StatusRow {
    word: &'static str,
    explained: &'static str,
    who: Vec<String>,
}

/// A task, a group of questions or a scene, with the results of the whole class.
#[derive(Serialize)]
struct Part {
    name: String,
    about: String,
    is_group: bool,
    possible: u32,
    mean: String,
    full: usize,
    of: usize,
    /// The percentage of submissions that don't have all its points.
    failing: u32,
}

/// A section of the course.
#[derive(Serialize)]
struct SectionRow {
    name: String,
    count: usize,
    mean: Option<String>,
    median: Option<u32>,
}

/// A submission's row.
#[derive(Serialize)]
struct Line {
    id: String,
    name: String,
    person: String,
    section: String,
    points: Option<u32>,
    /// The mark after the policy, and the final mark.
    policy: String,
    last: String,
    changes: Vec<String>,
    outcome: &'static str,
    notes: String,
    flags: usize,
    seconds: String,
    report: Option<String>,
}

/// Who may see a page.
#[derive(Clone, Copy, Eq, PartialEq)]
pub enum Audience {
    Instructor,
    /// The page has no names, so that it can be shown in class.
    Class,
}

/// The page of a class.
pub fn html(class: &Class, assignment: &Assignment, audience: Audience) -> String {
    let environment = environment(&TEMPLATES);
    let style = [PAGE_CSS, include_str!("../../../templates/class.css")];
    let style = style.concat().replace('\r', "");
    let script = include_str!("../../../templates/class.js").replace('\r', "");
    let page = environment.get_template("class.html").and_then(|page| {
        page.render(context! {
            class => Serde(of(class, assignment, audience)),
            policy => policy(&style, &script),
            style,
            script,
        })
    });
    page.unwrap_or_else(|error| panic!("the class's template: {error:#}"))
}

fn of<'a>(class: &'a Class<'a>, assignment: &Assignment, audience: Audience) -> Page<'a> {
    let is_anonymous = audience == Audience::Class;
    let mut points: Vec<u32> = class.graded().filter_map(|record| record.points).collect();
    points.sort();
    let possible = class
        .graded()
        .map(|record| record.possible)
        .max()
        .unwrap_or(0);
    let bins = bins(&points, possible);
    // Show only the number of people.
    let name = |id: &str| match is_anonymous {
        true => String::new(),
        false => printable(id),
    };
    let shown = |ids: &[String]| ids.iter().map(|id| name(id)).collect::<Vec<_>>();
    let alike = class.alike.iter().map(|alike| SharedAnswer {
        who: shown(&alike.who),
        ..alike.clone()
    });
    let slowest = class.slowest().into_iter();
    let concerns = class.concerns.iter().map(|concern| Concern {
        which: shown(&concern.which),
        ..concern.clone()
    });
    let concerns: Vec<Concern> = concerns.collect();
    let mistakes = class.mistakes().into_iter().map(|held| SharedBelief {
        who: shown(&held.who),
        ..held
    });
    let unexplained = unexplained_groups::groups(class.graded()).into_iter();
    let unexplained = unexplained.map(|group| UnexplainedGroup {
        who: shown(&group.who),
        ..group
    });
    Page {
        title: &class.title,
        judged_on: class.judged_on().join("; "),
        count: class.rows.len(),
        possible,
        mean: mean(points.iter().copied()),
        median: points.get(points.len() / 2).copied(),
        not_graded: class
            .not_graded()
            .into_iter()
            .map(|(id, why)| (name(id), printable(why)))
            .collect(),
        most_in_bin: bins.iter().map(|bin| bin.count).max().unwrap_or(0).max(1),
        bins,
        outcomes: class
            .outcomes()
            .into_iter()
            .map(|(kind, who)| StatusRow {
                word: kind.word(),
                explained: explained(kind),
                who: who.into_iter().map(name).collect(),
            })
            .collect(),
        tasks: parts(class, assignment),
        mistakes: mistakes.collect(),
        unexplained: unexplained.collect(),
        alike: alike.collect(),
        pairs: class
            .pairs
            .iter()
            .map(|pair| SharedPair {
                who: pair.who.each_ref().map(|id| name(id)),
                ..pair.clone()
            })
            .collect(),
        // A section may be a single person, as in Moodle's groups.
        sections: match is_anonymous {
            true => Vec::new(),
            false => sections(class),
        },
        has_policy: class.roll.policy.is_some(),
        is_anonymous,
        slowest: slowest
            .map(|(id, seconds)| (name(id), format!("{seconds:.1}")))
            .collect(),
        headline: class.roll.headline(&|id| class.is_graded(id), "graded"),
        is_grave: concerns.iter().any(|concern| concern.is_grave),
        concerns,
        rows: match is_anonymous {
            true => Vec::new(),
            false => class.all_rows().map(line).collect(),
        },
    }
}

fn visible(person: &Person) -> Person {
    Person {
        id: printable(&person.id),
        name: printable(&person.name),
        section: printable(&person.section),
        ..Person::default()
    }
}

fn line(row: &Row) -> Line {
    let person = row.person.map(visible).unwrap_or_default();
    let graded = row.record.filter(|record| record.is_graded());
    let changes = row.mark.iter().flat_map(|mark| &mark.changes);
    let changes = changes.map(|change| change.in_words());
    Line {
        id: person.id,
        name: printable(&row.entry.name),
        person: person.name,
        section: person.section,
        points: graded.and_then(|record| record.points),
        policy: row
            .mark
            .as_ref()
            .map_or(String::new(), |mark| number(mark.policy)),
        last: row
            .mark
            .as_ref()
            .map_or(String::new(), |mark| number(mark.last)),
        changes: changes
            .chain(row.not_counted.iter().cloned())
            .map(|why| printable(&why))
            .collect(),
        outcome: row
            .record
            .map_or(Status::NotGraded, |record| record.status)
            .word(),
        notes: row
            .record
            .map_or(String::new(), |record| printable(&record.notes)),
        flags: row.record.map_or(0, |record| record.flags),
        seconds: graded
            .map(|record| format!("{:.1}", record.seconds))
            .unwrap_or_default(),
        report: graded.map(|record| format!("submissions/{}/report.html", record.id)),
    }
}

/// A row for each section of the course, if there are several.
fn sections(class: &Class) -> Vec<SectionRow> {
    let mut sections: BTreeMap<String, Vec<u32>> = BTreeMap::new();
    for row in class.rows.iter().filter(|row| row.not_counted.is_none()) {
        let points = row.record.and_then(|record| record.points);
        if let (Some(person), Some(points)) = (row.person, points) {
            let section = printable(&person.section);
            sections.entry(section).or_default().push(points);
        }
    }
    if sections.len() < 2 {
        return Vec::new();
    }
    let rows = sections.into_iter().map(|(name, mut points)| {
        points.sort();
        SectionRow {
            name,
            count: points.len(),
            mean: mean(points.iter().copied()),
            median: points.get(points.len() / 2).copied(),
        }
    });
    rows.collect()
}

fn mean(points: impl Iterator<Item = u32>) -> Option<String> {
    let (sum, count) = points.fold((0, 0), |(sum, count), points| (sum + points, count + 1));
    (count > 0).then(|| format!("{:.1}", f64::from(sum) / f64::from(count)))
}

/// The histogram of points: ten bars, and a separate one for full marks.
fn bins(points: &[u32], possible: u32) -> Vec<Bin> {
    let width = possible.div_ceil(10).max(1);
    let starts = (0..possible).step_by(width as usize);
    let ranges = starts.map(|from| (from, (from + width - 1).min(possible.saturating_sub(1))));
    ranges
        .chain([(possible, possible)])
        .map(|(from, to)| Bin {
            from,
            to,
            count: points
                .iter()
                .filter(|points| (from..=to).contains(points))
                .count(),
        })
        .collect()
}

/// A row for each task, each group of questions and each scene.
fn parts(class: &Class, assignment: &Assignment) -> Vec<Part> {
    let part = |name: &str, about: &str, is_group: bool, all: Vec<(u32, u32)>| Part {
        name: name.into(),
        about: about.into(),
        is_group,
        possible: all.iter().map(|(_, possible)| *possible).max().unwrap_or(0),
        mean: mean(all.iter().map(|(points, _)| *points)).unwrap_or_default(),
        full: all
            .iter()
            .filter(|(points, possible)| points == possible)
            .count(),
        of: all.len(),
        failing: {
            let failing = all.iter().filter(|(points, possible)| points < possible);
            (100 * failing.count() / all.len().max(1)) as u32
        },
    };
    let points = |part: &PartSummary| (part.points, part.possible);
    let mut parts = Vec::new();
    for task in &assignment.tasks {
        let of = class.graded().filter_map(|record| {
            let mut tasks = record.tasks.iter();
            tasks.find(|other| *other.task.name == *task.name)
        });
        let of: Vec<_> = of.collect();
        let all = of.iter().map(|it| points(&it.task)).collect();
        parts.push(part(&task.name, &task.chapter, false, all));
        for group in task.all_points() {
            let groups = of.iter().filter_map(|task| {
                let mut groups = task.groups.iter();
                groups.find(|it| *it.name == group.group).map(points)
            });
            parts.push(part(&group.group, &group.about, true, groups.collect()));
        }
    }
    let all = class.graded().map(|record| record.scene_points).collect();
    parts.push(part("scenes", "all answers together", false, all));
    let names = class.graded().next().map(|record| &record.scenes);
    for scene in names.into_iter().flatten() {
        let scenes = class.graded().filter_map(|record| {
            let mut scenes = record.scenes.iter();
            scenes.find(|it| it.name == scene.name).map(points)
        });
        parts.push(part(&scene.name, "", true, scenes.collect()));
    }
    parts
}
