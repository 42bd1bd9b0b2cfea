//! Families that all shapes share: a plain question with one property varied.

use super::{Family, HasFamilies, decades, scales};
use crate::question::{Data, Question, ten_to};
use crate::shape::Ray;

/// Varies the length of the ray's direction.
pub fn direction<S: HasFamilies>() -> Family<S> {
    Family {
        name: "direction",
        axis: "length of the direction = 10^x",
        exponents: scales,
        everyday: 3,
        ask: |random, x, data| {
            // A scene so small that t is in range for every length.
            let size = if data == Data::F64 { 1e-13 } else { 1e-6 };
            let question = S::plain(random).map(|l| l * size, |n| n, |d| d, |t| t);
            question.map(|l| l, |n| n, |d| d * ten_to(x), |t| t)
        },
    }
}

/// Varies the distance of the scene from the world's origin.
pub fn offset<S: HasFamilies>() -> Family<S> {
    Family {
        name: "offset",
        axis: "distance of the scene from the world's origin = 10^x",
        exponents: |_| decades(12),
        everyday: 3,
        ask: |random, x, _| {
            let Question { shape, ray, min_t } = S::plain(random);
            let offset = random.unit() * ten_to(x);
            let origin = ray.origin + offset;
            Question {
                shape: shape.moved(offset),
                ray: Ray { origin, ..ray },
                min_t,
            }
        },
    }
}

/// Varies the unit in which the shape, the origin and the direction are measured.
pub fn scale<S: HasFamilies>() -> Family<S> {
    Family {
        name: "scale",
        axis: "size of the scene = 10^x",
        exponents: scales,
        everyday: 3,
        ask: |random, x, _| {
            let scale = ten_to(x);
            S::plain(random).map(|l| l * scale, |n| n, |d| d * scale, |t| t)
        },
    }
}

/// Varies `min_t` around the true hit: just before it, or just behind it.
pub fn threshold<S: HasFamilies>(axis: &'static str) -> Family<S> {
    Family {
        name: "threshold",
        axis,
        exponents: |_| (1..=17).collect(),
        everyday: 4,
        ask: |random, x, _| {
            loop {
                let question = S::plain(random);
                if let Some(root) = S::truth(&question).t {
                    let min_t = root.value * (1.0 + random.sign() * ten_to(-x));
                    return Question { min_t, ..question };
                }
            }
        },
    }
}
