//! Lets oiiotool judge films that exist only in memory.

use std::collections::HashSet;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};

use hmac_sha256::Hash;
use pinhole::Film;
use pinhole::oiiotool::Oiiotool;

use crate::checkout::Checkout;
use crate::error::{Error, Result, ResultExt};
use crate::mitsuba;

/// The second judge, with a folder for the films that it reads.
pub struct SecondJudge {
    tool: Oiiotool,
    folder: PathBuf,
    /// Fingerprints of films on which both judges agreed. Many mistakes cast the same films, and
    /// judging these once is enough.
    agreed: Mutex<HashSet<[u8; 32]>>,
}

impl SecondJudge {
    /// The installed oiiotool.
    pub fn find(checkout: &Checkout) -> Result<SecondJudge> {
        let tool = Oiiotool::find(&mitsuba::environment(checkout)).ok_or_else(|| {
            Error::environment(
                "the second judge, oiiotool, is not installed",
                "install it with Mitsuba: cargo pinhole golden setup",
            )
        })?;
        let folder = checkout.scratch().join("second-judge");
        fs::create_dir_all(&folder).or_environment(
            format_args!("cannot make {}", folder.display()),
            "check that you may write to the repository",
        )?;
        Ok(SecondJudge {
            tool,
            folder,
            agreed: Mutex::default(),
        })
    }

    /// Confirms the first judge's verdict on `film`, which is that it `passes` or not.
    ///
    /// # Errors
    /// If the two disagree. The fault is then ours, never the film's.
    pub fn confirm(&self, film: &Film, golden: &Path, passes: bool) -> Result<()> {
        let fingerprint = fingerprint(film, golden, passes);
        let agreed = || self.agreed.lock().unwrap_or_else(|lock| lock.into_inner());
        if agreed().contains(&fingerprint) {
            return Ok(());
        }
        static NEXT: AtomicUsize = AtomicUsize::new(0);
        let turn = NEXT.fetch_add(1, Ordering::Relaxed);
        let name = format!("{}-{turn}.exr", std::process::id());
        let laid = TemporaryFilm(self.folder.join(name));
        film.write(&laid.0)?;
        let second = self.tool.judge(golden, &laid.0).map_err(|problem| {
            Error::environment(
                problem,
                "install oiiotool again: cargo pinhole golden setup",
            )
        })?;
        if second.passes == passes {
            agreed().insert(fingerprint);
            return Ok(());
        }
        let word = |passes: bool| if passes { "passes" } else { "fails" };
        Err(Error::environment(
            format!(
                "the two judges disagree on {}: {} in Pinhole, {} in oiiotool ({})",
                golden.display(),
                word(passes),
                word(second.passes),
                second.said
            ),
            "this is a bug in Pinhole, not in the submission: report it",
        ))
    }
}

/// A film on disk that is deleted when dropped.
struct TemporaryFilm(PathBuf);

impl Drop for TemporaryFilm {
    fn drop(&mut self) {
        let _never_written = fs::remove_file(&self.0);
    }
}

/// Two calls have the same fingerprint only if film, golden and first verdict are the same.
fn fingerprint(film: &Film, golden: &Path, passes: bool) -> [u8; 32] {
    let mut hash = Hash::new();
    hash.update(golden.as_os_str().as_encoded_bytes());
    hash.update(format!("\n{} {passes}\n", film.resolution()));
    for channel in film.channels() {
        hash.update(format!("{}\n", channel.name));
        let bytes = channel
            .samples
            .iter()
            .flat_map(|sample| sample.to_bits().to_le_bytes());
        hash.update(bytes.collect::<Vec<u8>>());
    }
    hash.finalize()
}
