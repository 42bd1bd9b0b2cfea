//! Tests that casting whole scenes loses no hit, and that the nearer of two hits always comes
//! first.

use pinhole_study::cast::model::{Exact, FromCamera, Model, Plain, exact};
use pinhole_study::cast::world::{Primitive, View, World};
use pinhole_study::cast::{Caster, Search, Tally};
use pinhole_study::kernel::Camera;
use pinhole_study::oracle::scene::sight;
use pinhole_study::random::Random;
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
fn first<M: Model>(
    caster: &Caster,
    search: Search,
    ray: &Ray<f64>,
    min_t: f64,
) -> Option<(u32, f64)> {
    let found = caster.first::<M>(search, ray, min_t, &mut Tally::default())?;
    Some((found.part.place, found.t))
}

/// Checks that boxes change no answer, and returns whether there is a hit.
#[track_caller]
fn is_hit_in_boxes_too(caster: &Caster, ray: &Ray<f64>) -> usize {
    let all = first::<Exact>(caster, Search::BruteForce, ray, 0.0);
    let boxed = first::<Exact>(caster, Search::Boxes, ray, 0.0);
    assert_eq!(boxed, all, "{ray:?}");
    usize::from(all.is_some())
}

/// A random direction. Half of them lie along an axis or in an axis-aligned plane, and so run
/// parallel to the sides of boxes.
fn direction(random: &mut Random) -> Vector<f64> {
    let any = random.unit();
    let axis = Vector::new(1.0, 0.0, 0.0);
    match random.below(6) {
        0 => axis,
        1 => Vector::new(0.0, -2.0, 0.0),
        2 => Vector::new(0.0, any.y, any.z),
        _ => any,
    }
}

/// Scales of crowds, and their distances from the origin.
const CROWDS: [(f64, f64); 5] = [
    (1.0, 0.0),
    (1e-3, 1e3),
    (1e20, 0.0),
    (1e-30, 0.0),
    (1.0, 1e8),
];

/// Spheres and triangles on a grid, so that rays often coincide with the sides of boxes.
fn crowd(random: &mut Random, scale: f64, offset: Vector<f64>) -> World {
    let on_grid = |random: &mut Random| {
        let at = random.unit() * random.within(0.0, 8.0);
        offset + at.map(|x| x.round() * scale)
    };
    world_of((0..60).map(|object| match object % 3 {
        0 => Primitive::Sphere(Sphere {
            center: on_grid(random),
            radius: scale * random.within(0.1, 1.5),
        }),
        _ => Primitive::Triangle(Triangle {
            corners: [0; 3].map(|_| on_grid(random)),
        }),
    }))
}

#[test]
fn boxes_lose_no_hit() {
    let mut random = Random::new(1, "boxes");
    let mut hits = 0;
    for (scale, away) in CROWDS {
        for _ in 0..20 {
            let offset = random.unit() * away;
            let caster = Caster::new(crowd(&mut random, scale, offset));
            for _ in 0..300 {
                let at = random.unit() * random.within(0.0, 9.0);
                let origin = offset + at.map(|x| x.round() * scale);
                let direction = direction(&mut random);
                hits += is_hit_in_boxes_too(&caster, &Ray { origin, direction });
            }
        }
    }
    assert!(hits > 10_000, "{hits}");
}

#[test]
fn boxes_lose_no_hit_of_rays_from_far_away() {
    let mut random = Random::new(3, "far");
    let mut hits = 0;
    for exponent in 1..=14 {
        let caster = Caster::new(crowd(&mut random, 1.0, Vector::default()));
        for _ in 0..500 {
            let target = random.unit() * random.within(0.0, 9.0);
            let direction = random.unit() * random.within(0.1, 10.0);
            let origin = target - direction * 10f64.powi(exponent);
            hits += is_hit_in_boxes_too(&caster, &Ray { origin, direction });
        }
    }
    assert!(hits > 1_000, "{hits}");
}

