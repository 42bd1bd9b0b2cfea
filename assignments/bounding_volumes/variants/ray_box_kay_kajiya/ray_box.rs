use glam::DVec3;
use pinhole::{BoundingBox, Ray};

/// All points x with `low` ≤ `normal` · x ≤ `high` (Kay & Kajiya 1986).
struct Slab {
    normal: DVec3,
    low: f64,
    high: f64,
}

impl Slab {
    /// The part of `interval` in which a ray is in the slab.
    fn clip(&self, ray: &Ray, [enter, leave]: [f64; 2]) -> Option<[f64; 2]> {
        let start = self.normal.dot(ray.origin);
        let speed = self.normal.dot(ray.direction);
        if speed == 0.0 {
            let between = self.low <= start && start <= self.high;
            return between.then_some([enter, leave]);
        }
        let (low, high) = ((self.low - start) / speed, (self.high - start) / speed);
        let (near, far) = if speed > 0.0 {
            (low, high)
        } else {
            (high, low)
        };
        let clipped = [enter.max(near), leave.min(far)];
        (clipped[0] <= clipped[1]).then_some(clipped)
    }
}

pub fn ray_box(bounds: &BoundingBox, ray: &Ray, min_t: f64, max_t: f64) -> Option<f64> {
    let mut interval = [min_t, max_t];
    for normal in DVec3::AXES {
        let slab = Slab {
            normal,
            low: normal.dot(bounds.min),
            high: normal.dot(bounds.max),
        };
        interval = slab.clip(ray, interval)?;
    }
    Some(interval[0])
}
