//! Puts measurements into sentences.

use pinhole::part::{Part, Quantity};
use pinhole::words::number;

use super::law::{AxisLaw, Law, PartLaw};
use super::rule::{Literal, Rule, WhichAnswer, conditions};
use super::sample::Sample;

/// Significant digits of a measured number.
pub const DIGITS: usize = 4;

/// A part's law, as it follows the part's name: "is divided by |d|". Several parts can only have
/// the values of another answer.
pub fn law(law: &PartLaw, part: usize, sample: &Sample, several: bool) -> String {
    if let (PartLaw::Whole(Law::Other(k)), true) = (law, several) {
        let name = sample.others[*k].0;
        return match name.strip_prefix("that of ") {
            Some(rest) => format!("are those of {rest}"),
            None => format!("are {name}"),
        };
    }
    let described = sample.right.as_ref().map(|parts| &parts[part]);
    let (unit, axes) = described.map_or(("", &[][..]), |part| (part.unit, part.axes));
    let is_object = described.is_some_and(Part::is_object);
    match law {
        // "The object is the last one", but "t is that of the last one".
        PartLaw::Whole(Law::Other(k)) if is_object => {
            let name = sample.others[*k].0;
            format!("is {}", name.strip_prefix("that of ").unwrap_or(name))
        }
        PartLaw::Whole(law) => one(*law, sample, unit, axes),
        PartLaw::Length(Law::Always(length)) => format!("has length {}", number(*length, DIGITS)),
        PartLaw::Length(Law::Quantity(by, k)) => {
            format!(
                "is as long as {}",
                times(*by, sample.quantities[*k].name, 1)
            )
        }
        PartLaw::Length(law) => format!("has a length that {}", one(*law, sample, unit, axes)),
        PartLaw::Axes(laws) => {
            let follows = laws.iter().zip(axes).filter_map(|(law, axis)| match law {
                AxisLaw::Follows(law) => {
                    Some(format!("along {axis} {}", one(*law, sample, unit, axes)))
                }
                _ => None,
            });
            let along = |known: AxisLaw| {
                let which = laws.iter().zip(axes).filter(|(law, _)| **law == known);
                list(which.map(|(_, axis)| (*axis).to_owned()).collect())
            };
            let told = list(follows.collect());
            let (right, unknown) = (along(AxisLaw::Right), along(AxisLaw::Unknown));
            match (right.is_empty(), unknown.is_empty()) {
                (true, true) => told,
                (false, true) => format!("{told}, and is right along {right}"),
                (true, false) => format!("{told}, and is also wrong along {unknown}"),
                (false, false) => {
                    format!("{told}, is right along {right}, and is also wrong along {unknown}")
                }
            }
        }
    }
}

fn one(law: Law, sample: &Sample, unit: &str, axes: &[&str]) -> String {
    let name = |k: usize| sample.quantities[k].name;
    let measured = |by: f64, what: String| match by < 0.0 {
        true => format!("is too small by {what}"),
        false => format!("is too large by {what}"),
    };
    match law {
        Law::Times(-1.0) => "has the opposite sign".into(),
        Law::Times(0.0) => "is 0".into(),
        Law::Times(by) => format!("is {} times what it should be", number(by, DIGITS)),
        Law::TimesQuantity(by, k, power) if power < 0 => {
            let factor = times(1.0, name(k), -power);
            let multiplied = match by == 1.0 {
                true => String::new(),
                false => format!("multiplied by {} and ", number(by, DIGITS)),
            };
            format!("is {multiplied}divided by {factor}")
        }
        Law::TimesQuantity(by, k, power) => {
            format!("is multiplied by {}", times(by, name(k), power))
        }
        Law::Plus(by) => measured(by, counted(by, unit)),
        Law::PlusQuantity(by, k, power) if power < 0 => {
            let below = times(1.0, name(k), -power);
            measured(
                by,
                format!("{} / ({below}){unit}", number(by.abs(), DIGITS)),
            )
        }
        Law::PlusQuantity(by, k, power) => {
            measured(by, format!("{}{unit}", times(by.abs(), name(k), power)))
        }
        Law::Always(it) => format!("is always {}{unit}", number(it, DIGITS)),
        Law::Quantity(by, k) => format!("is {}{unit}", times(by, name(k), 1)),
        Law::Affine(more, by, factor) => {
            let shifted = measured(more, counted(more, unit));
            let stretched = match factor {
                Some((k, power)) => one(Law::TimesQuantity(by, k, power), sample, unit, axes),
                None => format!("multiplied by {}", number(by, DIGITS)),
            };
            format!("{shifted} and then {}", stretched.trim_start_matches("is "))
        }
        Law::PlusBoth(more, by, k) => {
            let quantity = times(by.abs(), name(k), 1);
            let constant = measured(more, counted(more, unit));
            let sign = if by < 0.0 { "small" } else { "large" };
            format!("{constant} and too {sign} by {quantity}{unit}")
        }
        Law::Other(k) => format!("is {}", sample.others[k].0),
        Law::Axis(by, axis) => {
            let axis = axes[axis];
            match by {
                1.0 => format!("is what it should be along {axis}"),
                -1.0 => format!("is minus what it should be along {axis}"),
                by => format!(
                    "is {} times what it should be along {axis}",
                    number(by, DIGITS)
                ),
            }
        }
    }
}

