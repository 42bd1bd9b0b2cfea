//! The questions that kernels and the oracle are asked, and the types of their numbers.

use std::cell::Cell;

use serde::Serialize;

use crate::number::Real;
use crate::shape::{Ray, Shape};
use crate::vector::Vector;

/// Where does this ray first hit this shape, with t ≥ `min_t`? The numbers are stored as `f64`,
/// but each is representable in the tested type, so that the oracle judges the kernel and not
/// the rounding of its input.
#[derive(Clone, Copy, Debug)]
pub struct Question<S> {
    /// The shape.
    pub shape: S,
    /// The ray.
    pub ray: Ray<f64>,
    /// The smallest t that counts.
    pub min_t: f64,
}

/// How unusual a question is. Results of different classes are never added together, because no
/// real scene asks such a mixture of questions.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Class {
    /// All lengths are within a factor of about a thousand, as in most scenes.
    Everyday,
    /// Planets, grazing rays, slivers, surfaces seen edge-on: a realistic scene may contain
    /// them.
    Hard,
    /// Lengths beyond 1e18 or below 1e-18: close to the ends of the type's range.
    Absurd,
}

impl Class {
    /// All classes.
    pub const ALL: [Class; 3] = [Class::Everyday, Class::Hard, Class::Absurd];

    /// The name in tables.
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
    /// `f64`: 53 bits, 1e-308 to 1e308.
    F64,
    /// `f32`: 24 bits, 1e-38 to 1e38.
    F32,
}

impl Data {
    fn pick<T>(self, of_f64: T, of_f32: T) -> T {
        match self {
            Data::F64 => of_f64,
            Data::F32 => of_f32,
        }
    }

    /// The name in tables.
    pub fn name(self) -> &'static str {
        self.pick("f64", "f32")
    }

    /// The nearest number of this type.
    pub fn round(self, value: f64) -> f64 {
        self.pick(value, f32::of(value).wide())
    }

    /// The largest number.
    pub fn largest(self) -> f64 {
        self.pick(f64::MAX, f32::MAX.wide())
    }

    /// The number of significant bits.
    pub fn digits(self) -> i32 {
        self.pick(f64::MANTISSA_DIGITS, f32::MANTISSA_DIGITS) as i32
    }

    /// The e of the smallest positive number, 2^e.
    pub fn smallest_exponent(self) -> i32 {
        self.pick(-1074, -149)
    }
}

impl<S> Question<S> {
    /// A question with `min_t` = 0.
    pub fn new(shape: S, origin: Vector<f64>, direction: Vector<f64>) -> Question<S> {
        Question {
            shape,
            ray: Ray { origin, direction },
            min_t: 0.0,
        }
    }
}

impl<S: Shape<Number = f64, With<f64> = S>> Question<S> {
    /// Applies one function to all lengths, one to the components of normals, one to those of
    /// directions, and one to t.
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

    /// Rounds every number to a type.
    pub fn rounded(&self, data: Data) -> Question<S> {
        let round = |value| data.round(value);
        self.map(round, round, round, round)
    }

    /// Whether every number is finite and directions and normals are not 0.
    pub fn is_sound(&self) -> bool {
        let are_finite = Cell::new(self.ray.is_finite() && self.min_t.is_finite());
        let normal = Cell::new(None);
        let length = |x: f64| {
            are_finite.set(are_finite.get() && x.is_finite());
            x
        };
        let free = |x: f64| {
            normal.set(Some(f64::max(normal.get().unwrap_or(0.0), x.abs())));
            length(x)
        };
        let _: S = self.shape.map(length, free);
        are_finite.get() && normal.get() != Some(0.0) && self.ray.direction.largest() > 0.0
    }
}

/// A power of ten, even if it is subnormal.
pub fn ten_to(power: i32) -> f64 {
    format!("1e{power}").parse().expect("it is a number")
}
