use super::*;

/// Three times the same picture of 100 pixels, of which so many differ by so much.
fn pictures(pixels: u32, difference: u8) -> Pictures {
    let picture = RgbImage::from_fn(10, 10, |x, y| {
        let differs = y * 10 + x < pixels;
        image::Rgb([100, 100, if differs { 100 + difference } else { 100 }])
    });
    Pictures([picture.clone(), picture.clone(), picture])
}

#[track_caller]
fn detected(pixels: u32, difference: u8, by: [bool; 3]) {
    let expected = pictures(0, 0);
    let got = pictures(pixels, difference);
    assert_eq!(
        SUITES.map(|suite| suite.detects(&expected, &got)),
        by,
        "Blender, OSL, OpenUSD"
    );
}

#[test]
fn a_percentage_of_pixels_may_differ() {
    detected(0, 0, [false, false, false]);
    detected(1, 255 - 100, [false, true, true]);
    detected(2, 255 - 100, [true, true, true]);
}

#[test]
fn small_differences_do_not_count() {
    // 1/255 is just below OSL's 0.004; 5/255 is 0.0196, 12/255 is 0.047.
    detected(100, 1, [false, false, false]);
    detected(100, 2, [false, true, false]);
    detected(100, 5, [true, true, false]);
    detected(100, 13, [true, true, true]);
}
