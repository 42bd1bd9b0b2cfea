//! A scene, or any film beside its golden, on the page.

use image::RgbImage;
use image::imageops::crop_imm;
use pinhole::film::HIT_CHANNELS;
use pinhole::judge::{ChannelVerdict, Golden, Verdict};
use pinhole::{Film, Pixel, Scene, false_colour};
use serde::Serialize;
use serde_json::json;

use super::belief::Beliefs;
use super::cause::{Cause, PixelCauses};
use super::heat::HeatMaps;
use super::page::{class, for_script};
use super::picture;
use super::pixels;
use super::rays::{RayGrid, SubmittedRays};
use super::window::{self, Window};
use crate::terminal;

/// What the page shows of a film.
pub struct Evidence<'a> {
    pub name: String,
    pub passes: bool,
    /// The verdict in a line.
    pub said: String,
    /// Whether an attempt was made to cast it.
    pub attempted: bool,
    /// Points earned and possible, if it has any.
    pub points: Option<(u32, u32)>,
    /// None if the film can't be compared, or there is no film.
    pub verdict: Option<&'a Verdict>,
    pub golden: &'a Golden,
    pub film: Option<&'a Film>,
    /// How many tests its pixels took, if that is known.
    pub heat: Option<HeatMaps>,
    /// The scene that the film shows, if it is known.
    pub scene: Option<&'a Scene>,
    /// A pixel without a usable answer.
    pub unanswered: Option<Pixel>,
    pub rays: Option<RayGrid>,
    pub own_rays: SubmittedRays,
    pub beliefs: Option<Beliefs>,
    /// What is remarkable in answers that pass their tasks.
    pub remarks: Vec<String>,
    /// The command that repeats this.
    pub command: String,
    /// The command that explains a pixel, in two parts: what comes before the pixel's column, and
    /// what comes after its row.
    pub explain: Option<[String; 2]>,
}

/// A film on the page.
#[derive(Debug, Serialize)]
pub struct SceneSection {
    /// The page's own id for it, because a file's name could break a link.
    pub id: String,
    pub name: String,
    pub passes: bool,
    pub points: Option<(u32, u32)>,
    pub said: String,
    pub attempted: bool,
    /// One line for each channel that fails.
    pub channels: Vec<String>,
    pub causes: Vec<CauseRow>,
    /// Which part of a large film is shown.
    pub cut: Option<String>,
    /// What the pictures show.
    pub view: View,
    /// Addresses of the pictures.
    pub expected: Option<String>,
    pub yours: Option<String>,
    pub difference: Option<String>,
    pub heat: Option<HeatMaps>,
    /// What the script needs, safe inside a `script` element; none if there is nothing
    /// to compare.
    pub viewer: Option<String>,
    pub beliefs: Option<Beliefs>,
    pub remarks: Vec<String>,
    pub command: String,
    /// The command that explains the worst pixel.
    pub explain: Option<String>,
}

/// The failing pixels of one cause.
#[derive(Debug, Serialize)]
pub struct CauseRow {
    /// The cause's number in the packed pixels.
    pub code: usize,
    pub words: &'static str,
    pub pixels: usize,
    /// The class of its colour.
    pub colour: &'static str,
}

/// One of the three ways to see a film of hits.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum View {
    Id,
    Depth,
    Normal,
}

