//! Tests whether a mark depends on the draw: asks every known wrong answer the fresh questions of
//! many seeds.
//!
//! An answer that fails the public questions of a group earns nothing there, whatever was drawn.
//! So only groups whose public questions pass are asked.

use std::path::{Path, PathBuf};
use std::{fmt, fs};

use pinhole::ask::Reply;
use pinhole::judge::judge;
use serde::Serialize;

use super::mutants;
use super::sentences::ask;
use super::validator::Validator;
use pinhole_course::assignment::Task;
use pinhole_course::compile::Program;
use pinhole_course::error::{Error, Result, ResultExt};
use pinhole_course::goldens::Goldens;
use pinhole_course::goldens::questions::QuestionFilm;
use pinhole_course::mistake;
use pinhole_course::overlay;
use pinhole_course::submission::Submission;

/// Every draw must catch a mistake that shows in more than this share of a group's questions.
const EVERYDAY: f64 = 0.001;

/// The result of comparing draws.
#[derive(Debug, Default, Serialize)]
pub struct Draws {
    /// Wrong answers to single tasks.
    pub answers: usize,
    /// Groups of these answers that pass their public questions.
    pub groups: usize,
    /// How often the groups were asked the questions of a seed.
    pub asked: usize,
    /// Groups that fail the questions of some seed, by their rate.
    pub caught: Vec<DrawnGroup>,
}

/// A group that passes its public questions and fails the questions of some seed.
#[derive(Clone, Debug, Serialize)]
pub struct DrawnGroup {
    /// The wrong answer.
    pub name: String,
    /// The group, as `task.group`.
    pub group: String,
    /// The share of questions that are answered wrongly, for all seeds together.
    pub rate: f64,
    /// The number of seeds that were asked.
    pub seeds: usize,
    /// The number of seeds whose questions the answer fails.
    pub failing: usize,
}

impl DrawnGroup {
    /// Whether the mark depends on the seed.
    pub fn depends_on_the_draw(&self) -> bool {
        self.failing < self.seeds
    }
}

impl fmt::Display for DrawnGroup {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let percent = 100.0 * self.rate;
        let DrawnGroup { name, group, .. } = self;
        write!(
            f,
            "{name}: wrong on {percent:.3} % of {group}'s questions; fails with {} of {} seeds",
            self.failing, self.seeds
        )
    }
}

impl Draws {
    /// Marks that depend on the draw although the mistake shows in everyday questions.
    pub fn faults(&self) -> Vec<String> {
        let mut faults: Vec<String> = Vec::new();
        for group in &self.caught {
            if group.depends_on_the_draw() && group.rate > EVERYDAY {
                faults.push(format!("a mark depends on the draw: {group}"));
            }
        }
        faults
    }
}

/// A wrong answer to one task.
struct WrongAnswer {
    name: String,
    submission: Submission,
}

/// The films of a group, one of each seed that has it.
struct DrawnFilms {
    group: String,
    films: Vec<QuestionFilm>,
}

/// Asks every mistake, rewrite and mutant whose name contains `named` the questions in the
/// folders of `folder`.
pub fn judge_all(validator: &Validator, folder: &Path, named: &str) -> Result<Draws> {
    let draws = folders(folder)?;
    let mut all = Draws::default();
    for task in &validator.assignment.tasks {
        let wrong = wrong_answers(validator, task, named)?;
        let public = validator.goldens.groups_without_scenes(task)?;
        let public: Vec<QuestionFilm> = public.into_iter().flat_map(|group| group.films).collect();
        let drawn = drawn(validator, task, &draws)?;
        let what = format!("draws of {}", task.name);
        let judged = validator.all(&what, &wrong, |wrong| {
            let program = validator.compiler.compile(&wrong.submission)?;
            judge_one(validator, wrong, &program, &public, &drawn, &task.name)
        })?;
        all.answers += wrong.len();
        for (groups, asked, caught) in judged {
            all.groups += groups;
            all.asked += asked;
            all.caught.extend(caught);
        }
    }
    all.caught.sort_by(|a, b| a.rate.total_cmp(&b.rate));
    Ok(all)
}

