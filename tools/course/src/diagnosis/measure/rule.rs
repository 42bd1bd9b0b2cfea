//! Where something is wrong: a condition on the question, or a bound on one of its
//! quantities, that separates the wrong samples from the right ones.

use pinhole::part::Condition;

use super::sample::Sample;

/// Which of a sample's conditions a rule is about.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum WhichAnswer {
    /// Those of the right answer.
    Right,
    /// Those of the answer that was given.
    Given,
}

/// One statement about a question.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Literal {
    /// This condition holds, or not.
    Holds(WhichAnswer, usize, bool),
    /// This quantity is below the bound.
    Below(usize, f64),
    /// This quantity is above the bound.
    Above(usize, f64),
}

/// Statements that separate wrong samples from right ones, and how sharply.
#[derive(Clone, Debug, PartialEq)]
pub struct Rule {
    /// The statements, all of which must hold.
    pub literals: Vec<Literal>,
    /// Where they hold.
    pub scope: Scope,
}

/// Where the statements of a rule hold.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Scope {
    /// Where something is wrong, and nowhere else.
    Exactly,
    /// Wherever something is wrong, and sometimes elsewhere.
    Everywhere,
    /// Only where something is wrong, but not wherever it is: there is another reason too.
    Partly,
}

impl Literal {
    /// Whether it holds for a sample.
    pub fn holds(self, sample: &Sample) -> bool {
        match self {
            Literal::Holds(of, k, so) => conditions(sample, of)[k].holds == so,
            Literal::Below(k, bound) => sample.quantities[k].value < bound,
            Literal::Above(k, bound) => sample.quantities[k].value > bound,
        }
    }
}

/// The conditions of a sample and one of its answers.
pub fn conditions(sample: &Sample, of: WhichAnswer) -> &[Condition] {
    match of {
        WhichAnswer::Right => &sample.conditions,
        WhichAnswer::Given => &sample.conditions_given,
    }
}

impl Rule {
    /// Whether all its statements hold.
    pub fn holds(&self, sample: &Sample) -> bool {
        self.literals.iter().all(|literal| literal.holds(sample))
    }

    /// Whether it is one bound on one quantity. A count has natural bounds, and 0 is one too.
    pub fn is_fixed_bound(&self, sample: &Sample) -> bool {
        match self.literals.as_slice() {
            [Literal::Below(k, bound) | Literal::Above(k, bound)] => {
                !sample.quantities[*k].is_count && *bound != 0.0
            }
            _ => false,
        }
    }

    /// Whether it separates the wrong samples from the right ones, with at most one exception in
    /// a hundred.
    pub fn separates(&self, wrong: &[&Sample], right: &[&Sample]) -> bool {
        let met = |samples: &[&Sample]| samples.iter().filter(|it| self.holds(it)).count();
        let (missed, extra) = (wrong.len() - met(wrong), met(right));
        let few = wrong.len().max(1) / 100;
        match self.scope {
            Scope::Exactly => missed <= few && extra <= few,
            Scope::Everywhere => missed <= few,
            Scope::Partly => {
                // Of the many pairs of conditions, some separate a few samples by chance.
                let least = if self.literals.len() > 1 { LEAST } else { 1 };
                let met = met(wrong);
                extra == 0 && met >= least && met * LEAST_COVERED >= wrong.len().max(1)
            }
        }
    }
}

impl Rule {
    /// "almost " if there are exceptions, otherwise empty.
    pub fn nearly(&self, wrong: &[&Sample], right: &[&Sample]) -> &'static str {
        let is_kept = wrong.iter().all(|it| self.holds(it))
            && !(self.scope == Scope::Exactly && right.iter().any(|it| self.holds(it)));
        if is_kept { "" } else { "almost " }
    }

    /// "each", or "nearly all" if the rule has exceptions.
    pub fn each(&self, wrong: &[&Sample], right: &[&Sample]) -> &'static str {
        match self.nearly(wrong, right) {
            "" => "each",
            _ => "nearly all",
        }
    }
}

/// With fewer samples than this on either side, don't look for a rule. Among so many conditions,
/// one often holds in eight samples by chance.
const LEAST: usize = 16;

/// A statement that holds for more than this share of the right samples is useless.
const TELLING: f64 = 0.34;

