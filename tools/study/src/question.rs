//! What kernels and oracle are asked, and the two kinds of numbers it is asked in.

use serde::Serialize;

use crate::number::Real;
use crate::shape::{Ray, Shape};
use crate::vector::Vector;

/// Where does this ray first meet this shape, from `min_t` on? The numbers are `f64`,
/// but each is one that the tested type has: the oracle judges the kernel, not the
/// rounding of its inputs.
#[derive(Clone, Copy, Debug)]
pub struct Question<S> {
    /// What may be met.
    pub shape: S,
    /// By what.
    pub ray: Ray<f64>,
    /// From where on.
    pub min_t: f64,
}

/// How far from the ordinary a question is. Classes are never added up: nobody's scene is a
/// mixture of a teapot and a galaxy.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(rename_all = "lowercase")]
pub enum Class {
    /// Within about a thousand sizes of everything: what most scenes ask.
    Everyday,
    /// Planets, grazing rays, slivers, surfaces seen edge-on: a careful scene may ask it.
    Hard,
    /// Lengths beyond 1e18 or below 1e-18: nearly at the ends of the type.
    Absurd,
}

impl Class {
    /// All of them.
    pub const ALL: [Class; 3] = [Class::Everyday, Class::Hard, Class::Absurd];

    /// How tables call it.
    pub fn name(self) -> &'static str {
        match self {
            Class::Everyday => "everyday",
            Class::Hard => "hard",
            Class::Absurd => "absurd",
        }
    }
}

/// The type in which a question's numbers are stored.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Data {
    /// 53 bits, 1e-308 to 1e308.
    F64,
    /// 24 bits, 1e-38 to 1e38.
    F32,
}

impl Data {
    /// How tables call it.
    pub fn name(self) -> &'static str {
        match self {
            Data::F64 => f64::NAME,
            Data::F32 => f32::NAME,
        }
    }

    /// The nearest number of this type.
    pub fn round(self, value: f64) -> f64 {
        match self {
            Data::F64 => value,
            Data::F32 => f32::of(value).wide(),
        }
    }

    /// The largest number.
    pub fn largest(self) -> f64 {
        match self {
            Data::F64 => f64::MAX,
            Data::F32 => f32::MAX.wide(),
        }
    }

    /// The bits of a number.
    pub fn digits(self) -> i32 {
        match self {
            Data::F64 => f64::MANTISSA_DIGITS as i32,
            Data::F32 => f32::MANTISSA_DIGITS as i32,
        }
    }

    /// The e of the smallest number above 0, 2^e.
    pub fn smallest_exponent(self) -> i32 {
        match self {
            Data::F64 => -1074,
            Data::F32 => -149,
        }
    }
}

impl<S> Question<S> {
    /// From the ray's origin on.
    pub fn new(shape: S, origin: Vector<f64>, direction: Vector<f64>) -> Question<S> {
        Question {
            shape,
            ray: Ray { origin, direction },
            min_t: 0.0,
        }
    }
}

impl<S: Shape<With<f64> = S>> Question<S> {
    /// Each number replaced by functions of it: of lengths, of what a plane's normal
    /// holds, of directions, of t.
    pub fn map(
        &self,
        length: impl Fn(f64) -> f64 + Copy,
        free: impl Fn(f64) -> f64 + Copy,
        direction: impl Fn(f64) -> f64 + Copy,
        t: impl Fn(f64) -> f64 + Copy,
    ) -> Question<S> {
        Question {
            shape: self.shape.map(length, free),
            ray: self.ray.map(length, direction),
            min_t: t(self.min_t),
        }
    }

    /// With every number rounded to a type.
    pub fn rounded(&self, data: Data) -> Question<S> {
        let round = |value| data.round(value);
        self.map(round, round, round, round)
    }

    /// All its numbers: lengths, a normal's, the direction's.
    pub fn numbers(&self) -> [Vec<f64>; 3] {
        let (mut lengths, mut free) = (Vec::new(), Vec::new());
        lengths.extend(self.ray.origin.array());
        let both = std::cell::RefCell::new((&mut lengths, &mut free));
        let _: S = self.shape.map(
            |value| {
                both.borrow_mut().0.push(value);
                value
            },
            |value| {
                both.borrow_mut().1.push(value);
                value
            },
        );
        [lengths, free, self.ray.direction.array().to_vec()]
    }

    /// Whether every number is finite and directions and normals are not 0.
    pub fn is_sound(&self) -> bool {
        let [lengths, free, direction] = self.numbers();
        let is_zero = |numbers: &[f64]| !numbers.is_empty() && numbers.iter().all(|x| *x == 0.0);
        let mut all = lengths.iter().chain(&free).chain(&direction);
        all.all(|x| x.is_finite())
            && self.min_t.is_finite()
            && !is_zero(&free)
            && !is_zero(&direction)
    }
}

/// A power of ten, also where it is subnormal.
pub fn ten_to(power: i32) -> f64 {
    format!("1e{power}").parse().expect("it is a number")
}
