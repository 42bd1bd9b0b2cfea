use pinhole::Fact;
use pinhole::judge::{Golden, judge};

use super::*;
use crate::watch::hints;
use crate::watch::keys::Key;
use pinhole_course::assignment::Assignment;
use pinhole_course::checkout::Checkout;
use pinhole_course::compile::Replacement;
use pinhole_course::goldens::Goldens;
use pinhole_course::outcome::{
    AnswerFile, FilmOutcome, GroupOutcome, Outcome, SceneFilm, SceneOutcome,
};
use pinhole_course::sandbox::Sandbox;
use pinhole_report::html::RepeatCommands;

/// The real course. Nothing is compiled or asked here.
pub(in crate::watch) fn course() -> Course {
    let checkout = Checkout::find().expect("the tests run in a checkout");
    let assignment = Assignment::read(&checkout, "ray_casting").expect("it is committed");
    let goldens = Goldens::read(&assignment.golden(), &assignment);
    let submission = Submission::find(&assignment.reference(), &assignment);
    Course {
        goldens: goldens.expect("they are committed"),
        submission: submission.expect("it is committed"),
        assignment,
        checkout,
        sandbox: Sandbox::Trusted,
        wall: Duration::from_secs(1),
        tasks: Vec::new(),
        report: "report.html".into(),
        again: RepeatCommands {
            whole: String::new(),
            part: String::new(),
        },
    }
}

/// A state, and the clock that it is given.
pub(in crate::watch) struct Watch {
    pub course: Course,
    pub state: State,
    ordered: Option<Order>,
    now: Instant,
}

impl Watch {
    pub fn begin() -> Watch {
        let course = course();
        let mut watch = Watch {
            state: State::new(&course),
            course,
            ordered: None,
            now: Instant::now(),
        };
        let acts = watch.state.begin();
        watch.obey(acts);
        watch
    }

    /// A watch that has judged every task, and these as wrong.
    pub fn with_wrong(wrong: &[&str]) -> Watch {
        let mut watch = Watch::begin();
        watch.judge_all(wrong);
        watch
    }

    fn obey(&mut self, acts: Vec<Action>) -> bool {
        let mut quits = false;
        for act in acts {
            match act {
                Action::Ask(order) => self.ordered = Some(order),
                Action::Report => {}
                Action::Quit => quits = true,
            }
        }
        quits
    }

    /// Handles an event. Returns whether it ends the watch.
    pub fn step(&mut self, event: Event) -> bool {
        let acts = self.state.step(event);
        self.obey(acts)
    }

    pub fn press(&mut self, key: Key) {
        self.step(Event::Key(key));
    }

    pub fn save(&mut self, tasks: &[&str]) {
        self.step(Event::Saved {
            submission: self.course.submission.clone(),
            tasks: tasks.iter().map(ToString::to_string).collect(),
            at: self.now,
        });
    }

    /// The last order.
    fn ordered(&self) -> Vec<&str> {
        let order = self.ordered.as_ref().expect("something was ordered");
        order.items.iter().map(Item::name).collect()
    }

    /// Returns the verdict on one item of the last order, a second after the last event.
    pub fn judge(&mut self, item: &str, passes: bool) {
        let number = self.ordered.as_ref().expect("it was ordered").number;
        self.judge_as(number, item, passes);
    }

    fn judge_as(&mut self, order: u64, item: &str, passes: bool) {
        self.now += Duration::from_secs(1);
        let examination = Box::new(self.examination(item, passes));
        let at = self.now;
        self.step(Event::Judged {
            order,
            examination,
            at,
        });
    }

    fn finish(&mut self) -> bool {
        let order = self.ordered.as_ref().expect("it was ordered").number;
        self.step(Event::Finished { order })
    }

    /// Returns the verdicts on all items of the last order.
    pub fn judge_all(&mut self, wrong: &[&str]) {
        let items: Vec<String> = self.ordered().into_iter().map(String::from).collect();
        for item in items {
            self.judge(&item, !wrong.contains(&item.as_str()));
        }
        self.finish();
    }

