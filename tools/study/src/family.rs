//! Families of questions. Each sweeps an exponent towards an extreme, until every kernel breaks or
//! the range of the type ends.

mod plane;
mod sphere;
mod triangle;
mod variations;

use crate::contestants::HasKernels;
use crate::question::{Class, Data, Question};
use crate::random::Random;
use crate::vector::Vector;

/// Questions that get harder, or smaller, or larger, with an exponent.
#[derive(Clone, Copy)]
pub struct Family<S> {
    /// One word or two, for tables and file names.
    pub name: &'static str,
    /// What is swept, as the label of an axis: "distance / radius = 10^x".
    pub axis: &'static str,
    /// The exponents, for each type of data.
    pub exponents: fn(Data) -> Vec<i32>,
    /// Questions are everyday ones if the exponent's magnitude is at most this.
    pub everyday: i32,
    /// Draws one random question.
    pub ask: fn(&mut Random, i32, Data) -> Question<S>,
}

/// Questions are absurd if the exponent's magnitude is larger than this.
const HARD: i32 = 18;

impl<S> Family<S> {
    /// The class of its questions at an exponent.
    pub fn class(&self, exponent: i32) -> Class {
        match exponent.abs() {
            x if x <= self.everyday => Class::Everyday,
            x if x <= HARD => Class::Hard,
            _ => Class::Absurd,
        }
    }
}

/// A shape with families of questions about it.
pub trait HasFamilies: HasKernels {
    /// All families of this shape.
    fn families() -> Vec<Family<Self>>;

    /// Draws a question with nothing difficult about it.
    fn plain(random: &mut Random) -> Question<Self>;

    /// The shape, translated.
    fn moved(self, by: Vector<f64>) -> Self;
}

/// All families of a shape, with each of their exponents.
pub fn steps<S: HasFamilies>(data: Data) -> impl Iterator<Item = (Family<S>, i32)> {
    let of_family = move |family: Family<S>| {
        let exponents = (family.exponents)(data).into_iter();
        exponents.map(move |exponent| (family, exponent))
    };
    S::families().into_iter().flat_map(of_family)
}

/// 0, 1, …, `last`, in steps of one decade.
fn decades(last: i32) -> Vec<i32> {
    (0..=last).collect()
}

/// Exponents over the whole range of the type, in coarse steps towards its ends.
fn scales(data: Data) -> Vec<i32> {
    let (coarse, fine): (_, &[i32]) = match data {
        Data::F64 => ((-300..=300).step_by(20), &[-320, -10, -6, -3, 3, 6, 10]),
        Data::F32 => ((-36..=36).step_by(4), &[-44, -40, -3, -2, -1, 1, 2, 3]),
    };
    let mut scales: Vec<i32> = coarse.chain(fine.iter().copied()).collect();
    scales.sort_unstable();
    scales
}

/// `count` valid questions of a family, rounded to the data's type. They are the same for every
/// kernel and on every machine. Empty if the type cannot represent enough of them.
pub fn questions<S: HasKernels>(
    family: &Family<S>,
    exponent: i32,
    data: Data,
    count: usize,
    seed: u64,
) -> Vec<Question<S>> {
    let purpose = format!("{} {} {exponent} {}", S::NAME, family.name, data.name());
    let mut random = Random::new(seed, &purpose);
    let tries = (0..count * 2).map(|_| (family.ask)(&mut random, exponent, data).rounded(data));
    let sound: Vec<_> = tries.filter(Question::is_sound).take(count).collect();
    match sound.len() == count {
        true => sound,
        false => Vec::new(),
    }
}
