//! Plans: does what is cast as planned keep to what was wished?

use pinhole::Scene;
use pinhole_study::cast::model::Exact;
use pinhole_study::cast::narrow::{Narrow, rounded};
use pinhole_study::cast::rays::rays;
use pinhole_study::cast::world::World;
use pinhole_study::cast::{Caster, Search, Tally};
use pinhole_study::oracle::scene::{Compared, sight};
use pinhole_study::plan::bounds::Rounding;
use pinhole_study::plan::{Numbers, Wish, plan, watch};
use pinhole_study::plans;
use pinhole_study::scenes::{Share, files};

fn wish(accuracy: f64) -> Wish {
    Wish {
        accuracy,
        exact_ids: false,
        depth: true,
        normal: true,
    }
}

fn scene(name: &str) -> Scene {
    let file = files().into_iter().find(|file| file.ends_with(name));
    Scene::read(&file.expect("it is committed")).expect("it is a scene")
}

#[test]
fn every_plan_keeps_to_what_was_wished_at_every_pixel_asked() {
    let share = Share {
        step: 13,
        rounds: 1,
    };
    for file in files() {
        for tally in plans::studied(&file, share, &[1e-2, 1e-5, 1e-8, 1e-12]).expect("a plan") {
            assert_eq!(tally.violations, 0, "{tally:#?}");
            assert!(!tally.exact_ids || tally.wrong_ids == 0, "{tally:#?}");
        }
    }
}

/// The bounds themselves, which the choice and the watch rest on: of a plain cast in `f32`,
/// no error may exceed its own bound, and most should not be far below it.
#[test]
fn what_f32_gets_wrong_is_within_the_bound_of_each_hit() {
    let mut tightest: f64 = 0.0;
    for file in files() {
        let scene = Scene::read(&file).expect("it is a scene");
        let world = World::of(&scene.objects);
        let narrow = Narrow::new(world.parts.iter());
        for ray in rays(&scene).iter().step_by(17) {
            let short = rounded(ray);
            let near = narrow.first::<pinhole_study::cast::kernels::Usual>(
                Search::BruteForce,
                &short,
                scene.min_t as f32,
            );
            let Some(near) = near else { continue };
            let part = &world.parts[near.place as usize];
            let t = f64::from(near.t);
            let bound = watch::bound(&part.shape, ray, (t, scene.min_t), Rounding::F32, false);
            let normal = near.normal(&short).map(f64::from);
            let seen = Some((part.object, t, normal));
            let truth = sight(&world.parts, ray, scene.min_t);
            if let Compared::Off { t, normal, .. } = truth.compared(ray, seen) {
                let place = format!("{} {ray:?} {bound:?} {t:e} {normal:e}", file.display());
                assert!(t <= bound.t && normal <= bound.normal, "{place}");
                tightest = tightest.max(t / bound.t).max(normal / bound.normal);
            }
        }
    }
    assert!(tightest > 0.02, "the bounds are slack: {tightest}");
}

#[test]
fn what_is_finer_than_f32_is_never_cast_in_it() {
    for name in ["sphere_packing.toml", "bunny.toml", "slide_example.toml"] {
        for accuracy in [1e-8, 1e-12] {
            let (plan, _) = plan(&scene(name), wish(accuracy)).expect("a plan");
            let mut kinds = plan.kinds.iter();
            let is_fine = kinds.all(|kind| kind.numbers > Numbers::F32);
            assert!(is_fine, "{name} at {accuracy:e}: {plan:#?}");
        }
    }
}

#[test]
fn what_no_f64_can_hold_is_refused() {
    let refused = plan(&scene("slide_example.toml"), wish(1e-17));
    assert!(refused.is_err_and(|why| why.contains("remedy")));
}

#[test]
fn exact_ids_are_those_of_the_exact_caster() {
    let scene = scene("inside_a_sphere.toml");
    let wish = Wish {
        exact_ids: true,
        depth: false,
        normal: false,
        ..wish(1e-3)
    };
    let (_, casting) = plan(&scene, wish).expect("a plan");
    let rays: Vec<_> = rays(&scene).into_iter().step_by(7).collect();
    let caster = Caster::new(World::of(&scene.objects));
    for (ray, seen) in rays.iter().zip(casting.film(&rays).0) {
        let mut tally = Tally::default();
        let exact = caster.first::<Exact>(Search::BruteForce, ray, scene.min_t, &mut tally);
        let exact = exact.map(|found| found.part.object);
        assert_eq!(seen.map(|(object, ..)| object), exact);
    }
}
