//! Fresh questions, the same for the whole class, and the points lost to them.
//!
//! A student who has the public goldens could write them into the answer files. Questions and
//! scenes from a fresh seed cannot be known in advance.

use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};

use crate::golden;
use crate::golden::arguments::{GoldenRender, random_seed};
use crate::grade::provenance;
use pinhole_course::assignment::Assignment;
use pinhole_course::checkout::Checkout;
use pinhole_course::error::{Error, Result, ResultExt};
use pinhole_course::goldens::Goldens;
use pinhole_course::manifest::Manifest;
use pinhole_course::mitsuba;
use pinhole_course::outcome::{GroupOutcome, Outcome};
use pinhole_course::private::is_hidden;
use pinhole_course::run_options::AssignmentOption;
use pinhole_course::seed::Seed;
use pinhole_course::shell::in_shell;

/// The fresh questions of a class.
pub struct Questions {
    /// The folder that contains them, or will contain them.
    pub folder: PathBuf,
    /// The seed to draw them from, if the user chose one.
    pub seed: Option<Seed>,
    /// Whether to draw new questions even if the folder already has some. Students know from their
    /// results which of the old ones they failed.
    pub redraw: bool,
}

impl Questions {
    /// Whether the existing questions, drawn from the seed `kept`, can be asked.
    fn serve(&self, kept: Option<Seed>) -> bool {
        match self.seed {
            Some(_) => kept == self.seed,
            None => kept.is_some() && !self.redraw,
        }
    }

    /// Finds the goldens of the fresh questions, or makes them. Returns them with their seed, or
    /// `None` if Mitsuba is not installed.
    pub fn find_or_make(
        &self,
        assignment: &Assignment,
        checkout: &Checkout,
    ) -> Result<Option<(Goldens, Option<Seed>)>> {
        let folder = &self.folder;
        let manifest = Manifest::read(folder).ok();
        let kept = manifest.and_then(|manifest| manifest.probe_seed);
        if self.serve(kept) {
            return Ok(Some((Goldens::read(folder, assignment)?, kept)));
        }
        if !mitsuba::is_there(checkout) {
            return match self.seed.or(kept) {
                Some(_) => Err(Error::environment(
                    "Mitsuba is needed to make fresh questions, but is not installed",
                    "install it (cargo pinhole golden setup), or pass --fresh DIR or --no-fresh",
                )),
                None => Ok(None),
            };
        }
        let seed = match self.seed {
            Some(seed) => seed,
            None => random_seed().or_environment(
                "the system has no random numbers for a seed",
                "pass a seed with --seed",
            )?,
        };
        anstream::eprintln!("making fresh questions with Mitsuba …");
        // Make them in another folder and rename it, so that the folder is complete or missing if
        // we are killed.
        let beside = folder.with_extension("new");
        let _left_behind = fs::remove_dir_all(&beside);
        let request = GoldenRender {
            assignment: AssignmentOption::default(),
            scenes: Vec::new(),
            out: Some(beside.clone()),
            seed: Some(seed),
            force: false,
            no_mistakes: true,
        };
        golden::make(assignment, checkout, &request)?;
        // Keep earlier questions, because marks based on them may be disputed.
        let retired = retired(folder).find(|place| !place.exists());
        let kept = match retired.filter(|_| folder.is_dir()) {
            Some(place) => fs::rename(folder, place),
            None => Ok(()),
        };
        kept.and_then(|()| fs::rename(&beside, folder))
            .or_environment(
                format_args!("cannot keep fresh questions in {}", folder.display()),
                "check that the folder can be written",
            )?;
        Ok(Some((Goldens::read(folder, assignment)?, Some(seed))))
    }
}

/// The places for a folder's earlier questions, the oldest first.
fn retired(folder: &Path) -> impl Iterator<Item = PathBuf> {
    (1..).map(|number| folder.with_extension(format!("retired-{number}")))
}

/// Where the questions with this hash of their manifest are now: in their folder or, if others were
/// drawn since, among its earlier ones.
pub fn still_kept(folder: &Path, manifest: &str) -> Option<PathBuf> {
    let earlier = retired(folder).take_while(|place| place.exists());
    let mut places = std::iter::once(folder.to_owned()).chain(earlier);
    places.find(|place| {
        let hash = provenance::of_file(&place.join("manifest.toml"));
        hash.is_ok_and(|hash| hash == manifest)
    })
}

/// What the fresh questions in a folder are for. A student who may submit many times gets to know
/// the questions behind the feedback, so the mark needs different ones.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Purpose {
    /// Feedback from an autograder, to which students may submit again and again.
    Feedback,
    /// A mark.
    Grading,
}

/// The file that records a folder's purpose. Its name begins with a dot, so that it isn't packed
/// into archives.
const PURPOSE: &str = ".purpose";

