//! The worst question of a film in words.

use pinhole::ask::Reply;
use pinhole::judge::Verdict;
use pinhole::report::digits_to_tell;
use pinhole::words::number;

use crate::goldens::questions::QuestionFilm;

/// The worst question of a verdict: what was asked, expected, and given.
///
/// `None` if the verdict passes, or is on a scene.
pub fn worst(verdict: &Verdict, asked: &QuestionFilm, reply: &Reply) -> Option<String> {
    let questions = asked.job.questions()?;
    let channel = verdict
        .channels
        .iter()
        .find(|channel| channel.failing > 0)?;
    let mismatch = channel.worst?;
    let index = verdict.resolution.index(mismatch.pixel);
    let digits = digits_to_tell(&mismatch);
    let answer = |answer| questions.describe_answer(index, &answer, digits);
    let question = questions.describe(index, &asked.name, digits);
    let expected = answer(questions.expected(asked.golden.film(), index));
    let got = match reply.answers.get(index).copied().flatten() {
        Some(got) => answer(got),
        None => "nothing".into(),
    };
    let mut words = format!("{question}\nexpected  {expected}\ngot       {got}");
    // An object is right or wrong; for all else it helps to see how near is near enough.
    if channel.name != "id" {
        let allowed = number(f64::from(mismatch.allowed), 2);
        words.push_str(&format!("\nallowed   {} ± {allowed}", channel.name));
    }
    Some(words)
}