    pub fn examination(&self, item: &str, passes: bool) -> Examination {
        let goldens = &self.course.goldens;
        let golden = Golden::read(&goldens.folder.join("lone_triangle.exr")).expect("it is there");
        let outcome = match passes {
            true => FilmOutcome::from(&judge(&golden, golden.film())),
            false => FilmOutcome::Died {
                how: "badly".into(),
            },
        };
        let mut made = Outcome::new("a test", "here".into(), "none");
        let mut films = Vec::new();
        match self.course.assignment.task(item) {
            Some(task) => {
                let why = Replacement::DoesNotCompile(String::new());
                let mut task = TaskOutcome::replaced(task, &why);
                task.file = AnswerFile::Compiled;
                for group in &mut task.groups {
                    let GroupOutcome {
                        name,
                        about,
                        possible,
                        ..
                    } = group.clone();
                    *group = GroupOutcome::new(name, about, possible, outcome.clone(), vec![]);
                }
                made.tasks.push(task);
            }
            None => {
                for scene in &goldens.scenes {
                    let (name, worth) = (scene.name.clone(), scene.worth);
                    let scene_outcome = SceneOutcome::new(name, worth, outcome.clone(), Some(0.5));
                    made.scenes.push(scene_outcome);
                    films.push(SceneFilm {
                        file: scene.file.clone(),
                        argument: scene.argument.clone(),
                        golden: golden.clone(),
                        film: None,
                        verdict: None,
                        rays: Default::default(),
                        tests: None,
                        needs: Vec::new(),
                        unanswered: None,
                    });
                }
            }
        }
        made.add_up();
        Examination {
            outcome: made,
            films,
            pictures: Vec::new(),
        }
    }

    #[track_caller]
    fn expect_shown(&self, item: &str) {
        let shown = self.state.item().map_or("everything", Item::name);
        assert_eq!(shown, item);
    }
}

#[test]
fn it_begins_at_the_first_task_with_missing_points_and_stays_there() {
    let mut watch = Watch::begin();
    assert_eq!(watch.ordered().len(), 6, "the scenes come last");
    assert_eq!(watch.ordered()[0], "plane", "the one to begin with");
    watch.judge("plane", true);
    watch.expect_shown("viewing_ray");
    watch.judge("viewing_ray", false);
    watch.judge("sphere", false);
    watch.expect_shown("viewing_ray");
}

#[test]
fn a_save_of_another_file_moves_the_watch_there_and_says_so() {
    let mut watch = Watch::with_wrong(&["sphere"]);
    watch.save(&["triangle"]);
    watch.expect_shown("triangle");
    assert_eq!(watch.ordered(), ["triangle"]);
    let notice = watch.state.notice.as_deref().unwrap_or_default();
    assert!(notice.contains("triangle.rs"), "{notice}");
}

#[test]
fn verdict_on_older_answers_is_stale() {
    let mut watch = Watch::with_wrong(&["sphere"]);
    watch.save(&["sphere"]);
    let older = watch.ordered.as_ref().expect("it was ordered").number;
    let sphere = Item::Task("sphere".into());
    assert!(
        !watch.state.has_verdict(&sphere),
        "its verdict is gone at once"
    );
    watch.save(&["sphere"]);
    watch.judge_as(older, "sphere", true);
    assert!(
        !watch.state.has_verdict(&sphere),
        "this was about other answers"
    );
    watch.judge("sphere", true);
    assert!(watch.state.is_full(&sphere));
}

#[test]
fn interrupted_items_are_asked_again() {
    let mut watch = Watch::begin();
    watch.judge("viewing_ray", true);
    watch.save(&["plane"]);
    let expected = ["plane", "sphere", "triangle", "triangle_soup", "first_hit"];
    assert_eq!(watch.ordered(), expected);
}

#[test]
fn the_time_from_save_to_verdict_spans_all_that_came_between() {
    let mut watch = Watch::with_wrong(&["sphere", "plane"]);
    watch.save(&["sphere"]);
    watch.save(&["plane"]);
    assert_eq!(watch.ordered(), ["plane", "sphere"]);
    watch.judge("plane", false);
    watch.judge("sphere", false);
    let after = |task: &str| watch.state.after_save(&Item::Task(task.into()));
    assert_eq!(after("plane"), Some(Duration::from_secs(1)));
    assert_eq!(after("sphere"), Some(Duration::from_secs(2)));
    assert_eq!(after("triangle"), None, "nobody saved it");
}

