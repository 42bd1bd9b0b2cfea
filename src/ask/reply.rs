//! The answers to a job, filled in message by message.

use std::time::Duration;

use super::ending::Ending;
use super::transport::Next;
use crate::camera::Resolution;
use crate::film::{Film, TESTS};
use crate::job::{Job, MOST_PANIC_TEXT, Message};
use crate::kind::{Answer, Questions, SearchLog, WireAnswer};
use crate::part::Tally;
use crate::ray::{Hit, Ray};
use crate::tree::NodeBox;

/// The reply to one job.
#[derive(Clone, Debug)]
pub struct Reply {
    /// The answers, in the job's order; `None` where none came.
    pub answers: Vec<Option<Answer>>,
    pub(super) missing: usize,
    /// How many tests each answer took, if they are counted; otherwise empty.
    pub tests: Vec<u32>,
    /// How many tests each pixel of a scene took, as the submission says; empty if it doesn't count
    /// them. They are only for pictures.
    pub own_tests: Vec<u32>,
    /// The boxes of the upper nodes of each tree, for pictures; empty if no trees came.
    pub outlines: Vec<Vec<NodeBox>>,
    /// How the steps of each answer were taken, for diagnoses; empty if answers have no steps.
    pub tallies: Vec<Vec<Tally>>,
    /// What each search has tested so far; otherwise empty.
    searches: Vec<SearchLog>,
    /// How it ended.
    pub ending: Ending,
    /// The place of a question that was still being answered at the end, if that is known.
    pub still_at: Option<usize>,
    /// How long it took to start, until the submission had read the job; `None` if it never did.
    pub start: Option<Duration>,
    /// What the student's code printed, standard output and error, cut at
    /// [`MOST_PRINTED`](super::MOST_PRINTED) bytes each.
    pub printed: String,
}

impl Reply {
    /// The reply to a job before anything has come.
    pub(crate) fn before(job: &Job) -> Reply {
        Reply {
            answers: vec![None; job.len()],
            missing: job.len(),
            tests: vec![0; if job.is_counted() { job.len() } else { 0 }],
            own_tests: Vec::new(),
            outlines: Vec::new(),
            tallies: Vec::new(),
            searches: Vec::new(),
            ending: Ending::Complete,
            still_at: None,
            start: None,
            printed: String::new(),
        }
    }

    /// The reply to a job that was not sent, because earlier jobs ended like this.
    pub fn unasked(job: &Job, ending: Ending) -> Reply {
        Reply {
            ending,
            ..Reply::before(job)
        }
    }

    /// The hits of a job of hits, with misses for missing answers; `None` for other jobs.
    pub fn hits(&self) -> Option<Vec<Option<Hit>>> {
        let hit = |answer: &Option<Answer>| match answer {
            Some(Answer::Hit(hit)) => Some(*hit),
            Some(_) => None,
            None => Some(None),
        };
        self.answers.iter().map(hit).collect()
    }

    /// The rays of a job of rays; `None` if one is missing.
    pub fn rays(&self) -> Option<Vec<Ray>> {
        self.all(|answer| match answer {
            Answer::Ray(ray) => Some(*ray),
            _ => None,
        })
    }

    /// Whether every question is answered.
    pub fn is_whole(&self) -> bool {
        self.missing == 0
    }

    /// The answers as a film: of rays, boxes or trees if all answers are of that type, of hits
    /// otherwise. Counted tests get a channel of their own.
    pub fn film(&self, resolution: Resolution) -> Film {
        let film = match self.answers.first() {
            Some(Some(Answer::Ray(_))) => self.rays().map(|rays| Film::of_rays(resolution, &rays)),
            Some(Some(Answer::Box(_))) => {
                let boxes = self.all(|answer| match answer {
                    Answer::Box(bounds) => Some(*bounds),
                    _ => None,
                });
                boxes.map(|boxes| Film::of_boxes(resolution, &boxes))
            }
            Some(Some(Answer::Tree(_))) => {
                let trees = self.all(|answer| match answer {
                    Answer::Tree(measures) => Some(*measures),
                    _ => None,
                });
                trees.map(|trees| Film::of_trees(resolution, &trees))
            }
            _ => None,
        };
        let film = film.unwrap_or_else(|| {
            let misses = || vec![None; self.answers.len()];
            Film::of_hits(resolution, &self.hits().unwrap_or_else(misses))
        });
        match self.tests.is_empty() {
            true => film,
            false => film.with(TESTS, as_samples(&self.tests)),
        }
    }

    /// How many tests each pixel of a scene took, as the submission says. They are a film of their
    /// own, because nothing is judged by them.
    pub fn own_tests(&self, resolution: Resolution) -> Option<Film> {
        let film = Film::new(resolution, Vec::new());
        let counts = (!self.own_tests.is_empty()).then_some(&self.own_tests);
        counts.map(|counts| film.with(TESTS, as_samples(counts)))
    }

    /// What `pick` returns for each answer; `None` if an answer is missing or `pick` returns
    /// `None`.
    fn all<T>(&self, pick: impl Fn(&Answer) -> Option<T>) -> Option<Vec<T>> {
        let answers = self.answers.iter();
        answers.map(|answer| pick(answer.as_ref()?)).collect()
    }

