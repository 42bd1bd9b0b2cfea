//! The study's record, `tools/study/record`, as the book quotes it: its numbers by name,
//! and its plots. Nobody copies a number from it, so that a new record changes the book.

use std::collections::BTreeMap;
use std::fs;

use pinhole_course::checkout::Checkout;
use serde::Deserialize;

use crate::error::{Error, Problem, Result};

/// What is shown, by name.
pub type Values = BTreeMap<String, String>;

/// Where the record lies.
const RECORD: &str = "tools/study/record";

/// What the book tells of kernels: whose numbers and data are `f64`, as the assignment's.
const NUMBERS: &str = "f64";

/// What the book reads of `study.json`; its schema says what the fields mean.
#[derive(Deserialize)]
struct Record {
    provenance: Provenance,
    families: Vec<Family>,
    speed: Vec<Speed>,
    breaking: Vec<Breaking>,
    meshes: Vec<Mesh>,
    scenes: Vec<Scene>,
}

#[derive(Deserialize)]
struct Provenance {
    machine: String,
    date: String,
    command: String,
}

#[derive(Deserialize)]
struct Family {
    shape: String,
    family: String,
    axis: String,
}

#[derive(Deserialize)]
struct Speed {
    shape: String,
    kernel: String,
    numbers: String,
    ratio: f64,
}

#[derive(Deserialize)]
struct Breaking {
    shape: String,
    family: String,
    kernel: String,
    numbers: String,
    above: Option<i32>,
    wrong: u64,
    asked: u64,
}

#[derive(Deserialize)]
struct Mesh {
    kernel: String,
    numbers: String,
    aimed_at: String,
    rays: u64,
    leaks: u64,
    double_hits: u64,
}

#[derive(Deserialize)]
struct Scene {
    scene: String,
    model: String,
    search: Option<String>,
    rays: u64,
    wrong_ids: u64,
    nanoseconds: Option<f64>,
    tests: Option<f64>,
}

/// Adds the record's numbers; without a record there are none, and a page that wants one
/// is told so.
pub fn add(values: &mut Values, checkout: &Checkout) -> Result<()> {
    let file = format!("{RECORD}/study.json");
    if !checkout.root().join(&file).is_file() {
        return Ok(());
    }
    let record: Record = serde_json::from_str(&checkout.read(&file)?).map_err(|error| {
        let remedy = "make it again: cargo pinhole study --out tools/study/record";
        Problem::of(&file, error.to_string(), remedy)
    })?;
    record.add(values);
    Ok(())
}

/// A plot of the record, by its name there.
pub fn plot(name: &str, checkout: &Checkout) -> Result<Vec<u8>> {
    let file = checkout.root().join(RECORD).join(name);
    fs::read(&file).map_err(|error| Error::file(&file, &error))
}

