//! What is measurably wrong in the answers to a task, even if no known mistake explains
//! it.
//!
//! Reading order: [`sample`] holds a question with both answers, part by part. [`law`] says how a
//! wrong part follows from the right one, and [`rule`] where it is wrong. [`single`] finds answers
//! that were rounded to `f32`, and [`steps`] looks at how an answer was found. [`words`] writes the
//! sentences, and [`claim`] tests them on other questions.
//!
//! Laws and rules are found on one half of the questions, and reported only if they hold on
//! the other half.

mod claim;
mod law;
mod rule;
mod sample;
mod single;
mod steps;
mod words;

use pinhole::part::Part;
use pinhole::words::number;
use rayon::prelude::*;
use serde::{Deserialize, Serialize};

use claim::{Claim, share_of};
use law::{PartLaw, best};
use rule::{Literal, Rule, Scope, WhichAnswer};
pub use sample::QuestionsAndAnswers;
use sample::{Sample, samples};
use words::DIGITS;

/// One thing that was measured, in a sentence.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct Finding {
    /// The part of an answer that the sentence is about.
    pub about: String,
    /// The sentence.
    pub says: String,
    /// Whether the sentence says what law the wrong answers follow, or where they are; if not, it
    /// only counts them.
    pub is_law: bool,
}

/// A finding, and what it claims.
#[derive(Clone, Debug, PartialEq)]
pub struct Measurement {
    /// What people read.
    pub finding: Finding,
    claim: Claim,
}

/// With fewer wrong samples than this, don't look for a law.
const LEAST: usize = 8;

/// A law is reported only if at least this share of the wrong samples follows it.
const LEAST_SHARE: f64 = 0.3;

/// From this share on, blame rounding for the rest.
const ALL: f64 = 0.99;

/// Search at most this many samples for a law.
const MOST_SEARCHED: usize = 160;

/// From this share on, hits are missed, or invented, nearly everywhere.
const NEARLY_ALL: f64 = 0.85;

/// If fewer than one in this many hits can be compared, they say little about the other hits.
const LEAST_SEEN: usize = 4;

/// What the samples of a part are called if only hits have that part.
const HITS: &str = "hits";

/// The most sentences that are reported for a task.
const MOST_SAID: usize = 4;

