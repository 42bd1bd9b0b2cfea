//! Tests whether diagnoses give the right name. It diagnoses rewrites and not the answers whose
//! films are stored, because matching a film with itself proves nothing.

use serde::Serialize;

use super::submissions::{SubmissionVerdict, SubmissionVerdicts};
use super::validator::Validator;
use pinhole_course::diagnosis::{Diagnosis, Reading};
use pinhole_course::error::Result;
use pinhole_course::outcome::Examination;

/// Diagnoses of wrong films, counted.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct NameCounts {
    /// How many films were given the right belief alone or, for a combined mistake, only beliefs
    /// that it has.
    pub right: usize,
    /// How many were given the right belief among two or three that the film cannot tell
    /// apart.
    pub among: usize,
    /// How many were given no name.
    pub none: usize,
    /// Films that were given a wrong name, perhaps besides the right one, with the names.
    pub wrong: Vec<String>,
}

/// The diagnoses of one submission, or of many.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct SubmissionDiagnosisCounts {
    /// Diagnoses of tasks, by their questions.
    pub tasks: NameCounts,
    /// Diagnoses of scenes, as `check` makes them after the tasks.
    pub scenes: NameCounts,
    /// Diagnoses of single pictures, as `diff` makes them, with nothing else known.
    pub pictures: NameCounts,
    /// Films that can't be diagnosed, because the code panicked.
    pub without_film: usize,
}

impl NameCounts {
    /// How many films were diagnosed.
    pub fn all(&self) -> usize {
        self.right + self.among + self.none + self.wrong.len()
    }

    /// The share that got the right name alone.
    pub fn share_right(&self) -> f64 {
        self.right as f64 / self.all().max(1) as f64
    }

    /// Counts the diagnosis of a film by a program with these beliefs.
    pub fn count(&mut self, film: &str, diagnosis: &Diagnosis, beliefs: &[String]) {
        let names: Vec<&String> = diagnosis.beliefs.iter().map(|named| &named.slug).collect();
        let held = |name: &&String| beliefs.contains(name);
        match diagnosis.reading {
            _ if names.is_empty() => self.none += 1,
            Reading::Together if names.iter().all(held) => self.right += 1,
            Reading::OneOf if names.iter().any(held) => self.among += 1,
            _ => self.wrong.push(format!("{film} is diagnosed as {names:?}")),
        }
    }

    /// Adds the counts of others.
    pub fn add(&mut self, other: &NameCounts) {
        self.right += other.right;
        self.among += other.among;
        self.none += other.none;
        self.wrong.extend_from_slice(&other.wrong);
    }
}

impl SubmissionDiagnosisCounts {
    /// The diagnoses of an examination of a program with these beliefs.
    pub fn of(
        validator: &Validator,
        name: &str,
        examination: &Examination,
        beliefs: &[String],
    ) -> Result<SubmissionDiagnosisCounts> {
        let mut naming = SubmissionDiagnosisCounts::default();
        let Examination { outcome, films, .. } = examination;
        for task in outcome.tasks.iter().filter(|task| !task.passes()) {
            let film = format!("{name}: {}", task.name);
            naming.tasks.count(&film, &task.diagnosis, beliefs);
        }
        let scenes = outcome.scenes.iter().zip(films);
        for (scene, cast) in scenes.filter(|(scene, _)| !scene.outcome.passes()) {
            let film = format!("{name}: {}", scene.name);
            let Some(film_cast) = &cast.film else {
                naming.without_film += 1;
                continue;
            };
            naming.scenes.count(&film, &scene.diagnosis, beliefs);
            let alone = validator
                .goldens
                .diagnose_film(&scene.name, &cast.golden, film_cast)?;
            naming.pictures.count(&film, &alone, beliefs);
        }
        Ok(naming)
    }

    /// The sum of all these counts.
    pub fn sum<'a>(
        all: impl Iterator<Item = &'a SubmissionDiagnosisCounts>,
    ) -> SubmissionDiagnosisCounts {
        let mut sum = SubmissionDiagnosisCounts::default();
        for naming in all {
            sum.tasks.add(&naming.tasks);
            sum.scenes.add(&naming.scenes);
            sum.pictures.add(&naming.pictures);
            sum.without_film += naming.without_film;
        }
        sum
    }
}

/// The share of a single belief's films that must get its name.
const ENOUGH: f64 = 0.95;

/// How often diagnoses give the right name.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Diagnoses {
    /// Diagnoses of rewrites of single beliefs.
    pub rewrites: SubmissionDiagnosisCounts,
    /// Diagnoses of two beliefs at once: composed of rewrites, or written as one answer.
    pub compounds: SubmissionDiagnosisCounts,
    /// Diagnoses of single beliefs as if each were unknown. Any name is then false.
    pub unmet: SubmissionDiagnosisCounts,
}

impl Diagnoses {
    /// Counts the names that were given to everything that was judged.
    pub fn of(mistakes: &SubmissionVerdicts, rewrites: &SubmissionVerdicts) -> Diagnoses {
        let sum = |judged: &[&SubmissionVerdict]| {
            SubmissionDiagnosisCounts::sum(judged.iter().map(|judged| &judged.naming))
        };
        let (unmet, compounds): (Vec<_>, Vec<_>) =
            mistakes.judged.iter().partition(|judged| judged.single);
        let (rewrites, composed): (Vec<_>, Vec<_>) =
            rewrites.judged.iter().partition(|judged| judged.single);
        // Leave out combinations of the beliefs' own answers, because the films of those answers
        // are stored.
        let written = compounds.into_iter().filter(|judged| !judged.composed);
        let compounds: Vec<&SubmissionVerdict> = written.chain(composed).collect();
        Diagnoses {
            rewrites: sum(&rewrites),
            compounds: sum(&compounds),
            unmet: sum(&unmet),
        }
    }

    /// The targets that were missed.
    pub fn faults(&self) -> Vec<String> {
        let Diagnoses {
            rewrites,
            compounds,
            ..
        } = self;
        let mut faults = Vec::new();
        for (films, names) in [("tasks", &rewrites.tasks), ("scenes", &rewrites.scenes)] {
            if names.all() > 0 && names.share_right() < ENOUGH {
                let share = 100.0 * names.share_right();
                faults.push(format!(
                    "only {share:.1} % of the {films} that a single belief makes wrong get its name"
                ));
            }
        }
        // For a single belief, a false name already lowers the share above. A single picture of
        // two beliefs may equal that of a third, so it is not counted.
        for names in [&compounds.tasks, &compounds.scenes] {
            faults.extend(names.wrong.iter().map(|film| format!("false name: {film}")));
        }
        faults
    }
}
