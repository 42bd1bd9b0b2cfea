//! The silhouette of one sphere from far away, computed in three ways.
//!
//! The unit sphere is at distance `far` from the origin, where the rays begin. Each ray leads to
//! a point (x, y) of the plane through the centre. However large the distance, the picture should
//! stay the same. None of the ways solves the sphere's task, because none computes t.

use glam::{DVec3, dvec3};

/// The direction from the origin to the sphere, and the two axes of the picture. They are not
/// axes of space, because many roundings happen to be exact along those.
const AXIS: DVec3 = dvec3(0.36, 0.48, 0.8);
const RIGHT: DVec3 = dvec3(0.8, -0.6, 0.0);
const UP: DVec3 = dvec3(0.48, 0.64, -0.6);

/// Whether the ray to (x, y) meets the sphere at distance `far`.
pub type Meets = fn(f64, f64, f64) -> bool;

/// The three ways, by their names in the book's values.
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
/// The truth is that the line passes the centre at a distance of at most one radius: far² (x² +
/// y²) ≤ x² + y² + far². The two sides are never close, because no pixel's middle is near the
/// outline, so an `f64` decides it.
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

fn ray_to(x: f64, y: f64, center: DVec3) -> DVec3 {
    center + x * RIGHT + y * UP
}

/// The textbook's discriminant.
fn in_f64(x: f64, y: f64, far: f64) -> bool {
    let center = far * AXIS;
    let (d, m) = (ray_to(x, y, center), -center);
    let (a, h, k) = (d.dot(d), d.dot(m), m.dot(m) - 1.0);
    h * h - a * k >= 0.0
}

/// The textbook's discriminant in single precision, including the data.
fn in_f32(x: f64, y: f64, far: f64) -> bool {
    let center = (far * AXIS).as_vec3();
    let (d, m) = (ray_to(x, y, center.as_dvec3()).as_vec3(), -center);
    let (a, h, k) = (d.dot(d), d.dot(m), m.dot(m) - 1.0);
    h * h - a * k >= 0.0
}

/// From the foot of the perpendicular (Haines, Günther & Akenine-Möller 2019).
fn from_the_foot(x: f64, y: f64, far: f64) -> bool {
    let center = far * AXIS;
    let (d, m) = (ray_to(x, y, center), -center);
    let foot = m - d.dot(m) / d.dot(d) * d;
    1.0 - foot.dot(foot) >= 0.0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn near_a_sphere_all_ways_agree_and_far_away_only_the_foot_of_the_perpendicular_is_right() {
        for (name, meets) in WAYS {
            assert_eq!(wrong(meets, 10.0), 0, "{name}");
        }
        let [single, double, foot] = WAYS.map(|(_, meets)| wrong(meets, 1e9));
        assert!(single > 100 && double > 100, "{single} {double}");
        assert_eq!(foot, 0);
    }
}
