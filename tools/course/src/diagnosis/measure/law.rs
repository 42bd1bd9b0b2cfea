//! Simple laws by which a part of an answer can be wrong.

use super::sample::{SAME, Sample};

/// How the wrong value of a part follows from the right one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Law {
    /// The right value times a constant.
    Times(f64),
    /// The right value times a constant and a power of a quantity of the question.
    TimesQuantity(f64, usize, i32),
    /// The right value plus a constant.
    Plus(f64),
    /// The right value plus a constant times a power of a quantity.
    PlusQuantity(f64, usize, i32),
    /// A constant, independent of the right value.
    Always(f64),
    /// A constant times a quantity.
    Quantity(f64, usize),
    /// The value of one of the question's other answers.
    Other(usize),
    /// Another axis of the right value times a constant.
    Axis(f64, usize),
    /// The right value plus the first constant, times the second and a power of a
    /// quantity.
    Affine(f64, f64, Option<(usize, i32)>),
    /// The right value plus the first constant, plus the second times a quantity.
    PlusBoth(f64, f64, usize),
}

/// Which values of a part follow a law.
#[derive(Clone, Debug, PartialEq)]
pub enum PartLaw {
    /// All axes follow the same law.
    Whole(Law),
    /// Each axis is right or wrong in its own way.
    Axes(Vec<AxisLaw>),
    /// Only the length follows a law.
    Length(Law),
}

/// What is known of one axis of a part.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum AxisLaw {
    /// It is right.
    Right,
    /// It follows a law.
    Follows(Law),
    /// It is wrong, and no law for it is known.
    Unknown,
}

/// How a sample compares with a law.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Fit {
    /// It has the law's value, which is wrong.
    Follows,
    /// It does not have the law's value.
    Breaks,
    /// The law's value is too close to the right one to tell them apart.
    Mute,
}

/// Powers of quantities that are tried.
const POWERS: [i32; 4] = [1, -1, 2, -2];

/// How many samples are tried for a law's constant.
const ASKED: usize = 5;

/// A constant this close to a simple number is replaced by it.
const SIMPLE: [f64; 13] = [
    1.0, -1.0, 2.0, -2.0, 0.5, -0.5, 3.0, 4.0, 0.25, -0.25, 0.0, 1.5, -1.5,
];

/// One value of a sample: a part's axis, or a part's length.
#[derive(Clone, Copy)]
pub enum Place {
    Axis(usize),
    Length,
}

impl Place {
    fn of(self, values: &[f64]) -> f64 {
        match self {
            Place::Axis(axis) => values[axis],
            Place::Length => values.iter().map(|x| x * x).sum::<f64>().sqrt(),
        }
    }
}

impl Law {
    /// Whether it makes sense for ids, which are names, and not only for measured values.
    fn is_counting(self) -> bool {
        matches!(self, Law::Plus(_) | Law::Other(_) | Law::Always(_))
    }

    /// The value that the law predicts, and the factor by which it stretches the right one.
    fn says(self, sample: &Sample, part: usize, place: Place) -> Option<(f64, f64)> {
        let right = &sample.right.as_ref()?.get(part)?.values;
        let value = place.of(right);
        let quantity = |k: usize, power: i32| sample.quantities[k].value.powi(power);
        Some(match self {
            Law::Times(by) => (by * value, by),
            Law::TimesQuantity(by, k, power) => {
                let by = by * quantity(k, power);
                (by * value, by)
            }
            Law::Plus(by) => (value + by, 1.0),
            Law::PlusQuantity(by, k, power) => (value + by * quantity(k, power), 1.0),
            Law::Always(it) => (it, 0.0),
            Law::Quantity(by, k) => (by * quantity(k, 1), 0.0),
            Law::Other(k) => {
                let other = sample.others.get(k)?.1.as_ref()?;
                (place.of(&other.get(part)?.values), 2.0)
            }
            Law::Axis(by, axis) => (by * right.get(axis)?, by),
            Law::Affine(more, by, factor) => {
                let by = by * factor.map_or(1.0, |(k, power)| quantity(k, power));
                (by * (value + more), by)
            }
            Law::PlusBoth(more, by, k) => (value + more + by * quantity(k, 1), 1.0),
        })
    }

