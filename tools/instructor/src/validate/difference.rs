//! Searches for questions on which two programs give different answers, compared to the last bit.
//! It asks all questions of a task and its [ties].

use std::collections::BTreeMap;
use std::fmt;
use std::fs;
use std::sync::{Arc, Mutex, OnceLock};
use std::time::Duration;

use pinhole::ask::Ending;
use pinhole::job::Job;
use pinhole::kind::Answer;
use pinhole::words;
use serde::Serialize;

use super::ties;
use super::validator::Validator;
use pinhole_course::assignment::Task;
use pinhole_course::compile::Program;
use pinhole_course::error::Result;
use pinhole_course::examine;
use pinhole_course::sandbox::Limits;
use pinhole_report::terminal;

/// How a mutant's answers differ from the reference's.
#[derive(Clone, Debug, Default, Serialize)]
pub struct Difference {
    /// Whether both are the same machine code, byte for byte. That proves that the mutant is no
    /// mistake; a search that finds no difference doesn't.
    pub same_program: bool,
    /// How many questions are not ties.
    pub asked: usize,
    /// How many questions are ties in exact arithmetic.
    pub ties: usize,
    /// How many of the questions that are not ties the mutant answers differently.
    pub elsewhere: usize,
    /// The first of these questions, in words.
    pub example: Option<String>,
    /// How many of the ties the mutant answers differently.
    pub on_ties: usize,
}

impl fmt::Display for Difference {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.same_program {
            return write!(f, "the same machine code");
        }
        write!(
            f,
            "answers differ on {} of {} questions and on {} of {} exact ties",
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
    validator: &'a Validator<'a>,
    program: Program,
    tasks: Mutex<BTreeMap<String, Arc<OnceLock<AnsweredQuestions>>>>,
}

/// Questions with the reference's answers.
struct AnsweredQuestions {
    job: Job,
    /// Which of the questions are ties.
    is_tie: Vec<bool>,
    answers: Vec<Option<Answer>>,
}

/// How long a program may take for a task's questions.
const WALL: Duration = Duration::from_secs(60);

impl<'a> Oracle<'a> {
    /// Asks `program`, the reference, once something is to be compared with it.
    pub fn new(validator: &'a Validator<'a>, program: Program) -> Oracle<'a> {
        Oracle {
            validator,
            program,
            tasks: Mutex::default(),
        }
    }

    /// How another program's answers to a task differ.
    pub fn compare(&self, task: &Task, other: &Program) -> Result<Difference> {
        let read = |program: &Program| fs::read(&program.executable).ok();
        // Two sources that compile to the same code are equivalent (Papadakis et al., "Trivial
        // Compiler Equivalence", 2015).
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
                let answered = self.answered(task)?;
                slot.get_or_init(|| answered)
            }
        };
        let (answers, ending) = self.answers(other, &own.job)?;
        let mut difference = Difference::default();
        let pairs = own.answers.iter().zip(&answers).zip(&own.is_tie);
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
                        let questions = own.job.questions();
                        let question = questions.map(|all| all.describe(index, &task.name, 17));
                        let (expected, got) = (in_words(expected), in_words(got));
                        let ended = match &ending {
                            Ending::Complete => String::new(),
                            other => format!(" ({other:?})"),
                        };
                        difference.example = question.map(|question| {
                            let question = terminal::facts(&question);
                            format!("{question}\nexpected  {expected}\ngot       {got}{ended}")
                        });
                    }
                }
            }
        }
        Ok(difference)
    }

    /// All questions of a task with the reference's answers.
    fn answered(&self, task: &Task) -> Result<AnsweredQuestions> {
        let goldens = self.validator.goldens;
        let kept = goldens.cached_questions(task)?;
        let films = kept.groups.iter().flat_map(|group| &group.films);
        let mut asked = films.filter_map(|film| film.job.questions());
        let mut questions = asked.next().cloned().expect("a task has questions");
        for more in asked {
            let is_alike = questions.append(more);
            assert!(is_alike, "a task's questions are of one kind");
        }
        let mut is_tie = vec![false; questions.len()];
        if let Some((more, ties)) = ties::read(goldens, task)? {
            questions.append(&more);
            is_tie.extend(ties);
        }
        let job = Job::Ask(questions);
        let answers = self.answers(&self.program, &job)?.0;
        Ok(AnsweredQuestions {
            job,
            is_tie,
            answers,
        })
    }

    fn answers(&self, program: &Program, job: &Job) -> Result<(Vec<Option<Answer>>, Ending)> {
        let sandbox = self.validator.sandbox;
        let reply = examine::run(
            program,
            sandbox,
            &Limits::of_answers(WALL),
            job,
            &mut |_| {},
        )?;
        Ok((reply.answers, reply.ending))
    }
}

/// Whether two answers agree to the last bit. Zero and negative zero count as equal.
fn is_same(a: &Option<Answer>, b: &Option<Answer>) -> bool {
    a == b
}

fn in_words(answer: &Option<Answer>) -> String {
    match answer {
        None => "nothing".into(),
        Some(Answer::Hit(hit)) => words::hit(*hit, 17),
        Some(other) => other.words(17),
    }
}
