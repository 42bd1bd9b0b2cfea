//! `pinhole render --exact` and `--plan`: a film by the study's casters.

use pinhole_course::checkout::Checkout;
use pinhole_course::error::{Error, Result};
use pinhole_course::shell::PINHOLE;
use pinhole_report::cast::Cast;
use pinhole_report::program::Status;
use pinhole_study::film;
use serde_json::json;

use super::plan::{scene, unplannable};
use crate::cli::Render;

pub fn run(checkout: &Checkout, arguments: &Render) -> Result<Status> {
    if arguments.plan.is_none() && !arguments.wanted.is_empty() {
        return Err(Error::input(
            "--ids and --outputs say what a plan is for",
            "say how accurate it is to be with --plan X",
        ));
    }
    let assignment = arguments.assignment.find(checkout, None)?;
    let (scene, _, golden) = scene(&arguments.scene, arguments.resolution, &assignment)?;
    let (film, seconds, by, exact, planned) = match arguments.plan {
        None => {
            let (film, report) = film::exact(&scene);
            let by = format!(
                "the exact caster: {} of {} tests and {} comparisons needed exact arithmetic",
                report.fallbacks, report.tests, report.close_calls
            );
            (film, report.seconds, by, Some(json!(report)), None)
        }
        Some(accuracy) => {
            let wish = arguments.wanted.wish(accuracy);
            let (film, planned) = film::planned(&scene, wish).map_err(unplannable)?;
            let by = format!(
                "the plan for {accuracy:e}: {} pixels were cast again in f64, {} exactly; why: \
                 {PINHOLE} plan {} --accuracy {accuracy:e}",
                planned.spent.again_in_f64, planned.spent.again_exactly, arguments.scene
            );
            (film, planned.seconds, by, None, Some(json!(planned)))
        }
    };
    let cast = Cast {
        scene: arguments.scene.clone(),
        film,
        by,
        seconds,
        problem: None,
        printed: String::new(),
        exact,
        planned,
    };
    let depth_per_t = scene.camera.depth_per_t();
    cast.deliver(&arguments.out, golden, depth_per_t, arguments.json)
}
