//! `pinhole explain` and `pinhole render`.

use std::fs;

use pinhole_testing::{fresh, pinhole, root, submission, trusted};

const REFERENCE: &str = "assignments/ray_casting/reference";

#[test]
fn the_lectures_worked_example_comes_out_as_on_the_slides() {
    let ran = pinhole(&[
        "explain",
        "slide_example",
        "2",
        "3",
        "--submission",
        REFERENCE,
    ]);
    let ran = ran
        .expect_code(0)
        .expect_out("expected   u(2) = −0.9, v(3) = −0.36")
        .expect_out("yours      u = −0.9, v = −0.36")
        .expect_out("yours      e = (0, 0, 0), d = (−0.9, −0.36, −10)")
        .expect_out("expected   e = (0, 0, 0), d = (−0.9, −0.36, −10)")
        .expect_out("d = (−0.9, 6.81651, −7.32563)")
        .expect_out("object 3   plane")
        .expect_out("Mitsuba's  object 3");
    assert!(!ran.out.contains("differs"), "{}", ran.out);
}

#[test]
fn a_wrong_ray_is_shown_above_the_right_one_with_what_it_printed() {
    let right = std::fs::read_to_string(
        pinhole_testing::root()
            .join(REFERENCE)
            .join("src/viewing_ray.rs"),
    );
    let wrong = right
        .expect("it is there")
        .replace("pixel.i as f64", "f64::from(dbg!(7u8))");
    let folder = submission(
        &trusted(),
        "explain-wrong-ray",
        &[("viewing_ray.rs", &wrong)],
    );
    let folder = folder.to_str().expect("a plain name");
    let ran = pinhole(&["explain", "slide_example", "2", "3", "--submission", folder]);
    ran.expect_code(0)
        .expect_out("expected   u(2) = −0.9, v(3) = −0.36")
        .expect_out("yours      u = −0.7, v = −0.36  ← differs")
        .expect_out("viewing_ray.rs:")
        .expect_out("7u8 = 7");
}

#[test]
fn unanswered_tasks_are_explained_with_mitsubas_ray() {
    pinhole(&["explain", "slide_example", "2", "3"])
        .expect_code(0)
        .expect_out("answers of assignments/ray_casting/handout")
        .expect_out("viewing_ray: unanswered")
        .expect_out("below, Mitsuba's ray is used")
        .expect_out("first hit\n  yours      unanswered");
}

#[test]
fn json_is_one_document_with_the_same_facts() {
    let explanation = pinhole(&[
        "explain",
        "slide_example",
        "2",
        "3",
        "--json",
        "--submission",
        REFERENCE,
    ])
    .json();
    assert_eq!(explanation["u"], -0.9);
    assert_eq!(explanation["first_hit"]["object"], 3);
    assert_eq!(explanation["candidates"].as_array().map(Vec::len), Some(4));
    assert_eq!(explanation["expected"]["first_hit"]["object"], 3);
}

#[test]
fn a_pixel_outside_the_film_is_refused_with_the_range() {
    pinhole(&["explain", "slide_example", "50", "0"])
        .expect_code(2)
        .expect_err("a column from 0 to 49 and a row from 0 to 24");
}

#[test]
fn render_writes_a_film_and_three_pictures() {
    let out = fresh(&trusted(), "render");
    let out_name = out.to_str().expect("a plain name");
    let ran = pinhole(&[
        "render",
        "slide_example",
        "--submission",
        REFERENCE,
        "--out",
        out_name,
        "--json",
    ]);
    let rendered = ran.expect_code(0).json();
    assert_eq!(rendered["resolution"][0], 50);
    for file in ["film.exr", "id.png", "depth.png", "normal.png"] {
        assert!(out.join(file).is_file(), "{file}");
    }
    let film = out.join("film.exr");
    pinhole(&[
        "diff",
        "golden/ray_casting/slide_example.exr",
        film.to_str().expect("plain"),
    ])
    .expect_code(0)
    .expect_out("oiiotool agrees");
}

