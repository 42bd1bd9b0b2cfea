//! The long runs, short: what `study record` would say in a few seconds.

use pinhole_study::record::{Hardness, decisions, leaks, plans};

#[test]
fn no_decision_is_wrong_in_everyday_questions_or_at_the_extremes() {
    for hardness in [Hardness::Random, Hardness::Adversarial] {
        let count = decisions(hardness, 20_000, 7, &|_| ());
        assert!(count.asked > 10_000, "{hardness:?}: {count:?}");
        assert_eq!(count.wrong, 0, "{hardness:?}");
    }
}

#[test]
fn no_ray_leaks_out_of_a_closed_mesh() {
    let leaks = leaks(2_000, 7, &|_| ());
    assert!(leaks.rays >= 4_000, "{leaks:?}");
    assert_eq!(leaks.leaks, 0);
}

#[test]
fn plans_of_random_scenes_keep_their_promise() {
    let plans = plans(500, 7, &|_| ());
    assert!(plans.hits > 10_000 && plans.exact_hits > 500, "{plans:?}");
    assert!(plans.broken.is_empty(), "{plans:?}");
}
