use pinhole::film::{Channel, HIT_CHANNELS};
use pinhole::judge::Golden;
use pinhole::{Film, Resolution};

use super::evidence::Evidence;
use super::known::KnownMistakes;
use super::{Diagnosis, Reading};
use crate::mistake::{Hint, Mistake};

const RESOLUTION: Resolution = Resolution { n_x: 50, n_y: 20 };

/// A film whose every pixel shows object 0 at this t, facing +z.
fn film(t: impl Fn(usize) -> f32) -> Film {
    let pixels = RESOLUTION.pixels();
    let channel = |name: &str, value: &dyn Fn(usize) -> f32| Channel {
        name: name.into(),
        samples: (0..pixels).map(value).collect(),
    };
    let [id, depth, x, y, z] = HIT_CHANNELS;
    Film::new(
        RESOLUTION,
        vec![
            channel(id, &|_| 0.0),
            channel(depth, &t),
            channel(x, &|_| 0.0),
            channel(y, &|_| 0.0),
            channel(z, &|_| 1.0),
        ],
    )
}

fn right(pixel: usize) -> f32 {
    2.0 + pixel as f32 / 100.0
}

fn golden() -> Golden {
    let tolerance = film(|_| 1e-5);
    let channels = tolerance.channels().iter().map(|channel| Channel {
        name: channel.name.clone(),
        samples: vec![1e-5; RESOLUTION.pixels()],
    });
    let tolerance = Film::new(RESOLUTION, channels.collect());
    Golden::new(film(right), tolerance).expect("they belong together")
}

fn mistake() -> Mistake {
    Mistake {
        belief: "t is what I say".into(),
        fails: vec!["sphere".into()],
        submissions: None,
        chapter: "Sphere".into(),
        beliefs: Vec::new(),
        hint: Hint {
            look: "look".into(),
            think: "think".into(),
            example: None,
            read: "read".into(),
        },
    }
}

/// Diagnoses films, given the films of known mistakes, the same number for each.
#[track_caller]
fn diagnosis(known_films: &[(&str, &[&Film])], films: &[&Film]) -> Diagnosis {
    let folder = tempfile::tempdir().expect("a folder can be made");
    let golden = golden();
    let slugs = known_films.iter().map(|(slug, _)| slug.to_string());
    let mut known = KnownMistakes {
        mistake: slugs.map(|slug| (slug, mistake())).collect(),
        ..KnownMistakes::default()
    };
    for place in 0..films.len() {
        let casts = known_films
            .iter()
            .map(|(slug, films)| (slug.to_string(), Some(films[place].clone())));
        known
            .add(&place.to_string(), &golden, casts.collect(), folder.path())
            .expect("the folder can be written");
    }
    known
        .write(folder.path())
        .expect("the folder can be written");
    let known = KnownMistakes::read(folder.path()).expect("it was written");
    let evidence = films.iter().enumerate().map(|(place, film)| {
        Evidence::of(&place.to_string(), &golden, film, &known, folder.path())
            .expect("the files are there")
            .expect("the films fit")
    });
    known.explain(&evidence.collect::<Vec<_>>(), &|_| true)
}

fn names(diagnosis: &Diagnosis) -> Vec<&str> {
    let beliefs = diagnosis.beliefs.iter();
    beliefs.map(|belief| belief.slug.as_str()).collect()
}

/// From pixel 500 on, t is too large by `by`.
fn late(by: f32) -> Film {
    film(move |pixel| right(pixel) + if pixel >= 500 { by } else { 0.0 })
}

#[test]
fn the_same_belief_with_other_rounding_is_recognised() {
    let known = late(0.5);
    let anew = film(|pixel| right(pixel) + if pixel >= 500 { 0.500_003 } else { 2e-6 });
    let diagnosis = diagnosis(&[("late", &[&known])], &[&anew]);
    assert_eq!(names(&diagnosis), ["late"]);
    assert_eq!(diagnosis.reading, Reading::Together);
    assert_eq!(diagnosis.beliefs[0].explained, 1.0);
}