/// Rays of one camera: from the same eye, or in the same direction. Many are aimed at points of a
/// grid, so that they run through corners and edges, and a third of them graze a sphere.
fn rays_of_one_camera(
    random: &mut Random,
    scale: f64,
    offset: Vector<f64>,
    world: &World,
    has_eye: bool,
) -> (Camera, Vec<Ray<f64>>) {
    let spheres = world.parts.iter().filter_map(|part| match part.shape {
        Primitive::Sphere(sphere) => Some(sphere),
        _ => None,
    });
    let spheres: Vec<_> = spheres.collect();
    let point = |random: &mut Random| {
        let at = random.unit() * random.within(0.0, 9.0);
        let is_on_grid = random.below(4) > 0;
        let at = at.map(|x| if is_on_grid { x.round() } else { x });
        offset + at * scale
    };
    let (eye, along) = (point(random), direction(random));
    let rays = (0..200).map(|_| match (has_eye, random.below(3)) {
        (_, 0) => {
            let sphere = spheres[random.below(spheres.len())];
            let slip = random.within(-1.0, 1.0) * 10f64.powf(random.within(-16.0, -2.0));
            let radius = sphere.radius * (1.0 + slip);
            let to = if has_eye { sphere.center - eye } else { along };
            // The eye may be the centre.
            let to = if to.largest() > 0.0 { to } else { along };
            let aside = random.unit_across(to.unit()) * radius;
            let distance = to.dot(to).sqrt();
            // From outside, the ray is tangent to the sphere with this radius.
            let sine = (radius / distance).min(0.9);
            match has_eye {
                true => Ray {
                    origin: eye,
                    direction: to + aside * (1.0 - sine * sine).sqrt().recip(),
                },
                false => Ray {
                    origin: sphere.center - along * (3.0 * scale) + aside,
                    direction: along,
                },
            }
        }
        (true, _) => Ray {
            origin: eye,
            direction: (point(random) - eye) * random.within(0.01, 100.0),
        },
        (false, _) => Ray {
            origin: point(random),
            direction: along,
        },
    });
    // A point of the grid may be the eye itself.
    let rays: Vec<_> = rays.filter(|ray| ray.direction.largest() > 0.0).collect();
    match has_eye {
        true => (Camera::Perspective { eye }, rays),
        false => (Camera::orthographic(&rays, eye), rays),
    }
}

fn what_rays_from_anywhere_see<M: Model>(has_eye: bool) {
    let mut random = Random::new(5, M::NAME);
    let [mut hits, mut accurate] = [0; 2];
    for (scale, away) in CROWDS {
        for round in 0..30 {
            let required = [1e-11, 1e-13][round % 2];
            let offset = random.unit() * away;
            let mut world = crowd(&mut random, scale, offset);
            let (camera, rays) = rays_of_one_camera(&mut random, scale, offset, &world, has_eye);
            let (point, normal) = (offset, direction(&mut random));
            world.add(60, Primitive::Plane(Plane { point, normal }));
            let anywhere = Caster::new(world.clone());
            let view = View {
                camera,
                required_t: &|_, _| required,
            };
            let caster = Caster::from_camera(world, view);
            for ray in rays {
                let all = first::<Exact>(&anywhere, Search::BruteForce, &ray, 0.0);
                let all = all.map(|(place, _)| place);
                for search in [Search::BruteForce, Search::Boxes] {
                    let found = caster.first::<M>(search, &ray, 0.0, &mut Tally::default());
                    let place = found.map(|found| found.part.place);
                    assert_eq!(place, all, "{search:?}, {camera:?}, {ray:?}");
                    let Some(found) = found else { continue };
                    hits += 1;
                    if found.is_accurate {
                        let root = exact(&found.part.shape, &ray, 0.0).expect("it is hit");
                        let t = root.rounded();
                        let is_near = (found.t - t).abs() <= required * t;
                        assert!(is_near, "{} instead of {t}: {ray:?}", found.t);
                        accurate += 1;
                    }
                }
            }
        }
    }
    assert!(
        hits > 20_000 && accurate > hits / 10,
        "{accurate} of {hits}"
    );
}

#[test]
fn rays_from_one_eye_see_what_rays_from_anywhere_see() {
    what_rays_from_anywhere_see::<FromCamera<true>>(true);
}

#[test]
fn parallel_rays_see_what_rays_from_anywhere_see() {
    what_rays_from_anywhere_see::<FromCamera<false>>(false);
}

