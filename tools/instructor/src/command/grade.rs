//! `pinhole grade`: grades a class of submissions.

mod questions;

use std::collections::BTreeMap;
use std::fs;
use std::path::PathBuf;
use std::time::{Duration, Instant};

use self::questions::{Folders, Questions, secrets};
use crate::cli::Grade;
use crate::grade::cache::{ResultCache, pretty};
use crate::grade::class::{ROLL, Roll, change, replace, roll};
use crate::grade::grader::Grader;
use crate::grade::grader::clock::Pace;
use crate::grade::intake::placement::Placement;
use crate::grade::intake::{self, Entry, roster};
use crate::grade::policy::Policy;
use crate::grade::provenance;
use crate::grade::queue::{GradeQueue, QueueResult};
use crate::grade::stored::StoredResults;
use crate::grade::views::preview;
use crate::grade::views::progress::GradingProgress;
use crate::grade::views::summary::{ClassOutput, RunSummary};
use pinhole_course::assignment::Assignment;
use pinhole_course::checkout::Checkout;
use pinhole_course::compile::Compiler;
use pinhole_course::error::{Error, Result, ResultExt};
use pinhole_course::private::make_private;
use pinhole_course::progress::Progress;
use pinhole_course::sandbox::Sandbox;
use pinhole_course::timings::Timings;
use pinhole_report::program::Status;

pub fn run(checkout: &Checkout, arguments: &Grade) -> Result<Status> {
    let assignment = arguments.assignment.find(checkout, None)?;
    let roll = roll(arguments, &assignment)?;
    let Some(out) = arguments.out.as_ref().filter(|_| !arguments.dry_run) else {
        return preview::print(&roll, &assignment, arguments.json);
    };
    let folders = Folders::of(arguments)?;
    let goldens = folders.goldens(&assignment)?;
    replace::refuse_inside(&arguments.paths, out)?;
    let cache = ResultCache::open(out)?;
    let (new, roll) = with_class(roll, arguments, &cache)?;
    folders.refuse_exposed()?;
    // Submissions are never trusted, even in the checkout.
    let sandbox = Sandbox::for_untrusted(
        "submissions",
        checkout,
        arguments.sandbox_choice(),
        &secrets(arguments, &goldens, &folders, out),
    )?;
    let questions =
        Questions::find_or_make(goldens, &folders, arguments, &cache, &assignment, checkout)?;
    let made_with = questions.grading_inputs(arguments, &assignment, checkout, &sandbox)?;
    if questions.fresh.is_none() {
        anstream::eprintln!(
            "no fresh questions are asked, so an answer could pass by memorising the goldens; to \
             ask fresh ones, install Mitsuba (cargo pinhole golden setup) and leave out --no-fresh"
        );
    }
    cache.write(ROLL, &pretty(&roll)?)?;
    let start = Instant::now();
    let mine = intake::shard(new, arguments.shard);
    let stored = StoredResults {
        cache: &cache,
        made_with: &made_with,
        assignment: &assignment,
    };
    let (mut worked, to_grade) = match arguments.regrade {
        true => (Vec::new(), mine.clone()),
        false => stored.valid(&mine)?,
    };
    let roll = match arguments.shard {
        None => {
            worked.extend(stored.of_others(&roll, &mine)?);
            roll
        }
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
        let progress = Progress::new();
        progress.say("building");
        let compiler = Compiler::new(&assignment, checkout, &sandbox)?;
        let programs = programs(&sandbox, checkout, &cache)?;
        progress.say("asking the reference");
        let least = Duration::from_secs(arguments.timeout);
        let pace = Pace::measure(&assignment, &questions.all(), checkout, least)?;
        let grader = Grader {
            assignment: &assignment,
            checkout,
            goldens: &questions.goldens,
            fresh: questions.fresh.as_ref(),
            withheld: questions.withheld,
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
        progress.clear();
    }
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
    change::sort(&mut changes);
    let run = RunSummary {
        graded,
        seconds: start.elapsed().as_secs_f64(),
        changes,
        is_regrade: arguments.regrade,
        faults,
    };
    output.write(&roll, &records, &run)
}

/// The submissions that were passed, and the class that they belong to. Single submissions are
/// added to the class that was graded into the same folder before.
fn with_class(
    mut roll: Roll,
    arguments: &Grade,
    cache: &ResultCache,
) -> Result<(Vec<Entry>, Roll)> {
    let earlier = cache.path(ROLL);
    if roll.passed.is_empty() && arguments.shard.is_none() && earlier.exists() {
        let class = Roll::read(&earlier)?;
        roll.take_ids_of(&class);
        replace::refuse_chosen_names(&roll, &class)?;
        replace::refuse_other_rules(&roll, &class, true)?;
        return Ok((roll.entries.clone(), roll.into_class(class)));
    }
    let one = "to add or replace submissions, pass the path of each, not of the folder around them, \
               and leave out --shard";
    replace::refuse_partial_class(&roll, &earlier, one)?;
    // A class of another version is graded again.
    if let Ok(class) = Roll::read(&earlier) {
        roll.remember_times(&class);
        roll.remember_alone(&class);
        roll.doubt_earlier_answers();
    }
    roll.note_times();
    Ok((roll.entries.clone(), roll))
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

/// The submissions, and the people who handed them in.
fn roll(arguments: &Grade, assignment: &Assignment) -> Result<Roll> {
    let policy = arguments.policy.as_ref();
    let policy = policy
        .map(|path| Policy::read(path, assignment))
        .transpose()?;
    let roster = arguments.roster.as_ref();
    let mut people = roster.map(|path| roster::read(path)).transpose()?;
    if let (Some(policy), Some(people)) = (&policy, &mut people) {
        roll::know_groups(policy, people);
    }
    let named = arguments.named.clone();
    // Names mean the same as when the class was graded into this folder.
    let earlier = arguments
        .out
        .as_ref()
        .map(|out| Roll::read(&out.join(ROLL)));
    let earlier = earlier.and_then(Result::ok).unwrap_or_default();
    let intake = intake::find(
        &arguments.paths,
        assignment,
        people.as_deref().or(earlier.people.as_deref()),
        named.as_ref().or(earlier.named.as_ref()),
    )?;
    let mut roll = Roll {
        assignment: assignment.name.clone(),
        entries: intake.entries,
        people,
        named,
        placed: Placement {
            superseded: intake.superseded,
            ..Placement::default()
        },
        ignored: intake.ignored,
        passed: intake.passed,
        policy,
        timed: Vec::new(),
        alone: BTreeMap::new(),
    };
    roll.place();
    Ok(roll)
}
