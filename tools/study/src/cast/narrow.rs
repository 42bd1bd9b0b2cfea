//! Casting in `f32`: shapes and rays are rounded to it first, and all that follows is
//! what a renderer in `f32` does.
//!
//! The shapes of a kind lie side by side, half as large as in `f64`, under a tree of their
//! own, which obvhs searches too: its search is in `f32` as well and promises no more than
//! the kernels do. Boxes are a little too large, so that what it loses is little.

use std::time::Duration;

use obvhs::BvhBuildParams;
use obvhs::aabb::Aabb;
use obvhs::bvh2::Bvh2;
use obvhs::bvh2::builder::build_bvh2;
use obvhs::ray::{Ray as BoxRay, RayHit};

use super::Search;
use super::kernels::{Kernels, Prepared};
use super::world::{Part, Primitive};
use crate::kernel::Kernel;
use crate::kernel::sphere::Scaled;
use crate::number::Real;
use crate::shape::{Plane, Ray, Shape, Sphere, Triangle};
use crate::vector::Vector;

/// A scene in `f32`.
#[derive(Clone, Default)]
pub struct Narrow {
    spheres: Kind<Sphere<f32>>,
    planes: Kind<Plane<f32>>,
    triangles: Kind<Triangle<f32>>,
}

/// All shapes of a kind.
#[derive(Clone)]
struct Kind<S> {
    /// In the order of the tree.
    shapes: Vec<S>,
    /// Of each, [`Part::place`].
    places: Vec<u32>,
    tree: Bvh2,
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
            Met::Triangle(shape) => shape.outward().unit(),
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
        let prepared = Prepared::<f32, K>::new(ray);
        let (sphere, triangle) = (&prepared.sphere, &prepared.triangle);
        let mut near = None;
        self.planes
            .all::<K::Plane>(&prepared.plane, min_t, Met::Plane, &mut near);
        match search {
            Search::BruteForce => {
                self.spheres
                    .all::<K::Sphere>(sphere, min_t, Met::Sphere, &mut near);
                self.triangles
                    .all::<K::Triangle>(triangle, min_t, Met::Triangle, &mut near);
            }
            Search::Boxes => {
                let scaled = Scaled::new(ray);
                self.spheres
                    .boxed::<K::Sphere>(sphere, &scaled, min_t, Met::Sphere, &mut near);
                self.triangles.boxed::<K::Triangle>(
                    triangle,
                    &scaled,
                    min_t,
                    Met::Triangle,
                    &mut near,
                );
            }
        }
        near
    }
}

impl<S> Default for Kind<S> {
    fn default() -> Kind<S> {
        Kind {
            shapes: Vec::new(),
            places: Vec::new(),
            tree: Bvh2::default(),
        }
    }
}

impl<S> Kind<S> {
    fn new<W>(parts: &[(u32, W)], primitive: fn(W) -> Primitive) -> Kind<S>
    where
        W: Shape<With<f32> = S>,
    {
        let boxes: Option<Vec<Aabb>> = parts.iter().map(|part| room(primitive(part.1))).collect();
        let tree = match boxes {
            Some(boxes) if !boxes.is_empty() => {
                let medium = BvhBuildParams::medium_build();
                build_bvh2(&boxes, medium, &mut Duration::default())
            }
            _ => Bvh2::default(),
        };
        let as_given = 0..parts.len() as u32;
        let order = match tree.primitive_indices.is_empty() {
            true => as_given.collect(),
            false => tree.primitive_indices.clone(),
        };
        let ordered = || order.iter().map(|at| &parts[*at as usize]);
        Kind {
            shapes: ordered().map(|part| part.1.map(f32::of, f32::of)).collect(),
            places: ordered().map(|part| part.0).collect(),
            tree,
        }
    }

    /// Where one is met, if that is before what was met so far.
    #[inline(always)]
    fn meet<'a, K: Kernel<S, f32>>(
        &'a self,
        at: usize,
        ray: &K::Prepared,
        min_t: f32,
        met: fn(&'a S) -> Met<'a>,
        near: &mut Option<Near<'a>>,
    ) {
        let Some(t) = K::intersect(&self.shapes[at], ray, min_t) else {
            return;
        };
        let place = self.places[at];
        if near.is_none_or(|near| (t, place) < (near.t, near.place)) {
            let shape = met(&self.shapes[at]);
            *near = Some(Near { t, place, shape });
        }
    }

    #[inline(always)]
    fn all<'a, K: Kernel<S, f32>>(
        &'a self,
        ray: &K::Prepared,
        min_t: f32,
        met: fn(&'a S) -> Met<'a>,
        near: &mut Option<Near<'a>>,
    ) {
        for at in 0..self.shapes.len() {
            self.meet::<K>(at, ray, min_t, met, near);
        }
    }

    #[inline(always)]
    fn boxed<'a, K: Kernel<S, f32>>(
        &'a self,
        ray: &K::Prepared,
        scaled: &Scaled<f32>,
        min_t: f32,
        met: fn(&'a S) -> Met<'a>,
        near: &mut Option<Near<'a>>,
    ) {
        if self.tree.nodes.is_empty() {
            return self.all::<K>(ray, min_t, met, near);
        }
        let horizon = |near: &Option<Near>| {
            let beyond = near.map_or(f32::MAX, |near| scaled.scale(near.t.next_up()));
            beyond.min(f32::MAX)
        };
        let [origin, direction] = [scaled.ray.origin, scaled.ray.direction].map(Vector::array);
        let line = BoxRay::new(origin.into(), direction.into(), 0.0, horizon(near));
        self.tree.ray_traverse(line, &mut RayHit::none(), |_, at| {
            self.meet::<K>(at, ray, min_t, met, near);
            horizon(near)
        });
    }
}

/// A box around it, larger by what rounding the shape and the ray may move them.
fn room(shape: Primitive) -> Option<Aabb> {
    let [low, high] = shape.bounds()?;
    let spare = 8.0 * f32::EPSILON * low.largest().max(high.largest()) as f32;
    let low = low.map(|x| (x as f32 - spare).next_down()).array();
    let high = high.map(|x| (x as f32 + spare).next_up()).array();
    let is_finite = low.iter().chain(&high).all(|x| x.abs() < f32::MAX);
    is_finite.then(|| Aabb::new(low.into(), high.into()))
}
