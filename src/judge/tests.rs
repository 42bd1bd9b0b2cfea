use super::*;
use crate::camera::Resolution;
use crate::testing::{self, Random, grid, row};

mod refusals;

/// A golden of hits: ids, ts, and the normals' z (x and y are 0).
fn golden(ids: &[f32], ts: &[f32], tolerance: f32) -> Golden {
    let exact = vec![0.0; ids.len()];
    let near = vec![tolerance; ids.len()];
    Golden::new(hits(ids, ts), hits_with(&exact, &near, &near)).unwrap()
}

fn hits(ids: &[f32], ts: &[f32]) -> Film {
    hits_with(ids, ts, &vec![0.0; ids.len()])
}

fn hits_with(ids: &[f32], ts: &[f32], normals: &[f32]) -> Film {
    row(&[
        ("id", ids),
        ("t", ts),
        ("N.X", normals),
        ("N.Y", normals),
        ("N.Z", normals),
    ])
}

/// Golden and tolerance of one row with a single channel `t`.
fn one_channel(expected: &[f32], allowed: &[f32]) -> Golden {
    Golden::new(row(&[("t", expected)]), row(&[("t", allowed)])).unwrap()
}

#[track_caller]
fn channel<'a>(verdict: &'a Verdict, name: &str) -> &'a ChannelVerdict {
    let mut channels = verdict.channels.iter();
    channels.find(|channel| channel.name == name).unwrap()
}

#[test]
fn a_golden_passes_its_own_judgement_whatever_it_holds() {
    let mut random = Random::new(1);
    for _ in 0..100 {
        let samples: Vec<f32> = (0..6).map(|_| random.coordinate() as f32).collect();
        let film = grid(3, &[("t", &samples), ("id", &samples)]);
        let zero = grid(3, &[("t", &[0.0; 6]), ("id", &[0.0; 6])]);
        let golden = Golden::new(film.clone(), zero).unwrap();
        let verdict = judge(&golden, &film).unwrap();
        assert!(verdict.passes());
        assert_eq!(verdict.resolution, film.resolution());
    }
}

#[test]
fn a_film_passes_at_its_tolerance_and_fails_one_step_beyond() {
    let mut random = Random::new(2);
    for _ in 0..1000 {
        let expected = 100.0 * random.coordinate() as f32;
        let got = expected + random.coordinate() as f32;
        // The distance as the rule computes it, with the same rounding.
        let distance = (got - expected).abs();
        let passes = |allowed: f32| {
            let golden = one_channel(&[expected], &[allowed]);
            judge(&golden, &row(&[("t", &[got])])).unwrap().passes()
        };
        assert!(passes(distance), "{got} and {expected} ± {distance}");
        assert!(!passes(distance.next_down()), "{got} and {expected}");
    }
}

#[test]
fn work_is_judged_by_its_sum_and_everything_else_pixel_by_pixel() {
    let golden = |name: &str| {
        let [expected, allowed] = [[4.0, 4.0, 4.0], [2.0, 2.0, 2.0]];
        Golden::new(row(&[(name, &expected)]), row(&[(name, &allowed)])).unwrap()
    };
    let failing = |name: &str, got: [f32; 3]| {
        let verdict = judge(&golden(name), &row(&[(name, &got)])).unwrap();
        verdict.failing
    };
    assert_eq!(failing("tests", [10.0, 4.0, 4.0]), [0; 0]);
    assert_eq!(failing("t", [10.0, 4.0, 4.0]), [0]);
    assert_eq!(failing("tests", [10.0, 4.0, 5.0]), [0]);
    assert_eq!(failing("tests", [4.0, 7.0, 8.0]), [1, 2]);
}

#[test]
fn a_film_fails_by_one_pixel_in_one_channel() {
    let ids = [0.0; 100];
    let ts = [2.0; 100];
    let golden = golden(&ids, &ts, 1e-3);
    for name in ["id", "t", "N.X", "N.Y", "N.Z"] {
        for wrong in [0, 57, 99] {
            let mut film = hits(&ids, &ts);
            let resolution = film.resolution();
            let channels = film.channels().to_vec().into_iter().map(|mut channel| {
                if channel.name == name {
                    channel.samples[wrong] += 0.01;
                }
                channel
            });
            film = Film::new(resolution, channels.collect());

            let verdict = judge(&golden, &film).unwrap();
            assert!(!verdict.passes());
            assert_eq!(verdict.failing, [wrong]);
            for judged in &verdict.channels {
                assert_eq!(judged.failing, usize::from(judged.name == name));
            }
        }
    }
}