/// How many groups pass their public questions, how many films they were asked, and which groups
/// fail some of those.
fn judge_one(
    validator: &Validator,
    wrong: &WrongAnswer,
    program: &Program,
    public: &[QuestionFilm],
    drawn: &[DrawnFilms],
    task: &str,
) -> Result<(usize, usize, Vec<DrawnGroup>)> {
    let (mut groups, mut asked, mut caught) = (0, 0, Vec::new());
    let known = wrong_questions(validator, program, &public.iter().collect::<Vec<_>>())?;
    for (film, known) in public.iter().zip(known) {
        let Some(drawn) = drawn.iter().find(|drawn| drawn.group == film.name) else {
            continue;
        };
        if known > 0 {
            continue;
        }
        groups += 1;
        asked += drawn.films.len();
        let films: Vec<&QuestionFilm> = drawn.films.iter().collect();
        let wrong_in = wrong_questions(validator, program, &films)?;
        let questions: usize = films.iter().map(|film| film.job.len()).sum();
        let failing = wrong_in.iter().filter(|wrong| **wrong > 0).count();
        if failing > 0 {
            caught.push(DrawnGroup {
                name: wrong.name.clone(),
                group: format!("{task}.{}", film.name),
                rate: wrong_in.iter().sum::<usize>() as f64 / questions as f64,
                seeds: films.len(),
                failing,
            });
        }
    }
    Ok((groups, asked, caught))
}

/// How many questions of each film are answered wrongly. If an answer is missing, all of them.
fn wrong_questions(
    validator: &Validator,
    program: &Program,
    films: &[&QuestionFilm],
) -> Result<Vec<usize>> {
    let count = |film: &QuestionFilm, reply: &Reply| {
        let verdict = judge(&film.golden, &reply.film(film.resolution));
        verdict.map_or(film.job.len(), |verdict| verdict.failing.len())
    };
    if let Some(replies) = ask(validator, program, films)? {
        let pairs = films.iter().zip(&replies);
        return Ok(pairs.map(|(film, reply)| count(film, reply)).collect());
    }
    // A missing answer counts against its own film only.
    let one = |film: &&QuestionFilm| {
        let replies = ask(validator, program, &[film])?;
        Ok(replies.map_or(film.job.len(), |replies| count(film, &replies[0])))
    };
    films.iter().map(one).collect()
}

/// Every wrong answer to this task that compiles.
fn wrong_answers(validator: &Validator, task: &Task, named: &str) -> Result<Vec<WrongAnswer>> {
    let reference = overlay::reference(validator.assignment)?;
    let mut all = Vec::new();
    for found in mistake::read_all(validator.assignment)? {
        let folders = [found.folder.clone(), found.folder.join("rewrite")];
        for (folder, kind) in folders.iter().zip(["", "/rewrite"]) {
            let file = folder.join(task.file());
            if let Ok(text) = fs::read_to_string(&file) {
                all.push((format!("mistakes/{}{kind}", found.slug), text));
            }
        }
    }
    let mutants = mutants::generate(&reference)?;
    let own = mutants.into_iter().filter(|it| it.task == task.name);
    all.extend(own.map(|mutant| (mutant.name(), mutant.text)));
    let wanted = all.into_iter().filter(|(name, _)| name.contains(named));
    Ok(wanted
        .map(|(name, text)| WrongAnswer {
            name,
            submission: reference.clone().with_answer(&task.name, text),
        })
        .collect())
}

/// The folders of goldens in a folder, one of each seed.
fn folders(folder: &Path) -> Result<Vec<PathBuf>> {
    let entries = fs::read_dir(folder).or_input(
        format_args!("cannot read {}", folder.display()),
        "name a folder that contains folders of fresh questions",
    )?;
    let is_draw = |path: &PathBuf| path.join("probes").is_dir();
    let paths = entries.flatten().map(|entry| entry.path());
    let mut folders: Vec<PathBuf> = paths.filter(is_draw).collect();
    folders.sort();
    match folders.is_empty() {
        false => Ok(folders),
        true => Err(Error::input(
            format!("{} contains no folder of fresh questions", folder.display()),
            "make some: cargo pinhole golden render --seed N --out DIR/N",
        )),
    }
}

/// The films of a task's groups that the folders have.
fn drawn(validator: &Validator, task: &Task, folders: &[PathBuf]) -> Result<Vec<DrawnFilms>> {
    let groups = task.points.iter().map(|points| &points.group);
    let of_group = |group: &String| {
        let name = format!("{}.{group}.exr", task.name);
        let has = |folder: &&PathBuf| folder.join("probes").join(&name).is_file();
        let film = |folder: &PathBuf| {
            let goldens = Goldens::read(folder, validator.assignment)?;
            goldens.probe(task, group)
        };
        Ok(DrawnFilms {
            group: group.clone(),
            films: folders
                .iter()
                .filter(has)
                .map(film)
                .collect::<Result<_>>()?,
        })
    };
    groups.map(of_group).collect()
}
