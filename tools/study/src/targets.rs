//! What was measured before this instrument was built (the project's field notes, section
//! 5), and what was promised of it, beside what came. A figure agrees if it is within a
//! factor of what random questions and another machine explain; 0 agrees with 0 only.

mod before;
mod crossovers;
mod meshes;
mod plans;
mod scenes;
mod times;

use before::{HITS_LOST, MEDIAN_ULP, SPHERE_WRONG, WRONG};

use crate::judge::rule_of_three;
use crate::result::{Judged, Target};
use crate::run::Findings;

/// Shares and errors may differ by this factor: the questions are others, and how exactly
/// the older ones were aimed was not written down.
const OF_SHARES: f64 = 4.0;

/// Every figure that the run allows to compare.
pub fn targets(findings: &Findings) -> Vec<Target> {
    let mut targets = Vec::new();
    for (kernel, shares) in SPHERE_WRONG {
        for (exponent, share) in [6, 7, 8].into_iter().zip(shares) {
            let place = ("sphere", "distance", exponent);
            targets.extend(wrong(findings, place, (kernel, "f64"), share));
        }
    }
    for (place, kernel, share) in WRONG {
        targets.extend(wrong(findings, place, kernel, share));
    }
    for (place, kernel, share) in HITS_LOST {
        targets.extend(hits_lost(findings, place, kernel, share));
    }
    for (place, kernel, ulp) in MEDIAN_ULP {
        targets.extend(median(findings, place, kernel, ulp));
    }
    targets.extend(never_wrong(findings, "distance", "Haines et al.", "f64"));
    targets.extend(never_wrong(findings, "direction", "Haines scaled", "f64"));
    for numbers in ["f64", "f32", "f64 on f32"] {
        targets.extend(never_wrong(findings, "", "adaptive exact", numbers));
    }
    targets.extend(f64_on_f32(findings));
    targets.extend(meshes::targets(&findings.meshes));
    targets.extend(times::targets(&findings.speed));
    targets.extend(scenes::targets(&findings.scenes));
    targets.extend(plans::targets(&findings.plans));
    targets.extend(crossovers::targets(&findings.crossovers));
    targets
}

/// A shape, one of its families, and the exponent.
type Place = (&'static str, &'static str, i32);

/// A kernel, and the numbers it computes with.
type Kernel = (&'static str, &'static str);

fn judged(
    findings: &Findings,
    (shape, family, exponent): Place,
    (kernel, numbers): Kernel,
) -> Option<&Judged> {
    let mut sweeps = findings.families.iter();
    let data = if numbers == "f64" { "f64" } else { "f32" };
    let sweep = sweeps.find(|s| s.shape == shape && s.family == family && s.data == data)?;
    let point = sweep
        .points
        .iter()
        .find(|point| point.exponent == exponent)?;
    point
        .kernels
        .iter()
        .find(|k| k.kernel == kernel && k.numbers == numbers)
}

fn percent(share: f64) -> String {
    format!("{:.3} %", share * 100.0)
}

/// Whether two shares agree, the second counted among `asked`: within the factor, or
/// within what chance does to such a count (two standard deviations, Poisson's).
fn agree(expected: f64, counted: u64, asked: u64) -> bool {
    let expected = expected * asked as f64;
    if expected == 0.0 || counted == 0 {
        return expected == counted as f64
            || counted == 0 && (0.0..3.0 * OF_SHARES).contains(&expected);
    }
    let chance = 2.0 * (counted as f64).sqrt();
    let (low, high) = (counted as f64 - chance, counted as f64 + chance);
    low <= expected * OF_SHARES && high >= expected / OF_SHARES
}

fn wrong(findings: &Findings, place: Place, kernel: Kernel, share: f64) -> Option<Target> {
    let tally = &judged(findings, place, kernel)?.tally;
    Some(Target {
        about: format!(
            "{} {}: wrong at {} 10^{}, {}",
            place.0, kernel.0, place.1, place.2, kernel.1
        ),
        expected: percent(share),
        measured: percent(tally.wrong_share()),
        met: agree(share, tally.wrong(), tally.asked),
        is_time: false,
    })
}

/// Of the true hits alone, which is what the older figures count.
fn hits_lost(findings: &Findings, place: Place, kernel: Kernel, share: f64) -> Option<Target> {
    let tally = &judged(findings, place, kernel)?.tally;
    Some(Target {
        about: format!(
            "{} {}: hits lost at {} 10^−{}, {}",
            place.0, kernel.0, place.1, place.2, kernel.1
        ),
        expected: percent(share),
        measured: percent(tally.false_misses as f64 / tally.hits.max(1) as f64),
        met: agree(share, tally.false_misses, tally.hits),
        is_time: false,
    })
}

fn median(findings: &Findings, place: Place, kernel: Kernel, ulp: f64) -> Option<Target> {
    let measured = judged(findings, place, kernel)?.tally.median_ulp?;
    Some(Target {
        about: format!(
            "{} {}: median error at {} 10^{}, {}",
            place.0, kernel.0, place.1, place.2, kernel.1
        ),
        expected: format!("{ulp:.2} ulp"),
        measured: format!("{measured:.2} ulp"),
        met: (1.0 / OF_SHARES..=OF_SHARES).contains(&(measured / ulp)),
        is_time: false,
    })
}

fn never_wrong(findings: &Findings, family: &str, kernel: &str, numbers: &str) -> Option<Target> {
    let swept = findings.breaking.iter().filter(|b| {
        (family.is_empty() || b.family == family && b.shape == "sphere")
            && b.kernel == kernel
            && b.numbers == numbers
    });
    let (wrong, asked) = swept.fold((0, 0), |sum, b| (sum.0 + b.wrong, sum.1 + b.asked));
    let family = if family.is_empty() {
        "every family"
    } else {
        family
    };
    (asked > 0).then(|| Target {
        about: format!("{kernel}: wrong in {family}, {numbers}"),
        expected: "0".into(),
        measured: counted(wrong, asked),
        met: wrong == 0,
        is_time: false,
    })
}

/// A good plain kernel for each shape.
const PLAIN: [&str; 3] = ["Haines et al.", "shifted origin", "Möller–Trumbore"];

fn f64_on_f32(findings: &Findings) -> Option<Target> {
    let of = |numbers: &str| {
        let is_it = |kernel: &str| PLAIN.contains(&kernel);
        let swept = findings
            .breaking
            .iter()
            .filter(|b| b.numbers == numbers && is_it(&b.kernel));
        swept.fold((0, 0), |sum, b| (sum.0 + b.wrong, sum.1 + b.asked))
    };
    let ((wrong, asked), (narrow, _)) = (of("f64 on f32"), of("f32"));
    (asked > 0).then(|| Target {
        about: format!(
            "{} in f64 on f32 data: wrong in every family ({narrow} in f32)",
            PLAIN.join(", ")
        ),
        expected: "0".into(),
        measured: counted(wrong, asked),
        met: wrong == 0,
        is_time: false,
    })
}

fn counted(wrong: u64, asked: u64) -> String {
    match wrong {
        0 => format!(
            "0 of {asked} (below {:.1e} with 95 % confidence)",
            rule_of_three(asked)
        ),
        _ => format!("{wrong} of {asked}"),
    }
}
