//! Short versions of the long runs of `pinhole-study record`.

use pinhole_study::record::{Kind, record};

#[test]
fn no_decision_is_wrong_in_everyday_questions_or_at_the_extremes() {
    for kind in [Kind::Random, Kind::Adversarial] {
        let count = record(kind, 0..1, 7);
        assert!(count.asked > 10_000, "{kind:?}: {count:?}");
        assert_eq!(count.wrong, 0, "{kind:?}");
    }
}

#[test]
fn no_ray_leaks_out_of_a_closed_mesh() {
    let count = record(Kind::Edges, 0..4, 7);
    assert!(count.asked == 4_000 && count.wrong == 0, "{count:?}");
}

#[test]
fn plans_of_random_scenes_keep_their_promise() {
    let count = record(Kind::Plans, 0..500, 7);
    assert!(count.hits > 10_000 && count.exact > 100, "{count:?}");
    assert_eq!(count.broken, [0; 0]);
}
