//! Command-line options for running a submission's program.

use std::env;
use std::path::Path;
use std::time::Duration;

use clap::Args;
use pinhole::Resolution;
use pinhole::scene::MOST_PIXELS;

use crate::assignment::Assignment;
use crate::checkout::Checkout;
use crate::error::Result;
use crate::sandbox::Choice;

/// The option that names an assignment.
#[derive(Args, Default)]
pub struct AssignmentOption {
    /// The assignment, by name or folder [default: the assignment that contains the path you pass,
    /// else the one that contains the current folder, else this repository's default]
    #[arg(long = "assignment", value_name = "NAME")]
    pub name: Option<String>,
}

impl AssignmentOption {
    /// The named assignment. Without a name: the one around `folder`, or else around
    /// the current folder.
    ///
    /// # Errors
    /// See [`Assignment::find`].
    pub fn find(&self, checkout: &Checkout, folder: Option<&Path>) -> Result<Assignment> {
        let here = || env::current_dir().unwrap_or_default();
        let folder = folder.map_or_else(here, Path::to_owned);
        Assignment::find(checkout, self.name.as_deref(), &folder)
    }

    /// The assignment of a command that also takes its name as an argument.
    ///
    /// # Errors
    /// See [`Assignment::find`].
    pub fn or(&self, named: Option<&str>, checkout: &Checkout) -> Result<Assignment> {
        match named {
            Some(name) => Assignment::find(checkout, Some(name), Path::new("")),
            None => self.find(checkout, None),
        }
    }
}

/// The sandbox for untrusted code.
#[derive(Args)]
pub struct SandboxOptions {
    /// The sandbox that the code runs in
    #[arg(long, value_enum, value_name = "SANDBOX", default_value_t)]
    pub sandbox: Choice,
    /// Run code from outside this repository without a sandbox; only for your own code (short for
    /// --sandbox none)
    #[arg(long, conflicts_with = "sandbox")]
    pub trust: bool,
}

impl SandboxOptions {
    /// The sandbox that the user has chosen.
    pub fn choice(&self) -> Choice {
        match self.trust {
            true => Choice::None,
            false => self.sandbox,
        }
    }
}

/// How to run a submission's program.
#[derive(Args)]
pub struct RunOptions {
    /// Stop a task or a scene after this many seconds, or when the code has returned nothing for a
    /// fifteenth of this time (at least 2 s)
    #[arg(long, value_name = "SECONDS", default_value_t = RunOptions::TIMEOUT,
          value_parser = clap::value_parser!(u64).range(1..=86_400))]
    pub timeout: u64,
    /// Which sandbox it runs in.
    #[command(flatten)]
    pub sandbox: SandboxOptions,
}

impl RunOptions {
    /// The default, in seconds.
    pub const TIMEOUT: u64 = 30;

    /// How long an answer may take.
    pub fn wall(&self) -> Duration {
        Duration::from_secs(self.timeout)
    }
}

/// A film's size as a user types it, `640x360`.
pub fn resolution(text: &str) -> std::result::Result<Resolution, String> {
    let wrong = || format!("`{text}` is not a size like 640x360");
    let (n_x, n_y) = text.split_once('x').ok_or_else(wrong)?;
    let count = |text: &str| {
        text.parse::<usize>()
            .ok()
            .filter(|n| (1..=20_000).contains(n))
    };
    match (count(n_x), count(n_y)) {
        (Some(n_x), Some(n_y)) if n_x * n_y <= MOST_PIXELS => Ok(Resolution { n_x, n_y }),
        (Some(_), Some(_)) => Err(format!("a film can have at most {MOST_PIXELS} pixels")),
        _ => Err(wrong()),
    }
}
