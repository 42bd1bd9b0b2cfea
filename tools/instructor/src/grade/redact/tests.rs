use glam::DVec3;
use pinhole::film::TESTS;
use pinhole::judge::{Golden, judge};
use pinhole::kind::CameraQuestion;
use pinhole::{Camera, Fact, Film, Pixel, Projection, Resolution};
use pinhole_course::diagnosis::Reading;
use pinhole_course::diagnosis::measure::Finding;
use pinhole_course::outcome::{AnswerFile, GroupOutcome, GroupPicture, Picture, TaskOutcome};
use pinhole_report::html::{Evidence, GroupRow, HeatMaps, SubmittedRays, TaskSection};
use pinhole_report::terminal;

use super::*;

const REVEALS: [Reveal; 4] = [
    Reveal::Points,
    Reveal::Message,
    Reveal::Picture,
    Reveal::Full,
];

const ONE_PIXEL: Resolution = Resolution { n_x: 1, n_y: 1 };

/// The outcome of a film with a wrong t.
fn wrong() -> FilmOutcome {
    let film = |t: f32| Film::new(ONE_PIXEL, Vec::new()).with("t", vec![t]);
    let golden = Golden::new(film(1.0), film(0.5)).expect("they belong together");
    FilmOutcome::from(&judge(&golden, &film(2.0)))
}

/// Everything in an outcome that may be withheld: a group of questions, one about pixels of
/// scenes, one that fails fresh questions, and two scenes.
fn outcome() -> Outcome {
    let diagnosis = Diagnosis {
        reading: Reading::OneOf,
        ..Diagnosis::default()
    };
    let group = |name: &str| {
        let worst = vec![Fact::new("t", "2")];
        GroupOutcome::new(name.into(), String::new(), 1, wrong(), worst)
    };
    let fresh = GroupOutcome {
        fails_fresh: true,
        ..group("fresh")
    };
    let examples = GroupOutcome {
        outcome: FilmOutcome::Examples {
            passes: true,
            says: String::new(),
        },
        ..group("examples")
    };
    let scene = |name: &str| SceneOutcome {
        diagnosis: diagnosis.clone(),
        ..SceneOutcome::new(name.into(), 1, wrong(), Some(0.25))
    };
    let measured = Finding {
        about: "t".into(),
        says: "t is 2".into(),
        is_law: true,
    };
    let task = TaskOutcome {
        name: "plane".into(),
        chapter: String::new(),
        points: 0,
        possible: 3,
        file: AnswerFile::Compiled,
        groups: vec![group("front"), group("scenes"), fresh, examples],
        diagnosis: diagnosis.clone(),
        measured: vec![measured],
        warnings: String::new(),
    };
    Outcome {
        tasks: vec![task],
        scenes: vec![scene("exam"), scene("bunny")],
        printed: "words".into(),
        ..Outcome::new("ray casting", "ada".into(), "none")
    }
}

fn empty_report() -> Report {
    Report {
        title: String::new(),
        of: Vec::new(),
        passes: false,
        said: String::new(),
        points: None,
        tasks: Vec::new(),
        scenes: Vec::new(),
        printed: Vec::new(),
        more_printed: 0,
        on_printed: None,
        command: String::new(),
        book: None,
        finish: None,
    }
}

/// How much is left of a film's outcome.
fn left(outcome: &FilmOutcome) -> Reveal {
    match outcome {
        FilmOutcome::Judged(comparison) if comparison.channels.is_empty() => Reveal::Picture,
        FilmOutcome::Judged(_) => Reveal::Full,
        FilmOutcome::Withheld { points_only, .. } if *points_only => Reveal::Points,
        _ => Reveal::Message,
    }
}

