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

/// The book shows kernels whose numbers and data are `f64`, as in the assignment.
const NUMBERS: &str = "f64";

/// What the book reads of `study.json`. `tools/study/src/result.rs` says what the fields mean.
#[derive(Deserialize)]
struct Record {
    provenance: Provenance,
    families: Vec<Family>,
    trades: Vec<Trade>,
    tiers: Vec<Tier>,
    conditioning: Vec<Conditioned>,
    secondary: Vec<Secondary>,
    breaking: Vec<Breaking>,
    meshes: Vec<Mesh>,
    scenes: Vec<Scene>,
    plans: Vec<Plan>,
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
struct Trade {
    shape: String,
    class: String,
    kernel: String,
    numbers: String,
    asked: u64,
    wrong: u64,
    median_ulp: Option<f64>,
    instructions: Option<f64>,
}

#[derive(Deserialize)]
struct Tier {
    shape: String,
    class: String,
    tier: String,
    decided: u64,
    asked: u64,
    instructions: Option<f64>,
}

#[derive(Deserialize)]
struct Conditioned {
    shape: String,
    kernel: String,
    numbers: String,
    decade: i32,
    median_ulp: f64,
}

#[derive(Deserialize)]
struct Secondary {
    shape: String,
    method: String,
    offset: f64,
    leaving: u64,
    self_hits: u64,
    lost: u64,
}

#[derive(Deserialize)]
struct Breaking {
    shape: String,
    family: String,
    kernel: String,
    numbers: String,
    above: Option<i32>,
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
    instructions: Option<f64>,
    nanoseconds: Option<f64>,
    tests: Option<f64>,
}

#[derive(Deserialize)]
struct Plan {
    rays: u64,
    violations: u64,
    wrong_ids: u64,
}

/// Adds the record's numbers. Without a record there are none, and a page that uses one gets an
/// error.
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
        for trade in &self.trades {
            let Trade { class, shape, .. } = trade;
            let mut name = format!("{class}_{shape}_{}", word(&trade.kernel));
            if trade.numbers != NUMBERS {
                name = format!("{name}_{}", word(&trade.numbers));
            }
            add(format!("cost_{name}"), count(trade.instructions));
            add(format!("wrong_{name}"), share(trade.wrong, trade.asked));
            if let Some(ulp) = trade.median_ulp {
                add(format!("ulp_{name}"), ulps(ulp));
            }
        }
        for tier in &self.tiers {
            let name = format!("{}_{}_{}", tier.class, tier.shape, word(&tier.tier));
            add(format!("tier_{name}"), share(tier.decided, tier.asked));
            add(format!("tier_cost_{name}"), count(tier.instructions));
        }
        for it in self.conditioning.iter().filter(|it| it.numbers == NUMBERS) {
            let name = format!("{}_{}_1e{}", it.shape, word(&it.kernel), it.decade);
            add(format!("conditioned_{name}"), ulps(it.median_ulp));
        }
        for it in &self.secondary {
            let name = format!("{}_{}_{}", it.shape, word(&it.method), it.offset);
            add(format!("self_{name}"), share(it.self_hits, it.leaving));
            add(format!("lost_{name}"), share(it.lost, it.leaving));
        }
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
        }
        let (rays, broken) = self.plans.iter().fold((0, 0), |(rays, broken), plan| {
            (rays + plan.rays, broken + plan.violations + plan.wrong_ids)
        });
        add("plans_broken".into(), share(broken, rays));
        let exact = self.scenes.iter().filter(|film| film.model == "exact");
        let ratio = |exact: &Scene| {
            let is_plain = |film: &&Scene| {
                film.model == NUMBERS
                    && (&film.scene, &film.search) == (&exact.scene, &exact.search)
            };
            let plain = self.scenes.iter().find(is_plain)?;
            // By instructions, or by time if they were not counted.
            match (exact.instructions, plain.instructions) {
                (Some(exact), Some(plain)) => Some(exact / plain),
                _ => Some(exact.nanoseconds? / plain.nanoseconds?),
            }
        };
        let mut ratios: Vec<f64> = exact.filter_map(ratio).collect();
        ratios.sort_by(f64::total_cmp);
        if let Some(worst) = ratios.last() {
            add(
                "exact_ratio_median".into(),
                format!("{:.2}", ratios[ratios.len() / 2]),
            );
            add("exact_ratio_worst".into(), format!("{worst:.2}"));
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
            add("bunny_tests_brute".into(), count(brute.tests));
            add("bunny_tests_boxes".into(), count(boxes.tests));
            if let (Some(slow), Some(fast)) = (brute.nanoseconds, boxes.nanoseconds) {
                add("bunny_faster".into(), format!("{:.0}", slow / fast));
            }
        }
    }
}

impl Record {
    /// Whether the exponents of this family stand for ever smaller numbers, 10^−x.
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
        // As a percentage with two decimals, it would be 0.00 %.
        part if part == 0 || part * 10_000 < all => {
            format!("{} of {}", grouped(part), grouped(all))
        }
        _ => format!("{:.2} %", 100.0 * part as f64 / all as f64),
    }
}

/// A cost, or a dash if it was not counted.
fn count(number: Option<f64>) -> String {
    number.map_or("–".into(), |number| grouped(number.round() as u64))
}

/// A whole number with commas between its thousands.
pub fn grouped(number: u64) -> String {
    let digits = number.to_string();
    let mut text = String::new();
    for (place, digit) in digits.chars().enumerate() {
        if place > 0 && (digits.len() - place).is_multiple_of(3) {
            text.push(',');
        }
        text.push(digit);
    }
    text
}

/// An error in ulp, rounded to the digits that mean something.
fn ulps(error: f64) -> String {
    match error {
        1e8.. => decade(error.log10().round() as i32),
        1e4.. => {
            let unit = 10_f64.powf(error.log10().floor() - 1.0);
            grouped(((error / unit).round() * unit) as u64)
        }
        10.0.. => format!("{error:.0}"),
        _ => format!("{error:.1}"),
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
            [0.62, 44.4, 369_506.0, 4e9].map(ulps),
            ["0.6", "44", "370,000", "10¹⁰"]
        );
        assert_eq!(
            [share(0, 30), share(1, 8), share(1, 10_001)],
            ["0 of 30", "12.50 %", "1 of 10,001"]
        );
    }

    #[test]
    fn the_record_has_a_number_for_every_kernel_of_the_book() {
        let checkout = Checkout::find().expect("tests run in a checkout");
        let mut values = Values::new();
        add(&mut values, &checkout).expect("it can be read");
        for name in [
            "cost_everyday_sphere_textbook",
            "wrong_hard_triangle_adaptive_exact",
            "ulp_everyday_plane_shifted_origin_f64_on_f32",
            "tier_hard_triangle_exact",
            "self_sphere_pbrt_v4_1000",
            "breaks_sphere_distance_textbook",
            "leaks_moeller_trumbore_edge",
            "bunny_faster",
        ] {
            assert!(values.contains_key(&format!("study_{name}")), "{name}");
        }
    }
}
