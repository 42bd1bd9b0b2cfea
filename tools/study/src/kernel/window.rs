use crate::number::Real;

/// Which t are surely from `min_t` on, and which surely before, if they are good to √u of
/// themselves.
///
/// t > m (1 + 8√u) + 2 TINY implies t − m > 4√u t + TINY, and t < m (1 − 8√u) − 2 TINY
/// that m − t > 4√u max(|t|, m) + TINY: what is further from m than 4√u of the larger is on
/// its side of it. That is for m ≥ 0, as all that casts scenes has it; else nothing is sure.
#[derive(Clone, Copy, Debug)]
pub struct Window<F> {
    /// Beyond this t are surely not before `min_t`.
    pub after: F,
    /// Below this they surely are.
    pub before: F,
}

impl<F: Real> Window<F> {
    /// For one `min_t`, in the measure of t.
    #[inline(always)]
    pub fn new(min_t: F) -> Window<F> {
        let room = F::of(8.0) * F::ROOT_OF_UNIT;
        let hair = F::TINY + F::TINY;
        let is_known = min_t >= F::ZERO && min_t.is_finite();
        let or_never = |t, never: f64| if is_known { t } else { F::of(never) };
        Window {
            after: or_never(min_t * (F::ONE + room) + hair, f64::INFINITY),
            before: or_never(min_t * (F::ONE - room) - hair, f64::NEG_INFINITY),
        }
    }
}
