//! `pinhole grade`: grades a class of submissions.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use rayon::prelude::*;

use crate::cli::Grade;
use crate::grade::cache::{ResultCache, pretty, standing};
use crate::grade::class::{self, Roll, replace};
use crate::grade::grader::clock::Pace;
use crate::grade::grader::{Grader, fresh};
use crate::grade::intake::placement::Placement;
use crate::grade::intake::{self, Entry, roster};
use crate::grade::policy::Policy;
use crate::grade::provenance::{self, GradingInputs, Tool};
use crate::grade::queue::{GradeQueue, QueueResult, kept, valid};
use crate::grade::redact::Withheld;
use crate::grade::views::preview;
use crate::grade::views::progress::GradingProgress;
use crate::grade::views::summary::{ClassOutput, RunSummary};
use pinhole_course::assignment::Assignment;
use pinhole_course::checkout::Checkout;
use pinhole_course::compile::Compiler;
use pinhole_course::error::{Error, Result, ResultExt};
use pinhole_course::goldens::Goldens;
use pinhole_course::manifest::Manifest;
use pinhole_course::private::make_private;
use pinhole_course::progress::Progress;
use pinhole_course::sandbox::{Choice, Sandbox};
use pinhole_course::timings::Timings;
use pinhole_report::program::Status;

