//! The report, in a real browser, by mouse, by keyboard and on a phone.

use std::path::{Path, PathBuf};

use serde_json::Value;

use crate::browser::{Browser, DOWN, ENTER, LEFT, RIGHT, SPACE, UP};
use crate::check::with_body;
use crate::course::{fresh, pinhole, root, submission, trusted};

/// Scene of the tests: small, and with a sphere in front of a plane.
const SCENE: &str = "sphere_and_plane";

/// The answer files of a known mistake over the reference's.
fn mistaken(name: &str, slug: &str, file: &str) -> PathBuf {
    let wrong = root().join("assignments/ray_casting/mistakes").join(slug);
    let text = std::fs::read_to_string(wrong.join(file)).expect("the mistake has it");
    submission(&trusted(), name, &[(file, &text)])
}

/// Checks a folder and gives its report.
#[track_caller]
fn report(folder: &Path, arguments: &[&str]) -> PathBuf {
    let page = folder.join("report.html");
    let [folder, path] = [folder, &page].map(|path| path.to_str().expect("plain"));
    let all = [&["check", folder, "--report", path], arguments].concat();
    pinhole(&all)
        .expect_code(1)
        .expect_out(&format!("report: {path}"));
    page
}

/// A report of a scene whose rays are all half a pixel off.
fn half_a_pixel_off(name: &str) -> (PathBuf, PathBuf) {
    let folder = mistaken(name, "viewing_ray_half_pixel_sign", "viewing_ray.rs");
    let page = report(&folder, &["--scene", SCENE]);
    (folder, page)
}

/// An expression for the samples of a canvas, read from a copy: browsers complain of
/// canvases that are read often.
fn samples(canvas: &str) -> String {
    format!(
        "((c) => {{ const copy = new OffscreenCanvas(c.width, c.height).getContext('2d', {{ willReadFrequently: true }}); \
         copy.drawImage(c, 0, 0); return copy.getImageData(0, 0, c.width, c.height).data; }})(document.querySelector('canvas.{canvas}'))"
    )
}

/// The numbers in a text, in order.
fn numbers(text: &str) -> Vec<f64> {
    let text = text.replace('−', "-");
    let pieces = text.split(|c: char| !(c.is_ascii_digit() || "-.e".contains(c)));
    pieces.filter_map(|piece| piece.parse().ok()).collect()
}

#[track_caller]
fn assert_near(shown: &str, values: &[&Value]) {
    let flat = values.iter().flat_map(|value| match value {
        Value::Array(axes) => axes.clone(),
        other => vec![(*other).clone()],
    });
    let values: Vec<f64> = flat
        .map(|value| value.as_f64().expect("a number"))
        .collect();
    let shown = numbers(shown);
    assert_eq!(shown.len(), values.len(), "{shown:?} {values:?}");
    for (shown, value) in shown.iter().zip(&values) {
        assert!(
            (shown - value).abs() <= 2e-5 * value.abs() + 1e-6,
            "{shown} is not {value}"
        );
    }
}