    /// Splits the reply to several jobs that were sent as one. `lengths` are the numbers of their
    /// questions.
    ///
    /// # Panics
    /// If the lengths do not add up to the number of answers.
    pub fn split(mut self, lengths: impl Iterator<Item = usize>) -> Vec<Reply> {
        let mut parts = Vec::new();
        let mut first = 0;
        for length in lengths {
            let still_at = self.still_at.and_then(|index| index.checked_sub(first));
            first += length;
            let rest = self.answers.split_off(length);
            let answers = std::mem::replace(&mut self.answers, rest);
            let missing = answers.iter().filter(|answer| answer.is_none()).count();
            let later = self.tests.split_off(length.min(self.tests.len()));
            let tests = std::mem::replace(&mut self.tests, later);
            let later = self.own_tests.split_off(length.min(self.own_tests.len()));
            let own_tests = std::mem::replace(&mut self.own_tests, later);
            let later = self.outlines.split_off(length.min(self.outlines.len()));
            let outlines = std::mem::replace(&mut self.outlines, later);
            let later = self.tallies.split_off(length.min(self.tallies.len()));
            let tallies = std::mem::replace(&mut self.tallies, later);
            parts.push(Reply {
                answers,
                missing,
                tests,
                own_tests,
                outlines,
                tallies,
                searches: Vec::new(),
                ending: self.ending.clone(),
                still_at: still_at.filter(|index| *index < length),
                start: self.start,
                printed: String::new(),
            });
        }
        assert!(self.answers.is_empty(), "some answers are left over");
        parts
    }

    /// Keeps what is drawn or described but not judged.
    fn keep_unjudged(&mut self, job: &Job, index: usize, sent: &WireAnswer) {
        match (sent, job.questions()) {
            (WireAnswer::Counted(_, tests), _) => {
                self.own_tests.resize(job.len(), 0);
                self.own_tests[index] = *tests;
            }
            (WireAnswer::Tree(tree), Some(Questions::Tree(all))) => {
                self.outlines.resize(job.len(), Vec::new());
                self.outlines[index] = all[index].outline(tree);
                self.tallies.resize(job.len(), Vec::new());
                self.tallies[index] = all[index].tallies(tree);
            }
            (_, Some(Questions::TreeSearch(_))) => {
                self.tallies.resize(job.len(), Vec::new());
                let searched = self.searches.get_mut(index).map(std::mem::take);
                self.tallies[index] = searched.unwrap_or_default().tallies();
            }
            _ => {}
        }
    }

    /// Stores one message, and says what comes next.
    pub(super) fn take(&mut self, job: &Job, message: Message) -> Result<Next, String> {
        match message {
            Message::Test(index, test) => {
                let questions = job.questions().filter(|_| index < self.tests.len());
                let questions = questions.ok_or("it asked for a test in an unknown question")?;
                self.tests[index] += 1;
                if self.tests[index] as usize > questions.most_tests(index) {
                    let why = "it asked for more than ten times as many tests as the tree has \
                               boxes and objects";
                    return Err(why.into());
                }
                let result = questions.test(index, test);
                let result = result.ok_or("it asked to test something that is not in the tree")?;
                if let Questions::TreeSearch(all) = questions {
                    self.searches.resize(job.len(), SearchLog::default());
                    self.searches[index].note(&all[index], test, result);
                }
                Ok(Next::Send(result))
            }
            Message::Panicked(mut panic) => {
                for text in [&mut panic.message, &mut panic.file] {
                    text.truncate(text.floor_char_boundary(MOST_PANIC_TEXT));
                }
                panic.index = panic.index.min(self.answers.len().saturating_sub(1));
                self.ending = Ending::Panicked(panic);
                Ok(Next::End)
            }
            Message::Unregistered(kind) => {
                self.ending = Ending::Unregistered(kind);
                Ok(Next::End)
            }
            Message::StillAt(_) => {
                Err("it reported its current question without being asked".into())
            }
            // A stream of these would keep its reader busy until time is up.
            Message::Started => Err("it said twice that it has started".into()),
            Message::Answers { answers, .. } if answers.is_empty() => {
                Err("it sent a message without an answer".into())
            }
            Message::Answers { first, answers } => {
                let end = first
                    .checked_add(answers.len())
                    .filter(|end| *end <= self.answers.len());
                let Some(end) = end else {
                    return Err("it answered a question that was not asked".into());
                };
                let places = &mut self.answers[first..end];
                // Check all answers before storing any, because a wrong message must not
                // complete the reply.
                if places.iter().any(Option::is_some) {
                    return Err("it answered a question twice".into());
                }
                let sent = || (first..end).zip(&answers);
                let received = sent().map(|(index, sent)| job.receive(index, sent));
                let received: Option<Vec<Answer>> = received.collect();
                let received = received.ok_or("it sent an answer to another kind of question")?;
                self.missing -= received.len();
                for (place, answer) in places.iter_mut().zip(received) {
                    *place = Some(answer);
                }
                for (index, sent) in sent() {
                    self.keep_unjudged(job, index, sent);
                }
                Ok(match self.missing {
                    0 => Next::End,
                    _ => Next::Receive,
                })
            }
        }
    }
}

fn as_samples(counts: &[u32]) -> Vec<f32> {
    counts.iter().map(|&count| count as f32).collect()
}
