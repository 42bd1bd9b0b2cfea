//! One mark: the judged points, the points after the policy, and the points for the gradebook.

use serde::Serialize;

use super::Policy;
use super::rules::{Direction, LatenessUnit, PercentageBase};
use super::times::{Lateness, begun, later};
use crate::grade::record::RecordSummary;

/// A mark on its way to the gradebook. All numbers are points of the assignment, and none is
/// below 0.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Mark {
    /// The judged points.
    pub raw: f64,
    /// After the rules for everyone.
    pub policy: f64,
    /// After changes by hand, rounded.
    #[serde(rename = "final")]
    pub last: f64,
    /// The most points without extra credit.
    pub possible: f64,
    /// Days of the budget that were spent.
    pub late_days: u32,
    /// What was added or taken off, in order.
    pub changes: Vec<Change>,
}

/// Points that were added or taken off, and why.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Change {
    pub points: f64,
    pub why: String,
}

impl Change {
    /// The change, in one line.
    pub fn in_words(&self) -> String {
        match self.points == 0.0 {
            true => self.why.clone(),
            false => {
                let sign = if self.points < 0.0 { "−" } else { "+" };
                format!("{sign}{}: {}", number(self.points.abs()), self.why)
            }
        }
    }
}

/// The points of a record, as the rules need them.
#[derive(Clone, Copy, Debug)]
pub struct JudgedPoints {
    pub points: f64,
    pub possible: f64,
    /// The part of the possible points that is extra credit.
    pub extra: f64,
}

impl JudgedPoints {
    /// The points of a record; `None` if it has no mark.
    pub fn of(record: &RecordSummary, extra: &[String]) -> Option<JudgedPoints> {
        let is_extra = |name: &str| extra.iter().any(|part| part == name);
        let tasks = record.tasks.iter().map(|it| &it.task);
        let tasks = tasks.filter(|task| is_extra(&task.name));
        let tasks: u32 = tasks.map(|task| task.possible).sum();
        let scenes = match is_extra("scenes") {
            true => record.scene_points.1,
            false => 0,
        };
        Some(JudgedPoints {
            points: record.points?.into(),
            possible: record.possible.into(),
            extra: (tasks + scenes).into(),
        })
    }
}

impl Mark {
    /// The mark if there is no policy.
    pub fn judged(judged: JudgedPoints) -> Mark {
        Mark {
            raw: judged.points,
            policy: judged.points,
            last: judged.points,
            possible: judged.possible - judged.extra,
            late_days: 0,
            changes: Vec::new(),
        }
    }

    /// Adds points. The mark doesn't go below 0.
    fn add(&mut self, points: f64, why: String) {
        let after = (self.last + points).max(0.0);
        let points = exact(after - self.last);
        self.last = exact(after);
        self.changes.push(Change { points, why });
    }
}

impl Policy {
    /// The mark of a person, or of a submission without a person.
    pub fn mark(&self, judged: JudgedPoints, lateness: &Lateness, id: Option<&str>) -> Mark {
        let mut mark = Mark::judged(judged);
        self.take_off_lateness(&mut mark, lateness, id);
        if let Some(at_most) = self.rules.extra_credit.as_ref().and_then(|it| it.at_most) {
            let most = mark.possible * at_most / 100.0;
            if mark.last > most {
                let why = format!(
                    "limited to {} percent of the points possible",
                    number(at_most)
                );
                mark.add(most - mark.last, why);
            }
        }
        mark.policy = mark.last;
        for by_hand in &self.rules.adjust {
            if Some(by_hand.id.as_str()) == id {
                mark.add(by_hand.points, by_hand.reason.clone());
            }
        }
        let rounded = self.rounded(mark.last);
        if rounded != mark.last {
            mark.add(rounded - mark.last, "rounded".into());
            mark.last = rounded;
        }
        mark
    }

    fn take_off_lateness(&self, mark: &mut Mark, lateness: &Lateness, id: Option<&str>) {
        let Lateness::Late { due, at } = lateness else {
            return;
        };
        let days = begun(due, at, LatenessUnit::Day);
        let when = at.strftime("handed in %Y-%m-%d %H:%M");
        let Some(late) = &self.rules.late else {
            return;
        };
        mark.late_days = id.map_or(0, |id| self.late_days_left(id)).min(days);
        let from = later(due, mark.late_days.into(), LatenessUnit::Day);
        let from = from.unwrap_or_else(|| due.clone());
        let (count, unit) = (begun(&from, at, late.per), late.per);
        if mark.late_days > 0 {
            let spent = counted(mark.late_days, LatenessUnit::Day);
            mark.add(
                0.0,
                format!("{when}: {spent} spent from the budget of late days"),
            );
        }
        if count == 0 {
            return;
        }
        let percent = (late.percent * f64::from(count)).min(late.at_most);
        let (base, of) = match late.of {
            PercentageBase::Possible => (mark.possible, "possible"),
            PercentageBase::Earned => (mark.last, "earned"),
        };
        let (late, percent_in_words) = (counted(count, unit), number(percent));
        let why = format!("{when}, {late} late: {percent_in_words} percent of the points {of}");
        mark.add(-base * percent / 100.0, why);
    }

    fn rounded(&self, points: f64) -> f64 {
        let Some(rounding) = &self.rules.rounding else {
            return points;
        };
        // Binary fractions may be slightly above or below the intended decimal number.
        const TOLERANCE: f64 = 1e-9;
        let steps = points / rounding.to;
        let steps = match rounding.direction {
            Direction::Nearest => (steps + 0.5 + TOLERANCE).floor(),
            Direction::Up => (steps - TOLERANCE).ceil(),
            Direction::Down => (steps + TOLERANCE).floor(),
        };
        exact(steps * rounding.to).max(0.0)
    }
}

/// Points rounded to a millionth, because smaller differences come from binary fractions.
fn exact(points: f64) -> f64 {
    (points * 1e6).round() / 1e6
}

/// A number as people write it: `77`, `76.5`.
pub fn number(points: f64) -> String {
    let text = format!("{:.4}", exact(points));
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}

fn counted(count: u32, unit: LatenessUnit) -> String {
    let unit = match unit {
        LatenessUnit::Hour => "hour",
        LatenessUnit::Day => "day",
    };
    let end = if count == 1 { "" } else { "s" };
    format!("{count} {unit}{end}")
}

#[cfg(test)]
mod tests;
