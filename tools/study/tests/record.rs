//! The long runs, short: what `study record` would say in a few seconds.

use pinhole_study::record::{Hardness, decisions, leaks};

#[test]
fn no_decision_is_wrong_in_everyday_questions_or_at_the_extremes() {
    for hardness in [Hardness::Random, Hardness::Adversarial] {
        let count = decisions(hardness, 20_000, 7, &|_| ());
        assert!(count.asked > 10_000, "{hardness:?}: {count:?}");
        assert_eq!(count.wrong, 0, "{hardness:?}");
    }
}

#[test]
fn a_ray_from_inside_a_closed_mesh_leaves_it_once() {
    let leaks = leaks(2_000, 7, &|_| ());
    assert!(leaks.rays >= 4_000, "{leaks:?}");
    assert_eq!([leaks.leaks, leaks.double_hits], [0; 2]);
}
