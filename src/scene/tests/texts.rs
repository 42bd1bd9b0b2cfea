//! Texts and files that are not scenes.

use std::fs;

use super::*;

#[test]
fn error_points_at_text_that_is_not_toml() {
    refused("width = 2.0", "width = ▶two", "invalid", "in the book");
    refused(
        "eye = [0.0, 1.0, 5.0]",
        "eye = [0.0, ▶1.0 5.0]",
        "",
        "in the book",
    );
    refused(
        "width = 2.0",
        "width = 2.0\n▶width = 3.0",
        "duplicate key",
        "in the book",
    );
}

#[test]
fn columns_count_characters_and_not_bytes() {
    refused(
        "[[object]]\ntype = \"sphere\"\ncenter = [0.0, 1.0, -1.0]\nradius = 0.75",
        "[[object]]\ntype = \"soup\"\nobj = \"größte.obj\" ▶oops",
        "",
        "in the book",
    );
}

#[test]
fn missing_scene_is_an_error() {
    let folder = tempfile::tempdir().unwrap();
    for path in [folder.path().join("absent.toml"), folder.path().into()] {
        let error = Scene::read(&path).unwrap_err();
        assert_eq!(error.path, path);
        assert!(
            error.problem.starts_with("cannot read this scene"),
            "{error}"
        );
    }
}

#[test]
fn no_text_makes_the_reader_panic() {
    let mut random = testing::Random::new(1);
    let signs: Vec<char> = "[]{}=\"'.,#\n -0123e nan inf é\u{2028}\0".chars().collect();
    let path = Path::new("a scene.toml");
    for _ in 0..2000 {
        let mut text: Vec<char> = GOOD.chars().collect();
        for _ in 0..1 + random.below(4) {
            let place = random.below(text.len());
            match random.below(3) {
                0 => text[place] = *random.one_of(&signs),
                1 => text.insert(place, *random.one_of(&signs)),
                _ => drop(text.remove(place)),
            }
        }
        let text = String::from_iter(text);
        let read = Document::parse(&text, path).and_then(Document::into_scene);
        if let Err(error) = read {
            assert!(error.position.is_some(), "{error}");
        }
    }
}

#[test]
fn spoilt_scenes_do_not_harm_the_reader() {
    // Use one file for all inputs, because a folder for each would fill the disk's
    // journal.
    let (_folder, path) = testing::file("scene.toml", "");
    bolero::check!().for_each(|bytes| {
        fs::write(&path, bytes).unwrap();
        if let Ok(scene) = Scene::read(&path) {
            assert!(scene.resolution.pixels() <= MOST_PIXELS);
        }
    });
}
