//! `policy.toml`, as a lecturer writes it. Everything is optional.

use std::collections::{BTreeMap, BTreeSet};

use serde::{Deserialize, Serialize};

/// How judged points become final marks. Paths of files are relative to the folder of this file.
#[derive(Clone, Debug, Default, Deserialize, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields, default)]
pub struct Rules {
    /// The zone of all times without an offset, such as `Europe/Berlin`.
    pub time_zone: Option<String>,
    /// When the assignment was due: `2026-11-20 23:59`.
    pub deadline: Option<String>,
    /// How much later still counts as on time: `15 minutes`.
    pub grace: Option<String>,
    /// A CSV file that says when people handed in: `id,time`, Moodle's grading worksheet, or
    /// Gradescope's grades.
    pub times: Option<String>,
    /// A CSV file of people who hand in together: `id,group`.
    pub groups: Option<String>,
    /// Which of several submissions by one person counts.
    pub attempts: Attempts,
    /// What a late submission loses.
    pub late: Option<Late>,
    /// Days that people may be late without losing points.
    pub late_days: Option<LateDays>,
    /// Later deadlines for single people, by id.
    pub extensions: BTreeMap<String, String>,
    /// Tasks whose points are extra credit.
    pub extra_credit: Option<ExtraCredit>,
    /// How the final mark is rounded. If absent, it is not rounded.
    pub rounding: Option<Rounding>,
    /// Changes to single people's marks, made by hand.
    pub adjust: Vec<Adjustment>,
    /// What the gradebook calls the assignment. In Canvas, include the number: `Homework 1 (22)`.
    pub gradebook_column: Option<String>,
}

/// Which of several submissions counts.
#[derive(Clone, Copy, Debug, Default, Deserialize, Eq, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(rename_all = "lowercase")]
pub enum Attempts {
    /// The one handed in last.
    #[default]
    Last,
    /// The one with the best mark, after the deduction for lateness.
    Best,
}

/// What a late submission loses.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct Late {
    /// The percentage to take off for each hour or day that has begun since the deadline.
    pub percent: f64,
    /// An hour or a day.
    pub per: LatenessUnit,
    /// What the percentage is taken of.
    #[serde(default)]
    pub of: PercentageBase,
    /// Never take off more than this many percent.
    #[serde(default = "everything")]
    pub at_most: f64,
}

fn everything() -> f64 {
    100.0
}

/// A unit of lateness.
#[derive(Clone, Copy, Debug, Deserialize, Eq, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(rename_all = "lowercase")]
pub enum LatenessUnit {
    /// 60 minutes.
    Hour,
    /// A calendar day. It ends at the same time tomorrow, even if clocks change in between.
    Day,
}

/// What a percentage is taken of.
#[derive(Clone, Copy, Debug, Default, Deserialize, Eq, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(rename_all = "lowercase")]
pub enum PercentageBase {
    /// Of all possible points, as in Canvas.
    #[default]
    Possible,
    /// Of the points earned.
    Earned,
}

/// Days that people may be late without losing points, over several assignments.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct LateDays {
    /// How many of these days each person has.
    pub budget: u32,
    /// The `grades.csv` files of earlier assignments, which say how many days have been spent. A
    /// file that is named twice counts once.
    #[serde(default)]
    pub spent: BTreeSet<String>,
}

/// Tasks whose points are extra credit, on top of the possible points.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct ExtraCredit {
    /// Names of tasks, or `scenes`.
    pub parts: Vec<String>,
    /// The mark never exceeds this many percent of the possible points.
    #[serde(default)]
    pub at_most: Option<f64>,
}

/// How a final mark is rounded.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct Rounding {
    /// To multiples of this: 1, 0.5, 0.1.
    pub to: f64,
    /// In which direction.
    #[serde(default)]
    pub direction: Direction,
}

/// In which direction a mark is rounded.
#[derive(Clone, Copy, Debug, Default, Deserialize, Eq, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(rename_all = "lowercase")]
pub enum Direction {
    /// To the nearest multiple; a half goes up.
    #[default]
    Nearest,
    /// In the student's favour.
    Up,
    /// Never above what was earned.
    Down,
}

