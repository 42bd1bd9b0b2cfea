use super::testing::{belief, film, golden};
use super::*;
use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use hmac_sha256::Hash;
use pinhole::Fact;
use pinhole::judge::judge;
use pinhole_course::describe::UnansweredPixel;
use pinhole_course::diagnosis::measure::Finding;
use pinhole_course::diagnosis::{Diagnosis, Explanation, Reading};
use pinhole_course::outcome::{AnswerFile, GroupOutcome, TaskOutcome};

const EVIL: &str = "</script><img src=x onerror=alert(1)>";

/// One task with this diagnosis, from a submission with a hostile name.
fn report_examination(diagnosis: Diagnosis) -> Examination {
    let group = GroupOutcome::new(
        "inside".into(),
        "the ray starts inside the sphere".into(),
        3,
        FilmOutcome::Died { how: EVIL.into() },
        vec![Fact::new("got", EVIL)],
    );
    let task = TaskOutcome {
        name: "sphere".into(),
        chapter: "Sphere".into(),
        points: 0,
        possible: 3,
        file: AnswerFile::Compiled,
        groups: vec![group],
        diagnosis,
        measured: Vec::new(),
        warnings: String::new(),
    };
    let mut outcome = Outcome::new("Ray casting", EVIL.into(), "none");
    outcome.tasks.push(task);
    outcome.printed = EVIL.into();
    outcome.add_up();
    Examination {
        outcome,
        films: Vec::new(),
        pictures: Vec::new(),
    }
}

fn report(diagnosis: Diagnosis) -> Report {
    report_on(&report_examination(diagnosis))
}

fn report_on(examination: &Examination) -> Report {
    let again = RepeatCommands {
        whole: EVIL.into(),
        part: EVIL.into(),
    };
    let report = Report::of_examination(examination, Path::new(""), &again);
    report.expect("no scene needs to be read")
}

fn html(diagnosis: Diagnosis) -> String {
    report(diagnosis).html()
}

#[test]
fn each_belief_has_three_hints_one_inside_the_other() {
    let beliefs = vec![
        belief("A first <b> `c < d`.", 1.0),
        belief("A second.", 1.0),
    ];
    let page = html(Diagnosis {
        beliefs,
        reading: Reading::OneOf,
    });
    assert!(page.contains("One of these beliefs explains all that is wrong here"));
    assert!(page.contains("<q>A first &lt;b&gt; <code>c &lt; d</code>.</q>"));
    assert!(page.contains("17 of the public solutions"));
    let hints: Vec<&str> = page.split("<details class=\"hint\">").skip(1).collect();
    assert_eq!(hints.len(), 6);
    for three in hints.chunks(3) {
        let closed = |text: &str| text.matches("</details>").count();
        assert_eq!((closed(three[0]), closed(three[1])), (0, 0));
        assert!(closed(three[2]) >= 3);
        assert!(three[2].contains("<p>The roots are −2 and 2.</p>"));
        assert!(three[2].contains("section “Which root counts”"));
    }
}

#[test]
fn without_a_diagnosis_the_chapter_is_named_and_no_belief() {
    let page = html(Diagnosis::default());
    assert!(!page.contains("believe"));
    assert!(page.contains("<dd>the book&#x27;s chapter “Sphere”</dd>"));
}

#[test]
fn a_book_on_this_machine_is_one_click_away() {
    let beliefs = vec![belief("A belief.", 1.0)];
    let reading = Reading::OneOf;
    let mut report = report(Diagnosis { beliefs, reading });
    report.book = Some("file:///course/book".into());
    let page = report.html().replace("&#x2f;", "/");
    for place in ["sphere.html", "sphere.html#which-root-counts"] {
        let link = format!("<a href=\"file:///course/book/{place}\">book/{place}</a>");
        assert!(page.contains(&link), "{link}");
    }
}

