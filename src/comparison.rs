//! A film beside its golden, part by part, for finding out why it is wrong.
//!
//! The judge decides whether a film passes. This module finds out which pixels are wrong, which
//! part of an answer is wrong there, and whether the wrong values are those that a known mistake
//! leaves.

use crate::film::{Film, MISS};
use crate::judge::Golden;

/// One wrong pixel.
#[derive(Clone, Debug, PartialEq)]
pub struct Witness {
    /// Its index in image order.
    pub pixel: usize,
    /// What the mistake leaves there, in the golden's channel order.
    pub values: Vec<f32>,
}

/// A value counts as a mistake's value if they differ by no more than this share of their size.
/// They may have been computed in different ways, and the rounding errors of 32-bit arithmetic stay
/// well below this.
const SAME: f32 = 1e-5;

/// Where a golden's tolerance is wider than [`SAME`], use the tolerance, up to this limit.
const MOST_SAME: f32 = 1e-3;

/// A number or a vector that is compared as one, by the indices of its channels.
#[derive(Clone, Debug)]
enum Quantity {
    Id(usize),
    Other(Vec<usize>),
}

/// A part of a film that can be right while the rest is wrong.
#[derive(Clone, Debug)]
enum Part {
    /// Which object is hit.
    Id(usize),
    /// A number or a vector.
    Values(Vec<usize>),
    /// A vector's length alone.
    Length(Vec<usize>),
}

/// A film and the golden it is compared with.
#[derive(Clone, Debug)]
pub struct FilmComparison<'a> {
    film: Vec<&'a [f32]>,
    expected: Vec<&'a [f32]>,
    tolerance: Vec<&'a [f32]>,
    quantities: Vec<Quantity>,
    parts: Vec<Part>,
    wrong: Vec<bool>,
    failing: usize,
}

