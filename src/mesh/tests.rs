use std::fs;

use super::*;
use crate::testing::{self, Random};
use glam::dvec3;

const SQUARE: &str = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

fn from(text: &str) -> Result<Vec<Corners>, Error> {
    parse(text, Path::new("mesh.obj"))
}

#[track_caller]
fn corners(text: &str) -> Vec<Corners> {
    from(text).unwrap()
}

#[track_caller]
fn refused(text: &str, line: usize, problem: &str) {
    let error = from(text).expect_err("this mesh should be refused");
    assert_eq!(error.position, Some((line, 1)), "{error}");
    assert!(error.problem.contains(problem), "{error}");
    assert!(!error.remedy.is_empty());
}

#[test]
fn a_polygon_is_a_fan_around_its_first_corner() {
    let [a, b, c, d] = [
        dvec3(0.0, 0.0, 0.0),
        dvec3(1.0, 0.0, 0.0),
        dvec3(1.0, 1.0, 0.0),
        dvec3(0.0, 1.0, 0.0),
    ];
    assert_eq!(
        corners(&format!("{SQUARE}f 1 2 3 4\n")),
        [[a, b, c], [a, c, d]]
    );
}

#[test]
fn a_polygon_of_n_corners_is_n_minus_2_triangles_that_share_the_first() {
    for n in 3..12 {
        let vertices: String = (0..n).map(|k| format!("v {k} {} 0\n", k * k)).collect();
        let face: String = (1..=n).map(|k| format!(" {k}")).collect();
        let triangles = corners(&format!("{vertices}f{face}\n"));
        assert_eq!(triangles.len(), n - 2);
        for (k, [a, b, c]) in triangles.into_iter().enumerate() {
            assert_eq!((a.x, b.x, c.x), (0.0, k as f64 + 1.0, k as f64 + 2.0));
        }
    }
}

#[test]
fn triangles_stand_in_the_order_of_the_file_whatever_group_they_are_in() {
    let text = format!("{SQUARE}o b\nf 1 2 3\ng a\nusemtl z\nf 2 3 4\nf 3 4 1\no b\nf 4 1 2\n");
    let first: Vec<DVec3> = corners(&text).iter().map(|[a, ..]| *a).collect();
    let squares: Vec<DVec3> = corners(&format!("{SQUARE}f 1 2 3\nf 2 3 4\nf 3 4 1\nf 4 1 2\n"))
        .iter()
        .map(|[a, ..]| *a)
        .collect();
    assert_eq!(first, squares);
}

#[test]
fn negative_indices_count_back_from_the_face() {
    assert_eq!(
        corners(&format!("{SQUARE}f -4 -3 -2\nv 9 9 9\nf -1 -3 1\n")),
        corners(&format!("{SQUARE}f 1 2 3\nv 9 9 9\nf 5 3 1\n"))
    );
}

#[test]
fn only_positions_matter() {
    let plain = corners(&format!("{SQUARE}f 1 2 3\n"));
    for (dressed, what) in [
        ("f 1/9/9 2//7 3/5\n", "coordinates that are not there"),
        (
            "vt 0 0\nvn 0 0 1\nf 1/1/1 2/1/1 3/1/1\n",
            "coordinates and normals",
        ),
        (
            "vt 0 0\nf 1/-9223372036854775808/1 2/-5 3/-5\n",
            "hostile ones",
        ),
        ("mtllib none.mtl\nusemtl\ns off\nf 1 2 3\n", "materials"),
        ("f 1 2 3 # the lower right half\n", "a comment"),
        ("l 1 2 3 4\np 1\nl 1 99\nf 1 2 3\n", "lines and points"),
        ("f 1 2\nf 1\nf\nf 1 2 3\n", "faces without area"),
        ("  f\t1   2 3\n", "blanks"),
    ] {
        assert_eq!(corners(&format!("{SQUARE}{dressed}")), plain, "{what}");
    }
}

#[test]
fn a_vertex_is_its_x_y_z() {
    let plain = corners("v 1 2 3\nv 2 0 0\nv 0 2 0\nf 1 2 3\n");
    for (first, what) in [
        ("v 1 2 3 2", "w"),
        ("v 1 2 3 0.5 0.5 0.5", "a colour"),
        ("v 1 2 3 # the tip", "a comment"),
        ("v 1e0 +2 3.", "other spellings"),
    ] {
        let text = format!("{first}\nv 2 0 0\nv 0 2 0\nf 1 2 3\n");
        assert_eq!(corners(&text), plain, "{what}");
    }
}

