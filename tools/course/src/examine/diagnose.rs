//! Diagnoses of an examination: which known mistakes explain its films.

use pinhole::Film;
use pinhole::ask::Reply;
use pinhole::judge::Golden;

use crate::assignment::Task;
use crate::diagnosis::evidence::Evidence;
use crate::diagnosis::measure::QuestionsAndAnswers;
use crate::diagnosis::{Diagnosis, Explanation, Reading};
use crate::error::Result;
use crate::goldens::Goldens;
use crate::goldens::questions::{Group, QuestionFilm};
use crate::outcome::{Examination, FilmOutcome, TaskOutcome};

/// One of several beliefs is mentioned at a scene only if it explains at least this share of
/// its errors.
const LEAST_SHARE: f64 = 0.02;

/// A belief that explains this share of what is wrong in a task leaves nothing to explain.
const ALL: f64 = 0.9;

/// One film that was asked for, and its outcome.
pub struct Cast<'a> {
    /// What was asked.
    pub asked: &'a QuestionFilm,
    /// The film, if it is complete.
    pub film: Option<Film>,
    /// How it was judged.
    pub end: FilmOutcome,
}

/// The questions of groups and the replies to their films, for measuring. Groups about the pixels of
/// scenes are left out, because a scene may be withheld.
pub fn asked<'a>(
    task: &Task,
    groups: &'a [(&'a Group, Vec<Reply>)],
) -> Vec<QuestionsAndAnswers<'a>> {
    let groups = groups
        .iter()
        .filter(|(group, _)| !task.is_of_scenes(&group.name));
    groups
        .flat_map(|(group, replies)| group.films.iter().zip(replies))
        .filter(|(_, reply)| reply.is_whole())
        .filter_map(|(film, reply)| {
            Some(QuestionsAndAnswers {
                questions: film.job.questions()?,
                answers: &reply.answers,
                tallies: &reply.tallies,
                golden: &film.golden,
            })
        })
        .collect()
}

impl Goldens {
    /// The belief that explains these films, which are films of one task.
    pub fn diagnose_task(&self, task: &str, casts: &[Cast<'_>]) -> Result<Diagnosis> {
        // If every film panicked, nothing distinguishes one belief from another.
        if casts.iter().all(|cast| cast.film.is_none()) {
            return Ok(Diagnosis::default());
        }
        if let Some(probes) = &self.probes {
            let own = casts
                .iter()
                .filter(|cast| cast.asked.golden_path.starts_with(&probes.folder));
            return probes.diagnose_casts(task, own);
        }
        self.diagnose_casts(task, casts.iter())
    }

    fn diagnose_casts<'a>(
        &self,
        task: &str,
        casts: impl Iterator<Item = &'a Cast<'a>>,
    ) -> Result<Diagnosis> {
        let mut evidence = Vec::new();
        for Cast { asked, film, end } in casts {
            let name = self.film_name(&asked.golden_path);
            match (film, end) {
                (Some(film), _) => evidence.extend(self.evidence(&name, &asked.golden, film)?),
                (None, FilmOutcome::Panicked { .. }) => {
                    evidence.push(Evidence::of_panic(&name, asked.job.len(), &self.known));
                }
                // For other failures, such as no answer in time, beliefs can't be told
                // apart.
                (None, _) => return Ok(Diagnosis::default()),
            }
        }
        let fails_here = |slug: &str| {
            let mistake = self.known.mistake.get(slug);
            mistake.is_some_and(|mistake| mistake.fails.iter().any(|name| name == task))
        };
        Ok(self.known.explain(&evidence, &fails_here))
    }

    /// The belief that explains one film, judged by this film alone.
    pub fn diagnose_film(&self, name: &str, golden: &Golden, film: &Film) -> Result<Diagnosis> {
        let evidence = self.evidence(name, golden, film)?;
        Ok(self.known.explain(evidence.as_slice(), &|_| true))
    }

