//! Diagnoses of an examination: what the known mistakes say of its films.

use pinhole::Film;
use pinhole::judge::Golden;

use crate::diagnosis::evidence::Evidence;
use crate::diagnosis::{Diagnosis, Explanation, Reading};
use crate::error::Result;
use crate::goldens::Goldens;
use crate::goldens::questions::QuestionFilm;
use crate::outcome::{Examination, FilmOutcome, TaskOutcome};

/// A belief that explains less of a scene than this is not mentioned there.
const LEAST_SHARE: f64 = 0.02;

/// What came of one film that was asked for.
pub struct Cast<'a> {
    /// What was asked.
    pub asked: &'a QuestionFilm,
    /// The film, if it is whole.
    pub film: Option<Film>,
    /// How it was judged.
    pub end: FilmOutcome,
}

impl Goldens {
    /// Which belief spoils these films, which are all those of one task.
    pub fn diagnose_task(&self, task: &str, casts: &[Cast<'_>]) -> Result<Diagnosis> {
        // Everybody's panics look alike.
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
                // Nothing else tells beliefs apart: no answer in time, say.
                (None, _) => return Ok(Diagnosis::default()),
            }
        }
        let fails_here = |slug: &str| {
            let mistake = self.known.mistake.get(slug);
            mistake.is_some_and(|mistake| mistake.fails.iter().any(|name| name == task))
        };
        Ok(self.known.explain(&evidence, &fails_here))
    }

    /// Which belief spoils one film, of which nothing else is known.
    pub fn diagnose_film(&self, name: &str, golden: &Golden, film: &Film) -> Result<Diagnosis> {
        let evidence = self.evidence(name, golden, film)?;
        Ok(self.known.explain(evidence.as_slice(), &|_| true))
    }

    /// Diagnoses the scenes. The beliefs that spoil single tasks say what is wrong with
    /// the pictures. Only if no task was found wrong do pictures speak for themselves:
    /// all together first, because what looks alike in one may differ in another.
    pub fn diagnose_scenes(&self, examination: &mut Examination) -> Result<()> {
        let Examination { outcome, films } = examination;
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
        let together = match tasks.iter().all(TaskOutcome::passes) {
            true => {
                let all: Vec<Evidence> = evidence.iter().flatten().cloned().collect();
                self.known.explain(&all, &|_| true)
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
                (explanation.explained >= LEAST_SHARE).then_some(explanation)
            });
            scene.diagnosis = match together.is_empty() && tasks.iter().all(TaskOutcome::passes) {
                true => self.known.explain(evidence, &|_| true),
                false => Diagnosis {
                    beliefs: shown.collect(),
                    reading: together.reading,
                },
            };
        }
        Ok(())
    }

    fn evidence(&self, name: &str, golden: &Golden, film: &Film) -> Result<Option<Evidence>> {
        Evidence::of(name, golden, film, &self.known, &self.folder)
    }
}

/// The beliefs that tasks were found to be spoiled by, each once.
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