/// A rule that holds in less than one in this many of the wrong samples says too little.
const LEAST_COVERED: usize = 4;

/// The simplest rule that separates the wrong samples from the right ones. It is found on one
/// half of the samples and must hold on the other.
pub fn find(wrong: &[&Sample], right: &[&Sample], of: WhichAnswer) -> Option<Rule> {
    // A rule can't be found for only a few wrong samples.
    if wrong.len() < LEAST || right.len() < LEAST.max(wrong.len() / 30) {
        return None;
    }
    let [fit, test] = [true, false].map(|fits| (half(wrong, fits), half(right, fits)));
    let stands = |rule: &Rule| rule.separates(&fit.0, &fit.1) && rule.separates(&test.0, &test.1);
    let all = literals(&fit.0, &fit.1, of);
    let mut literals = all.clone();
    // Keep the statements that hold wherever something is wrong.
    literals.retain(|literal| {
        fit.0.iter().filter(|it| !literal.holds(it)).count() * 100 <= fit.0.len()
    });
    let single = literals.iter().map(|literal| vec![*literal]);
    for literals in single.chain(pairs(&literals)) {
        let rule = Rule {
            literals,
            scope: Scope::Exactly,
        };
        if stands(&rule) {
            return Some(rule);
        }
    }
    let share = |literal: &Literal| {
        let met = fit.1.iter().filter(|it| literal.holds(it)).count();
        met as f64 / fit.1.len().max(1) as f64
    };
    let best = literals.iter().min_by(|a, b| share(a).total_cmp(&share(b)));
    let everywhere = best.map(|best| Rule {
        literals: vec![*best],
        scope: Scope::Everywhere,
    });
    let is_telling = |rule: &Rule| {
        let telling = match rule.literals[0] {
            Literal::Holds(..) => TELLING,
            // The bound was chosen for these samples. For all samples, the best bound may be a
            // little further out.
            Literal::Below(..) | Literal::Above(..) => 0.5 * TELLING,
        };
        share(&rule.literals[0]) <= telling && stands(rule)
    };
    everywhere
        .filter(is_telling)
        .or_else(|| partly(&all, &fit.0, &stands))
}

/// What holds for each of these invented hits, and for none of these questions' right hits. With it,
/// something can be said even if no hit was found rightly.
pub fn never_right(invented: &[&Sample], hits: &[&Sample]) -> Option<Rule> {
    let count = invented.first()?.conditions_given.len();
    let all = (0..count).flat_map(|k| [(k, true), (k, false)]);
    let mut all = all.filter(|_| invented.len() >= LEAST && hits.len() >= LEAST);
    let (k, so) = all.find(|(k, so)| {
        let is_so = |conditions: &[Condition]| conditions[*k].holds == *so;
        invented.iter().all(|it| is_so(&it.conditions_given))
            && !hits.iter().any(|it| is_so(&it.conditions))
    })?;
    Some(Rule {
        literals: vec![Literal::Holds(WhichAnswer::Given, k, so)],
        scope: Scope::Everywhere,
    })
}

/// The condition that holds in most of the wrong samples and in no right one, or else two
/// conditions that do so together.
fn partly(literals: &[Literal], wrong: &[&Sample], stands: &dyn Fn(&Rule) -> bool) -> Option<Rule> {
    let covered = |literal: &Literal| wrong.iter().filter(|it| literal.holds(it)).count();
    // Don't try bounds: each is chosen to separate these samples, so it proves nothing.
    let mut conditions: Vec<Literal> = literals
        .iter()
        .filter(|literal| matches!(literal, Literal::Holds(..)))
        .copied()
        .collect();
    conditions.sort_by_key(|literal| std::cmp::Reverse(covered(literal)));
    conditions.retain(|literal| covered(literal) * LEAST_COVERED >= wrong.len());
    let single = conditions.iter().map(|literal| vec![*literal]);
    let rules = single.chain(pairs(&conditions)).map(|literals| Rule {
        literals,
        scope: Scope::Partly,
    });
    rules.into_iter().find(|rule| stands(rule))
}

/// Every two of these.
fn pairs(literals: &[Literal]) -> impl Iterator<Item = Vec<Literal>> {
    literals.iter().enumerate().flat_map(|(k, one)| {
        let others = literals[k + 1..].iter();
        others.map(move |other| vec![*one, *other])
    })
}

