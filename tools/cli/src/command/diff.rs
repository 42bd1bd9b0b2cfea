//! `pinhole diff`: asks both judges about a film by any renderer.

use std::path::{Path, PathBuf};

use pinhole::film::HIT_CHANNELS;
use pinhole::heat_map::HeatScale;
use pinhole::judge::{Golden, Refusal, Verdict, judge};
use pinhole::oiiotool::{Oiiotool, SecondVerdict};
use pinhole::{Film, Scene, false_colour};
use serde_json::json;

use crate::cli::Diff;
use pinhole_course::assignment::ScenePoints;
use pinhole_course::checkout::Checkout;
use pinhole_course::diagnosis::Diagnosis;
use pinhole_course::error::{Error, Result};
use pinhole_course::goldens::Goldens;
use pinhole_course::mitsuba;
use pinhole_course::outcome::FilmOutcome;
use pinhole_course::output;
use pinhole_course::shell::PINHOLE;
use pinhole_report::escape::{printable, printable_word};
use pinhole_report::html::{self, Beliefs, Evidence, HeatMaps, Report, SubmittedRays};
use pinhole_report::program::Status;
use pinhole_report::{json, pictures, terminal};

pub fn run(checkout: &Checkout, arguments: &Diff) -> Result<Status> {
    let golden = Golden::read(&arguments.golden)?;
    // A film that can't be read is judged wrong, like a film of the wrong size. A film that isn't
    // there is an error.
    if !arguments.film.is_file() {
        let problem = format!("there is no film file {}", arguments.film.display());
        return Err(Error::input(problem, "name the film to judge"));
    }
    let film = Film::read(&arguments.film);
    let verdict = film.as_ref().map(|film| judge(&golden, film));
    let second = match Oiiotool::find(&mitsuba::environment(checkout)) {
        Some(tool) => Some(
            tool.judge(&arguments.golden, &arguments.film)
                .map_err(|problem| {
                    Error::environment(
                        problem,
                        "install Mitsuba and oiiotool again: cargo pinhole golden setup",
                    )
                })?,
        ),
        None => None,
    };
    let passes = matches!(&verdict, Ok(Ok(verdict)) if verdict.passes());
    // oiiotool may accept a damaged file that we refuse. Compare verdicts only if both judges could
    // read the film.
    if let (Some(second), Ok(_)) = (&second, &film)
        && second.passes != passes
    {
        return Err(disagreement(passes, second));
    }

    let diagnosis = match &film {
        Ok(film) if !passes => {
            let goldens = Goldens::around(&arguments.golden)?;
            let name = goldens.film_name(&arguments.golden);
            goldens.diagnose_film(&name, &golden, film)?
        }
        _ => Diagnosis::default(),
    };
    let mut written = Vec::new();
    if let Some(folder) = &arguments.out {
        output::make_folder(folder)?;
        if let Ok(film) = &film {
            written = draw(folder, &golden, film)?;
        }
    }
    let mut report = None;
    if let Some(path) = report_path(arguments) {
        film_report(checkout, arguments, &golden, &film, &verdict, &diagnosis)?.write(&path)?;
        report = Some(path.display().to_string());
    }
    if arguments.json {
        let judged = match &verdict {
            Ok(verdict) => json::verdict(verdict),
            Err(error) => json!({ "kind": "refused", "why": error.problem }),
        };
        let second = second.map(|second| json!({ "passes": second.passes, "said": second.said }));
        anstream::println!(
            "{:#}",
            json!({
                "passes": passes,
                "verdict": judged,
                "diagnosis": json::diagnosis(&diagnosis),
                "oiiotool": second,
                "pictures": written,
                "report": report,
            })
        );
    } else {
        match &verdict {
            Ok(verdict) => print(verdict),
            Err(error) => anstream::println!("refused: {}", printable(&error.problem)),
        }
        if !diagnosis.is_empty() {
            anstream::println!("{}", terminal::diagnosis(&diagnosis));
        }
        match second {
            Some(second) if second.passes != passes => {
                anstream::println!(
                    "oiiotool can read this file, but Pinhole refuses it as damaged"
                );
            }
            Some(second) => anstream::println!("oiiotool agrees{}", said(&second)),
            None => anstream::println!(
                "oiiotool was not asked: it is not installed (cargo pinhole golden setup \
                 installs it)"
            ),
        }
        for line in written.iter().map(|file| format!("wrote {file}")) {
            anstream::println!("{line}");
        }
        if let Some(report) = &report {
            anstream::println!("report: {}", printable(report));
        }
        if !written.is_empty() && !passes {
            for (_, words) in false_colour::Difference::LEGEND {
                anstream::println!("  difference.png, {words}");
            }
        }
    }
    Ok(if passes {
        Status::Well
    } else {
        Status::JudgedWrong
    })
}

fn said(second: &SecondVerdict) -> String {
    match second.said.as_str() {
        "" => String::new(),
        words => format!(" ({})", printable(words)),
    }
}

