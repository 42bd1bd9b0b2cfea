//! Casting in `f32`: shapes and rays are rounded to it first, and all that follows is
//! what a renderer in `f32` does.
//!
//! The shapes of a kind lie side by side, half as large as in `f64`, under a tree of their
//! own. Its search is in `f32` too, and promises no more than the kernels do: boxes are
//! a little too large, so that what it loses is little.

use std::time::Duration;

use glam::Vec3A;
use obvhs::BvhBuildParams;
use obvhs::aabb::Aabb;
use obvhs::bvh2::Bvh2;
use obvhs::bvh2::builder::build_bvh2;
use smallvec::SmallVec;

use super::Search;
use super::eight::{EIGHT, Sifted};
use super::kernels::{Kernels, Prepared};
use super::world::{Part, Primitive};
use crate::kernel::Kernel;
use crate::kernel::sphere::Scaled;
use crate::number::Real;
use crate::shape::{Plane, Ray, Shape, Sphere, Triangle};
use crate::vector::Vector;

/// A scene in `f32`.
#[derive(Default)]
pub struct Narrow {
    spheres: Kind<Sphere<f32>>,
    planes: Kind<Plane<f32>>,
    triangles: Kind<Triangle<f32>>,
}

/// All shapes of a kind.
struct Kind<S: Sifted> {
    /// In the order of the tree.
    shapes: Vec<S>,
    /// The same, eight in a row.
    rows: Vec<S::Rows>,
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

/// Fewer than this are sooner asked one by one than eight at a time.
const FEW: usize = 4;

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

impl<S: Sifted> Default for Kind<S> {
    fn default() -> Kind<S> {
        Kind {
            shapes: Vec::new(),
            rows: Vec::new(),
            places: Vec::new(),
            tree: Bvh2::default(),
        }
    }
}

impl<S: Sifted> Kind<S> {
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
        let shapes: Vec<S> = ordered().map(|part| part.1.map(f32::of, f32::of)).collect();
        Kind {
            rows: shapes.chunks(EIGHT).map(S::rows).collect(),
            shapes,
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
        ray: &Ray<f32>,
        prepared: &K::Prepared,
        min_t: f32,
        met: fn(&'a S) -> Met<'a>,
        near: &mut Option<Near<'a>>,
    ) {
        if self.shapes.len() < FEW {
            return (0..self.shapes.len()).for_each(|at| {
                self.meet::<K>(at, prepared, min_t, met, near);
            });
        }
        for (chunk, rows) in self.rows.iter().enumerate() {
            let margins = S::margins(rows, ray);
            if !margins.iter().any(|margin| *margin >= 0.0) {
                continue;
            }
            for (lane, margin) in margins.into_iter().enumerate() {
                let at = chunk * EIGHT + lane;
                if margin >= 0.0 && at < self.shapes.len() {
                    self.meet::<K>(at, prepared, min_t, met, near);
                }
            }
        }
    }

    #[inline(always)]
    fn boxed<'a, K: Kernel<S, f32>>(
        &'a self,
        ray: &Ray<f32>,
        prepared: &K::Prepared,
        min_t: f32,
        met: fn(&'a S) -> Met<'a>,
        near: &mut Option<Near<'a>>,
    ) {
        if self.shapes.len() <= EIGHT || self.tree.nodes.is_empty() {
            return self.all::<K>(ray, prepared, min_t, met, near);
        }
        let slabs = Slabs::of(ray, min_t);
        let nodes = &self.tree.nodes;
        let mut waiting: SmallVec<[(u32, f32); 64]> = SmallVec::new();
        let mut beyond = slabs.horizon(near);
        let mut next = (0, slabs.enters(nodes[0].aabb(), beyond));
        loop {
            let (at, entry) = next;
            let node = &nodes[at as usize];
            if entry <= beyond {
                let first = node.first_index;
                if node.prim_count == 0 {
                    let [one, other] = [first, first + 1]
                        .map(|at| (at, slabs.enters(nodes[at as usize].aabb(), beyond)));
                    let (nearer, further) = match one.1 <= other.1 {
                        true => (one, other),
                        false => (other, one),
                    };
                    if further.1 <= beyond {
                        waiting.push(further);
                    }
                    next = nearer;
                    continue;
                }
                for at in first..first + node.prim_count {
                    self.meet::<K>(at as usize, prepared, min_t, met, near);
                }
                beyond = slabs.horizon(near);
            }
            match waiting.pop() {
                None => return,
                Some(one) => next = one,
            }
        }
    }
}

/// What is needed of a ray to say which boxes it meets.
struct Slabs {
    scaled: Scaled<f32>,
    origin: Vec3A,
    inverse: Vec3A,
    from: f32,
}

/// Both ends of a slab are off by 3u of themselves at most.
const ROOM: f32 = 1.0 + 4.0 * f32::EPSILON;

impl Slabs {
    #[inline(always)]
    fn of(ray: &Ray<f32>, min_t: f32) -> Slabs {
        let scaled = Scaled::new(ray);
        let inverse = |d: f32| if d == 0.0 { f32::MAX } else { 1.0 / d };
        Slabs {
            origin: scaled.ray.origin.array().into(),
            inverse: scaled.ray.direction.map(inverse).array().into(),
            from: scaled.scale(min_t),
            scaled,
        }
    }

    /// What lies beyond it cannot be first.
    #[inline(always)]
    fn horizon(&self, near: &Option<Near>) -> f32 {
        let beyond = near.map_or(f32::MAX, |near| self.scaled.scale(near.t) * ROOM);
        beyond.min(f32::MAX)
    }

    /// Where a ray enters a box, or infinity.
    #[inline(always)]
    fn enters(&self, room: &Aabb, beyond: f32) -> f32 {
        let low = (room.min - self.origin) * self.inverse;
        let high = (room.max - self.origin) * self.inverse;
        let near = low.min(high).max_element();
        let near = if near > self.from { near } else { self.from };
        let far = low.max(high).min_element() * ROOM;
        match near <= far && near <= beyond {
            true => near,
            false => f32::INFINITY,
        }
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
