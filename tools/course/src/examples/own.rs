//! Questions that students write themselves, each about a ray and the task's shape. Mitsuba
//! answers them, and the known mistakes are asked them too, so this needs what only a checkout
//! has.

use std::ffi::OsStr;
use std::fs;
use std::path::Path;
use std::sync::atomic::{AtomicUsize, Ordering};

use pinhole::job::Job;
use pinhole::judge::{Refusal, judge};
use pinhole::kind::{Questions, ShapeQuestion};
use pinhole::{Film, Ray, Shape};
use rayon::iter::{IntoParallelRefIterator, ParallelIterator};
use toml::Spanned;
use toml::de::{DeTable, DeValue};

use super::file::Entry;
use super::{Asked, OWN};
use crate::assignment::{Assignment, Task};
use crate::checkout::Checkout;
use crate::diagnosis::fingerprint::MOST_SAMPLED;
use crate::error::{Error, Result, ResultExt};
use crate::goldens::Goldens;
use crate::mistake::{self, MistakeFolder};
use crate::mistake_films::{build, cast};
use crate::mitsuba;
use crate::private::make_private;
use crate::progress::Progress;

/// The questions that a student has written, in a folder of goldens that exists as long as this.
pub(super) struct OwnQuestions {
    pub goldens: Goldens,
}

impl Drop for OwnQuestions {
    fn drop(&mut self) {
        let _absent_if_mitsuba_made_nothing = fs::remove_dir_all(&self.goldens.folder);
    }
}

impl OwnQuestions {
    /// Answers the own questions in a file of examples, whose text is `text`, with Mitsuba and
    /// with the known mistakes.
    pub fn answer(
        (path, text, entries): (&Path, &str, &[Spanned<Entry>]),
        task: &Task,
        assignment: &Assignment,
        checkout: &Checkout,
        interactive: bool,
    ) -> Result<OwnQuestions> {
        let questions = read((path, text), entries, task)?;
        if !mitsuba::is_there(checkout) {
            let remedy = match mitsuba::scripts(checkout).is_dir() {
                true => "install it: cargo pinhole golden setup",
                false => "choose public questions, or ask your instructor to judge this file",
            };
            let problem = "only Mitsuba can judge rays of your own, and it is not installed here";
            return Err(Error::environment(problem, remedy));
        }
        static NEXT: AtomicUsize = AtomicUsize::new(0);
        let number = NEXT.fetch_add(1, Ordering::Relaxed);
        let name = format!("examples-{}-{number}", std::process::id());
        let folder = checkout.scratch().join(name);
        let mut own = OwnQuestions {
            goldens: Goldens::of_scenes(&folder, &[])?,
        };
        // Python's TOML is older than ours, and doesn't read all that a student may write.
        let plain = text.parse::<toml::Table>();
        let plain = plain.or_input(path.display(), "use numbers of ordinary size")?;
        let file = folder.join("examples.toml");
        fs::create_dir_all(&folder)
            .and_then(|()| make_private(&folder))
            .and_then(|()| fs::write(&file, plain.to_string()))
            .or_fail(&Error::file(&file))?;
        let progress = match interactive {
            true => Progress::new(),
            false => Progress::hidden(),
        };
        own.make(&file, &questions, task, assignment, checkout, &progress)?;
        Ok(own)
    }

