//! `pinhole grade`: a class of submissions, each on its own.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use crate::cli::Grade;
use crate::grade::bench::Bench;
use crate::grade::changes;
use crate::grade::class::{self, Roll};
use crate::grade::clock::Pace;
use crate::grade::desk::Desk;
use crate::grade::finish::{Telling, Told};
use crate::grade::intake::{self, Entry};
use crate::grade::provenance::{self, MadeWith, Tool};
use crate::grade::redact::Withheld;
use crate::grade::store::{Store, pretty};
use crate::grade::unfinished::Unfinished;
use crate::grade::{fresh, roster};
use pinhole_course::assignment::Assignment;
use pinhole_course::checkout::Checkout;
use pinhole_course::compile::Compiler;
use pinhole_course::error::Result;
use pinhole_course::goldens::Goldens;
use pinhole_course::manifest::Manifest;
use pinhole_course::progress::Progress;
use pinhole_course::sandbox::Sandbox;
use pinhole_report::program::Status;

pub fn run(checkout: &Checkout, arguments: &Grade) -> Result<Status> {
    let assignment = arguments.assignment.find(checkout, None)?;
    let roll = roll(arguments, &assignment)?;
    let public = checkout.golden(&assignment.name);
    let folder = arguments.golden.as_ref().unwrap_or(&public);
    let goldens = Goldens::find(folder, &assignment, checkout)?;
    let store = Store::open(&arguments.out)?;

    let made = match (&arguments.fresh, arguments.no_fresh) {
        (_, true) => None,
        (Some(folder), _) => {
            let seed = Manifest::read(folder)?.probe_seed.unwrap_or_default();
            Some((Goldens::read(folder, &assignment)?, seed))
        }
        (None, _) => {
            let folder = store.path("fresh");
            fresh::find_or_make(&folder, arguments.seed, &assignment, checkout)?
        }
    };
    for folder in [Some(folder), made.as_ref().map(|(fresh, _)| &fresh.folder)]
        .into_iter()
        .flatten()
    {
        Manifest::read(folder)?.refuse_changed(folder, checkout)?;
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
    let sandbox = Sandbox::for_strangers("submissions", checkout, arguments.walls(), &secrets)?;
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
    let rooms = rooms(checkout, &store);
    progress.say("asking the reference");
    let judges: Vec<&Goldens> = [Some(&goldens), made.as_ref().map(|(fresh, _)| fresh)]
        .into_iter()
        .flatten()
        .collect();
    let least = Duration::from_secs(arguments.timeout);
    let pace = Pace::measure(&assignment, &judges, checkout, least)?;
    let bench = Bench {
        assignment: &assignment,
        goldens: &goldens,
        fresh: made.as_ref().map(|(goldens, _)| goldens),
        withheld,
        compiler: &compiler,
        sandbox: &sandbox,
        pace: &pace,
        rooms: &rooms,
        made_with: &made_with,
    };
    store.write(class::ROLL, &pretty(&roll)?)?;
    let mine = intake::shard(roll.entries.clone(), arguments.shard);
    Unfinished::begin(&mine, &store, &assignment, &made_with)?;
    let start = Instant::now();
    let desk = Desk::new(&bench, &store, arguments.regrade, &progress, mine.len());
    let worked = desk.work(&mine, jobs(arguments));
    Unfinished::end(&store);
    progress.clear();
    let _left_for_the_next_run = fs::remove_dir_all(&rooms);

    let mut records = BTreeMap::new();
    let mut changes = Vec::new();
    let mut faults = Vec::new();
    let mut anew = 0;
    for done in worked {
        anew += usize::from(done.anew);
        changes.extend(done.change);
        faults.extend(done.fault);
        records.insert(done.record.id.clone(), done.record);
    }
    changes::sort(&mut changes);
    let roll = match arguments.shard {
        None => roll,
        // A shard speaks of its own; what was not handed in is for the merge to say.
        Some(_) => Roll {
            entries: mine,
            ..Roll::default()
        },
    };
    if arguments.regrade {
        store.write("changes.csv", &changes::csv(&changes))?;
    }
    let told = Told {
        anew,
        seconds: start.elapsed().as_secs_f64(),
        changes,
        faults,
    };
    let telling = Telling {
        store: &store,
        assignment: &assignment,
        formats: &arguments.format,
        as_json: arguments.json,
    };
    Ok(super::of_class(telling.finish(&roll, &records, &told)?))
}

fn jobs(arguments: &Grade) -> usize {
    let cores = std::thread::available_parallelism().map_or(1, usize::from);
    arguments.jobs.unwrap_or(cores)
}

/// Where this class's programs lie while they are asked, without those of a run that was
/// killed. Not in `--out`: whom the code runs as may not get there.
fn rooms(checkout: &Checkout, store: &Store) -> PathBuf {
    let out = store.path("");
    let out = out.canonicalize().unwrap_or(out);
    let name = provenance::sha256(out.as_os_str().as_encoded_bytes());
    let rooms = checkout.scratch().join("grading").join(&name[..16]);
    let _absent = fs::remove_dir_all(&rooms);
    rooms
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