/// A change made by hand.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct Adjustment {
    /// The id of the person whose mark changes.
    pub id: String,
    /// Points to add, or, if negative, to take off.
    pub points: f64,
    /// The reason, which the student reads.
    pub reason: String,
}

impl Rules {
    /// Checks what TOML's types can't: that the rules make sense.
    pub fn check(&self) -> Result<(), String> {
        let percent = |what: &str, percent: f64| match (0.0..=100.0).contains(&percent) {
            true => Ok(()),
            false => Err(format!(
                "{what} is {percent}, which is not between 0 and 100"
            )),
        };
        if let Some(late) = &self.late {
            percent("late.percent", late.percent)?;
            percent("late.at_most", late.at_most)?;
        }
        let needs = [
            ("late", self.late.is_some()),
            ("late_days", self.late_days.is_some()),
            ("grace", self.grace.is_some()),
        ];
        for (what, _) in needs.iter().filter(|(_, is_there)| *is_there) {
            if self.deadline.is_none() {
                return Err(format!("it has `{what}`, but no `deadline`"));
            }
        }
        if (self.deadline.is_some() || !self.extensions.is_empty()) && self.time_zone.is_none() {
            return Err(
                "a deadline needs `time_zone`, such as Europe/Berlin, because the times in the \
                 names of submissions are local times"
                    .into(),
            );
        }
        if self.late_days.is_some() && self.late.is_none() {
            return Err(
                "it has `late_days`, but no `late`, so late days would have no effect".into(),
            );
        }
        if let Some(rounding) = &self.rounding
            && !(0.001..=1000.0).contains(&rounding.to)
        {
            return Err(format!(
                "rounding.to is {:?}, which is not between 0.001 and 1000",
                rounding.to
            ));
        }
        if let Some(at_most) = self.extra_credit.as_ref().and_then(|it| it.at_most)
            && !(at_most >= 0.0 && at_most.is_finite())
        {
            return Err(format!(
                "extra_credit.at_most is {at_most}, which is not a finite number of at least 0"
            ));
        }
        for by_hand in &self.adjust {
            if !by_hand.points.is_finite() || by_hand.reason.trim().is_empty() {
                return Err(format!(
                    "the adjustment for {} needs a number of points and a reason",
                    by_hand.id
                ));
            }
        }
        if let Some(grace) = &self.grace {
            super::times::grace(grace)?;
        }
        Ok(())
    }
}

#[cfg(test)]
#[test]
fn the_committed_schema_of_policies_is_that_of_the_type() {
    use schemars::generate::SchemaSettings;
    let generator = SchemaSettings::draft2020_12().into_generator();
    let schema = generator.into_root_schema_for::<Rules>();
    let text = serde_json::to_string_pretty(&schema).expect("it can be written") + "\n";
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../schema/policy.schema.json");
    if std::env::var_os("UPDATE_SCHEMAS").is_some() {
        std::fs::write(path, &text).expect("it can be written");
    }
    let committed = std::fs::read_to_string(path).unwrap_or_default();
    let again = "UPDATE_SCHEMAS=1 cargo test -p pinhole-instructor schema";
    assert_eq!(committed, text, "if this is meant, run: {again}");
}

#[cfg(test)]
#[test]
fn the_example_in_the_book_is_a_policy_and_has_every_key() {
    let page = include_str!("../../../../../book/src/instructor/policies_and_gradebooks.md");
    let mut blocks = page.split("```");
    let example = blocks.find_map(|block| block.strip_prefix("toml\n"));
    let example = example.expect("the page has an example");
    let rules: Rules = toml::from_str(example).expect("it is a policy");
    rules.check().expect("it makes sense");
    let generator = schemars::SchemaGenerator::default();
    let schema = generator.into_root_schema_for::<Rules>();
    let keys = schema.get("properties").and_then(|keys| keys.as_object());
    let written: toml::Table = toml::from_str(example).expect("it is a table");
    for key in keys.expect("a policy has keys").keys() {
        assert!(written.contains_key(key), "the example lacks {key}");
    }
}
