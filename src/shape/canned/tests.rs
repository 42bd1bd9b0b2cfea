use super::*;
use glam::DVec3;

#[test]
fn a_canned_object_is_met_at_its_first_intersection_from_min_t_on() {
    let at = |t| Intersection {
        t,
        normal: DVec3::X,
    };
    let ray = Ray {
        origin: DVec3::ZERO,
        direction: DVec3::Y,
    };
    let object = Canned {
        ray,
        intersections: vec![at(-1.0), at(2.0), at(3.0)],
    };
    let met = |min_t| object.intersect(&ray, min_t).map(|found| found.t);
    assert_eq!(met(-5.0), Some(-1.0));
    assert_eq!(met(0.0), Some(2.0));
    assert_eq!(met(2.0), Some(2.0), "an intersection at min_t counts");
    assert_eq!(met(2.5), Some(3.0));
    assert_eq!(met(3.5), None);
}

#[test]
#[should_panic(expected = "pass `ray` on unchanged")]
fn a_canned_object_refuses_another_ray() {
    let ray = Ray {
        origin: DVec3::ZERO,
        direction: 2.0 * DVec3::Y,
    };
    let object = Canned {
        ray,
        intersections: Vec::new(),
    };
    let direction = ray.direction.normalize();
    object.intersect(&Ray { direction, ..ray }, 0.0);
}
