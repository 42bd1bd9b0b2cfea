//! `pinhole grade`: a class of submissions, each on its own.

use std::collections::BTreeMap;
use std::fs;
use std::io::IsTerminal;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

use serde_json::json;

use super::Outcome;
use crate::assignment::Assignment;
use crate::checkout::Checkout;
use crate::cli::Grade;
use crate::compile::Compiler;
use crate::describe::printable;
use crate::error::Result;
use crate::goldens::Goldens;
use crate::grade::alike::Known;
use crate::grade::bench::{Bench, Graded};
use crate::grade::changes::{self, Change};
use crate::grade::class::{Class, Roll};
use crate::grade::clock::Pace;
use crate::grade::formats::Format;
use crate::grade::intake::{self, Entry};
use crate::grade::provenance::{self, MadeWith, Provenance, Tool};
use crate::grade::record::Record;
use crate::grade::store::{Store, pretty};
use crate::grade::withheld::Withheld;
use crate::grade::{csv, fresh, page, roster};
use crate::manifest::Manifest;
use crate::progress::Progress;
use crate::sandbox::Sandbox;
use crate::submission::Unusable;

/// The file that merges read.
pub const ROLL: &str = "roll.json";

pub fn run(checkout: &Checkout, arguments: &Grade) -> Result<Outcome> {
    let assignment = Assignment::around(checkout, &std::env::current_dir().unwrap_or_default())?;
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
        scenes: arguments.golden.is_some(),
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
        judged_on: judged_on(
            arguments.golden.is_some(),
            made.as_ref().map(|(_, seed)| *seed),
        ),
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
             cargo run --release -- golden setup",
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
        of_fresh: arguments.reveal,
        compiler: &compiler,
        sandbox: &sandbox,
        pace: &pace,
        rooms: &rooms,
        made_with: &made_with,
    };
    store.write(ROLL, &pretty(&roll)?)?;
    let mine = intake::shard(roll.entries.clone(), arguments.shard);
    let start = Instant::now();
    let desk = Desk {
        bench: &bench,
        store: &store,
        regrade: arguments.regrade,
        of: mine.len(),
        done: AtomicUsize::new(0),
        progress: &progress,
    };
    let worked = desk.work(&mine, jobs(arguments));
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
    finish(
        &store,
        &roll,
        &records,
        &assignment,
        &arguments.format,
        told,
        arguments.json,
    )
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

fn judged_on(own: bool, seed: Option<u64>) -> String {
    let goldens = if own {
        "the instructor's goldens"
    } else {
        "public goldens"
    };
    match seed {
        Some(seed) => format!("{goldens} and fresh questions (seed {seed})"),
        None => format!("{goldens} only"),
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

/// Where entries are worked off, several at a time.
struct Desk<'a> {
    bench: &'a Bench<'a>,
    store: &'a Store,
    regrade: bool,
    of: usize,
    done: AtomicUsize,
    progress: &'a Progress,
}

/// What came of one.
struct Done {
    record: Record,
    anew: bool,
    change: Option<Change>,
    /// Whose grading failed now, and why.
    fault: Option<(String, String)>,
}

fn locked<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

impl Desk<'_> {
    fn work(&self, entries: &[Entry], jobs: usize) -> Vec<Done> {
        let next = AtomicUsize::new(0);
        let all = Mutex::new(Vec::new());
        let late = Mutex::new(Vec::new());
        std::thread::scope(|scope| {
            for _ in 0..jobs.clamp(1, entries.len().max(1)) {
                scope.spawn(|| {
                    while let Some(entry) = entries.get(next.fetch_add(1, Ordering::Relaxed)) {
                        match self.one(entry, false) {
                            Some(done) => locked(&all).push(done),
                            None => locked(&late).push(entry),
                        }
                    }
                });
            }
        });
        let mut all = all.into_inner().unwrap_or_else(PoisonError::into_inner);
        let late = late.into_inner().unwrap_or_else(PoisonError::into_inner);
        for entry in &late {
            let name = printable(&entry.id);
            self.progress
                .say(&format!("{name} again, alone: an answer came too late"));
            all.extend(self.one(entry, true));
        }
        all
    }

    /// `None` if it is to be graded again, `alone`.
    fn one(&self, entry: &Entry, alone: bool) -> Option<Done> {
        let done = self.grade(entry, alone)?;
        self.tell(&done);
        Some(done)
    }

    fn grade(&self, entry: &Entry, alone: bool) -> Option<Done> {
        let Bench {
            assignment,
            made_with,
            ..
        } = self.bench;
        let before = self.store.record(&entry.id);
        let submission = match intake::open(entry, assignment) {
            Ok(submission) => submission,
            Err(error) => {
                let missing = Unusable::Missing;
                let nothing = intake::without_answers(entry, assignment, &missing);
                let record = self.bench.blank(entry, &nothing);
                return Some(self.faulty(record.not_graded(error.to_string()), None));
            }
        };
        if let Some(before) = &before
            && !self.regrade
            && before.provenance == Provenance::of(&submission, made_with)
            && before.name == entry.name
        {
            return Some(Done {
                record: before.clone(),
                anew: false,
                change: None,
                fault: None,
            });
        }
        let Graded { record, report } = self.bench.grade(entry, &submission, alone)?;
        let Some(report) = report else {
            return Some(self.faulty(record, before));
        };
        if let Err(error) = self.store.keep(&record, &report) {
            return Some(self.faulty(record.not_graded(error.to_string()), before));
        }
        let change = before.and_then(|before| Change::between(&before, &record));
        Some(Done {
            record,
            anew: true,
            change,
            fault: None,
        })
    }

    /// A fault of ours: told, and kept beside the grade from `before` if there is one,
    /// which stands if it is of the same answers, judged by the same.
    fn faulty(&self, mut record: Record, before: Option<Record>) -> Done {
        if let Err(error) = self.store.keep_fault(&record) {
            record.explanation.push_str(&format!("; {}", error.problem));
        }
        let fault = Some((record.id.clone(), record.explanation.clone()));
        let stands = before.filter(|before| before.provenance == record.provenance);
        Done {
            anew: stands.is_none(),
            record: stands.unwrap_or(record),
            change: None,
            fault,
        }
    }

    fn tell(&self, done: &Done) {
        let count = self.done.fetch_add(1, Ordering::Relaxed) + 1;
        let Record {
            id,
            points,
            possible,
            outcome,
            ..
        } = &done.record;
        let id = printable(id);
        self.progress
            .show(&id, count as f64 / self.of.max(1) as f64);
        if !std::io::stderr().is_terminal() && done.anew {
            let points =
                points.map_or("no mark".into(), |points| format!("{points} of {possible}"));
            anstream::eprintln!("[{count}/{}] {id}: {points}, {}", self.of, outcome.word());
        }
    }
}

