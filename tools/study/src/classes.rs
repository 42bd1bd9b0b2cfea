//! Everyday, hard and absurd questions, each class on its own: what a kernel costs and what it
//! gets wrong, how often each tier of an exact kernel is needed, and how errors of t depend on
//! the questions' condition numbers.

use std::collections::BTreeMap;

use crate::conditioning::decade;
use crate::family::HasFamilies;
use crate::instructions;
use crate::judge::{Tally, median_and_worst};
use crate::kernel::Tier;
use crate::question::{Class, Data};
use crate::result::{ConditioningErrors, Sweep, TierTally, Trade};
use crate::scenes::Share;
use crate::speed::{PAIRS, Time, pool, race};

/// A kernel's name, and the numbers it computes with.
pub type Entry = (&'static str, &'static str);

/// The class of a question, the error of its t in ulp, and its condition number.
pub type Error = (Class, f64, f64);

/// All errors of one shape's kernels.
pub type Errors = BTreeMap<Entry, Vec<Error>>;

/// Questions per class on which the shares of the tiers are counted.
const COUNTED: usize = 10 * PAIRS;

/// Cost and wrong decisions of every kernel, by class.
pub fn trades<S: HasFamilies>(
    sweeps: &[Sweep],
    errors: &Errors,
    share: Share,
    seed: u64,
) -> Vec<Trade> {
    let mut trades = Vec::new();
    for class in Class::ALL {
        let costs = costs::<S>(class, share, seed);
        for (entry, errors) in errors {
            let tallies = sweeps
                .iter()
                .flat_map(|sweep| &sweep.points)
                .filter(|point| point.class == class)
                .flat_map(|point| &point.kernels)
                .filter(|judged| (judged.kernel, judged.numbers) == *entry);
            let tallies: Vec<&Tally> = tallies.map(|judged| &judged.tally).collect();
            let sum = |of: fn(&Tally) -> u64| tallies.iter().map(|tally| of(tally)).sum::<u64>();
            let of_class = errors.iter().filter(|error| error.0 == class);
            let [median_ulp, worst_ulp] = median_and_worst(of_class.map(|error| error.1));
            let cost = costs.get(entry);
            trades.push(Trade {
                shape: S::NAME,
                class,
                kernel: entry.0,
                numbers: entry.1,
                asked: sum(|tally| tally.asked),
                wrong: sum(Tally::wrong),
                not_finite: sum(|tally| tally.not_finite),
                median_ulp,
                worst_ulp,
                nanoseconds: cost.map(|cost| cost.0.nanoseconds),
                spread: cost.map(|cost| cost.0.spread),
                instructions: cost.and_then(|cost| cost.1),
            });
        }
    }
    trades
}

/// Time and instructions of every kernel on a sample of a class.
fn costs<S: HasFamilies>(
    class: Class,
    share: Share,
    seed: u64,
) -> BTreeMap<Entry, (Time, Option<f64>)> {
    let mut costs = BTreeMap::new();
    for data in [Data::F64, Data::F32] {
        let asked = pool::<S>(class, data, PAIRS, seed);
        let entered = S::contestants().into_iter().enumerate();
        let entered: Vec<_> = entered.filter(|(_, kernel)| kernel.data == data).collect();
        let workloads = entered.iter().map(|(_, kernel)| (kernel.workload)(&asked));
        let times = race(workloads.collect(), asked.len(), share.seconds);
        for ((at, kernel), time) in entered.into_iter().zip(times) {
            let what = format!("{} {} {seed}", S::NAME, class.name());
            let count = || instructions::of_cast(&what, at, asked.len());
            costs.insert(
                (kernel.name, kernel.numbers),
                (time, share.instructions.then(count).flatten()),
            );
        }
    }
    costs
}

/// Each tier of the exact kernel in `f64`: its share of a class, and its cost.
pub fn tiers<S: HasFamilies>(share: Share, seed: u64) -> Vec<TierTally> {
    let (at, kernel) = S::exact_kernel();
    let mut tallies = Vec::new();
    for class in Class::ALL {
        let all = pool::<S>(class, Data::F64, COUNTED, seed);
        for tier in [Tier::SemiStatic, Tier::DoubleDouble, Tier::Exact] {
            let mut decided = all.clone();
            decided.retain(|question| S::tier(question) == tier);
            let count = decided.len();
            if count == 0 {
                continue;
            }
            decided.truncate(PAIRS);
            let timed = decided.len();
            let time = race(vec![(kernel.workload)(&decided)], timed, share.seconds);
            let what = format!("{} {} {seed} {tier:?}", S::NAME, class.name());
            let instructions = || instructions::of_cast(&what, at, timed);
            tallies.push(TierTally {
                shape: S::NAME,
                class,
                tier,
                decided: count as u64,
                asked: all.len() as u64,
                nanoseconds: time[0].nanoseconds,
                instructions: share.instructions.then(instructions).flatten(),
            });
        }
    }
    tallies
}

/// Runs one kernel's workload `casts` times, on a class of questions or only on those that one
/// tier decides. This is what runs under valgrind. Returns false if `what` names something
/// else.
pub fn cast<S: HasFamilies>(what: &str, kernel: usize, casts: u32) -> bool {
    let mut words = what.splitn(4, ' ');
    let (shape, class, seed) = (words.next(), words.next(), words.next());
    let class = Class::ALL.into_iter().find(|it| Some(it.name()) == class);
    let seed = seed.and_then(|seed| seed.parse().ok());
    let (Some(class), Some(seed), true) = (class, seed, shape == Some(S::NAME)) else {
        return false;
    };
    if let Some(kernel) = S::contestants().get(kernel) {
        let tier = words.next();
        let count = if tier.is_some() { COUNTED } else { PAIRS };
        let mut asked = pool::<S>(class, kernel.data, count, seed);
        asked.retain(|it| tier.is_none_or(|tier| format!("{:?}", S::tier(it)) == tier));
        asked.truncate(PAIRS);
        let mut cast = (kernel.workload)(&asked);
        (0..casts).for_each(|_| cast());
    }
    true
}

/// Errors of t in everyday and hard questions, by decade of the condition number.
pub fn conditioning(shape: &'static str, errors: &Errors) -> Vec<ConditioningErrors> {
    let mut all = Vec::new();
    for (&(kernel, numbers), errors) in errors {
        let mut decades: BTreeMap<i32, Vec<f64>> = BTreeMap::new();
        for (_, ulp, condition) in errors.iter().filter(|it| it.0 < Class::Absurd) {
            decades.entry(decade(*condition)).or_default().push(*ulp);
        }
        for (decade, errors) in decades {
            let hits = errors.len() as u64;
            let [median, worst] = median_and_worst(errors);
            all.push(ConditioningErrors {
                shape,
                kernel,
                numbers,
                decade,
                hits,
                median_ulp: median.unwrap_or_default(),
                worst_ulp: worst.unwrap_or_default(),
            });
        }
    }
    all
}
