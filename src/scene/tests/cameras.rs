//! Cameras and films as a scene file describes them.

use super::*;

#[test]
fn a_perspective_camera_sees_from_its_image_plane_on() {
    assert_eq!(read(GOOD).unwrap().min_t, 1.0);
}

#[test]
fn an_orthographic_camera_sees_from_its_eye_on() {
    let text = with("focal_length = 1.5\n", "").replace("perspective", "orthographic");
    let scene = read(&text).unwrap();
    assert_eq!(scene.camera.projection, Projection::Orthographic);
    assert_eq!(scene.min_t, 0.0);
}

#[test]
fn min_t_may_be_chosen() {
    let text = with("width = 2.0", "width = 2.0\nmin_t = 0.25");
    assert_eq!(read(&text).unwrap().min_t, 0.25);
}

#[test]
fn unknown_projection_lists_both() {
    refused(
        "\"perspective\"",
        "▶\"fisheye\"",
        "unknown variant `fisheye`, expected `perspective` or `orthographic`",
        "in the book",
    );
}

#[test]
fn up_along_the_line_of_sight_is_refused() {
    for up in ["[0.0, 0.0, -7.0]", "[0.0, 0.0, 0.5]"] {
        refused(
            "up = [0.0, 3.0, 1.0]",
            &format!("up = ▶{up}"),
            "`up` is parallel to `view`",
            "turn `up`",
        );
    }
}

#[test]
fn a_film_has_at_least_one_pixel_and_fits_in_memory() {
    let resolution = "resolution = [8, 5]";
    for bad in [
        "[0, 5]",
        "[8, 0]",
        "[100000, 100000]",
        "[9223372036854775807, 9]",
    ] {
        refused(
            resolution,
            &format!("resolution = ▶{bad}"),
            "a film can't have",
            "at least one column and one row",
        );
    }
}

#[test]
fn pixels_are_counted_in_whole_numbers() {
    refused(
        "resolution = [8, 5]",
        "resolution = [8, ▶-5]",
        "integer `-5`, expected usize",
        "in the book",
    );
    refused(
        "resolution = [8, 5]",
        "resolution = [8, ▶2.5]",
        "invalid type",
        "in the book",
    );
}

#[test]
fn an_orthographic_camera_has_no_focal_length() {
    refused_text(
        &with("= 1.5", "= ▶1.5").replace("perspective", "orthographic"),
        "an orthographic camera has no focal length",
        "remove `focal_length`",
    );
}

#[test]
fn a_perspective_camera_needs_its_focal_length() {
    refused_text(
        &with("focal_length = 1.5\n", "").replace("[camera]", "▶[camera]"),
        "needs a `focal_length`",
        "focal_length = 1.0",
    );
}
