use super::*;
use crate::watch::Event;
use crate::watch::keys::Key;
use crate::watch::state::tests::Watch;

/// The letters alone, as a person sees them.
fn text(frame: &Frame) -> String {
    let plain = anstream::adapter::strip_str(&frame.lines.join("\n")).to_string();
    plain.replace('\u{a0}', " ")
}

#[test]
fn a_frame_fits_every_screen() {
    let mut watch = Watch::with_wrong(&["sphere"]);
    let views: [&[Key]; 4] = [
        &[],
        &[Key::Hint, Key::Hint],
        &[Key::Help],
        &[Key::Everything],
    ];
    for keys in views {
        keys.iter().for_each(|key| watch.press(*key));
        for columns in [10, 20, 60, 80, 200] {
            for rows in [1, 2, 5, 12, 24, 60] {
                let frame = frame(&watch.state, columns, rows);
                assert!(frame.lines.len() <= rows, "{} of {rows}", frame.lines.len());
                for line in &frame.lines {
                    let width = textwrap::core::display_width(line);
                    assert!(width <= columns, "{width} of {columns}: {line:?}");
                }
            }
        }
    }
}

#[test]
fn ordinary_screens_hold_the_verdict_the_progress_and_every_key() {
    let watch = Watch::with_wrong(&["sphere"]);
    for (columns, rows) in [(80, 24), (60, 24)] {
        let text = text(&frame(&watch.state, columns, rows));
        assert!(text.starts_with("✗ sphere    0 / 18"), "{text}");
        assert!(text.contains("5 / 6 tasks, 62 / 100 points"), "{text}");
        for state in ["✓ plane", "✗ sphere", "… scenes"] {
            assert!(text.contains(state), "{state} in\n{text}");
        }
        // A long path is broken wherever the screen ends.
        let unbroken: String = text.split_whitespace().collect();
        assert!(unbroken.contains("sphere.rs"), "{text}");
        for (key, _, name, _) in KEYS {
            assert!(text.contains(&format!("{key}:{name}")), "{key} in\n{text}");
        }
    }
    // All keys fit into one line of an ordinary terminal.
    assert!(text(&frame(&watch.state, 80, 24)).ends_with("?:help"));
    let last = frame(&watch.state, 80, 24).lines.pop().unwrap_or_default();
    assert!(last.contains("hint"), "{last}");
}

#[test]
fn a_long_verdict_is_scrolled_as_far_as_its_end() {
    let mut watch = Watch::with_wrong(&["sphere"]);
    watch.press(Key::Everything);
    watch.judge_all(&["sphere"]);
    let first = frame(&watch.state, 80, 12);
    assert!(text(&first).contains("more"), "{}", text(&first));
    watch.press(Key::Scroll(1000));
    let end = frame(&watch.state, 80, 12);
    assert!(
        end.scroll < 1000 && text(&end).contains("total"),
        "{}",
        text(&end)
    );
}

#[test]
fn control_characters_in_a_verdict_are_escaped() {
    let mut watch = Watch::begin();
    let mut examination = watch.examination("plane", false);
    let rude = "\u{1b}]0;owned\u{7}\u{1b}[2J";
    examination.outcome.printed = rude.into();
    examination.outcome.tasks[0].groups[0].outcome =
        pinhole_course::outcome::FilmOutcome::Died { how: rude.into() };
    watch.step(Event::Judged {
        order: 1,
        examination: Box::new(examination),
        at: std::time::Instant::now(),
    });
    let lines = frame(&watch.state, 80, 24).lines.join("\n");
    assert!(lines.contains("owned"), "{lines}");
    assert!(
        !lines.contains("\u{1b}]") && !lines.contains("\u{1b}[2J"),
        "{lines}"
    );
}

#[test]
fn a_verdict_says_how_long_it_took() {
    let mut watch = Watch::with_wrong(&["sphere", "plane"]);
    watch.save(&["sphere"]);
    let judging = text(&frame(&watch.state, 80, 24));
    assert!(judging.contains("judging sphere …"), "{judging}");
    watch.judge("sphere", true);
    let judged = text(&frame(&watch.state, 80, 24));
    assert!(
        judged.contains("judged 1.00 s after you saved; press n to go on"),
        "{judged}"
    );
}