#[test]
fn a_film_with_other_values_in_the_same_wrong_pixels_gets_no_name() {
    assert!(diagnosis(&[("late", &[&late(0.5)])], &[&late(0.6)]).is_empty());
}

#[test]
fn a_film_that_is_only_half_explained_gets_no_name() {
    let wrong = film(|pixel| right(pixel) + if pixel >= 500 { 0.5 } else { 0.1 });
    assert!(diagnosis(&[("late", &[&late(0.5)])], &[&wrong]).is_empty());
}

#[test]
fn a_film_that_shows_half_of_a_mistake_gets_no_name() {
    let wrong = film(|pixel| right(pixel) + if pixel >= 750 { 0.5 } else { 0.0 });
    assert!(diagnosis(&[("late", &[&late(0.5)])], &[&wrong]).is_empty());
}

#[test]
fn belief_that_holds_in_one_branch_is_named_if_it_shows_in_few_others() {
    let (late, right) = (late(0.5), late(0.0));
    let known: [(&str, &[&Film]); 1] = [("late", &[&late; 5])];
    let most = diagnosis(&known, &[&late, &late, &late, &late, &right]);
    assert_eq!(names(&most), ["late"]);
    let fewer = diagnosis(&known, &[&late, &late, &late, &right, &right]);
    assert!(fewer.is_empty());
}

#[test]
fn right_film_gets_no_diagnosis() {
    assert!(diagnosis(&[("late", &[&late(0.5)])], &[&film(right)]).is_empty());
}

#[test]
fn a_mistake_that_leaves_not_a_number_is_recognised() {
    let lost = |pixel: usize| if pixel >= 500 { f32::NAN } else { right(pixel) };
    let diagnosis = diagnosis(&[("lost", &[&film(lost)])], &[&film(lost)]);
    assert_eq!(names(&diagnosis), ["lost"]);
}

/// A film whose first pixels show nothing.
fn blind(pixels: usize) -> Film {
    let film = film(right);
    let channels = film.channels().iter().map(|channel| {
        let mut samples = channel.samples.clone();
        samples[..pixels].fill(if channel.name == HIT_CHANNELS[0] {
            -1.0
        } else {
            0.0
        });
        Channel {
            name: channel.name.clone(),
            samples,
        }
    });
    Film::new(RESOLUTION, channels.collect())
}

#[test]
fn a_film_without_hits_is_named_only_after_a_mistake_without_hits() {
    let (all, most) = (blind(RESOLUTION.pixels()), blind(950));
    assert!(diagnosis(&[("most", &[&most])], &[&all]).is_empty());
    assert!(diagnosis(&[("most", &[&most, &most])], &[&all, &all]).is_empty());
    assert_eq!(names(&diagnosis(&[("all", &[&all])], &[&all])), ["all"]);
    assert_eq!(names(&diagnosis(&[("most", &[&most])], &[&most])), ["most"]);
}

#[test]
fn beliefs_that_differ_in_few_pixels_are_told_apart() {
    // They differ in three pixels of a thousand, which an even sample of a hundred misses.
    let but_three = film(|pixel| {
        let by = match pixel {
            548 | 578 | 741 => 0.25,
            pixel if pixel >= 500 => 0.5,
            _ => 0.0,
        };
        right(pixel) + by
    });
    let all = late(0.5);
    let known: [(&str, &[&Film]); 2] = [("all", &[&all]), ("but_three", &[&but_three])];
    assert_eq!(names(&diagnosis(&known, &[&all])), ["all"]);
    assert_eq!(names(&diagnosis(&known, &[&but_three])), ["but_three"]);
}

