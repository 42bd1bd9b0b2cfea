//! `pinhole merge`: combines the shards of a class, wherever they were graded.

use std::collections::BTreeMap;

use crate::cli::Merge;
use crate::grade::cache::{Backlog, ResultCache, link, pretty, standing, write_unflushed};
use crate::grade::class::{ROLL, Roll};
use crate::grade::evidence::Evidence;
use crate::grade::policy::Policy;
use crate::grade::provenance::GradingInputs;
use crate::grade::record::Record;
use crate::grade::views::summary::{ClassOutput, RunSummary};
use pinhole_course::checkout::Checkout;
use pinhole_course::error::{Error, Result};
use pinhole_report::program::Status;

pub fn run(checkout: &Checkout, arguments: &Merge) -> Result<Status> {
    let assignment = arguments.assignment.find(checkout, None)?;
    let mut roll = common_roll(arguments)?;
    if let Some(path) = &arguments.policy {
        roll.policy = Some(Policy::read(path)?);
        roll.find_groups();
    }
    let cache = ResultCache::open(&arguments.out)?;
    let mut records: BTreeMap<String, Record> = BTreeMap::new();
    let mut with: Option<GradingInputs> = None;
    let shards = arguments.shards.iter();
    let shards = shards.map(|shard| Ok((shard, Backlog::read(shard)?)));
    let shards: Vec<_> = shards.collect::<Result<_>>()?;
    for entry in &roll.entries {
        for (shard, backlog) in &shards {
            let from = shard.join("submissions").join(&entry.id);
            let Some(record) = standing(&from) else {
                continue;
            };
            let record = backlog.check(record);
            if !record.is_graded() {
                // Keep the reason, unless another shard has a grade.
                records.entry(entry.id.clone()).or_insert(record);
                continue;
            }
            let made_with = &record.provenance.made_with;
            let with = with.get_or_insert_with(|| made_with.clone());
            // Each machine may have built the program itself, so the hash of the program may
            // differ.
            if with.goldens != made_with.goldens
                || with.fresh != made_with.fresh
                || with.assignment != made_with.assignment
            {
                return Err(Error::input(
                    format!("{} was judged by other goldens", shard.display()),
                    "grade all shards with the same --golden, --fresh or --seed",
                ));
            }
            let report = from.join("report.html");
            if !report.is_file() {
                return Err(Error::input(
                    format!("there is no report in {}", from.display()),
                    "grade that shard again",
                ));
            }
            let evidence = Evidence::file(&entry.id);
            if shard.join(&evidence).is_file() {
                link(&shard.join(&evidence), &cache.path(&evidence))?;
            }
            let to = cache.of(&entry.id);
            link(&report, &to.join("report.html"))?;
            write_unflushed(&to.join("result.json"), pretty(&record)?.as_bytes())?;
            records.insert(entry.id.clone(), record);
            break;
        }
    }
    cache.write(ROLL, &pretty(&roll)?)?;
    let output = ClassOutput {
        cache: &cache,
        assignment: &assignment,
        formats: &arguments.format,
        as_json: arguments.json,
    };
    output.write(&roll, &records, &RunSummary::default())
}

/// The roll of the class, on which all shards must agree.
fn common_roll(arguments: &Merge) -> Result<Roll> {
    let mut common: Option<Roll> = None;
    for shard in &arguments.shards {
        let path = shard.join(ROLL);
        if !path.exists() && arguments.shards.len() > 1 {
            anstream::eprintln!(
                "{} has not started: its people are listed as not graded",
                shard.display()
            );
            continue;
        }
        let roll = Roll::read(&path)?;
        match &common {
            Some(common) if *common != roll => {
                return Err(Error::input(
                    format!("{} is a shard of another class", shard.display()),
                    "grade all shards with the same paths and the same roster",
                ));
            }
            _ => common = Some(roll),
        }
    }
    common.ok_or_else(|| Error::input("no part has started", "name the parts' folders"))
}