#[test]
fn scenes_come_once_every_task_passes_with_current_verdicts() {
    let mut watch = Watch::with_wrong(&["plane"]);
    watch.save(&["plane"]);
    watch.judge_all(&[]);
    watch.expect_shown("scenes");
    let expected = [
        "viewing_ray",
        "sphere",
        "triangle",
        "triangle_soup",
        "first_hit",
        "scenes",
    ];
    assert_eq!(watch.ordered(), expected);
    watch.judge_all(&[]);
    assert!(!watch.state.is_judging(), "then all is done");
    assert_eq!(watch.state.points(), (100, 100));
}

#[test]
fn next_goes_to_the_first_task_that_lacks_points_or_else_to_the_next() {
    let mut watch = Watch::with_wrong(&["sphere", "triangle"]);
    watch.expect_shown("sphere");
    watch.press(Key::Next);
    watch.expect_shown("triangle");
    watch.press(Key::Next);
    watch.expect_shown("triangle_soup");
    watch.press(Key::Next);
    watch.expect_shown("sphere");
    for before in ["viewing_ray", "plane", "scenes"] {
        watch.press(Key::Previous);
        watch.expect_shown(before);
    }
    assert_eq!(watch.ordered(), ["scenes"]);
}

#[test]
fn going_back_to_an_older_verdict_renews_it() {
    let mut watch = Watch::with_wrong(&["sphere", "triangle"]);
    watch.save(&["triangle"]);
    watch.judge_all(&["triangle"]);
    watch.press(Key::Previous);
    assert_eq!(watch.ordered(), ["sphere"], "it may call what was saved");
    watch.judge_all(&["sphere"]);
    let order = watch.ordered.as_ref().map(|order| order.number);
    watch.press(Key::Next);
    watch.press(Key::Previous);
    assert_eq!(watch.ordered.as_ref().map(|order| order.number), order);
}

#[test]
fn each_press_shows_another_hint_and_a_save_hides_them() {
    let mut watch = Watch::with_wrong(&["sphere"]);
    let all = hints::of(&watch.state);
    assert!(all[0].contains("`outside` asks about rays"), "{all:?}");
    assert!(
        all.last()
            .is_some_and(|last| last.contains("book/src/sphere.md)"))
    );
    for shown in [1, 2, 3, 3] {
        watch.press(Key::Hint);
        assert_eq!(watch.state.hints, shown);
    }
    watch.save(&["sphere"]);
    assert_eq!(watch.state.hints, 0);
}

#[test]
fn the_first_hint_on_a_panic_or_an_endless_loop_is_the_one_about_it() {
    let mut watch = Watch::with_wrong(&["sphere"]);
    let mut tasks = watch.state.known.outcome.tasks.iter_mut();
    let sphere = tasks.find(|task| task.name == "sphere");
    let group = &mut sphere.expect("it was judged").groups[0];
    group.worst.push(Fact::new("note", "do its loops end?"));
    let all = hints::of(&watch.state);
    assert_eq!(all[0], "note: do its loops end?");
    assert!(all[1].contains("`outside` asks about rays"), "{all:?}");
}

#[test]
fn the_report_waits_until_everything_is_judged() {
    let mut watch = Watch::with_wrong(&["sphere"]);
    watch.press(Key::Report);
    assert_eq!(watch.ordered(), ["scenes"]);
    watch.judge("scenes", false);
    let order = watch.ordered.as_ref().expect("it was ordered").number;
    let acts = watch.state.step(Event::Finished { order });
    assert!(matches!(acts.as_slice(), [Action::Report]), "{acts:?}");
    let acts = watch.state.step(Event::Key(Key::Report));
    assert!(matches!(acts.as_slice(), [Action::Report]), "{acts:?}");
}

#[test]
fn a_problem_stays_until_the_folder_is_back() {
    let mut watch = Watch::with_wrong(&["sphere"]);
    watch.step(Event::Lost(Error::input("it is gone", "bring it back")));
    assert!(watch.state.problem.is_some());
    watch.save(&[]);
    assert!(watch.state.problem.is_none());
}

#[test]
fn closed_input_ends_the_watch_after_the_running_order() {
    let mut watch = Watch::begin();
    assert!(!watch.step(Event::Closed));
    for task in [
        "viewing_ray",
        "sphere",
        "plane",
        "triangle",
        "triangle_soup",
    ] {
        watch.judge(task, false);
    }
    watch.judge("first_hit", false);
    assert!(watch.finish());
    assert!(Watch::with_wrong(&["sphere"]).step(Event::Closed));
    assert!(Watch::begin().step(Event::Quit));
}
