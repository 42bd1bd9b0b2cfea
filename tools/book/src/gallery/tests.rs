//! Tests that stale and identical strips are reported.

use pinhole_course::mistake::{Hint, Mistake};

use super::*;

fn strip(pixels: usize, png: &str) -> Strip {
    let shown = StripSubject {
        scene: "bunny".into(),
        view: View::Id,
        pixels,
        of: 100,
    };
    let png = png.into();
    Strip { shown, png }
}

#[test]
fn a_strip_that_its_mistake_no_longer_casts_is_a_problem() {
    let folder = tempfile::tempdir().expect("there is room");
    let checkout = Checkout::at(folder.path());
    let strips = || {
        vec![
            ("seen".to_owned(), Some(strip(7, "a picture"))),
            ("unseen".to_owned(), None),
        ]
    };
    keep_all(strips(), &checkout).expect("there is room");
    let told = |strips: &Strips| -> Vec<String> {
        let problems = stale(strips, &checkout).into_iter();
        problems.map(|problem| problem.problem).collect()
    };
    assert!(told(&strips()).is_empty());

    let changed = ["the strip is missing or out of date"];
    let mut other_picture = strips();
    other_picture[0].1 = Some(strip(7, "another"));
    assert_eq!(told(&other_picture), changed);
    let mut other_count = strips();
    other_count[0].1 = Some(strip(8, "a picture"));
    assert_eq!(told(&other_count), changed);
    let mut shown_now = strips();
    shown_now[1].1 = Some(strip(1, "a picture"));
    assert_eq!(told(&shown_now), changed);
    let mut hidden_now = strips();
    hidden_now[0].1 = None;
    assert_eq!(told(&hidden_now), changed);
    assert_eq!(told(&strips().split_off(1)), ["there is no such mistake"]);
}

#[test]
fn two_strips_of_one_chapter_with_the_same_picture_are_a_problem() {
    let mistake = |slug: &str, fails: &str| MistakeFolder {
        slug: slug.into(),
        folder: PathBuf::new(),
        mistake: Mistake {
            belief: String::new(),
            fails: vec![fails.into()],
            submissions: None,
            chapter: String::new(),
            beliefs: Vec::new(),
            hint: Hint {
                look: String::new(),
                think: String::new(),
                example: None,
                read: String::new(),
            },
        },
    };
    let mistakes = [
        mistake("black", "sphere"),
        mistake("dark", "sphere"),
        mistake("night", "plane"),
    ];
    let strips = |dark: &str| -> Strips {
        let pictures = [
            ("black", "a picture"),
            ("dark", dark),
            ("night", "a picture"),
        ];
        let strips = pictures.map(|(slug, png)| (slug.to_owned(), Some(strip(7, png))));
        strips.into()
    };
    let checkout = Checkout::at(std::path::Path::new("/course"));
    let told = |dark: &str| -> Vec<String> {
        let problems = alike(&strips(dark), &mistakes, &checkout).into_iter();
        problems.map(|problem| problem.problem).collect()
    };
    assert!(told("another").is_empty());
    let same = ["in the gallery of sphere, black has the same picture"];
    assert_eq!(told("a picture"), same);
}