#[test]
fn where_the_golden_hits_nothing_any_t_and_normal_pass_but_no_id() {
    let anything = [EXEMPT];
    let golden = Golden::new(
        hits(&[-1.0], &[0.0]),
        hits_with(&[0.0], &anything, &anything),
    )
    .unwrap();
    for t in [0.0, -1.0, 1e30, f32::MAX, f32::MIN] {
        let passes = |id| {
            judge(&golden, &hits_with(&[id], &[t], &[t]))
                .unwrap()
                .passes()
        };
        assert!(passes(-1.0), "t = {t}");
        assert!(!passes(0.0), "t = {t}");
    }
}

#[test]
fn the_worst_pixel_is_the_one_most_tolerances_away() {
    // The second pixel's t is farther off, but its tolerance allows that.
    let golden = one_channel(&[1.0, 1.0, 1.0], &[0.01, 1.0, 0.01]);
    let film = row(&[("t", &[1.05, 3.0, 1.02])]);
    let verdict = judge(&golden, &film).unwrap();
    let worst = channel(&verdict, "t").worst.unwrap();
    assert_eq!(
        worst,
        Mismatch {
            pixel: Pixel { i: 0, j: 0 },
            got: 1.05,
            expected: 1.0,
            allowed: 0.01
        }
    );
}

#[test]
fn the_worst_pixel_of_a_channel_shows_the_right_object_if_any_does() {
    let golden = golden(&[0.0, 0.0, 0.0], &[1.0, 1.0, 1.0], 0.01);
    // Another object is far off in t; the right one is a little off.
    let film = hits(&[1.0, 0.0, 0.0], &[50.0, 1.0, 1.5]);
    let verdict = judge(&golden, &film).unwrap();
    let worst = channel(&verdict, "t").worst.unwrap();
    assert_eq!(worst.pixel, Pixel { i: 2, j: 0 });
    let worst = channel(&verdict, "id").worst.unwrap();
    assert_eq!(worst.pixel, Pixel { i: 0, j: 0 });
}

#[test]
fn the_worst_pixel_is_found_even_where_no_pixel_shows_the_right_object() {
    let golden = golden(&[0.0, 0.0], &[1.0, 1.0], 0.01);
    let verdict = judge(&golden, &hits(&[1.0, 1.0], &[2.0, 5.0])).unwrap();
    let worst = channel(&verdict, "t").worst.unwrap();
    assert_eq!(worst.pixel, Pixel { i: 1, j: 0 });
}

#[test]
fn error_over_a_tolerance_of_zero_is_infinite() {
    let golden = one_channel(&[1.0, 1.0], &[0.1, 0.0]);
    let verdict = judge(&golden, &row(&[("t", &[9.0, 1.1])])).unwrap();
    let worst = channel(&verdict, "t").worst.unwrap();
    assert_eq!(worst.pixel, Pixel { i: 1, j: 0 });
}

#[test]
fn bounds_are_the_smallest_rectangle_around_what_fails() {
    let mut random = Random::new(3);
    let (n_x, n_y) = (7, 5);
    for _ in 0..200 {
        let count = 1 + random.below(4);
        let wrong: Vec<usize> = (0..count).map(|_| random.below(n_x * n_y)).collect();
        let mut samples = [0.0; 35];
        wrong.iter().for_each(|index| samples[*index] = 1.0);
        let zero = [0.0; 35];
        let golden = Golden::new(grid(n_x, &[("t", &zero)]), grid(n_x, &[("t", &zero)])).unwrap();
        let film = grid(n_x, &[("t", &samples)]);

        let verdict = judge(&golden, &film).unwrap();
        let bounds = channel(&verdict, "t").bounds.unwrap();
        let columns = wrong.iter().map(|index| index % n_x);
        let rows = wrong.iter().map(|index| n_y - 1 - index / n_x);
        assert_eq!(Some(bounds.min.i), columns.clone().min());
        assert_eq!(Some(bounds.max.i), columns.max());
        assert_eq!(Some(bounds.min.j), rows.clone().min());
        assert_eq!(Some(bounds.max.j), rows.max());
    }
}

#[test]
fn a_channel_that_agrees_has_no_worst_pixel_and_no_bounds() {
    let golden = one_channel(&[1.0], &[0.0]);
    let verdict = judge(&golden, &row(&[("t", &[1.0])])).unwrap();
    let judged = channel(&verdict, "t");
    assert_eq!(
        (judged.failing, judged.worst, judged.bounds),
        (0, None, None)
    );
}

#[test]
fn a_pixel_is_exempt_only_if_every_channel_is() {
    let film = hits(&[0.0; 3], &[1.0; 3]);
    let all = [0.0, EXEMPT, EXEMPT];
    let ids = [0.0, EXEMPT, 0.0];
    let golden = Golden::new(film.clone(), hits_with(&ids, &all, &all)).unwrap();
    let exempt: Vec<bool> = (0..3).map(|index| golden.is_exempt(index)).collect();
    assert_eq!(exempt, [false, true, false]);
    assert_eq!(judge(&golden, &film).unwrap().exempt, 1);
}