#[test]
fn windows_line_ends_change_nothing() {
    let text = format!("{SQUARE}f 1 2 3 4\n# end");
    assert_eq!(corners(&text), corners(&text.replace('\n', "\r\n")));
}

#[test]
fn missing_mesh_is_an_error() {
    let folder = tempfile::tempdir().unwrap();
    for path in [folder.path().join("absent.obj"), folder.path().into()] {
        let error = read(&path).unwrap_err();
        assert_eq!(error.path, path);
        assert!(error.problem.contains("cannot read this mesh"), "{error}");
        assert!(error.remedy.contains("relative to the scene"), "{error}");
    }
}

#[test]
fn mesh_without_a_face_is_refused() {
    for text in ["", "\n\n", "# nothing\n", SQUARE, "l 1 2\n", "{}"] {
        let error = from(text).unwrap_err();
        assert_eq!(error.problem, "this mesh has no faces", "{text:?}");
    }
}

#[test]
fn error_points_at_a_face_whose_vertex_is_missing() {
    for (face, bad) in [
        ("f 1 2 5", "vertex 5"),
        ("f 0 1 2", "vertex 0"),
        ("f 1 2 -5", "vertex -5"),
        ("f 1/1 2/1 77/1", "vertex 77"),
        ("f 1 2 -9223372036854775808", "vertex -9223372036854775808"),
    ] {
        refused(&format!("{SQUARE}f 1 2 3\n\n{face}\nf 1 2 4\n"), 7, bad);
    }
}

#[test]
fn a_vertex_must_come_before_its_face() {
    refused(&format!("f 1 2 3\n{SQUARE}"), 1, "0 vertices precede it");
}

#[test]
fn error_points_at_a_vertex_that_is_not_a_number() {
    for vertex in ["v 0 nan 0", "v inf 0 0", "v 0 0 -inf", "v 1e999 0 0"] {
        let text = format!("# a mesh\n{SQUARE}{vertex}\nf 1 2 5\n");
        refused(&text, 6, "a vertex is not finite");
    }
}

#[test]
fn error_points_at_a_line_that_is_not_obj() {
    for line in ["v 1 2", "v", "v a b c", "f 1 2 x", "f 1 2 3.5", "f 1,2,3"] {
        let text = format!("{SQUARE}f 1 2 3\n{line}\nf 1 2 4\n");
        refused(&text, 6, "this is not a mesh");
        refused(&text.replace('\n', "\r\n"), 6, "this is not a mesh");
    }
}

#[test]
fn line_that_programs_read_differently_is_refused() {
    // Python would read a face here.
    for end in super::ONLY_IN_PYTHON {
        let text = format!("{SQUARE}f 1 2 3\n# a mesh{end}f 1 2 4\n");
        refused(&text, 6, "not all programs agree");
    }
}

#[test]
fn no_text_makes_the_reader_panic() {
    const WORDS: &[&str] = &[
        "v",
        "f",
        "l",
        "p",
        "o",
        "g",
        "vn",
        "vt",
        "usemtl",
        "mtllib",
        "#",
        "1",
        "2",
        "3",
        "-1",
        "0",
        "1/1/1",
        "1//2",
        "2/-9",
        "/",
        "//",
        "nan",
        "inf",
        "1e999",
        "-9223372036854775808",
        "9223372036854775807",
        "99999999999999999999",
        "é",
        "\u{feff}",
        "\\",
        "\r",
        "\u{a0}",
    ];
    let mut random = Random::new(2);
    for _ in 0..3000 {
        let mut text = SQUARE.to_owned();
        for _ in 0..random.below(12) {
            text += ["f 1", "v 1", "vt 1", ""][random.below(4)];
            for _ in 0..random.below(5) {
                text.extend([" ", *random.one_of(WORDS)]);
            }
            text.push('\n');
        }
        if let Ok(triangles) = from(&text) {
            let finite = |corners: &Corners| corners.iter().all(|c| c.is_finite());
            assert!(triangles.iter().all(finite), "{text}");
        }
    }
}

#[test]
fn no_bytes_make_the_reader_panic() {
    let mut random = Random::new(3);
    let (_folder, path) = testing::file("mesh.obj", "");
    for length in 0..100 {
        fs::write(&path, random.bytes(length)).unwrap();
        assert!(read(&path).is_err());
    }
}

#[test]
fn spoilt_meshes_do_not_harm_the_reader() {
    bolero::check!().for_each(|bytes| {
        if let Ok(text) = str::from_utf8(bytes)
            && let Ok(triangles) = from(text)
        {
            let mut corners = triangles.iter().flatten();
            assert!(corners.all(|corner| corner.is_finite()));
        }
    });
}