    /// This law, with the constant that fits this sample.
    fn fitted(self, sample: &Sample, part: usize, place: Place) -> Option<Law> {
        let (right, given) = sample.both(part)?;
        let (value, given) = (place.of(right), place.of(given));
        let quantity = |k: usize, power: i32| sample.quantities[k].value.powi(power);
        // A value that may be 0 has no meaningful ratio to another.
        let is_zero = |value: f64| value.abs() <= sample.allowed(part, 0.0, 1.0);
        let base = match self {
            Law::Times(_) | Law::TimesQuantity(..) => value,
            Law::Axis(_, axis) => right[axis],
            _ => f64::INFINITY,
        };
        if is_zero(base) {
            return None;
        }
        let by = match self {
            Law::Times(_) => given / value,
            Law::TimesQuantity(_, k, power) => given / (value * quantity(k, power)),
            Law::Plus(_) => given - value,
            Law::PlusQuantity(_, k, power) => (given - value) / quantity(k, power),
            Law::Always(_) => given,
            Law::Quantity(_, k) => given / quantity(k, 1),
            Law::Other(_) => 0.0,
            Law::Axis(_, axis) => given / right[axis],
            Law::Affine(..) | Law::PlusBoth(..) => return None,
        };
        let by = simple(by)?;
        Some(match self {
            Law::Times(_) => Law::Times(by),
            Law::TimesQuantity(_, k, power) => Law::TimesQuantity(by, k, power),
            Law::Plus(_) => Law::Plus(by),
            Law::PlusQuantity(_, k, power) => Law::PlusQuantity(by, k, power),
            Law::Always(_) => Law::Always(by),
            Law::Quantity(_, k) => Law::Quantity(by, k),
            Law::Other(k) => Law::Other(k),
            Law::Axis(_, axis) => Law::Axis(by, axis),
            Law::Affine(..) | Law::PlusBoth(..) => return None,
        })
    }

    /// This law, with the two constants that fit these samples.
    fn fitted_to_both(self, both: [&Sample; 2], part: usize, place: Place) -> Option<Law> {
        let values = |sample: &Sample| -> Option<(f64, f64)> {
            let (right, given) = sample.both(part)?;
            let (value, given) = (place.of(right), place.of(given));
            Some(match self {
                Law::PlusBoth(_, _, k) => (sample.quantities[k].value, given - value),
                Law::Affine(_, _, Some((k, power))) => {
                    (value, given / sample.quantities[k].value.powi(power))
                }
                _ => (value, given),
            })
        };
        let [(x_1, y_1), (x_2, y_2)] = [values(both[0])?, values(both[1])?];
        let slope = simple((y_2 - y_1) / (x_2 - x_1))?;
        match self {
            Law::PlusBoth(_, _, k) => Some(Law::PlusBoth(simple(y_1 - slope * x_1)?, slope, k)),
            Law::Affine(_, _, factor) => {
                Some(Law::Affine(simple(y_1 / slope - x_1)?, slope, factor))
            }
            _ => None,
        }
    }

    /// How one value of a sample compares with it.
    fn stand(self, sample: &Sample, part: usize, place: Place) -> Fit {
        // A part that only has a limit has no right value that a wrong one could follow from.
        let is_limited = sample.is_limited(part);
        let is_own = matches!(self, Law::Quantity(1.0, _) | Law::Other(_) | Law::Always(_));
        if is_limited && !is_own {
            return Fit::Breaks;
        }
        let told = self.says(sample, part, place).zip(sample.both(part));
        let Some(((says, stretch), (right, given))) = told else {
            return Fit::Breaks;
        };
        let size = Place::Length.of(given);
        let size = if size.is_finite() { size } else { 0.0 };
        let size = says.abs().max(size);
        // The tolerance of a limit is the limit, and not how far a value may be from a law.
        let allowed = match is_limited {
            true => SAME * size,
            false => sample.allowed(part, size, stretch),
        };
        // Written this way so that NaN breaks the law.
        let is_said = (place.of(given) - says).abs() <= allowed;
        if !is_said {
            return Fit::Breaks;
        }
        match (says - place.of(right)).abs() > 2.0 * allowed {
            true => Fit::Follows,
            false => Fit::Mute,
        }
    }
}