#[test]
fn hit_one_ulp_before_min_t_is_not_seen() {
    let mut random = Random::new(4, "min_t");
    let mut met = 0;
    for _ in 0..20 {
        let caster = Caster::new(crowd(&mut random, 1.0, Vector::default()));
        for _ in 0..200 {
            let ray = Ray {
                origin: random.unit() * random.within(0.0, 9.0),
                direction: random.unit(),
            };
            let from = |min_t| first::<Exact>(&caster, Search::Boxes, &ray, min_t);
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

/// Casts rays at surfaces that are a few ulps apart, and counts wrong objects.
fn wrong_objects<M: Model>() -> usize {
    let mut random = Random::new(2, "close");
    let mut wrong = 0;
    for round in 0..2_000 {
        let from = random.unit() * 4.0;
        let target = random.unit() * 0.3;
        let ray = Ray {
            origin: from,
            direction: (target - from) * random.within(0.3, 3.0),
        };
        // A sphere, and a plane or triangle through the point where the ray hits it, up to
        // rounding.
        let ball = Primitive::Sphere(Sphere {
            center: Vector::new(0.0, 0.0, 0.0),
            radius: 1.0,
        });
        let alone = Caster::new(world_of([ball]));
        let (_, t) = first::<Exact>(&alone, Search::Boxes, &ray, 0.0).expect("it is hit");
        let point = ray.origin + ray.direction * t;
        let across = random.unit_across(point);
        let corners = [
            across,
            across.cross(point),
            across * -1.0 - across.cross(point),
        ];
        let other = match round % 2 == 0 {
            true => Primitive::Plane(Plane {
                point,
                normal: point,
            }),
            false => Primitive::Triangle(Triangle {
                corners: corners.map(|corner| point + corner),
            }),
        };
        let caster = Caster::new(world_of([ball, other]));
        let truth = sight(&caster.world.parts, &ray, 0.0).map(|(part, _)| part.place);
        for search in [Search::BruteForce, Search::Boxes] {
            let seen = first::<M>(&caster, search, &ray, 0.0).map(|(place, _)| place);
            wrong += usize::from(truth != seen);
        }
    }
    wrong
}

#[test]
fn of_two_surfaces_an_ulp_apart_the_nearer_is_seen() {
    assert_eq!(wrong_objects::<Exact>(), 0);
    // The judge notices a caster that compares rounded t.
    let plain = wrong_objects::<Plain>();
    assert!(plain > 100, "{plain}");
}

/// The direction's y component underflows when the direction is scaled to a length of about 1,
/// so that it seems to run parallel to the plane.
#[test]
fn plane_is_hit_if_scaling_the_direction_underflows() {
    let caster = Caster::new(world_of([Primitive::Plane(Plane {
        point: Vector::new(0.0, 5e-301, 0.0),
        normal: Vector::new(0.0, 1.0, 0.0),
    })]));
    let ray = Ray {
        origin: Vector::default(),
        direction: Vector::new(1e300, 1e-300, 0.0),
    };
    let seen = first::<Exact>(&caster, Search::Boxes, &ray, 0.0);
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
    let caster = Caster::new(world_of([ball(8.0, 7.45, 10.0), ball(0.0, 2.3, 1.0)]));
    let ray = Ray {
        origin: Vector::default(),
        direction: Vector::new(0.0, 0.0, 2f64.powi(1023)),
    };
    for search in [Search::BruteForce, Search::Boxes] {
        let seen = first::<Exact>(&caster, search, &ray, 0.0).map(|(place, _)| place);
        assert_eq!(seen, Some(1), "{search:?}");
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
    let caster = Caster::new(world_of([Primitive::Sphere(Sphere {
        center: Vector::new(0.0, 0.0, -1e10),
        radius: 9e9,
    })]));
    let ray = Ray {
        origin: Vector::new(5e9, 0.0, 0.0),
        direction: Vector::new(0.0, 0.0, -1e-163),
    };
    assert!(first::<Exact>(&caster, Search::Boxes, &ray, 0.0).is_some());
    assert!(sight(&caster.world.parts, &ray, 0.0).is_some());
}
