//! Judges submissions that people wrote and whose verdict is known: the stub, the reference,
//! mistakes, rewrites of them, and variants.

mod bases;

use std::path::PathBuf;

use serde::Serialize;

use super::naming::SubmissionDiagnosisCounts;
use super::validator::Validator;
use crate::scene_cap::most_for_scenes;
use bases::{Bases, OverlayBase};
use pinhole_course::error::{Error, Result};
use pinhole_course::examine::Selection;
use pinhole_course::mistake;
use pinhole_course::outcome::{AnswerFile, FilmOutcome, Outcome};
use pinhole_course::overlay;
use pinhole_course::stubs;
use pinhole_course::submission::{Answer, Submission};

/// The results of the stub and the reference.
#[derive(Debug, Serialize)]
pub struct PristineVerdicts {
    /// The reference's points, and the points that are possible.
    pub reference: (u32, u32),
    /// The stub's points.
    pub stub: u32,
    /// The verdicts that differ from the required ones.
    pub faults: Vec<String>,
}

/// Submissions of one kind.
#[derive(Debug, Serialize)]
pub struct SubmissionVerdicts {
    /// The verdicts, by the submissions' names.
    pub judged: Vec<SubmissionVerdict>,
}

/// One submission's verdict.
#[derive(Clone, Debug, Serialize)]
pub struct SubmissionVerdict {
    /// Its folder inside the assignment.
    pub name: String,
    /// Whether it has a single belief.
    pub single: bool,
    /// Whether it is composed of the folders of several beliefs.
    pub composed: bool,
    /// Tasks that must lose points, sorted. Empty if it must pass.
    pub declared: Vec<String>,
    /// Tasks that lose points, sorted.
    pub tasks: Vec<String>,
    /// Groups of questions that fail, as `task.group`.
    pub groups: Vec<String>,
    /// Scenes that fail.
    pub scenes: Vec<String>,
    /// Points that its scenes earn, before the limit.
    pub scene_points: u32,
    /// The most that the scenes may earn; see [`crate::scene_cap`].
    pub most_for_scenes: u32,
    /// Answers that do not compile, whose failure therefore shows nothing.
    pub not_compiled: Vec<String>,
    /// What its diagnoses name.
    pub naming: SubmissionDiagnosisCounts,
}

/// Judges the stub and the reference on everything.
pub fn pristine(validator: &Validator) -> Result<PristineVerdicts> {
    let all = [stub(validator)?, overlay::reference(validator.assignment)?];
    let examined = validator.all("stub and reference", &all, |submission| {
        validator.examine(submission, &Selection::default())
    })?;
    let [stub, reference] = &examined[..] else {
        unreachable!("two submissions have two results");
    };
    let mut faults = Vec::new();
    let is_empty =
        |film: &FilmOutcome| matches!(film, FilmOutcome::Unanswered | FilmOutcome::Blocked { .. });
    let (stub, reference) = (&stub.outcome, &reference.outcome);
    let answered = films(stub).filter(|(_, film)| !is_empty(film));
    faults.extend(answered.map(|(name, _)| format!("{name} counts as answered by the stub")));
    let wrong = films(reference).filter(|(_, film)| !film.passes());
    faults.extend(wrong.map(|(name, _)| format!("false fail: the reference fails {name}")));
    Ok(PristineVerdicts {
        reference: (reference.points.unwrap_or_default(), reference.possible),
        stub: stub.points.unwrap_or_default(),
        faults,
    })
}

/// The generated handout, because the committed one may have been filled in.
fn stub(validator: &Validator) -> Result<Submission> {
    let package = stubs::generate(validator.assignment)?;
    let text = |file: String| package.get(&PathBuf::from("src").join(file)).cloned();
    let answers = validator.assignment.tasks.iter().map(|task| Answer {
        task: task.name.clone(),
        text: Ok(text(task.file()).unwrap_or_default()),
    });
    Ok(Submission {
        folder: validator.assignment.handout(),
        read_from: validator.assignment.handout(),
        place: validator.assignment.handout().join("src"),
        answers: answers.collect(),
        examples: Vec::new(),
    })
}