    /// Makes the films, and the fingerprints of the mistakes.
    fn make(
        &mut self,
        file: &Path,
        questions: &[ShapeQuestion],
        task: &Task,
        assignment: &Assignment,
        checkout: &Checkout,
        progress: &Progress,
    ) -> Result<()> {
        let goldens = &mut self.goldens;
        progress.say("Mitsuba");
        let shape = task.shape.map_or("", |shape| shape.name());
        let name = format!("{}.{OWN}", task.name);
        let line: [&OsStr; 8] = [
            "own-questions".as_ref(),
            file.as_ref(),
            "--shape".as_ref(),
            shape.as_ref(),
            "--name".as_ref(),
            name.as_ref(),
            "--out".as_ref(),
            goldens.folder.as_ref(),
        ];
        if let Some(refusal) = mitsuba::render(checkout, &line, None, progress)?.refusal {
            let remedy = "move its ray or its shape a little, or change `min_t`";
            let file = file.display().to_string();
            let problem = refusal.problem.replace(&file, "the examples");
            return Err(Error::input(problem, remedy));
        }
        let film = goldens.probe(task, OWN)?;
        progress.say("the mistakes");
        // Mitsuba computes in single precision, which is too little for a tiny shape far away.
        let reference = build(&assignment.reference(), assignment, checkout)?;
        let place = match cast(&reference, &film)?.map(|own| judge(&film.golden, &own)) {
            Some(Ok(verdict)) => verdict.failing.first().copied(),
            Some(Err(Refusal::NotFinite { pixel, .. })) => Some(film.resolution.index(pixel)),
            Some(Err(_)) | None => {
                let problem = format!("our own solution gives no usable answer to an {OWN}");
                return Err(Error::environment(problem, "run: cargo pinhole validate"));
            }
        };
        // Even the question is rounded to single precision. So our own solution also answers the
        // questions as they were written, and an example is judged only if both answers agree.
        let mut written = goldens.probe(task, OWN)?;
        let all = questions.iter().cycle().take(film.job.len()).cloned();
        written.job = Job::Ask(Questions::Intersect(all.collect()));
        let asked = Asked::read(goldens, task, OWN)?;
        let differs = |place: &usize, own: &Film| {
            let own =
                |channel: usize| own.channel(&asked.channels[channel]).unwrap_or_default()[*place];
            let golden = asked.right_answer(*place);
            !asked.contradictions(*place, &golden, &own).is_empty()
        };
        let written = cast(&reference, &written)?;
        let places = &asked.places;
        let rounded = match &written {
            Some(own) => places.iter().find(|place| differs(place, own)),
            None => places.first(),
        };
        if let Some(place) = place.or(rounded.copied()) {
            let problem = format!("Mitsuba's precision is too low for {OWN} {place}");
            let remedy = "use numbers of ordinary size with fewer digits";
            return Err(Error::input(problem, remedy));
        }
        let ours = |error: Error| Error::environment(error.problem, error.remedy);
        let mut mistakes = mistake::read_all(assignment).map_err(ours)?;
        mistakes.retain(|it| it.mistake.is_single() && it.mistake.fails.contains(&task.name));
        let answered = |folder: &MistakeFolder| {
            let program = build(&folder.folder, assignment, checkout)?;
            Ok((folder.slug.clone(), cast(&program, &film)?))
        };
        let casts = mistakes.par_iter().map(answered).collect::<Result<_>>()?;
        let name = goldens.film_name(&film.golden_path);
        let folder = &goldens.folder;
        goldens.known.add(&name, &film.golden, casts, folder)?;
        let words = mistakes.into_iter().map(|it| (it.slug, it.mistake));
        goldens.known.mistake = words.collect();
        progress.clear();
        Ok(())
    }
}

/// Reads the rays and shapes that a file of examples describes.
fn read(
    (path, text): (&Path, &str),
    entries: &[Spanned<Entry>],
    task: &Task,
) -> Result<Vec<ShapeQuestion>> {
    let at = |span: usize, problem: &str, remedy: &str| {
        let line = text[..span].matches('\n').count() + 1;
        let problem = format!("{}:{line}: {problem}", path.display());
        Err(Error::input(problem, remedy))
    };
    let root = DeTable::parse(text).or_fail(&Error::file(path))?;
    let tables = root.get_ref().get("example").map(Spanned::get_ref);
    let tables = tables.and_then(DeValue::as_array).into_iter().flatten();
    let mut questions = Vec::new();
    for (entry, table) in entries.iter().zip(tables) {
        let Some(ray) = &entry.get_ref().ray else {
            continue;
        };
        if questions.len() == MOST_SAMPLED {
            let problem = format!("more than {MOST_SAMPLED} examples have rays of their own");
            return at(
                entry.span().start,
                &problem,
                "put some of them into another file",
            );
        }
        let span = ray.span().start;
        let ray = ray.get_ref();
        // Question films are in single precision.
        let length = ray.d.length() as f32;
        let has_direction = (length * length).is_normal();
        if !(ray.e.is_finite() && has_direction && ray.min_t.is_finite() && ray.min_t >= 0.0) {
            let problem = "no ray has these numbers";
            let remedy =
                "give finite numbers, a `d` of ordinary length, and a `min_t` of 0 or more";
            return at(span, problem, remedy);
        }
        let Some(kind) = task.shape else {
            let problem = "rays of your own can only be used in a task about one shape";
            return at(
                span,
                problem,
                "choose a public question: give `group` and `question`",
            );
        };
        let shape = table.get_ref().get("shape");
        let has_type = |it: &DeTable| it.contains_key("type");
        if shape.is_some_and(|it| it.get_ref().as_table().is_some_and(has_type)) {
            return at(
                span,
                "the shape of an example must not have a `type`",
                "leave it out",
            );
        }
        if let Some((span, values)) =
            shape.and_then(|it| Some((it.span(), it.get_ref().as_table()?)))
        {
            questions.push(ShapeQuestion {
                shape: Shape::read(kind, (path, text), span, values)?,
                ray: Ray {
                    origin: ray.e,
                    direction: ray.d,
                },
                min_t: ray.min_t,
            });
        }
    }
    Ok(questions)
}
