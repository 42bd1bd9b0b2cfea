//! Casting in `f32`: shapes and rays are rounded to it first, and all that follows is
//! what a renderer in `f32` does.
//!
//! The shapes of a kind lie side by side, half as large as in `f64`, under a tree of their
//! own. Its search is in `f32` too, and promises no more than the kernels do: boxes are
//! a little too large, so that what it loses is little.

mod kind;
mod slabs;

use super::Search;
use super::kernels::{Kernels, Prepared};
use super::world::{Part, Primitive};
use crate::number::Real;
use crate::shape::{Plane, Ray, Sphere, Triangle};
use crate::vector::Vector;
use kind::Kind;

/// A scene in `f32`.
#[derive(Default)]
pub struct Narrow {
    spheres: Kind<Sphere<f32>>,
    planes: Kind<Plane<f32>>,
    triangles: Kind<Triangle<f32>>,
}

/// What a ray meets first.
#[derive(Clone, Copy, Debug)]
pub struct Near<'a> {
    /// In multiples of the ray's direction.
    pub t: f32,
    /// [`Part::place`] of what is met.
    pub place: u32,
    shape: Met<'a>,
}

#[derive(Clone, Copy, Debug)]
enum Met<'a> {
    Sphere(&'a Sphere<f32>),
    Plane(&'a Plane<f32>),
    Triangle(&'a Triangle<f32>),
}

impl Near<'_> {
    /// The unit outward normal, in `f32` too.
    pub fn normal(&self, ray: &Ray<f32>) -> Vector<f32> {
        match self.shape {
            Met::Sphere(shape) => shape.outward(ray.origin + ray.direction * self.t).unit(),
            Met::Plane(shape) => shape.normal.unit(),
            Met::Triangle(shape) => shape.normal(),
        }
    }
}

/// A ray in `f32`.
pub fn rounded(ray: &Ray<f64>) -> Ray<f32> {
    ray.map(f32::of, f32::of)
}

impl Narrow {
    /// Of these parts.
    pub fn new<'a>(parts: impl Iterator<Item = &'a Part>) -> Narrow {
        let (mut spheres, mut planes, mut triangles) = (Vec::new(), Vec::new(), Vec::new());
        for Part { place, shape, .. } in parts {
            match shape {
                Primitive::Sphere(shape) => spheres.push((*place, *shape)),
                Primitive::Plane(shape) => planes.push((*place, *shape)),
                Primitive::Triangle(shape) => triangles.push((*place, *shape)),
            }
        }
        Narrow {
            spheres: Kind::new(&spheres, Primitive::Sphere),
            planes: Kind::new(&planes, Primitive::Plane),
            triangles: Kind::new(&triangles, Primitive::Triangle),
        }
    }

    /// What a ray meets first, from `min_t` on.
    #[inline]
    pub fn first<K: Kernels<f32>>(
        &self,
        search: Search,
        ray: &Ray<f32>,
        min_t: f32,
    ) -> Option<Near<'_>> {
        let Prepared {
            sphere,
            plane,
            triangle,
        } = &Prepared::<f32, K>::new(ray);
        let (spheres, planes, triangles) = (&self.spheres, &self.planes, &self.triangles);
        let mut near = None;
        planes.all::<K::Plane>(ray, plane, min_t, Met::Plane, &mut near);
        match search {
            Search::BruteForce => {
                spheres.all::<K::Sphere>(ray, sphere, min_t, Met::Sphere, &mut near);
                triangles.all::<K::Triangle>(ray, triangle, min_t, Met::Triangle, &mut near);
            }
            Search::Boxes => {
                spheres.boxed::<K::Sphere>(ray, sphere, min_t, Met::Sphere, &mut near);
                triangles.boxed::<K::Triangle>(ray, triangle, min_t, Met::Triangle, &mut near);
            }
        }
        near
    }
}