impl<'a> FilmComparison<'a> {
    /// `None` if they differ in size or channels.
    pub fn new(golden: &'a Golden, film: &'a Film) -> Option<FilmComparison<'a>> {
        if golden.film().resolution() != film.resolution() {
            return None;
        }
        let names = channel_names(golden);
        let of = |film: &'a Film| -> Option<Vec<&'a [f32]>> {
            names.iter().map(|name| film.channel(name)).collect()
        };
        let (expected, tolerance) = (of(golden.film())?, of(golden.tolerance())?);
        let film = of(film)?;
        // Written this way so that NaN counts as wrong.
        let right = |pixel: usize| {
            (0..names.len()).all(|channel| {
                let distance = (film[channel][pixel] - expected[channel][pixel]).abs();
                distance <= tolerance[channel][pixel]
            })
        };
        let wrong: Vec<bool> = (0..golden.film().resolution().pixels())
            .map(|pixel| !right(pixel))
            .collect();
        Some(FilmComparison {
            film,
            expected,
            tolerance,
            parts: parts(&quantities(&names)),
            quantities: quantities(&names),
            failing: wrong.iter().filter(|wrong| **wrong).count(),
            wrong,
        })
    }

    /// How many pixels are wrong.
    pub fn failing(&self) -> usize {
        self.failing
    }

    /// How many pixels there are.
    pub fn pixels(&self) -> usize {
        self.wrong.len()
    }

    /// Whether any pixel has values to compare, because its ray hits something, as it should.
    pub fn has_values(&self) -> bool {
        let is_hit = |film, pixel| self.is_hit(film, pixel);
        (0..self.pixels()).any(|pixel| is_hit(&self.film, pixel) && is_hit(&self.expected, pixel))
    }

    /// In how many pixels a ray should hit something.
    pub fn expected_hits(&self) -> usize {
        let is_hit = |pixel: &usize| self.is_hit(&self.expected, *pixel);
        (0..self.pixels()).filter(is_hit).count()
    }

    /// Whether a ray hits something in this pixel of a film, or the film has no ids.
    fn is_hit(&self, film: &[&[f32]], pixel: usize) -> bool {
        let mut ids = self
            .quantities
            .iter()
            .filter_map(|quantity| match quantity {
                Quantity::Id(place) => Some(film[*place][pixel]),
                Quantity::Other(_) => None,
            });
        ids.next() != Some(MISS)
    }

    /// Whether the pixel is wrong at all.
    pub fn is_wrong(&self, pixel: usize) -> bool {
        self.wrong.get(pixel) == Some(&true)
    }

    /// Whether the pixel has this witness's wrong values.
    pub fn shows(&self, witness: &Witness) -> bool {
        let Witness { pixel, values } = witness;
        self.is_wrong(*pixel)
            && values.len() == self.film.len()
            && self.quantities.iter().all(|quantity| match quantity {
                Quantity::Id(place) => self.film[*place][*pixel] == values[*place],
                // A miss has no t and no normal.
                Quantity::Other(_) if self.is_miss(values) => true,
                Quantity::Other(places) => self.is_same(places, *pixel, values),
            })
    }

    /// By how much each value of a witness is too large. `None` if the witness or the golden is a
    /// miss.
    pub fn error(&self, witness: &Witness) -> Option<Vec<f64>> {
        let expected: Vec<f32> = self.expected.iter().map(|it| it[witness.pixel]).collect();
        if self.is_miss(&expected) || self.is_miss(&witness.values) {
            return None;
        }
        let pairs = witness.values.iter().zip(&expected);
        let errors = pairs.map(|(value, right)| f64::from(*value) - f64::from(*right));
        Some(errors.collect())
    }

    /// What two mistakes leave together in a pixel that both get wrong, if their errors add up.
    /// `None` if there is nothing to add, because one of them or the golden is a miss.
    pub fn sum(&self, one: &Witness, other: &Witness) -> Option<Witness> {
        self.error(one)?;
        let errors = self.error(other)?;
        let values = one.values.iter().zip(errors);
        let values = values.map(|(value, error)| (f64::from(*value) + error) as f32);
        Some(Witness {
            pixel: one.pixel,
            values: values.collect(),
        })
    }

    /// The number of parts that are compared separately.
    pub fn parts(&self) -> usize {
        self.parts.len()
    }

    /// Whether a part is the length of the vector that is the part before it.
    pub fn is_length(&self, part: usize) -> bool {
        matches!(self.parts[part], Part::Length(_))
    }

    /// In how many pixels each part is wrong, where it can be seen.
    pub fn failing_parts(&self) -> Vec<f64> {
        let count = |part: usize| {
            let wrong = (0..self.pixels()).filter(|pixel| self.is_part_wrong(part, *pixel));
            wrong.count() as f64
        };
        (0..self.parts.len()).map(count).collect()
    }

    /// Whether a part can be seen and is wrong in the film.
    pub fn is_part_wrong(&self, part: usize, pixel: usize) -> bool {
        self.is_wrong(pixel)
            && self.is_seen(part, pixel, &|place| self.film[place][pixel])
            && self.is_off(part, pixel, &|place| self.film[place][pixel])
    }

    /// Whether a mistake spoils a part in this pixel, and the film lets us see it.
    pub fn shows_part(&self, part: usize, witness: &Witness) -> bool {
        let Witness { pixel, values } = witness;
        values.len() == self.film.len()
            && *pixel < self.pixels()
            && self.is_seen(part, *pixel, &|place| self.film[place][*pixel])
            && self.is_seen(part, *pixel, &|place| values[place])
            && self.is_off(part, *pixel, &|place| values[place])
    }

    /// Whether a part has the values of a mistake.
    pub fn is_part_same(&self, part: usize, witness: &Witness) -> bool {
        let Witness { pixel, values } = witness;
        match &self.parts[part] {
            Part::Id(place) => self.film[*place][*pixel] == values[*place],
            Part::Values(places) => self.is_same(places, *pixel, values),
            Part::Length(places) => {
                let got = length(places, &|place| self.film[place][*pixel]);
                let known = length(places, &|place| values[place]);
                let tolerance = self.widest(places, *pixel).min(MOST_SAME * known);
                (got - known).abs() <= tolerance.max(SAME * known)
            }
        }
    }

    /// Whether a part can be seen. The object can always be seen, everything else only where the
    /// object is right.
    fn is_seen(&self, part: usize, pixel: usize, value: &dyn Fn(usize) -> f32) -> bool {
        let mut ids = self
            .parts
            .iter()
            .enumerate()
            .filter_map(|(k, it)| match it {
                Part::Id(place) if k != part => Some(*place),
                _ => None,
            });
        ids.all(|id| value(id) == self.expected[id][pixel] && value(id) != MISS)
    }

    fn is_off(&self, part: usize, pixel: usize, value: &dyn Fn(usize) -> f32) -> bool {
        // Written this way so that NaN counts as wrong.
        let is_near = |place: usize| {
            (value(place) - self.expected[place][pixel]).abs() <= self.tolerance[place][pixel]
        };
        match &self.parts[part] {
            Part::Id(place) => !is_near(*place),
            Part::Values(places) => !places.iter().all(|place| is_near(*place)),
            Part::Length(places) => {
                let expected = length(places, &|place| self.expected[place][pixel]);
                let apart = (length(places, value) - expected).abs();
                let allowed = 2.0 * self.widest(places, pixel) + SAME * expected;
                let is_near = apart <= allowed;
                !is_near
            }
        }
    }

    fn widest(&self, places: &[usize], pixel: usize) -> f32 {
        let tolerances = places.iter().map(|place| self.tolerance[*place][pixel]);
        tolerances.fold(0.0, f32::max)
    }

    fn is_miss(&self, values: &[f32]) -> bool {
        let mut ids = self
            .quantities
            .iter()
            .filter_map(|quantity| match quantity {
                Quantity::Id(place) => Some(values[*place]),
                Quantity::Other(_) => None,
            });
        ids.next() == Some(MISS)
    }

    fn is_same(&self, places: &[usize], pixel: usize, values: &[f32]) -> bool {
        let size = places
            .iter()
            .map(|place| values[*place].abs())
            .fold(0.0, f32::max);
        places.iter().all(|place| {
            let (got, known) = (self.film[*place][pixel], values[*place]);
            let tolerance = self.tolerance[*place][pixel].min(MOST_SAME * size);
            let both_lost = !got.is_finite() && !known.is_finite();
            both_lost || (got - known).abs() <= tolerance.max(SAME * size)
        })
    }

    /// What the film has in a pixel.
    pub fn witness(&self, pixel: usize) -> Witness {
        Witness {
            pixel,
            values: self.film.iter().map(|samples| samples[pixel]).collect(),
        }
    }
}

