use crate::number::Real;

/// What a filter compares with where plain arithmetic compares with 0, worked out once
/// for a shape and all rays that begin near enough.
#[derive(Clone, Copy, Debug)]
pub struct Limits<F> {
    /// What decides hit or miss has its sign if it is further from 0 than this.
    pub sign: F,
    /// The divisor of t is good to ½√u if it is further from 0, and so is the root in it.
    pub divisor: F,
    /// The dividend of t is good to ½√u, and has its sign, if it is further from 0.
    pub dividend: F,
}

impl<F: Real> Limits<F> {
    /// Nothing is known: every question is left open.
    pub fn none() -> Limits<F> {
        let [sign, divisor, dividend] = [F::of(f64::INFINITY); 3];
        Limits {
            sign,
            divisor,
            dividend,
        }
    }
}
