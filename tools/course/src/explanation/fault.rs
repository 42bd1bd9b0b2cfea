//! Which task to read about if a pixel differs from Mitsuba's.

use pinhole::{Hit, Intersection, Kind, Ray, Shape, ShapeKind};

use super::{AnswerResult, PixelExplanation};
use crate::assignment::{Assignment, Task};

/// An explanation calls two numbers different only if they differ by more than this share of
/// themselves, or of 1. To tell closer numbers apart, you need the goldens' tolerances.
const CLEAR: f64 = 1e-3;

impl PixelExplanation {
    /// The first task whose answer is missing or clearly not Mitsuba's.
    pub fn task_at_fault<'a>(
        &self,
        objects: &[Shape],
        assignment: &'a Assignment,
    ) -> Option<&'a Task> {
        let (kind, shape) = self.fault(objects)?;
        assignment.task_of_kind(kind, shape)
    }

    /// Whether there is a ray that is clearly not Mitsuba's.
    pub fn ray_differs(&self) -> bool {
        match (&self.ray, &self.mitsuba) {
            (Ok(ray), Some(mitsuba)) => !same_ray(ray, &mitsuba.ray),
            _ => false,
        }
    }

    /// Whether there is a first hit that is clearly not Mitsuba's.
    pub fn nearest_differs(&self) -> bool {
        match (&self.nearest, &self.mitsuba) {
            (Ok(nearest), Some(mitsuba)) => !same_hit(nearest, &mitsuba.hit),
            _ => false,
        }
    }

    /// The kind of the task at fault, and the shape it intersects if it is of that kind.
    fn fault(&self, objects: &[Shape]) -> Option<(Kind, Option<ShapeKind>)> {
        let of_object = |k: Option<usize>| match k {
            Some(k) => {
                let shape = objects[k].kind();
                (Kind::of_shape(shape), Some(shape))
            }
            None => (Kind::FirstHit, None),
        };
        let mitsuba = self.mitsuba.as_ref()?;
        match &self.ray {
            Ok(ray) if same_ray(ray, &mitsuba.ray) => {}
            _ => return Some((Kind::ViewingRay, None)),
        }
        let Ok(found) = &self.nearest else {
            let silent = self.candidates.iter().position(Result::is_err);
            return Some(of_object(silent));
        };
        if same_hit(found, &mitsuba.hit) {
            return None;
        }
        let lost = |said: &AnswerResult<Option<Hit>>| {
            let hit = said.as_ref().ok().copied().flatten();
            hit.is_some_and(|Hit { intersection, .. }| {
                !(intersection.t.is_finite() && intersection.normal.is_finite())
            })
        };
        if let Some(k) = self.candidates.iter().position(lost) {
            return Some(of_object(Some(k)));
        }
        // The object that should be seen is at fault if its own answer is wrong. Otherwise, the
        // fault lies with an object that claims to be nearer.
        let wrong = match (mitsuba.hit, found) {
            (Some(expected), _) if !self.says(expected) => Some(expected.object),
            (Some(expected), Some(found)) => {
                let nearer = found.intersection.t < expected.intersection.t;
                (nearer && self.says(*found)).then_some(found.object)
            }
            (Some(_), None) => None,
            (None, found) => found.filter(|found| self.says(*found)).map(|it| it.object),
        };
        Some(of_object(wrong))
    }

    /// Whether the object of this hit gives the same answer when it is asked alone.
    fn says(&self, hit: Hit) -> bool {
        let Some(Ok(Some(said))) = self.candidates.get(hit.object) else {
            return false;
        };
        same_intersection(&said.intersection, &hit.intersection)
    }
}

fn near(one: f64, other: f64) -> bool {
    (one - other).abs() <= CLEAR * one.abs().max(1.0)
}

fn same_ray(one: &Ray, other: &Ray) -> bool {
    let length = one.direction.length();
    (one.origin - other.origin).length() <= CLEAR * one.origin.length().max(1.0)
        && (one.direction - other.direction).length() <= CLEAR * length
}

fn same_intersection(one: &Intersection, other: &Intersection) -> bool {
    near(one.t, other.t) && (one.normal - other.normal).length() <= CLEAR
}

fn same_hit(one: &Option<Hit>, other: &Option<Hit>) -> bool {
    match (one, other) {
        (Some(one), Some(other)) => {
            one.object == other.object && same_intersection(&one.intersection, &other.intersection)
        }
        (one, other) => one.is_none() && other.is_none(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::explanation::{Mitsuba, NoAnswer};
    use crate::outcome::FilmOutcome;
    use glam::DVec3;
    use pinhole::{Plane, Sphere};

    const RAY: Ray = Ray {
        origin: DVec3::ZERO,
        direction: DVec3::NEG_Z,
    };

    fn hit(object: usize, t: f64) -> Option<Hit> {
        let normal = DVec3::Z;
        let intersection = Intersection { t, normal };
        Some(Hit {
            object,
            intersection,
        })
    }

    /// A sphere at 2 and a plane at 5, and these answers.
    fn at_fault(
        ray: AnswerResult<Ray>,
        sphere: Option<Hit>,
        first: AnswerResult<Option<Hit>>,
    ) -> Option<(Kind, Option<ShapeKind>)> {
        at_fault_if(hit(0, 2.0), ray, sphere, first)
    }

    /// The same, if this hit is right.
    fn at_fault_if(
        expected: Option<Hit>,
        ray: AnswerResult<Ray>,
        sphere: Option<Hit>,
        first: AnswerResult<Option<Hit>>,
    ) -> Option<(Kind, Option<ShapeKind>)> {
        let objects = [
            Shape::Sphere(Sphere {
                center: DVec3::NEG_Z * 3.0,
                radius: 1.0,
            }),
            Shape::Plane(Plane {
                point: DVec3::NEG_Z * 5.0,
                normal: DVec3::Z,
            }),
        ];
        let explanation = PixelExplanation {
            ray,
            asked: Some(RAY),
            candidates: vec![Ok(sphere), Ok(hit(1, 5.0))],
            nearest: first,
            mitsuba: Some(Mitsuba {
                ray: RAY,
                hit: expected,
            }),
            printed: Default::default(),
        };
        explanation.fault(&objects)
    }

    #[test]
    fn first_wrong_answer_decides_what_to_read() {
        let tilted = Ray {
            direction: DVec3::new(0.1, 0.0, -1.0),
            ..RAY
        };
        let right = Ok(hit(0, 2.0));
        let viewing_ray = Some((Kind::ViewingRay, None));
        let sphere = Some((Kind::Intersect, Some(ShapeKind::Sphere)));
        let first_hit = Some((Kind::FirstHit, None));
        assert_eq!(at_fault(Ok(RAY), hit(0, 2.0), right.clone()), None);
        assert_eq!(at_fault(Ok(tilted), hit(0, 2.0), right), viewing_ray);
        assert_eq!(at_fault(Ok(RAY), None, Ok(hit(1, 5.0))), sphere);
        assert_eq!(at_fault(Ok(RAY), hit(0, 2.0), Ok(hit(1, 5.0))), first_hit);
        assert_eq!(at_fault(Ok(RAY), hit(0, 2.0), Ok(None)), first_hit);
        let lost = || hit(0, f64::NAN);
        assert_eq!(
            at_fault_if(hit(1, 5.0), Ok(RAY), lost(), Ok(lost())),
            sphere
        );
        let unanswered = Err(NoAnswer::Failed(FilmOutcome::Unanswered));
        assert_eq!(at_fault(Ok(RAY), hit(0, 2.0), unanswered), first_hit);
    }
}
