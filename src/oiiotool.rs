//! The second judge: the one rule as a command line of OpenImageIO's `oiiotool`.
//!
//! It shares no code with [`judge`](crate::judge), so that a mistake in either shows as a
//! disagreement. `oiiotool --diff` alone is not enough, because it passes films that hold NaN, lack
//! a channel, or differ in size only by a black margin. So guards come first, as commands of the
//! same tool.

use std::env;
use std::ffi::OsString;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::sync::atomic::{AtomicUsize, Ordering};

use crate::film::{Film, TESTS};
use crate::judge::tolerance_path;

/// An installed `oiiotool`.
#[derive(Clone, Debug)]
pub struct Oiiotool {
    binary: PathBuf,
}

/// What the second judge says.
#[derive(Clone, Debug, PartialEq)]
pub struct SecondVerdict {
    /// Whether the film passes.
    pub passes: bool,
    /// What the tool said about it, if anything.
    pub said: String,
}

/// The environment variable that names a binary to use instead of the one that would be found.
pub const BINARY_VARIABLE: &str = "PINHOLE_OIIOTOOL";

impl Oiiotool {
    /// The binary named by `PINHOLE_OIIOTOOL`, or that of the Python environment in
    /// the folder `python`, or the first on the path.
    pub fn find(python: &Path) -> Option<Oiiotool> {
        let name = format!("oiiotool{}", env::consts::EXE_SUFFIX);
        let named = env::var_os(BINARY_VARIABLE).map(PathBuf::from);
        // The package's own binary starts 90 ms sooner than its Python wrapper.
        let folders = [python.join("lib"), python.join("Lib")];
        let libraries = folders
            .iter()
            .flat_map(|folder| fs::read_dir(folder).into_iter().flatten());
        let packaged = libraries
            .flatten()
            .map(|entry| entry.path())
            .flat_map(|library| {
                let own = Path::new("OpenImageIO").join("bin").join(&name);
                [library.join("site-packages").join(&own), library.join(own)]
            });
        let path = env::var_os("PATH").unwrap_or_default();
        // A relative folder would be one in the current folder, which may be a student's.
        let on_path = env::split_paths(&path)
            .filter(|folder| folder.is_absolute())
            .map(|folder| folder.join(&name))
            .collect::<Vec<_>>();
        let binary = named
            .into_iter()
            .chain(packaged)
            .chain(on_path)
            .find(|file| file.is_file())?;
        Some(Oiiotool { binary })
    }

    /// The program's file.
    pub fn binary(&self) -> &Path {
        &self.binary
    }

    /// Judges the film at `film` against the golden at `golden` and its tolerance.
    ///
    /// # Errors
    /// If the golden cannot be read, or the tool cannot be started.
    pub fn judge(&self, golden: &Path, film: &Path) -> Result<SecondVerdict, String> {
        let layout = Film::read(golden).map_err(|error| error.to_string())?;
        // Copy the films to plain names, because `#` and `{…}` in a path have a special meaning for
        // the tool.
        let copies =
            FilmCopies::new(golden, film).map_err(|error| format!("cannot copy films: {error}"))?;
        let output = Command::new(&self.binary)
            .args(arguments(&layout))
            .current_dir(&copies.folder)
            .output()
            .map_err(|error| format!("cannot start {}: {error}", self.binary.display()))?;
        Ok(verdict(&output))
    }
}

/// A folder with copies of the three films, which is deleted when dropped.
struct FilmCopies {
    folder: PathBuf,
}

const FILM: &str = "film.exr";
const GOLDEN: &str = "golden.exr";
const TOLERANCE: &str = "tolerance.exr";

impl FilmCopies {
    fn new(golden: &Path, film: &Path) -> io::Result<FilmCopies> {
        static NEXT: AtomicUsize = AtomicUsize::new(0);
        let turn = NEXT.fetch_add(1, Ordering::Relaxed);
        let name = format!("pinhole-films-{}-{turn}", std::process::id());
        let copies = FilmCopies {
            folder: env::temp_dir().join(name),
        };
        // Not `recursive`: a folder of this name may belong to another process. Nobody else may
        // read goldens that students don't have.
        #[cfg_attr(not(unix), expect(unused_mut))]
        let mut folder = fs::DirBuilder::new();
        #[cfg(unix)]
        std::os::unix::fs::DirBuilderExt::mode(&mut folder, 0o700);
        folder.create(&copies.folder)?;
        fs::copy(film, copies.folder.join(FILM))?;
        fs::copy(golden, copies.folder.join(GOLDEN))?;
        fs::copy(tolerance_path(golden), copies.folder.join(TOLERANCE))?;
        Ok(copies)
    }
}

impl Drop for FilmCopies {
    fn drop(&mut self) {
        let _never_made = fs::remove_dir_all(&self.folder);
    }
}

/// The rule: guards, then |film − golden| − tolerance, cut off below 0, must be 0.
fn arguments(layout: &Film) -> Vec<OsString> {
    let size = layout.resolution();
    let names: Vec<&str> = layout
        .channels()
        .iter()
        .map(|channel| channel.name.as_str())
        .collect();
    let expected = [
        ("nchannels", names.len()),
        ("width", size.n_x),
        ("height", size.n_y),
        ("x", 0),
        ("y", 0),
        ("full_width", size.n_x),
        ("full_height", size.n_y),
        ("full_x", 0),
        ("full_y", 0),
    ];
    let words = |text: &str| text.split(' ').map(OsString::from).collect::<Vec<_>>();

    let mut line = words("--native --fail 0 --failpercent 0 --hardfail 0");
    line.push(FILM.into());
    // A guard refuses a film by reading a file that does not exist.
    for (what, value) in expected {
        line.extend(words(&format!(
            "--if {{TOP.{what}!={value}}} --i WRONG_LAYOUT --endif"
        )));
    }
    line.extend(words(
        "--if {eq(TOP.format,\"float\")} --else --i NOT_FLOAT --endif",
    ));
    // Put the channels of every film in one order, because the tool sorts them by rules of its
    // own.
    let in_order = words(&format!("--ch {}", names.join(",")));
    line.extend(words("--fixnan error"));
    line.extend_from_slice(&in_order);
    line.push(GOLDEN.into());
    line.extend_from_slice(&in_order);
    line.extend(["--absdiff".into(), TOLERANCE.into()]);
    line.extend(in_order);
    line.extend(words("--sub"));
    if names.contains(&TESTS) {
        // Work is judged by its sum, and so by its mean.
        let others = names.iter().filter(|name| **name != TESTS);
        let others: Vec<&str> = others.copied().collect();
        line.extend(words(&format!(
            "--dup --ch {TESTS} --if {{TOP.AVGCOLOR>0}} --i TOO_MUCH_WORK --endif --pop --ch {}",
            others.join(",")
        )));
    }
    line.extend(words("--maxc 0 --dup --mulc 0 --diff"));
    line
}

/// Exit code 0 is not enough, because the tool fills a missing channel with 0 and only warns.
fn verdict(output: &Output) -> SecondVerdict {
    let said = String::from_utf8_lossy(&output.stderr);
    let first = said.lines().next().unwrap_or_default().to_owned();
    SecondVerdict {
        passes: output.status.success() && first.is_empty(),
        said: first,
    }
}
