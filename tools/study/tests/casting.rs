//! Tests that casting whole scenes loses no hit, and that the nearer of two hits always comes
//! first.

use pinhole_study::cast::model::{Exact, FromCamera, Model, exact};
use pinhole_study::cast::rays::{camera, rays};
use pinhole_study::cast::world::{Part, Primitive, View, World};
use pinhole_study::cast::{Caster, Tally};
use pinhole_study::kernel::Camera;
use pinhole_study::oracle::scene::sight;
use pinhole_study::random::Random;
use pinhole_study::random_scene;
use pinhole_study::shape::{Plane, Ray, Sphere, Triangle};
use pinhole_study::vector::Vector;

/// The scene of these shapes, each an object of its own.
fn world_of(shapes: impl IntoIterator<Item = Primitive>) -> World {
    let mut world = World::default();
    for (object, shape) in shapes.into_iter().enumerate() {
        world.add(object, shape);
    }
    world
}

/// The place of the part that is seen first, and its t.
fn first(caster: &Caster, ray: &Ray<f64>, min_t: f64) -> Option<(u32, f64)> {
    let found = caster.first::<Exact>(ray, min_t, &mut Tally::default())?;
    Some((found.part.place, found.t))
}

/// Turns a ray of a camera to the limb of a sphere, or to the first edge of a triangle.
fn aimed(random: &mut Random, ray: Ray<f64>, has_eye: bool, part: &Part) -> Ray<f64> {
    let target = match part.shape {
        Primitive::Plane(plane) => plane.point,
        Primitive::Triangle(Triangle { corners: [a, b, _] }) => {
            a + (b - a) * (random.below(3) as f64 / 2.0)
        }
        Primitive::Sphere(Sphere { center, radius }) => {
            let to = if has_eye {
                center - ray.origin
            } else {
                ray.direction
            };
            // From outside, the ray is tangent to the sphere up to this slip.
            let sine = if has_eye {
                radius / to.squared().sqrt()
            } else {
                0.0
            };
            let slip = random.within(-1.0, 1.0) * 10f64.powf(random.within(-16.0, -2.0));
            let aside = radius * (1.0 + slip) / (1.0 - sine * sine).max(0.1).sqrt();
            center + random.unit_across(to.unit()) * aside
        }
    };
    let Ray { origin, direction } = ray;
    let along = (target - origin).dot(direction) / direction.squared();
    match has_eye {
        true => Ray {
            direction: target - origin,
            origin,
        },
        false => Ray {
            origin: target - direction * along,
            direction,
        },
    }
}

/// A ray through the anchors of two parts, from between them or from far away. It may lie in an
/// axis-aligned plane, and so run parallel to the sides of boxes.
fn through(random: &mut Random, parts: &[Part]) -> Ray<f64> {
    let [from, to] = [0; 2].map(|_| parts[random.below(parts.len())].shape.anchor());
    let mut masked = |x: f64| if random.below(4) > 0 { x } else { 0.0 };
    let [x, y, z] = (to - from).array().map(&mut masked);
    let direction = Vector::new(x, y, z);
    let away = [0.0, 10f64.powi(random.below(15) as i32)][random.below(2)];
    Ray {
        origin: to - direction * away,
        direction,
    }
}

/// Hits, and hits with an accurate t, of rays that all searches and casters see alike.
fn seen_alike<M: Model>() -> [usize; 2] {
    let mut random = Random::new(5, "camera");
    let [mut hits, mut accurate] = [0; 2];
    for seed in 0..1_000 {
        let (scene, _) = random_scene::drawn(seed);
        let mut rays = rays(&scene);
        if M::HAS_CAMERA
            && M::HAS_EYE != matches!(camera(&scene, &rays), Camera::Perspective { .. })
        {
            continue;
        }
        let world = World::of(&scene.objects);
        for ray in &mut rays {
            let part = &world.parts[random.below(world.parts.len())];
            *ray = match (M::HAS_CAMERA, random.below(3)) {
                (true, 0) => *ray,
                (true, _) => aimed(&mut random, *ray, M::HAS_EYE, part),
                (false, _) => through(&mut random, &world.parts),
            };
        }
        rays.retain(|ray| ray.is_finite() && ray.direction.largest() > 0.0);
        let accuracy = [1e-11, 1e-13][random.below(2)];
        let anywhere = Caster::new(world.clone(), None, false);
        let view = M::HAS_CAMERA.then(|| View {
            camera: camera(&scene, &rays),
            accuracy,
        });
        let casters = [false, true].map(|has_boxes| Caster::new(world.clone(), view, has_boxes));
        for ray in rays {
            let place = first(&anywhere, &ray, 0.0).map(|(place, _)| place);
            for caster in &casters {
                let found = caster.first::<M>(&ray, 0.0, &mut Tally::default());
                assert_eq!(
                    found.map(|found| found.part.place),
                    place,
                    "{seed}, {ray:?}"
                );
                let Some(found) = found else { continue };
                hits += 1;
                if found.is_accurate {
                    let root = exact(&found.part.shape, &ray, 0.0).expect("it is hit");
                    let t = root.rounded();
                    let is_near = (found.t - t).abs() <= accuracy * t;
                    assert!(is_near, "{} instead of {t}: {ray:?}", found.t);
                    accurate += 1;
                }
            }
        }
    }
    [hits, accurate]
}