/// The golden's channels in the order of a witness's values.
pub fn channel_names(golden: &Golden) -> Vec<String> {
    let channels = golden.film().channels().iter();
    let mut names: Vec<String> = channels.map(|channel| channel.name.clone()).collect();
    names.sort();
    names
}

fn quantities(names: &[String]) -> Vec<Quantity> {
    let mut quantities: Vec<(&str, Vec<usize>)> = Vec::new();
    for (place, name) in names.iter().enumerate() {
        let vector = name.split('.').next().unwrap_or(name);
        match quantities.last_mut() {
            Some((last, places)) if *last == vector => places.push(place),
            _ => quantities.push((vector, vec![place])),
        }
    }
    quantities
        .into_iter()
        .map(|(name, places)| match (name, places.as_slice()) {
            ("id", [place]) => Quantity::Id(*place),
            _ => Quantity::Other(places),
        })
        .collect()
}

fn parts(quantities: &[Quantity]) -> Vec<Part> {
    let mut parts = Vec::new();
    for quantity in quantities {
        match quantity {
            Quantity::Id(place) => parts.push(Part::Id(*place)),
            Quantity::Other(places) => {
                parts.push(Part::Values(places.clone()));
                if places.len() > 1 {
                    parts.push(Part::Length(places.clone()));
                }
            }
        }
    }
    parts
}

fn length(places: &[usize], value: &dyn Fn(usize) -> f32) -> f32 {
    let squares = places.iter().map(|place| value(*place).powi(2));
    squares.sum::<f32>().sqrt()
}