#[test]
fn only_what_is_withheld_is_redacted_and_only_as_far_as_chosen() {
    let full = outcome();
    for reveal in REVEALS {
        for (probes, scene) in [(false, false), (true, false), (false, true), (true, true)] {
            let case = format!("{reveal:?}, probes {probes}, scene {scene}");
            let withheld = Withheld {
                scenes: scene.then(|| "exam".into()).into_iter().collect(),
                scene_groups: vec![("plane".into(), "scenes".into())],
                probes,
                reveal,
            };
            let mut shown = outcome();
            withheld.redact(&mut shown);
            let or_full = |is_withheld: bool| if is_withheld { reveal } else { Reveal::Full };
            let (task, was) = (&shown.tasks[0], &full.tasks[0]);
            for (group, is_withheld) in task.groups.iter().zip([probes, scene, true]) {
                let (name, most) = (&group.name, or_full(is_withheld));
                assert_eq!(left(&group.outcome), most, "{case}: {name}");
                assert_eq!(
                    group.worst.is_empty(),
                    most < Reveal::Full,
                    "{case}: {name}"
                );
            }
            assert_eq!(task.groups[3], was.groups[3], "{case}: examples are public");
            let most = or_full(probes);
            let is_diagnosed = task.diagnosis == was.diagnosis;
            assert_eq!(is_diagnosed, most >= Reveal::Picture, "{case}");
            assert_eq!(task.measured.is_empty(), most < Reveal::Full, "{case}");
            let (exam, most) = (&shown.scenes[0], or_full(scene));
            assert_eq!(left(&exam.outcome), most, "{case}");
            assert_eq!(exam.seconds.is_none(), scene, "{case}");
            let is_diagnosed = exam.diagnosis == full.scenes[0].diagnosis;
            assert_eq!(is_diagnosed, most >= Reveal::Picture, "{case}");
            assert_eq!(shown.scenes[1], full.scenes[1], "{case}");
            assert_eq!(shown.printed.is_empty(), probes || scene, "{case}");
        }
    }
}

#[test]
fn what_an_answer_lacks_is_said_unless_only_points_are_shown() {
    let blocked = FilmOutcome::Blocked { by: "plane".into() };
    for outcome in [FilmOutcome::Unanswered, blocked] {
        for reveal in REVEALS {
            let is_said = redacted(&outcome, reveal) == outcome;
            assert_eq!(is_said, reveal > Reveal::Points, "{outcome:?}");
        }
    }
}

#[test]
fn a_report_shows_as_much_of_a_withheld_scene_as_its_outcome() {
    let film = Film::of_hits(ONE_PIXEL, &[None]);
    let golden = Golden::new(film.clone(), film).expect("they belong together");
    let tests = Film::new(ONE_PIXEL, Vec::new()).with(TESTS, vec![3.0]);
    let section = |scene: &SceneOutcome| {
        let evidence = Evidence {
            name: scene.name.clone(),
            passes: false,
            said: String::new(),
            attempted: true,
            points: None,
            verdict: None,
            golden: &golden,
            film: None,
            heat: HeatMaps::alone(&tests),
            scene: None,
            rays: None,
            own_rays: SubmittedRays::Unknown,
            unanswered: None,
            beliefs: None,
            remarks: vec!["note: the code chose which".into()],
            command: String::new(),
            explain: None,
        };
        SceneSection::of(0, evidence, 20_000)
    };
    for reveal in REVEALS {
        for scenes in [vec!["exam".into()], Vec::new()] {
            let withheld = Withheld {
                scenes,
                scene_groups: Vec::new(),
                probes: false,
                reveal,
            };
            let mut outcome = outcome();
            outcome.tasks[0].groups.truncate(2);
            let mut report = Report {
                scenes: outcome.scenes.iter().map(section).collect(),
                printed: vec!["words".into()],
                more_printed: 1,
                on_printed: Some("much"),
                ..empty_report()
            };
            withheld.redact_report(&mut report, &outcome);
            let has_pictures = |scene: usize| {
                let section = &report.scenes[scene];
                (section.expected.is_some(), section.heat.is_some())
            };
            let shows = !withheld.any() || reveal >= Reveal::Picture;
            assert_eq!(has_pictures(0), (shows, shows), "{reveal:?}");
            assert_eq!(has_pictures(1), (true, true), "{reveal:?}");
            let has_remark = |scene: usize| !report.scenes[scene].remarks.is_empty();
            let shows = !withheld.any() || reveal == Reveal::Full;
            assert_eq!([has_remark(0), has_remark(1)], [shows, true], "{reveal:?}");
            let more = (report.more_printed, report.on_printed);
            let printed = (report.printed.is_empty(), more == (0, None));
            assert_eq!(printed, (withheld.any(), withheld.any()), "{reveal:?}");
        }
    }
}

