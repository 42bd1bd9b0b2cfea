use std::fmt::Write;

use crate::result::{PlanTally, Study};

/// Plans and what makes one way cheaper, as sections of the page.
pub fn section(text: &mut String, study: &Study) {
    if !study.plans.is_empty() {
        plans(text, &study.plans);
    }
    if !study.crossovers.is_empty() {
        crossovers(text, study);
    }
}

fn plans(text: &mut String, plans: &[PlanTally]) {
    let _ = write!(
        text,
        "## The cheapest that is accurate enough\n\n\
         `pinhole plan SCENE --accuracy X` chooses, for each kind of shape, the cheapest numbers \
         that keep every t to X of itself and every normal to X radians. *Watched* kinds tell of \
         each hit how far rounding may have moved it; what exceeds X is cast again, in `f64` or \
         exactly. *Beyond X* counts pixels that break the promise, of all that were judged; \
         *wrong* counts pixels with another object, which only *exact ids* excludes. The last \
         columns compare the time with that of the most accurate way (every decision and every \
         t exact) and of the least (the fastest kernels in `f32`).\n\n\
         | scene | X | ids | choice | pixels | beyond X | wrong | worst t | worst normal | again in f64 | exactly | ns/ray | × least | most / this |\n\
         | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |\n"
    );
    for plan in plans {
        let ids = if plan.exact_ids { "exact" } else { "rounded" };
        let _ = writeln!(
            text,
            "| {} | {:.0e} | {ids} | {} | {} | {} | {} | {:.0e} | {:.0e} rad | {} | {} | {:.0} | {:.2} | {:.1} |",
            plan.scene,
            plan.accuracy,
            plan.choice,
            plan.rays,
            plan.violations,
            plan.wrong_ids,
            plan.worst_t,
            plan.worst_normal,
            plan.again_in_f64,
            plan.again_exactly,
            plan.nanoseconds,
            plan.nanoseconds / plan.least_accurate,
            plan.most_accurate / plan.nanoseconds
        );
    }
    text.push('\n');
}

fn crossovers(text: &mut String, study: &Study) {
    let _ = write!(
        text,
        "## From how many parts on do boxes pay?\n\n\
         Made scenes: balls or triangles that fill the same ball. Nanoseconds for a ray; `f32` \
         asks eight parts at a time.\n\n\
         | what | numbers | parts | every part | boxes |\n\
         | --- | --- | --- | --- | --- |\n"
    );
    for tally in &study.crossovers {
        let _ = writeln!(
            text,
            "| {} | {} | {} | {:.0} | {:.0} |",
            tally.shape, tally.numbers, tally.parts, tally.brute_force, tally.boxes
        );
    }
    text.push('\n');
}