#[test]
fn student_text_is_never_markup() {
    let page = html(Diagnosis::default());
    assert!(!page.contains("<img"), "{page}");
    assert_eq!(page.matches("</script>").count(), 2);
    assert!(page.matches("&lt;img src=x").count() >= 5);
}

#[test]
fn the_policy_lets_the_pages_own_style_and_script_pass_and_nothing_else() {
    let page = html(Diagnosis::default());
    for (tag, name) in [("<style>", "style"), ("<script>", "script")] {
        let (_, behind) = page.split_once(tag).expect("there is one");
        let (text, _) = behind.split_once("</").expect("it ends");
        let hash = STANDARD.encode(Hash::hash(text.as_bytes()));
        let allowed = format!(
            "{name}-src &#x27;sha256-{}&#x27;",
            hash.replace('/', "&#x2f;")
        );
        assert!(page.contains(&allowed), "no {allowed}");
    }
    assert!(page.contains("default-src &#x27;none&#x27;"));
    assert!(!page.contains("unsafe-"));
}

#[test]
fn data_for_the_script_ends_no_element() {
    let data = page::for_script(&serde_json::json!({ "name": EVIL }));
    assert!(!data.contains('<'), "{data}");
    let read: serde_json::Value = serde_json::from_str(&data).expect("it is still JSON");
    assert_eq!(read["name"], EVIL);
}

/// What the terminal says of scenes whose wrong pixels these beliefs explain.
fn scenes(of_task: &[Explanation], of_scenes: &[Explanation]) -> String {
    terminal::scenes(&scene_examination(of_task, of_scenes))
}

/// Two scenes whose wrong pixels these beliefs explain.
fn scene_examination(of_task: &[Explanation], of_scenes: &[Explanation]) -> Examination {
    let beliefs = |beliefs: &[Explanation]| Diagnosis {
        beliefs: beliefs.to_vec(),
        reading: Reading::Together,
    };
    let golden = golden(&[[0.0, 2.0, 0.0, 0.0, 1.0]], 1e-3);
    let cast = film(&[[0.0, 3.0, 0.0, 0.0, 1.0]]);
    let mut examination = report_examination(beliefs(of_task));
    for name in ["one", "two"] {
        let outcome = FilmOutcome::from(&judge(&golden, &cast));
        let mut scene = SceneOutcome::new(name.into(), 1, outcome, Some(0.5));
        scene.diagnosis = beliefs(of_scenes);
        examination.outcome.scenes.push(scene);
        examination.films.push(SceneFilm {
            file: "scene.toml".into(),
            argument: name.into(),
            golden: golden.clone(),
            film: Some(cast.clone()),
            verdict: None,
            rays: Default::default(),
            tests: None,
            needs: Vec::new(),
            unanswered: None,
        });
    }
    examination
}

#[test]
fn a_scene_counts_a_belief_only_if_a_row_above_spelled_it_out() {
    let told = scenes(&[belief("A.", 1.0)], &[belief("A.", 0.5)]);
    let counted = "the belief above about sphere explains 50 % of what is wrong here";
    assert_eq!(told.matches(counted).count(), 2, "{told}");
    assert!(!told.contains("You may believe"), "{told}");
    let told = scenes(&[], &[belief("A.", 1.0)]);
    assert_eq!(told.matches("You may believe: “A.”").count(), 1, "{told}");
    assert_eq!(told.matches("the belief above about").count(), 1, "{told}");
    // The second scene, which is explained already, gets no more lines.
    assert_eq!(told.matches("worst pixel").count(), 1, "{told}");
}