/// The samples that laws are fitted to, or the others.
fn half<'a>(samples: &[&'a Sample], fits: bool) -> Vec<&'a Sample> {
    let half = samples.iter().filter(|sample| sample.fits == fits);
    half.copied().collect()
}

/// Every statement that may separate: conditions, and the bounds of each quantity that separate
/// best.
fn literals(wrong: &[&Sample], right: &[&Sample], of: WhichAnswer) -> Vec<Literal> {
    let Some(first) = wrong.first() else {
        return Vec::new();
    };
    let count = conditions(first, of).len();
    let mut literals: Vec<Literal> = (0..count)
        .flat_map(|k| [true, false].map(|so| Literal::Holds(of, k, so)))
        .collect();
    for k in 0..first.quantities.len() {
        let values = |samples: &[&Sample]| -> Vec<f64> {
            samples.iter().map(|it| it.quantities[k].value).collect()
        };
        let (wrong, right) = (values(wrong), values(right));
        if wrong.iter().chain(&right).any(|value| !value.is_finite()) {
            continue;
        }
        // A count's bound is right next to the wrong samples, where we are sure of it.
        let bounds = |wrong: f64, right: f64| match first.quantities[k].is_count {
            true => vec![wrong + 0.5 * (right - wrong).signum()],
            false => between(wrong, right),
        };
        let largest = wrong.iter().copied().fold(f64::MIN, f64::max);
        let smallest = wrong.iter().copied().fold(f64::MAX, f64::min);
        // If all wrong samples have the same value, such as 0, no bound is known.
        if smallest == largest && !first.quantities[k].is_count {
            continue;
        }
        let above = right.iter().copied().filter(|it| *it > largest);
        let below = right.iter().copied().filter(|it| *it < smallest);
        let (next, last) = (
            above.fold(f64::MAX, f64::min),
            below.fold(f64::MIN, f64::max),
        );
        if next < f64::MAX {
            let bounds = bounds(largest, next).into_iter();
            literals.extend(bounds.map(|bound| Literal::Below(k, bound)));
        }
        if last > f64::MIN {
            let bounds = bounds(smallest, last).into_iter();
            literals.extend(bounds.map(|bound| Literal::Above(k, bound)));
        }
    }
    literals
}

/// Bounds for a value like `wrong` but unlike `right`. First what people write in code: 0, a power
/// of ten, or the spacing of floating-point numbers at 1; then the number with the fewest digits.
fn between(wrong: f64, right: f64) -> Vec<f64> {
    if wrong < 0.0 && right >= 0.0 || wrong > 0.0 && right <= 0.0 {
        return vec![0.0];
    }
    let (low, high) = (wrong.min(right), wrong.max(right));
    let middle = 0.5 * (low + high);
    let is_inside = |it: &f64| low < *it && *it < high;
    let parsed = |text: String| text.parse().unwrap_or(middle);
    let power = format!("1e{}", high.abs().log10().floor()).parse().ok();
    let mut rounded = (0..9).map(|digits| parsed(format!("{middle:.digits$e}")));
    let shortest = rounded.find(is_inside).unwrap_or(middle);
    let epsilons = [f64::EPSILON, f64::from(f32::EPSILON)];
    let mut bounds: Vec<f64> = power.into_iter().chain(epsilons).collect();
    bounds.retain(is_inside);
    if !bounds.contains(&shortest) {
        bounds.push(shortest);
    }
    bounds
}

#[cfg(test)]
mod tests {
    use super::between;

    #[test]
    fn plainest_bounds_come_first() {
        assert_eq!(between(-1e-22, 3e-9), [0.0]);
        assert_eq!(between(-1e-22, 0.0), [0.0]);
        assert_eq!(between(3e-9, -1e-22), [0.0]);
        assert_eq!(between(0.97, 1.04), [1.0]);
        assert_eq!(between(9e-13, 4e-12), [1e-12, 2e-12]);
        assert_eq!(between(9e-17, 8e-16), [1e-16, f64::EPSILON, 4e-16]);
        // A value of 0 would not be below 0.
        assert!(!between(0.0, 2e-9).contains(&0.0));
    }
}
