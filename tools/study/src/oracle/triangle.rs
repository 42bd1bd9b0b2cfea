use super::{Exact, HasTruth, Truth, fraction, sign};
use crate::question::Question;
use crate::shape::Triangle;

impl HasTruth for Triangle<f64> {
    /// Solves e − a = α t₁ + β t₂ − t d by Cramer's rule, in fractions. Edges belong to the
    /// triangle, and a ray that touches one is a tie.
    fn truth(question: &Question<Self>) -> Truth {
        let Question { shape, ray, min_t } = question;
        let [a, b, c] = shape.corners.map(Exact::of);
        let (t1, t2, d) = (b.minus(&a), c.minus(&a), Exact::of(ray.direction));
        let from_a = Exact::of(ray.origin).minus(&a);
        // The determinant |t₁ t₂ −d| is −d·(t₁ × t₂); the others replace one column by e − a.
        let normal = t1.cross(&t2);
        let determinant = -d.dot(&normal);
        if sign(&determinant) == 0 {
            return Truth::miss(false);
        }
        let alpha = d.dot(&t2.cross(&from_a)) / &determinant;
        let beta = d.dot(&from_a.cross(&t1)) / &determinant;
        let rest = fraction(1.0) - &alpha - &beta;
        let signs = [sign(&alpha), sign(&beta), sign(&rest)];
        if signs.contains(&-1) {
            return Truth::miss(false);
        }
        let t = from_a.dot(&normal) / &determinant;
        Truth::only(t, *min_t, signs.contains(&0))
    }
}
