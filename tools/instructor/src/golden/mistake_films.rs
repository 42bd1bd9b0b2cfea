//! Casts the films of all known mistakes, and stores their fingerprints beside the goldens.

use std::path::PathBuf;
use std::sync::atomic::{AtomicUsize, Ordering};

use pinhole::Film;
use rayon::iter::{IntoParallelRefIterator, ParallelIterator};

use pinhole_course::assignment::Assignment;
use pinhole_course::checkout::Checkout;
use pinhole_course::compile::Program;
use pinhole_course::diagnosis::known::KnownMistakes;
use pinhole_course::error::Result;
use pinhole_course::goldens::Goldens;
use pinhole_course::goldens::questions::QuestionFilm;
use pinhole_course::mistake::{self, MistakeFolder};
use pinhole_course::mistake_films::{build, cast};
use pinhole_course::progress::Progress;

/// Films to fingerprint, each with its task, if it tests only one.
type FilmsToCast = Vec<(Option<String>, QuestionFilm)>;

/// Fingerprints the mistakes on scenes and, with `probes`, on every group of questions. Keeps
/// earlier fingerprints of other films. Returns the files that were written, as paths inside
/// the folder.
pub fn make(
    assignment: &Assignment,
    goldens: &Goldens,
    probes: bool,
    checkout: &Checkout,
    progress: &Progress,
) -> Result<Vec<PathBuf>> {
    let mut mistakes = mistake::read_all(assignment)?;
    mistakes.retain(|folder| folder.mistake.is_single());
    if mistakes.is_empty() {
        return Ok(Vec::new());
    }
    let counter = Counter::new("building the mistakes", mistakes.len(), progress);
    let programs = mistakes
        .par_iter()
        .map(|folder| counter.after(build(&folder.folder, assignment, checkout)));
    let programs: Vec<Program> = programs.collect::<Result<_>>()?;

    let mut known = KnownMistakes::read(&goldens.folder)?;
    let words = |folder: &MistakeFolder| (folder.slug.clone(), folder.mistake.clone());
    known.mistake = mistakes.iter().map(words).collect();
    let films_to_cast = films_to_cast(assignment, goldens, probes)?;
    let cast_all = |(task, film): &(Option<String>, QuestionFilm)| {
        let shows = |folder: &MistakeFolder| match task {
            Some(task) => folder.mistake.fails.contains(task),
            None => true,
        };
        let mut casts = Vec::new();
        for (folder, program) in mistakes.iter().zip(&programs) {
            if shows(folder) {
                casts.push((folder.slug.clone(), cast(program, film)?));
            }
        }
        Ok(casts)
    };
    let counter = Counter::new("rendering the mistakes", films_to_cast.len(), progress);
    let films = films_to_cast
        .par_iter()
        .map(|film| counter.after(cast_all(film)));
    let casts: Vec<Vec<(String, Option<Film>)>> = films.collect::<Result<_>>()?;
    let mut written = Vec::new();
    for ((_, film), casts) in films_to_cast.iter().zip(casts) {
        let name = goldens.film_name(&film.golden_path);
        written.extend(known.add(&name, &film.golden, casts, &goldens.folder)?);
    }
    let is_there = |name: &String| goldens.folder.join(format!("{name}.exr")).is_file();
    known.films.retain(|name, _| is_there(name));
    known.panics.retain(|name, _| is_there(name));
    known.write(&goldens.folder)?;
    progress.clear();
    Ok(written)
}

fn films_to_cast(assignment: &Assignment, goldens: &Goldens, probes: bool) -> Result<FilmsToCast> {
    let mut films_to_cast = FilmsToCast::new();
    for scene in &goldens.scenes {
        films_to_cast.push((None, goldens.scene_film(scene)?));
    }
    for task in &assignment.tasks {
        let groups = match probes {
            true => goldens.groups(task)?,
            false => goldens.scene_groups(task)?,
        };
        for film in groups.into_iter().flat_map(|group| group.films) {
            films_to_cast.push((Some(task.name.clone()), film));
        }
    }
    Ok(films_to_cast)
}

/// Counts finished items for the progress line.
struct Counter<'a> {
    what: &'a str,
    all: usize,
    done: AtomicUsize,
    progress: &'a Progress,
}

impl<'a> Counter<'a> {
    fn new(what: &'a str, all: usize, progress: &'a Progress) -> Counter<'a> {
        let done = AtomicUsize::new(0);
        Counter {
            what,
            all,
            done,
            progress,
        }
    }

    fn after<T>(&self, result: T) -> T {
        let done = self.done.fetch_add(1, Ordering::Relaxed) + 1;
        self.progress.show(self.what, done as f64 / self.all as f64);
        result
    }
}
