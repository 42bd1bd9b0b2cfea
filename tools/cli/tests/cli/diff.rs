//! Films by another program, compared by both judges.

use std::path::{Path, PathBuf};
use std::process::Command;

use pinhole_testing::{RunResult, fresh, pinhole, root, trusted};

const GOLDEN: &str = "golden/ray_casting/sphere_and_plane.exr";

/// Writes variants of the golden with OpenImageIO's Python module, without any code of ours.
const WRITER: &str = r#"
import sys
import numpy as np
import OpenImageIO as oiio

source, target, what = sys.argv[1:]
buffer = oiio.ImageBuf(source)
pixels = buffer.get_pixels(oiio.FLOAT)
names = list(buffer.spec().channelnames)
id, t = names.index("id"), names.index("t")
full = None

if what == "nan":
    pixels[40, 80, t] = np.nan
elif what == "infinity":
    pixels[40, 80, t] = np.inf
elif what == "cropped":
    pixels = pixels[:-3, :-3]
elif what == "padded":
    padded = np.zeros((96, 170, 5), np.float32)
    padded[:90, :160] = pixels
    pixels = padded
elif what == "window":
    full = (-5, -5, 170, 100)
elif what == "missing":
    keep = [k for k, name in enumerate(names) if name != "N.Z"]
    pixels, names = pixels[:, :, keep], [names[k] for k in keep]
elif what == "extra":
    pixels, names = np.concatenate([pixels, pixels[:, :, :1]], 2), names + ["A"]
elif what == "renamed":
    names = ["N.W" if name == "N.Z" else name for name in names]
elif what == "black":
    pixels = pixels * 0
elif what == "one_id":
    pixels[40, 80, id] = 5
elif what == "t_shifted":
    pixels[:, :, t] += 1e-4
elif what == "t_at_misses":
    pixels[:, :, t] = np.where(pixels[:, :, id] < 0, 3e38, pixels[:, :, t])
elif what == "reversed_channels":
    pixels, names = pixels[:, :, ::-1], names[::-1]

height, width, count = pixels.shape
spec = oiio.ImageSpec(width, height, count, "half" if what == "half" else "float")
spec.channelnames = names
if full:
    spec.full_x, spec.full_y, spec.full_width, spec.full_height = full
output = oiio.ImageOutput.create(target)
output.open(target, spec)
output.write_image(np.ascontiguousarray(pixels))
output.close()
"#;

fn film(what: &str) -> PathBuf {
    let folder = fresh(&trusted(), &format!("diff-{what}"));
    let target = folder.join("film.exr");
    let python = root().join("tools/mitsuba/.venv/bin/python");
    let written = Command::new(python)
        .args(["-c", WRITER])
        .args([root().join(GOLDEN), target.clone()])
        .arg(what)
        .status()
        .expect("the Python environment was made: pinhole golden setup");
    assert!(written.success(), "{what} could not be written");
    target
}

fn diff(film: &Path) -> RunResult {
    pinhole(&["diff", GOLDEN, film.to_str().expect("a plain name")])
}

#[track_caller]
fn assert_refused_by_both(what: &str, because: &str) {
    diff(&film(what))
        .expect_code(1)
        .expect_out(because)
        .expect_out("oiiotool agrees");
}

#[test]
fn a_film_by_another_program_passes() {
    diff(&film("same"))
        .expect_code(0)
        .expect_out("passes")
        .expect_out("oiiotool agrees");
}

#[test]
fn the_order_of_channels_in_the_file_does_not_matter() {
    diff(&film("reversed_channels"))
        .expect_code(0)
        .expect_out("oiiotool agrees");
}

#[test]
fn t_is_ignored_where_nothing_is_hit() {
    diff(&film("t_at_misses"))
        .expect_code(0)
        .expect_out("oiiotool agrees");
}

#[test]
fn nan_and_infinity_are_refused() {
    assert_refused_by_both("nan", "channel `t` is NaN or infinite at pixel (80, 49)");
    assert_refused_by_both(
        "infinity",
        "channel `t` is NaN or infinite at pixel (80, 49)",
    );
}

#[test]
fn films_with_another_size_are_refused() {
    assert_refused_by_both("cropped", "157×87");
    assert_refused_by_both("padded", "170×96");
    assert_refused_by_both("window", "is not the whole picture");
}

#[test]
fn films_with_other_channels_are_refused() {
    assert_refused_by_both("missing", "no channel `N.Z`");
    assert_refused_by_both("extra", "channel `A`");
    assert_refused_by_both("renamed", "no channel `N.Z`");
    assert_refused_by_both("half", "does not hold 32-bit floats");
}

#[test]
fn a_black_film_one_wrong_id_and_a_small_shift_of_t_fail() {
    assert_refused_by_both("black", "14400 of 14400 pixels are wrong");
    assert_refused_by_both(
        "one_id",
        "1 pixel; worst at (80, 49): got object 5, expected object",
    );
    assert_refused_by_both("t_shifted", "pixels are wrong");
}

#[test]
fn diff_refuses_a_file_that_is_not_a_film() {
    let folder = fresh(&trusted(), "diff-garbage");
    let garbage = folder.join("film.exr");
    std::fs::write(&garbage, b"no film").expect("it can be written");
    diff(&garbage)
        .expect_code(1)
        .expect_out("refused")
        .expect_out("oiiotool agrees");
    diff(&folder.join("absent.exr"))
        .expect_code(2)
        .expect_err("there is no film file");
}

#[test]
fn a_damaged_film_that_oiiotool_reads_is_refused_and_not_our_bug() {
    let bytes = std::fs::read(root().join(GOLDEN)).expect("goldens are committed");
    let mut damaged = bytes[..8].to_vec();
    // An attribute that claims to be longer than the file.
    damaged.extend(b"x\0string\0\xff\xff\xff\x7f");
    damaged.extend(&bytes[8..]);
    let film = fresh(&trusted(), "diff-damaged").join("film.exr");
    std::fs::write(&film, damaged).expect("there is room");
    diff(&film).expect_code(1).expect_out("refused: ");
}

#[test]
fn both_judges_refuse_an_impossible_header() {
    let mut bytes = std::fs::read(root().join(GOLDEN)).expect("goldens are committed");
    let name = b"pixelAspectRatio\0float\0";
    let found = bytes.windows(name.len()).position(|window| window == name);
    // The name is followed by the value's length in four bytes, and then by the value.
    let value = found.expect("every film has an aspect") + name.len() + 4;
    bytes[value..value + 4].copy_from_slice(&f32::NEG_INFINITY.to_le_bytes());
    let film = fresh(&trusted(), "diff-aspect").join("film.exr");
    std::fs::write(&film, bytes).expect("it can be written");
    diff(&film)
        .expect_code(1)
        .expect_out("refused")
        .expect_out("oiiotool agrees");
}

#[test]
fn pictures_and_json_say_where_the_films_differ() {
    let film = film("one_id");
    let out = film.with_file_name("pictures");
    let [film, folder] = [&film, &out].map(|path| path.to_str().expect("a plain name"));
    let ran = pinhole(&["diff", GOLDEN, film, "--out", folder, "--json"]).expect_code(1);
    let said = ran.json();
    assert_eq!(said["verdict"]["failing"], 1);
    assert_eq!(said["oiiotool"]["passes"], false);
    for file in ["expected-id.png", "got-id.png", "difference.png"] {
        assert!(out.join(file).is_file(), "{file}");
    }
}
