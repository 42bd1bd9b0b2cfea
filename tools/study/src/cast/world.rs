//! A scene as a list of parts, each of which a kernel can intersect.

use pinhole::{Hit, Intersection};

use super::bounds::required_t;
use crate::kernel::sphere::SphereFromEye;
use crate::kernel::triangle::TriangleFromCamera;
use crate::kernel::{Camera, Filtered, Limits, ScaledQuery, plane};
use crate::number::{ROOT_OF_UNIT, U};
use crate::shape::{Plane, Ray, Shape, Sphere, Triangle};
use crate::vector::{Vector, around};

/// A shape that a kernel can intersect.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Primitive {
    /// See [`Sphere`].
    Sphere(Sphere<f64>),
    /// See [`Plane`].
    Plane(Plane<f64>),
    /// See [`Triangle`].
    Triangle(Triangle<f64>),
}

/// Evaluates an expression for the shape in a [`Primitive`], of whatever type it is.
macro_rules! of_each {
    ($primitive:expr, $shape:ident => $result:expr) => {
        match $primitive {
            Primitive::Sphere($shape) => $result,
            Primitive::Plane($shape) => $result,
            Primitive::Triangle($shape) => $result,
        }
    };
}
pub(crate) use of_each;

macro_rules! into_primitive {
    ($($shape:ident)*) => {$(
        impl From<$shape<f64>> for Primitive {
            fn from(shape: $shape<f64>) -> Primitive {
                Primitive::$shape(shape)
            }
        }
    )*};
}
into_primitive!(Sphere Plane Triangle);

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
    /// The filters' limits for the rays of the camera.
    pub limits: Limits,
    /// The constants for the rays of the camera, if there is one.
    pub from_camera: Option<PartFromCamera>,
    /// Which of its hits are accurate enough.
    pub accurate: Accurate,
}

impl Part {
    /// The filter's answer for a ray, of which q is what the camera does not fix; `None` if
    /// rounding might have changed the answer.
    #[inline(always)]
    pub fn filtered<const HAS_EYE: bool>(
        &self,
        q: Vector<f64>,
        query: &ScaledQuery,
    ) -> Option<Option<f64>> {
        let limits = &self.limits;
        match &self.from_camera {
            Some(PartFromCamera::Sphere(sphere)) => sphere.filtered(query, limits),
            Some(PartFromCamera::Plane(normal, height)) => {
                plane::at_height(*normal, *height, query, limits)
            }
            Some(PartFromCamera::Triangle(triangle)) => {
                triangle.filtered::<HAS_EYE>(q, query, limits)
            }
            None => of_each!(&self.shape, shape => shape.filtered(query, limits)),
        }
    }

    /// A hit of this part, as the harness writes it to a film.
    #[inline(always)]
    pub fn hit(&self, t: f64, normal: Vector<f64>) -> Hit {
        let normal = normal.into();
        Hit {
            object: self.object as usize,
            intersection: Intersection { t, normal },
        }
    }
}

/// The constants of a part for the rays of one camera.
#[derive(Clone, Copy, Debug)]
pub enum PartFromCamera {
    /// See [`SphereFromEye`].
    Sphere(SphereFromEye),
    /// Its normal n, and n·(p − e).
    Plane(Vector<f64>, f64),
    /// See [`TriangleFromCamera`].
    Triangle(TriangleFromCamera),
}

impl PartFromCamera {
    /// The constants of a shape; `None` if they might overflow, or if there are none.
    fn new(shape: &Primitive, camera: &Camera) -> Option<PartFromCamera> {
        Some(match shape {
            Primitive::Sphere(sphere) => {
                PartFromCamera::Sphere(SphereFromEye::new(sphere, camera.eye()?)?)
            }
            Primitive::Plane(plane) => {
                let height = plane.normal.dot(plane.point - camera.eye()?);
                PartFromCamera::Plane(plane.normal, height)
            }
            Primitive::Triangle(triangle) => {
                PartFromCamera::Triangle(TriangleFromCamera::new(triangle, camera))
            }
        })
    }
}

/// The camera whose rays are cast, and how accurate its hits are to be.
#[derive(Clone, Copy)]
pub struct View {
    /// The camera.
    pub camera: Camera,
    /// The largest relative error that t may have, and the largest angle of a normal in radians.
    pub accuracy: f64,
}

