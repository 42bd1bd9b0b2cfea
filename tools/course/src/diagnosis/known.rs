//! The known mistakes as they are stored beside the goldens: their text in `mistakes.toml`, their
//! fingerprints in `FILM.mistakes.exr`.
//!
//! A student's repository does not have the mistakes' sources, but with these two files it can
//! still diagnose them.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

use pinhole::comparison::{FilmComparison, Witness, channel_names};
use pinhole::film::Channel;
use pinhole::judge::Golden;
use pinhole::{Film, Resolution};
use serde::{Deserialize, Serialize};

use super::fingerprint::{Fingerprint, MOST_SAMPLED, MOST_TELLING, fingerprints};
use crate::error::{Error, Result, ResultExt};
use crate::mistake::Mistake;

/// The file of their beliefs and hints.
pub const FILE: &str = "mistakes.toml";

/// The channel that says which pixel of the film a column is about.
const PIXEL: &str = "pixel";

/// The value of [`PIXEL`] in an unused column.
const UNUSED: f32 = -1.0;

/// The known mistakes that are stored in a folder of goldens.
#[derive(Clone, Debug, Default, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct KnownMistakes {
    /// The mistakes, by name.
    #[serde(default)]
    pub mistake: BTreeMap<String, Mistake>,
    /// For each film, the mistakes that show in it, and in how many pixels. The rows of the
    /// fingerprints' file have the same order, from the top.
    #[serde(default)]
    pub films: BTreeMap<String, BTreeMap<String, usize>>,
    /// For each film, the mistakes that panic while casting it.
    #[serde(default)]
    pub panics: BTreeMap<String, BTreeSet<String>>,
}

impl KnownMistakes {
    /// Reads the known mistakes of a folder. Without the file, there are none.
    pub fn read(folder: &Path) -> Result<KnownMistakes> {
        let path = folder.join(FILE);
        let Ok(text) = fs::read_to_string(&path) else {
            return Ok(KnownMistakes::default());
        };
        toml::from_str(&text).or_environment(
            path.display(),
            "make it again: cargo pinhole golden mistakes",
        )
    }

    /// Writes `mistakes.toml` into `folder`.
    pub fn write(&self, folder: &Path) -> Result<()> {
        fs::write(folder.join(FILE), self.text()?).or_input(
            format_args!("cannot write {}", folder.join(FILE).display()),
            "name a folder you may write to",
        )
    }

    /// The text of the file.
    pub fn text(&self) -> Result<String> {
        let text = toml::to_string(self)
            .or_environment(format_args!("cannot write {FILE}"), "report this")?;
        let head = "# Written by `pinhole golden`: what is known of mistakes, and in how many pixels \
                    of each film each shows.\n\n";
        Ok(format!("{head}{text}"))
    }

    /// Fingerprints these mistakes' films of `golden` and writes them. A mistake without a film
    /// panicked. Returns the file's path inside `folder`, if any mistake shows.
    pub fn add(
        &mut self,
        film: &str,
        golden: &Golden,
        casts: Vec<(String, Option<Film>)>,
        folder: &Path,
    ) -> Result<Option<PathBuf>> {
        let panicking = casts.iter().filter(|(_, film)| film.is_none());
        let panicking: BTreeSet<String> = panicking.map(|(slug, _)| slug.clone()).collect();
        self.panics.remove(film);
        if !panicking.is_empty() {
            self.panics.insert(film.into(), panicking);
        }
        let comparable = casts
            .iter()
            .filter_map(|(slug, film)| Some((slug, FilmComparison::new(golden, film.as_ref()?)?)));
        let (slugs, compared): (Vec<&String>, Vec<FilmComparison>) = comparable.unzip();
        let shown: BTreeMap<&String, Fingerprint> = slugs
            .into_iter()
            .zip(fingerprints(&compared))
            .filter_map(|(slug, fingerprint)| Some((slug, fingerprint?)))
            .collect();
        let counts = shown
            .iter()
            .map(|(slug, print)| ((*slug).clone(), print.failing));
        self.films.insert(film.into(), counts.collect());
        if shown.is_empty() {
            return Ok(None);
        }
        let file = file(film);
        let prints: Vec<&Fingerprint> = shown.values().collect();
        laid_out(&prints, &channel_names(golden)).write(&folder.join(&file))?;
        Ok(Some(file))
    }

    /// The mistakes that panic while casting a film.
    pub fn panicking(&self, film: &str) -> impl Iterator<Item = &String> {
        self.panics.get(film).into_iter().flatten()
    }

    /// The fingerprints that mistakes leave in a film.
    pub fn fingerprints(
        &self,
        film: &str,
        golden: &Golden,
        folder: &Path,
    ) -> Result<Vec<(&str, Fingerprint)>> {
        let Some(counts) = self.films.get(film).filter(|counts| !counts.is_empty()) else {
            return Ok(Vec::new());
        };
        let path = folder.join(file(film));
        let broken = || {
            Error::environment(
                format!("{} does not fit {FILE}", path.display()),
                "make both again: cargo pinhole golden mistakes",
            )
        };
        let laid_out = Film::read(&path)?;
        let pixels = laid_out.channel(PIXEL).ok_or_else(broken)?;
        let names = channel_names(golden);
        let channels: Option<Vec<&[f32]>> =
            names.iter().map(|name| laid_out.channel(name)).collect();
        let channels = channels.ok_or_else(broken)?;
        let Resolution { n_x, n_y } = laid_out.resolution();
        if n_y != counts.len() || n_x != MOST_SAMPLED + MOST_TELLING {
            return Err(broken());
        }
        let witnesses = |from: usize, count: usize| -> Vec<Witness> {
            (from..from + count)
                .filter(|index| pixels[*index] >= 0.0)
                .map(|index| Witness {
                    pixel: pixels[index] as usize,
                    values: channels.iter().map(|samples| samples[index]).collect(),
                })
                .collect()
        };
        let rows = counts.iter().enumerate();
        Ok(rows
            .map(|(row, (slug, failing))| {
                let first = row * n_x;
                let fingerprint = Fingerprint {
                    failing: *failing,
                    sample: witnesses(first, MOST_SAMPLED),
                    telling: witnesses(first + MOST_SAMPLED, MOST_TELLING),
                };
                (slug.as_str(), fingerprint)
            })
            .collect())
    }
}

/// The path of a film's fingerprints.
fn file(film: &str) -> PathBuf {
    format!("{film}.mistakes.exr").into()
}

/// Lays fingerprints out as a film. Each is a row: first its sample, then its telling pixels.
fn laid_out(prints: &[&Fingerprint], names: &[String]) -> Film {
    let columns = MOST_SAMPLED + MOST_TELLING;
    let resolution = Resolution {
        n_x: columns,
        n_y: prints.len(),
    };
    let channel = |name: &str, value: &dyn Fn(&Witness) -> f32, unused: f32| {
        let mut samples = vec![unused; resolution.pixels()];
        for (row, print) in prints.iter().enumerate() {
            let places = (0..).zip(&print.sample);
            let places = places.chain((MOST_SAMPLED..).zip(&print.telling));
            for (column, witness) in places {
                samples[row * columns + column] = value(witness);
            }
        }
        Channel {
            name: name.into(),
            samples,
        }
    };
    let mut channels = vec![channel(PIXEL, &|witness| witness.pixel as f32, UNUSED)];
    for (place, name) in names.iter().enumerate() {
        channels.push(channel(name, &|witness| witness.values[place], 0.0));
    }
    Film::new(resolution, channels)
}