    /// Diagnoses the scenes. Beliefs that were found in single tasks explain the pictures. Only
    /// if every task is right are pictures diagnosed by themselves, first all together, because
    /// beliefs that look alike in one picture may differ in another. What is said of a public scene
    /// does not depend on others.
    pub fn diagnose_scenes(
        &self,
        examination: &mut Examination,
        is_public: &dyn Fn(&str) -> bool,
    ) -> Result<()> {
        let Examination { outcome, films, .. } = examination;
        let (tasks, scenes) = (&outcome.tasks, &mut outcome.scenes);
        if scenes.iter().all(|scene| scene.outcome.passes()) {
            return Ok(());
        }
        let mut evidence = Vec::new();
        for (scene, cast) in scenes.iter().zip(films) {
            evidence.push(match &cast.film {
                Some(film) => self.evidence(&scene.name, &cast.golden, film)?,
                None => None,
            });
        }
        // Which pixels a belief spoils may depend on the student's other answers, such as a
        // tree. If nothing else is wrong, it need not explain a scene pixel by pixel.
        let only = only_belief(tasks).map(str::to_owned);
        // Nobody holds a belief that would fail a task which passes.
        let is_possible = |slug: &str| {
            let passes = |name: &String| tasks.iter().any(|it| it.name == *name && it.passes());
            let mistake = self.known.mistake.get(slug);
            mistake.is_some_and(|mistake| !mistake.fails.iter().any(passes))
        };
        let together = match tasks.iter().all(TaskOutcome::passes) {
            true => {
                let all = scenes.iter().zip(&evidence);
                let public = all.filter(|(scene, _)| is_public(&scene.name));
                let public = public.filter_map(|(_, evidence)| evidence.clone());
                self.known
                    .explain(&public.collect::<Vec<_>>(), &is_possible)
            }
            false => held(tasks),
        };
        for (scene, evidence) in scenes.iter_mut().zip(&evidence) {
            let Some(evidence) = evidence.as_ref().filter(|evidence| evidence.failing > 0) else {
                continue;
            };
            let evidence = std::slice::from_ref(evidence);
            let shown = together.beliefs.iter().filter_map(|belief| {
                let explanation = self.known.explanation_of(&belief.slug, evidence)?;
                let shows = explanation.explained >= LEAST_SHARE;
                (shows || only.as_deref() == Some(&belief.slug)).then_some(explanation)
            });
            scene.diagnosis = match together.is_empty() && tasks.iter().all(TaskOutcome::passes) {
                true => self.known.explain(evidence, &is_possible),
                false => Diagnosis {
                    beliefs: shown.collect(),
                    reading: together.reading,
                },
            };
        }
        Ok(())
    }

    fn evidence<'a>(
        &self,
        name: &str,
        golden: &'a Golden,
        film: &'a Film,
    ) -> Result<Option<Evidence<'a>>> {
        Evidence::of(name, golden, film, &self.known, &self.folder)
    }
}

/// The belief that alone explains every wrong task, if there is one.
fn only_belief(tasks: &[TaskOutcome]) -> Option<&str> {
    let mut wrong = tasks.iter().filter(|task| !task.passes());
    fn alone(task: &TaskOutcome) -> Option<&str> {
        match task.diagnosis.beliefs.as_slice() {
            [belief] if belief.explained >= ALL => Some(belief.slug.as_str()),
            _ => None,
        }
    }
    let first = alone(wrong.next()?)?;
    wrong
        .all(|task| alone(task) == Some(first))
        .then_some(first)
}

/// The beliefs that were found in the tasks, each listed once.
fn held(tasks: &[TaskOutcome]) -> Diagnosis {
    let mut beliefs: Vec<Explanation> = Vec::new();
    for belief in tasks.iter().flat_map(|task| &task.diagnosis.beliefs) {
        if beliefs.iter().all(|other| other.slug != belief.slug) {
            beliefs.push(belief.clone());
        }
    }
    Diagnosis {
        beliefs,
        reading: Reading::Together,
    }
}