impl Record {
    fn add(&self, values: &mut Values) {
        let mut add = |name: String, text: String| values.insert(format!("study_{name}"), text);
        let Provenance {
            machine,
            date,
            command,
        } = &self.provenance;
        add("machine".into(), machine.clone());
        add("date".into(), date.clone());
        add("command".into(), command.clone());
        for speed in self.speed.iter().filter(|speed| speed.numbers == NUMBERS) {
            let name = format!("cost_{}_{}", speed.shape, word(&speed.kernel));
            add(name, format!("{:.2}", speed.ratio));
        }
        let mut decisions: BTreeMap<(&str, &str), (u64, u64)> = BTreeMap::new();
        for it in self.breaking.iter().filter(|it| it.numbers == NUMBERS) {
            let name = format!(
                "breaks_{}_{}_{}",
                it.shape,
                word(&it.family),
                word(&it.kernel)
            );
            let sign = if self.shrinks(it) { -1 } else { 1 };
            let breaks = it.above.map(|exponent| decade(sign * exponent));
            add(name, breaks.unwrap_or("never".into()));
            let (wrong, asked) = decisions.entry((&it.shape, &it.kernel)).or_default();
            *wrong += it.wrong;
            *asked += it.asked;
        }
        for ((shape, kernel), (wrong, asked)) in decisions {
            add(
                format!("wrong_{shape}_{}", word(kernel)),
                share(wrong, asked),
            );
        }
        for mesh in self.meshes.iter().filter(|mesh| mesh.numbers == NUMBERS) {
            let name = format!("{}_{}", word(&mesh.kernel), mesh.aimed_at);
            add(format!("leaks_{name}"), share(mesh.leaks, mesh.rays));
            add(
                format!("doubles_{name}"),
                share(mesh.double_hits, mesh.rays),
            );
        }
        let films = |model: &str| -> (u64, u64) {
            let all = self.scenes.iter().filter(|film| film.model == model);
            all.fold((0, 0), |(wrong, rays), film| {
                (wrong + film.wrong_ids, rays + film.rays)
            })
        };
        for model in ["f64", "exact"] {
            let (wrong, rays) = films(model);
            add(format!("scenes_{model}"), share(wrong, rays));
        }
        let bunny = |search: &str| {
            self.scenes.iter().find(|film| {
                (film.scene.as_str(), film.model.as_str()) == ("bunny", NUMBERS)
                    && film.search.as_deref() == Some(search)
            })
        };
        if let (Some(brute), Some(boxes)) = (bunny("brute force"), bunny("boxes")) {
            let count =
                |tests: Option<f64>| tests.map_or("?".into(), |tests| format!("{tests:.0}"));
            add("bunny_tests_brute".into(), count(brute.tests));
            add("bunny_tests_boxes".into(), count(boxes.tests));
            if let (Some(slow), Some(fast)) = (brute.nanoseconds, boxes.nanoseconds) {
                add("bunny_faster".into(), format!("{:.0}", slow / fast));
            }
        }
    }
}

impl Record {
    /// Whether what is pushed gets smaller from question to question.
    fn shrinks(&self, it: &Breaking) -> bool {
        let mut families = self.families.iter();
        let own = families.find(|own| (&own.shape, &own.family) == (&it.shape, &it.family));
        own.is_some_and(|own| own.axis.contains("10^−x"))
    }
}

/// A name as a part of a value's name.
fn word(name: &str) -> String {
    let name = name.to_lowercase().replace('ö', "oe");
    let parts = name.split(|c: char| !c.is_ascii_alphanumeric());
    let parts: Vec<&str> = parts.filter(|part| !part.is_empty()).collect();
    parts.join("_")
}

fn share(part: u64, all: u64) -> String {
    match part {
        0 => format!("0 of {all}"),
        _ => format!("{:.2} %", 100.0 * part as f64 / all as f64),
    }
}

/// A power of ten.
fn decade(exponent: i32) -> String {
    let digit = |c: char| match c.to_digit(10) {
        Some(digit) => "⁰¹²³⁴⁵⁶⁷⁸⁹".chars().nth(digit as usize).unwrap_or(c),
        None => '⁻',
    };
    let exponent: String = exponent.to_string().chars().map(digit).collect();
    format!("10{exponent}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_and_numbers_are_as_pages_write_them() {
        assert_eq!(word("Möller–Trumbore"), "moeller_trumbore");
        assert_eq!(word("M–T with epsilon"), "m_t_with_epsilon");
        assert_eq!(decade(-17), "10⁻¹⁷");
        assert_eq!(
            (share(0, 30), share(1, 8)),
            ("0 of 30".into(), "12.50 %".into())
        );
    }

    #[test]
    fn the_record_has_a_number_for_every_kernel_of_the_book() {
        let checkout = Checkout::find().expect("tests run in a checkout");
        let mut values = Values::new();
        add(&mut values, &checkout).expect("it can be read");
        for name in [
            "cost_sphere_textbook",
            "wrong_triangle_adaptive_exact",
            "breaks_sphere_distance_textbook",
            "leaks_moeller_trumbore_edge",
            "bunny_faster",
        ] {
            assert!(values.contains_key(&format!("study_{name}")), "{name}");
        }
    }
}