#[test]
fn boxes_lose_no_hit_and_casters_for_one_camera_agree_with_those_for_any_ray() {
    let [hits, _] = seen_alike::<Exact>();
    assert!(hits > 10_000, "{hits}");
    for [hits, accurate] in [
        seen_alike::<FromCamera<true>>(),
        seen_alike::<FromCamera<false>>(),
    ] {
        assert!(
            hits > 10_000 && accurate > hits / 10,
            "{accurate} of {hits}"
        );
    }
}

#[test]
fn hit_one_ulp_before_min_t_is_not_seen() {
    let mut random = Random::new(4, "min_t");
    let mut met = 0;
    for _ in 0..20 {
        let balls = (0..60).map(|_| {
            let center = (random.unit() * random.within(0.0, 8.0)).map(f64::round);
            let radius = random.within(0.1, 1.5);
            Primitive::Sphere(Sphere { center, radius })
        });
        let caster = Caster::new(world_of(balls), None, true);
        for _ in 0..200 {
            let ray = Ray {
                origin: random.unit() * random.within(0.0, 9.0),
                direction: random.unit(),
            };
            let from = |min_t| first(&caster, &ray, min_t);
            let Some((_, t)) = from(0.0) else { continue };
            met += 1;
            for min_t in [t.next_down().max(0.0), t, t.next_up()] {
                let roots = caster.world.parts.iter().filter_map(|part| {
                    let root = exact(&part.shape, &ray, min_t)?;
                    Some((root, part.place))
                });
                let first = roots.min_by(|(p, at), (q, other)| p.compare(q).then(at.cmp(other)));
                let seen = from(min_t).map(|(place, _)| place);
                assert_eq!(seen, first.map(|(_, place)| place), "{ray:?} {min_t:e}");
            }
        }
    }
    assert!(met > 1_000, "{met}");
}

/// The direction's y component underflows when the direction is scaled to a length of about 1,
/// so that it seems to run parallel to the plane.
#[test]
fn plane_is_hit_if_scaling_the_direction_underflows() {
    let plane = Primitive::Plane(Plane {
        point: Vector::new(0.0, 5e-301, 0.0),
        normal: Vector::new(0.0, 1.0, 0.0),
    });
    let caster = Caster::new(world_of([plane]), None, true);
    let ray = Ray {
        origin: Vector::default(),
        direction: Vector::new(1e300, 1e-300, 0.0),
    };
    let seen = first(&caster, &ray, 0.0);
    assert_eq!(seen, Some((0, 0.5)));
}

/// The box of the farther sphere is entered first. Its t, 1.45 times the smallest float, is
/// rounded down to 1, before the nearer sphere's 1.3.
#[test]
fn boxes_lose_no_hit_with_subnormal_t() {
    let unit = 2f64.powi(-51);
    let ball = |x: f64, z: f64, radius: f64| {
        Primitive::Sphere(Sphere {
            center: Vector::new(x, 0.0, z) * unit,
            radius: radius * unit,
        })
    };
    let ray = Ray {
        origin: Vector::default(),
        direction: Vector::new(0.0, 0.0, 2f64.powi(1023)),
    };
    for has_boxes in [false, true] {
        let world = world_of([ball(8.0, 7.45, 10.0), ball(0.0, 2.3, 1.0)]);
        let seen = first(&Caster::new(world, None, has_boxes), &ray, 0.0);
        assert_eq!(seen.map(|(place, _)| place), Some(1), "{has_boxes}");
    }
}

/// The area 1e-320 of the first triangle is subnormal, with three digits. That of the second
/// underflows to 0, and that of the third overflows.
#[test]
fn normals_of_tiny_and_huge_triangles_are_accurate() {
    for size in [1e-160, 1e-170, 1e160] {
        let corner = |x: f64, y: f64| Vector::new(x, y, 0.5 * x) * size;
        let triangle = Triangle {
            corners: [corner(0.0, 0.0), corner(1.0, 0.25), corner(0.0, 1.0)],
        };
        let ray = Ray {
            origin: Vector::default(),
            direction: Vector::new(0.0, 0.0, 1.0),
        };
        let normal = Primitive::Triangle(triangle).normal(&ray, 0.0);
        let off = normal - Vector::new(-0.5, 0.0, 1.0).unit();
        assert!(off.largest() < 1e-15, "{size}: {normal:?}");
    }
}

/// The square of this direction's length underflows to 0.
#[test]
fn judge_handles_a_direction_whose_square_underflows() {
    let sphere = Primitive::Sphere(Sphere {
        center: Vector::new(0.0, 0.0, -1e10),
        radius: 9e9,
    });
    let caster = Caster::new(world_of([sphere]), None, true);
    let ray = Ray {
        origin: Vector::new(5e9, 0.0, 0.0),
        direction: Vector::new(0.0, 0.0, -1e-163),
    };
    assert!(first(&caster, &ray, 0.0).is_some());
    assert!(sight(&caster.world.parts, &ray, 0.0).is_some());
}
