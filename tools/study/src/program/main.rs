//! Runs the study: `pinhole study` is the way to it.

mod parts;
mod whole;

use std::path::PathBuf;
use std::process::ExitCode;

use clap::{Parser, Subcommand, ValueEnum};
use pinhole_study::instructions;
use pinhole_study::plan::Wish;

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
    /// Only this family of questions (distance, surface, …), or crossover, mesh, plans, scenes,
    /// spoilt or speed
    #[arg(long, value_name = "FAMILY")]
    only: Option<String>,
    /// What random questions come from
    #[arg(long, value_name = "N", default_value_t = 20_261_121)]
    seed: u64,
    /// A student's answers to the questions that `questions` wrote
    #[arg(long, value_name = "FILE", hide = true)]
    answers: Option<PathBuf>,
}

#[derive(Subcommand)]
enum Part {
    /// Write down what a student's code is asked: what `pinhole study --submission` runs
    #[command(hide = true)]
    Questions { file: PathBuf },
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
    /// 500 million rays at edges and as many at vertices: about two hours of a core.
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
        /// Cast as planned for this accuracy instead
        #[arg(long, value_name = "X")]
        plan: Option<f64>,
        #[command(flatten)]
        wanted: Wanted,
    },
    /// The cheapest way to cast a scene accurately enough: what `pinhole plan` runs
    #[command(hide = true)]
    Plan {
        scene: PathBuf,
        #[arg(long, value_name = "X")]
        accuracy: f64,
        #[arg(long, num_args = 2, value_names = ["NX", "NY"])]
        resolution: Vec<usize>,
        #[command(flatten)]
        wanted: Wanted,
        #[arg(long)]
        json: bool,
    },
}

/// What is wanted of a planned film.
#[derive(clap::Args)]
struct Wanted {
    #[arg(long, value_enum, default_value_t = Ids::Rounded)]
    ids: Ids,
    #[arg(long, value_enum, value_delimiter = ',', default_values = ["id", "depth", "normal"])]
    outputs: Vec<Output>,
}

#[derive(Clone, Copy, PartialEq, ValueEnum)]
enum Ids {
    Rounded,
    Exact,
}

#[derive(Clone, Copy, PartialEq, ValueEnum)]
enum Output {
    Id,
    Depth,
    Normal,
}

impl Wanted {
    fn wish(&self, accuracy: f64) -> Wish {
        Wish {
            accuracy,
            exact_ids: self.ids == Ids::Exact,
            depth: self.outputs.contains(&Output::Depth),
            normal: self.outputs.contains(&Output::Normal),
        }
    }
}

/// The seed of workloads whose instructions are counted.
const WORKLOAD: u64 = 1;

fn main() -> ExitCode {
    let arguments = Arguments::parse();
    let done = match &arguments.part {
        None => whole::studied(&arguments),
        Some(Part::Cast {
            shape,
            kernel,
            casts,
        }) => {
            instructions::cast(shape, *kernel, *casts, WORKLOAD);
            Ok(true)
        }
        Some(Part::Questions { file }) => parts::questions(file, arguments.seed).map(|()| true),
        Some(Part::Record {
            random,
            adversarial,
            edges,
            seed,
        }) => Ok(parts::record(*random, *adversarial, *edges, *seed)),
        Some(Part::Film {
            scene,
            film,
            resolution,
            plan,
            wanted,
        }) => {
            let wish = plan.map(|accuracy| wanted.wish(accuracy));
            parts::cast(scene, resolution, wish, film).map(|()| true)
        }
        Some(Part::Plan {
            scene,
            accuracy,
            resolution,
            wanted,
            json,
        }) => parts::tell(scene, resolution, wanted.wish(*accuracy), *json).map(|()| true),
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
