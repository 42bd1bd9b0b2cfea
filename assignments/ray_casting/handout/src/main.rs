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
use pinhole::Answers;

const ANSWERS: Answers = Answers {
    viewing_ray: viewing_ray::viewing_ray,
    first_hit: first_hit::first_hit,
    first_hit_canned: first_hit::first_hit,
    sphere: IntersectRay::intersect_ray,
    plane: IntersectRay::intersect_ray,
    triangle: IntersectRay::intersect_ray,
    triangle_soup: IntersectRay::intersect_ray,
    triangle_soup_canned: IntersectRay::intersect_ray,
};

fn main() -> ExitCode {
    pinhole::serve(&ANSWERS)
}
