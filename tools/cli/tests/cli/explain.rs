//! `pinhole explain` and `pinhole render`.

use pinhole_testing::{fresh, pinhole, trusted};

#[test]
fn the_lectures_worked_example_comes_out_as_on_the_slides() {
    pinhole(&["explain", "slide_example", "2", "3"])
        .expect_code(0)
        .expect_out("u(2) = −0.9, v(3) = −0.36")
        .expect_out("t (−0.9, −0.36, −10)")
        .expect_out("d = (−0.9, 6.81651, −7.32563)")
        .expect_out("object 3   plane")
        .expect_out("expected (Mitsuba)   object 3");
}

#[test]
fn unanswered_tasks_are_explained_with_mitsubas_ray() {
    pinhole(&[
        "explain",
        "slide_example",
        "2",
        "3",
        "--submission",
        "assignments/ray_casting/handout",
    ])
    .expect_code(0)
    .expect_out("viewing_ray: unanswered")
    .expect_out("below, Mitsuba's ray is used")
    .expect_out("first hit              unanswered");
}

#[test]
fn json_is_one_document_with_the_same_facts() {
    let explanation = pinhole(&["explain", "slide_example", "2", "3", "--json"]).json();
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
    let ran = pinhole(&["render", "slide_example", "--out", out_name, "--json"]);
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
fn exact_casting_agrees_with_mitsuba_and_tells_what_it_took() {
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
fn a_scene_with_a_light_is_told_why_there_are_none() {
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
