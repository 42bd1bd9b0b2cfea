//! `pinhole grade`: a class of submissions, each on its own.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use crate::cli::Grade;
use crate::grade::cache::{Backlog, ResultCache, pretty};
use crate::grade::class::{self, Roll};
use crate::grade::grader::clock::Pace;
use crate::grade::grader::{Grader, fresh};
use crate::grade::intake::{self, Entry, roster};
use crate::grade::provenance::{self, MadeWith, Tool};
use crate::grade::queue::GradeQueue;
use crate::grade::redact::Withheld;
use crate::grade::views::csv;
use crate::grade::views::progress::GradingProgress;
use crate::grade::views::summary::{ClassOutput, RunSummary};
use pinhole_course::assignment::Assignment;
use pinhole_course::checkout::Checkout;
use pinhole_course::compile::Compiler;
use pinhole_course::error::Result;
use pinhole_course::goldens::Goldens;
use pinhole_course::manifest::Manifest;
use pinhole_course::progress::Progress;
use pinhole_course::sandbox::Sandbox;
use pinhole_course::timings::Timings;
use pinhole_report::program::Status;

pub fn run(checkout: &Checkout, arguments: &Grade) -> Result<Status> {
    let assignment = arguments.assignment.find(checkout, None)?;
    let roll = roll(arguments, &assignment)?;
    let public = assignment.golden();
    let folder = arguments.golden.as_ref().unwrap_or(&public);
    let goldens = Goldens::find(folder, &assignment)?;
    let cache = ResultCache::open(&arguments.out)?;

    let made = match (&arguments.fresh, arguments.no_fresh) {
        (_, true) => None,
        (Some(folder), _) => {
            let seed = Manifest::read(folder)?.probe_seed.unwrap_or_default();
            Some((Goldens::read(folder, &assignment)?, seed))
        }
        (None, _) => {
            let folder = cache.path("fresh");
            fresh::find_or_make(&folder, arguments.seed, &assignment, checkout)?
        }
    };
    for folder in [Some(folder), made.as_ref().map(|(fresh, _)| &fresh.folder)]
        .into_iter()
        .flatten()
    {
        Manifest::read(folder)?.refuse_changed(folder, &assignment)?;
    }
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
        .chain([arguments.out.clone()])
        .collect();
    // Submissions are never trusted for lying in the checkout.
    let sandbox = Sandbox::for_untrusted("submissions", checkout, arguments.walls(), &secrets)?;
    let of_manifest = |folder: &Path| provenance::of_file(&folder.join("manifest.toml"));
    let made_with = MadeWith {
        judged_on: judged_on(arguments.golden.is_some(), made.is_some()),
        seed: made.as_ref().map(|(_, seed)| *seed),
        goldens: of_manifest(folder)?,
        fresh: made
            .as_ref()
            .map(|(fresh, _)| of_manifest(&fresh.folder))
            .transpose()?,
        assignment: provenance::of_assignment(&assignment)?,
        tool: Tool::this()?,
        sandbox: sandbox.name().into(),
        timeout: arguments.timeout,
        reveal: (withheld.any() || made.is_some()).then_some(arguments.reveal),
    };
    if made.is_none() {
        anstream::eprintln!(
            "judged on {}: an answer could have memorised them. For fresh questions: \
             cargo pinhole golden setup",
            made_with.judged_on
        );
    }
    let progress = Progress::new();
    progress.say("building");
    let compiler = Compiler::new(&assignment, checkout, &sandbox)?;
    let programs = programs(checkout, &cache);
    progress.say("asking the reference");
    let judges: Vec<&Goldens> = [Some(&goldens), made.as_ref().map(|(fresh, _)| fresh)]
        .into_iter()
        .flatten()
        .collect();
    let least = Duration::from_secs(arguments.timeout);
    let pace = Pace::measure(&assignment, &judges, checkout, least)?;
    let grader = Grader {
        assignment: &assignment,
        goldens: &goldens,
        fresh: made.as_ref().map(|(goldens, _)| goldens),
        withheld,
        compiler: &compiler,
        sandbox: &sandbox,
        pace: &pace,
        programs: &programs,
        made_with: &made_with,
    };
    cache.write(class::ROLL, &pretty(&roll)?)?;
    let mine = intake::shard(roll.entries.clone(), arguments.shard);
    Backlog::begin(&mine, &cache, &assignment, &made_with)?;
    let start = Instant::now();
    let queue = GradeQueue {
        grader: &grader,
        cache: &cache,
        regrade: arguments.regrade,
        progress: GradingProgress::new(&progress, mine.len()),
    };
    let worked = queue.work(&mine, jobs(arguments));
    Backlog::end(&cache);
    progress.clear();
    if arguments.timings {
        anstream::eprint!("{}", Timings::so_far());
    }
    let _left_for_the_next_run = fs::remove_dir_all(&programs);

    let mut records = BTreeMap::new();
    let mut changes = Vec::new();
    let mut faults = Vec::new();
    let mut graded = 0;
    for done in worked {
        graded += usize::from(done.is_new);
        changes.extend(done.change);
        faults.extend(done.fault);
        records.insert(done.record.id.clone(), done.record);
    }
    class::sort_changes(&mut changes);
    let roll = match arguments.shard {
        None => roll,
        // A shard reports only its own submissions; the merge says what was not handed in.
        Some(_) => Roll {
            entries: mine,
            ..Roll::default()
        },
    };
    if arguments.regrade {
        cache.write("changes.csv", &csv::changes(&changes))?;
    }
    let run = RunSummary {
        graded,
        seconds: start.elapsed().as_secs_f64(),
        changes,
        faults,
    };
    let output = ClassOutput {
        cache: &cache,
        assignment: &assignment,
        formats: &arguments.format,
        as_json: arguments.json,
    };
    Ok(super::of_class(output.write(&roll, &records, &run)?))
}

fn jobs(arguments: &Grade) -> usize {
    let cores = std::thread::available_parallelism().map_or(1, usize::from);
    arguments.jobs.unwrap_or(cores)
}

/// Where this class's programs lie while they are asked, without those of a run that was
/// killed. Not in `--out`: the user that the code runs as may have no access there.
fn programs(checkout: &Checkout, cache: &ResultCache) -> PathBuf {
    let out = cache.path("");
    let out = out.canonicalize().unwrap_or(out);
    let name = provenance::sha256(out.as_os_str().as_encoded_bytes());
    let programs = checkout.scratch().join("grading").join(&name[..16]);
    let _absent = fs::remove_dir_all(&programs);
    programs
}

/// Students read this, so it does not name the seed: who knows it can make the questions.
fn judged_on(own: bool, fresh: bool) -> String {
    let goldens = if own {
        "the instructor's goldens"
    } else {
        "public goldens"
    };
    match fresh {
        true => format!("{goldens} and fresh questions"),
        false => format!("{goldens} only"),
    }
}

/// What was handed in, and whose it is.
fn roll(arguments: &Grade, assignment: &Assignment) -> Result<Roll> {
    let intake = intake::find(&arguments.paths, assignment)?;
    let people = arguments
        .roster
        .as_ref()
        .map(|path| roster::read(path))
        .transpose()?;
    let placed = roster::place(&intake.entries, people.as_deref());
    let counts = |entry: &Entry| !placed.superseded.contains_key(&entry.id);
    Ok(Roll {
        entries: intake.entries.into_iter().filter(counts).collect(),
        placed,
        ignored: intake.ignored,
    })
}
