//! Films that are not compared at all.

use super::*;

#[test]
fn another_size_is_refused() {
    let six = [0.0; 6];
    let golden = Golden::new(grid(3, &[("t", &six)]), grid(3, &[("t", &six)])).unwrap();
    for n_x in [1, 2, 6] {
        let refusal = judge(&golden, &grid(n_x, &[("t", &six)])).unwrap_err();
        let got = Resolution { n_x, n_y: 6 / n_x };
        let expected = Resolution { n_x: 3, n_y: 2 };
        assert_eq!(refusal, Refusal::WrongSize { got, expected });
    }
}

#[test]
fn a_missing_channel_is_refused() {
    let golden = golden(&[0.0], &[1.0], 9.0);
    let film = row(&[
        ("id", &[0.0]),
        ("t", &[1.0]),
        ("N.X", &[0.0]),
        ("N.Z", &[0.0]),
    ]);
    assert_eq!(
        judge(&golden, &film),
        Err(Refusal::MissingChannel("N.Y".into()))
    );
}

#[test]
fn a_channel_of_another_name_is_missing_whatever_its_case() {
    let golden = one_channel(&[0.0], &[9.0]);
    assert_eq!(
        judge(&golden, &row(&[("T", &[0.0])])),
        Err(Refusal::MissingChannel("t".into()))
    );
}

#[test]
fn an_extra_channel_is_refused() {
    let golden = one_channel(&[0.0], &[9.0]);
    assert_eq!(
        judge(&golden, &row(&[("t", &[0.0]), ("alpha", &[1.0])])),
        Err(Refusal::ExtraChannel("alpha".into()))
    );
}

#[test]
fn nan_is_refused_even_at_exempt_pixels() {
    for bad in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY] {
        let golden = one_channel(&[0.0, 0.0], &[0.0, EXEMPT]);
        assert_eq!(
            judge(&golden, &row(&[("t", &[0.0, bad])])),
            Err(Refusal::NotFinite {
                channel: "t".into(),
                pixel: Pixel { i: 1, j: 0 }
            })
        );
    }
}

#[test]
fn a_refusal_says_what_and_where() {
    let size = |n_x, n_y| Resolution { n_x, n_y };
    let refusals = [
        (
            Refusal::WrongSize {
                got: size(4, 3),
                expected: size(8, 6),
            },
            ["4×3", "8×6"],
        ),
        (Refusal::MissingChannel("id".into()), ["no channel", "`id`"]),
        (Refusal::ExtraChannel("R".into()), ["channel", "`R`"]),
        (
            Refusal::NotFinite {
                channel: "t".into(),
                pixel: Pixel { i: 1, j: 2 },
            },
            ["`t`", "(1, 2)"],
        ),
    ];
    for (refusal, words) in refusals {
        let text = refusal.to_string();
        assert!(words.iter().all(|word| text.contains(word)), "{text}");
    }
}