/// Everything that was asked, by name.
fn films(outcome: &Outcome) -> impl Iterator<Item = (String, &FilmOutcome)> {
    outcome.films().map(|(task, name, film)| match task {
        Some(task) => (format!("{task}.{name}"), film),
        None => (name.to_owned(), film),
    })
}

/// Folders to lay over other answers, one after the other, and the expected verdict.
struct Overlay {
    name: String,
    folders: Vec<PathBuf>,
    single: bool,
    declared: Vec<String>,
    beliefs: Vec<String>,
    under: OverlayBase,
}

/// Judges the mistakes and their rewrites whose names contain `named`.
pub fn mistakes(
    validator: &Validator,
    named: &str,
) -> Result<(SubmissionVerdicts, SubmissionVerdicts)> {
    let mut mistakes = Vec::new();
    let mut rewrites = Vec::new();
    for found in mistake::read_all(validator.assignment)? {
        let mut declared = found.mistake.fails.clone();
        declared.sort();
        let single = found.mistake.is_single();
        let beliefs = match single {
            true => vec![found.slug.clone()],
            false => found.mistake.beliefs.clone(),
        };
        let folders = found.overlays(validator.assignment)?;
        let rewritten = folders.iter().map(|folder| folder.join("rewrite"));
        let rewritten: Vec<PathBuf> = rewritten.collect();
        if rewritten.iter().all(|folder| folder.is_dir()) {
            rewrites.push(Overlay {
                name: format!("mistakes/{}/rewrite", found.slug),
                folders: rewritten,
                single,
                declared: declared.clone(),
                beliefs: beliefs.clone(),
                under: OverlayBase::Variants(rewrites.len()),
            });
        }
        mistakes.push(Overlay {
            name: format!("mistakes/{}", found.slug),
            single,
            folders,
            declared,
            beliefs,
            under: match single {
                true => OverlayBase::ReferenceUnaware,
                false => OverlayBase::Reference,
            },
        });
    }
    let mistakes = judge_all(validator, "mistakes", mistakes, named)?;
    let rewrites = judge_all(validator, "rewrites of mistakes", rewrites, named)?;
    Ok((mistakes, rewrites))
}

/// Judges the variants whose names contain `named`.
pub fn variants(validator: &Validator, named: &str) -> Result<SubmissionVerdicts> {
    let found = mistake::folders(&validator.assignment.folder.join("variants"));
    let overlay = |(slug, folder)| Overlay {
        name: format!("variants/{slug}"),
        folders: vec![folder],
        single: false,
        declared: Vec::new(),
        beliefs: Vec::new(),
        under: OverlayBase::Reference,
    };
    let overlays = found.into_iter().map(overlay).collect();
    judge_all(validator, "variants", overlays, named)
}

