use glam::{DVec3, dvec3};

use super::*;
use crate::camera::{Camera, Projection, Resolution};
use crate::kind::Answer;
use crate::ray::Intersection;
use crate::shape::{Plane, Sphere};

/// Three pixels: the golden film shows the sphere, the plane and nothing.
const RESOLUTION: Resolution = Resolution { n_x: 3, n_y: 1 };

fn scene() -> Scene {
    let projection = Projection::Orthographic;
    let camera = Camera::new(DVec3::ZERO, DVec3::X, DVec3::Y, (3.0, 1.0), projection);
    Scene {
        camera: camera.expect("view and up differ"),
        resolution: RESOLUTION,
        min_t: 0.0,
        objects: vec![
            Shape::Sphere(Sphere {
                center: DVec3::ZERO,
                radius: 1.0,
            }),
            Shape::Plane(Plane {
                point: DVec3::ZERO,
                normal: DVec3::X,
            }),
        ],
    }
}

fn hit(object: usize, t: f64) -> Option<Hit> {
    let normal = DVec3::Y;
    let intersection = Intersection { t, normal };
    Some(Hit {
        object,
        intersection,
    })
}

fn ray(x: f64) -> Ray {
    Ray {
        origin: dvec3(x, 0.0, 0.0),
        direction: DVec3::X,
    }
}

/// Golden hits at t = 5, golden rays from x = 100.
fn preview(mut ask: impl FnMut(&Job) -> Option<Reply>) -> Preview {
    let golden = Film::of_hits(RESOLUTION, &[hit(0, 5.0), hit(1, 5.0), None]);
    let rays = Film::of_rays(RESOLUTION, &[ray(100.0); 3]);
    let Ok(preview) = Preview::new(&scene(), &golden, &rays, &mut |job| {
        Ok::<_, std::convert::Infallible>(ask(job))
    });
    preview
}

fn answered(job: &Job, answer: impl Fn(usize) -> Answer) -> Option<Reply> {
    let mut reply = Reply::before(job);
    for (index, place) in reply.answers.iter_mut().enumerate() {
        *place = Some(answer(index));
    }
    Some(reply)
}

#[test]
fn with_no_answer_at_all_the_golden_film_is_copied() {
    let preview = preview(|_| None);
    assert_eq!(preview.copied, [true, true, false]);
    assert_eq!(preview.answered, []);
    assert_eq!(preview.film.hit(0), hit(0, 5.0));
    assert_eq!(preview.film.hit(1), hit(1, 5.0));
    assert_eq!(preview.film.hit(2), None);
}

#[test]
fn one_shape_alone_is_intersected_along_the_golden_rays() {
    let preview = preview(|job| match job {
        Job::Meet(_, rays) if rays[0].1 == 1 => {
            assert_eq!(rays.as_slice(), [(ray(100.0), 1)]);
            answered(job, |_| Answer::Hit(hit(0, 7.0)))
        }
        _ => None,
    });
    assert_eq!(preview.copied, [true, false, false]);
    let plane = (Kind::Intersect, Some(ShapeKind::Plane));
    let sphere = (Kind::Intersect, Some(ShapeKind::Sphere));
    assert_eq!(preview.answered, [plane]);
    let others = [(Kind::ViewingRay, None), sphere];
    assert_eq!(preview.missing, others);
    assert_eq!(preview.film.hit(0), hit(0, 5.0));
    assert_eq!(preview.film.hit(1), hit(1, 7.0), "it keeps the object's id");
}

#[test]
fn a_wrong_viewing_ray_and_a_wrong_miss_are_shown_as_they_are() {
    let preview = preview(|job| match job {
        Job::Meet(_, rays) => {
            assert_eq!(rays[0].0, ray(rays[0].1 as f64), "the submission's own");
            answered(job, |_| Answer::Hit(None))
        }
        _ => answered(job, |index| Answer::Ray(ray(index as f64))),
    });
    assert_eq!(preview.copied, [false; 3]);
    assert_eq!(preview.film.hit(0), None);
    assert_eq!(preview.missing, []);
}
