use super::*;

/// Of this many questions, how many are ties.
fn ties<Q>(ask: impl Fn(&mut Random) -> (Q, bool)) -> usize {
    let mut random = Random::new();
    (0..10_000).filter(|_| ask(&mut random).1).count()
}

#[test]
fn every_kind_of_question_has_ties_and_is_mostly_something_else() {
    for (kind, ties) in [
        ("sphere", ties(sphere)),
        ("plane", ties(plane)),
        ("triangle", ties(triangle)),
        ("disk", ties(disk)),
        ("objects", ties(objects)),
    ] {
        assert!((10..5_000).contains(&ties), "{ties} of {kind}");
    }
}

#[test]
fn a_plane_is_met_exactly_at_min_t_in_ties_and_in_no_other_question() {
    let mut random = Random::new();
    for _ in 0..10_000 {
        let (asked, is_tie) = plane(&mut random);
        let Shape::Plane(plane) = asked.shape else {
            panic!("a plane was asked for");
        };
        let parallel = asked.ray.direction.dot(plane.normal) == 0.0;
        let at_min_t = asked.ray.at(asked.min_t) - plane.point;
        assert_eq!(is_tie, !parallel && at_min_t.dot(plane.normal) == 0.0);
    }
}

#[test]
fn a_tangent_ray_and_one_that_starts_on_the_sphere_are_ties() {
    let mut random = Random::new();
    let mut seen = [false; 2];
    for (asked, is_tie) in (0..100_000).map(|_| sphere(&mut random)) {
        let Shape::Sphere(sphere) = asked.shape else {
            panic!("a sphere was asked for");
        };
        let from_center = asked.ray.at(asked.min_t) - sphere.center;
        if from_center.length_squared() == sphere.radius * sphere.radius {
            seen[0] = true;
            assert!(is_tie, "{asked:?}");
        } else if is_tie {
            seen[1] = true;
        }
    }
    assert_eq!(seen, [true; 2], "at min_t, and tangent elsewhere");
}

#[test]
fn a_ray_to_the_edge_of_a_disk_or_to_it_at_min_t_is_a_tie() {
    let mut random = Random::new();
    let mut seen = [0; 2];
    for (asked, is_tie) in (0..100_000).map(|_| disk(&mut random)) {
        let Shape::Disk(disk) = asked.shape else {
            panic!("a disk was asked for");
        };
        let along = asked.ray.direction.dot(disk.normal);
        // Only where the quotient is exact.
        if ![1.0, 2.0, 4.0].contains(&along.abs()) {
            continue;
        }
        let t = (disk.center - asked.ray.origin).dot(disk.normal) / along;
        let away = asked.ray.at(t).distance_squared(disk.center);
        let (on_edge, at_min_t) = (away == disk.radius * disk.radius, t == asked.min_t);
        assert_eq!(is_tie, on_edge || at_min_t);
        seen[0] += usize::from(on_edge);
        seen[1] += usize::from(at_min_t);
    }
    assert!(seen.iter().all(|count| *count > 10), "{seen:?}");
}
