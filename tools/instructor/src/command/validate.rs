//! `pinhole validate`: tests the grading.

use crate::cli::Validate;
use crate::validate::validator::Validator;
use crate::validate::{Part, Plan, table, validate};
use pinhole_course::checkout::Checkout;
use pinhole_course::compile::Compiler;
use pinhole_course::error::{Error, Result, ResultExt};
use pinhole_course::goldens::Goldens;
use pinhole_course::progress::Progress;
use pinhole_course::sandbox::{Choice, Sandbox};
use pinhole_course::second_judge::SecondJudge;
use pinhole_report::program::Status;

pub fn run(checkout: &Checkout, arguments: &Validate) -> Result<Status> {
    let assignment = arguments
        .assignment
        .or(arguments.positional.as_deref(), checkout)?;
    let goldens = Goldens::read(&assignment.golden(), &assignment)?;
    let fresh = arguments.fresh.as_deref();
    let fresh = fresh
        .map(|folder| Goldens::read(folder, &assignment))
        .transpose()?;
    let folder = assignment.folder.canonicalize().unwrap_or_default();
    let sandbox = Sandbox::around(&folder, checkout, Choice::Auto, &[])?;
    let second_judge = arguments
        .oiiotool
        .then(|| SecondJudge::find(checkout))
        .transpose()?;
    let progress = Progress::new();
    progress.say("building");
    let pool = rayon::ThreadPoolBuilder::new()
        .num_threads(arguments.jobs.map_or(0, usize::from))
        .build()
        .or_environment(
            "cannot start that many threads",
            "ask for fewer jobs with --jobs",
        )?;
    let validator = Validator {
        assignment: &assignment,
        goldens: &goldens,
        fresh: fresh.as_ref(),
        compiler: &Compiler::new(&assignment, checkout, &sandbox)?,
        sandbox: &sandbox,
        second_judge: second_judge.as_ref(),
        pool: &pool,
        progress: &progress,
    };
    let validation = validate(&validator, &plan(arguments))?;
    progress.clear();
    if let Some(named) = arguments.named.as_ref().filter(|_| validation.is_empty()) {
        return Err(Error::input(
            format!("nothing to judge has {named:?} in its name"),
            "pass part of a name that the tables list, such as `mistakes/` or `bunny`",
        ));
    }

    if arguments.json {
        let document = serde_json::to_string_pretty(&validation)
            .or_environment("cannot write the result as JSON", "report this")?;
        anstream::println!("{document}");
    } else {
        anstream::print!("{}", table(&validation));
    }
    Ok(match validation.faults.is_empty() {
        true => Status::Well,
        false => Status::JudgedWrong,
    })
}

fn plan(arguments: &Validate) -> Plan {
    let mut parts = match (arguments.only.is_empty(), &arguments.draws) {
        (true, Some(_)) => Vec::new(),
        (true, None) => vec![
            Part::Mistakes,
            Part::Variants,
            Part::Pairs,
            Part::Sensitivity,
        ],
        (false, _) => arguments.only.clone(),
    };
    parts.extend(arguments.mutants.then_some(Part::Mutants));
    Plan {
        parts,
        draws: arguments.draws.clone(),
        all_pairs: arguments.pairs,
        named: arguments.named.clone().unwrap_or_default(),
    }
}
