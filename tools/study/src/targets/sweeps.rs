//! How often and how far kernels are off, in the families' sweeps.

use super::before::{HITS_LOST, MEDIAN_ULP, SPHERE_WRONG, WRONG};
use super::{OF_SHARES, PLAIN, agree, counted, percent};
use crate::result::{Judged, Target};
use crate::run::Findings;

/// A shape, one of its families, and the exponent.
pub type Place = (&'static str, &'static str, i32);

/// A kernel, and the numbers it computes with.
pub type Kernel = (&'static str, &'static str);

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
    targets
}

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