/// Reserves a folder of fresh questions for one purpose. It can never serve the other one.
///
/// # Errors
/// If the folder has been used for the other purpose.
pub fn reserve(folder: &Path, purpose: Purpose) -> Result<()> {
    let path = folder.join(PURPOSE);
    let word = match purpose {
        Purpose::Feedback => "feedback",
        Purpose::Grading => "grading",
    };
    match fs::read_to_string(&path) {
        Ok(other) if other.trim() == word => Ok(()),
        Ok(other) => Err(Error::input(
            format!(
                "the fresh questions in {} have already been used for {}",
                folder.display(),
                other.trim()
            ),
            "make others: cargo pinhole golden render --seed random --no-mistakes --out DIR",
        )),
        // Don't write through a link that somebody else has put there, and leave no empty file.
        Err(_) => tempfile::NamedTempFile::new_in(folder)
            .and_then(|mut file| {
                writeln!(file, "{word}")?;
                file.persist(&path)?;
                Ok(())
            })
            .or_input(
                format_args!("cannot write {}", path.display()),
                "copy the folder to a place where you may write",
            ),
    }
}

/// Refuses a folder of goldens that other users can read or replace.
pub fn refuse_exposed(folder: &Path) -> Result<()> {
    if is_hidden(folder) {
        return Ok(());
    }
    let name = folder.display().to_string();
    Err(Error::input(
        format!("other users can read or replace {name}"),
        format!(
            "move it to a folder of yours, and chmod go-rwx {}",
            in_shell(&name)
        ),
    ))
}

/// Takes away the points of groups that pass the public questions but fail fresh ones.
pub fn revoke_failing_fresh(outcome: &mut Outcome, fresh: &Outcome) {
    for task in &mut outcome.tasks {
        let Some(again) = fresh.tasks.iter().find(|again| again.name == task.name) else {
            continue;
        };
        for (group, again) in task.groups.iter_mut().zip(&again.groups) {
            if group.outcome.passes() && !again.outcome.passes() {
                *group = GroupOutcome {
                    points: 0,
                    outcome: again.outcome.clone(),
                    worst: again.worst.clone(),
                    fails_fresh: true,
                    ..group.clone()
                };
            }
        }
    }
    outcome.add_up();
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn earlier_questions_are_found_where_they_were_put() {
        let out = tempfile::tempdir().expect("there is room");
        let folder = out.path().join("fresh");
        for (place, manifest) in [("fresh", "new"), ("fresh.retired-1", "old")] {
            let place = out.path().join(place);
            fs::create_dir(&place).expect("there is room");
            fs::write(place.join("manifest.toml"), manifest).expect("there is room");
        }
        let kept = |manifest: &str| still_kept(&folder, &provenance::sha256(manifest.as_bytes()));
        assert_eq!(kept("new"), Some(folder.clone()));
        assert_eq!(kept("old"), Some(out.path().join("fresh.retired-1")));
        assert_eq!(kept("lost"), None);
    }

    #[test]
    fn regrade_draws_new_questions_and_a_resumed_run_keeps_them() {
        let serve = |seed: Option<u128>, redraw, kept: Option<u128>| {
            let questions = Questions {
                folder: PathBuf::new(),
                seed: seed.map(Seed),
                redraw,
            };
            questions.serve(kept.map(Seed))
        };
        assert!(serve(None, false, Some(7)), "a resumed run");
        assert!(!serve(None, true, Some(7)), "a regrade");
        assert!(
            serve(Some(7), true, Some(7)),
            "a regrade with the same seed"
        );
        assert!(!serve(Some(8), false, Some(7)), "another seed");
        assert!(!serve(None, false, None), "the first run");
    }

    #[test]
    fn no_questions_are_used_both_for_feedback_and_for_marks() {
        for (first, second) in [
            (Purpose::Feedback, Purpose::Grading),
            (Purpose::Grading, Purpose::Feedback),
        ] {
            let folder = tempfile::tempdir().expect("there is room");
            let reserve = |purpose| reserve(folder.path(), purpose);
            assert!(reserve(first).is_ok(), "the first time");
            assert!(reserve(first).is_ok(), "a resumed run");
            assert!(reserve(second).is_err(), "{first:?}, then {second:?}");
        }
        #[cfg(unix)]
        {
            let folder = tempfile::tempdir().expect("there is room");
            let victim = folder.path().join("victim");
            let link = folder.path().join(PURPOSE);
            std::os::unix::fs::symlink(&victim, link).expect("there is room");
            assert!(reserve(folder.path(), Purpose::Grading).is_ok());
            assert!(!victim.exists(), "it wrote through a link");
        }
    }

    #[test]
    fn random_seeds_use_all_their_bits() {
        let seeds: Vec<u128> = (0..64).map(|_| random_seed().expect("random").0).collect();
        let any = seeds.iter().fold(0, |any, seed| any | seed);
        let all = seeds.iter().fold(u128::MAX, |all, seed| all & seed);
        // With random bits, one in 2^56 tries fails.
        assert_eq!((any, all), (u128::MAX, 0));
    }
}
