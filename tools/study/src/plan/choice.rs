//! Chooses the numbers for each kind of shape, and remembers why.
//!
//! 1. [`impossible`] is what no numbers can do.
//! 2. [`known`] is what analysis and sample say of a kind.
//! 3. [`decision`] takes the cheapest numbers that serve it.
//! 4. [`whole`] puts together what was decided for all.

mod decision;
mod impossible;
mod known;
mod whole;

use pinhole::Scene;

use super::sample::Sample;
use super::{Kind, Numbers, Wish};
use crate::cast::world::World;
use decision::Decision;
use known::Known;

/// What is known of one kind, and decided for it.
#[derive(Clone)]
struct Chosen {
    known: Known,
    decision: Decision,
}

impl Chosen {
    fn is_narrow(&self) -> bool {
        self.decision.numbers == Numbers::F32
    }
}

/// A plan in the making.
#[derive(Clone)]
pub struct Chooser {
    wish: Wish,
    kinds: [Option<Chosen>; 3],
    left_out: Vec<String>,
}

impl Chooser {
    /// Analyses the scene, and chooses what its bounds allow.
    pub fn new(
        scene: &Scene,
        world: &World,
        wish: Wish,
        sample: &Sample,
    ) -> Result<Chooser, String> {
        impossible::refuse(scene, world, wish)?;
        let mut left_out = Vec::new();
        let from = match wish.exact_ids {
            true => {
                left_out.push("f32: exact ids are filtered in f64".into());
                Numbers::F64
            }
            false => Numbers::F32,
        };
        let known = known::by_kind(scene, world, wish, sample);
        let kinds = Kind::ALL.map(|kind| {
            let known = known[kind as usize]?;
            let decision = Decision::of((kind, &known), wish, from, &mut left_out);
            Some(Chosen { known, decision })
        });
        Ok(Chooser {
            wish,
            kinds,
            left_out,
        })
    }

    fn of(&self, kind: Kind) -> Option<&Chosen> {
        self.kinds[kind as usize].as_ref()
    }

    /// Whether anything is to be cast in `f32`.
    pub fn uses_f32(&self) -> bool {
        self.kinds.iter().flatten().any(Chosen::is_narrow)
    }

    /// The same without `f32`.
    pub fn without_f32(&self) -> Chooser {
        let mut without = self.clone();
        for kind in Kind::ALL {
            if self.of(kind).is_some_and(Chosen::is_narrow) {
                without.choose(kind, Numbers::F64);
            }
        }
        without
    }

    /// One more thing that is left out.
    pub fn leave_out(&mut self, what: String) {
        self.left_out.push(what);
    }

    /// The cheapest numbers that are no worse than `from` and serve.
    fn choose(&mut self, kind: Kind, from: Numbers) {
        if let Some(Chosen { known, decision }) = &mut self.kinds[kind as usize] {
            *decision = Decision::of((kind, known), self.wish, from, &mut self.left_out);
        }
    }

    /// The oracle has refused what was chosen for a kind.
    pub fn refuse(&mut self, kind: Kind, violations: u64) -> Result<(), String> {
        let refused = self.of(kind).map(|chosen| chosen.decision.numbers);
        let (refused, next) = match refused {
            Some(Numbers::F32) => (Numbers::F32, Numbers::F64),
            Some(Numbers::F64) => (Numbers::F64, Numbers::Exact),
            _ => {
                return Err(format!(
                    "{} of the sample miss the accuracy even if they are cast exactly\n  remedy: \
                     report this, for it should not be",
                    kind.name()
                ));
            }
        };
        self.left_out.push(format!(
            "{} for {}: the sample disagrees with the analysis at {violations} pixels",
            refused.name(),
            kind.name()
        ));
        self.choose(kind, next);
        Ok(())
    }
}