/// What is wrong in the answers to one task.
pub fn measure(films: &[QuestionsAndAnswers<'_>]) -> Vec<Measurement> {
    let samples = samples(films);
    let mut found = decisions(&samples);
    let both = with_both_answers(&samples);
    let is_hit = |sample: &Sample| sample.right.iter().flatten().any(Part::is_object);
    let noun = match samples.iter().any(is_hit) {
        true => HITS,
        false => "questions",
    };
    let parts = both
        .first()
        .and_then(|it| it.right.as_ref())
        .map_or(0, Vec::len);
    let hits = samples.iter().filter(|sample| sample.right.is_some());
    let hits = hits.count();
    let mut right = Vec::new();
    let mut wrong_parts: Vec<PartFinding> = Vec::new();
    for part in 0..parts {
        let name = |sample: &Sample| sample.right.as_ref().map_or("", |parts| parts[part].name);
        let about = name(both[0]);
        let comparable = |sample: &&&Sample| sample.is_comparable(part);
        let comparable: Vec<&Sample> = both.iter().filter(comparable).copied().collect();
        let (good, wrong): (Vec<&Sample>, Vec<&Sample>) =
            comparable.iter().partition(|sample| sample.is_right(part));
        if wrong.is_empty() {
            // In a task without hits, the sentence can't say where the part is right, so it must be
            // right everywhere.
            let is_everywhere = noun == HITS || good.len() == both.len();
            let is_seen = good.len() >= LEAST
                && good.len() * LEAST_SEEN >= hits
                && is_everywhere
                && !both[0].is_object(part);
            right.extend(is_seen.then_some((about, part)));
            continue;
        }
        wrong_parts.push(PartFinding {
            part,
            about,
            noun: match noun == HITS && comparable.len() < both.len() {
                true => "hits on the right object",
                false => noun,
            },
            side: None,
            wrong,
            good,
        });
    }
    found.extend(measured_parts(&wrong_parts));
    let wrong: Vec<&str> = wrong_parts.iter().map(|part| part.about).collect();
    found.extend(steps::found(films, &wrong));
    // If a law is known, leave out parts that are only known to be wrong, because they may follow
    // from it.
    found.sort_by_key(|measured| measured.claim.rank());
    let has_law = found
        .iter()
        .any(|it| matches!(it.claim, Claim::Part { .. }));
    if has_law && noun != HITS {
        found.retain(|measured| measured.claim.rank() == 0);
    }
    found.splice(0..0, single::found(films, &both));
    found.truncate(MOST_SAID);
    let told = |about: &str| found.iter().any(|measured| measured.finding.about == about);
    right.retain(|(about, _)| !told(about));
    if !found.is_empty() && !right.is_empty() {
        let objects = both.iter().all(|sample| sample.is_same_object());
        found.push(right_parts(&right, noun, objects));
    }
    found
}

/// Reports answers in single precision. They may all be right, but in a scene, their errors can add
/// up.
pub fn single_precision(films: &[QuestionsAndAnswers<'_>]) -> Option<Measurement> {
    single::found(films, &with_both_answers(&samples(films)))
}

/// The samples for which there is a right answer, and one was given.
fn with_both_answers(samples: &[Sample]) -> Vec<&Sample> {
    let both = samples.iter();
    both.filter(|sample| sample.right.is_some() && sample.given.is_some())
        .collect()
}

/// Reports the parts that are right wherever they can be compared.
fn right_parts(parts: &[(&str, usize)], noun: &str, objects: bool) -> Measurement {
    let names: Vec<String> = parts.iter().map(|(name, _)| (*name).to_owned()).collect();
    let names = words::list(names);
    let are = if parts.len() == 1 { "is" } else { "are" };
    let place = match (noun, objects) {
        (HITS, true) => "in every real hit that you find",
        (HITS, false) => "wherever the object is right",
        _ => "everywhere",
    };
    Measurement {
        finding: Finding {
            says: format!("{} {are} right {place}.", capital(&names)),
            about: names,
            is_law: false,
        },
        claim: Claim::Right {
            parts: parts.iter().map(|(_, part)| *part).collect(),
        },
    }
}

/// Reports hits that are missed, and hits where there should be none.
fn decisions(samples: &[Sample]) -> Vec<Measurement> {
    let mut found = Vec::new();
    for misses in [true, false] {
        let asked: Vec<&Sample> = samples
            .iter()
            .filter(|sample| sample.right.is_some() == misses)
            .collect();
        let (wrong, good): (Vec<&Sample>, Vec<&Sample>) = asked
            .iter()
            .partition(|sample| sample.given.is_some() != misses);
        if wrong.is_empty() {
            continue;
        }
        let (some, all) = (wrong.len(), asked.len());
        let hits = samples.iter().filter(|it| it.right.is_some());
        if good.is_empty() && all >= LEAST {
            let says = match misses {
                true => format!("You miss all {all} hits."),
                false => {
                    let rule = rule::never_right(&wrong, &hits.collect::<Vec<_>>());
                    let place = rule.map(|rule| words::rule(&rule, wrong[0]));
                    let place = place.map(|place| format!(" In each of them, {place}."));
                    let place = place.unwrap_or_default();
                    format!("You find a hit in all {all} questions where there is none.{place}")
                }
            };
            found.push(decision(says, true, Claim::Never { misses }));
            continue;
        }
        // Compare invented hits with right ones, and missed hits with found ones.
        let found_rightly: Vec<&Sample> = match misses {
            true => good,
            false => hits.clone().filter(|it| it.given.is_some()).collect(),
        };
        let of = if misses {
            WhichAnswer::Right
        } else {
            WhichAnswer::Given
        };
        let rule = match misses || !found_rightly.is_empty() {
            true => rule::find(&wrong, &found_rightly, of),
            false => rule::never_right(&wrong, &hits.collect::<Vec<_>>()),
        };
        let counted = match misses {
            true => format!("You miss {some} of the {all} hits"),
            false => format!("You find a hit in {some} of the {all} questions where there is none"),
        };
        found.push(match rule {
            Some(rule) => {
                let place = words::rule(&rule, wrong[0]);
                let nearly = rule.nearly(&wrong, &found_rightly);
                let each = rule.each(&wrong, &found_rightly);
                let says = match (rule.scope, misses) {
                    (Scope::Exactly, true) => {
                        let bound = match nearly.is_empty() && rule.is_fixed_bound(wrong[0]) {
                            true => " Your code may compare it with a fixed bound.",
                            false => "",
                        };
                        format!("{counted}: {nearly}exactly those where {place}.{bound}")
                    }
                    (Scope::Exactly | Scope::Everywhere, _) => {
                        format!("{counted}. In {each} of them, {place}.")
                    }
                    (Scope::Partly, _) => format!("{counted}{}.", among(&rule, &wrong, misses)),
                };
                decision(says, true, Claim::Decision { misses, rule })
            }
            None if some as f64 >= NEARLY_ALL * all as f64 && all >= LEAST => {
                let says = match misses {
                    true => format!("You miss nearly all hits: {some} of {all}."),
                    false => format!(
                        "You find a hit in nearly all questions where there is none: in {some} \
                         of {all}."
                    ),
                };
                decision(says, true, Claim::Nearly { misses })
            }
            None => decision(format!("{counted}."), false, Claim::Count),
        });
    }
    found
}

/// Says in how many of the wrong samples a rule holds, if it does not hold in all of them.
fn among(rule: &Rule, wrong: &[&Sample], all: bool) -> String {
    let place = words::rule(rule, wrong[0]);
    let count = wrong.iter().filter(|it| rule.holds(it)).count();
    match all {
        true => format!(", including all {count} where {place}"),
        // A condition on a wrong hit can't be tested where no hit was found, so don't claim "all".
        false => format!("; in {count} of these, {place}"),
    }
}

fn decision(says: String, is_law: bool, claim: Claim) -> Measurement {
    let about = "hit or miss".into();
    Measurement {
        finding: Finding {
            about,
            says,
            is_law,
        },
        claim,
    }
}

/// Describes the wrong parts. Parts that are wrong in the same way share a sentence.
fn measured_parts(findings: &[PartFinding<'_>]) -> Vec<Measurement> {
    let mut alike: Vec<(Claim, Vec<&PartFinding>)> = Vec::new();
    let mut measured = Vec::new();
    let claims = findings.par_iter().map(|finding| {
        let claim = finding.claim();
        let sides = finding.sides(&claim);
        (claim, sides)
    });
    let claims: Vec<_> = claims.collect();
    for (finding, (claim, sides)) in findings.iter().zip(claims) {
        if let Some(sides) = sides {
            measured.extend(sides);
            continue;
        }
        let is_same = |(other, of): &&mut (Claim, Vec<&PartFinding>)| {
            finding.excess().is_none()
                && of[0].wrong.len() == finding.wrong.len()
                && of[0].good.len() == finding.good.len()
                && other.is_like(&claim)
        };
        match alike.iter_mut().find(is_same) {
            Some((_, of)) => of.push(finding),
            None => alike.push((claim, vec![finding])),
        }
    }
    measured.extend(alike.into_iter().map(|(claim, of)| {
        let about = words::list(of.iter().map(|it| it.about.to_owned()).collect());
        let says = of[0].says(&about, of.len() > 1, &claim);
        let is_law = claim != Claim::Count;
        let claim = match of.as_slice() {
            [_] => claim,
            all => Claim::Several(all.iter().map(|it| claim.about(it.part)).collect()),
        };
        Measurement {
            finding: Finding {
                about,
                says,
                is_law,
            },
            claim,
        }
    }));
    measured
}

/// A part that is wrong somewhere.
struct PartFinding<'a> {
    part: usize,
    about: &'static str,
    noun: &'static str,
    /// The samples that it is about; `None` if it is about all of them.
    side: Option<Literal>,
    wrong: Vec<&'a Sample>,
    good: Vec<&'a Sample>,
}

impl<'a> PartFinding<'a> {
    /// The strongest claim that holds.
    fn claim(&self) -> Claim {
        let part = self.part;
        let rule = rule::find(&self.wrong, &self.good, WhichAnswer::Right);
        match (self.law(), rule) {
            (Some((law, share)), rule) => Claim::Part {
                part,
                law,
                share,
                rule,
                side: self.side,
            },
            (None, Some(rule)) => Claim::Where { part, rule },
            (None, None) => Claim::Count,
        }
    }

    /// Two sentences instead of one, if the part follows one law where a condition holds, and
    /// another law where it doesn't.
    fn sides(&self, whole: &Claim) -> Option<Vec<Measurement>> {
        let is_clear = |claim: &Claim| match claim {
            Claim::Part { law, share, .. } => *share >= ALL && law.is_complete(),
            _ => false,
        };
        if is_clear(whole) {
            return None;
        }
        let conditions = self.wrong.first()?.conditions.len();
        (0..conditions).find_map(|k| {
            let sides = [true, false].map(|so| self.on(Literal::Holds(WhichAnswer::Right, k, so)));
            if sides.iter().any(|side| side.wrong.len() < LEAST) {
                return None;
            }
            let claims = sides.iter().map(PartFinding::claim);
            let claims: Vec<Claim> = claims.take_while(is_clear).collect();
            if claims.len() < sides.len() {
                return None;
            }
            let measured = sides.iter().zip(claims).map(|(side, claim)| Measurement {
                finding: Finding {
                    about: side.about.into(),
                    says: side.says(side.about, false, &claim),
                    is_law: true,
                },
                claim,
            });
            Some(measured.collect())
        })
    }

    /// The same part where this holds.
    fn on(&self, side: Literal) -> Self {
        let only = |samples: &[&'a Sample]| -> Vec<&'a Sample> {
            let met = samples.iter().filter(|sample| side.holds(sample));
            met.copied().collect()
        };
        PartFinding {
            side: Some(side),
            wrong: only(&self.wrong),
            good: only(&self.good),
            ..*self
        }
    }

    /// A claim in words, about a part, or about several that are wrong in the same way.
    fn says(&self, about: &str, several: bool, claim: &Claim) -> String {
        let (some, all) = (self.wrong.len(), self.wrong.len() + self.good.len());
        let about = match self.side {
            Some(side) => format!("Where {}, {about}", words::literal(&side, self.wrong[0])),
            None => capital(about),
        };
        let (is, it) = if several {
            ("are", "they")
        } else {
            ("is", "it")
        };
        let (wrong, excess) = match self.excess() {
            Some(excess) => ("too large", excess),
            None => ("wrong", String::new()),
        };
        let place = claim.rule().map(|rule| {
            let place = words::rule(rule, self.wrong[0]);
            let nearly = rule.nearly(&self.wrong, &self.good);
            let each = rule.each(&self.wrong, &self.good);
            match rule.scope {
                Scope::Exactly => format!(", {nearly}exactly where {place}"),
                Scope::Everywhere => format!(", in {each} of which {place}"),
                Scope::Partly => among(rule, &self.wrong, true),
            }
        });
        let where_ = place.unwrap_or_default();
        let of = match some == all {
            true => format!("in all {all} {}", self.noun),
            false => format!("in {some} of {all} {}", self.noun),
        };
        match claim {
            Claim::Part { law, share, .. } => {
                let said = words::law(law, self.part, self.wrong[0], several);
                let is_always = matches!(law, PartLaw::Whole(law::Law::Always(_)));
                match *share >= ALL {
                    true if is_always && some < all => {
                        format!("{about} {is} wrong {of}{where_}; there, {it} {said}.")
                    }
                    true if *share == 1.0 => format!("{about} {said}, {of}{where_}."),
                    true => format!("{about} {said}, {of}{where_}, with few exceptions."),
                    false => {
                        let share = share_of(law, self.part, self.wrong.iter().copied());
                        let percent = 100.0 * share.unwrap_or_default();
                        format!(
                            "{about} {is} wrong {of}{where_}; in about {:.0} % of the wrong ones, \
                             {it} {said}.",
                            percent.clamp(1.0, 99.0),
                            said = said.replacen("always ", "", 1)
                        )
                    }
                }
            }
            Claim::Count => match self.lost() {
                0 => format!("{about} {is} {wrong} {of}{excess}."),
                lost if lost == some => format!("{about} {is} infinite or not a number {of}."),
                lost => format!(
                    "{about} {is} wrong {of}; in {lost} of these, {it} {is} infinite or not a \
                     number."
                ),
            },
            _ => format!("{about} {is} {wrong} {of}{where_}{excess}."),
        }
    }

    /// How many of the given values are infinite or not a number.
    fn lost(&self) -> usize {
        let lost = self.wrong.iter().filter(|sample| {
            let given = sample.both(self.part).map_or(&[][..], |(_, given)| given);
            given.iter().any(|value| !value.is_finite())
        });
        lost.count()
    }

    /// How far a part is above its limit at worst, if it has one.
    fn excess(&self) -> Option<String> {
        let limited = self.wrong.iter().map(|sample| sample.limited(self.part));
        let limited: Vec<(f64, f64)> = limited.collect::<Option<_>>()?;
        // Above a limit of 0, the ratio is infinite.
        let by_excess = |a: &&(f64, f64), b: &&(f64, f64)| {
            let ratio = |it: &(f64, f64)| it.0 / it.1;
            ratio(a).total_cmp(&ratio(b)).then(a.0.total_cmp(&b.0))
        };
        let (given, most) = limited.iter().max_by(by_excess)?;
        let [given, most] = [*given, *most].map(|value| number(value, DIGITS));
        Some(format!(
            ": {given} at worst, where at most {most} is allowed"
        ))
    }

    /// The law that most of the wrong samples follow on both halves, and its share.
    fn law(&self) -> Option<(PartLaw, f64)> {
        if self.wrong.len() < LEAST {
            return None;
        }
        let fitting: Vec<&Sample> = self.wrong.iter().filter(|it| it.fits).copied().collect();
        let step = fitting.len().div_ceil(MOST_SEARCHED).max(1);
        let few: Vec<&Sample> = fitting.iter().step_by(step).copied().collect();
        let law = best(&few, self.part)?;
        let share = |fits: bool| {
            let half = self.wrong.iter().filter(|it| it.fits == fits).copied();
            share_of(&law, self.part, half)
        };
        let (fitted, tested) = (share(true)?, share(false)?);
        let share = fitted.min(tested);
        // If a golden only limits a part, many values are right, so it says nothing that some
        // answers have the same one.
        let is_always = matches!(law, PartLaw::Whole(law::Law::Always(_)));
        let is_limited = self.wrong.iter().any(|it| it.is_limited(self.part));
        let least = match is_always && is_limited {
            true => ALL,
            false => LEAST_SHARE,
        };
        // If only a few samples follow the law, don't report it: their share is too uncertain, and
        // a few may agree with another answer by chance.
        let follow = share * self.wrong.len() as f64;
        let is_other = matches!(law, PartLaw::Whole(law::Law::Other(_)));
        let is_known = follow >= 2.0 * LEAST as f64 || share >= ALL && !is_other;
        (share >= least && is_known && (fitted - tested).abs() <= 0.1).then_some((law, share))
    }
}

impl Measurement {
    /// Whether its sentence is also true of other questions.
    pub fn holds(&self, films: &[QuestionsAndAnswers<'_>]) -> bool {
        self.claim.holds(films)
    }
}

fn capital(words: &str) -> String {
    // A variable's letter is not capitalised.
    match words.split_once(' ') {
        Some(("the", rest)) => format!("The {rest}"),
        _ => words.into(),
    }
}

#[cfg(test)]
mod tests;
