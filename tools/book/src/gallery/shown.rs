//! A gallery as a page shows it.

use std::cmp::Reverse;

use super::Told;
use super::kept::list;
use crate::checkout::Checkout;
use crate::course::{Mistake, SOLUTIONS_COUNTED, mistakes};
use crate::error::{Error, Wrong};
use crate::html::escaped;

/// So many stand open; the others are folded.
const OPEN: usize = 4;

/// HTML of a task's gallery: the mistakes made most often, then all others, folded.
pub fn shown(task: &str, to_root: &str, checkout: &Checkout) -> std::result::Result<String, Wrong> {
    let remedy = "make it: cargo run --release -p pinhole-book -- gallery";
    let wrong = |error: Error| (error.to_string(), remedy.to_owned());
    let list = list(checkout);
    let all = mistakes(checkout).map_err(wrong)?;
    let mut own: Vec<(&String, &Mistake, Option<&Told>)> = all
        .iter()
        .filter(|(_, mistake)| {
            mistake.beliefs.is_empty() && mistake.fails.iter().any(|own| own == task)
        })
        .map(|(slug, mistake)| (slug, mistake, list.get(slug)))
        .collect();
    if own.iter().all(|(_, _, told)| told.is_none()) {
        return Err((
            format!("the gallery of {task} was never made"),
            remedy.into(),
        ));
    }
    // What was met most often first; of those never counted, what shows in most pixels.
    own.sort_by_key(|(slug, mistake, told)| {
        let share = told.map_or(0, |told| told.pixels * 1000 / told.of);
        (
            Reverse((told.is_some(), mistake.submissions, share)),
            (*slug).clone(),
        )
    });
    let one = |(slug, mistake, told): &(&String, &Mistake, Option<&Told>)| {
        one(slug, mistake, *told, to_root)
    };
    let (open, folded) = own.split_at(OPEN.min(own.len()));
    let open: String = open.iter().map(one).collect();
    let count = folded.len();
    let folded: String = folded.iter().map(one).collect();
    Ok(format!(
        "<div class=\"gallery\">\n{open}<details><summary>{count} more, less often \
         seen</summary>\n{folded}</details>\n</div>\n"
    ))
}

fn one(slug: &str, mistake: &Mistake, told: Option<&Told>, to_root: &str) -> String {
    let belief = escaped(&mistake.belief);
    let often = match mistake.submissions {
        Some(count) => format!(" Seen in {count} of {SOLUTIONS_COUNTED} solutions."),
        None => String::new(),
    };
    let read = escaped(&mistake.hint.read);
    let reading = format!("Read “{read}” in {}.{often}", escaped(&mistake.chapter));
    let Some(Told {
        scene,
        picture,
        pixels,
        of,
    }) = told
    else {
        return format!(
            "<figure class=\"mistake\" id=\"{slug}\"><figcaption>You may believe: “{belief}” No scene \
             shows it: questions do. {reading}</figcaption></figure>\n"
        );
    };
    let alternative = format!(
        "Scene {scene} as {picture} picture: as expected, as somebody with this belief casts it, and \
         the {pixels} of {of} pixels that differ"
    );
    format!(
        "<figure class=\"mistake\" id=\"{slug}\">\
         <div class=\"heads\" aria-hidden=\"true\"><span>expected</span><span>theirs</span>\
         <span>difference</span></div>\
         <img src=\"{to_root}gallery/{slug}.png\" alt=\"{alternative}\" loading=\"lazy\">\
         <figcaption>You may believe: “{belief}” <span class=\"where\"><code>{scene}</code>, {picture}: \
         {pixels} of {of} pixels. {reading}</span></figcaption></figure>\n"
    )
}
