//! The HTML of a task's gallery, for its chapter.

use std::cmp::Reverse;

use image::Rgb;
use pinhole::false_colour::Difference;
use pinhole_course::assignment::Assignment;
use pinhole_course::checkout::Checkout;
use pinhole_course::mistake::{self, Mistake, MistakeFolder};

use super::{StripSubject, list};
use crate::error::ProblemAndRemedy;
use crate::html::{escaped, heads, with_code};

/// How many mistakes are shown. The others are folded.
const OPEN: usize = 4;

/// HTML of a task's gallery: the most frequent mistakes, then all others, folded.
pub fn shown(
    task: &str,
    to_root: &str,
    assignment: &Assignment,
    checkout: &Checkout,
) -> Result<String, ProblemAndRemedy> {
    let list = list(checkout);
    let all = mistake::read_all(assignment).map_err(|error| (error.problem, error.remedy))?;
    let own = all.iter().filter(|MistakeFolder { mistake, .. }| {
        mistake.is_single() && mistake.fails.iter().any(|own| own == task)
    });
    let mut own: Vec<(&str, &Mistake, Option<&StripSubject>)> = own
        .map(|MistakeFolder { slug, mistake, .. }| (slug.as_str(), mistake, list.get(slug)))
        .collect();
    if own.iter().all(|(_, _, shown)| shown.is_none()) {
        let remedy = "make it: cargo pinhole book gallery";
        return Err((
            format!("the gallery of {task} was never made"),
            remedy.into(),
        ));
    }
    // Sort by how often students made a mistake. Mistakes that were never counted are sorted by
    // the number of wrong pixels.
    own.sort_by_key(|(slug, mistake, shown)| {
        let share = shown.map(|shown| shown.pixels * 1000 / shown.of);
        (Reverse((mistake.submissions, share)), *slug)
    });
    let figure = |(slug, mistake, shown): &(&str, &Mistake, Option<&StripSubject>)| {
        figure(slug, mistake, *shown, assignment.solutions_read, to_root)
    };
    let (open, folded) = own.split_at(OPEN.min(own.len()));
    let open: String = open.iter().map(figure).collect();
    let count = folded.len();
    let folded: String = folded.iter().map(figure).collect();
    Ok(format!(
        "<div class=\"gallery\">\n{}{open}<details><summary>{count} more, less often \
         seen</summary>\n{folded}</details>\n</div>\n",
        legend()
    ))
}

/// The legend for the colours of the third picture.
fn legend() -> String {
    let entry = |(kind, words): (Difference, &str)| {
        let Rgb([r, g, b]) = kind.colour();
        // The words begin with the colour's name, which the swatch shows.
        let words = words.split_once(": ").map_or(words, |(_, words)| words);
        format!("<li><span style=\"background: rgb({r} {g} {b})\"></span>{words}</li>")
    };
    let entries: String = Difference::LEGEND.map(entry).concat();
    format!("<ul class=\"legend\" aria-label=\"Colours of the differences\">{entries}</ul>\n")
}

fn figure(
    slug: &str,
    mistake: &Mistake,
    shown: Option<&StripSubject>,
    solutions_read: Option<u32>,
    to_root: &str,
) -> String {
    let belief = with_code(&mistake.belief);
    let often = match (mistake.submissions, solutions_read) {
        (Some(count), Some(all)) => format!(" Seen in {count} of {all} solutions."),
        _ => String::new(),
    };
    let read = escaped(&mistake.hint.read);
    let reading = format!("Read “{read}” in {}.{often}", escaped(&mistake.chapter));
    let Some(StripSubject {
        scene,
        view,
        pixels,
        of,
    }) = shown
    else {
        return format!(
            "<figure class=\"mistake\" id=\"{slug}\"><figcaption>You may believe: “{belief}” <span \
             class=\"where\">No scene shows it clearly, but questions do. {reading}</span></figcaption></figure>\n"
        );
    };
    let alternative = format!(
        "Three {view} pictures of scene {scene}: the expected one, one by code with this \
         mistake, and the {pixels} of {of} pixels that differ"
    );
    let heads = heads(&["expected", "yours", "difference"]);
    format!(
        "<figure class=\"mistake\" id=\"{slug}\">{heads}\
         <img src=\"{to_root}gallery/{slug}.png\" alt=\"{alternative}\" loading=\"lazy\">\
         <figcaption>You may believe: “{belief}” <span class=\"where\"><code>{scene}</code>, {view}: \
         {pixels} of {of} pixels differ. {reading}</span></figcaption></figure>\n"
    )
}
