//! What was measured before this instrument was built (`NOTES.md` of this package), and
//! what was promised of it, beside what came. A figure agrees if it is within a
//! factor of what random questions and another machine explain; 0 agrees with 0 only.

mod before;
mod crossovers;
mod meshes;
mod plans;
mod scenes;
mod sweeps;
mod times;

use crate::judge::rule_of_three;
use crate::result::Target;
use crate::run::Findings;

/// Every figure that the run allows to compare.
pub fn targets(findings: &Findings) -> Vec<Target> {
    let mut targets = sweeps::targets(findings);
    targets.extend(meshes::targets(&findings.meshes));
    targets.extend(times::targets(&findings.speed));
    targets.extend(scenes::targets(&findings.scenes));
    targets.extend(plans::targets(&findings.plans));
    targets.extend(crossovers::targets(&findings.crossovers));
    targets
}

/// Shares and errors may differ by this factor: the questions are others, and how exactly
/// the older ones were aimed was not written down.
const OF_SHARES: f64 = 4.0;

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

/// A good plain kernel for each shape.
const PLAIN: [&str; 3] = ["Haines et al.", "shifted origin", "Möller–Trumbore"];

/// A share, as targets show it.
fn percent(share: f64) -> String {
    format!("{:.3} %", share * 100.0)
}

/// So many wrong answers of all, as targets show them.
fn counted(wrong: u64, asked: u64) -> String {
    match wrong {
        0 => format!(
            "0 of {asked} (below {:.1e} with 95 % confidence)",
            rule_of_three(asked)
        ),
        _ => format!("{wrong} of {asked}"),
    }
}
