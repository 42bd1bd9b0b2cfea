//! `grades.csv`, `groups.csv` and `changes.csv`: marks without times, the same byte for byte whenever
//! the marks are.

use crate::grade::class::{Change, Class, Row};
use pinhole_course::assignment::Assignment;
use pinhole_report::escape::printable;

/// One line for each submission, then one for each person without.
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
    let head = [&head[..], &tasks, &["scenes", "flags", "judged_on"]].concat();
    let mut table = Table::new(&head);
    for Row {
        entry,
        person,
        record,
    } in &class.rows
    {
        let person = person.cloned().unwrap_or_default();
        let mut line = vec![person.id, person.name, person.section, entry.name.clone()];
        match record {
            Some(record) if record.is_graded() => {
                line.push(record.got.points.unwrap_or_default().to_string());
                line.push(record.got.possible.to_string());
                line.push(record.status.word().into());
                line.push(record.notes());
                for name in &tasks {
                    let task = record.got.tasks.iter().find(|task| task.name == *name);
                    line.push(task.map(|task| task.points.to_string()).unwrap_or_default());
                }
                line.push(record.scene_points().0.to_string());
                line.push(record.got.flags.len().to_string());
                line.push(record.provenance.made_with.judged_on.clone());
            }
            _ => {
                line.extend([String::new(), String::new(), "not graded".into()]);
                line.resize(head.len(), String::new());
            }
        }
        table.line(&line);
    }
    for person in &class.roll.placed.missing {
        let mut line = vec![
            person.id.clone(),
            person.name.clone(),
            person.section.clone(),
        ];
        line.resize(head.len(), String::new());
        line[6] = "nothing handed in".into();
        table.line(&line);
    }
    table.text()
}

/// One line for each group of questions and scene of each submission.
pub fn groups(class: &Class) -> String {
    let mut table = Table::new(&[
        "submission",
        "task",
        "group",
        "points",
        "possible",
        "outcome",
    ]);
    for record in class.graded() {
        let mut line = |task: &str, group: &str, points: u32, possible: u32, outcome: &str| {
            let [points, possible] = [points, possible].map(|points| points.to_string());
            let words = [
                &record.got.submission,
                task,
                group,
                &points,
                &possible,
                outcome,
            ];
            table.line(&words.map(str::to_owned));
        };
        for task in &record.got.tasks {
            for group in &task.groups {
                let word = group.outcome.status().word();
                line(&task.name, &group.name, group.points, group.possible, word);
            }
        }
        for scene in &record.got.scenes {
            line(
                "scenes",
                &scene.name,
                scene.points,
                scene.possible,
                scene.outcome.status().word(),
            );
        }
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

/// A CSV file in the making.
struct Table(csv::Writer<Vec<u8>>);

impl Table {
    /// A table with these columns.
    fn new(head: &[&str]) -> Table {
        let mut table = Table(csv::Writer::from_writer(Vec::new()));
        table.line(
            &head
                .iter()
                .map(|word| (*word).to_owned())
                .collect::<Vec<_>>(),
        );
        table
    }

    /// One line.
    fn line(&mut self, cells: &[String]) {
        let cells: Vec<String> = cells.iter().map(|cell| harmless(cell)).collect();
        self.0
            .write_record(&cells)
            .expect("memory can be written, and lines are even");
    }

    /// All of it.
    fn text(self) -> String {
        let bytes = self.0.into_inner().expect("memory can be written");
        String::from_utf8(bytes).expect("only text was written")
    }
}

/// A spreadsheet must not take somebody's name for a formula.
fn harmless(cell: &str) -> String {
    let cell = printable(cell);
    match cell.trim_start().starts_with(['=', '+', '-', '@']) {
        true => format!("'{cell}"),
        false => cell,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_cell_is_a_formula_or_holds_a_control_character() {
        for cell in ["=1+1", " =1", "+1", "-1", "@A1", "\t=1", "\r=1"] {
            let safe = harmless(cell);
            assert!(
                !safe.trim_start().starts_with(['=', '+', '-', '@']),
                "{safe}"
            );
            assert!(!safe.contains(char::is_control), "{safe}");
        }
        assert_eq!(harmless("Ada"), "Ada");
    }
}
