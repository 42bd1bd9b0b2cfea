//! Diagnoses of an examination: what the known mistakes say of its films.

use pinhole::Film;
use pinhole::judge::Golden;

use crate::diagnosis::evidence::Evidence;
use crate::diagnosis::{Diagnosis, Explanation, Reading};
use crate::error::Result;
use crate::examination::Examination;
use crate::goldens::Goldens;
use crate::questions::QuestionFilm;

/// A belief that explains less of a scene than this is not mentioned there.
const LEAST_SHARE: f64 = 0.02;

impl Goldens {
    /// Which belief spoils these films, which are all those of one task.
    pub fn diagnose_task(
        &self,
        task: &str,
        films: &[(QuestionFilm, Option<Film>)],
    ) -> Result<Diagnosis> {
        let mut evidence = Vec::new();
        for (asked, film) in films {
            let name = self.film_name(&asked.golden_path);
            match film {
                Some(film) => evidence.extend(self.evidence(&name, &asked.golden, film)?),
                // Films alone tell beliefs apart; without one there is no telling.
                None => return Ok(Diagnosis::default()),
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
    /// the pictures; a picture speaks for itself only if no task was found wrong.
    pub fn diagnose_scenes(&self, examination: &mut Examination) -> Result<()> {
        let any_task_fails = examination.tasks.iter().any(|task| !task.passes());
        let mut held: Vec<&Explanation> = Vec::new();
        for belief in examination
            .tasks
            .iter()
            .flat_map(|task| &task.diagnosis.beliefs)
        {
            if held.iter().all(|other| other.slug != belief.slug) {
                held.push(belief);
            }
        }
        for scene in &mut examination.scenes {
            let Some(film) = scene.film.as_ref().filter(|_| !scene.outcome.passes()) else {
                continue;
            };
            scene.diagnosis = if any_task_fails {
                let evidence = self.evidence(&scene.name, &scene.golden, film)?;
                let shown = held.iter().filter_map(|belief| {
                    let explanation = self
                        .known
                        .explanation_of(&belief.slug, evidence.as_slice())?;
                    (explanation.explained >= LEAST_SHARE).then_some(explanation)
                });
                Diagnosis {
                    beliefs: shown.collect(),
                    reading: Reading::Together,
                }
            } else {
                self.diagnose_film(&scene.name, &scene.golden, film)?
            };
        }
        Ok(())
    }

    fn evidence(&self, name: &str, golden: &Golden, film: &Film) -> Result<Option<Evidence>> {
        Evidence::of(name, golden, film, &self.known, &self.folder)
    }
}
