//! What is known of a kind of shape before anything is chosen for it: from analysis, about
//! all rays; from the sample, about its hits.

use pinhole::Scene;

use crate::cast::model::Exact;
use crate::cast::world::{Part, World};
use crate::cast::{Caster, Search, Tally};
use crate::plan::bounds::{Bound, Rounding};
use crate::plan::extent::Extent;
use crate::plan::sample::Sample;
use crate::plan::{Kind, Wish, watch};

/// What is known of a kind that the scene has.
#[derive(Clone, Copy)]
pub struct Known {
    /// How many there are.
    pub parts: usize,
    /// If they are computed in `f32`.
    pub in_f32: Doubt,
    /// If they are in `f64`.
    pub in_f64: Doubt,
}

/// How uncertain a type of numbers leaves a kind.
#[derive(Clone, Copy)]
pub struct Doubt {
    /// For all rays.
    pub worst: Bound,
    /// Of the sample's hits on it, the share that is uncertain.
    pub open: f64,
}

/// What is known of each kind, in the order of [`Kind::ALL`]; `None` if there is none.
pub fn by_kind(scene: &Scene, world: &World, wish: Wish, sample: &Sample) -> [Option<Known>; 3] {
    let extent = Extent::of(scene);
    let open = open(world, scene.min_t, wish, sample);
    Kind::ALL.map(|kind| {
        let of_kind = |part: &&Part| Kind::of(&part.shape) == kind;
        let parts: Vec<&Part> = world.parts.iter().filter(of_kind).collect();
        let doubt = |rounding, open| Doubt {
            worst: worst(&extent, &parts, rounding),
            open,
        };
        let [open_in_f32, open_in_f64] = open[kind as usize];
        (!parts.is_empty()).then(|| Known {
            parts: parts.len(),
            in_f32: doubt(Rounding::F32, open_in_f32),
            in_f64: doubt(Rounding::F64, open_in_f64),
        })
    })
}

/// The worst that rounding can do to any of these parts, whatever ray meets it.
fn worst(extent: &Extent, parts: &[&Part], rounding: Rounding) -> Bound {
    // A soup's triangles have one object in common.
    let neighbours = parts.windows(2).any(|two| two[0].object == two[1].object);
    let bounds = parts
        .iter()
        .map(|part| extent.bound(part, rounding, neighbours));
    let nothing = Bound {
        t: 0.0,
        normal: 0.0,
    };
    bounds.fold(nothing, Bound::worse)
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
