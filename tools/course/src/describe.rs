//! Rays, hits and differences in the words of the lecture.

use glam::DVec3;
use pinhole::ask::Reply;
use pinhole::job::{Answer, Job};
use pinhole::judge::Verdict;
use pinhole::report::{digits_to_tell, number};
use pinhole::{Film, Hit, Intersection, Projection, Ray, Shape};

use crate::goldens::questions::QuestionFilm;

/// The worst question of a verdict: what was asked, expected, and given.
///
/// `None` if the verdict passes.
pub fn worst(verdict: &Verdict, asked: &QuestionFilm, reply: &Reply) -> Option<String> {
    let QuestionFilm {
        name, job, golden, ..
    } = asked;
    let channel = verdict
        .channels
        .iter()
        .find(|channel| channel.failing > 0)?;
    let mismatch = channel.worst?;
    let index = verdict.resolution.index(mismatch.pixel);
    let digits = digits_to_tell(&mismatch);
    let question = question(job, index, name, digits);
    let got = match reply.answers.get(index).copied().flatten() {
        Some(Answer::Hit(hit)) => {
            let shown = hit.map(|hit| (hit.object, hit.intersection));
            intersection(shown, matches!(job, Job::FirstHit(_)), digits)
        }
        Some(Answer::Ray(answer)) => ray(&answer, digits),
        None => "nothing".into(),
    };
    let expected = expected(
        golden.film(),
        index,
        matches!(job, Job::FirstHit(_)),
        digits,
    );
    let mut words = format!("{question}\nexpected  {expected}\ngot       {got}");
    // An object is right or wrong; for all else it helps to see how near is near enough.
    if channel.name != "id" {
        let allowed = number(f64::from(mismatch.allowed), 2);
        words.push_str(&format!("\nallowed   {} ± {allowed}", channel.name));
    }
    Some(words)
}

/// A question in words.
pub fn question(job: &Job, index: usize, part: &str, digits: usize) -> String {
    match job {
        Job::ViewingRay(questions) => {
            let asked = &questions[index];
            let camera = &asked.camera;
            let projection = match camera.projection {
                Projection::Perspective { focal_length } => {
                    format!("perspective, focal length {}", number(focal_length, digits))
                }
                Projection::Orthographic => "orthographic".into(),
            };
            format!(
                "pixel     {} of {}, {part}\ncamera    {projection}, {} × {}, eye {}\n          u {}  v {}  w {}",
                asked.pixel,
                asked.resolution,
                number(camera.width, digits),
                number(camera.height, digits),
                vector(camera.eye, digits),
                vector(camera.u, digits),
                vector(camera.v, digits),
                vector(camera.w, digits),
            )
        }
        Job::Intersect(questions) => {
            let asked = &questions[index];
            let shape = shape(&asked.shape, digits);
            let (kind, rest) = shape.split_once(' ').unwrap_or((&shape, ""));
            format!(
                "{}\n{kind:<9} {rest}",
                from(&asked.ray, asked.min_t, digits)
            )
        }
        Job::FirstHit(questions) | Job::TriangleSoup(questions) => {
            let asked = &questions[index];
            let answers = asked
                .objects
                .triangles
                .iter()
                .enumerate()
                .map(|(k, object)| {
                    let ts = object.intersections.iter().map(|at| number(at.t, digits));
                    let ts: Vec<String> = ts.collect();
                    format!(
                        "{k}: {}",
                        if ts.is_empty() {
                            "never".into()
                        } else {
                            ts.join(", ")
                        }
                    )
                });
            let objects = answers.collect::<Vec<_>>().join("; ");
            format!(
                "min_t     {}\nobjects   met at t = {{ {objects} }}",
                number(asked.min_t, digits)
            )
        }
        Job::Film(_) | Job::Cast(..) => String::new(),
    }
}

fn expected(golden: &Film, index: usize, with_object: bool, digits: usize) -> String {
    if golden.channel("id").is_none() {
        return ray(&ray_in_film(golden, index), digits);
    }
    let hit = hit_in_film(golden, index).map(|hit| (hit.object, hit.intersection));
    intersection(hit, with_object, digits)
}

/// What a film of hits shows at `index`.
pub fn hit_in_film(film: &Film, index: usize) -> Option<Hit> {
    let id = sample(film, "id", index);
    let intersection = Intersection {
        t: sample(film, "t", index),
        normal: vector_in_film(film, "N", index),
    };
    (id >= 0.0).then_some(Hit {
        object: id as usize,
        intersection,
    })
}

/// What a film of rays shows at `index`.
pub fn ray_in_film(film: &Film, index: usize) -> Ray {
    Ray {
        origin: vector_in_film(film, "O", index),
        direction: vector_in_film(film, "D", index),
    }
}

fn vector_in_film(film: &Film, name: &str, index: usize) -> DVec3 {
    let [x, y, z] = ["X", "Y", "Z"].map(|axis| sample(film, &format!("{name}.{axis}"), index));
    DVec3::new(x, y, z)
}

fn sample(film: &Film, channel: &str, index: usize) -> f64 {
    film.channel(channel)
        .map_or(0.0, |samples| f64::from(samples[index]))
}

/// "t = 3.2, normal (0, 1, 0)", with the object where that matters.
pub fn intersection(
    hit: Option<(usize, Intersection)>,
    with_object: bool,
    digits: usize,
) -> String {
    let Some((object, at)) = hit else {
        return "no hit".into();
    };
    let object = if with_object {
        format!("object {object} at ")
    } else {
        String::new()
    };
    format!(
        "{object}t = {}, normal {}",
        number(at.t, digits),
        vector(at.normal, digits)
    )
}

/// "e = (0, 0, 0), d = (0, 0, −1)".
pub fn ray(ray: &Ray, digits: usize) -> String {
    format!(
        "e = {}, d = {}",
        vector(ray.origin, digits),
        vector(ray.direction, digits)
    )
}

fn from(asked: &Ray, min_t: f64, digits: usize) -> String {
    format!(
        "ray       {}, min_t = {}",
        ray(asked, digits),
        number(min_t, digits)
    )
}

/// A shape as its scene file would have it.
pub fn shape(shape: &Shape, digits: usize) -> String {
    match shape {
        Shape::Sphere(sphere) => {
            format!(
                "sphere c = {}, r = {}",
                vector(sphere.center, digits),
                number(sphere.radius, digits)
            )
        }
        Shape::Plane(plane) => {
            format!(
                "plane through {}, n = {}",
                vector(plane.point, digits),
                vector(plane.normal, digits)
            )
        }
        Shape::Triangle(triangle) => {
            let [a, b, c] = triangle.corners.map(|corner| vector(corner, digits));
            format!("triangle a = {a}, b = {b}, c = {c}")
        }
        Shape::Soup(soup) => format!("soup of {} triangles", soup.triangles.len()),
    }
}

/// The task that intersects this shape.
pub fn kind(shape: &Shape) -> &'static str {
    match shape {
        Shape::Sphere(_) => "sphere",
        Shape::Plane(_) => "plane",
        Shape::Triangle(_) => "triangle",
        Shape::Soup(_) => "triangle_soup",
    }
}

/// "(0.5, 1, −2)".
pub fn vector(vector: DVec3, digits: usize) -> String {
    let [x, y, z] = vector.to_array().map(|value| number(value, digits));
    format!("({x}, {y}, {z})")
}
