//! The claim of a sentence, which can be tested on other questions.

use super::law::{self, Law, PartLaw};
use super::rule::{Literal, Rule, Scope};
use super::sample::{QuestionsAndAnswers, Sample, samples};
use super::single;
use super::steps;
use super::{ALL, LEAST_SHARE};

/// What a sentence claims, in a form that can be tested on other questions.
#[derive(Clone, Debug, PartialEq)]
pub enum Claim {
    /// Nothing but a count.
    Count,
    /// There is never a hit, or always one.
    Never { misses: bool },
    /// There is hardly ever a hit, or nearly always one.
    Nearly { misses: bool },
    /// Hits are missed, or invented, where the rule says.
    Decision { misses: bool, rule: Rule },
    /// This share of a part's wrong values follows a law, where the rule says so. If there is a
    /// side, only the samples on that side count.
    Part {
        part: usize,
        law: PartLaw,
        share: f64,
        rule: Option<Rule>,
        side: Option<Literal>,
    },
    /// A part is wrong where the rule says.
    Where { part: usize, rule: Rule },
    /// A part has single precision.
    Single { part: usize },
    /// This share of an answer's steps is of the sort that the tally at this place in the list
    /// counts.
    Steps { tally: usize, share: f64 },
    /// Parts are right.
    Right { parts: Vec<usize> },
    /// All of these.
    Several(Vec<Claim>),
}

impl Claim {
    /// The place of a claim in a list: claims that say more come first.
    pub fn rank(&self) -> u8 {
        match self {
            Claim::Never { .. }
            | Claim::Nearly { .. }
            | Claim::Decision { .. }
            | Claim::Part { .. }
            | Claim::Steps { .. }
            | Claim::Single { .. } => 0,
            Claim::Where { .. } => 1,
            Claim::Count | Claim::Right { .. } => 2,
            Claim::Several(claims) => claims.iter().map(Claim::rank).min().unwrap_or(2),
        }
    }

    /// The rule that says where something is wrong, if it has one.
    pub fn rule(&self) -> Option<&Rule> {
        match self {
            Claim::Part { rule, .. } => rule.as_ref(),
            Claim::Where { rule, .. } => Some(rule),
            _ => None,
        }
    }

    /// The same claim about another part.
    pub fn about(&self, part: usize) -> Claim {
        let mut claim = self.clone();
        if let Claim::Part { part: own, .. } | Claim::Where { part: own, .. } = &mut claim {
            *own = part;
        }
        claim
    }

    /// Whether two parts may share a sentence: neither has a law, or both have the values of the
    /// same other answer.
    pub fn is_like(&self, other: &Claim) -> bool {
        match (self, other) {
            (Claim::Count, Claim::Count) => true,
            (Claim::Where { rule, .. }, Claim::Where { rule: its, .. }) => rule == its,
            (
                Claim::Part {
                    law, share, rule, ..
                },
                Claim::Part {
                    law: its_law,
                    share: its_share,
                    rule: its_rule,
                    ..
                },
            ) => {
                let is_other = matches!(law, PartLaw::Whole(Law::Other(_)));
                is_other && law == its_law && rule == its_rule && (share - its_share).abs() < 0.01
            }
            _ => false,
        }
    }
}

/// The share of wrong samples that follow a law; `None` if it can't be told.
pub fn share_of<'a>(
    law: &PartLaw,
    part: usize,
    wrong: impl Iterator<Item = &'a Sample>,
) -> Option<f64> {
    let (follow, broken) = law::tally(law, part, wrong);
    (follow > 0).then(|| follow as f64 / (follow + broken) as f64)
}

impl Claim {
    /// Whether it is also true of these questions, apart from a few exceptions.
    pub fn holds(&self, films: &[QuestionsAndAnswers<'_>]) -> bool {
        let samples = samples(films);
        let both = || {
            samples
                .iter()
                .filter(|it| it.right.is_some() && it.given.is_some())
        };
        let split = |part: usize| -> (Vec<&Sample>, Vec<&Sample>) {
            let comparable = both().filter(|it| it.is_comparable(part));
            comparable.partition(|it| !it.is_right(part))
        };
        let meets = |rule: &Rule, wrong: &[&Sample], good: &[&Sample]| {
            let met = |samples: &[&Sample]| samples.iter().filter(|it| rule.holds(it)).count();
            let few = wrong.len() / 20 + 1;
            let (missed, extra) = (wrong.len() - met(wrong), met(good));
            match rule.scope {
                Scope::Exactly => missed <= few && extra <= few,
                Scope::Everywhere => missed <= few,
                Scope::Partly => extra <= few,
            }
        };
        match self {
            Claim::Count => true,
            Claim::Steps { tally, share } => steps::sum(films)
                .get(*tally)
                .is_some_and(|sum| steps::is_about(sum, *share)),
            Claim::Single { part } => single::is_single(&both().collect::<Vec<_>>(), *part),
            // The sentence is about the public questions. Of many more questions, a few may have a
            // right answer by chance.
            Claim::Never { misses } => {
                let asked = samples.iter().filter(|it| it.right.is_some() == *misses);
                let (wrong, good): (Vec<&Sample>, Vec<&Sample>) =
                    asked.partition(|it| it.given.is_some() != *misses);
                good.len() * 100 <= wrong.len()
            }
            Claim::Nearly { misses } => {
                let asked = samples.iter().filter(|it| it.right.is_some() == *misses);
                let (wrong, good): (Vec<&Sample>, Vec<&Sample>) =
                    asked.partition(|it| it.given.is_some() != *misses);
                wrong.len() >= 4 * good.len()
            }
            Claim::Decision { misses, rule } => {
                let asked = samples.iter().filter(|it| it.right.is_some() == *misses);
                let (wrong, good): (Vec<&Sample>, Vec<&Sample>) =
                    asked.partition(|it| it.given.is_some() != *misses);
                let good = if *misses { good } else { both().collect() };
                meets(rule, &wrong, &good)
            }
            Claim::Part {
                part,
                law,
                share,
                rule,
                side,
            } => {
                let (mut wrong, mut good) = split(*part);
                for samples in [&mut wrong, &mut good] {
                    samples.retain(|it| side.is_none_or(|side| side.holds(it)));
                }
                let follows = share_of(law, *part, wrong.iter().copied());
                // Fresh questions are more often extreme than public ones. If only a part of the
                // wrong answers follows the law, another part does so there.
                let least = if *share < ALL {
                    LEAST_SHARE
                } else {
                    share - 0.1
                };
                follows.is_none_or(|follows| follows >= least)
                    && rule.as_ref().is_none_or(|rule| meets(rule, &wrong, &good))
            }
            Claim::Where { part, rule } => {
                let (wrong, good) = split(*part);
                meets(rule, &wrong, &good)
            }
            Claim::Several(claims) => claims.iter().all(|claim| claim.holds(films)),
            Claim::Right { parts } => parts.iter().all(|part| split(*part).0.len() <= 2),
        }
    }
}
