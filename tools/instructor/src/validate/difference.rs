//! A search for questions on which two programs give different answers.

use std::collections::BTreeMap;
use std::fmt;
use std::fs;
use std::sync::{Arc, Mutex, OnceLock};
use std::time::Duration;

use pinhole::ask::Ending;
use pinhole::kind::Answer;
use pinhole::words;
use serde::Serialize;

use super::adversary::{self, Asked};
use super::bench::Bench;
use pinhole_course::assignment::Task;
use pinhole_course::compile::Program;
use pinhole_course::error::Result;
use pinhole_course::examine;
use pinhole_course::sandbox::Limits;
use pinhole_report::terminal;

/// How a mutant's answers differ from the reference's.
#[derive(Clone, Debug, Default, Serialize)]
pub struct Difference {
    /// Whether both are the same machine code, byte for byte: proof, not only search.
    pub same_program: bool,
    /// Questions that are no ties.
    pub asked: usize,
    /// Questions that exact arithmetic calls ties.
    pub ties: usize,
    /// Of the questions that are no ties, how many are answered otherwise.
    pub elsewhere: usize,
    /// The first of them in words.
    pub example: Option<String>,
    /// Of the ties, how many are answered otherwise.
    pub on_ties: usize,
}

impl fmt::Display for Difference {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.same_program {
            return write!(f, "the same machine code");
        }
        write!(
            f,
            "answers otherwise: {} of {} questions, and {} of {} exact ties",
            self.elsewhere, self.asked, self.on_ties, self.ties
        )?;
        match &self.example {
            Some(example) => write!(f, "; for example\n{example}"),
            None => Ok(()),
        }
    }
}

/// The reference, its program and its answers.
pub struct Oracle<'a> {
    bench: &'a Bench<'a>,
    program: Program,
    tasks: Mutex<BTreeMap<String, Arc<OnceLock<Answered>>>>,
}

/// Questions with the reference's answers.
struct Answered {
    asked: Asked,
    answers: Vec<Option<Answer>>,
}

/// No program takes longer over a task's questions.
const WALL: Duration = Duration::from_secs(60);

impl<'a> Oracle<'a> {
    /// Asks `program`, the reference, when something is to be compared with it.
    pub fn new(bench: &'a Bench<'a>, program: Program) -> Oracle<'a> {
        Oracle {
            bench,
            program,
            tasks: Mutex::default(),
        }
    }

    /// Where another program's answers to a task differ.
    pub fn compare(&self, task: &Task, other: &Program) -> Result<Difference> {
        let read = |program: &Program| fs::read(&program.executable).ok();
        // What the same compiler makes the same code of is the same program
        // (Papadakis et al., "Trivial Compiler Equivalence", 2015).
        if read(other).is_some_and(|code| Some(code) == read(&self.program)) {
            return Ok(Difference {
                same_program: true,
                ..Difference::default()
            });
        }
        let slot = {
            let mut tasks = self.tasks.lock().unwrap_or_else(|lock| lock.into_inner());
            tasks.entry(task.name.clone()).or_default().clone()
        };
        let own = match slot.get() {
            Some(own) => own,
            None => {
                let asked = adversary::ask(task);
                let answers = self.answers(&self.program, &asked)?.0;
                slot.get_or_init(|| Answered { asked, answers })
            }
        };
        let (answers, ending) = self.answers(other, &own.asked)?;
        let mut difference = Difference::default();
        let pairs = own.answers.iter().zip(&answers).zip(&own.asked.is_tie);
        for (index, ((expected, got), is_tie)) in pairs.enumerate() {
            let differs = usize::from(!is_same(expected, got));
            match is_tie {
                true => {
                    difference.ties += 1;
                    difference.on_ties += differs;
                }
                false => {
                    difference.asked += 1;
                    difference.elsewhere += differs;
                    if differs == 1 && difference.example.is_none() {
                        let questions = own.asked.job.questions();
                        let question = questions.map(|all| all.describe(index, &task.name, 17));
                        let (expected, got) = (in_words(expected), in_words(got));
                        difference.example = question.map(|question| {
                            let question = terminal::facts(&question);
                            format!("{question}\nexpected  {expected}\ngot       {got} {ending:?}")
                        });
                    }
                }
            }
        }
        Ok(difference)
    }

    fn answers(&self, program: &Program, asked: &Asked) -> Result<(Vec<Option<Answer>>, Ending)> {
        let sandbox = self.bench.sandbox;
        let reply = examine::run(
            program,
            sandbox,
            &Limits::of_answers(WALL),
            &asked.job,
            &mut |_| {},
        )?;
        Ok((reply.answers, reply.ending))
    }
}

/// To the last bit, except that both zeros are one.
fn is_same(a: &Option<Answer>, b: &Option<Answer>) -> bool {
    a == b
}

fn in_words(answer: &Option<Answer>) -> String {
    match answer {
        None => "nothing".into(),
        Some(Answer::Ray(ray)) => words::ray(ray, 17),
        Some(Answer::Hit(hit)) => words::hit(*hit, 17),
    }
}