#[test]
fn at_an_exempt_pixel_every_object_passes() {
    let golden = Golden::new(
        hits(&[0.0], &[1.0]),
        hits_with(&[EXEMPT], &[EXEMPT], &[EXEMPT]),
    )
    .unwrap();
    for film in [hits(&[-1.0], &[0.0]), hits(&[7.0], &[-3e38])] {
        assert!(judge(&golden, &film).unwrap().passes());
    }
}

#[test]
fn channels_are_judged_in_the_order_people_read_them() {
    let golden = golden(&[0.0], &[1.0], 0.0);
    let film = row(&[
        ("N.Z", &[0.0]),
        ("N.Y", &[0.0]),
        ("t", &[1.0]),
        ("N.X", &[0.0]),
        ("id", &[0.0]),
    ]);
    let verdict = judge(&golden, &film).unwrap();
    let names: Vec<&str> = verdict.channels.iter().map(|c| c.name.as_str()).collect();
    assert_eq!(names, ["id", "t", "N.X", "N.Y", "N.Z"]);
}

#[test]
fn a_tolerance_that_fits_another_golden_is_refused() {
    let golden = row(&[("t", &[1.0])]);
    assert!(Golden::new(golden.clone(), row(&[("t", &[0.0, 0.0])])).is_err());
    assert!(Golden::new(golden.clone(), row(&[("id", &[0.0])])).is_err());
    assert!(Golden::new(golden.clone(), row(&[("t", &[f32::INFINITY])])).is_err());
    assert!(Golden::new(row(&[("t", &[f32::NAN])]), golden).is_err());
}

#[test]
fn a_golden_lies_beside_its_tolerance() {
    let (folder, path) = testing::file("scene.exr", "");
    let film = row(&[("t", &[1.0])]);
    film.write(&path).unwrap();
    let beside = folder.path().join("scene.tol.exr");
    assert_eq!(tolerance_path(&path), beside);

    assert_eq!(Golden::read(&path).unwrap_err().path, beside);
    row(&[("t", &[0.5])]).write(&beside).unwrap();
    assert_eq!(
        Golden::read(&path).unwrap().tolerance().channels()[0].samples,
        [0.5]
    );
    row(&[("id", &[0.5])]).write(&beside).unwrap();
    let error = Golden::read(&path).unwrap_err();
    assert_eq!(error.path, beside);
    assert!(error.problem.contains("does not fit its golden"), "{error}");
}

#[test]
fn a_golden_that_exempts_more_than_one_pixel_of_a_few_is_refused() {
    let golden = |allowed: &[f32]| Golden::new(row(&[("t", &[0.0; 3])]), row(&[("t", allowed)]));
    assert!(golden(&[0.0, EXEMPT, 0.0]).is_ok());
    let refused = golden(&[0.0, EXEMPT, EXEMPT]).unwrap_err();
    assert_eq!(
        refused,
        Refusal::TooLenient {
            exempt: 2,
            pixels: 3
        }
    );
}

#[test]
fn one_pixel_in_two_thousand_may_be_exempt_but_always_one() {
    let most = [1, 1999, 2000, 4000, 57_600].map(Golden::most_exempt);
    assert_eq!(most, [1, 1, 1, 2, 28]);
}

#[test]
fn pictures_show_where_a_film_misses_even_one_that_is_refused() {
    let golden = golden(&[0.0; 5], &[1.0; 5], 0.5);
    let film = hits(&[0.0; 5], &[1.5, 1.6, f32::NAN, f32::INFINITY, 0.5]);
    assert_eq!(golden.missed(&film, "t"), [false, true, true, true, false]);
    let lenient = one_channel(&[1.0; 2], &[EXEMPT, 0.0]);
    let film = row(&[("t", &[f32::INFINITY, 1.0])]);
    assert_eq!(lenient.missed(&film, "t"), [true, false]);
    assert_eq!(lenient.missed(&film, "id"), [true; 2]);
}

#[test]
fn only_a_failing_pixel_of_the_right_object_is_a_channels_own_except_for_ids() {
    let golden = golden(&[0.0; 3], &[1.0; 3], 0.5);
    let verdict = judge(&golden, &hits(&[0.0, 1.0, 0.0], &[3.0, 3.0, 1.0])).unwrap();
    let counts = |name| (channel(&verdict, name).failing, channel(&verdict, name).own);
    assert_eq!((counts("id"), counts("t")), ((1, 1), (2, 1)));
}

#[test]
fn of_equally_bad_pixels_the_first_is_shown() {
    let golden = one_channel(&[0.0; 3], &[1.0; 3]);
    let verdict = judge(&golden, &row(&[("t", &[0.0, 3.0, 3.0])])).unwrap();
    let worst = channel(&verdict, "t").worst.as_ref().unwrap();
    assert_eq!(worst.pixel.i, 1);
}
