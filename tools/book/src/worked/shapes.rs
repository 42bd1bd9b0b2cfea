//! One ray and everything that it meets: the three shapes, the soup and the list.

use glam::{DVec3, dvec3};
use pinhole::{Intersection, Plane, Ray, Shape, Sphere, Triangle, TriangleSoup};

use super::{Values, shown, vector};
use crate::error::Result;
use crate::reference::Reference;

/// The ray of all worked numbers.
pub const RAY: Ray = Ray {
    origin: dvec3(1.0, 1.0, 0.0),
    direction: dvec3(1.0, 2.0, -2.0),
};

/// The plane it meets; its normal has length 5.
pub const PLANE: Plane = Plane {
    point: dvec3(0.0, 0.0, -2.0),
    normal: dvec3(0.0, 3.0, 4.0),
};

/// The sphere it meets.
pub const SPHERE: Sphere = Sphere {
    center: dvec3(4.0, 4.0, -3.0),
    radius: 1.5,
};

/// The triangle it meets. It has three sides of different lengths, no right angle, no edge
/// parallel to an axis, and an area of 12.
pub const TRIANGLE: Triangle = Triangle {
    corners: [
        dvec3(1.0, 3.0, -3.0),
        dvec3(5.0, 3.0, -7.0),
        dvec3(3.0, 7.0, -3.0),
    ],
};

/// a t² + 2 h t + k = 0 of a ray and a sphere.
#[derive(Clone, Copy, Debug)]
pub struct Quadratic {
    /// d · d.
    pub a: f64,
    /// d · m, with m = e − c.
    pub h: f64,
    /// m · m − r².
    pub k: f64,
}

impl Quadratic {
    /// The chapter's three coefficients.
    pub fn new(ray: &Ray, sphere: &Sphere) -> Quadratic {
        let m = ray.origin - sphere.center;
        Quadratic {
            a: ray.direction.length_squared(),
            h: ray.direction.dot(m),
            k: m.length_squared() - sphere.radius * sphere.radius,
        }
    }

    /// Δ = h² − a k.
    pub fn discriminant(&self) -> f64 {
        self.h * self.h - self.a * self.k
    }

    /// t₀ ≤ t₁; not a number if the line misses the sphere.
    pub fn roots(&self) -> [f64; 2] {
        let root = self.discriminant().sqrt();
        [-1.0, 1.0].map(|sign| (-self.h + sign * root) / self.a)
    }
}

/// D, α, β of a ray and a triangle, by Cramer's rule (Möller & Trumbore 1997).
pub fn weights(ray: &Ray, triangle: &Triangle) -> [f64; 3] {
    let [a, b, c] = triangle.corners;
    let (t1, t2, s, d) = (b - a, c - a, ray.origin - a, ray.direction);
    let determinant = t1.dot(d.cross(t2));
    let (alpha, beta) = (s.dot(d.cross(t2)), d.dot(s.cross(t1)));
    [determinant, alpha / determinant, beta / determinant]
}

/// t of the plane, after moving it and the ray by 2⁴⁰ along each axis, where every coordinate is
/// exact: once with the numerator multiplied out, once with the points subtracted first.
fn plane_from_afar() -> [f64; 2] {
    let far = DVec3::splat(2.0_f64.powi(40));
    let (q, e) = (PLANE.point + far, RAY.origin + far);
    let n = PLANE.normal / 10.0;
    [q.dot(n) - e.dot(n), (q - e).dot(n)].map(|way| way / RAY.direction.dot(n))
}

/// Adds these chapters' numbers.
pub fn add(values: &mut Values, reference: &Reference) -> Result<()> {
    let mut add = |name: &str, text| {
        values.insert(name.to_owned(), text);
    };
    let met = |shape: &Shape, min_t| reference.intersect(shape, RAY, min_t);
    let t = |at: Option<Intersection>| at.map_or("none".into(), |at| shown(at.t));
    let normal = |at: Option<Intersection>| at.map_or("none".into(), |at| vector(at.normal));
    let point = |at: Option<Intersection>| at.map_or("none".into(), |at| vector(RAY.at(at.t)));

    let plane = Shape::Plane(PLANE);
    let at = met(&plane, 1.0)?;
    add(
        "plane_distance",
        shown((PLANE.point - RAY.origin).dot(PLANE.normal)),
    );
    add("plane_step", shown(RAY.direction.dot(PLANE.normal)));
    add("plane_t", t(at));
    add("plane_point", point(at));
    add("plane_normal", normal(at));
    let [multiplied_out, subtracted_first] = plane_from_afar();
    add("plane_far_multiplied_out", shown(multiplied_out));
    add("plane_far_subtracted_first", shown(subtracted_first));

    let quadratic = Quadratic::new(&RAY, &SPHERE);
    let [t0, t1] = quadratic.roots();
    add("sphere_a", shown(quadratic.a));
    add("sphere_h", shown(quadratic.h));
    add("sphere_k", shown(quadratic.k));
    add("sphere_discriminant", shown(quadratic.discriminant()));
    add("sphere_t0", shown(t0));
    add("sphere_t1", shown(t1));
    let sphere = Shape::Sphere(SPHERE);
    for (min_t, name) in [(1.0, "1"), (1.6, "1_6")] {
        let at = met(&sphere, min_t)?;
        add(&format!("sphere_t_from_{name}"), t(at));
        add(&format!("sphere_normal_from_{name}"), normal(at));
    }
    add("sphere_from_1_9", t(met(&sphere, 1.9)?));

    let triangle = Shape::Triangle(TRIANGLE);
    let at = met(&triangle, 1.0)?;
    let [determinant, alpha, beta] = weights(&RAY, &TRIANGLE);
    add("triangle_determinant", shown(determinant));
    add("triangle_alpha", shown(alpha));
    add("triangle_beta", shown(beta));
    add("triangle_t", t(at));
    add("triangle_point", point(at));
    add("triangle_normal", normal(at));

    let soup = [3.0, 0.0, 2.0].map(|steps| moved(TRIANGLE, steps * RAY.direction));
    for (place, triangle) in soup.iter().enumerate() {
        add(
            &format!("soup_t_{place}"),
            t(met(&Shape::Triangle(*triangle), 1.0)?),
        );
    }
    let soup = Shape::Soup(TriangleSoup {
        triangles: soup.into(),
    });
    for min_t in [1.0, 3.0] {
        add(&format!("soup_t_from_{min_t}"), t(met(&soup, min_t)?));
    }

    let list = [plane, sphere, triangle];
    for (min_t, name) in [(1.0, "1"), (1.6, "1_6"), (1.9, "1_9"), (6.0, "6")] {
        let hit = reference.first_hit(&list, RAY, min_t)?;
        let words = hit.map_or("none".into(), |hit| {
            format!("object {}, t = {}", hit.object, shown(hit.intersection.t))
        });
        add(&format!("first_hit_from_{name}"), words);
    }
    Ok(())
}

fn moved(triangle: Triangle, by: DVec3) -> Triangle {
    Triangle {
        corners: triangle.corners.map(|corner| corner + by),
    }
}