/// "1 pixel", "0.5 pixels".
fn counted(by: f64, unit: &str) -> String {
    let unit = match by.abs() == 1.0 {
        true => unit.trim_end_matches('s'),
        false => unit,
    };
    format!("{}{unit}", number(by.abs(), DIGITS))
}

/// "2 · |d|²".
fn times(by: f64, name: &str, power: i32) -> String {
    let name = match power {
        1 => name.to_owned(),
        _ if name.contains(' ') => format!("({name})²"),
        _ => format!("{name}²"),
    };
    match by {
        1.0 => name,
        -1.0 if name.starts_with("the ") => format!("minus {name}"),
        -1.0 => format!("−{name}"),
        by => format!("{} · {name}", number(by, DIGITS)),
    }
}

/// A rule, as it follows "where".
pub fn rule(rule: &Rule, sample: &Sample) -> String {
    let literals = rule.literals.iter().map(|it| literal(it, sample));
    list(literals.collect())
}

/// A statement, as it follows "where".
pub fn literal(literal: &Literal, sample: &Sample) -> String {
    match literal {
        Literal::Holds(of, k, so) => {
            let condition = conditions(sample, *of)[*k];
            let name = match so {
                true => condition.name,
                false => condition.otherwise,
            };
            match (of, name.strip_prefix("t ")) {
                (WhichAnswer::Given, Some(rest)) => format!("your t {rest}"),
                _ => name.to_owned(),
            }
        }
        Literal::Below(k, bound) => bounded(sample.quantities[*k], "less", *bound),
        Literal::Above(k, bound) => bounded(sample.quantities[*k], "more", *bound),
    }
}

fn bounded(quantity: Quantity, than: &str, bound: f64) -> String {
    let name = quantity.name;
    match quantity.is_count {
        true if than == "more" => format!("{name} is {} or more", bound.ceil()),
        true => format!("{name} is {} or less", bound.floor()),
        false if bound == 0.0 && than == "less" => format!("{name} is negative"),
        false if bound == 0.0 => format!("{name} is positive"),
        false if bound == f64::EPSILON => format!("{name} is {than} than `f64::EPSILON`"),
        false if bound == f64::from(f32::EPSILON) => {
            format!("{name} is {than} than `f32::EPSILON`")
        }
        false => format!("{name} is {than} than {}", number(bound, DIGITS)),
    }
}

/// "a, b and c".
pub fn list(words: Vec<String>) -> String {
    match words.as_slice() {
        [] => String::new(),
        [one] => one.clone(),
        [first @ .., last] => format!("{} and {last}", first.join(", ")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_bound_of_zero_is_told_as_a_sign() {
        let discriminant = Quantity {
            name: "the discriminant",
            value: 1.0,
            is_count: false,
        };
        let negative = "the discriminant is negative";
        assert_eq!(bounded(discriminant, "less", 0.0), negative);
        let positive = "the discriminant is positive";
        assert_eq!(bounded(discriminant, "more", 0.0), positive);
    }
}