#[test]
fn a_failing_scene_names_what_was_measured_in_a_task_that_passes() {
    let judged = |t: f32| {
        let cast = film(&[[0.0, t, 0.0, 0.0, 1.0]]);
        FilmOutcome::from(&judge(&golden(&[[0.0, 2.0, 0.0, 0.0, 1.0]], 1e-3), &cast))
    };
    let told = |t| {
        let mut examination = scene_examination(&[], &[]);
        let task = &mut examination.outcome.tasks[0];
        task.measured.push(Finding {
            about: "t".into(),
            says: "t is odd.".into(),
            is_law: true,
        });
        task.groups[0].outcome = judged(t);
        examination.outcome.add_up();
        examination.films[0].needs.push("sphere".into());
        terminal::scenes(&examination)
    };
    let said = "The task `sphere` passes, but: t is odd.";
    assert_eq!(told(2.0).matches(said).count(), 1, "{}", told(2.0));
    assert_eq!(told(3.0).matches(said).count(), 0, "{}", told(3.0));
}

#[test]
fn output_that_may_take_too_long_is_remarked_on() {
    for (lines, is_much) in [(100, false), (100_000, true)] {
        let mut examination = report_examination(Diagnosis::default());
        examination.outcome.printed = "here\n".repeat(lines);
        let said = "Remove this before you hand in";
        let told = terminal::printed(&examination.outcome.printed);
        assert_eq!(told.contains(said), is_much);
        assert_eq!(report_on(&examination).html().contains(said), is_much);
    }
}

#[test]
fn a_scene_without_a_film_says_at_which_pixel_and_gives_a_hint_once() {
    let mut examination = scene_examination(&[], &[]);
    for (k, scene) in examination.outcome.scenes.iter_mut().enumerate() {
        scene.outcome = FilmOutcome::TimedOut {
            seconds: 2.0,
            whole: false,
        };
        examination.films[k].film = None;
        examination.films[k].unanswered = Some(UnansweredPixel {
            pixel: pinhole::Pixel { i: k, j: 7 },
            note: Some("do its loops end?"),
        });
    }
    let told = terminal::scenes(&examination);
    for part in [
        "gave no answer",
        "the same",
        "explain one 0 7",
        "explain two 1 7",
        "note: do",
    ] {
        assert_eq!(told.matches(part).count(), 1, "{part}: {told}");
    }
}

#[test]
fn a_small_share_is_called_a_part() {
    let told = scenes(&[], &[belief("A.", 0.02)]);
    let part = "“A.” That explains part of what is wrong here.";
    assert!(told.contains(part), "{told}");
}

#[test]
fn no_share_is_told_of_beliefs_that_explain_something_together() {
    let told = scenes(&[], &[belief("A.", 0.4), belief("B.", 0.5)]);
    assert!(
        told.contains("“A.” That explains part of what is wrong here."),
        "{told}"
    );
    assert!(!told.contains('%'), "{told}");
}

#[cfg(unix)]
#[test]
fn other_users_cannot_read_a_report() {
    use std::os::unix::fs::PermissionsExt;
    let folder = tempfile::tempdir().expect("there is room");
    let path = folder.path().join("report.html");
    std::fs::write(&path, "an earlier report").expect("there is room");
    page::write(&path, "a golden").expect("there is room");
    assert_eq!(
        std::fs::read_to_string(&path).expect("it is there"),
        "a golden"
    );
    let mode = path.metadata().expect("it is there").permissions().mode();
    assert_eq!(mode & 0o777, 0o600);
    // Another user may read from a pipe of their own.
    let socket = folder.path().join("socket");
    let _listens = std::os::unix::net::UnixListener::bind(&socket).expect("there is room");
    if std::os::unix::fs::chown(&socket, Some(12345), None).is_ok() {
        let refused = page::write(&socket, "a golden").expect_err("it is not ours");
        assert!(refused.to_string().contains("another user"), "{refused}");
    }
    // A student may have handed in a link to a device.
    let link = folder.path().join("link");
    std::os::unix::fs::symlink("/dev/full", &link).expect("there is room");
    page::write(&link, "a golden").expect("the link is replaced");
    assert!(!link.is_symlink());
    page::write(Path::new("/dev/full"), "a golden").expect_err("it is full");
}