pub fn run(checkout: &Checkout, arguments: &Grade) -> Result<Status> {
    let assignment = arguments.assignment.find(checkout, None)?;
    let mut roll = roll(arguments, &assignment)?;
    let Some(out) = arguments.out.as_ref().filter(|_| !arguments.dry_run) else {
        return preview::print(&roll, &assignment, arguments.json);
    };
    let public = assignment.golden();
    // Use what is checked below, and not a link to it that another user may change.
    let real = |folder: &PathBuf| {
        folder.canonicalize().or_input(
            format_args!("cannot read {}", folder.display()),
            "pass a folder of goldens; `cargo pinhole golden render --out DIR` makes one",
        )
    };
    let golden = arguments.golden.as_ref().map(real).transpose()?;
    let fresh = arguments.fresh.as_ref().map(real).transpose()?;
    let folder = golden.as_ref().unwrap_or(&public);
    let goldens = Goldens::find(folder, &assignment)?;
    replace::refuse_inside(&arguments.paths, out)?;
    let cache = ResultCache::open(out)?;
    let earlier = cache.path(class::ROLL);
    let is_added = roll.passed.is_empty() && arguments.shard.is_none() && earlier.exists();
    let class = is_added.then(|| Roll::read(&earlier)).transpose()?;
    if let Some(class) = &class {
        roll.take_ids_of(class);
    }
    let new: Vec<Entry> = roll.entries.clone();
    let roll = match class {
        Some(class) => {
            replace::refuse_chosen_names(&roll, &class)?;
            replace::refuse_other_rules(&roll, &class, true)?;
            roll.into_class(class)
        }
        None => {
            let one = "to add or replace submissions, pass the path of each, not of the folder \
                       around them, and leave out --shard";
            replace::refuse_partial_class(&roll, &earlier, one)?;
            // A class of another version is graded again.
            if let Ok(class) = Roll::read(&earlier) {
                roll.note_changes(&class);
            }
            roll
        }
    };

    for folder in golden.iter().chain(&fresh) {
        if let Err(exposed) = fresh::refuse_exposed(folder) {
            // An instructor's own scenes need not be secret.
            if fresh.as_ref() == Some(folder) {
                return Err(exposed);
            }
            let Error {
                problem, remedy, ..
            } = exposed;
            anstream::eprintln!("{problem}; if these goldens are secret: {remedy}");
        }
    }
    let made = match (&fresh, arguments.no_fresh) {
        (_, true) => None,
        (Some(folder), _) => {
            let seed = Manifest::read(folder)?.probe_seed;
            Some((Goldens::read(folder, &assignment)?, seed))
        }
        (None, _) => {
            let folder = cache.path("fresh");
            let questions = fresh::Questions {
                folder,
                seed: arguments.seed,
                redraw: arguments.regrade,
            };
            questions.find_or_make(&assignment, checkout)?
        }
    };
    if let Some((questions, _)) = &made {
        fresh::reserve(&questions.folder, fresh::Purpose::Grading)?;
    }
    for folder in [Some(folder), made.as_ref().map(|(fresh, _)| &fresh.folder)]
        .into_iter()
        .flatten()
    {
        Manifest::read(folder)?.refuse_changed(folder, &assignment)?;
    }
    goldens.refuse_scene_without_tasks(&assignment)?;
    let withheld = Withheld {
        scenes: match arguments.golden {
            Some(_) => goldens
                .scenes
                .iter()
                .map(|scene| scene.name.clone())
                .collect(),
            None => assignment
                .withheld_scenes()
                .map(|scene| scene.name.clone())
                .collect(),
        },
        scene_groups: assignment.scene_groups(),
        probes: arguments.golden.is_some() && goldens.probes.is_none(),
        reveal: arguments.reveal,
    };
    let secrets = [
        Some(folder.clone()),
        made.as_ref().map(|(fresh, _)| fresh.folder.clone()),
    ];
    let secrets: Vec<PathBuf> = secrets
        .into_iter()
        .flatten()
        .chain([out.clone()])
        .chain(arguments.paths.iter().cloned())
        .chain(arguments.roster.clone())
        .chain(arguments.policy.clone())
        .collect();
    // Submissions are never trusted, even in the checkout.
    let sandbox = Sandbox::for_untrusted(
        "submissions",
        checkout,
        arguments.sandbox_choice(),
        &secrets,
    )?;
    let of_manifest = |folder: &Path| provenance::of_file(&folder.join("manifest.toml"));
    let made_with = GradingInputs {
        judged_on: judged_on(
            arguments.golden.is_some(),
            made.is_some(),
            arguments.sandbox_choice(),
        ),
        seed: made.as_ref().and_then(|(_, seed)| *seed),
        goldens: of_manifest(folder)?,
        fresh: made
            .as_ref()
            .map(|(fresh, _)| of_manifest(&fresh.folder))
            .transpose()?,
        assignment: provenance::of_assignment(&assignment, checkout)?,
        tool: Tool::this(checkout)?,
        sandbox: sandbox.name().into(),
        timeout: arguments.timeout,
        reveal: (withheld.any() || made.is_some()).then_some(arguments.reveal),
    };
    if made.is_none() {
        anstream::eprintln!(
            "no fresh questions are asked, so an answer could pass by memorising the goldens; to \
             ask fresh ones, install Mitsuba (cargo pinhole golden setup) and leave out --no-fresh"
        );
    }
    let progress = Progress::new();
    cache.write(class::ROLL, &pretty(&roll)?)?;
    let mine = intake::shard(new, arguments.shard);
    let start = Instant::now();
    let found = mine.par_iter().map(|entry| match arguments.regrade {
        true => Ok(Err(None)),
        false => valid(entry, &cache, &made_with, &assignment),
    });
    let found: Vec<_> = found.collect::<Result<_>>()?;
    let mut worked = Vec::new();
    let mut to_grade = Vec::new();
    let mut again: BTreeMap<&str, usize> = BTreeMap::new();
    for (entry, found) in mine.iter().zip(found) {
        match found {
            Ok(valid) => worked.push(valid),
            Err(why) => {
                to_grade.push(entry.clone());
                *again.entry(why.unwrap_or_default()).or_default() += 1;
            }
        }
    }
    again.remove("");
    for (why, count) in again {
        anstream::eprintln!("to be graded again: {count} (last graded with {why})");
    }
    let is_mine = |id: &str| mine.iter().any(|entry| entry.id == id);
    for entry in roll.entries.iter().filter(|entry| !is_mine(&entry.id)) {
        // Submissions of an earlier run into the same folder.
        if arguments.shard.is_none()
            && let Some(record) = standing(&cache.of(&entry.id), entry)
        {
            let is_old = !record.provenance.made_with.asks_the_same(&made_with);
            worked.push(kept(record, &cache, &assignment, is_old)?);
        }
    }
    let roll = match arguments.shard {
        None => roll,
        // A shard reports only its own submissions; the merge says what was not handed in.
        Some(_) => Roll {
            entries: mine,
            ..Roll::default()
        },
    };
    let output = ClassOutput {
        cache: &cache,
        assignment: &assignment,
        formats: &arguments.format,
        as_json: arguments.json,
    };
    if !to_grade.is_empty() {
        progress.say("building");
        let compiler = Compiler::new(&assignment, checkout, &sandbox)?;
        let programs = programs(&sandbox, checkout, &cache)?;
        progress.say("asking the reference");
        let judges: Vec<&Goldens> = [Some(&goldens), made.as_ref().map(|(fresh, _)| fresh)]
            .into_iter()
            .flatten()
            .collect();
        let least = Duration::from_secs(arguments.timeout);
        let pace = Pace::measure(&assignment, &judges, checkout, least)?;
        let grader = Grader {
            assignment: &assignment,
            checkout,
            goldens: &goldens,
            fresh: made.as_ref().map(|(goldens, _)| goldens),
            withheld,
            compiler: &compiler,
            sandbox: &sandbox,
            pace: &pace,
            programs: &programs,
            made_with: &made_with,
        };
        let so_far = |done: &[QueueResult]| {
            let done = worked.iter().chain(done).map(|it| &it.record);
            let records = done.map(|record| (record.id.clone(), record.clone()));
            let records = records.collect();
            // If this fails, the final write reports the error.
            let _ = output.write_so_far(&roll, &records);
        };
        let queue = GradeQueue {
            grader: &grader,
            cache: &cache,
            progress: GradingProgress::new(&progress, to_grade.len()),
            so_far: &so_far,
        };
        let done = queue.work(&to_grade, jobs(arguments));
        worked.extend(done);
        let _left_for_the_next_run = fs::remove_dir_all(&programs);
    }
    progress.clear();
    if arguments.timings {
        anstream::eprint!("{}", Timings::so_far());
    }

    let mut changes = Vec::new();
    let mut faults = Vec::new();
    let mut graded = 0;
    let mut records = BTreeMap::new();
    for done in worked {
        graded += usize::from(done.is_new);
        changes.extend(done.change);
        faults.extend(done.fault);
        records.insert(done.record.id.clone(), done.record);
    }
    class::sort_changes(&mut changes);
    let run = RunSummary {
        graded,
        seconds: start.elapsed().as_secs_f64(),
        changes,
        is_regrade: arguments.regrade,
        faults,
    };
    output.write(&roll, &records, &run)
}

