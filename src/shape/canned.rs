use serde::{Deserialize, Serialize};

use crate::film::Samples;
use crate::ray::{Intersection, Ray};
use crate::words::number;

/// An object that knows its intersections with one ray, and no others.
///
/// Question films use it to judge the search for the nearest object without any real shape. It
/// answers with what Mitsuba found for the real object that it replaces.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Canned {
    /// The ray.
    pub ray: Ray,
    /// Everything the ray meets, in increasing t.
    pub intersections: Vec<Intersection>,
}

/// A pixel of a question film can hold at most this many of them.
const MOST_OBJECTS: usize = 6;

impl Canned {
    /// The first intersection with the ray at or beyond `min_t`.
    ///
    /// # Panics
    /// If it is another ray. The message is for the author of the code that asks.
    #[track_caller]
    pub fn intersect(&self, ray: &Ray, min_t: f64) -> Option<Intersection> {
        assert!(
            *ray == self.ray,
            "an object was asked about a ray other than the one given: pass `ray` on unchanged, \
             because t is in multiples of `ray.direction`"
        );
        self.first_from(min_t)
    }

    pub(crate) fn first_from(&self, min_t: f64) -> Option<Intersection> {
        self.intersections
            .iter()
            .find(|found| found.t >= min_t)
            .copied()
    }

    /// Reads all objects of a pixel of a question film.
    pub(crate) fn read_all(samples: Samples<'_>) -> Result<Vec<Canned>, String> {
        let count = samples.count("count")?;
        if count > MOST_OBJECTS {
            return Err(format!(
                "channel `count` holds {count}, more than {MOST_OBJECTS} objects"
            ));
        }
        (0..count).map(|k| Canned::read(samples, k)).collect()
    }

    fn read(samples: Samples<'_>, k: usize) -> Result<Canned, String> {
        let hits = samples.count(&format!("{k}.hits"))?;
        let intersection = |n: usize| {
            Ok(Intersection {
                t: samples.number(&format!("{k}.{n}.t"))?,
                normal: samples.vector(&format!("{k}.{n}.N"))?,
            })
        };
        let intersections = (0..hits).map(intersection).collect::<Result<_, String>>()?;
        Ok(Canned {
            ray: samples.ray()?,
            intersections,
        })
    }

    /// A list of objects in words: "0: 1.5, 2.5; 1: never".
    pub(crate) fn describe_all(objects: &[Canned], digits: usize) -> String {
        let object = |(k, object): (usize, &Canned)| {
            let ts = object.intersections.iter().map(|at| number(at.t, digits));
            match ts.collect::<Vec<_>>().join(", ") {
                ts if ts.is_empty() => format!("{k}: never"),
                ts => format!("{k}: {ts}"),
            }
        };
        let objects: Vec<String> = objects.iter().enumerate().map(object).collect();
        objects.join("; ")
    }
}

#[cfg(test)]
mod tests;