#[test]
fn beliefs_that_look_alike_are_all_named_and_said_to_be_alike() {
    let wrong = late(0.5);
    let known: [(&str, &[&Film]); 2] = [("one", &[&wrong]), ("other", &[&wrong])];
    let diagnosis = diagnosis(&known, &[&wrong]);
    assert_eq!(names(&diagnosis), ["one", "other"]);
    assert_eq!(diagnosis.reading, Reading::OneOf);
}

#[test]
fn beliefs_that_look_alike_are_not_named_if_there_are_many() {
    let wrong = late(0.5);
    let films: [&Film; 1] = [&wrong];
    let known = ["a", "b", "c", "d"].map(|slug| (slug, films.as_slice()));
    assert!(diagnosis(&known, &[&wrong]).is_empty());
}

#[test]
fn a_second_film_tells_apart_beliefs_that_look_alike_in_one() {
    let (wrong, fine) = (late(0.5), film(right));
    let known: [(&str, &[&Film]); 2] = [("one", &[&wrong, &wrong]), ("other", &[&wrong, &fine])];
    assert_eq!(names(&diagnosis(&known, &[&wrong, &fine])), ["other"]);
    assert_eq!(names(&diagnosis(&known, &[&wrong, &wrong])), ["one"]);
}

#[test]
fn two_beliefs_are_both_named_if_each_shows_alone() {
    let (fine, far, near) = (film(right), late(0.5), late(-0.5));
    let known: [(&str, &[&Film]); 2] = [("far", &[&far, &fine]), ("near", &[&fine, &near])];
    let diagnosis = diagnosis(&known, &[&far, &near]);
    assert_eq!(names(&diagnosis), ["far", "near"]);
    assert_eq!(diagnosis.reading, Reading::Together);
    for belief in &diagnosis.beliefs {
        assert!((belief.explained - 0.5).abs() < 1e-6, "{belief:?}");
    }
}

#[test]
fn a_belief_beside_something_unknown_is_not_named() {
    let (fine, far, unknown) = (film(right), late(0.5), film(|pixel| 3.0 * right(pixel)));
    let known: [(&str, &[&Film]); 1] = [("far", &[&far, &fine])];
    assert!(diagnosis(&known, &[&far, &unknown]).is_empty());
}

#[test]
fn a_mistake_that_panics_is_recognised_by_where_it_panics() {
    let folder = tempfile::tempdir().expect("a folder can be made");
    let golden = golden();
    let mut known = KnownMistakes::default();
    known.mistake.insert("panics".into(), mistake());
    let far = late(0.5);
    for (name, film) in [("some", Some(far.clone())), ("none", None)] {
        let casts = vec![("panics".to_owned(), film)];
        known
            .add(name, &golden, casts, folder.path())
            .expect("the folder can be written");
    }
    let fine = film(right);
    let of = |(name, film)| {
        Evidence::of(name, &golden, film, &known, folder.path())
            .expect("the files are there")
            .expect("the films fit")
    };
    let panic = |name: &str| Evidence::of_panic(name, RESOLUTION.pixels(), &known);
    let explain = |evidence: [Evidence; 2]| known.explain(&evidence, &|_| true);
    assert_eq!(
        names(&explain([of(("some", &far)), panic("none")])),
        ["panics"]
    );
    assert!(explain([("some", &far), ("none", &fine)].map(of)).is_empty());
    assert!(explain([panic("some"), panic("none")]).is_empty());
}

/// A film whose t is wrong from pixel 500 on, and which has these normals everywhere.
fn late_with_normals(by: f32, z: f32) -> Film {
    let film = late(by);
    let channels = film.channels().iter().map(|channel| Channel {
        name: channel.name.clone(),
        samples: match channel.name == HIT_CHANNELS[4] {
            true => vec![z; RESOLUTION.pixels()],
            false => channel.samples.clone(),
        },
    });
    Film::new(RESOLUTION, channels.collect())
}