#[test]
fn render_draws_the_tests_of_each_pixel_where_they_are_counted() {
    let out = fresh(&trusted(), "render-tests");
    let out_name = out.to_str().expect("a plain name");
    let render = |assignment: &str| {
        let reference = format!("assignments/{assignment}/reference");
        let ran = pinhole(&[
            "render",
            "bunny",
            "--submission",
            &reference,
            "--out",
            out_name,
        ]);
        ran.expect_code(0)
    };
    render("ray_casting");
    assert!(!out.join("tests.png").exists(), "nothing is counted");
    render("bounding_volumes")
        .expect_out("tests.png: black 0, ")
        .expect_out("tests.png\n");
    // These are our own answers, so they take exactly the tests that are recorded for them.
    let reference = "assignments/bounding_volumes/reference";
    let line = ["render", "bunny", "--submission", reference, "--json"];
    let sums = pinhole(&[&line[..], &["--out", out_name]].concat());
    let sums = sums.expect_code(0).json();
    assert!(sums["tests"].as_f64() > Some(10_000.0), "{sums}");
    assert_eq!(sums["tests"], sums["expected_tests"]);
    let [tests, expected] = ["tests", "expected-tests"]
        .map(|name| image::open(out.join(name).with_extension("png")).expect("a picture"));
    assert_eq!(tests, expected, "of the same numbers on the same scale");
    let picture = image::open(out.join("tests.png"))
        .expect("a picture")
        .to_rgb8();
    let brightness = |x, y| picture.get_pixel(x, y).0.map(u32::from).iter().sum::<u32>();
    let (middle, corner) = (brightness(80, 45), brightness(0, 0));
    assert!(middle > corner + 100, "{middle} and {corner}");
    // Tests that a submission counts itself are not in the film, because the film is judged.
    let film = out.join("film.exr");
    let golden = "golden/bounding_volumes/bunny.exr";
    pinhole(&["diff", golden, film.to_str().expect("plain")]).expect_code(0);
}

#[test]
fn render_fills_in_missing_answers_from_the_golden_film() {
    let stubs = root().join("assignments/ray_casting/handout/src");
    let stub = |file| fs::read_to_string(stubs.join(file)).expect("a stub");
    let missing = ["viewing_ray.rs", "first_hit.rs", "sphere.rs", "triangle.rs"];
    let stubs = missing.map(|file| (file, stub(file)));
    let overlay = stubs.each_ref().map(|(file, text)| (*file, text.as_str()));
    let folder = submission(&trusted(), "only-plane", &overlay);
    let out = fresh(&trusted(), "render-only-plane");
    let (folder, out) = (
        folder.to_str().expect("plain"),
        out.to_str().expect("plain"),
    );
    let line = [
        "render",
        "two_spheres_and_plane",
        "--submission",
        folder,
        "--out",
        out,
    ];
    let told = pinhole(&[&line[..], &["--json"]].concat())
        .expect_code(1)
        .json();
    assert_eq!(told["answered"], serde_json::json!(["plane"]), "{told:#}");
    let golden = serde_json::json!(["viewing_ray", "sphere"]);
    assert_eq!(told["from_golden"], golden, "{told:#}");
    let film = format!("{out}/film.exr");
    pinhole(&[
        "diff",
        "golden/ray_casting/two_spheres_and_plane.exr",
        &film,
    ])
    .expect_code(0);
}

#[test]
fn exact_casting_agrees_with_mitsuba_and_reports_its_work() {
    let out = fresh(&trusted(), "render-exact");
    let out_name = out.to_str().expect("a plain name");
    let exact = ["render", "bunny", "--exact", "--out", out_name];
    let told = pinhole(&[&exact[..], &["--json"]].concat());
    let told = told.expect_code(0).json();
    assert!(told["exact"]["tests"].as_u64() > Some(10_000), "{told}");
    assert!(out.join("normal.png").is_file());
    let film = out.join("film.exr");
    pinhole(&[
        "diff",
        "golden/ray_casting/bunny.exr",
        film.to_str().expect("plain"),
    ])
    .expect_code(0);

    let ran = pinhole(&[&exact[..], &["--resolution", "20x10"]].concat());
    ran.expect_code(0)
        .expect_out("20×10 pixels")
        .expect_out("needed exact arithmetic");
    let reference = "assignments/ray_casting/reference";
    pinhole(&[&exact[..], &["--submission", reference]].concat()).expect_code(2);
}

#[test]
fn a_scene_with_a_light_is_refused_because_there_are_none() {
    let folder = fresh(&trusted(), "light");
    let scene = folder.join("lit.toml");
    let good = pinhole_testing::root().join("assignments/ray_casting/scenes/slide_example.toml");
    let text = std::fs::read_to_string(good).expect("the scene is there");
    std::fs::write(&scene, text + "\n[light]\nposition = [0, 0, 0]\n").expect("it can be written");
    pinhole(&["render", scene.to_str().expect("plain")])
        .expect_code(2)
        .expect_err("lit.toml:")
        .expect_err("no lights")
        .expect_err("remedy: remove `light`");
}

#[test]
fn the_readmes_pictures_are_what_render_draws() {
    let out = fresh(&trusted(), "readme-pictures");
    let folder = out.to_str().expect("a plain name");
    pinhole(&[
        "render",
        "bunny",
        "--submission",
        REFERENCE,
        "--resolution",
        "480x270",
        "--out",
        folder,
    ])
    .expect_code(0);
    for name in ["id.png", "depth.png", "normal.png"] {
        let read = |path: std::path::PathBuf| std::fs::read(path).expect("the picture is there");
        let committed = read(pinhole_testing::root().join("book/figures").join(name));
        assert!(
            read(out.join(name)) == committed,
            "book/figures/{name} is out of step"
        );
    }
}
