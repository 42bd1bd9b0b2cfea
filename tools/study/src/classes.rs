//! Everyday, hard and absurd questions, each class on its own: what a kernel costs and what it
//! gets wrong, how often each tier of an exact kernel is needed, how errors of t depend on the
//! questions' condition numbers, and where each kernel breaks.

use std::collections::BTreeMap;

use crate::conditioning::decade;
use crate::extent::Extent;
use crate::family::HasFamilies;
use crate::judge::{Tally, median_and_worst};
use crate::kernel::Tier;
use crate::question::{Class, Data};
use crate::result::{
    BreakingPoint, ConditioningErrors, KernelTally, Point, Sweep, TierTally, Trade,
};
use crate::speed::{self, PAIRS, Time, pool, race};

/// A kernel's name, and the numbers it computes with.
pub type Entry = (&'static str, &'static str);

/// Questions per class on which the shares of the tiers are counted.
const COUNTED: usize = 10 * PAIRS;

/// The points of these sweeps in one class, or in several.
fn points(
    sweeps: &[Sweep],
    is_wanted: impl Fn(Class) -> bool,
) -> impl Iterator<Item = &KernelTally> {
    let points = sweeps.iter().flat_map(|sweep| &sweep.points);
    let points = points.filter(move |point| is_wanted(point.class));
    points.flat_map(|point| &point.kernels)
}

/// Cost and wrong decisions of every kernel, by class.
pub fn trades<S: HasFamilies>(sweeps: &[Sweep], extent: &Extent) -> Vec<Trade> {
    let mut trades = Vec::new();
    for class in Class::ALL {
        let mut judged: BTreeMap<Entry, Vec<&KernelTally>> = BTreeMap::new();
        for it in points(sweeps, |it| it == class) {
            judged.entry((it.kernel, it.numbers)).or_default().push(it);
        }
        let costs = costs::<S>(class, extent);
        for (entry, judged) in judged {
            let sum = |of: fn(&Tally) -> u64| judged.iter().map(|it| of(&it.tally)).sum::<u64>();
            let errors = judged.iter().flat_map(|it| &it.errors);
            let [median_ulp, _] = median_and_worst(errors.map(|error| error.0));
            let (time, instructions) = &costs[&entry];
            trades.push(Trade {
                shape: S::NAME,
                class,
                kernel: entry.0,
                numbers: entry.1,
                asked: sum(|tally| tally.asked),
                wrong: sum(Tally::wrong),
                not_finite: sum(|tally| tally.not_finite),
                median_ulp,
                nanoseconds: Some(time.nanoseconds),
                spread: Some(time.spread),
                instructions: *instructions,
            });
        }
    }
    trades
}

/// Time and instructions of every kernel on a sample of a class.
fn costs<S: HasFamilies>(class: Class, extent: &Extent) -> BTreeMap<Entry, (Time, Option<f64>)> {
    let mut costs = BTreeMap::new();
    for data in [Data::F64, Data::F32] {
        let asked = pool::<S>(class, data, PAIRS, extent.seed);
        let entered = S::contestants().into_iter().enumerate();
        let entered: Vec<_> = entered.filter(|(_, kernel)| kernel.data == data).collect();
        let workloads = entered.iter().map(|(_, kernel)| (kernel.workload)(&asked));
        let times = race(workloads.collect(), asked.len(), extent.seconds);
        for ((at, kernel), time) in entered.into_iter().zip(times) {
            let what = format!("{} {} {}", S::NAME, class.name(), extent.seed);
            let count = || speed::instructions(&what, at, asked.len());
            let instructions = extent.instructions.then(count).flatten();
            costs.insert((kernel.name, kernel.numbers), (time, instructions));
        }
    }
    costs
}

/// Each tier of the exact kernel in `f64`: its share of a class, and its cost.
pub fn tiers<S: HasFamilies>(extent: &Extent) -> Vec<TierTally> {
    let (at, kernel) = S::exact_kernel();
    let mut tallies = Vec::new();
    for class in Class::ALL {
        let all = pool::<S>(class, Data::F64, COUNTED, extent.seed);
        for tier in [Tier::SemiStatic, Tier::Exact] {
            let mut decided = all.clone();
            decided.retain(|question| S::tier(question) == tier);
            let count = decided.len();
            if count == 0 {
                continue;
            }
            decided.truncate(PAIRS);
            let timed = decided.len();
            let time = race(vec![(kernel.workload)(&decided)], timed, extent.seconds);
            let what = format!("{} {} {} {tier:?}", S::NAME, class.name(), extent.seed);
            let instructions = || speed::instructions(&what, at, timed);
            tallies.push(TierTally {
                shape: S::NAME,
                class,
                tier,
                decided: count as u64,
                asked: all.len() as u64,
                nanoseconds: time[0].nanoseconds,
                instructions: extent.instructions.then(instructions).flatten(),
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
pub fn conditioning(shape: &'static str, sweeps: &[Sweep]) -> Vec<ConditioningErrors> {
    let mut decades: BTreeMap<_, Vec<f64>> = BTreeMap::new();
    for it in points(sweeps, |class| class < Class::Absurd) {
        for (ulp, condition) in &it.errors {
            let key = (it.kernel, it.numbers, decade(*condition));
            decades.entry(key).or_default().push(*ulp);
        }
    }
    let of_decade = |((kernel, numbers, decade), errors): (_, Vec<f64>)| {
        let hits = errors.len() as u64;
        let [median, worst] = median_and_worst(errors);
        ConditioningErrors {
            shape,
            kernel,
            numbers,
            decade,
            hits,
            median_ulp: median.unwrap_or_default(),
            worst_ulp: worst.unwrap_or_default(),
        }
    };
    decades.into_iter().map(of_decade).collect()
}

/// A kernel with a larger share of wrong decisions is broken.
const WRONG: f64 = 1e-3;

/// A kernel is broken if more than one decision in a thousand is wrong, if any t is not finite,
/// or if at least half of all t have lost half of their digits.
fn is_broken(tally: &Tally, data: Data) -> bool {
    let half_lost = 2f64.powf(f64::from(data.digits()) / 2.0);
    tally.wrong_share() > WRONG
        || tally.not_finite > 0
        || tally.median_ulp.is_some_and(|ulp| ulp > half_lost)
}

/// The breaking points of every kernel in a sweep, by the same rule for all kernels.
pub fn breaking(sweep: &Sweep, data: Data) -> Vec<BreakingPoint> {
    // The exponent nearest to 0 is the easiest: search upwards from there.
    let exponents = sweep.points.iter().map(|point| point.exponent);
    let easy = exponents.min_by_key(|x| x.abs()).unwrap_or_default();
    let above = || sweep.points.iter().filter(|it| it.exponent >= easy);
    let of_kernel = |(at, named): (usize, &KernelTally)| BreakingPoint {
        shape: sweep.shape,
        family: sweep.family,
        kernel: named.kernel,
        numbers: named.numbers,
        above: above()
            .find(|it: &&Point| is_broken(&it.kernels[at].tally, data))
            .map(|it| it.exponent),
    };
    let kernels = sweep.points.first().into_iter().flat_map(|it| &it.kernels);
    kernels.enumerate().map(of_kernel).collect()
}