#[test]
fn a_picture_of_a_withheld_question_is_drawn_only_if_all_is_revealed() {
    let film = || Film::new(ONE_PIXEL, Vec::new()).with(TESTS, vec![3.0]);
    let tests = || Picture::Tests {
        golden: film(),
        film: film(),
    };
    let size = (1.0, 1.0);
    let camera = Camera::new(
        DVec3::ZERO,
        DVec3::X,
        DVec3::Y,
        size,
        Projection::Orthographic,
    );
    let ray = || Picture::Ray {
        question: CameraQuestion {
            camera: camera.expect("view and up differ"),
            pixel: Pixel { i: 0, j: 0 },
            resolution: ONE_PIXEL,
        },
        expected: [0.0; 2],
        got: [0.5; 2],
    };
    let kinds: [&dyn Fn() -> Picture; 2] = [&tests, &ray];
    for (reveal, shows) in REVEALS
        .into_iter()
        .flat_map(|reveal| kinds.map(|shows| (reveal, shows)))
    {
        let withheld = Withheld {
            scenes: Vec::new(),
            scene_groups: vec![("plane".into(), "scenes".into())],
            probes: false,
            reveal,
        };
        let outcome = outcome();
        let picture = |group: &str| GroupPicture {
            task: "plane".into(),
            group: group.into(),
            shows: shows(),
        };
        let mut report = empty_report();
        let pictures = [picture("front"), picture("fresh")];
        report.tasks = vec![TaskSection::of(0, &outcome.tasks[0], &pictures, "")];
        withheld.redact_report(&mut report, &outcome);
        let groups = &report.tasks[0].groups;
        let is_drawn = |group: &GroupRow| group.heat.is_some() || group.ray.is_some();
        let [front, _, fresh] = [0, 1, 2].map(|group| is_drawn(&groups[group]));
        assert_eq!((front, fresh), (true, reveal == Reveal::Full), "{reveal:?}");
    }
}

#[test]
fn student_output_on_withheld_questions_is_removed() {
    let words = "0.5 0.25";
    let spoken = [
        FilmOutcome::Panicked {
            message: words.into(),
            file: words.into(),
            line: 7,
        },
        FilmOutcome::Died { how: words.into() },
        FilmOutcome::Garbled { why: words.into() },
        FilmOutcome::Refused { why: words.into() },
        FilmOutcome::TimedOut {
            seconds: 7.0,
            whole: false,
        },
        FilmOutcome::OutOfMemory { most: 7 << 20 },
    ];
    for outcome in spoken {
        for reveal in REVEALS {
            let redacted = redacted(&outcome, reveal);
            let kept = serde_json::to_string(&redacted).expect("it can be written");
            let said = terminal::outcome(&redacted);
            for shown in [kept, said] {
                assert!(!shown.contains(words) && !shown.contains('7'), "{shown}");
            }
            let shown = match reveal {
                Reveal::Points => Status::Graded,
                _ => outcome.status(),
            };
            assert_eq!(redacted.status(), shown);
        }
        let said = terminal::outcome(&outcome);
        assert!(said.contains(words) || said.contains('7'), "{said}");
    }
}

#[test]
fn revealing_only_points_hides_pixel_counts_and_endings() {
    let scene = |outcome| SceneOutcome::new("exam".into(), 5, outcome, Some(0.25));
    for (outcome, said) in [
        (
            FilmOutcome::Unanswered,
            "does not pass; what was asked is withheld",
        ),
        (
            FilmOutcome::TimedOut {
                seconds: 1.0,
                whole: true,
            },
            "does not pass; what was asked is withheld",
        ),
    ] {
        let mut scene = scene(outcome);
        redact_scene(&mut scene, Reveal::Points);
        assert_eq!(terminal::scene_in_words(&scene), said);
        assert_eq!(scene.seconds, None);
    }
}

#[test]
fn one_withheld_scene_also_withholds_the_questions_about_pixels() {
    let withheld = |scenes: &[&str]| Withheld {
        scenes: scenes.iter().map(|name| (*name).to_owned()).collect(),
        scene_groups: vec![("viewing_ray".into(), "scenes".into())],
        probes: false,
        reveal: Reveal::Message,
    };
    let one = withheld(&["exam"]);
    assert!(one.holds_scene("exam"));
    assert!(!one.holds_scene("bunny"));
    let group = |name: &str| GroupOutcome::new(name.into(), String::new(), 1, wrong(), Vec::new());
    assert!(one.holds_group("viewing_ray", &group("scenes")));
    assert!(!one.holds_group("viewing_ray", &group("corners")));
    assert!(one.any());
    let none = withheld(&[]);
    assert!(!none.holds_group("viewing_ray", &group("scenes")));
    assert!(!none.any());
}
