//! The four shapes a ray can meet. How it meets them is the student's work.

use glam::DVec3;
use serde::{Deserialize, Serialize};

use crate::ray::Intersection;

/// All points at distance `radius` from `center`.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Sphere {
    /// World space, scene units.
    pub center: DVec3,
    /// Scene units, positive.
    pub radius: f64,
}

/// All points p with (p − `point`) · `normal` = 0; it has no edge.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Plane {
    /// Any point of the plane; world space, scene units.
    pub point: DVec3,
    /// Perpendicular to the plane, as the scene file has it: **not** unit length in
    /// general, never zero.
    pub normal: DVec3,
}

/// A flat triangle, edges included.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Triangle {
    /// The corners a, b, c, counter-clockwise when seen from outside; world space.
    pub corners: [DVec3; 3],
}

/// Triangles that together are one object.
///
/// Generic over what it holds so that a soup can be judged apart from the
/// triangle: probes fill it with [`Canned`] objects.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct TriangleSoup<T = Triangle> {
    /// In the mesh file's order, which means nothing about distance.
    pub triangles: Vec<T>,
}

/// Any of the four.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum Shape {
    /// See [`Sphere`].
    Sphere(Sphere),
    /// See [`Plane`].
    Plane(Plane),
    /// See [`Triangle`].
    Triangle(Triangle),
    /// See [`TriangleSoup`].
    Soup(TriangleSoup),
}

/// An object whose intersections with one ray are known beforehand.
///
/// Probes use it to judge `first_hit` and the soup without any real shape: whoever
/// asks it gets what Mitsuba found for the real object it stands for.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Canned {
    /// Everything the ray meets, in increasing t.
    pub intersections: Vec<Intersection>,
}

impl Canned {
    /// The first intersection at or beyond `min_t`.
    pub fn intersect(&self, min_t: f64) -> Option<Intersection> {
        self.intersections
            .iter()
            .find(|found| found.t >= min_t)
            .copied()
    }
}

#[cfg(test)]
mod tests;
