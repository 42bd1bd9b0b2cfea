//! Describes the worst question of a film in words.

use pinhole::ask::{Ending, Reply};
use pinhole::film::TESTS;
use pinhole::heat_map::sum;
use pinhole::judge::{ChannelVerdict, Mismatch, Refusal, Verdict};
use pinhole::report::digits_to_tell;
use pinhole::words::number;
use pinhole::{Fact, Pixel, Resolution};

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
    facts.push(Fact::new(NOTE, NOT_FINITE));
    facts
}

/// The label of a hint about an answer that failed.
pub const NOTE: &str = "note";

const NOT_FINITE: &str = "0 / 0, ∞ − ∞ and the square root of a negative number are NaN; any \
                          other number / 0 is infinite";

const STILL_WORKING: &str = "your code was still working on this; do its loops and recursive calls \
                             end?";

/// The question that an answer did not get past: it panicked there, ended its process, or was still
/// working when its time was up. Empty if that is unknown, or the answer is still `todo!`.
pub fn unanswered(asked: &QuestionFilm, reply: &Reply) -> Vec<Fact> {
    match (stopped_at(reply), asked.job.questions()) {
        (Some((index, note)), Some(questions)) if index < questions.len() => {
            let mut facts = questions.describe(index, &asked.name, DIGITS);
            facts.extend(note.map(|note| Fact::new(NOTE, note)));
            facts
        }
        _ => Vec::new(),
    }
}

/// A pixel without a usable answer: the code panicked there, ended its process, was still working
/// when its time was up, or gave a number that is not finite.
#[derive(Clone, Copy, Debug)]
pub struct UnansweredPixel {
    /// The pixel.
    pub pixel: Pixel,
    /// A hint.
    pub note: Option<&'static str>,
}

/// The first pixel of a scene without a usable answer, if that is known.
pub fn unanswered_pixel(
    reply: &Reply,
    judged: Option<&Result<Verdict, Refusal>>,
    resolution: Resolution,
) -> Option<UnansweredPixel> {
    match judged {
        Some(Err(Refusal::NotFinite { pixel, .. })) => Some(UnansweredPixel {
            pixel: *pixel,
            note: Some(NOT_FINITE),
        }),
        Some(_) => None,
        None => stopped_at(reply).map(|(index, note)| UnansweredPixel {
            pixel: resolution.pixel(index),
            note,
        }),
    }
}

/// The place of the question that an answer did not get past, and a hint.
fn stopped_at(reply: &Reply) -> Option<(usize, Option<&'static str>)> {
    match &reply.ending {
        Ending::Panicked(panic) if !panic.is_unanswered() => {
            Some((panic.index, panic_note(&panic.message)))
        }
        Ending::TimedOut(_) => Some((reply.still_at?, Some(STILL_WORKING))),
        Ending::Died(_) => Some((reply.still_at?, None)),
        _ => None,
    }
}

/// A hint about a panic that Rust itself words: it begins like this, or has these words in it.
fn panic_note(message: &str) -> Option<&'static str> {
    let notes = [
        (
            "on a `None` value",
            "this value can be `None`, for instance if nothing is hit; handle that case with `?`, \
             `if let` or `match`",
        ),
        (
            "on an `Err` value",
            "this value can be an error; handle that case with `if let` or `match`",
        ),
        (
            "index out of bounds",
            "the last index of a list is its length − 1, and an empty list has none",
        ),
        (
            "out of range for slice",
            "a range must end at the list's length or earlier",
        ),
        (
            "with overflow",
            "the result does not fit the integer's type: a `usize` cannot be negative, so convert \
             to `f64` before you subtract",
        ),
        (
            "attempt to divide by zero",
            "an integer can't be divided by 0; is it the length of an empty list?",
        ),
        (
            "with a divisor of zero",
            "an integer can't be divided by 0; is it the length of an empty list?",
        ),
    ];
    let note = notes.into_iter().find(|(words, _)| message.contains(words));
    note.map(|(_, note)| note)
}

/// How many digits of a question's numbers to show if there is no wrong answer to compare.
const DIGITS: usize = 6;

#[cfg(test)]
mod tests {
    use std::hint::black_box;
    use std::panic::catch_unwind;

    use super::panic_note;

    /// A hint about this panic.
    fn note_on<T>(panics: fn() -> T) -> Option<&'static str> {
        let panic = catch_unwind(|| drop(panics())).expect_err("it panics");
        let text = panic.downcast_ref::<String>().cloned();
        let text = text.or_else(|| panic.downcast_ref::<&str>().map(|it| (*it).to_owned()));
        panic_note(&text.expect("a panic has words"))
    }

    #[test]
    fn a_panic_that_rust_words_gets_a_hint_of_its_own() {
        let none = note_on(|| black_box(None::<f64>).unwrap());
        assert!(none.is_some_and(|note| note.contains("`None`")), "{none:?}");
        let error = note_on(|| black_box(Err::<f64, i32>(1)).unwrap());
        assert!(
            error.is_some_and(|note| note.contains("error")),
            "{error:?}"
        );
        let index = note_on(|| black_box(Vec::<f64>::new())[black_box(0)]);
        let range = note_on(|| black_box(vec![0.0])[..black_box(2)].len());
        for list in [index, range] {
            assert!(list.is_some_and(|note| note.contains("length")), "{list:?}");
        }
        let overflow = note_on(|| black_box(i32::MIN) / black_box(-1));
        assert!(
            overflow.is_some_and(|note| note.contains("fit")),
            "{overflow:?}"
        );
        let quotient = note_on(|| 1 / black_box(0));
        let remainder = note_on(|| 1 % black_box(0));
        for zero in [quotient, remainder] {
            assert!(zero.is_some_and(|note| note.contains("by 0")), "{zero:?}");
        }
        assert_eq!(note_on(|| panic!("the student's own words")), None);
    }
}
