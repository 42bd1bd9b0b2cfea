//! Runs the study: `pinhole study` is the way to it.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clap::{Parser, Subcommand};
use indicatif::ProgressBar;
use pinhole::Resolution;
use pinhole_study::family::Studied;
use pinhole_study::judge::rule_of_three;
use pinhole_study::provenance::provenance;
use pinhole_study::record::{self, Count, Hardness, Leaks};
use pinhole_study::result::{SCHEMA, Study};
use pinhole_study::run::{Extent, run};
use pinhole_study::shape::{Plane, Sphere, Triangle};
use pinhole_study::targets::targets;
use pinhole_study::{film, instructions, plots, summary};

/// Measure the trade between speed and accuracy, and the extremes.
///
/// Every way to intersect a sphere, a plane and a triangle is asked the same questions,
/// which get harder step by step, and judged by exact arithmetic. Writes study.json,
/// summary.md and plots as SVG; prints what was measured before, or promised, beside what
/// came. Exit 0 if all of that agrees but for times, which depend on the machine; else 1.
#[derive(Parser)]
#[command(
    name = "study",
    max_term_width = 100,
    args_conflicts_with_subcommands = true
)]
struct Arguments {
    #[command(subcommand)]
    part: Option<Part>,
    /// Ask fewer questions: less than a minute
    #[arg(long)]
    quick: bool,
    /// Where to write
    #[arg(long, value_name = "DIR", default_value = "study")]
    out: PathBuf,
    /// Print the document on standard output too
    #[arg(long)]
    json: bool,
    /// Only this family of questions (distance, surface, …), or mesh, scenes, spoilt or speed
    #[arg(long, value_name = "FAMILY")]
    only: Option<String>,
    /// What random questions come from
    #[arg(long, value_name = "N", default_value_t = 20_261_121)]
    seed: u64,
}

#[derive(Subcommand)]
enum Part {
    /// Cast one kernel's workload: what runs under callgrind
    #[command(hide = true)]
    Cast {
        shape: String,
        kernel: usize,
        casts: u32,
    },
    /// Ask exact casting as many questions as there is time for, and print what came
    ///
    /// The promise is for 100 million random and 10 million adversarial questions, and
    /// a billion rays at edges and vertices: many hours of a core, so choose.
    Record {
        /// Everyday questions
        #[arg(long, value_name = "N", default_value_t = 1_000_000)]
        random: u64,
        /// Questions at the extremes
        #[arg(long, value_name = "N", default_value_t = 1_000_000)]
        adversarial: u64,
        /// Rays at edges, and as many at vertices, of closed meshes
        #[arg(long, value_name = "N", default_value_t = 1_000_000)]
        edges: u64,
        /// What random questions come from
        #[arg(long, value_name = "N", default_value_t = 20_261_121)]
        seed: u64,
    },
    /// Cast a scene exactly into a film: what `pinhole render --exact` runs
    #[command(hide = true)]
    Film {
        scene: PathBuf,
        film: PathBuf,
        #[arg(long, num_args = 2, value_names = ["NX", "NY"])]
        resolution: Vec<usize>,
    },
}

/// The seed of workloads whose instructions are counted.
const WORKLOAD: u64 = 1;

fn main() -> ExitCode {
    let arguments = Arguments::parse();
    let done = match &arguments.part {
        None => studied(&arguments),
        Some(Part::Cast {
            shape,
            kernel,
            casts,
        }) => {
            instructions::cast(shape, *kernel, *casts, WORKLOAD);
            Ok(true)
        }
        Some(Part::Record {
            random,
            adversarial,
            edges,
            seed,
        }) => Ok(record(*random, *adversarial, *edges, *seed)),
        Some(Part::Film {
            scene,
            film,
            resolution,
        }) => cast(scene, resolution, film).map(|()| true),
    };
    match done {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::from(1),
        Err(problem) => {
            eprintln!("study: {problem}");
            ExitCode::from(2)
        }
    }
}

/// Casts a film, and says on standard output what that took, as JSON.
fn cast(scene: &Path, resolution: &[usize], to: &Path) -> Result<(), String> {
    let resolution = match resolution {
        [n_x, n_y] => Some(Resolution {
            n_x: *n_x,
            n_y: *n_y,
        }),
        _ => None,
    };
    let report = film::write(scene, resolution, to).map_err(|error| error.to_string())?;
    println!("{}", serde_json::json!(report));
    Ok(())
}

