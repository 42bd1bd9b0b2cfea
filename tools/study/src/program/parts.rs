//! Parts that are asked for by themselves.

use std::fs;
use std::io::Write;
use std::path::Path;

use indicatif::{ProgressBar, ProgressStyle};
use pinhole::{Resolution, Scene};
use pinhole_study::film;
use pinhole_study::judge::rule_of_three;
use pinhole_study::plan::told::told;
use pinhole_study::plan::{Wish, plan};
use pinhole_study::record::{self, Count, Hardness, Leaks};
use pinhole_study::run::Extent;
use pinhole_study::theirs::asked;
use serde_json::json;

/// A scene file, at another resolution if one is given.
fn read(file: &Path, resolution: &[usize]) -> Result<Scene, String> {
    let mut scene = Scene::read(file).map_err(|error| error.to_string())?;
    if let [n_x, n_y] = *resolution {
        scene.resolution = Resolution { n_x, n_y };
    }
    Ok(scene)
}

/// Casts a film, exactly or as planned, and says on standard output what that took, as
/// JSON.
pub fn cast(
    file: &Path,
    resolution: &[usize],
    wish: Option<Wish>,
    to: &Path,
) -> Result<(), String> {
    let scene = read(file, resolution)?;
    let report = match wish {
        None => json!(film::exact(&scene, to).map_err(|error| error.to_string())?),
        Some(wish) => json!(film::planned(&scene, wish, to)?),
    };
    println!("{report}");
    Ok(())
}

/// Plans, and says what and why.
pub fn tell(file: &Path, resolution: &[usize], wish: Wish, is_json: bool) -> Result<(), String> {
    let scene = read(file, resolution)?;
    let (plan, _) = plan(&scene, wish)?;
    let name = file.file_stem().unwrap_or_default().to_string_lossy();
    match is_json {
        true => println!("{:#}", json!(plan)),
        false => print!("{}", told(&plan, &name)),
    }
    Ok(())
}

/// Writes what a student's code is asked.
pub fn questions(file: &Path, seed: u64) -> Result<(), String> {
    let asked = asked(Extent::QUICK.questions, seed).map_err(|error| error.to_string())?;
    let bytes = postcard::to_stdvec(&asked).map_err(|error| error.to_string())?;
    fs::write(file, bytes).map_err(|error| format!("cannot write {}: {error}", file.display()))
}

/// The long runs; whether nothing was wrong.
pub fn record(random: u64, adversarial: u64, edges: u64, seed: u64) -> bool {
    let mut is_well = true;
    for (name, hardness, count) in [
        ("random", Hardness::Random, random),
        ("adversarial", Hardness::Adversarial, adversarial),
    ] {
        is_well &= count == 0 || decisions(name, hardness, count, seed);
    }
    is_well &= edges == 0 || leaks(edges, seed);
    say("camera rays, as computed and as rounded once (apart from all above):");
    for camera in record::cameras() {
        say(&format!(
            "{}: up to {:.1e} rad and {:.1e} of the origin apart; {} of {} pixels change",
            camera.scene, camera.angle, camera.origin, camera.changed, camera.pixels
        ));
    }
    is_well
}

fn decisions(name: &str, hardness: Hardness, count: u64, seed: u64) -> bool {
    let bar = bar(name, count);
    let Count { asked, wrong } = record::decisions(hardness, count, seed, &|n| bar.inc(n));
    bar.finish_and_clear();
    say(&format!(
        "{name}: {wrong} wrong decisions in {asked}{}",
        bound(wrong, asked)
    ));
    wrong == 0
}

fn leaks(edges: u64, seed: u64) -> bool {
    let bar = bar("edges and vertices", 2 * edges);
    let Leaks {
        rays,
        leaks,
        double_hits,
        fallbacks,
    } = record::leaks(edges, seed, &|n| bar.inc(n));
    bar.finish_and_clear();
    say(&format!(
        "edges and vertices: {leaks} leaks, {double_hits} double hits in {rays} rays{}; \
         {fallbacks} tests were decided in exact numbers",
        bound(leaks + double_hits, rays)
    ));
    leaks + double_hits == 0
}

/// A line as soon as it is known. Whoever stops reading wants no more, and a long run does
/// not end for that.
fn say(line: &str) {
    let _ = writeln!(std::io::stdout(), "{line}");
}

/// How far a long run is, for who looks at it.
fn bar(name: &str, count: u64) -> ProgressBar {
    let style = "{msg}: {human_pos} of {human_len}, {eta} to go";
    let style = ProgressStyle::with_template(style).expect("it is well-formed");
    ProgressBar::new(count)
        .with_style(style)
        .with_message(name.to_owned())
}

/// What a count of 0 says of the rate.
fn bound(wrong: u64, asked: u64) -> String {
    match wrong {
        0 => format!(" (below {:.1e} with 95 % confidence)", rule_of_three(asked)),
        _ => String::new(),
    }
}