fn print(verdict: &std::result::Result<Verdict, Refusal>) {
    match verdict {
        Err(refusal) => anstream::println!("refused: {refusal}"),
        Ok(verdict) => match verdict.exempt {
            1 => anstream::println!("{verdict}\n  1 pixel is exempt"),
            some => anstream::println!("{verdict}\n  {some} pixels are exempt"),
        },
    }
}

fn report_path(arguments: &Diff) -> Option<PathBuf> {
    let in_folder = |folder: &PathBuf| folder.join("report.html");
    arguments
        .report
        .clone()
        .or(arguments.out.as_ref().map(in_folder))
}

/// The report of a judged film.
fn film_report(
    checkout: &Checkout,
    arguments: &Diff,
    golden: &Golden,
    film: &std::result::Result<Film, pinhole::Error>,
    verdict: &std::result::Result<std::result::Result<Verdict, Refusal>, &pinhole::Error>,
    diagnosis: &Diagnosis,
) -> Result<Report> {
    let [golden_path, film_path] =
        [&arguments.golden, &arguments.film].map(|path| path.display().to_string());
    let scene = scene(checkout, arguments)?;
    let (said, verdict) = match verdict {
        Ok(judged) => {
            let said = terminal::outcome(&FilmOutcome::from(judged));
            (said, judged.as_ref().ok())
        }
        Err(error) => (format!("refused: {}", printable(&error.problem)), None),
    };
    let name = arguments.golden.file_stem().unwrap_or_default();
    let command = format!(
        "{PINHOLE} diff {} {}",
        printable_word(&golden_path),
        printable_word(&film_path)
    );
    Ok(Report::of_film(
        Evidence {
            name: printable(&name.to_string_lossy()),
            passes: verdict.is_some_and(Verdict::passes),
            said,
            attempted: true,
            points: None,
            verdict,
            golden,
            film: film.as_ref().ok(),
            heat: film
                .as_ref()
                .ok()
                .and_then(|film| HeatMaps::beside(golden.film(), film)),
            scene: scene.as_ref(),
            unanswered: None,
            rays: html::rays_beside(&arguments.golden),
            own_rays: SubmittedRays::Unknown,
            beliefs: Beliefs::of(diagnosis, &[]),
            remarks: Vec::new(),
            command,
            explain: None,
        },
        &golden_path,
        &film_path,
    ))
}

/// The scene that both films show, if it is known.
fn scene(checkout: &Checkout, arguments: &Diff) -> Result<Option<Scene>> {
    let assignment = arguments
        .assignment
        .find(checkout, Some(&arguments.golden))?;
    if let Some(named) = &arguments.scene {
        return Ok(Some(assignment.find_scene(named)?.0));
    }
    let is_own = |scene: &&ScenePoints| {
        let golden = assignment.golden().join(&scene.name).with_extension("exr");
        match (golden.canonicalize(), arguments.golden.canonicalize()) {
            (Ok(own), Ok(given)) => own == given,
            _ => false,
        }
    };
    match assignment.scenes.iter().find(is_own) {
        Some(scene) => Ok(Some(Scene::read(&assignment.scene(&scene.name))?)),
        None => Ok(None),
    }
}

/// Pictures of golden, film and difference. None for a film without hits.
fn draw(folder: &Path, golden: &Golden, film: &Film) -> Result<Vec<String>> {
    let drawable = |film: &Film| HIT_CHANNELS.iter().all(|name| film.channel(name).is_some());
    if !drawable(golden.film()) || !drawable(film) {
        return Ok(Vec::new());
    }
    // Show t and not depth, because a film does not know its camera. The two are proportional.
    let range = false_colour::depth_range(golden.film(), 1.0);
    let mut written = Vec::new();
    for (prefix, film) in [("expected", golden.film()), ("got", film)] {
        written.extend(pictures::write(
            folder,
            &format!("{prefix}-"),
            film,
            1.0,
            range.clone(),
            &[],
        )?);
    }
    if let Some(scale) = HeatScale::of(&[golden.film(), film]) {
        for (prefix, film) in [("expected-", golden.film()), ("got-", film)] {
            written.push(pictures::write_tests(folder, prefix, film, &scale)?);
        }
    }
    if film.resolution() == golden.film().resolution() {
        let path = folder.join("difference.png");
        pictures::save(&false_colour::difference(golden, film), &path)?;
        written.push(path.display().to_string());
    }
    Ok(written)
}

fn disagreement(passes: bool, second: &SecondVerdict) -> Error {
    let word = |passes: bool| if passes { "passes" } else { "fails" };
    Error::environment(
        format!(
            "the two judges disagree: the film {} in Pinhole and {} in oiiotool{}",
            word(passes),
            word(second.passes),
            said(second)
        ),
        "this is a bug in Pinhole, and the film may be right: report it with both films",
    )
}
