//! Makes strips: has each mistake cast the scene that shows it best, and lays three
//! pictures side by side.

use std::time::Duration;

use image::{Rgb, RgbImage};
use pinhole::ask::Ending;
use pinhole::film::HIT_CHANNELS;
use pinhole::job::Job;
use pinhole::judge::Golden;
use pinhole::{Film, Scene, false_colour};
use pinhole_course::assignment::Assignment;
use pinhole_course::checkout::Checkout;
use pinhole_course::compile::Compiler;
use pinhole_course::diagnosis::known::KnownMistakes;
use pinhole_course::mistake::{self, MistakeFolder};
use pinhole_course::sandbox::{Limits, Sandbox};
use pinhole_course::{examine, overlay};

use super::Told;
use crate::course::{assignment, golden};
use crate::error::{Error, Problem, Result};

/// The strip of each mistake; `None` if it shows in no scene.
pub type Strips = Vec<(String, Option<Strip>)>;

/// A strip, and what is told of it.
pub struct Strip {
    /// See [`Told`].
    pub told: Told,
    /// The file.
    pub png: Vec<u8>,
}

/// Pixels between two pictures.
const GAP: u32 = 4;

/// No mistake casts longer.
const WALL: Duration = Duration::from_secs(30);

/// The strips of all mistakes, or of those named.
pub fn strips(slugs: &[String], checkout: &Checkout) -> Result<Strips> {
    let assignment = assignment(checkout)?;
    let known = KnownMistakes::read(&golden(checkout))?;
    let compiler = Compiler::new(&assignment, checkout, &Sandbox::Trusted)?;
    let mut strips = Vec::new();
    for mistake in mistake::read_all(&assignment)? {
        let slug = &mistake.slug;
        if !mistake.mistake.is_single() || !(slugs.is_empty() || slugs.contains(slug)) {
            continue;
        }
        let strip = match best(slug, &assignment, &known, checkout)? {
            None => None,
            Some((name, golden)) => {
                let scene = Scene::read(&assignment.scene(name))?;
                let depth_per_t = scene.camera.depth_per_t();
                let film = film(&mistake, scene, &compiler, &assignment, checkout)?;
                Some(strip(name, &golden, &film, depth_per_t)?)
            }
        };
        strips.push((mistake.slug, strip));
    }
    Ok(strips)
}

/// The scene that shows a mistake best, and its golden.
fn best<'a>(
    slug: &str,
    assignment: &'a Assignment,
    known: &KnownMistakes,
    checkout: &Checkout,
) -> Result<Option<(&'a str, Golden)>> {
    let mut shows = Vec::new();
    for scene in &assignment.scenes {
        let film = known.films.get(&scene.name);
        if let Some(pixels) = film.and_then(|film| film.get(slug)) {
            let golden = Golden::read(&golden(checkout).join(format!("{}.exr", scene.name)))?;
            let all = golden.film().resolution().pixels();
            // Best where much is wrong, and enough is right to see that it is this scene.
            let share = *pixels as f64 / all as f64;
            let merit = if share <= 0.6 { share } else { 0.6 - share };
            shows.push((merit, scene.name.as_str(), golden));
        }
    }
    shows.sort_by(|one, other| other.0.total_cmp(&one.0));
    let best = shows.into_iter().next();
    Ok(best.map(|(_, scene, golden)| (scene, golden)))
}

/// What somebody with this mistake casts.
fn film(
    mistake: &MistakeFolder,
    scene: Scene,
    compiler: &Compiler,
    assignment: &Assignment,
    checkout: &Checkout,
) -> Result<Film> {
    let submission = overlay::reference(assignment)?.overlaid(&mistake.folder)?;
    let program = compiler.compile(&submission)?;
    let resolution = scene.resolution;
    let limits = Limits::of_answers(WALL);
    let job = Job::Film(scene);
    let reply = examine::run(&program, &Sandbox::Trusted, &limits, &job, &mut |_| {})?;
    if reply.ending != Ending::Complete {
        let problem = format!("it casts no film: {:?}", reply.ending);
        let remedy = "make what is known again: cargo pinhole golden mistakes";
        return Err(Problem::of(checkout.inside(&mistake.folder), problem, remedy).into());
    }
    Ok(reply.film(resolution))
}

/// Expected, theirs, difference, in the picture that shows the difference.
pub fn strip(scene: &str, golden: &Golden, film: &Film, depth_per_t: f64) -> Result<Strip> {
    let [ids, ts, xs, ys, zs] = HIT_CHANNELS.map(|channel| golden.missed(film, channel));
    let all = film.resolution().pixels();
    let count = |wrong: &dyn Fn(usize) -> bool| (0..all).filter(|at| wrong(*at)).count();
    let objects = count(&|at| ids[at]);
    let depths = count(&|at| !ids[at] && ts[at]);
    let pixels = count(&|at| ids[at] || ts[at] || xs[at] || ys[at] || zs[at]);
    let normals = pixels - objects - depths;
    let range = false_colour::depth_range(golden.film(), depth_per_t);
    let most = objects.max(depths).max(normals);
    let picture = match most {
        most if most == objects => "id",
        most if most == depths => "depth",
        _ => "normal",
    };
    let draw = |film| match picture {
        "id" => false_colour::id(film),
        "depth" => false_colour::depth(film, depth_per_t, range.clone()),
        _ => false_colour::normal(film),
    };
    let pictures = [
        draw(golden.film()),
        draw(film),
        false_colour::difference(golden, film),
    ];
    Ok(Strip {
        told: Told {
            scene: scene.into(),
            picture: picture.into(),
            pixels,
            of: all,
        },
        png: png(&beside(&pictures, GAP))?,
    })
}

/// Pictures of the same height beside each other, on white.
pub fn beside(pictures: &[RgbImage], gap: u32) -> RgbImage {
    let height = pictures.iter().map(RgbImage::height).max().unwrap_or(0);
    let width: u32 = pictures.iter().map(RgbImage::width).sum();
    let width = width + gap * (pictures.len() as u32).saturating_sub(1);
    let mut all = RgbImage::from_pixel(width, height, Rgb([255; 3]));
    let mut x = 0;
    for picture in pictures {
        image::imageops::replace(&mut all, picture, x.into(), 0);
        x += picture.width() + gap;
    }
    all
}

/// Pictures of the same width below each other, on white.
pub fn stacked(pictures: &[RgbImage], gap: u32) -> RgbImage {
    let turned: Vec<RgbImage> = pictures.iter().map(image::imageops::rotate90).collect();
    image::imageops::rotate270(&beside(&turned.into_iter().rev().collect::<Vec<_>>(), gap))
}

/// The picture as a PNG file.
pub fn png(picture: &RgbImage) -> Result<Vec<u8>> {
    let mut file = std::io::Cursor::new(Vec::new());
    picture
        .write_to(&mut file, image::ImageFormat::Png)
        .map_err(|error| Error::environment(format!("no PNG: {error}"), "report this"))?;
    Ok(file.into_inner())
}
