use super::{Exact, HasTruth, Truth, sign};
use crate::question::Question;
use crate::shape::Plane;

impl HasTruth for Plane<f64> {
    /// t = n·(p − e) / n·d; a miss if n·d is exactly 0.
    fn truth(question: &Question<Self>) -> Truth {
        let Question { shape, ray, min_t } = question;
        let normal = Exact::of(shape.normal);
        let along = normal.dot(&Exact::of(ray.direction));
        let height = normal.dot(&Exact::of(shape.point).minus(&Exact::of(ray.origin)));
        if sign(&along) == 0 {
            return Truth::miss(sign(&height) == 0);
        }
        Truth::only(height / along, *min_t, false)
    }
}
