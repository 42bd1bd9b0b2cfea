//! Asks the compiled reference like any submission. It runs in a process of its own, and is not
//! linked into this program.
//!
//! No tool may import a submission. So a number that the book attributes to the reference comes
//! from the very program that is judged against Mitsuba.

use std::time::Duration;

use pinhole::ask::{Ending, Reply};
use pinhole::job::Job;
use pinhole::kind::{Answer, CameraQuestion, Questions, SearchQuestion, ShapeQuestion};
use pinhole::{Camera, Hit, Intersection, Pixel, Ray, Resolution, Shape, Triangle};

use pinhole_course::assignment::Assignment;
use pinhole_course::checkout::Checkout;
use pinhole_course::compile::{Program, compile};
use pinhole_course::examine;
use pinhole_course::overlay;
use pinhole_course::sandbox::{Limits, Sandbox};

use crate::course::assignment;
use crate::error::{Error, Result};

/// The running reference.
pub struct Reference {
    program: Program,
}

/// The longest time for a question of the book.
const WALL: Duration = Duration::from_secs(60);

impl Reference {
    /// Builds the reference of the first assignment.
    pub fn build(checkout: &Checkout) -> Result<Reference> {
        Reference::of(&assignment(checkout)?, checkout)
    }

    /// Builds the reference of an assignment.
    pub fn of(assignment: &Assignment, checkout: &Checkout) -> Result<Reference> {
        let submission = overlay::reference(assignment)?;
        let program = compile(&submission, assignment, checkout, &Sandbox::Trusted)?;
        Ok(Reference { program })
    }

    /// The ray through the centre of a pixel.
    pub fn viewing_ray(&self, camera: Camera, pixel: Pixel, resolution: Resolution) -> Result<Ray> {
        let question = CameraQuestion {
            camera,
            pixel,
            resolution,
        };
        match self.ask(&Job::Ask(Questions::ViewingRay(vec![question])))? {
            Answer::Ray(ray) => Ok(ray),
            _ => Err(odd()),
        }
    }

    /// Where a ray meets a single shape.
    pub fn intersect(&self, shape: &Shape, ray: Ray, min_t: f64) -> Result<Option<Intersection>> {
        let question = ShapeQuestion {
            shape: shape.clone(),
            ray,
            min_t,
        };
        match self.ask(&Job::Ask(Questions::Intersect(vec![question])))? {
            Answer::Hit(hit) => Ok(hit.map(|hit| hit.intersection)),
            _ => Err(odd()),
        }
    }

    /// The ray through each pixel's centre, row by row from the top.
    pub fn viewing_rays(&self, camera: Camera, resolution: Resolution) -> Result<Vec<Ray>> {
        let pixels = (0..resolution.n_y)
            .rev()
            .flat_map(|j| (0..resolution.n_x).map(move |i| Pixel { i, j }));
        let question = |pixel| CameraQuestion {
            camera,
            pixel,
            resolution,
        };
        let questions = Questions::ViewingRay(pixels.map(question).collect());
        let ray = |answer| match answer {
            Some(Answer::Ray(ray)) => Ok(ray),
            _ => Err(odd()),
        };
        let answers = self.reply(&Job::Ask(questions))?.answers;
        answers.into_iter().map(ray).collect()
    }

    /// Where each of these rays meets a single shape.
    pub fn intersect_all(
        &self,
        shape: &Shape,
        rays: &[Ray],
        min_t: f64,
    ) -> Result<Vec<Option<Intersection>>> {
        let question = |ray: &Ray| ShapeQuestion {
            shape: shape.clone(),
            ray: *ray,
            min_t,
        };
        let questions = Questions::Intersect(rays.iter().map(question).collect());
        let met = |answer| match answer {
            Some(Answer::Hit(hit)) => Ok(hit.map(|hit: Hit| hit.intersection)),
            _ => Err(odd()),
        };
        let answers = self.reply(&Job::Ask(questions))?.answers;
        answers.into_iter().map(met).collect()
    }

    /// Where a ray meets these triangles: t for each of them, without those that it misses.
    pub fn each(&self, triangles: &[Triangle], ray: Ray, min_t: f64) -> Result<Vec<f64>> {
        let question = |triangle: &Triangle| ShapeQuestion {
            shape: Shape::Triangle(*triangle),
            ray,
            min_t,
        };
        let questions = Questions::Intersect(triangles.iter().map(question).collect());
        let reply = self.reply(&Job::Ask(questions))?;
        let t = |answer| match answer {
            Some(Answer::Hit(hit)) => hit.map(|hit: Hit| hit.intersection.t),
            _ => None,
        };
        Ok(reply.answers.into_iter().filter_map(t).collect())
    }

    /// What a ray meets first of a list.
    pub fn first_hit(&self, shapes: &[Shape], ray: Ray, min_t: f64) -> Result<Option<Hit>> {
        match self.ask(&Job::Cast(ray, min_t, shapes.to_vec()))? {
            Answer::Hit(hit) => Ok(hit),
            _ => Err(odd()),
        }
    }

    /// A scene's film.
    pub fn film(&self, scene: &pinhole::Scene) -> Result<pinhole::Film> {
        let resolution = scene.resolution;
        let reply = self.reply(&Job::Film(scene.clone()))?;
        Ok(reply.film(resolution))
    }

    /// What a ray meets first in a tree, and how many tests it takes to find that.
    pub fn search(&self, question: SearchQuestion) -> Result<(Option<Hit>, u32)> {
        let reply = self.reply(&Job::Ask(Questions::TreeSearch(vec![question])))?;
        match (reply.answers.as_slice(), reply.tests.as_slice()) {
            ([Some(Answer::Hit(hit))], [tests]) => Ok((*hit, *tests)),
            _ => Err(odd()),
        }
    }

    /// The answer to a single question.
    pub fn ask(&self, job: &Job) -> Result<Answer> {
        let answers = self.reply(job)?.answers;
        answers.into_iter().next().flatten().ok_or_else(odd)
    }

    /// The reply to a job, with all its answers.
    pub fn reply(&self, job: &Job) -> Result<Reply> {
        let limits = Limits::of_answers(WALL);
        let reply = examine::run(&self.program, &Sandbox::Trusted, &limits, job, &mut |_| {})?;
        match &reply.ending {
            Ending::Complete => Ok(reply),
            other => Err(Error::environment(
                format!("the reference does not answer: {other:?}"),
                "run `pinhole check` on the assignment's `reference` folder",
            )),
        }
    }
}

fn odd() -> Error {
    Error::environment(
        "the reference gives an answer of another kind",
        "report this",
    )
}