#[test]
fn beliefs_about_two_parts_are_both_named_if_several_films_are_wrong() {
    let (far, long) = (late(0.5), late_with_normals(0.0, 2.0));
    let known: [(&str, &[&Film]); 2] = [("far", &[&far, &far]), ("long", &[&long, &long])];
    let both = late_with_normals(0.5, 2.0);
    assert_eq!(names(&diagnosis(&known, &[&both, &both])), ["far", "long"]);
    assert!(diagnosis(&known, &[&both]).is_empty());
    let whole = film(right);
    let known_once: [(&str, &[&Film]); 2] = [("far", &[&far, &whole]), ("long", &[&long, &whole])];
    assert!(diagnosis(&known_once, &[&both, &whole]).is_empty());
    let other = late_with_normals(0.7, 3.0);
    let unknown = diagnosis(&known, &[&other, &other]);
    assert!(unknown.is_empty(), "{unknown:?}");
}

#[test]
fn a_belief_that_explains_one_part_is_named_beside_something_unknown() {
    let (far, long) = (late(0.5), late_with_normals(0.0, 2.0));
    let known: [(&str, &[&Film]); 2] = [("far", &[&far, &far]), ("long", &[&long, &long])];
    let film = late_with_normals(0.5, 3.0);
    assert_eq!(names(&diagnosis(&known, &[&film, &film])), ["far"]);
}

#[test]
fn a_belief_that_explains_one_part_is_not_named_if_nothing_is_wrong_elsewhere() {
    let spoiled = |from: usize| {
        let film = late(0.0);
        let channels = film.channels().iter().map(|channel| {
            let mut samples = channel.samples.clone();
            if channel.name == HIT_CHANNELS[4] {
                samples[500..].fill(2.0);
            }
            if channel.name == HIT_CHANNELS[1] {
                samples[from..].fill(0.25);
            }
            Channel {
                name: channel.name.clone(),
                samples,
            }
        });
        Film::new(RESOLUTION, channels.collect())
    };
    let long = spoiled(RESOLUTION.pixels());
    let known: [(&str, &[&Film]); 1] = [("long", &[&long, &long])];
    let (same, more) = (spoiled(500), spoiled(450));
    let named = diagnosis(&known, &[&same, &same]);
    assert!(named.is_empty(), "{named:?}");
    assert_eq!(names(&diagnosis(&known, &[&more, &more])), ["long"]);
}

/// Everywhere, t is too large by this.
fn everywhere(by: impl Fn(usize) -> f32) -> Film {
    film(move |pixel| right(pixel) + by(pixel))
}

/// An error that is larger in later pixels.
fn growing(pixel: usize) -> f32 {
    0.1 + pixel as f32 / 50.0
}

#[test]
fn two_errors_that_add_up_in_every_pixel_are_both_named() {
    let (shift, growth) = (everywhere(|_| 0.5), everywhere(growing));
    let other = everywhere(|pixel| growing(1000 - pixel));
    let known: [(&str, &[&Film]); 3] = [
        ("shift", &[&shift, &shift]),
        ("growth", &[&growth, &growth]),
        ("other", &[&other, &other]),
    ];
    let both = everywhere(|pixel| 0.5 + growing(pixel));
    let diagnosis_of = |film: &Film| diagnosis(&known, &[film, film]);
    assert_eq!(names(&diagnosis_of(&both)), ["growth", "shift"]);
    assert!(diagnosis(&known, &[&both]).is_empty());
    let whole = film(right);
    let known_once: [(&str, &[&Film]); 2] =
        [("shift", &[&shift, &whole]), ("growth", &[&growth, &whole])];
    assert!(diagnosis(&known_once, &[&both, &whole]).is_empty());
    let twice = everywhere(|pixel| 0.5 + 2.0 * growing(pixel));
    assert!(diagnosis_of(&twice).is_empty());
    let often = everywhere(|pixel| 0.5 + if pixel % 2 == 0 { 1.0 } else { growing(pixel) });
    assert!(diagnosis_of(&often).is_empty());
}

