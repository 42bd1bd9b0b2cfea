//! `pinhole render --exact` and `--plan`: casts a film with the study's casters.

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
    if arguments.plan.is_none() && !arguments.wanted.outputs.is_empty() {
        return Err(Error::input(
            "--outputs needs a plan",
            "give the accuracy of the plan with --plan X",
        ));
    }
    let assignment = arguments.assignment.find(checkout, None)?;
    let (scene, _, golden) = scene(&arguments.scene, arguments.resolution, &assignment)?;
    let wish = match arguments.plan {
        None => film::EXACT,
        Some(accuracy) => arguments.wanted.wish(accuracy),
    };
    let (film, report) = film::planned(&scene, wish).map_err(unplannable)?;
    let spent = format!(
        "{} of {} tests, {} comparisons, and t and normals of {} pixels needed exact arithmetic",
        report.fallbacks, report.tests, report.close_calls, report.exact_hits
    );
    let (by, exact, planned) = match arguments.plan {
        None => (
            format!("the exact caster: {spent}"),
            Some(json!(report)),
            None,
        ),
        Some(accuracy) => {
            let why = format!(
                "why: {PINHOLE} plan {} --accuracy {accuracy:e}",
                arguments.scene
            );
            let by = format!("the plan for {accuracy:e}: {spent}; {why}");
            (by, None, Some(json!(report)))
        }
    };
    let cast = Cast {
        tests: None,
        expected_tests: None,
        scene: arguments.scene.clone(),
        film,
        by,
        seconds: report.seconds,
        problem: None,
        printed: String::new(),
        exact,
        planned,
        shares: None,
    };
    let depth_per_t = scene.camera.depth_per_t();
    cast.deliver(&arguments.out, golden, depth_per_t, arguments.json)
}
