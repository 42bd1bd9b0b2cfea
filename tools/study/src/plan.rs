//! The cheapest way to cast one scene that is as accurate as is wished.
//!
//! 1. [`bounds`] says how far rounding can move t and the normal of a hit; [`extent`] the
//!    worst of that for all rays that a scene's camera can send, before any is cast.
//! 2. Where the worst is too much, [`watch`] tells it of each hit from its own numbers, and
//!    [`casting`] casts again, in better numbers, what is uncertain.
//! 3. [`crossover`] says, from measured times, which search is cheaper: boxes or every
//!    part.
//! 4. [`sample`] casts some of the scene's rays: in `f32` and in `f64`, if either would do,
//!    to see which is faster; and as planned, to let the oracle judge. What it refuses is
//!    planned anew.
//! 5. [`told`] puts it in words.
//!
//! Bounds are about t and normals, wherever the right thing is met. Whether it is, at a
//! silhouette that a ray passes within a rounding, no such bound can promise: pixels with
//! another object are counted apart, and a wish for exact ids leaves none.

pub mod bounds;
pub mod casting;
mod choice;
pub mod crossover;
pub mod extent;
pub mod sample;
pub mod told;
pub mod watch;

use pinhole::Scene;
use serde::Serialize;

use crate::cast::rays::rays;
use crate::cast::world::{Primitive, World};
use bounds::Bound;
use casting::Casting;
use choice::Chooser;
use sample::{Confirmed, Sample};

/// What a user wants of a film.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Wish {
    /// The largest relative error of t, and the largest angle of a normal in radians.
    pub accuracy: f64,
    /// Whether no pixel may show another object than the one truly seen.
    pub exact_ids: bool,
    /// Whether t is asked for.
    pub depth: bool,
    /// Whether the normal is.
    pub normal: bool,
}

impl Wish {
    /// Whether what is asked for is certain to be so near the truth.
    #[inline]
    pub fn is_met(&self, bound: Bound) -> bool {
        (!self.depth || bound.t <= self.accuracy) && (!self.normal || bound.normal <= self.accuracy)
    }
}

/// A kind of shape.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Kind {
    /// Spheres.
    Sphere,
    /// Planes.
    Plane,
    /// Triangles, alone or in soups.
    Triangle,
}

impl Kind {
    /// All of them.
    pub const ALL: [Kind; 3] = [Kind::Sphere, Kind::Plane, Kind::Triangle];

    /// Of a part.
    #[inline]
    pub fn of(shape: &Primitive) -> Kind {
        match shape {
            Primitive::Sphere(_) => Kind::Sphere,
            Primitive::Plane(_) => Kind::Plane,
            Primitive::Triangle(_) => Kind::Triangle,
        }
    }

    /// In words.
    pub fn name(self) -> &'static str {
        match self {
            Kind::Sphere => "spheres",
            Kind::Plane => "planes",
            Kind::Triangle => "triangles",
        }
    }
}

/// What a kind is computed with, the cheapest first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Numbers {
    /// 24 binary digits.
    F32,
    /// 53.
    F64,
    /// As many as it takes, at every hit.
    Exact,
}

impl Numbers {
    /// In words.
    pub fn name(self) -> &'static str {
        match self {
            Numbers::F32 => "f32",
            Numbers::F64 => "f64",
            Numbers::Exact => "exact",
        }
    }
}

/// What is planned for a kind of shape.
#[derive(Clone, Debug, Serialize)]
pub struct OfKind {
    /// Which.
    pub kind: Kind,
    /// How many there are.
    pub parts: usize,
    /// What they are computed with.
    pub numbers: Numbers,
    /// Whether each hit's own bound is looked at, and what exceeds the wish cast again.
    pub watched: bool,
    /// How far t may be off in these numbers, whatever ray is cast; none without an end.
    pub worst_t: Option<f64>,
    /// And the normal.
    pub worst_normal: Option<f64>,
    /// Why these numbers.
    pub reason: String,
}

/// A plan for one scene.
#[derive(Clone, Debug, Serialize)]
pub struct Plan {
    /// What for.
    pub wish: Wish,
    /// Pixels of the film.
    pub pixels: usize,
    /// The kinds there are.
    pub kinds: Vec<OfKind>,
    /// `brute force` or `boxes`.
    pub search: &'static str,
    /// Why.
    pub search_reason: String,
    /// What is worked out for a pixel.
    pub outputs: String,
    /// Pixels that will be decided exactly, as far as the sample tells, and why.
    pub exact_pixels: String,
    /// What was left out, and why.
    pub left_out: Vec<String>,
    /// What the oracle says of a sample.
    pub confirmed: Confirmed,
}

/// Plans, and confirms the plan; or says why nothing meets the wish.
pub fn plan(scene: &Scene, wish: Wish) -> Result<(Plan, Casting), String> {
    let world = World::of(&scene.objects);
    let rays = rays(scene);
    let sample = Sample::of(&world, &rays, scene.min_t);
    planned(scene, &world, &sample, rays.len(), wish)
}

/// `f32` is chosen if it takes less than this part of what `f64` takes: what differs less
/// would be decided by chance.
const WORTH: f64 = 0.9;

/// The same for a scene whose sample is known already.
pub fn planned(
    scene: &Scene,
    world: &World,
    sample: &Sample,
    pixels: usize,
    wish: Wish,
) -> Result<(Plan, Casting), String> {
    let mut chooser = Chooser::new(scene, world, wish, sample)?;
    let casting = |chooser: &Chooser| Casting::new(world, scene.min_t, chooser.how());
    if chooser.uses_f32() {
        let without = chooser.without_f32();
        let [narrow, wide] = sample.race([&casting(&chooser), &casting(&without)]);
        let times = format!("{narrow:.0} ns in f32, {wide:.0} ns in f64");
        let is_worth_it = narrow < wide * WORTH;
        let (best, loser) = match is_worth_it {
            true => (chooser, "f64"),
            false => (without, "f32"),
        };
        chooser = best;
        chooser.leave_out(format!(
            "{loser}, which would do: a ray of this scene takes {times}, measured"
        ));
    }
    loop {
        let (how, casting) = (chooser.how(), casting(&chooser));
        let confirmed = sample.confirm(&casting, &wish);
        let refused = Kind::ALL
            .into_iter()
            .zip(confirmed.violations)
            .find(|(_, violations)| *violations > 0);
        match refused {
            Some((kind, violations)) => chooser.refuse(kind, violations)?,
            None => return Ok((chooser.plan(&how, confirmed, pixels), casting)),
        }
    }
}

impl Plan {
    /// In a few words, for tables.
    pub fn short(&self) -> String {
        let kind = |kind: &OfKind| {
            let watched = if kind.watched { ", watched" } else { "" };
            format!("{} {}{watched}", kind.kind.name(), kind.numbers.name())
        };
        let kinds: Vec<String> = self.kinds.iter().map(kind).collect();
        format!("{}; {}", kinds.join("; "), self.search)
    }
}
