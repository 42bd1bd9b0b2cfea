//! The whole plan: what was decided for each kind of shape, put together and told.

use super::{Chooser, Chosen};
use crate::cast::Search;
use crate::plan::casting::How;
use crate::plan::crossover::{boxes_from, search};
use crate::plan::sample::Confirmed;
use crate::plan::told::{count, percent};
use crate::plan::{Kind, Numbers, OfKind, Plan, Wish};

impl Chooser {
    /// How to cast, as it stands.
    pub fn how(&self) -> How {
        let numbers = Kind::ALL.map(|kind| {
            self.of(kind).map_or((Numbers::F64, false), |chosen| {
                (chosen.decision.numbers, chosen.decision.watched)
            })
        });
        let parts = |kind, is_narrow| {
            self.of(kind)
                .filter(|chosen| chosen.is_narrow() == is_narrow)
                .map_or(0, |chosen| chosen.known.parts)
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
        let (search, search_reason) = self.search(how);
        let again = confirmed.spent.again_exactly as f64 / confirmed.rays.max(1) as f64;
        let mut of_numbers = how.numbers.iter();
        let any_exactly = again > 0.0 || of_numbers.any(|(numbers, _)| *numbers == Numbers::Exact);

        let mut left_out = self.left_out;
        left_out.push(match search {
            Search::Boxes => "every part for every ray: boxes spare most of them".into(),
            Search::BruteForce => "a tree of boxes: it costs more than it spares".into(),
        });
        if !wish.depth {
            left_out.push("t: it is not asked for; the film has 0".into());
        }
        if !wish.normal {
            left_out.push("normals: they are not asked for; the film has 0".into());
        }
        if !wish.exact_ids && !any_exactly {
            left_out
                .push("exact arithmetic: nothing asks for it, or a pixel here and there".into());
        }

        let kinds = Kind::ALL.into_iter().zip(self.kinds);
        Plan {
            wish,
            pixels,
            kinds: kinds
                .filter_map(|(kind, chosen)| Some(chosen?.planned(kind)))
                .collect(),
            search: search.name(),
            search_reason,
            outputs: outputs(wish).into(),
            exact_pixels: match (wish.exact_ids, any_exactly) {
                (true, _) => format!(
                    "every decision is filtered, and exact where the filter leaves it open; t and \
                     normals of {} of the pixels",
                    percent(again)
                ),
                (false, true) => format!("{} of the pixels, as the sample has it", percent(again)),
                (false, false) => "none: no pixel of the sample needs it".into(),
            },
            left_out,
            confirmed,
        }
    }

    /// The search that most rays begin with, and why.
    fn search(&self, how: &How) -> (Search, String) {
        let uses_f32 = self.uses_f32();
        let (search, numbers) = match (uses_f32, self.wish.exact_ids) {
            (true, _) => (how.narrow, Numbers::F32),
            (false, true) => (how.wide, Numbers::Exact),
            (false, false) => (how.wide, Numbers::F64),
        };
        let crossover = |kind: Kind| {
            let chosen = self.of(kind)?;
            let from = boxes_from(kind, numbers);
            let parts = count(chosen.known.parts, kind.name());
            (!uses_f32 || chosen.is_narrow()).then(|| format!("{parts} (boxes pay from {from} on)"))
        };
        let parts: Vec<String> = [Kind::Sphere, Kind::Triangle]
            .into_iter()
            .filter_map(crossover)
            .collect();
        let reason = match parts.is_empty() {
            true => "planes fit into no box".into(),
            false => format!("measured, for {}", parts.join(" and ")),
        };
        (search, reason)
    }
}

impl Chosen {
    fn planned(self, kind: Kind) -> OfKind {
        let worst = match self.is_narrow() {
            true => self.known.in_f32.worst,
            false => self.known.in_f64.worst,
        };
        let finite = |bound: f64| bound.is_finite().then_some(bound);
        OfKind {
            kind,
            parts: self.known.parts,
            numbers: self.decision.numbers,
            watched: self.decision.watched,
            worst_t: finite(worst.t),
            worst_normal: finite(worst.normal),
            reason: self.decision.reason,
        }
    }
}

/// What is worked out for a pixel.
fn outputs(wish: Wish) -> &'static str {
    match (wish.depth, wish.normal) {
        (true, true) => "id, depth and normal: a normal is worked out once for a pixel",
        (true, false) => "id and depth: no normal is worked out",
        (false, true) => "id and normal: one normal for a pixel",
        (false, false) => "id alone",
    }
}
