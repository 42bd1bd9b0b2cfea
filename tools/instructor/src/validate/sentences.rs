//! Checks whether the measured sentences about wrong answers are true. Every sentence is found
//! with the public questions and tested on fresh ones.

use serde::Serialize;

use super::validator::{Validator, WALL};
use pinhole::ask::Reply;
use pinhole::job::Job;
use pinhole_course::assignment::Task;
use pinhole_course::compile::Program;
use pinhole_course::diagnosis::measure::{QuestionsAndAnswers, measure};
use pinhole_course::error::Result;
use pinhole_course::examine;
use pinhole_course::goldens::Goldens;
use pinhole_course::goldens::questions::QuestionFilm;
use pinhole_course::sandbox::Limits;

/// The sentences about one wrong task, or about many.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Sentences {
    /// How many wrong tasks answered every question.
    pub tasks: usize,
    /// How many of these got a law or a sentence about where they are wrong.
    pub told: usize,
    /// All sentences.
    pub said: Vec<String>,
    /// Tasks that got neither, with the sentences that they did get.
    pub untold: Vec<String>,
    /// How many sentences were tested on fresh questions.
    pub tested: usize,
    /// The sentences that are false on the fresh questions.
    pub wrong: Vec<String>,
}

/// With fewer wrong tasks than this, no share is required.
pub const FEW: usize = 20;

impl Sentences {
    /// The sentences about a program's answers to a task that it gets wrong.
    pub fn of(
        validator: &Validator,
        program: &Program,
        task: &Task,
        name: &str,
    ) -> Result<Sentences> {
        let mut sentences = Sentences::default();
        let films = films(validator.goldens, task)?;
        let Some(replies) = ask(validator, program, &films.iter().collect::<Vec<_>>())? else {
            return Ok(sentences);
        };
        let said = measure(&asked(&films, &replies));
        sentences.tasks = 1;
        let says = said.iter().map(|it| format!("{name}: {}", it.finding.says));
        sentences.said = says.collect();
        match said.iter().any(|measured| measured.finding.is_law) {
            true => sentences.told = 1,
            false => {
                let says: Vec<&str> = said.iter().map(|it| it.finding.says.as_str()).collect();
                sentences.untold.push(format!("{name}: {}", says.join(" ")));
            }
        }
        if let Some(fresh) = validator.fresh {
            let films = self::films(fresh, task)?;
            if let Some(replies) = ask(validator, program, &films.iter().collect::<Vec<_>>())? {
                let asked = asked(&films, &replies);
                sentences.tested = said.len();
                let wrong = said.iter().filter(|measured| !measured.holds(&asked));
                let wrong = wrong.map(|it| format!("{name}: {}", it.finding.says));
                sentences.wrong = wrong.collect();
            }
        }
        Ok(sentences)
    }

    /// The sum of all these results.
    pub fn sum<'a>(all: impl Iterator<Item = &'a Sentences>) -> Sentences {
        let mut sum = Sentences::default();
        for one in all {
            sum.tasks += one.tasks;
            sum.told += one.told;
            sum.tested += one.tested;
            sum.said.extend_from_slice(&one.said);
            sum.untold.extend_from_slice(&one.untold);
            sum.wrong.extend_from_slice(&one.wrong);
        }
        sum
    }

    /// The targets that were missed, if `enough` is the share of wrong tasks that must get a law.
    pub fn faults(&self, what: &str, enough: f64) -> Vec<String> {
        let false_ones = self.wrong.iter().map(|it| format!("false sentence: {it}"));
        let mut faults: Vec<String> = false_ones.collect();
        if self.tasks >= FEW && (self.told as f64) < enough * self.tasks as f64 {
            let (told, tasks) = (self.told, self.tasks);
            faults.push(format!(
                "only {told} of {tasks} {what} with wrong answers are described by a sentence"
            ));
        }
        faults
    }
}

/// The films of a task's questions, except those about scenes.
fn films(goldens: &Goldens, task: &Task) -> Result<Vec<QuestionFilm>> {
    let groups = goldens.groups_without_scenes(task)?;
    Ok(groups.into_iter().flat_map(|group| group.films).collect())
}

fn asked<'a>(films: &'a [QuestionFilm], replies: &'a [Reply]) -> Vec<QuestionsAndAnswers<'a>> {
    let pairs = films.iter().zip(replies);
    let asked = pairs.filter_map(|(film, reply)| {
        Some(QuestionsAndAnswers {
            questions: film.job.questions()?,
            answers: &reply.answers,
            tallies: &reply.tallies,
            golden: &film.golden,
        })
    });
    asked.collect()
}

/// Asks all questions in one process; `None` if some answers are missing.
pub fn ask(
    validator: &Validator,
    program: &Program,
    films: &[&QuestionFilm],
) -> Result<Option<Vec<Reply>>> {
    let mut questions = films.iter().filter_map(|film| film.job.questions());
    let Some(mut all) = questions.next().cloned() else {
        return Ok(None);
    };
    for more in questions {
        all.append(more);
    }
    let (limits, job) = (Limits::of_answers(WALL), Job::Ask(all));
    let reply = examine::run(program, validator.sandbox, &limits, &job, &mut |_| {})?;
    let split = |reply: Reply| reply.split(films.iter().map(|film| film.job.len()));
    Ok(reply.is_whole().then(|| split(reply)))
}
