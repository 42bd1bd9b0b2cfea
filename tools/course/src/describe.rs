//! Describes the worst question of a film in words.

use pinhole::Fact;
use pinhole::ask::{Ending, Reply};
use pinhole::film::TESTS;
use pinhole::heat_map::sum;
use pinhole::judge::{ChannelVerdict, Mismatch, Refusal, Verdict};
use pinhole::report::digits_to_tell;
use pinhole::words::number;

use crate::goldens::questions::QuestionFilm;

/// The first channel that is wrong, and where it is worst.
pub fn worst_of(verdict: &Verdict) -> Option<(&ChannelVerdict, Mismatch)> {
    let mut channels = verdict.channels.iter();
    channels.find_map(|channel| Some((channel, channel.worst?)))
}

/// The worst question of a verdict: what was asked, expected, and given.
///
/// Empty if the verdict passes, or is about a scene.
pub fn worst(verdict: &Verdict, asked: &QuestionFilm, reply: &Reply) -> Vec<Fact> {
    let (Some(questions), Some((channel, mismatch))) = (asked.job.questions(), worst_of(verdict))
    else {
        return Vec::new();
    };
    if channel.name == TESTS {
        return vec![Fact::new("tests", work(mismatch, asked, reply))];
    }
    let index = verdict.resolution.index(mismatch.pixel);
    let digits = digits_to_tell(&mismatch);
    let answer = |answer| questions.describe_answer(index, &answer, digits);
    let mut facts = questions.describe(index, &asked.name, digits);
    let expected = answer(questions.expected(asked.golden.film(), index));
    let got = match reply.answers.get(index).copied().flatten() {
        Some(got) => answer(got),
        None => "nothing".into(),
    };
    facts.extend([Fact::new("expected", expected), Fact::new("got", got)]);
    // An object is either right or wrong. All other channels have a tolerance, so show it too.
    if channel.name != "id" {
        let parts = questions.parts(index, &questions.expected(asked.golden.film(), index));
        let mut limits = parts.iter().flatten().filter(|part| part.is_limit);
        let limit = limits.find(|part| part.channels.contains(&channel.name.as_str()));
        let allowed = number(f64::from(mismatch.allowed), 2);
        let allowed = match limit {
            Some(part) => format!("{}: at most {allowed}", part.name),
            None if mismatch.allowed == 0.0 => format!("{}: exactly this number", channel.name),
            None => format!("{} ± {allowed}", channel.name),
        };
        facts.push(Fact::new("allowed", allowed));
    }
    facts
}

/// How many tests were counted, for one question and for all together.
fn work(mismatch: Mismatch, asked: &QuestionFilm, reply: &Reply) -> String {
    let golden = &asked.golden;
    let least = golden.film().channel(TESTS).unwrap_or_default().iter();
    let counts = reply.tests.iter().map(|&count| f64::from(count));
    let apart: f64 = counts
        .zip(least)
        .map(|(count, &least)| (count - f64::from(least)).abs())
        .sum();
    format!(
        "{} for one ray, where {} are enough; over all rays, the differences add up to \
         {apart:.0}, and at most {:.0} is allowed",
        mismatch.got,
        mismatch.expected,
        sum(golden.tolerance())
    )
}

/// The first question whose answer is not a finite number, and what was given. Empty if the film
/// was refused for another reason.
pub fn refused(refusal: &Refusal, asked: &QuestionFilm, reply: &Reply) -> Vec<Fact> {
    let (Some(questions), Refusal::NotFinite { pixel, .. }) = (asked.job.questions(), refusal)
    else {
        return Vec::new();
    };
    let index = asked.resolution.index(*pixel);
    let mut facts = questions.describe(index, &asked.name, DIGITS);
    let answer = |answer| questions.describe_answer(index, &answer, DIGITS);
    let expected = answer(questions.expected(asked.golden.film(), index));
    facts.push(Fact::new("expected", expected));
    let got = reply.answers.get(index).copied().flatten();
    facts.extend(got.map(|got| Fact::new("got", answer(got))));
    facts.push(Fact::new(
        "note",
        "0 / 0, ∞ − ∞ and the square root of a negative number are NaN; any other number / 0 is infinite",
    ));
    facts
}

/// The question that an answer did not get past: it panicked there, ended its process, or was still
/// working when its time was up. Empty if that is unknown, or the answer is still `todo!`.
pub fn unanswered(asked: &QuestionFilm, reply: &Reply) -> Vec<Fact> {
    let (index, note) = match &reply.ending {
        Ending::Panicked(panic) if !panic.is_unanswered() => (Some(panic.index), None),
        Ending::TimedOut(_) => (
            reply.still_at,
            Some(
                "your code was still working on this question; do its loops and recursive \
                 calls end?",
            ),
        ),
        Ending::Died(_) => (reply.still_at, None),
        _ => (None, None),
    };
    match (index, asked.job.questions()) {
        (Some(index), Some(questions)) if index < questions.len() => {
            let mut facts = questions.describe(index, &asked.name, DIGITS);
            facts.extend(note.map(|note| Fact::new("note", note)));
            facts
        }
        _ => Vec::new(),
    }
}

/// How many digits of a question's numbers to show if there is no wrong answer to compare.
const DIGITS: usize = 6;