fn jobs(arguments: &Grade) -> usize {
    let cores = std::thread::available_parallelism().map_or(1, usize::from);
    arguments.jobs.unwrap_or(cores)
}

/// The folder for this class's programs. Deletes programs that a killed run may have left. The
/// folder isn't in `--out`, because the user that runs the students' code may have no access there.
fn programs(sandbox: &Sandbox, checkout: &Checkout, cache: &ResultCache) -> Result<PathBuf> {
    let grading = sandbox.scratch(checkout).join("grading");
    let out = cache.path("");
    let out = out.canonicalize().unwrap_or(out);
    let name = provenance::sha256(out.as_os_str().as_encoded_bytes());
    let programs = grading.join(&name[..16]);
    let _absent = fs::remove_dir_all(&programs);
    if !sandbox.needs_access() {
        fs::create_dir_all(&grading)
            .and_then(|()| make_private(&grading))
            .or_fail(&Error::file(&grading))?;
    }
    Ok(programs)
}

/// Students read this text, so it must not name the seed, from which anyone could make the
/// questions.
fn judged_on(own: bool, fresh: bool, walls: Choice) -> String {
    let goldens = if own {
        "the instructor's goldens"
    } else {
        "public goldens"
    };
    let asked = match fresh {
        true => format!("{goldens} and fresh questions"),
        false => format!("{goldens} only"),
    };
    // Without a sandbox, the code could have got its answers from anywhere.
    match walls {
        Choice::None => format!("{asked}, without a sandbox"),
        _ => asked,
    }
}

/// The submissions, and the people who handed them in.
fn roll(arguments: &Grade, assignment: &Assignment) -> Result<Roll> {
    let policy = arguments.policy.as_ref();
    let policy = policy
        .map(|path| Policy::read(path, assignment))
        .transpose()?;
    let roster = arguments.roster.as_ref();
    let mut people = roster.map(|path| roster::read(path)).transpose()?;
    if let (Some(policy), Some(people)) = (&policy, &mut people) {
        class::know_groups(policy, people);
    }
    let intake = intake::find(&arguments.paths, assignment, people.as_deref())?;
    let mut roll = Roll {
        entries: intake.entries,
        people,
        placed: Placement {
            superseded: intake.superseded,
            ..Placement::default()
        },
        ignored: intake.ignored,
        passed: intake.passed,
        policy,
        changed: BTreeMap::new(),
    };
    roll.place();
    Ok(roll)
}
