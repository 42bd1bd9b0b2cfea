//! Reading the report with a mouse: the divider, pixels, causes and hints.

use super::{SCENE, assert_as_explained, half_a_pixel_off, mistaken, numbers, report};
use crate::browser::{Browser, ENTER};
use pinhole_testing::{fresh, pinhole, root, trusted};

/// An expression for the samples of a canvas. It reads them from a copy, because browsers
/// complain about a canvas that is read often.
fn samples(canvas: &str) -> String {
    format!(
        "((c) => {{ const copy = new OffscreenCanvas(c.width, c.height).getContext('2d', {{ willReadFrequently: true }}); \
         copy.drawImage(c, 0, 0); return copy.getImageData(0, 0, c.width, c.height).data; }})(document.querySelector('canvas.{canvas}'))"
    )
}

#[test]
fn a_failing_pixel_is_read_by_mouse_and_says_what_explain_says() {
    let (folder, page) = half_a_pixel_off("report-mouse");
    let browser = Browser::open(&page);
    browser.wait_for("document.querySelector('.viewer').hidden === false");
    assert_eq!(
        browser.value("document.querySelector('.stills').offsetHeight"),
        0
    );

    // Column 80 of 160, row 30 from the bottom of 90.
    let [x, y, ..] = browser.rectangle(".compare .sheet", 80.5 / 160.0, 1.0 - 30.5 / 90.0);
    browser.click(x, y);
    assert_as_explained(&browser, &folder, 80, 30);
    let heard = browser.text("document.querySelector('[role=status]').textContent");
    assert!(heard.starts_with("Pixel 80, 30: "), "{heard}");
    let command = browser.text("document.querySelector('.reading code').textContent");
    assert!(
        command.starts_with("cargo pinhole explain sphere_and_plane 80 30 --submission "),
        "{command}"
    );

    // The difference picture can be clicked too.
    let [x, y, ..] = browser.rectangle(
        ".pane:not(.compare) .sheet",
        10.5 / 160.0,
        1.0 - 89.5 / 90.0,
    );
    browser.click(x, y);
    assert_as_explained(&browser, &folder, 10, 89);
    browser.expect_quiet();
}

#[test]
fn the_divider_shows_more_of_what_was_expected_or_more_of_yours() {
    let (_, page) = half_a_pixel_off("report-divider");
    let browser = Browser::open(&page);
    browser.wait_for("document.querySelector('.viewer').hidden === false");
    let clip = || {
        let clip = browser.text("document.querySelector('.yours').style.clipPath");
        clip.split([' ', '%'])
            .find_map(|part| part.parse::<f64>().ok().filter(|share| *share != 0.0))
            .unwrap_or(0.0)
    };
    assert!((clip() - 50.0).abs() < 1.0);
    // A click on the slider's track moves the divider, as dragging does.
    let [x, y, ..] = browser.rectangle(".slide input", 0.25, 0.5);
    browser.click(x, y);
    assert!((clip() - 25.0).abs() < 3.0, "{}", clip());
    browser.click_on("[data-divider='100']");
    assert!((clip() - 100.0).abs() < 0.5, "{}", clip());
    assert_eq!(
        browser.value("getComputedStyle(document.querySelector('.of-yours')).visibility"),
        "hidden"
    );
    browser.click_on("[data-divider='0']");
    assert!(clip() < 0.5);
    assert_eq!(
        browser.value("getComputedStyle(document.querySelector('.of-expected')).visibility"),
        "hidden"
    );
    browser.expect_quiet();
}

#[test]
fn failing_pixels_are_counted_by_cause_and_shown_by_cause() {
    let (_, page) = half_a_pixel_off("report-causes");
    let browser = Browser::open(&page);
    browser.wait_for("document.querySelector('.viewer').hidden === false");
    let counts = browser.value("[...document.querySelectorAll('.causes .number')].slice(1).map((cell) => Number(cell.textContent))");
    let counts: Vec<u64> = serde_json::from_value(counts).expect("numbers");
    let said = browser.text("document.querySelector('.card .said').textContent");
    assert_eq!(
        counts.iter().sum::<u64>() as f64,
        numbers(&said)[0],
        "{counts:?} {said}"
    );

    // If a cause is chosen, only its pixels stay bright.
    let bright = format!(
        "(() => {{ const data = {}; let count = 0; for (let k = 0; k < data.length; k += 4) \
         count += Math.max(data[k], data[k + 1], data[k + 2]) > 240; return count; }})()",
        samples("difference")
    );
    let bright = bright.as_str();
    for (k, count) in counts.iter().enumerate() {
        let button = format!("tr:nth-child({}) [data-cause]", k + 1);
        browser.click_on(&button);
        assert_eq!(browser.value(bright), *count, "cause {k}");
        browser.click_on(&button);
    }
    assert_eq!(browser.value(bright), counts.iter().sum::<u64>());
    browser.expect_quiet();
}

#[test]
fn the_pages_pictures_are_those_that_render_draws() {
    let (folder, page) = half_a_pixel_off("report-pictures");
    let out = fresh(&trusted(), "report-pictures-out");
    let [out_name, folder] = [&out, &folder].map(|path| path.to_str().expect("plain"));
    pinhole(&["render", SCENE, "--submission", folder, "--out", out_name]).expect_code(0);
    let browser = Browser::open(&page);
    browser.wait_for("document.querySelector('.viewer').hidden === false");
    for view in ["id", "depth", "normal"] {
        browser.click_on(&format!("[value={view}]"));
        let drawn = browser.value(&format!("[...{}]", samples("yours")));
        let drawn: Vec<u8> = serde_json::from_value(drawn).expect("bytes");
        let picture = image::open(out.join(format!("{view}.png")))
            .expect("render wrote it")
            .to_rgba8();
        let far = picture
            .iter()
            .zip(&drawn)
            .filter(|(one, other)| one.abs_diff(**other) > 2)
            .count();
        assert_eq!((picture.len(), far), (drawn.len(), 0), "{view}");
    }
}

#[test]
fn hints_open_one_after_the_other() {
    let folder = mistaken("report-hints", "sphere_near_root_only", "sphere.rs");
    let browser = Browser::open(&report(&folder, &["--task", "sphere"]));
    let text = std::fs::read_to_string(
        root().join("assignments/ray_casting/mistakes/sphere_near_root_only/mistake.toml"),
    );
    let mistake: toml::Table = text.expect("it is there").parse().expect("it is TOML");
    // The page shows as code what stands between backquotes.
    let plain = |words: &toml::Value| words.as_str().expect("a text").replace('`', "");
    let hint = |depth: &str| plain(&mistake["hint"][depth]);
    let seen = || browser.text("document.body.innerText");
    assert!(seen().contains(&plain(&mistake["belief"])), "{}", seen());
    for depth in ["look", "think", "read"] {
        assert!(!seen().contains(&hint(depth)), "{depth} is there too early");
        browser.tab_to(".hint:not([open]) > summary");
        browser.press(&[ENTER]);
        assert!(seen().contains(&hint(depth)), "{depth} in {}", seen());
    }
    assert!(seen().contains("section “Which root counts”"), "{}", seen());
    browser.expect_quiet();
}
