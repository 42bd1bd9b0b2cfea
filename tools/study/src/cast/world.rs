//! A scene as a list of parts, each of which a kernel can meet.

use crate::shape::{Plane, Sphere, Triangle};
use crate::vector::Vector;

/// What a ray can meet.
#[derive(Clone, Copy, Debug)]
pub enum Primitive {
    /// See [`Sphere`].
    Sphere(Sphere<f64>),
    /// See [`Plane`].
    Plane(Plane<f64>),
    /// See [`Triangle`].
    Triangle(Triangle<f64>),
}

/// One primitive of a scene.
#[derive(Clone, Copy, Debug)]
pub struct Part {
    /// The object it belongs to: its id in a film.
    pub object: u32,
    /// Its place in the scene. Of two parts met at the very same t, the one listed first
    /// counts.
    pub place: u32,
    /// What is met.
    pub shape: Primitive,
}

/// All parts of a scene.
#[derive(Clone, Debug, Default)]
pub struct World {
    /// A tree may change their order; [`Part::place`] remembers it.
    pub parts: Vec<Part>,
    corners: Corners,
}

/// What is known of all triangles of a scene.
#[derive(Clone, Copy, Debug, Default)]
struct Corners {
    /// Of a box around all corners, where there are any.
    bounds: Option<[Vector<f64>; 2]>,
    /// The largest component of an edge from a first corner.
    edges: f64,
}

/// The same numbers in this package's vector.
pub fn vector(v: glam::DVec3) -> Vector<f64> {
    Vector::new(v.x, v.y, v.z)
}

fn triangle(triangle: &pinhole::Triangle) -> Primitive {
    Primitive::Triangle(Triangle {
        corners: triangle.corners.map(vector),
    })
}

impl World {
    /// Of the objects of a scene.
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
                pinhole::Shape::Triangle(corners) => world.add(object, triangle(corners)),
                pinhole::Shape::Soup(soup) => {
                    for corners in &soup.triangles {
                        world.add(object, triangle(corners));
                    }
                }
            }
        }
        world
    }

    /// The largest component of an edge that leaves a triangle's first corner.
    pub fn edges(&self) -> f64 {
        self.corners.edges
    }

    /// The largest component that leads from a point to a triangle's corner, rounded as
    /// that difference is: rounding keeps order.
    #[inline]
    pub fn away(&self, point: Vector<f64>) -> f64 {
        let corners = self.corners.bounds.into_iter().flatten();
        let away = corners.map(|corner| (point - corner).largest());
        away.fold(0.0, f64::max)
    }

    /// One more part, of an object.
    pub fn add(&mut self, object: usize, shape: Primitive) {
        if let (Primitive::Triangle(triangle), Some(bounds)) = (&shape, shape.bounds()) {
            let [a, b, c] = triangle.corners;
            let edges = (b - a).largest().max((c - a).largest());
            self.corners.edges = self.corners.edges.max(edges);
            let [low, high] = self.corners.bounds.unwrap_or(bounds);
            let by = |pick: fn(f64, f64) -> f64, p: Vector<f64>, q: Vector<f64>| {
                Vector::new(pick(p.x, q.x), pick(p.y, q.y), pick(p.z, q.z))
            };
            let wider = [by(f64::min, low, bounds[0]), by(f64::max, high, bounds[1])];
            self.corners.bounds = Some(wider);
        }
        self.parts.push(Part {
            object: object as u32,
            place: self.parts.len() as u32,
            shape,
        });
    }
}

impl Primitive {
    /// The corners of a box around it; none around a plane.
    pub fn bounds(&self) -> Option<[Vector<f64>; 2]> {
        match self {
            Primitive::Plane(_) => None,
            Primitive::Sphere(Sphere { center, radius }) => {
                let r = Vector::new(*radius, *radius, *radius);
                Some([*center - r, *center + r])
            }
            Primitive::Triangle(Triangle { corners: [a, b, c] }) => {
                let of = |pick: fn(f64, f64) -> f64| {
                    let of = |x, y, z| pick(pick(x, y), z);
                    Vector::new(of(a.x, b.x, c.x), of(a.y, b.y, c.y), of(a.z, b.z, c.z))
                };
                Some([of(f64::min), of(f64::max)])
            }
        }
    }

    /// The unit outward normal at a point of it.
    pub fn normal(&self, point: Vector<f64>) -> Vector<f64> {
        match self {
            Primitive::Sphere(sphere) => sphere.outward(point).unit(),
            Primitive::Plane(plane) => plane.normal.unit(),
            Primitive::Triangle(triangle) => triangle.outward().unit(),
        }
    }
}
