//! The report: one HTML file that opens from disk and loads nothing else.
//!
//! Reading order: `task` and `scene` hold what the page shows; `cause` says why a pixel is wrong;
//! `heat` shows tests, `tree` shows trees and `ray_drawing` shows where rays go; `belief` holds
//! diagnoses; `pixels`, `window` and `rays` hold the data of films; `page` turns it all into HTML.
//! Then read `templates`, and `viewer.js` there.

mod belief;
mod cause;
mod heat;
pub mod mark;
mod page;
mod picture;
mod pixels;
mod ray_drawing;
mod rays;
mod scene;
mod task;
#[cfg(test)]
mod testing;
#[cfg(test)]
mod tests;
mod tree;
mod window;

use std::path::Path;

use pinhole::{Film, Scene};
use rayon::prelude::{IndexedParallelIterator, IntoParallelRefIterator, ParallelIterator};
use serde::Serialize;

use crate::escape::{printable, printable_word};
use crate::finish::Finish;
use crate::passage::Passage;
use crate::terminal;
use belief::BeliefReference;
pub use belief::Beliefs;
pub use heat::HeatMaps;
pub use page::{PAGE_CSS, environment, policy};
use pinhole_course::error::{Result, ResultExt};
use pinhole_course::goldens::tests_beside;
use pinhole_course::outcome::{Examination, FilmOutcome, Outcome, SceneFilm, SceneOutcome};
pub use rays::{RayGrid, SubmittedRays};
pub use scene::{Evidence, SceneSection};
pub use task::{GroupRow, TaskSection};

/// Lines of a student's own output that are kept.
const MOST_PRINTED_LINES: usize = 200;

/// The contents of the page.
#[derive(Debug, Serialize)]
pub struct Report {
    /// The assignment's title, or the film's name.
    pub title: String,
    /// What was judged, as pairs of its kind and its path.
    pub of: Vec<(&'static str, String)>,
    pub passes: bool,
    /// The whole verdict in a sentence.
    pub said: String,
    /// Points earned and possible, if there are any.
    pub points: Option<(u32, u32)>,
    pub tasks: Vec<TaskSection>,
    pub scenes: Vec<SceneSection>,
    /// What the student's code printed.
    pub printed: Vec<String>,
    pub more_printed: usize,
    /// What to say of so much output.
    pub on_printed: Option<&'static str>,
    /// The command that repeats the examination.
    pub command: String,
    /// The book's address on the machine that will show this page.
    pub book: Option<String>,
    /// What to show a student who has earned all points.
    pub finish: Option<FinishSection>,
}

/// What the page shows when all points are earned.
#[derive(Debug, Serialize)]
pub struct FinishSection {
    pub scene: String,
    /// The picture's address.
    pub picture: String,
    /// The command that packs the answers to hand in.
    pub command: String,
    pub next: Passage,
}

impl FinishSection {
    /// The section for a student who has all points.
    pub fn of(finish: Finish) -> FinishSection {
        FinishSection {
            picture: picture::address(&finish.picture),
            command: finish.pack,
            scene: finish.scene,
            next: finish.next,
        }
    }
}

/// Commands that repeat an examination.
#[derive(Clone, Debug)]
pub struct RepeatCommands {
    /// The command as it was typed.
    pub whole: String,
    /// The command without tasks and scenes, so that one can be added.
    pub part: String,
}

impl Report {
    /// The report of an examination that used the golden films in a folder. `again` is the command
    /// that repeats it.
    ///
    /// # Errors
    /// If a scene file cannot be read any more.
    pub fn of_examination(
        examination: &Examination,
        goldens: &Path,
        again: &RepeatCommands,
    ) -> Result<Report> {
        let Examination {
            outcome,
            films,
            pictures,
        } = examination;
        let tasks = outcome.tasks.iter().enumerate();
        let told: Vec<BeliefReference> = tasks
            .clone()
            .flat_map(|(k, task)| BeliefReference::by_task(k, &task.name, &task.diagnosis))
            .collect();
        let most = match outcome.scenes.len() {
            1 => window::MOST_ALONE,
            _ => window::MOST_EACH,
        };
        let scenes = outcome.scenes.par_iter().zip(films).enumerate();
        let scenes = scenes.map(|(k, (scene, film))| {
            let evidence = JudgedScene {
                scene,
                film,
                examination,
                submission: &outcome.submission,
                goldens,
                again,
                told: &told,
            };
            evidence.section(k, most)
        });
        let lines: Vec<String> = outcome.printed.lines().map(printable).collect();
        let earlier = outcome.earlier.iter().map(terminal::earlier_in_words);
        let said = [Some(summary(outcome)), terminal::withheld_in_words(outcome)];
        let said = said.into_iter().flatten().chain(earlier);
        Ok(Report {
            title: outcome.assignment.clone(),
            of: vec![("submission", printable(&outcome.submission))],
            passes: outcome.passes,
            said: said.collect::<Vec<_>>().join(" "),
            points: outcome.points.map(|points| (points, outcome.possible)),
            tasks: tasks
                .map(|(k, task)| TaskSection::of(k, task, pictures, &again.part))
                .collect(),
            scenes: scenes.collect::<Result<_>>()?,
            more_printed: lines.len().saturating_sub(MOST_PRINTED_LINES),
            on_printed: terminal::on_much_output(&outcome.printed),
            printed: lines.into_iter().take(MOST_PRINTED_LINES).collect(),
            command: again.whole.clone(),
            book: None,
            finish: None,
        })
    }