fn judge_all(
    validator: &Validator,
    what: &str,
    all: Vec<Overlay>,
    named: &str,
) -> Result<SubmissionVerdicts> {
    let bases = Bases::new(validator)?;
    let wanted = |overlay: &Overlay| overlay.name.contains(named);
    let wanted: Vec<Overlay> = all.into_iter().filter(wanted).collect();
    let judged = validator.all(what, &wanted, |overlay| {
        let is_empty = |folder: &&PathBuf| {
            let mut tasks = validator.assignment.tasks.iter();
            !tasks.any(|task| folder.join(task.file()).is_file())
        };
        if let Some(folder) = overlay.folders.iter().find(is_empty) {
            return Err(Error::input(
                format!("{} contains no answer file", folder.display()),
                "put the answer file that differs from the reference into this folder, or remove \
                 the folder and whatever names it",
            ));
        }
        let base = bases.of(overlay.under);
        let goldens = match overlay.under {
            OverlayBase::ReferenceUnaware => {
                let own = overlay.beliefs.first().map_or("", String::as_str);
                Some(validator.goldens.unaware_of(own))
            }
            _ => None,
        };
        let validator = Validator {
            goldens: goldens.as_ref().unwrap_or(validator.goldens),
            ..*validator
        };
        let mut folders = overlay.folders.iter();
        let under = base.submission.clone();
        let submission = folders.try_fold(under, |under, folder| under.overlaid(folder))?;
        let examination = validator.examine_over(&submission, base)?;
        let naming = SubmissionDiagnosisCounts::of(
            &validator,
            &overlay.name,
            &examination,
            &overlay.beliefs,
        )?;
        let needs = validator.goldens.needs_of_scenes(validator.assignment)?;
        let most = most_for_scenes(&examination.outcome, &[], &needs, &[]);
        Ok(SubmissionVerdict::of(
            &examination.outcome,
            overlay,
            naming,
            most,
        ))
    })?;
    Ok(SubmissionVerdicts { judged })
}

impl SubmissionVerdict {
    fn of(
        outcome: &Outcome,
        overlay: &Overlay,
        naming: SubmissionDiagnosisCounts,
        most_for_scenes: u32,
    ) -> SubmissionVerdict {
        let mut tasks = Vec::new();
        let mut groups = Vec::new();
        for task in &outcome.tasks {
            let failing = task.groups.iter().filter(|group| !group.outcome.passes());
            let names: Vec<String> = failing
                .map(|group| format!("{}.{}", task.name, group.name))
                .collect();
            tasks.extend((!names.is_empty()).then(|| task.name.clone()));
            groups.extend(names);
        }
        tasks.sort();
        let scenes = outcome.scenes.iter();
        let scenes = scenes.filter(|scene| !scene.outcome.passes());
        let tasks_asked = outcome.tasks.iter();
        let replaced = tasks_asked.filter(|task| task.file != AnswerFile::Compiled);
        SubmissionVerdict {
            name: overlay.name.clone(),
            single: overlay.single,
            composed: overlay.folders.len() > 1,
            declared: overlay.declared.clone(),
            tasks,
            groups,
            scenes: scenes.map(|scene| scene.name.clone()).collect(),
            scene_points: outcome.scenes.iter().map(|scene| scene.points).sum(),
            most_for_scenes,
            not_compiled: replaced.map(|task| task.name.clone()).collect(),
            naming,
        }
    }

    /// Whether something fails.
    pub fn is_caught(&self) -> bool {
        !(self.groups.is_empty() && self.scenes.is_empty())
    }

    /// Whether it fails in exactly the tasks it declares, or passes if it must.
    pub fn is_as_declared(&self) -> bool {
        let passes = self.declared.is_empty() && self.is_caught();
        self.not_compiled.is_empty() && self.tasks == self.declared && !passes
    }

    /// What is wrong with its verdict, if anything.
    pub fn faults(&self) -> Option<String> {
        let SubmissionVerdict { name, .. } = self;
        let listed = |names: &[String]| match names {
            [] => "no task".into(),
            names => names.join(", "),
        };
        if !self.not_compiled.is_empty() {
            let files = listed(&self.not_compiled);
            return Some(format!("{name} does not compile: {files}"));
        }
        if self.is_as_declared() {
            return None;
        }
        Some(match (self.declared.as_slice(), self.is_caught()) {
            ([], _) => {
                let films: Vec<String> = self.groups.iter().chain(&self.scenes).cloned().collect();
                format!("false fail: {name} fails {}", films.join(", "))
            }
            (_, false) => format!("missed: {name} passes everything"),
            (declared, true) => format!(
                "{name} is declared to fail in {}, but fails in {}",
                listed(declared),
                listed(&self.tasks)
            ),
        })
    }
}