/// Checks that what the page says of a pixel is what `explain` says.
#[track_caller]
fn assert_as_explained(browser: &Browser, folder: &Path, i: usize, j: usize) {
    let folder = folder.to_str().expect("plain");
    let [i, j] = [i, j].map(|k| k.to_string());
    let explained = pinhole(&["explain", SCENE, &i, &j, "--submission", folder, "--json"]).json();
    let cell = |row: usize, column: usize| {
        browser.text(&format!(
            "document.querySelectorAll('.pixel tbody tr')[{row}].children[{column}].textContent"
        ))
    };
    assert!(
        browser
            .text("document.querySelector('.reading .cause').textContent")
            .contains(&format!("({i}, {j})"))
    );
    let ray = &explained["expected"]["ray"];
    let shown = |k: usize| {
        browser.text(&format!(
            "document.querySelectorAll('.ray dd')[{k}].textContent"
        ))
    };
    assert_near(&shown(0), &[&ray["origin"]]);
    assert_near(&shown(1), &[&ray["direction"]]);
    assert_near(&shown(2), &[&explained["min_t"]]);
    for (column, hit) in [
        (1, &explained["expected"]["first_hit"]),
        (2, &explained["first_hit"]),
    ] {
        if hit.is_null() {
            assert_eq!(cell(0, column), "no hit");
            continue;
        }
        let at = &hit["intersection"];
        assert_near(&cell(0, column), &[&hit["object"]]);
        assert_near(&cell(1, column), &[&at["t"]]);
        for axis in 0..3 {
            assert_near(&cell(2 + axis, column), &[&at["normal"][axis]]);
        }
    }
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
        command.starts_with("cargo run --release -- explain sphere_and_plane 80 30 --submission "),
        "{command}"
    );

    // The difference is a picture to click on as well.
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
    // Dragging along the slider, as a click on its track does.
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

    // A chosen cause leaves as many bright pixels as it has.
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
fn hints_open_one_behind_the_other() {
    let folder = mistaken("report-hints", "sphere_near_root_only", "sphere.rs");
    let browser = Browser::open(&report(&folder, &["--task", "sphere"]));
    let text = std::fs::read_to_string(
        root().join("assignments/ray_casting/mistakes/sphere_near_root_only/mistake.toml"),
    );
    let mistake: toml::Table = text.expect("it is there").parse().expect("it is TOML");
    let hint = |depth: &str| mistake["hint"][depth].as_str().expect("a hint").to_owned();
    let seen = || browser.text("document.body.innerText");
    assert!(
        seen().contains(mistake["belief"].as_str().expect("a belief")),
        "{}",
        seen()
    );
    for depth in ["look", "think", "read"] {
        assert!(!seen().contains(&hint(depth)), "{depth} is there too early");
        browser.tab_to(".hint:not([open]) > summary");
        browser.press(&[ENTER]);
        assert!(seen().contains(&hint(depth)), "{depth} in {}", seen());
    }
    assert!(
        seen().contains("book/sphere.html#which-root-counts"),
        "{}",
        seen()
    );
    browser.expect_quiet();
}

#[test]
fn what_a_student_prints_or_names_is_text_and_nothing_else() {
    let evil =
        "</script><img src=x onerror='document.title=666'><script>document.title=666</script>";
    let panic = format!("println!(\"{evil}\"); panic!(\"{evil}\");");
    let folder = submission(
        &trusted(),
        "report-evil<img src=x onerror='document.title=666'>",
        &[("plane.rs", &with_body("plane", &panic))],
    );
    std::fs::write(
        folder.join("triangle.rs"),
        format!("compile_error!(\"{evil}\");"),
    )
    .expect("it can be written");
    let page = report(
        &folder,
        &["--task", "plane", "--task", "triangle", "--scene", SCENE],
    );
    let browser = Browser::open(&page);
    assert!(browser.text("document.title").contains("Ray casting"));
    assert_eq!(
        browser.value("document.querySelectorAll('img[src=x]').length"),
        0
    );
    let seen = browser.text("document.body.innerText");
    // Folder, panics, compiler and output: all four are shown as they are.
    assert!(
        seen.matches("<img src=x onerror='document.title=666'>")
            .count()
            >= 4,
        "{seen}"
    );
    browser.expect_quiet();

    // Were something to slip through, the policy would still not let it run.
    browser.value("document.body.insertAdjacentHTML('beforeend', \"<img src='x' onerror='document.title=666'>\")");
    browser.value("document.body.append(Object.assign(document.createElement('script'), { textContent: 'document.title=666' }))");
    std::thread::sleep(std::time::Duration::from_millis(200));
    assert!(browser.text("document.title").contains("Ray casting"));
}