/// The long runs; whether nothing was wrong.
fn record(random: u64, adversarial: u64, edges: u64, seed: u64) -> bool {
    let mut is_well = true;
    for (name, hardness, count) in [
        ("random", Hardness::Random, random),
        ("adversarial", Hardness::Adversarial, adversarial),
    ] {
        let Count { asked, wrong } = record::decisions(hardness, count, seed);
        println!(
            "{name}: {wrong} wrong decisions in {asked}{}",
            bound(wrong, asked)
        );
        is_well &= wrong == 0;
    }
    let Leaks {
        rays,
        leaks,
        double_hits,
        lost_in_boxes,
    } = record::leaks(edges, seed);
    println!(
        "edges and vertices: {leaks} leaks, {double_hits} double hits, {lost_in_boxes} lost in \
         boxes, in {rays} rays{}",
        bound(leaks + double_hits + lost_in_boxes, rays)
    );
    is_well &= leaks + double_hits + lost_in_boxes == 0;
    println!("camera rays, as computed and as rounded once (apart from all above):");
    for camera in record::cameras() {
        println!(
            "{}: up to {:.1e} rad and {:.1e} of the origin apart; {} of {} pixels change",
            camera.scene, camera.angle, camera.origin, camera.changed, camera.pixels
        );
    }
    is_well
}

/// What a count of 0 says of the rate.
fn bound(wrong: u64, asked: u64) -> String {
    match wrong {
        0 => format!(" (below {:.1e} with 95 % confidence)", rule_of_three(asked)),
        _ => String::new(),
    }
}

fn studied(arguments: &Arguments) -> Result<bool, String> {
    let extent = if arguments.quick {
        Extent::QUICK
    } else {
        Extent::FULL
    };
    let bar = ProgressBar::new_spinner();
    bar.enable_steady_tick(std::time::Duration::from_millis(100));
    let say = |what: &str| match bar.is_hidden() {
        true => eprintln!("{what}"),
        false => bar.set_message(what.to_owned()),
    };
    let findings = run(&extent, arguments.seed, arguments.only.as_deref(), &say);
    bar.finish_and_clear();
    let targets = targets(&findings);
    let study = Study {
        schema: SCHEMA.into(),
        provenance: provenance(extent.name, arguments.seed),
        families: findings.families,
        meshes: findings.meshes,
        spoilt: findings.spoilt,
        speed: findings.speed,
        breaking: findings.breaking,
        scenes: findings.scenes,
        targets,
    };
    if study.families.is_empty()
        && study.meshes.is_empty()
        && study.spoilt.is_empty()
        && study.speed.is_empty()
        && study.scenes.is_empty()
    {
        let only = arguments.only.as_deref().unwrap_or_default();
        return Err(format!(
            "there is no family {only:?}\n  remedy: name one of {}",
            names().join(", ")
        ));
    }
    write(&study, arguments)?;
    Ok(study
        .targets
        .iter()
        .all(|target| target.met || target.is_time))
}

/// What `--only` understands.
fn names() -> Vec<&'static str> {
    let mut names = vec!["mesh", "scenes", "spoilt", "speed"];
    names.extend(Sphere::families().iter().map(|family| family.name));
    names.extend(Plane::families().iter().map(|family| family.name));
    names.extend(Triangle::families().iter().map(|family| family.name));
    names.sort_unstable();
    names.dedup();
    names
}

fn write(study: &Study, arguments: &Arguments) -> Result<(), String> {
    let folder = &arguments.out;
    let failed = |error: &dyn std::fmt::Display| {
        format!(
            "cannot write {}: {error}\n  remedy: name another folder with --out",
            folder.display()
        )
    };
    fs::create_dir_all(folder).map_err(|error| failed(&error))?;
    let document = serde_json::to_string(study).map_err(|error| failed(&error))?;
    fs::write(folder.join("study.json"), document.clone() + "\n")
        .map_err(|error| failed(&error))?;
    let names = plots::draw(study, folder).map_err(|error| failed(&error))?;
    let text = summary::summary(study, &names);
    fs::write(folder.join("summary.md"), &text).map_err(|error| failed(&error))?;
    match arguments.json {
        true => println!("{document}"),
        false => println!(
            "{}\nwritten to {}",
            summary::terminal(study),
            folder.display()
        ),
    }
    Ok(())
}