impl SceneSection {
    /// The `k`-th film, with all numbers of at most this many of its pixels.
    pub fn of(k: usize, evidence: Evidence, most: usize) -> SceneSection {
        let golden = evidence.golden.film();
        let film = evidence.film.filter(|film| shows_hits(film));
        let comparable = film.filter(|film| {
            shows_hits(golden) && film.resolution() == golden.resolution() && !evidence.passes
        });
        let wrong = comparable.map(|film| PixelCauses::between(evidence.golden, film));
        let start = start(&evidence, wrong.as_ref());
        let window = Window::around(
            start,
            golden.resolution(),
            window::share(golden.resolution(), most),
        );
        let view = match evidence.verdict.and_then(worst_pixel) {
            Some((channel, _)) => View::of(&channel.name),
            None => View::Normal,
        };
        let depth_per_t = evidence
            .scene
            .map_or(1.0, |scene| scene.camera.depth_per_t());
        let range = match shows_hits(golden) {
            true => false_colour::depth_range(golden, depth_per_t),
            false => 0.0..1.0,
        };
        let still = |film: &Film| {
            let whole = match view {
                View::Id => false_colour::id(film),
                View::Depth => false_colour::depth(film, depth_per_t, range.clone()),
                View::Normal => false_colour::normal(film),
            };
            picture::address(&cut(
                &whole,
                window,
                film.resolution() == golden.resolution(),
            ))
        };
        let viewer = wrong.as_ref().zip(comparable).map(|(wrong, film)| {
            let objects = evidence.scene.map(|scene| {
                let words = scene.objects.iter().map(|shape| shape.describe(6));
                words.collect::<Vec<_>>()
            });
            for_script(&json!({
                "film": golden.resolution(),
                "window": window,
                "start": [start.i, start.j],
                "view": view,
                "depth": { "per_t": depth_per_t, "near": range.start, "far": range.end },
                "objects": objects.unwrap_or_default(),
                "min_t": evidence.scene.map(|scene| scene.min_t),
                "rays": evidence.rays,
                "own_rays": evidence.own_rays,
                "explain": evidence.explain,
                "pixels": pixels::pack(evidence.golden, film, wrong, window),
            }))
        });
        SceneSection {
            id: format!("scene-{k}"),
            passes: evidence.passes,
            points: evidence.points,
            said: evidence.said,
            attempted: evidence.attempted,
            channels: evidence.verdict.map(failing_channels).unwrap_or_default(),
            causes: wrong.as_ref().map(cause_rows).unwrap_or_default(),
            cut: (!window.is_whole(golden.resolution())).then(|| {
                let (last, bottom) = (
                    window.left + window.n_x - 1,
                    golden.resolution().n_y - window.top - window.n_y,
                );
                format!(
                    "The film is too large to show all of it. These are columns {} to {last} and \
                     rows {bottom} to {} of {}, around the worst pixel.",
                    window.left,
                    bottom + window.n_y - 1,
                    golden.resolution(),
                )
            }),
            view,
            expected: shows_hits(golden).then(|| still(golden)),
            yours: film.filter(|_| !evidence.passes).map(still),
            difference: comparable.map(|film| {
                let whole = false_colour::difference(evidence.golden, film);
                picture::address(&cut(&whole, window, true))
            }),
            heat: evidence.heat,
            viewer,
            beliefs: evidence.beliefs,
            remarks: evidence.remarks,
            command: evidence.command,
            explain: evidence
                .explain
                .filter(|_| comparable.is_some() || evidence.unanswered.is_some())
                .map(|[before, after]| format!("{before} {} {}{after}", start.i, start.j)),
            name: evidence.name,
        }
    }
}

impl View {
    /// The view that shows a channel.
    fn of(channel: &str) -> View {
        match channel {
            "id" => View::Id,
            "t" => View::Depth,
            _ => View::Normal,
        }
    }
}

fn shows_hits(film: &Film) -> bool {
    HIT_CHANNELS.iter().all(|name| film.channel(name).is_some())
}

fn worst_pixel(verdict: &Verdict) -> Option<(&ChannelVerdict, Pixel)> {
    terminal::worst_pixel(&verdict.channels)
}

/// The pixel to look at first.
fn start(evidence: &Evidence, wrong: Option<&PixelCauses>) -> Pixel {
    let worst = evidence
        .verdict
        .and_then(worst_pixel)
        .map(|(_, pixel)| pixel);
    let first = || {
        let failing = wrong?.causes.iter().position(Option::is_some)?;
        Some(evidence.golden.film().resolution().pixel(failing))
    };
    let unanswered = evidence.unanswered;
    worst
        .or(unanswered)
        .or_else(first)
        .unwrap_or(Pixel { i: 0, j: 0 })
}

fn cut(whole: &RgbImage, window: Window, fits: bool) -> RgbImage {
    let [left, top, n_x, n_y] = [window.left, window.top, window.n_x, window.n_y].map(|n| n as u32);
    match fits {
        true => crop_imm(whole, left, top, n_x, n_y).to_image(),
        // If the film's size differs from its golden's, show both from the same corner.
        false => crop_imm(
            whole,
            0,
            0,
            whole.width().min(n_x.max(320)),
            whole.height().min(n_y.max(320)),
        )
        .to_image(),
    }
}

fn failing_channels(verdict: &Verdict) -> Vec<String> {
    let failing = verdict
        .channels
        .iter()
        .filter(|channel| channel.failing > 0);
    failing.map(|channel| channel.to_string()).collect()
}

fn cause_rows(wrong: &PixelCauses) -> Vec<CauseRow> {
    let rows = Cause::ALL
        .into_iter()
        .enumerate()
        .map(|(place, cause)| CauseRow {
            code: place + 1,
            words: cause.words(),
            pixels: wrong.count(cause),
            colour: cause.difference().map_or("any", class),
        });
    rows.filter(|row| row.pixels > 0).collect()
}
