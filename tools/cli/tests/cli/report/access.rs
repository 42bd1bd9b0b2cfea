//! The report by keyboard alone, on a phone, in dark mode, and with a screen reader.

use super::{assert_as_explained, half_a_pixel_off, numbers, report};
use crate::browser::{Browser, DOWN, ENTER, LEFT, RIGHT, SPACE, UP};
use crate::check::with_body;
use pinhole_testing::{root, submission, trusted};

#[test]
fn the_keyboard_alone_reaches_and_reads_everything() {
    let (folder, page) = half_a_pixel_off("report-keyboard");
    let browser = Browser::open(&page);
    browser.wait_for("document.querySelector('.viewer').hidden === false");
    let here = || {
        let said = browser.text("document.querySelector('.reading .cause').textContent");
        let pixel = numbers(said.split(')').next().unwrap_or_default());
        (pixel[0] as usize, pixel[1] as usize)
    };

    browser.tab_to(".views input");
    browser.press(&[RIGHT]);
    let shown = "document.querySelector('.views input:checked').value";
    assert_ne!(browser.text(shown), "id");
    browser.tab_to("[data-zoom=in]");
    browser.press(&[ENTER, SPACE]);
    assert_eq!(
        browser.text("document.querySelector('output').textContent"),
        "4×"
    );

    browser.tab_to(".compare .glass");
    browser.press_with_shift(RIGHT);
    let (i, j) = here();
    browser.press(&[RIGHT, RIGHT, UP, LEFT]);
    assert_eq!(here(), (i + 1, j + 1));
    browser.press_with_shift(LEFT);
    assert_eq!(here(), (i - 9, j + 1));
    assert_as_explained(&browser, &folder, i - 9, j + 1);
    browser.press(&["n"]);
    let first = here();
    browser.press(&["n"]);
    assert_ne!(here(), first);
    browser.press(&["p"]);
    assert_eq!(here(), first);
    browser.press(&["+", "-", "-", "-"]);
    assert_eq!(
        browser.text("document.querySelector('output').textContent"),
        "1×"
    );
    // No key leads out of the picture.
    browser.press(&[DOWN; 95]);
    assert_eq!(here().1, 0);

    browser.tab_to("[type=range]");
    browser.press(&[LEFT, LEFT]);
    assert_eq!(
        browser.text("document.querySelector('[type=range]').value"),
        "48"
    );
    browser.tab_to("[data-cause]");
    browser.press(&[ENTER]);
    assert_eq!(
        browser.text("document.activeElement.getAttribute('aria-pressed')"),
        "true"
    );
    browser.expect_quiet();
}

#[test]
fn page_fits_a_phone_and_has_enough_contrast_in_light_and_dark() {
    let panics = with_body("plane", "panic!(\"a{}\", \"long\".repeat(200));");
    let folder = submission(&trusted(), "report-phone", &[("plane.rs", &panics)]);
    let wrong =
        root().join("assignments/ray_casting/mistakes/viewing_ray_half_pixel_sign/viewing_ray.rs");
    std::fs::copy(wrong, folder.join("viewing_ray.rs")).expect("it can be copied");
    std::fs::write(folder.join("triangle.rs"), "fn broken( {").expect("it can be written");
    let browser = Browser::open(&report(
        &folder,
        &[
            "--task",
            "plane",
            "--task",
            "triangle",
            "--task",
            "viewing_ray",
            "--scene",
            "lone_triangle",
        ],
    ));
    browser.prefer("prefers-reduced-motion", "reduce");
    assert_eq!(
        browser.text("getComputedStyle(document.documentElement).scrollBehavior"),
        "auto"
    );
    for scheme in ["light", "dark"] {
        browser.prefer("prefers-color-scheme", scheme);
        for width in [360, 768, 1280] {
            browser.screen(width, 800);
            let reach = browser.value("Math.max(...[...document.querySelectorAll('body *')].filter((e) => !e.closest('pre, .glass, .unseen, .skip')).map((e) => e.getBoundingClientRect().right))");
            assert!(
                reach.as_f64().expect("a number") <= f64::from(width) + 0.5,
                "{reach} at {width}"
            );
            assert_eq!(browser.value("document.documentElement.scrollWidth"), width);
        }
        assert_eq!(
            browser.value(FAINT_WORDS),
            serde_json::json!([]),
            "{scheme}"
        );
    }
    let ground = "getComputedStyle(document.body).backgroundColor";
    let dark = browser.text(ground);
    browser.prefer("prefers-color-scheme", "light");
    assert_ne!(browser.text(ground), dark);
    browser.expect_quiet();
}

/// Text with a contrast below 4.5 to 1 (WCAG 2.2, 1.4.3).
const FAINT_WORDS: &str = "(() => {
  const channels = (colour) => colour.match(/[\\d.]+/g).map(Number);
  const light = (colour) => {
    const [r, g, b] = channels(colour).map((value) => value / 255)
      .map((value) => (value <= 0.04045 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4));
    return 0.2126 * r + 0.7152 * g + 0.0722 * b;
  };
  const behind = (element) => {
    const ground = getComputedStyle(element).backgroundColor;
    return channels(ground)[3] === 0 ? behind(element.parentElement) : ground;
  };
  const faint = [];
  for (const element of document.querySelectorAll('body *')) {
    const says = [...element.childNodes].some((node) => node.nodeType === 3 && node.data.trim());
    if (!says || element.closest('script, button:disabled, .absent')) continue;
    const [one, other] = [getComputedStyle(element).color, behind(element)].map(light);
    const contrast = (Math.max(one, other) + 0.05) / (Math.min(one, other) + 0.05);
    if (contrast < 4.5) faint.push([element.className, element.textContent.trim().slice(0, 40), contrast]);
  }
  return faint;
})()";

#[test]
fn a_screen_reader_finds_a_name_for_everything_it_can_reach() {
    let (_, page) = half_a_pixel_off("report-reader");
    let browser = Browser::open(&page);
    browser.wait_for("document.querySelector('.viewer').hidden === false");
    let tree = browser.command("Accessibility.getFullAXTree", serde_json::json!({}));
    let nodes = tree["nodes"].as_array().expect("a list");
    let shown = nodes.iter().filter(|node| node["ignored"] != true);
    let mut roles = std::collections::BTreeSet::new();
    for node in shown {
        let role = node["role"]["value"].as_str().unwrap_or_default();
        roles.insert(role);
        let needs_name = [
            "button",
            "slider",
            "radio",
            "image",
            "application",
            "table",
            "heading",
            "link",
            "figure",
            "progressbar",
            "group",
            "region",
        ];
        if needs_name.contains(&role) {
            let name = node["name"]["value"].as_str().unwrap_or_default();
            assert!(
                !name.is_empty() || role == "group",
                "a {role} without a name: {node:#}"
            );
        }
    }
    for role in [
        "heading",
        "table",
        "slider",
        "radio",
        "application",
        "status",
        "button",
        "main",
        "banner",
        "contentinfo",
    ] {
        assert!(roles.contains(role), "no {role} among {roles:?}");
    }
    assert_eq!(browser.text("document.documentElement.lang"), "en");
    assert_eq!(browser.value("document.querySelectorAll('h1').length"), 1);
    let levels = browser
        .value("[...document.querySelectorAll('h1, h2, h3, h4')].map((e) => Number(e.tagName[1]))");
    let levels: Vec<u64> = serde_json::from_value(levels).expect("numbers");
    assert!(
        levels.windows(2).all(|pair| pair[1] <= pair[0] + 1),
        "{levels:?}"
    );
    browser.expect_quiet();
}
