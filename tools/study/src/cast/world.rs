//! A scene as a list of parts, each of which a kernel can intersect.

use super::reach::Reach;
use crate::kernel::{Limits, plane, sphere, triangle};
use crate::shape::{Plane, Ray, Sphere, Triangle};
use crate::vector::{Vector, around};

/// A shape that a kernel can intersect.
#[derive(Clone, Copy, Debug)]
pub enum Primitive {
    /// See [`Sphere`].
    Sphere(Sphere<f64>),
    /// See [`Plane`].
    Plane(Plane<f64>),
    /// See [`Triangle`].
    Triangle(Triangle<f64>),
}

impl From<Sphere<f64>> for Primitive {
    fn from(sphere: Sphere<f64>) -> Primitive {
        Primitive::Sphere(sphere)
    }
}

impl From<Plane<f64>> for Primitive {
    fn from(plane: Plane<f64>) -> Primitive {
        Primitive::Plane(plane)
    }
}

impl From<Triangle<f64>> for Primitive {
    fn from(triangle: Triangle<f64>) -> Primitive {
        Primitive::Triangle(triangle)
    }
}

/// One primitive of a scene.
#[derive(Clone, Copy, Debug)]
pub struct Part {
    /// The object it belongs to: the id in a film.
    pub object: u32,
    /// Its index in the scene's list. If a ray hits two parts at exactly the same t, the one
    /// listed first wins.
    pub place: u32,
    /// Its shape.
    pub shape: Primitive,
    /// The filters' limits for rays from within [`World::reach`].
    pub limits: Limits,
}

/// All parts of a scene.
#[derive(Clone, Debug, Default)]
pub struct World {
    /// The tree may reorder them; [`Part::place`] keeps the original index.
    pub parts: Vec<Part>,
    /// The region that most rays are assumed to start in.
    pub reach: Reach,
}

/// Converts glam's vector to this package's.
pub fn vector(v: glam::DVec3) -> Vector<f64> {
    Vector::new(v.x, v.y, v.z)
}

fn corners_of(triangle: &pinhole::Triangle) -> Primitive {
    Primitive::Triangle(Triangle {
        corners: triangle.corners.map(vector),
    })
}

impl World {
    /// Collects the parts of a scene's objects.
    ///
    /// # Panics
    /// If an object has no kernel; [`read`](crate::scenes::read) rejects such scenes.
    pub fn of(objects: &[pinhole::Shape]) -> World {
        let mut world = World::default();
        for (object, shape) in objects.iter().enumerate() {
            match shape {
                pinhole::Shape::Sphere(sphere) => {
                    let (center, radius) = (vector(sphere.center), sphere.radius);
                    world.add(object, Primitive::Sphere(Sphere { center, radius }));
                }
                pinhole::Shape::Plane(plane) => {
                    let (point, normal) = (vector(plane.point), vector(plane.normal));
                    world.add(object, Primitive::Plane(Plane { point, normal }));
                }
                pinhole::Shape::Triangle(corners) => world.add(object, corners_of(corners)),
                pinhole::Shape::Soup(soup) => {
                    for corners in &soup.triangles {
                        world.add(object, corners_of(corners));
                    }
                }
                other => unreachable!("a scene with a {} should have been rejected", other.kind()),
            }
        }
        world
    }

    /// Computes the filters' limits of all parts. Call it when the list is complete.
    pub fn settle(&mut self) {
        self.reach = Reach::around(&self.parts);
        for part in &mut self.parts {
            let away = self.reach.away(part.shape.anchor());
            part.limits = match &part.shape {
                Primitive::Sphere(shape) => sphere::limits(shape, away),
                Primitive::Plane(shape) => plane::limits(shape, away),
                Primitive::Triangle(shape) => triangle::limits(triangle::size(shape), away),
            };
        }
    }

    /// Adds a part of an object.
    pub fn add(&mut self, object: usize, shape: Primitive) {
        self.parts.push(Part {
            object: object as u32,
            place: self.parts.len() as u32,
            shape,
            limits: Limits::default(),
        });
    }
}

/// The names of all kinds of primitives.
pub const KINDS: [&str; 3] = ["sphere", "plane", "triangle"];

impl Primitive {
    /// Its kind, one of [`KINDS`].
    pub fn kind(&self) -> &'static str {
        match self {
            Primitive::Sphere(_) => KINDS[0],
            Primitive::Plane(_) => KINDS[1],
            Primitive::Triangle(_) => KINDS[2],
        }
    }

    /// The point that kernels subtract from a ray's origin: a sphere's centre, a plane's point
    /// or a triangle's first corner.
    pub fn anchor(&self) -> Vector<f64> {
        match self {
            Primitive::Sphere(sphere) => sphere.center,
            Primitive::Plane(plane) => plane.point,
            Primitive::Triangle(triangle) => triangle.corners[0],
        }
    }

    /// Two opposite corners of its bounding box; `None` for a plane.
    pub fn bounds(&self) -> Option<[Vector<f64>; 2]> {
        match self {
            Primitive::Plane(_) => None,
            Primitive::Sphere(Sphere { center, radius }) => {
                let r = Vector::new(*radius, *radius, *radius);
                let [low, high] = [*center - r, *center + r];
                // Widen by one ulp, to make up for the rounding.
                Some([low.map(f64::next_down), high.map(f64::next_up)])
            }
            Primitive::Triangle(triangle) => around(triangle.corners.map(|corner| [corner; 2])),
        }
    }

    /// The unit outward normal at a hit, computed with rounding. For a sphere, the hit is
    /// computed relative to the centre, so that it keeps its digits far from the world's
    /// origin.
    pub fn normal(&self, ray: &Ray<f64>, t: f64) -> Vector<f64> {
        match self {
            Primitive::Sphere(sphere) => (ray.origin - sphere.center + ray.direction * t).unit(),
            Primitive::Plane(plane) => plane.normal.unit(),
            Primitive::Triangle(triangle) => triangle.outward_near_one().unit(),
        }
    }
}
