//! The program that casts your films. You need not change this file: it hands your
//! answers to the harness.

mod build_tree;
mod casting;
mod intersect_ray;
mod nearest_hit;
mod ray_box;
mod triangle;
mod triangle_box;

use std::process::ExitCode;

use pinhole::AnswerFn;

const ANSWERS: &[AnswerFn] = &[
    AnswerFn::ViewingRay(casting::viewing_ray),
    AnswerFn::Intersect(casting::intersect),
    AnswerFn::FirstHit {
        shapes: casting::first_hit,
        canned: casting::first_canned_hit,
    },
    AnswerFn::Bounds {
        of_triangle: triangle_box::triangle_box,
        join: triangle_box::join,
    },
    AnswerFn::RayBox(ray_box::ray_box),
    AnswerFn::Tree(build_tree::build_tree),
    AnswerFn::TreeSearch(nearest_hit::nearest_hit),
];

fn main() -> ExitCode {
    pinhole::serve(ANSWERS)
}