/// Which hits of a part are as accurate as a [`View`] requires.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Accurate {
    /// No hit is certain to be.
    Never,
    /// The hits that the camera's filter decides.
    IfFiltered,
    /// All hits.
    Always,
}

/// All parts of a scene.
#[derive(Clone, Debug, Default)]
pub struct World {
    /// The tree may reorder them; [`Part::place`] keeps the original index.
    pub parts: Vec<Part>,
    /// The camera whose rays are cast exactly; `None` if rays are cast in plain `f64`.
    pub camera: Option<Camera>,
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

/// Bound on the relative error of the exact caster's t: twice the √u that
/// [`Adaptive`](crate::kernel::Adaptive) promises, which covers the final division and scaling.
pub const PROVEN_T: f64 = 2.0 * ROOT_OF_UNIT;

/// Bound on the relative error of t by the rounding of a filter's final operations.
const OF_OPERATIONS: f64 = 16.0 * U;

/// A filter for smaller errors would hardly decide any hit.
const LEAST_REQUIRED: f64 = 64.0 * U;

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
                    world.parts.reserve(soup.triangles.len());
                    for corners in &soup.triangles {
                        world.add(object, corners_of(corners));
                    }
                }
                other => unreachable!("a scene with a {} should have been rejected", other.kind()),
            }
        }
        world
    }

    /// Computes the filters' limits of all parts, and their constants for the camera. Call it when
    /// the list is complete.
    pub fn settle(&mut self, view: View) {
        self.camera = Some(view.camera);
        for part in &mut self.parts {
            let away = view.camera.away(part.shape.anchor());
            let distance = view.camera.distance(part.shape.anchor());
            let required = required_t(&part.shape, distance, view.accuracy);
            part.accurate = match required {
                PROVEN_T.. => Accurate::Always,
                LEAST_REQUIRED.. => Accurate::IfFiltered,
                _ => Accurate::Never,
            };
            let accuracy = match part.accurate {
                Accurate::IfFiltered => (required - OF_OPERATIONS).min(ROOT_OF_UNIT),
                _ => ROOT_OF_UNIT,
            };
            part.limits = of_each!(&part.shape, shape => shape.limits(away, distance, accuracy));
            part.from_camera = PartFromCamera::new(&part.shape, &view.camera);
            let limits = &mut part.limits;
            if let Some(PartFromCamera::Sphere(sphere)) = &part.from_camera {
                let divisor = sphere.divisor(distance, accuracy, limits);
                limits.divisor = limits.divisor.min(divisor);
            }
            if let Primitive::Triangle(triangle) = &part.shape {
                *limits = TriangleFromCamera::limits(triangle, away, accuracy, *limits);
            }
        }
    }

    /// Adds a part of an object.
    pub fn add(&mut self, object: usize, shape: Primitive) {
        self.parts.push(Part {
            object: object as u32,
            place: self.parts.len() as u32,
            shape,
            // With these limits, the filters decide nothing. `settle` computes the real ones.
            limits: Limits {
                sign: f64::INFINITY,
                divisor: f64::INFINITY,
                dividend: f64::INFINITY,
            },
            from_camera: None,
            accurate: Accurate::Never,
        });
    }
}

impl Primitive {
    /// Its kind, such as `sphere`.
    pub fn kind(&self) -> &'static str {
        fn name<S: Shape>(_: &S) -> &'static str {
            S::NAME
        }
        of_each!(self, shape => name(shape))
    }

    /// The point that kernels subtract from a ray's origin: a sphere's centre, a plane's point
    /// or a triangle's first corner.
    pub fn anchor(&self) -> Vector<f64> {
        of_each!(self, shape => shape.anchor())
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
            _ => self.flat_normal(),
        }
    }

    /// The unit normal of a plane or a triangle, computed with rounding; 0 for a sphere.
    pub fn flat_normal(&self) -> Vector<f64> {
        match self {
            Primitive::Sphere(_) => Vector::default(),
            Primitive::Plane(plane) => plane.normal.unit(),
            Primitive::Triangle(triangle) => triangle.outward_near_one().unit(),
        }
    }
}
