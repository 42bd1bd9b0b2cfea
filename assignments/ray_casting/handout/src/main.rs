//! The program that casts your films. You need not change this file: it hands your
//! six answers to the harness, which asks them for pixels.

mod first_hit;
mod intersect_ray;
mod plane;
mod sphere;
mod triangle;
mod triangle_soup;
mod viewing_ray;

use std::process::ExitCode;

use intersect_ray::IntersectRay;
use pinhole::AnswerFn;

const ANSWERS: &[AnswerFn] = &[
    AnswerFn::ViewingRay(viewing_ray::viewing_ray),
    AnswerFn::Intersect(IntersectRay::intersect_ray),
    AnswerFn::FirstHit {
        shapes: first_hit::first_hit,
        canned: first_hit::first_hit,
    },
    AnswerFn::Soup(IntersectRay::intersect_ray),
];

fn main() -> ExitCode {
    pinhole::serve(ANSWERS)
}
