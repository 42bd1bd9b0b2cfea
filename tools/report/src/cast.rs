//! Writes a film and its pictures, and prints a summary.

use std::fmt;
use std::io;
use std::ops::Range;
use std::path::{Path, PathBuf};

use crate::escape::printable;
use pinhole::heat_map::{self, HeatScale};
use pinhole::words::number;
use pinhole::{Film, false_colour};
use pinhole_course::error::{Result, ResultExt};
use serde_json::{Value, json};

use crate::pictures;
use crate::program::Status;
use pinhole_course::output;

/// What was cast, and by which submission.
pub struct Cast {
    /// The scene, as the user named it.
    pub scene: String,
    /// What was cast.
    pub film: Film,
    /// How many tests each pixel took, if that is counted.
    pub tests: Option<Film>,
    /// How many tests our answers take for each pixel of the scene, if that is known.
    pub expected_tests: Option<Film>,
    /// Who cast it: a submission's folder, or one of the study's methods.
    pub by: String,
    /// How long the cast took.
    pub seconds: f64,
    /// Why the film is not complete.
    pub problem: Option<String>,
    /// What a student's code printed.
    pub printed: String,
    /// How much work exact casting was.
    pub exact: Option<Value>,
    /// How much work planned casting was, and the plan.
    pub planned: Option<Value>,
    /// Which pixels are the submission's own, if some come from the golden film.
    pub shares: Option<Shares>,
}

/// Which parts of a film a submission answered, and which come from the golden film.
pub struct Shares {
    /// The tasks that it answered.
    pub yours: Vec<String>,
    /// The tasks without an answer, for which the golden films fill in.
    pub golden: Vec<String>,
    /// For each pixel, whether it was copied from the golden film.
    pub copied: Vec<bool>,
}

impl Cast {
    fn is_by_submission(&self) -> bool {
        self.exact.is_none() && self.planned.is_none()
    }

    /// Writes film.exr and its pictures into `out`, and prints a summary. Depths are t times
    /// `depth_per_t`, in scene units. The picture of depths spans those of `golden`, if there is
    /// one.
    pub fn deliver(
        &self,
        out: &Path,
        golden: Option<PathBuf>,
        depth_per_t: f64,
        json: bool,
    ) -> Result<Status> {
        let path = out.join("film.exr");
        output::make_folder(out)?;
        let bytes = self.film.to_bytes().map_err(io::Error::other);
        let written = bytes.and_then(|bytes| output::write(&path, &bytes));
        written.or_input(
            format_args!("cannot write {}", path.display()),
            "name another folder with --out",
        )?;
        let range = match &golden {
            Some(golden) => false_colour::depth_range(&Film::read(golden)?, depth_per_t),
            None => false_colour::depth_range(&self.film, depth_per_t),
        };
        let shares = self.shares.as_ref();
        let copied = shares.map_or(&[][..], |shares| &shares.copied);
        let mut written = vec![path.display().to_string()];
        let pictures = pictures::write(out, "", &self.film, depth_per_t, range.clone(), copied)?;
        written.extend(pictures);
        let mut scale = None;
        if let Some(tests) = &self.tests {
            // Films that are shown side by side need the same scale.
            let expected = self.expected_tests.as_ref();
            let films = [Some(tests), expected].into_iter().flatten();
            scale = HeatScale::of(&films.collect::<Vec<_>>());
            if let Some(scale) = &scale {
                written.push(pictures::write_tests(out, "", tests, scale)?);
                if let Some(expected) = expected {
                    written.push(pictures::write_tests(out, "expected-", expected, scale)?);
                }
            }
        }
        self.show(&range, scale.as_ref(), &written, json);
        Ok(match self.problem {
            None => Status::Well,
            Some(_) => Status::JudgedWrong,
        })
    }

    fn show(&self, range: &Range<f64>, scale: Option<&HeatScale>, written: &[String], json: bool) {
        let resolution = self.film.resolution();
        let hits = self
            .film
            .channel("id")
            .unwrap_or_default()
            .iter()
            .filter(|id| **id >= 0.0)
            .count();
        if json {
            anstream::println!(
                "{:#}",
                json!({
                    "scene": self.scene,
                    "submission": self.is_by_submission().then_some(&self.by),
                    "exact": self.exact,
                    "planned": self.planned,
                    "resolution": [resolution.n_x, resolution.n_y],
                    "hits": hits,
                    "depth_range": [range.start, range.end],
                    "tests": self.tests.as_ref().map(heat_map::sum),
                    "expected_tests": self.expected_tests.as_ref().map(heat_map::sum),
                    "seconds": self.seconds,
                    "files": written,
                    "problem": self.problem,
                    "answered": self.shares.as_ref().map(|shares| &shares.yours),
                    "from_golden": self.shares.as_ref().map(|shares| &shares.golden),
                })
            );
        } else {
            anstream::println!(
                "{resolution} pixels in {:.2} s; {hits} of them show an object; cast by {}",
                self.seconds,
                printable(&self.by)
            );
            if hits == 0 && self.problem.is_none() {
                anstream::println!(
                    "every ray missed; see one of them: cargo pinhole explain {} {} {}",
                    self.scene,
                    resolution.n_x / 2,
                    resolution.n_y / 2
                );
            }
            let (near, far) = (number(range.start, 4), number(range.end, 4));
            anstream::println!("depth.png spans {near} (bright) to {far} (dark) scene units");
            if let (Some(film), Some(scale)) = (&self.tests, scale) {
                anstream::println!(
                    "tests.png: {scale} for a pixel; {} tests in total",
                    number(heat_map::sum(film), 9)
                );
                if let Some(expected) = &self.expected_tests {
                    let sum = number(heat_map::sum(expected), 9);
                    anstream::println!(
                        "expected-tests.png: the reference answers take {sum} tests in total"
                    );
                }
            }
            for file in written {
                anstream::println!("wrote {file}");
            }
            if !self.printed.is_empty() {
                anstream::eprintln!("your code printed:");
                for line in self.printed.lines() {
                    anstream::eprintln!("  {}", printable(line));
                }
            }
            match (&self.shares, &self.problem) {
                (Some(shares), _) => anstream::println!("{shares}"),
                (None, Some(problem)) => {
                    anstream::println!("the film is not complete: {problem}");
                }
                (None, None) => {}
            }
        }
    }
}

impl fmt::Display for Shares {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.yours.is_empty() {
            true => writeln!(f, "nothing in this film is yours yet")?,
            false => writeln!(f, "yours: {}", self.yours.join(", "))?,
        }
        let missing = self.golden.iter().map(|task| format!("{task}, "));
        let missing: String = missing.collect();
        write!(
            f,
            "from Mitsuba's film (copied pixels are faded): {missing}which object a pixel shows"
        )
    }
}
