//! The true answers: decisions without any rounding, and t to more than 300 bits.
//!
//! Every number of a question is a fraction, and so is every intermediate result except a
//! square root. The arithmetic is dashu's. The oracle shares no arithmetic with the kernels,
//! and tests compare it with a second oracle that uses Python's fractions.

pub mod scene;
mod shapes;
mod truth;

pub use truth::{Root, Truth};

use dashu_ratio::Relaxed;

use crate::question::Question;
use crate::shape::Shape;
use crate::vector::Vector;

/// A shape for which the true answer can be computed.
pub trait HasTruth: Shape<Number = f64, With<f64> = Self> {
    /// The true answer.
    ///
    /// # Panics
    /// If a number of the question is not finite.
    fn truth(question: &Question<Self>) -> Truth;
}

/// Converts a float to a fraction, exactly.
fn fraction(value: f64) -> Relaxed {
    Relaxed::try_from(value).expect("only finite questions are asked")
}

/// A vector of fractions.
struct Exact([Relaxed; 3]);

impl Exact {
    fn of(vector: Vector<f64>) -> Exact {
        Exact(vector.array().map(fraction))
    }

    fn dot(&self, other: &Exact) -> Relaxed {
        let terms = self.0.iter().zip(&other.0).map(|(a, b)| a * b);
        terms.fold(fraction(0.0), |sum, term| sum + term)
    }

    fn minus(&self, other: &Exact) -> Exact {
        let [x, y, z] = &self.0;
        let [a, b, c] = &other.0;
        Exact([x - a, y - b, z - c])
    }

    fn cross(&self, other: &Exact) -> Exact {
        let [x, y, z] = &self.0;
        let [a, b, c] = &other.0;
        Exact([y * c - z * b, z * a - x * c, x * b - y * a])
    }
}

/// −1, 0 or 1.
fn sign(value: &Relaxed) -> i32 {
    match value.is_zero() {
        true => 0,
        false => (value.numerator() > &dashu_int::IBig::ZERO) as i32 * 2 - 1,
    }
}