/// The nearest simple number if there is one close by, or the number itself; `None` if it is not
/// finite.
fn simple(number: f64) -> Option<f64> {
    let near = |simple: &&f64| (number - **simple).abs() <= 2e-4 * simple.abs().max(0.05);
    let simple = SIMPLE.iter().find(near).copied().unwrap_or(number);
    simple.is_finite().then_some(simple)
}

impl PartLaw {
    /// Whether it determines all values of the part.
    pub fn is_complete(&self) -> bool {
        match self {
            PartLaw::Whole(_) => true,
            PartLaw::Axes(laws) => !laws.contains(&AxisLaw::Unknown),
            PartLaw::Length(_) => false,
        }
    }

    /// How a sample compares with it.
    pub fn stand(&self, sample: &Sample, part: usize) -> Fit {
        match self {
            PartLaw::Length(law) => law.stand(sample, part, Place::Length),
            PartLaw::Whole(law) => {
                let axes = sample.both(part).map_or(0, |(right, _)| right.len());
                all((0..axes).map(|axis| law.stand(sample, part, Place::Axis(axis))))
            }
            PartLaw::Axes(laws) => all(laws.iter().enumerate().map(|(axis, law)| match law {
                AxisLaw::Follows(law) => law.stand(sample, part, Place::Axis(axis)),
                AxisLaw::Right => match Law::Times(1.0).stand(sample, part, Place::Axis(axis)) {
                    Fit::Breaks => Fit::Breaks,
                    _ => Fit::Mute,
                },
                AxisLaw::Unknown => Fit::Mute,
            })),
        }
    }
}

fn all(stands: impl Iterator<Item = Fit>) -> Fit {
    let mut sum = Fit::Mute;
    for stand in stands {
        match stand {
            Fit::Breaks => return Fit::Breaks,
            Fit::Follows => sum = Fit::Follows,
            Fit::Mute => {}
        }
    }
    sum
}

/// How many samples follow a law, and how many break it.
pub fn tally<'a>(
    law: &PartLaw,
    part: usize,
    samples: impl Iterator<Item = &'a Sample>,
) -> (usize, usize) {
    samples.fold((0, 0), |(follow, broken), sample| {
        match law.stand(sample, part) {
            Fit::Follows => (follow + 1, broken),
            Fit::Breaks => (follow, broken + 1),
            Fit::Mute => (follow, broken),
        }
    })
}