/// What is said of this run alone.
#[derive(Default)]
pub struct Told {
    pub anew: usize,
    pub seconds: f64,
    pub changes: Vec<Change>,
    /// Whose grading failed, and why; an earlier grade of the same may stand.
    pub faults: Vec<(String, String)>,
}

/// Writes what is said of the class, and says it.
pub fn finish(
    store: &Store,
    roll: &Roll,
    records: &BTreeMap<String, Record>,
    assignment: &Assignment,
    formats: &[Format],
    told: Told,
    as_json: bool,
) -> Result<Outcome> {
    let class = Class::new(&assignment.title, roll, records, &Known::read(assignment)?);
    for record in records.values() {
        for format in formats {
            if let Some((name, content)) = format.of(record)? {
                store.write(&format!("submissions/{}/{name}", record.id), &content)?;
            }
        }
    }
    if formats.contains(&Format::Csv) {
        store.write("groups.csv", &csv::groups(&class))?;
    }
    store.write("grades.csv", &csv::grades(&class, assignment))?;
    store.write("class.html", &page::html(&class, assignment))?;
    let not_graded = class.not_graded();
    match as_json {
        true => anstream::println!("{:#}", document(&class, &told)),
        false => anstream::print!("{}", words(&class, &told, store)),
    }
    if not_graded.is_empty() && told.faults.is_empty() {
        return Ok(Outcome::Well);
    }
    anstream::eprintln!(
        "pinhole: {} of {} submissions have no mark, and grading failed for {}\n  remedy: see \
         why above; run the same command again, and it grades these alone",
        not_graded.len(),
        class.rows.len(),
        told.faults.len()
    );
    Ok(Outcome::Incomplete)
}

fn document(class: &Class, told: &Told) -> serde_json::Value {
    let outcomes = class.outcomes().into_iter();
    let outcomes: BTreeMap<&str, Vec<&str>> =
        outcomes.map(|(kind, who)| (kind.word(), who)).collect();
    let points = class.rows.iter().map(|row| {
        let points = row.record.and_then(|record| record.points);
        (row.entry.id.as_str(), points)
    });
    json!({
        "assignment": class.title,
        "submissions": class.rows.len(),
        "not_graded": class.not_graded(),
        "graded_now": told.anew,
        "seconds": told.seconds,
        "points": points.collect::<BTreeMap<_, _>>(),
        "outcomes": outcomes,
        "mistakes": class.mistakes(),
        "alike": class.alike,
        "changes": told.changes,
        "faults": told.faults,
        "roster": class.roll.placed,
        "ignored": class.roll.ignored,
    })
}

fn words(class: &Class, told: &Told, store: &Store) -> String {
    let mut text = String::new();
    let mut line = |words: String| {
        text.push_str(&words);
        text.push('\n');
    };
    for (id, why) in class.not_graded() {
        line(format!("not graded: {}: {}", printable(id), printable(why)));
    }
    let stands = |id: &String| !class.not_graded().iter().any(|(other, _)| other == id);
    for (id, why) in told.faults.iter().filter(|(id, _)| stands(id)) {
        line(format!(
            "not graded again, the old mark stands: {}: {}",
            printable(id),
            printable(why)
        ));
    }
    for change in &told.changes {
        line(format!("changed: {}", printable(&change.in_words())));
    }
    let all = class.rows.len();
    let kept = all.saturating_sub(told.anew);
    let minutes = told.seconds / 60.0;
    line(format!(
        "{all} submissions, {} graded now in {:.0} s ({:.0} a minute), {kept} unchanged",
        told.anew,
        told.seconds,
        told.anew as f64 / minutes.max(1e-9)
    ));
    for (kind, who) in class.outcomes() {
        line(format!("{:>5} {}", who.len(), kind.word()));
    }
    let placed = &class.roll.placed;
    let lists = [
        ("nothing handed in", placed.missing.len()),
        ("on no roster", placed.unknown.len()),
        ("could be several people's", placed.ambiguous.len()),
        ("earlier attempts, not graded", placed.superseded.len()),
        ("people with several submissions", placed.several.len()),
        ("answers the same as others", class.alike.len()),
    ];
    for (what, count) in lists.into_iter().filter(|(_, count)| *count > 0) {
        line(format!("{count:>5} {what}"));
    }
    line(format!("\ngrades: {}", store.path("grades.csv").display()));
    line(format!("class:  {}", store.path("class.html").display()));
    text
}