    /// The report of one film. `golden` and `film` are the paths of the two films.
    pub fn of_film(evidence: Evidence, golden: &str, film: &str) -> Report {
        let section = SceneSection::of(0, evidence, window::MOST_ALONE);
        Report {
            title: section.name.clone(),
            of: vec![("film", printable(film)), ("golden", printable(golden))],
            passes: section.passes,
            said: match section.passes {
                true => "The film agrees with its golden at every pixel.".into(),
                false => "The film differs from its golden.".into(),
            },
            points: None,
            tasks: Vec::new(),
            printed: Vec::new(),
            more_printed: 0,
            on_printed: None,
            command: section.command.clone(),
            book: None,
            finish: None,
            scenes: vec![section],
        }
    }

    /// Writes the page, and makes folders where needed.
    pub fn write(&self, path: &Path) -> Result<()> {
        page::write(path, &self.html()).or_input(
            format_args!("cannot write the report {}", path.display()),
            "name another file with --report, or pass --no-report",
        )
    }
}

fn summary(outcome: &Outcome) -> String {
    if outcome.passes {
        return "Everything that was judged passes.".into();
    }
    let passing = |what: &str, all: Vec<bool>| {
        let good = all.iter().filter(|passes| **passes).count();
        (!all.is_empty()).then(|| format!("{good} of {} {what}", all.len()))
    };
    let tasks = outcome.tasks.iter();
    let tasks = tasks.map(|task| task.points == task.possible).collect();
    let scenes = outcome.scenes.iter().map(|scene| scene.outcome.passes());
    let parts = [passing("tasks", tasks), passing("scenes", scenes.collect())];
    let parts: Vec<String> = parts.into_iter().flatten().collect();
    format!("{} pass.", parts.join(" and "))
}

/// A scene's result, and what the page says about it.
struct JudgedScene<'a> {
    scene: &'a SceneOutcome,
    film: &'a SceneFilm,
    examination: &'a Examination,
    submission: &'a str,
    goldens: &'a Path,
    again: &'a RepeatCommands,
    told: &'a [BeliefReference],
}

impl JudgedScene<'_> {
    fn section(&self, k: usize, most: usize) -> Result<SceneSection> {
        let (result, cast) = (self.scene, self.film);
        let passes = result.outcome.passes();
        let scene = match passes {
            true => None,
            false => Some(Scene::read(&cast.file)?),
        };
        let rays = match passes || cast.film.is_none() {
            true => None,
            false => rays_beside(&self.goldens.join(&result.name)),
        };
        let evidence = Evidence {
            name: result.name.clone(),
            passes,
            said: terminal::scene_in_words(result),
            attempted: !matches!(
                result.outcome,
                FilmOutcome::Unanswered | FilmOutcome::Blocked { .. }
            ),
            points: Some((result.points, result.possible)),
            verdict: cast.verdict.as_ref(),
            golden: &cast.golden,
            film: cast.film.as_ref(),
            heat: cast.tests.as_ref().and_then(|tests| {
                match Film::read(&tests_beside(&self.goldens.join(&result.name))) {
                    Ok(expected) => HeatMaps::beside(&expected, tests),
                    Err(_) => HeatMaps::alone(tests),
                }
            }),
            scene: scene.as_ref(),
            unanswered: cast.unanswered.map(|unanswered| unanswered.pixel),
            rays,
            own_rays: SubmittedRays::of(&cast.rays, rays.as_ref()),
            beliefs: Beliefs::of(&result.diagnosis, self.told),
            remarks: match passes {
                true => Vec::new(),
                false => {
                    let note = terminal::note(cast).into_iter();
                    note.chain(terminal::remarks(self.examination, cast))
                        .collect()
                }
            },
            command: format!(
                "{} --scene {}",
                self.again.part,
                printable_word(&result.name)
            ),
            explain: Some(terminal::explain(&cast.argument, self.submission)),
        };
        Ok(SceneSection::of(k, evidence, most))
    }
}

/// The rays of a golden's pixels, if their film lies beside it as `NAME.rays.exr`.
pub fn rays_beside(golden: &Path) -> Option<RayGrid> {
    RayGrid::of(&Film::read(&golden.with_extension("rays.exr")).ok()?)
}