#[test]
fn nothing_sticks_out_on_a_phone_and_every_word_is_readable_in_light_and_dark() {
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

/// Words with less contrast than 4.5 to 1 (WCAG 2.2, 1.4.3) on what is behind them.
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
fn diff_writes_a_report_beside_its_pictures() {
    let (folder, _) = half_a_pixel_off("report-diff");
    let out = folder.join("out");
    let [folder, out_name] = [&folder, &out].map(|path| path.to_str().expect("plain"));
    pinhole(&["render", SCENE, "--submission", folder, "--out", out_name]).expect_code(0);
    let film = out.join("film.exr");
    let golden = format!("golden/ray_casting/{SCENE}.exr");
    let ran = pinhole(&[
        "diff",
        &golden,
        film.to_str().expect("plain"),
        "--out",
        out_name,
    ]);
    ran.expect_code(1).expect_out("report.html");
    let browser = Browser::open(&out.join("report.html"));
    browser.wait_for("document.querySelector('.viewer').hidden === false");
    // The golden is the assignment's, so the scene is known, and the rays lie beside it.
    let reading = browser.text("document.querySelector('.reading').innerText");
    assert!(
        reading.contains("(plane)") && reading.contains("min_t"),
        "{reading}"
    );
    browser.expect_quiet();
}

#[test]
fn every_scene_failing_everywhere_is_still_less_than_two_megabytes() {
    let folder = mistaken(
        "report-size",
        "viewing_ray_half_pixel_sign",
        "viewing_ray.rs",
    );
    let page = report(&folder, &[]);
    let size = page.metadata().expect("it was written").len();
    assert!(size < 2_000_000, "{size}");
    let browser = Browser::open(&page);
    browser.value(
        "document.querySelectorAll('details.scene').forEach((card) => { card.open = true; })",
    );
    browser.wait_for("[...document.querySelectorAll('.viewer')].every((viewer) => !viewer.hidden)");
    assert_eq!(
        browser.value("document.querySelectorAll('.viewer').length"),
        12
    );
    browser.expect_quiet();
}

#[test]
fn check_writes_a_report_unless_told_not_to_and_says_where() {
    let reference = "assignments/ray_casting/reference";
    let default = root().join("target/pinhole/report.html").canonicalize();
    let json = |arguments: &[&str]| {
        let all = [
            &["check", reference, "--task", "plane", "--json"],
            arguments,
        ]
        .concat();
        pinhole(&all).expect_code(0).json()["report"].clone()
    };
    let said = json(&[]);
    let said = Path::new(said.as_str().expect("a path"))
        .canonicalize()
        .expect("it is there");
    assert_eq!(said, default.expect("it is there"));
    assert_eq!(json(&["--no-report"]), Value::Null);
    let own = fresh(&trusted(), "report-own").join("deep/mine.html");
    let own = own.to_str().expect("plain");
    assert_eq!(json(&["--report", own]), own);
    assert!(Path::new(own).is_file());
    pinhole(&[
        "check",
        reference,
        "--task",
        "plane",
        "--report",
        "/dev/null/report.html",
    ])
    .expect_code(2)
    .expect_out("12 / 12")
    .expect_err("cannot write the report");
}

#[test]
fn a_scene_that_was_not_cast_shows_what_was_expected_and_why() {
    let page = trusted().join("report-unanswered.html");
    let path = page.to_str().expect("plain");
    pinhole(&["check", "assignments/ray_casting/handout", "--report", path]).expect_code(1);
    let browser = Browser::open(&page);
    assert_eq!(
        browser.value("document.querySelectorAll('.viewer').length"),
        0
    );
    let seen = browser.text("document.body.innerText");
    assert!(
        seen.contains("0 of 100 points") && seen.contains("unanswered"),
        "{seen}"
    );
    assert_eq!(
        browser.value("document.querySelectorAll('.stills img').length"),
        12
    );
    browser.expect_quiet();
}
