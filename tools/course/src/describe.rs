//! The worst question of a film in words.

use pinhole::Fact;
use pinhole::ask::Reply;
use pinhole::judge::Verdict;
use pinhole::report::digits_to_tell;
use pinhole::words::number;

use crate::goldens::questions::QuestionFilm;

/// The worst question of a verdict: what was asked, expected, and given.
///
/// Nothing if the verdict passes, or is on a scene.
pub fn worst(verdict: &Verdict, asked: &QuestionFilm, reply: &Reply) -> Vec<Fact> {
    let mut channels = verdict.channels.iter();
    let worst = channels.find_map(|channel| Some((channel, channel.worst?)));
    let (Some(questions), Some((channel, mismatch))) = (asked.job.questions(), worst) else {
        return Vec::new();
    };
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
    // An object is right or wrong; for all else it helps to see how near is near enough.
    if channel.name != "id" {
        let allowed = number(f64::from(mismatch.allowed), 2);
        let allowed = format!("{} ± {allowed}", channel.name);
        facts.push(Fact::new("allowed", allowed));
    }
    facts
}
