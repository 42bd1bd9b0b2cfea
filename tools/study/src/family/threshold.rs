use crate::oracle::Known;
use crate::question::{Question, ten_to};
use crate::random::Random;

/// A hit whose t is just before or just behind `min_t`: by 10^−`exponent` of itself.
pub fn at_threshold<S: Known>(
    random: &mut Random,
    exponent: i32,
    plain: fn(&mut Random) -> Question<S>,
) -> Question<S> {
    loop {
        let question = plain(random);
        if let Some(root) = S::truth(&question).t {
            let min_t = root.value() * (1.0 + random.sign() * ten_to(-exponent));
            return Question { min_t, ..question };
        }
    }
}