/// The law that most of these samples follow, all of which are wrong in this part. Simple laws are
/// tried first, and a complicated one wins only if clearly more samples follow it.
pub fn best(samples: &[&Sample], part: usize) -> Option<PartLaw> {
    let (right, _) = samples.first()?.both(part)?;
    let axes = right.len();
    let mut best: Option<(usize, PartLaw)> = None;
    let mut offer = |law: PartLaw| {
        let least = best.as_ref().map_or(0, |(most, _)| most + most / 20);
        let mut follow = 0;
        for (seen, sample) in samples.iter().enumerate() {
            // Most laws fail early, so there is no need to compare them with every sample.
            if follow + (samples.len() - seen) <= least {
                return;
            }
            follow += usize::from(law.stand(sample, part) == Fit::Follows);
        }
        if follow > least {
            best = Some((follow, law));
        }
    };
    let quantities = samples[0].quantities.len();
    let others = samples.iter().map(|sample| sample.others.len()).max()?;
    let asked = || {
        samples
            .iter()
            .step_by(samples.len().div_ceil(ASKED))
            .copied()
    };
    let object = samples[0].is_object(part);
    for law in whole(quantities, others)
        .into_iter()
        .filter(|law| !object || law.is_counting())
    {
        for sample in asked() {
            // The largest axis gives the most precise constant.
            let (right, _) = sample.both(part)?;
            let largest = (0..axes).max_by(|a, b| right[*a].abs().total_cmp(&right[*b].abs()));
            let place = Place::Axis(largest.unwrap_or(0));
            let alone = axes == 1 || !matches!(law, Law::Plus(_) | Law::PlusQuantity(..));
            if let Some(law) = law.fitted(sample, part, place).filter(|_| alone) {
                offer(PartLaw::Whole(law));
            }
            if matches!(law, Law::Other(_)) {
                break;
            }
        }
    }
    if axes > 1 {
        let laws = by_axes(samples, part, axes, quantities);
        if !laws.contains(&AxisLaw::Unknown) {
            offer(PartLaw::Axes(laws.clone()));
        }
        for law in whole(quantities, 0) {
            for sample in asked() {
                if let Some(law) = law.fitted(sample, part, Place::Length) {
                    offer(PartLaw::Length(law));
                }
            }
        }
        // An axis of unknown law fits everything, so it must not compete.
        let follows = |law: &AxisLaw| matches!(law, AxisLaw::Follows(_));
        let most = best.as_ref().map_or(0, |(most, _)| *most);
        if 2 * most < samples.len() && laws.iter().any(follows) {
            return Some(PartLaw::Axes(laws));
        }
    }
    best.map(|(_, law)| law)
}

/// The law of each axis.
fn by_axes(samples: &[&Sample], part: usize, axes: usize, quantities: usize) -> Vec<AxisLaw> {
    let of_axis = |axis: usize| {
        let place = Place::Axis(axis);
        let fits = |law: Law| {
            let stands = samples.iter().map(|sample| law.stand(sample, part, place));
            let mut broken = stands.filter(|stand| *stand == Fit::Breaks);
            broken.nth(samples.len() / 20).is_none()
        };
        if fits(Law::Times(1.0)) {
            return Some(AxisLaw::Right);
        }
        let crossed = (0..axes)
            .filter(|other| *other != axis)
            .map(|other| Law::Axis(1.0, other));
        let single = whole(quantities, 0).into_iter().chain(crossed);
        let first = *samples.first()?;
        let mut fitted = single.filter_map(|law| law.fitted(first, part, place));
        if let Some(law) = fitted.find(|law| fits(*law)) {
            return Some(AxisLaw::Follows(law));
        }
        let pairs = samples[1..].iter().step_by(samples.len().div_ceil(ASKED));
        let mut fitted = pairs.flat_map(|other| {
            let both = [first, *other];
            let laws = with_two_constants(quantities).into_iter();
            laws.filter_map(move |law| law.fitted_to_both(both, part, place))
        });
        fitted.find(|law| fits(*law)).map(AxisLaw::Follows)
    };
    (0..axes)
        .map(|axis| of_axis(axis).unwrap_or(AxisLaw::Unknown))
        .collect()
}

/// Laws with two constants, which need two samples.
fn with_two_constants(quantities: usize) -> Vec<Law> {
    let mut laws = vec![Law::Affine(0.0, 1.0, None)];
    for k in 0..quantities {
        laws.push(Law::PlusBoth(0.0, 1.0, k));
        laws.extend([1, -1].map(|power| Law::Affine(0.0, 1.0, Some((k, power)))));
    }
    laws
}

/// All laws except those of several axes, the simplest first, without their constants.
fn whole(quantities: usize, others: usize) -> Vec<Law> {
    let mut laws = vec![Law::Times(1.0), Law::Plus(0.0)];
    laws.extend((0..others).map(Law::Other));
    let powers = POWERS
        .iter()
        .flat_map(|power| (0..quantities).map(|k| (k, *power)));
    laws.extend(
        powers
            .clone()
            .map(|(k, power)| Law::TimesQuantity(1.0, k, power)),
    );
    laws.push(Law::Always(0.0));
    laws.extend((0..quantities).map(|k| Law::Quantity(1.0, k)));
    laws.extend(powers.map(|(k, power)| Law::PlusQuantity(1.0, k, power)));
    laws
}
