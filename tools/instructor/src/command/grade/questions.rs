//! The questions that a class is judged by, and what its results say about them.

use std::path::{Path, PathBuf};

use crate::cli::Grade;
use crate::grade::cache::ResultCache;
use crate::grade::grader::fresh;
use crate::grade::provenance::{self, GradingInputs, Tool};
use crate::grade::redact::Withheld;
use pinhole_course::assignment::Assignment;
use pinhole_course::checkout::Checkout;
use pinhole_course::error::{Error, Result, ResultExt};
use pinhole_course::goldens::Goldens;
use pinhole_course::manifest::Manifest;
use pinhole_course::sandbox::{Choice, Sandbox};
use pinhole_course::seed::Seed;

/// The folders of goldens that the user named. Their paths contain no link, which another user
/// might change after the checks.
pub struct Folders {
    golden: Option<PathBuf>,
    fresh: Option<PathBuf>,
}

impl Folders {
    pub fn of(arguments: &Grade) -> Result<Folders> {
        let real = |folder: &PathBuf| {
            folder.canonicalize().or_input(
                format_args!("cannot read {}", folder.display()),
                "pass a folder of goldens; `cargo pinhole golden render --out DIR` makes one",
            )
        };
        Ok(Folders {
            golden: arguments.golden.as_ref().map(real).transpose()?,
            fresh: arguments.fresh.as_ref().map(real).transpose()?,
        })
    }

    /// The goldens to judge by, besides the fresh questions.
    pub fn goldens(&self, assignment: &Assignment) -> Result<Goldens> {
        let public = assignment.golden();
        Goldens::find(self.golden.as_ref().unwrap_or(&public), assignment)
    }

    /// Refuses fresh questions that other users can read or replace. Only warns of other goldens,
    /// because an instructor's own scenes need not be secret.
    pub fn refuse_exposed(&self) -> Result<()> {
        let golden = self.golden.as_deref().map(fresh::refuse_exposed);
        if let Some(Err(exposed)) = golden {
            let Error {
                problem, remedy, ..
            } = exposed;
            anstream::eprintln!("{problem}; if these goldens are secret: {remedy}");
        }
        self.fresh.as_deref().map_or(Ok(()), fresh::refuse_exposed)
    }
}

/// What code from students must not read: goldens, results and everything that the user passed.
pub fn secrets(
    arguments: &Grade,
    goldens: &Goldens,
    folders: &Folders,
    out: &Path,
) -> Vec<PathBuf> {
    let Grade {
        paths,
        roster,
        policy,
        ..
    } = arguments;
    // Fresh questions that are made later lie in `out`.
    [goldens.folder.clone(), out.to_owned()]
        .into_iter()
        .chain(folders.fresh.clone())
        .chain(paths.iter().cloned())
        .chain(roster.clone())
        .chain(policy.clone())
        .collect()
}

/// The questions that a class is judged by.
pub struct Questions {
    pub goldens: Goldens,
    pub fresh: Option<Goldens>,
    /// The seed that the fresh questions were drawn from.
    seed: Option<Seed>,
    pub withheld: Withheld,
}

impl Questions {
    /// Finds the fresh questions, or makes them, and checks that all goldens can be asked.
    pub fn find_or_make(
        goldens: Goldens,
        folders: &Folders,
        arguments: &Grade,
        cache: &ResultCache,
        assignment: &Assignment,
        checkout: &Checkout,
    ) -> Result<Questions> {
        let made = match (&folders.fresh, arguments.no_fresh) {
            (_, true) => None,
            (Some(folder), _) => {
                let seed = Manifest::read(folder)?.probe_seed;
                Some((Goldens::read(folder, assignment)?, seed))
            }
            (None, _) => {
                let folder = cache.path("fresh");
                let questions = fresh::Questions {
                    folder,
                    seed: arguments.seed,
                    redraw: arguments.regrade,
                };
                questions.find_or_make(assignment, checkout)?
            }
        };
        let (fresh, seed) = made.unzip();
        if let Some(fresh) = &fresh {
            fresh::reserve(&fresh.folder, fresh::Purpose::Grading)?;
        }
        let questions = Questions {
            withheld: withheld(&goldens, assignment, arguments),
            goldens,
            fresh,
            seed: seed.flatten(),
        };
        for goldens in questions.all() {
            let folder = &goldens.folder;
            Manifest::read(folder)?.refuse_changed(folder, assignment)?;
        }
        questions.goldens.refuse_scene_without_tasks(assignment)?;
        Ok(questions)
    }

    /// The goldens of all questions.
    pub fn all(&self) -> Vec<&Goldens> {
        [Some(&self.goldens), self.fresh.as_ref()]
            .into_iter()
            .flatten()
            .collect()
    }

    /// What every result says it was made with.
    pub fn grading_inputs(
        &self,
        arguments: &Grade,
        assignment: &Assignment,
        checkout: &Checkout,
        sandbox: &Sandbox,
    ) -> Result<GradingInputs> {
        let of_manifest =
            |goldens: &Goldens| provenance::of_file(&goldens.folder.join("manifest.toml"));
        let hides = self.withheld.any() || self.fresh.is_some();
        Ok(GradingInputs {
            judged_on: self.in_words(arguments),
            seed: self.seed,
            goldens: of_manifest(&self.goldens)?,
            fresh: self.fresh.as_ref().map(of_manifest).transpose()?,
            assignment: provenance::of_assignment(assignment, checkout)?,
            tool: Tool::this(checkout)?,
            sandbox: sandbox.name().into(),
            timeout: arguments.timeout,
            reveal: hides.then_some(arguments.reveal),
        })
    }

    /// Students read this text, so it must not name the seed, from which anyone could make the
    /// questions.
    fn in_words(&self, arguments: &Grade) -> String {
        let goldens = match arguments.golden {
            Some(_) => "the instructor's goldens",
            None => "public goldens",
        };
        let asked = match self.fresh {
            Some(_) => format!("{goldens} and fresh questions"),
            None => format!("{goldens} only"),
        };
        // Without a sandbox, the code could have got its answers from anywhere.
        match arguments.sandbox_choice() {
            Choice::None => format!("{asked}, without a sandbox"),
            _ => asked,
        }
    }
}

/// What must not be shown to students of `goldens`.
fn withheld(goldens: &Goldens, assignment: &Assignment, arguments: &Grade) -> Withheld {
    let is_own = arguments.golden.is_some();
    let own = goldens.scenes.iter().filter(|_| is_own);
    let assigned = assignment.withheld_scenes().filter(|_| !is_own);
    Withheld {
        scenes: own
            .map(|scene| scene.name.clone())
            .chain(assigned.map(|scene| scene.name.clone()))
            .collect(),
        scene_groups: assignment.scene_groups(),
        probes: is_own && goldens.probes.is_none(),
        reveal: arguments.reveal,
    }
}