#[test]
fn a_belief_beside_one_of_two_that_look_alike_is_named_alone() {
    let (shift, growth) = (everywhere(|_| 0.5), everywhere(growing));
    let known: [(&str, &[&Film]); 3] = [
        ("shift", &[&shift, &shift]),
        ("growth", &[&growth, &growth]),
        ("like_growth", &[&growth, &growth]),
    ];
    let both = everywhere(|pixel| 0.5 + growing(pixel));
    assert_eq!(names(&diagnosis(&known, &[&both, &both])), ["shift"]);
}

#[test]
fn a_mistake_that_explains_nothing_by_itself_is_not_named_beside_another() {
    let (shift, late) = (
        everywhere(|_| 0.5),
        film(|pixel| right(pixel) + if pixel >= 995 { 0.25 } else { 0.0 }),
    );
    let known: [(&str, &[&Film]); 2] = [("shift", &[&shift, &shift]), ("late", &[&late, &late])];
    let given = |every: usize| {
        everywhere(move |pixel| match pixel {
            995.. => 0.75,
            _ if pixel % every == 0 => 0.1,
            _ => 0.5,
        })
    };
    let named = diagnosis(&known, &[&given(7), &given(2000)]);
    assert_eq!(names(&named), ["shift"]);
}

#[test]
fn a_belief_is_named_beside_an_unknown_mistake_if_it_explains_most_pixels() {
    let (shift, growth) = (everywhere(|_| 0.5), everywhere(growing));
    let known: [(&str, &[&Film]); 2] = [
        ("shift", &[&shift, &shift]),
        ("growth", &[&growth, &growth]),
    ];
    let given = |from: usize, unknown: usize| {
        everywhere(move |pixel| match pixel {
            _ if pixel < from => growing(pixel),
            _ if pixel < from + unknown => 0.25,
            _ => 0.5,
        })
    };
    let named = |film: &Film| diagnosis(&known, &[film, film]);
    assert_eq!(names(&named(&given(0, 120))), ["shift"]);
    assert!(named(&given(0, 180)).is_empty());
    // In 300 of 1000 pixels, the answer has the values of growth.
    assert_eq!(names(&named(&given(300, 0))), ["growth", "shift"]);
    assert_eq!(names(&named(&given(100, 120))), ["shift"]);
    let most = everywhere(|pixel| if pixel < 800 { 0.5 } else { 0.0 });
    let known: [(&str, &[&Film]); 2] = [("shift", &[&shift, &shift]), ("most", &[&most, &most])];
    let given = given(0, 120);
    let named = diagnosis(&known, &[&given, &given]);
    assert!(named.is_empty(), "{named:?}");
}

#[test]
fn a_belief_whose_error_is_twice_that_of_another_is_not_named() {
    let (shift, far, growth) = (
        everywhere(|_| 0.5),
        everywhere(|_| 1.0),
        everywhere(growing),
    );
    let known: [(&str, &[&Film]); 3] = [
        ("shift", &[&shift, &shift]),
        ("far", &[&far, &far]),
        ("growth", &[&growth, &growth]),
    ];
    let both = everywhere(|pixel| 1.0 + growing(pixel));
    assert_eq!(names(&diagnosis(&known, &[&both, &both])), ["growth"]);
}

#[test]
fn a_film_without_the_misses_that_a_mistake_predicts_is_not_named_after_it() {
    let (shift, most) = (everywhere(|_| 0.5), blind(900));
    let known: [(&str, &[&Film]); 2] = [("shift", &[&shift, &shift]), ("most", &[&most, &most])];
    let given = everywhere(|pixel| if pixel >= 900 { 0.5 } else { 0.7 });
    let named = diagnosis(&known, &[&given, &given]);
    assert!(named.is_empty(), "{named:?}");
}
