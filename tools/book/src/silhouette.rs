//! The silhouette of one sphere from far away, decided in three ways.
//!
//! The unit sphere stands at distance `far` on the axis; a ray leaves the origin through
//! (x, y, far). However far it is, the picture should stay the same. These are no
//! solutions of the sphere's task: the ray is given, and nobody asks for t.

/// Whether the ray through (x, y, far) meets the sphere.
pub type Meets = fn(f64, f64, f64) -> bool;

/// The ways, by the names that values have.
pub const WAYS: [(&str, Meets); 3] = [("f32", in_f32), ("f64", in_f64), ("foot", from_the_foot)];

/// The distances, in radii, that the book shows.
pub const DISTANCES: [f64; 6] = [1e1, 1e3, 1e5, 1e7, 1e8, 1e9];

/// Pixels of a silhouette's side.
pub const SIDE: u32 = 40;

/// The middle of a pixel, from −1.2 to 1.2 radii.
pub fn on(k: u32) -> f64 {
    (f64::from(k) + 0.5) / f64::from(SIDE) * 2.4 - 1.2
}

/// In how many pixels a way is wrong.
///
/// The truth is that the ray passes the centre at most a radius away: far² (x² + y²) ≤
/// x² + y² + far². No two of these sums are near each other, for no pixel's middle lies
/// near the outline, so that an `f64` decides it.
pub fn wrong(meets: Meets, far: f64) -> usize {
    let pixels = (0..SIDE).flat_map(|i| (0..SIDE).map(move |j| (on(i), on(j))));
    let truth = |x: f64, y: f64| {
        let aside = x * x + y * y;
        aside * (1.0 - 1.0 / (far * far)) <= 1.0
    };
    pixels
        .filter(|(x, y)| meets(*x, *y, far) != truth(*x, *y))
        .count()
}

/// The textbook's discriminant.
fn in_f64(x: f64, y: f64, far: f64) -> bool {
    let (a, h, k) = (x * x + y * y + far * far, -far * far, far * far - 1.0);
    h * h - a * k >= 0.0
}

/// The same in single precision.
fn in_f32(x: f64, y: f64, far: f64) -> bool {
    let (x, y, far) = (x as f32, y as f32, far as f32);
    let (a, h, k) = (x * x + y * y + far * far, -far * far, far * far - 1.0);
    h * h - a * k >= 0.0
}

/// From the foot of the perpendicular (Haines, Günther & Akenine-Möller 2019).
fn from_the_foot(x: f64, y: f64, far: f64) -> bool {
    let a = x * x + y * y + far * far;
    let t = far * far / a;
    let foot = [t * x, t * y, t * far - far];
    1.0 - foot.iter().map(|part| part * part).sum::<f64>() >= 0.0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn near_a_sphere_all_ways_agree_and_far_away_only_the_foot_is_right() {
        for (name, meets) in WAYS {
            assert_eq!(wrong(meets, 10.0), 0, "{name}");
        }
        let [single, double, foot] = WAYS.map(|(_, meets)| wrong(meets, 1e9));
        assert!(single > 100 && double > 100, "{single} {double}");
        assert_eq!(foot, 0);
    }
}
