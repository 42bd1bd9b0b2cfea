//! `grades.csv`, `groups.csv` and `changes.csv`. They contain no times, so equal marks give equal
//! files, byte for byte.

use crate::grade::class::{Change, Class, Row};
use crate::grade::policy::mark::{Mark, number};
use crate::grade::record::{PartSummary, RecordSummary, TaskSummary};
use pinhole_course::assignment::Assignment;
use pinhole_report::escape::printable_cell;

/// One line for each submission, then one for each person without a submission.
pub fn grades(class: &Class, assignment: &Assignment) -> String {
    let tasks: Vec<&str> = assignment
        .tasks
        .iter()
        .map(|task| task.name.as_str())
        .collect();
    let head = [
        "id",
        "name",
        "section",
        "submission",
        "points",
        "possible",
        "outcome",
        "notes",
    ];
    let rest = ["scenes", "flags", "judged_on"];
    let marks = ["raw", "policy", "final", "late_days", "changes"];
    let head = [&head[..], &tasks, &rest, &marks].concat();
    let mut table = Table::new(&head);
    for Row {
        entry,
        person,
        record,
        mark,
        not_counted,
        ..
    } in class.all_rows()
    {
        let person = person.cloned().unwrap_or_default();
        let mut line = vec![person.id, person.name, person.section, entry.name.clone()];
        match record {
            Some(record) if record.is_graded() => {
                line.push(record.points.unwrap_or_default().to_string());
                line.push(record.possible.to_string());
                line.push(record.status.word().into());
                line.push(record.notes.clone());
                for name in &tasks {
                    let mut all = record.tasks.iter().map(|it| &it.task);
                    let task = all.find(|task| *task.name == **name);
                    line.push(task.map(|task| task.points.to_string()).unwrap_or_default());
                }
                line.push(record.scene_points.0.to_string());
                line.push(record.flags.to_string());
                line.push(record.judged_on.clone());
                line.extend(of_mark(mark.as_ref(), record, not_counted));
            }
            _ => {
                line.extend([String::new(), String::new(), "not graded".into()]);
                line.resize(head.len(), String::new());
            }
        }
        table.line(&line);
    }
    let placed = &class.roll.placed;
    let missing = placed.missing.iter().map(|it| (it, "nothing handed in"));
    let in_doubt = class.roll.in_doubt().into_iter().map(|it| (it, "in doubt"));
    for (person, outcome) in missing.chain(in_doubt) {
        let mut line = vec![
            person.id.clone(),
            person.name.clone(),
            person.section.clone(),
        ];
        line.resize(head.len(), String::new());
        line[6] = outcome.into();
        table.line(&line);
    }
    table.text()
}

/// A mark's cells: raw, policy, final, late days, and the reasons for changes.
fn of_mark(
    mark: Option<&Mark>,
    record: &RecordSummary,
    not_counted: &Option<String>,
) -> [String; 5] {
    let Some(mark) = mark else {
        let raw = record.points.unwrap_or_default().to_string();
        let why = not_counted.clone().unwrap_or_default();
        return [raw, String::new(), String::new(), String::new(), why];
    };
    let [raw, policy, last] = [mark.raw, mark.policy, mark.last].map(number);
    let changes = mark.changes.iter().map(|change| change.in_words());
    let changes = changes.collect::<Vec<_>>().join("; ");
    [raw, policy, last, mark.late_days.to_string(), changes]
}

/// One line for each group of questions and scene of each submission.
pub fn groups(class: &Class) -> String {
    let mut table = Table::new(&[
        "id",
        "name",
        "submission",
        "task",
        "group",
        "points",
        "possible",
        "outcome",
    ]);
    for row in &class.rows {
        let Some(record) = row.record.filter(|record| record.is_graded()) else {
            continue;
        };
        let person = row.person.cloned().unwrap_or_default();
        let mut line = |task: &str, part: &PartSummary| {
            let [points, possible] = [part.points, part.possible].map(|it| it.to_string());
            let words = [
                &person.id,
                &person.name,
                &row.entry.name,
                task,
                &part.name,
                &points,
                &possible,
                part.status.word(),
            ];
            table.line(&words.map(str::to_owned));
        };
        for TaskSummary { task, groups, .. } in &record.tasks {
            groups.iter().for_each(|group| line(&task.name, group));
        }
        record.scenes.iter().for_each(|scene| line("scenes", scene));
    }
    table.text()
}

/// One line for each mark that grading again has changed.
pub fn changes(changes: &[Change]) -> String {
    let mut table = Table::new(&["submission", "before", "after", "what", "answers"]);
    for change in changes {
        let parts = change
            .parts
            .iter()
            .map(|(name, had, has)| format!("{name} {had} to {has}"));
        table.line(&[
            change.id.clone(),
            change.before.to_string(),
            change.after.to_string(),
            parts.collect::<Vec<_>>().join(", "),
            if change.answers_changed {
                "changed"
            } else {
                "the same"
            }
            .into(),
        ]);
    }
    table.text()
}

/// A CSV file under construction.
pub struct Table(csv::Writer<Vec<u8>>);

impl Table {
    /// A table with these columns.
    pub fn new(head: &[&str]) -> Table {
        let mut table = Table(csv::Writer::from_writer(Vec::new()));
        table.line(
            &head
                .iter()
                .map(|word| (*word).to_owned())
                .collect::<Vec<_>>(),
        );
        table
    }

    /// Adds a line.
    pub fn line(&mut self, cells: &[String]) {
        let cells: Vec<String> = cells.iter().map(|cell| printable_cell(cell)).collect();
        self.0
            .write_record(&cells)
            .expect("memory can be written, and all rows are equally long");
    }

    /// The whole file. It begins with a byte order mark, because without one Excel reads UTF-8
    /// as the system's old 8-bit encoding.
    pub fn text(self) -> String {
        format!("\u{feff}{}", self.for_machines())
    }

    /// The whole file without a byte order mark, for programs that look for the first column's
    /// name.
    pub fn for_machines(self) -> String {
        let bytes = self.0.into_inner().expect("memory can be written");
        String::from_utf8(bytes).expect("only text was written")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn csv_files_begin_with_a_byte_order_mark() {
        let mut table = Table::new(&["name"]);
        table.line(&["Zoë".into()]);
        assert_eq!(table.text(), "\u{feff}name\nZoë\n");
    }
}
