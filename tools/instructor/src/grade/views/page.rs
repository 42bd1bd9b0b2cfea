//! `class.html`: the whole class on one page.

use minijinja::{context, value::Serde};
use serde::Serialize;

use crate::grade::alike::SharedAnswer;
use crate::grade::class::{Class, Row, SharedBelief};
use crate::grade::intake::roster::{Person, Placement};
use crate::grade::record::explained;
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

/// What stands on the page. Names are a student's: whatever cannot be seen is shown as
/// its code, and the template escapes the rest.
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
    alike: Vec<SharedAnswer>,
    slowest: Vec<(String, String)>,
    placed: &'a Placement,
    ambiguous: Vec<(String, Vec<String>)>,
    missing: Vec<Person>,
    ignored: Vec<String>,
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

/// A task or a scene, over the class.
#[derive(Serialize)]
struct Part {
    name: String,
    about: String,
    is_group: bool,
    possible: u32,
    mean: String,
    full: usize,
    of: usize,
}

/// A submission's row.
#[derive(Serialize)]
struct Line {
    id: String,
    name: String,
    person: String,
    section: String,
    points: Option<u32>,
    outcome: &'static str,
    notes: String,
    flags: usize,
    seconds: String,
    report: Option<String>,
}

/// The page of a class.
pub fn html(class: &Class, assignment: &Assignment) -> String {
    let environment = environment(&TEMPLATES);
    let style = [PAGE_CSS, include_str!("../../../templates/class.css")];
    let style = style.concat().replace('\r', "");
    let script = include_str!("../../../templates/class.js").replace('\r', "");
    let page = environment.get_template("class.html").and_then(|page| {
        page.render(context! {
            class => Serde(of(class, assignment)),
            policy => policy(&style, &script),
            style,
            script,
        })
    });
    page.unwrap_or_else(|error| panic!("the class's template: {error:#}"))
}

fn of<'a>(class: &'a Class<'a>, assignment: &Assignment) -> Page<'a> {
    let mut points: Vec<u32> = class
        .graded()
        .filter_map(|record| record.got.points)
        .collect();
    points.sort();
    let possible = class
        .graded()
        .map(|record| record.got.possible)
        .max()
        .unwrap_or(0);
    let bins = bins(&points, possible);
    let mut judged_on: Vec<String> = class
        .graded()
        .map(|record| record.provenance.made_with.judged_on.clone())
        .collect();
    judged_on.sort();
    judged_on.dedup();
    let shown = |ids: &[String]| ids.iter().map(|id| printable(id)).collect::<Vec<_>>();
    let alike = class.alike.iter().map(|alike| SharedAnswer {
        who: shown(&alike.who),
        ..alike.clone()
    });
    let slowest = class.slowest().into_iter();
    let ambiguous = class.roll.placed.ambiguous.iter();
    Page {
        title: &class.title,
        judged_on: judged_on.join("; "),
        count: class.rows.len(),
        possible,
        mean: mean(points.iter().copied()),
        median: points.get(points.len() / 2).copied(),
        not_graded: class
            .not_graded()
            .into_iter()
            .map(|(id, why)| (printable(id), printable(why)))
            .collect(),
        most_in_bin: bins.iter().map(|bin| bin.count).max().unwrap_or(0).max(1),
        bins,
        outcomes: class
            .outcomes()
            .into_iter()
            .map(|(kind, who)| StatusRow {
                word: kind.word(),
                explained: explained(kind),
                who: who.into_iter().map(printable).collect(),
            })
            .collect(),
        tasks: parts(class, assignment),
        mistakes: class.mistakes(),
        alike: alike.collect(),
        slowest: slowest
            .map(|(id, seconds)| (printable(id), format!("{seconds:.1}")))
            .collect(),
        ambiguous: ambiguous
            .map(|(id, people)| {
                let people = people.iter().map(|person| printable(&person.name));
                (printable(id), people.collect())
            })
            .collect(),
        missing: class.roll.placed.missing.iter().map(visible).collect(),
        placed: &class.roll.placed,
        ignored: shown(&class.roll.ignored),
        rows: class.rows.iter().map(line).collect(),
    }
}

fn visible(person: &Person) -> Person {
    Person {
        id: printable(&person.id),
        name: printable(&person.name),
        section: printable(&person.section),
    }
}

fn line(row: &Row) -> Line {
    let person = row.person.map(visible).unwrap_or_default();
    let graded = row.record.filter(|record| record.is_graded());
    Line {
        id: person.id,
        name: printable(&row.entry.name),
        person: person.name,
        section: person.section,
        points: graded.and_then(|record| record.got.points),
        outcome: row
            .record
            .map_or(Status::NotGraded, |record| record.status)
            .word(),
        notes: row.record.map(|record| record.notes()).unwrap_or_default(),
        flags: row.record.map_or(0, |record| record.got.flags.len()),
        seconds: graded
            .map(|record| format!("{:.1}", record.timings.total))
            .unwrap_or_default(),
        report: graded.map(|record| format!("submissions/{}/report.html", record.id)),
    }
}

fn mean(points: impl Iterator<Item = u32>) -> Option<String> {
    let (sum, count) = points.fold((0, 0), |(sum, count), points| (sum + points, count + 1));
    (count > 0).then(|| format!("{:.1}", f64::from(sum) / f64::from(count)))
}

/// Ten bars; full marks have their own.
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

/// Task by task, group by group, scene by scene.
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
    };
    let mut parts = Vec::new();
    for task in &assignment.tasks {
        let of = class.graded().filter_map(|record| {
            let mut tasks = record.got.tasks.iter();
            tasks.find(|other| other.name == task.name)
        });
        let of: Vec<_> = of.collect();
        let all = of.iter().map(|task| (task.points, task.possible)).collect();
        parts.push(part(&task.name, &task.chapter, false, all));
        for group in &task.points {
            let groups = of.iter().filter_map(|task| {
                let group = task.groups.iter().find(|other| other.name == group.group)?;
                Some((group.points, group.possible))
            });
            parts.push(part(&group.group, &group.about, true, groups.collect()));
        }
    }
    let all = class.graded().map(|record| record.scene_points()).collect();
    parts.push(part("scenes", "all answers together", false, all));
    let names = class.graded().next().map(|record| &record.got.scenes);
    for scene in names.into_iter().flatten() {
        let scenes = class.graded().filter_map(|record| {
            let scene = record
                .got
                .scenes
                .iter()
                .find(|other| other.name == scene.name)?;
            Some((scene.points, scene.possible))
        });
        parts.push(part(&scene.name, "", true, scenes.collect()));
    }
    parts
}
