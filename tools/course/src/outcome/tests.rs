use std::fs;
use std::path::Path;

use pinhole::judge::{Bounds, ChannelVerdict, Mismatch};
use pinhole::{Fact, Kind, Pixel, Resolution, ShapeKind};
use schemars::JsonSchema;
use schemars::generate::SchemaSettings;

use super::*;
use crate::assignment::Task;
use crate::compile::Replacement;
use crate::submission::AnswerFileProblem;

// The harness derives no schemas, so these types repeat how its types look in documents.

/// A fact in words.
#[derive(JsonSchema)]
#[schemars(rename = "Fact")]
#[allow(dead_code)]
pub struct FactSchema {
    /// What the fact is about, in a word.
    label: String,
    /// The fact in words, with a line break where a second line is needed.
    text: String,
}

/// How many pixels a picture has.
#[derive(JsonSchema)]
#[schemars(rename = "Resolution")]
#[allow(dead_code)]
pub struct ResolutionSchema {
    /// Columns.
    n_x: usize,
    /// Rows.
    n_y: usize,
}

/// The verdict on one channel.
#[derive(JsonSchema)]
#[schemars(rename = "Channel")]
#[allow(dead_code)]
pub struct ChannelSchema {
    /// The channel.
    name: String,
    /// How many pixels miss the golden by more than the tolerance.
    failing: usize,
    /// How many of the failing pixels show the right object, which means that this channel itself
    /// is wrong.
    own: usize,
    /// The pixel whose error is largest, as a multiple of its tolerance.
    worst: Option<MismatchSchema>,
    /// The smallest rectangle of pixels around all that fail.
    bounds: Option<BoundsSchema>,
}

/// One sample that is too far from its golden.
#[derive(JsonSchema)]
#[schemars(rename = "Mismatch")]
#[allow(dead_code)]
struct MismatchSchema {
    /// The pixel's column and row.
    pixel: [usize; 2],
    /// The film's sample.
    got: f32,
    /// The golden's sample.
    expected: f32,
    /// The tolerance: how far apart the two samples may be.
    allowed: f32,
}

/// A rectangle of pixels, both corners included.
#[derive(JsonSchema)]
#[schemars(rename = "Bounds")]
#[allow(dead_code)]
struct BoundsSchema {
    /// Column and row of the bottom left.
    min: [usize; 2],
    /// Column and row of the top right.
    max: [usize; 2],
}

/// One of every kind of film outcome.
fn every_film_outcome() -> Vec<FilmOutcome> {
    let pixel = Pixel { i: 3, j: 4 };
    let channel = ChannelVerdict {
        name: "t".into(),
        failing: 2,
        own: 1,
        worst: Some(Mismatch {
            pixel,
            got: 0.1,
            expected: 0.2,
            allowed: f32::MAX,
        }),
        bounds: Some(Bounds {
            min: pixel,
            max: pixel,
        }),
    };
    let resolution = Resolution { n_x: 8, n_y: 6 };
    vec![
        FilmOutcome::Judged(Comparison {
            passes: false,
            resolution,
            pixels: 48,
            failing: 2,
            exempt: 1,
            channels: vec![channel],
        }),
        FilmOutcome::Refused { why: "why".into() },
        FilmOutcome::Unanswered,
        FilmOutcome::Blocked { by: "plane".into() },
        FilmOutcome::Panicked {
            message: "oh".into(),
            file: "plane.rs".into(),
            line: 7,
        },
        FilmOutcome::TimedOut {
            seconds: 30.0,
            whole: false,
        },
        FilmOutcome::OutOfMemory { most: 1 << 30 },
        FilmOutcome::Died { how: "how".into() },
        FilmOutcome::Garbled { why: "why".into() },
        FilmOutcome::Examples {
            passes: false,
            says: "why".into(),
        },
        FilmOutcome::Withheld {
            passes: false,
            ended: Status::TimedOut,
            points_only: true,
        },
    ]
}

#[test]
fn an_outcome_is_read_back_as_it_was_written() {
    let task = Task {
        name: "plane".into(),
        kind: Kind::Intersect,
        shape: Some(ShapeKind::Plane),
        chapter: "Plane".into(),
        points: Vec::new(),
        examples: None,
    };
    let fact = Fact::new("got", "nothing\nat all");
    let groups = every_film_outcome()
        .into_iter()
        .map(|film| GroupOutcome::new("g".into(), "about".into(), 3, film, vec![fact.clone()]));
    let groups: Vec<GroupOutcome> = groups.collect();
    let states = [
        Replacement::Unusable(AnswerFileProblem::Missing),
        Replacement::Unusable(AnswerFileProblem::Refused("why".into())),
        Replacement::DoesNotCompile("error".into()),
    ];
    let mut outcome = Outcome::new("Ray casting", "ada".into(), "none");
    let none = Diagnosis::default();
    outcome.tasks = vec![TaskOutcome::new(&task, None, groups, none, Vec::new())];
    let replaced = states.iter().map(|why| TaskOutcome::replaced(&task, why));
    outcome.tasks.extend(replaced);
    for film in every_film_outcome() {
        outcome
            .scenes
            .push(SceneOutcome::new("s".into(), 2, film, Some(0.5)));
    }
    outcome.add_up();
    assert_eq!((outcome.points, outcome.possible), (Some(0), 55));
    let text = serde_json::to_string(&outcome).expect("it can be written");
    let read: Outcome = serde_json::from_str(&text).expect("it can be read");
    assert_eq!(read, outcome);
}

#[test]
fn the_compilers_colours_stay_out_of_documents() {
    let compiler = "\u{1b}[31merror\u{1b}[0m: no".to_owned();
    let file = AnswerFile::DoesNotCompile { compiler };
    let document = serde_json::to_value(file).expect("it can be written");
    assert_eq!(document["compiler"], "error: no");
}

#[test]
fn submission_has_the_worst_status_of_its_tasks_and_scenes() {
    let mut outcome = Outcome::new("Ray casting", "ada".into(), "none");
    assert_eq!(outcome.status(), Status::Graded);
    let died = FilmOutcome::Died { how: "how".into() };
    outcome
        .scenes
        .push(SceneOutcome::new("s".into(), 2, died, Some(0.5)));
    assert_eq!(outcome.status(), Status::Killed);
    let task = Task {
        name: "plane".into(),
        kind: Kind::Intersect,
        shape: Some(ShapeKind::Plane),
        chapter: "Plane".into(),
        points: Vec::new(),
        examples: None,
    };
    let missing = Replacement::Unusable(AnswerFileProblem::Missing);
    outcome.tasks.push(TaskOutcome::replaced(&task, &missing));
    assert_eq!(outcome.status(), Status::MissingFile);
}

#[test]
fn the_committed_schema_is_that_of_the_type() {
    let generator = SchemaSettings::draft2020_12().into_generator();
    let schema = generator.into_root_schema_for::<Outcome>();
    let text = serde_json::to_string_pretty(&schema).expect("it can be written") + "\n";
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../schema/outcome.schema.json");
    if std::env::var_os("UPDATE_SCHEMAS").is_some() {
        fs::write(&path, &text).expect("it can be written");
    }
    let committed = fs::read_to_string(&path).unwrap_or_default();
    let again = "UPDATE_SCHEMAS=1 cargo test -p pinhole-course schema";
    assert_eq!(committed, text, "if this is meant, run: {again}");
}
