//! Tests that casting whole scenes loses no hit, and that the nearer of two hits always comes
//! first.

use pinhole_study::cast::model::Exact;
use pinhole_study::cast::world::{Part, Primitive, View, World};
use pinhole_study::cast::{Caster, Tally, first_hit};
use pinhole_study::kernel::Camera;
use pinhole_study::oracle::scene::sight;
use pinhole_study::plan::casting::{camera, rays};
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

/// The place of the part that is seen first, and its t, by the only ray of a camera. Both kinds of
/// camera see the same.
fn first(world: &World, ray: &Ray<f64>, min_t: f64) -> Option<(u32, f64)> {
    let seen = first_hit(world.clone(), ray, min_t, &mut Tally::default());
    let view = View {
        camera: Camera::orthographic(&[*ray], ray.origin),
        accuracy: f64::INFINITY,
    };
    let caster = Caster::new(world.clone(), Some(view), true);
    let found = caster.first::<Exact<false>>(ray, min_t, &mut Tally::default());
    let place = found.map(|found| found.part.place);
    assert_eq!(place, seen.map(|(place, _)| place), "{ray:?} {min_t:e}");
    seen
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

/// Hits, and hits with an accurate t, of a camera's rays, all of which see what is truly first.
fn seen_truly<const HAS_EYE: bool>() -> [usize; 2] {
    let mut random = Random::new(5, "camera");
    let [mut hits, mut accurate] = [0; 2];
    for seed in 0..300 {
        let (scene, _) = random_scene::drawn(seed);
        let mut rays = rays(&scene);
        if HAS_EYE != matches!(camera(&scene, &rays), Camera::Perspective { .. }) {
            continue;
        }
        let world = World::of(&scene.objects);
        for ray in &mut rays {
            let part = &world.parts[random.below(world.parts.len())];
            if random.below(3) > 0 {
                *ray = aimed(&mut random, *ray, HAS_EYE, part);
            }
        }
        rays.retain(|ray| ray.is_finite() && ray.direction.largest() > 0.0);
        let accuracy = [1e-11, 1e-13][random.below(2)];
        let view = View {
            camera: camera(&scene, &rays),
            accuracy,
        };
        let caster = |has_boxes| Caster::new(world.clone(), Some(view), has_boxes);
        let casters = [false, true].map(caster);
        for ray in rays {
            let truth = sight(&world.parts, &ray, 0.0);
            let place = truth.as_ref().map(|(part, _)| part.place);
            for caster in &casters {
                let found = caster.first::<Exact<HAS_EYE>>(&ray, 0.0, &mut Tally::default());
                assert_eq!(
                    found.map(|found| found.part.place),
                    place,
                    "{seed}, {ray:?}"
                );
                let Some(found) = found else { continue };
                hits += 1;
                if found.is_accurate {
                    let error = truth.as_ref().map(|(_, root)| root.relative_error(found.t));
                    assert!(error <= Some(accuracy), "{}: {error:?}, {ray:?}", found.t);
                    accurate += 1;
                }
            }
        }
    }
    [hits, accurate]
}

#[test]
fn rays_of_a_camera_see_what_is_truly_first() {
    for [hits, accurate] in [seen_truly::<true>(), seen_truly::<false>()] {
        assert!(hits > 3_000 && accurate > hits / 10, "{accurate} of {hits}");
    }
}

#[test]
fn boxes_lose_no_hit_of_a_ray_from_anywhere() {
    let mut random = Random::new(5, "anywhere");
    let mut hits = 0;
    for seed in 0..300 {
        let world = World::of(&random_scene::drawn(seed).0.objects);
        for _ in 0..20 {
            let ray = through(&mut random, &world.parts);
            if ray.is_finite() && ray.direction.largest() > 0.0 {
                let place = first(&world, &ray, 0.0).map(|(place, _)| place);
                let truth = sight(&world.parts, &ray, 0.0).map(|(part, _)| part.place);
                assert_eq!(place, truth, "{seed}");
                hits += usize::from(place.is_some());
            }
        }
    }
    assert!(hits > 1_500, "{hits}");
}

/// The direction's y component underflows when the direction is scaled to a length of about 1,
/// so that it seems to run parallel to the plane.
#[test]
fn plane_is_hit_if_scaling_the_direction_underflows() {
    let plane = Primitive::Plane(Plane {
        point: Vector::new(0.0, 5e-301, 0.0),
        normal: Vector::new(0.0, 1.0, 0.0),
    });
    let ray = Ray {
        origin: Vector::default(),
        direction: Vector::new(1e300, 1e-300, 0.0),
    };
    let seen = first(&world_of([plane]), &ray, 0.0);
    assert_eq!(seen, Some((0, 0.5)));
}

/// `min_t` times the length of the direction is beyond the largest `f64`. The true t is as large,
/// but is computed to be a little smaller.
#[test]
fn plane_is_hit_if_scaling_min_t_overflows() {
    let plane = Primitive::Plane(Plane {
        point: Vector::new(
            -6.895782578993324e303,
            -8.896027818089673e287,
            -9.533687857970925e291,
        ),
        normal: Vector::new(1.591153435001304, -0.7955456837799035, 6.103515625e-5),
    });
    let ray = Ray {
        origin: Vector::default(),
        direction: Vector::new(0.0, 0.0, -2f64.powi(1000)),
    };
    let seen = first(&world_of([plane]), &ray, 2f64.powi(24));
    assert!(seen.is_some());
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
    let world = world_of([ball(8.0, 7.45, 10.0), ball(0.0, 2.3, 1.0)]);
    let seen = first(&world, &ray, 0.0);
    assert_eq!(seen.map(|(place, _)| place), Some(1));
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
    let world = world_of([sphere]);
    let ray = Ray {
        origin: Vector::new(5e9, 0.0, 0.0),
        direction: Vector::new(0.0, 0.0, -1e-163),
    };
    assert!(first(&world, &ray, 0.0).is_some());
    assert!(sight(&world.parts, &ray, 0.0).is_some());
}

/// Enough triangles that there are boxes.
#[test]
fn ray_without_a_direction_hits_nothing() {
    let triangles = (0..100).map(|k| {
        let corner = |x: f64, y: f64| Vector::new(x, y, f64::from(k));
        let corners = [corner(0.0, 0.0), corner(1.0, 0.0), corner(0.0, 1.0)];
        Primitive::Triangle(Triangle { corners })
    });
    let world = world_of(triangles);
    for origin in [Vector::new(0.1, 0.2, 50.5), Vector::new(100.0, 0.0, 1e6)] {
        let direction = Vector::default();
        let seen = first(&world, &Ray { origin, direction }, 0.0);
        assert_eq!(seen, None);
    }
}

/// All boxes are entered at once, and each level of the tree leaves seven of them waiting. The
/// smallest sphere is found last.
#[test]
fn smallest_of_hundreds_of_nested_spheres_is_seen_from_within() {
    let ball = |power: i32| {
        Primitive::Sphere(Sphere {
            center: Vector::default(),
            radius: 1.1f64.powi(power),
        })
    };
    let ray = Ray {
        origin: Vector::default(),
        direction: Vector::new(1.0, 0.5, 0.25),
    };
    let seen = first(&world_of((0..400).rev().map(ball)), &ray, 0.0);
    assert_eq!(seen.map(|(place, _)| place), Some(399));
}

/// Boxes with a common corner make a tree that is deeper than obvhs expects.
#[test]
fn deep_tree_over_spheres_and_triangles_is_built() {
    let both = |k: i32| {
        let q = 1.0 + f64::from(k) / 1000.0;
        let corners = [(0.0, 0.0, 0.0), (q, 9.0, 0.0), (0.0, 9.0, q)];
        let corners = corners.map(|(x, y, z)| Vector::new(x, y, z));
        let (center, radius) = (Vector::new(q, q, q) * 0.5, 0.5 * q);
        [
            Primitive::Sphere(Sphere { center, radius }),
            Primitive::Triangle(Triangle { corners }),
        ]
    };
    let world = world_of((0..1200).flat_map(both));
    let ray = Ray {
        origin: Vector::new(0.5, 0.75, 40.0),
        direction: Vector::new(0.0, 0.0, -1.0),
    };
    let seen = first(&world, &ray, 0.0).map(|(place, _)| place);
    let truth = sight(&world.parts, &ray, 0.0).map(|(part, _)| part.place);
    assert!(seen.is_some() && seen == truth);
}

/// If the boxes were not made unequal, this would take minutes.
#[test]
fn tree_over_many_equal_boxes_is_built_soon() {
    let triangle = Primitive::Triangle(Triangle {
        corners: [0.0, 1.0, 2.0].map(|x| Vector::new(x, x * x, 1.0)),
    });
    let ray = Ray {
        origin: Vector::default(),
        direction: Vector::new(1.0, 1.5, 1.0),
    };
    let seen = first(&world_of(std::iter::repeat_n(triangle, 100_000)), &ray, 0.0);
    assert_eq!(seen, Some((0, 1.0)));
}
