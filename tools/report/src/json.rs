//! Results as JSON documents for scripts. Field names are the words of the tables.

use pinhole::judge::{Refusal, Verdict};
use serde_json::{Value, json};

use pinhole_course::compile::Replaced;
use pinhole_course::diagnosis::{Diagnosis, Explanation, Reading};
use pinhole_course::examination::{Examination, Outcome};
use pinhole_course::submission::Unusable;
use pinhole_course::submission::flags::Flag;

/// An examination, as `check --json` prints it.
pub fn examination(examination: &Examination) -> Value {
    let (points, possible) = examination.points();
    let tasks = examination.tasks.iter().map(|task| {
        let (points, possible) = task.points();
        let groups = task.groups.iter().map(|group| {
            json!({
                "name": group.name,
                "points": if group.outcome.passes() { group.worth } else { 0 },
                "possible": group.worth,
                "outcome": outcome(&group.outcome),
                "worst": group.worst,
            })
        });
        json!({
            "name": task.name,
            "chapter": task.chapter,
            "points": points,
            "possible": possible,
            "file": file_state(task.replaced.as_ref()),
            "groups": groups.collect::<Vec<_>>(),
            "diagnosis": diagnosis(&task.diagnosis),
        })
    });
    let scenes = examination.scenes.iter().map(|scene| {
        json!({
            "name": scene.name,
            "points": if scene.outcome.passes() { scene.worth } else { 0 },
            "possible": scene.worth,
            "outcome": outcome(&scene.outcome),
            "seconds": scene.seconds,
            "diagnosis": diagnosis(&scene.diagnosis),
        })
    });
    json!({
        "assignment": examination.title,
        "submission": examination.submission,
        "passes": examination.passes(),
        "points": points,
        "possible": possible,
        "withheld": examination.withheld,
        "tasks": tasks.collect::<Vec<_>>(),
        "scenes": scenes.collect::<Vec<_>>(),
        "printed": examination.printed,
    })
}

/// What an instructor may want to look at.
pub fn flags(flags: &[Flag]) -> Value {
    let shown = flags
        .iter()
        .map(|flag| json!({ "task": flag.task, "line": flag.line, "what": flag.what }));
    shown.collect()
}

/// A diagnosis; `null` if nothing known explains what came.
pub fn diagnosis(diagnosis: &Diagnosis) -> Value {
    if diagnosis.is_empty() {
        return Value::Null;
    }
    let beliefs = diagnosis.beliefs.iter().map(|explanation| {
        let Explanation {
            slug,
            mistake,
            explained,
        } = explanation;
        json!({
            "mistake": slug,
            "belief": mistake.belief,
            "explained": explained,
            "chapter": mistake.chapter,
            "hint": mistake.hint,
        })
    });
    json!({
        "reading": match diagnosis.reading {
            Reading::Together => "together",
            Reading::OneOf => "one of",
        },
        "beliefs": beliefs.collect::<Vec<_>>(),
    })
}

fn file_state(replaced: Option<&Replaced>) -> Value {
    match replaced {
        None => json!({ "state": "compiled" }),
        Some(Replaced::Unusable(Unusable::Missing)) => json!({ "state": "missing" }),
        Some(Replaced::Unusable(Unusable::Refused(why))) => {
            json!({ "state": "refused", "why": why })
        }
        Some(Replaced::DoesNotCompile(text)) => {
            json!({ "state": "does not compile", "compiler": anstream::adapter::strip_str(text).to_string() })
        }
    }
}

fn outcome(outcome: &Outcome) -> Value {
    match outcome {
        Outcome::Judged(verdict) => self::verdict(&Ok(verdict.clone())),
        Outcome::Refused(refusal) => self::verdict(&Err(refusal.clone())),
        Outcome::Unanswered => json!({ "kind": "unanswered" }),
        Outcome::BlockedBy(task) => json!({ "kind": "blocked", "by": task }),
        Outcome::Panicked(panic) => json!({
            "kind": "panicked", "message": panic.message, "file": panic.file, "line": panic.line,
        }),
        Outcome::TimedOut { seconds } => json!({ "kind": "timed out", "seconds": seconds }),
        Outcome::OutOfMemory { most } => json!({ "kind": "out of memory", "most": most }),
        Outcome::Died(how) => json!({ "kind": "died", "how": how }),
        Outcome::Garbled(why) => json!({ "kind": "garbled", "why": why }),
    }
}

/// A verdict or refusal, as `diff --json` prints it.
pub fn verdict(verdict: &Result<Verdict, Refusal>) -> Value {
    let verdict = match verdict {
        Ok(verdict) => verdict,
        Err(refusal) => return json!({ "kind": "refused", "why": refusal.to_string() }),
    };
    let channels = verdict.channels.iter().map(|channel| {
        json!({
            "name": channel.name,
            "failing": channel.failing,
            "own": channel.own,
            "worst": channel.worst.map(|worst| json!({
                "pixel": [worst.pixel.i, worst.pixel.j],
                "got": worst.got,
                "expected": worst.expected,
                "allowed": worst.allowed,
            })),
            "bounds": channel.bounds.map(|bounds| json!({
                "min": [bounds.min.i, bounds.min.j],
                "max": [bounds.max.i, bounds.max.j],
            })),
        })
    });
    json!({
        "kind": "judged",
        "passes": verdict.passes(),
        "pixels": verdict.resolution.pixels(),
        "failing": verdict.failing.len(),
        "exempt": verdict.exempt,
        "channels": channels.collect::<Vec<_>>(),
    })
}
