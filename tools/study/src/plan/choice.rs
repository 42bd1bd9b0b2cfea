//! Chooses the numbers for each kind of shape, and remembers why.

use pinhole::Scene;

use super::bounds::{Bound, Rounding};
use super::casting::How;
use super::crossover::{boxes_from, search};
use super::extent::Extent;
use super::sample::{Confirmed, Sample};
use super::told::{angle, bounded, count, percent};
use super::watch;
use super::{Kind, Numbers, OfKind, Plan, Wish};
use crate::cast::model::Exact;
use crate::cast::world::World;
use crate::cast::{Caster, Search, Tally};
use crate::number::Real;

/// Where more hits than this are uncertain in `f32`, casting them again in `f64` takes
/// what `f32` can spare.
const MOST_AGAIN_IN_F64: f64 = 0.2;
/// Where more are uncertain in `f64`, watching them is spared, and all are exact.
const MOST_AGAIN_EXACTLY: f64 = 0.5;

/// What is known of one kind, and chosen for it.
#[derive(Clone)]
struct Chosen {
    parts: usize,
    /// For all rays, in `f32` and in `f64`.
    worst: [Bound; 2],
    /// Of the sample's hits on it, the share that is uncertain.
    open: [f64; 2],
    numbers: Numbers,
    watched: bool,
    reason: String,
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
        refuse_the_impossible(scene, world, wish)?;
        let extent = Extent::of(scene);
        let open = open(world, scene.min_t, wish, sample);
        let mut chooser = Chooser {
            wish,
            kinds: [None, None, None],
            left_out: Vec::new(),
        };
        for kind in Kind::ALL {
            let parts = || {
                world
                    .parts
                    .iter()
                    .filter(|part| Kind::of(&part.shape) == kind)
            };
            // A soup's triangles have one object in common.
            let neighbours = parts()
                .zip(parts().skip(1))
                .any(|(one, next)| one.object == next.object);
            let worst = [Rounding::F32, Rounding::F64].map(|rounding| {
                parts()
                    .map(|part| extent.bound(part, rounding, neighbours))
                    .fold(
                        Bound {
                            t: 0.0,
                            normal: 0.0,
                        },
                        Bound::worse,
                    )
            });
            let parts = parts().count();
            if parts > 0 {
                chooser.kinds[kind as usize] = Some(Chosen {
                    parts,
                    worst,
                    open: open[kind as usize],
                    numbers: Numbers::F32,
                    watched: false,
                    reason: String::new(),
                });
            }
        }
        let cheapest = match wish.exact_ids {
            true => Numbers::F64,
            false => Numbers::F32,
        };
        let why_not = wish
            .exact_ids
            .then(|| "f32: exact ids are filtered in f64".into());
        chooser.left_out.extend(why_not);
        for kind in Kind::ALL {
            chooser.choose(kind, cheapest);
        }
        Ok(chooser)
    }

    /// Whether anything is to be cast in `f32`.
    pub fn uses_f32(&self) -> bool {
        let mut chosen = self.kinds.iter().flatten();
        chosen.any(|chosen| chosen.numbers == Numbers::F32)
    }

    /// The same without `f32`.
    pub fn without_f32(&self) -> Chooser {
        let mut without = self.clone();
        for kind in Kind::ALL {
            let chosen = self.kinds[kind as usize].as_ref();
            if chosen.is_some_and(|chosen| chosen.numbers == Numbers::F32) {
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
        let (wish, name) = (self.wish, kind.name());
        let Some(chosen) = &mut self.kinds[kind as usize] else {
            return;
        };
        let mut take = |numbers, watched, reason| {
            (chosen.numbers, chosen.watched, chosen.reason) = (numbers, watched, reason);
        };
        if from == Numbers::F32 {
            let [worst, _] = chosen.worst;
            let [open, _] = chosen.open;
            let why_not = if wish.is_met(worst) {
                return take(Numbers::F32, false, met(worst, wish));
            } else if open <= MOST_AGAIN_IN_F64 {
                let reason = watched(open, "in f64");
                return take(Numbers::F32, true, reason);
            } else {
                format!("{} of the hits would be uncertain", percent(open))
            };
            self.left_out.push(format!("f32 for {name}: {why_not}"));
        }
        let [_, worst] = chosen.worst;
        let [_, open] = chosen.open;
        if from <= Numbers::F64 {
            if wish.is_met(worst) {
                return take(Numbers::F64, false, met(worst, wish));
            }
            if open <= MOST_AGAIN_EXACTLY {
                let reason = watched(open, "exactly");
                return take(Numbers::F64, true, reason);
            }
            let why_not = format!("{} of the hits would be uncertain", percent(open));
            self.left_out.push(format!("f64 for {name}: {why_not}"));
        }
        take(
            Numbers::Exact,
            false,
            "f64 is uncertain too often: each t is exact, and rounded once".into(),
        );
    }

    /// The oracle has refused what was chosen for a kind.
    pub fn refuse(&mut self, kind: Kind, violations: u64) -> Result<(), String> {
        let refused = self.kinds[kind as usize]
            .as_ref()
            .map(|chosen| chosen.numbers);
        let next = match refused {
            Some(Numbers::F32) => Numbers::F64,
            Some(Numbers::F64) => Numbers::Exact,
            _ => {
                return Err(format!(
                    "{} of the sample miss the accuracy even if they are cast exactly\n  remedy: \
                     report this, for it should not be",
                    kind.name()
                ));
            }
        };
        let numbers = refused.map_or("", Numbers::name);
        self.left_out.push(format!(
            "{numbers} for {}: the sample disagrees with the analysis at {violations} pixels",
            kind.name()
        ));
        self.choose(kind, next);
        Ok(())
    }

    /// As it stands.
    pub fn how(&self) -> How {
        let of = |kind: Kind| self.kinds[kind as usize].as_ref();
        let numbers = Kind::ALL.map(|kind| {
            of(kind).map_or((Numbers::F64, false), |chosen| {
                (chosen.numbers, chosen.watched)
            })
        });
        let parts = |kind, is_narrow| {
            of(kind)
                .filter(|chosen| (chosen.numbers == Numbers::F32) == is_narrow)
                .map_or(0, |chosen| chosen.parts)
        };
        let search = |is_narrow, numbers| {
            let [spheres, triangles] =
                [Kind::Sphere, Kind::Triangle].map(|kind| parts(kind, is_narrow));
            search(spheres, triangles, numbers)
        };
        How {
            wish: self.wish,
            numbers,
            narrow: search(true, Numbers::F32),
            wide: match self.wish.exact_ids {
                true => search(false, Numbers::Exact),
                false => search(false, Numbers::F64),
            },
        }
    }

    /// The whole, with what the oracle says of it.
    pub fn plan(self, how: &How, confirmed: Confirmed, pixels: usize) -> Plan {
        let wish = self.wish;
        let is_narrow = |chosen: &&Chosen| chosen.numbers == Numbers::F32;
        let uses_f32 = self.uses_f32();
        let (search, numbers) = match (uses_f32, wish.exact_ids) {
            (true, _) => (how.narrow, Numbers::F32),
            (false, true) => (how.wide, Numbers::Exact),
            (false, false) => (how.wide, Numbers::F64),
        };
        let crossover = |kind: Kind| {
            let chosen = self.kinds[kind as usize].as_ref();
            let chosen = chosen.filter(|chosen| !uses_f32 || is_narrow(chosen))?;
            let from = boxes_from(kind, numbers);
            let parts = count(chosen.parts, kind.name());
            Some(format!("{parts} (boxes pay from {from} on)"))
        };
        let parts: Vec<String> = [Kind::Sphere, Kind::Triangle]
            .into_iter()
            .filter_map(crossover)
            .collect();
        let mut left_out = self.left_out;
        left_out.extend(match search {
            Search::Boxes => Some("every part for every ray: boxes spare most of them".into()),
            Search::BruteForce => Some("a tree of boxes: it costs more than it spares".into()),
        });
        left_out.extend((!wish.depth).then(|| "t: it is not asked for; the film has 0".into()));
        left_out.extend(
            (!wish.normal).then(|| "normals: they are not asked for; the film has 0".into()),
        );
        let share = confirmed.spent.again_exactly as f64 / confirmed.rays.max(1) as f64;
        let is_exact = how
            .numbers
            .iter()
            .any(|(numbers, _)| *numbers == Numbers::Exact);
        let exact_pixels = match (wish.exact_ids, share > 0.0 || is_exact) {
            (true, _) => format!(
                "every decision is filtered, and exact where the filter leaves it open; t and \
                 normals of {} of the pixels",
                percent(share)
            ),
            (false, true) => format!("{} of the pixels, as the sample has it", percent(share)),
            (false, false) => "none: no pixel of the sample needs it".into(),
        };
        if !wish.exact_ids && share == 0.0 && !is_exact {
            left_out
                .push("exact arithmetic: nothing asks for it, or a pixel here and there".into());
        }
        let outputs = match (wish.depth, wish.normal) {
            (true, true) => "id, depth and normal: a normal is worked out once for a pixel",
            (true, false) => "id and depth: no normal is worked out",
            (false, true) => "id and normal: one normal for a pixel",
            (false, false) => "id alone",
        };
        let finite = |bound: f64| bound.is_finite().then_some(bound);
        let kinds = Kind::ALL.into_iter().zip(self.kinds);
        Plan {
            wish,
            pixels,
            kinds: kinds
                .filter_map(|(kind, chosen)| {
                    let chosen = chosen?;
                    let worst = chosen.worst[usize::from(chosen.numbers != Numbers::F32)];
                    Some(OfKind {
                        kind,
                        parts: chosen.parts,
                        numbers: chosen.numbers,
                        watched: chosen.watched,
                        worst_t: finite(worst.t),
                        worst_normal: finite(worst.normal),
                        reason: chosen.reason,
                    })
                })
                .collect(),
            search: search.name(),
            search_reason: match parts.is_empty() {
                true => "planes fit into no box".into(),
                false => format!("measured, for {}", parts.join(" and ")),
            },
            outputs: outputs.into(),
            exact_pixels,
            left_out,
            confirmed,
        }
    }
}

/// Why no hit needs to be watched.
fn met(worst: Bound, wish: Wish) -> String {
    match (wish.depth || wish.normal, wish.exact_ids) {
        (true, _) => format!("no ray can be off by more: {}", bounded(worst, wish)),
        (false, true) => "which object is nearest is filtered, and decided exactly".into(),
        (false, false) => "neither t nor normals are asked for".into(),
    }
}

/// Why hits are watched, of which this share is uncertain.
fn watched(open: f64, next: &str) -> String {
    match open > 0.0 {
        true => format!(
            "{} of the sample's hits are certain to meet X; each hit is watched, and what is not \
             is cast again {next}",
            percent(1.0 - open)
        ),
        false => format!(
            "every hit of the sample is certain to meet X, if not every ray there could be; each \
             hit is watched, and what is not certain is cast again {next}"
        ),
    }
}

/// Of the sample's hits on each kind, the share that is uncertain in `f32` and in `f64`.
fn open(world: &World, min_t: f64, wish: Wish, sample: &Sample) -> [[f64; 2]; 3] {
    let caster = Caster::new(world.clone());
    let (mut hits, mut open) = ([0u32; 3], [[0u32; 2]; 3]);
    for ray in &sample.rays {
        let found = caster.first::<Exact>(Search::Boxes, ray, min_t, &mut Tally::default());
        let Some(found) = found else { continue };
        let kind = Kind::of(&found.part.shape) as usize;
        hits[kind] += 1;
        for (at, rounding) in [Rounding::F32, Rounding::F64].into_iter().enumerate() {
            let shape = &found.part.shape;
            let bound = watch::bound(shape, ray, (found.t, min_t), rounding, wish.exact_ids);
            open[kind][at] += u32::from(!wish.is_met(bound));
        }
    }
    [0, 1, 2].map(|kind| open[kind].map(|open| f64::from(open) / f64::from(hits[kind].max(1))))
}

/// What even the exact path cannot promise, for its results are `f64`.
fn refuse_the_impossible(scene: &Scene, world: &World, wish: Wish) -> Result<(), String> {
    let u = f64::UNIT_ROUNDOFF;
    if !(wish.accuracy >= 16.0 * u) {
        return Err(format!(
            "an f64 holds 16 digits: no answer is known to {:e}\n  remedy: ask for 2e-15 or more",
            wish.accuracy
        ));
    }
    if !wish.normal {
        return Ok(());
    }
    let extent = Extent::of(scene);
    let floor = world.parts.iter().map(|part| extent.floor(part));
    let floor = floor.fold(0.0, f64::max);
    match floor <= wish.accuracy {
        true => Ok(()),
        false => Err(format!(
            "the normal of a sphere so small or so far away is known to {} only, for t is an \
             f64\n  remedy: ask for that, or leave normals out with --outputs id,depth",
            angle(floor)
        )),
    }
}
