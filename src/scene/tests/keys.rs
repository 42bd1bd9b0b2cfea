//! Keys that are unknown, missing, or hold something of the wrong kind.

use super::*;

#[test]
fn error_points_at_an_unknown_key() {
    refused(
        "radius = 0.75",
        "radius = 0.75\n▶radios = 1.0",
        "unknown field `radios`",
        "correct its spelling",
    );
    refused(
        "width = 2.0",
        "▶widht = 2.0\nwidth = 2.0",
        "unknown field `widht`",
        "correct its spelling",
    );
    refused(
        "# One of each shape that needs no file.",
        "▶title = \"shapes\"",
        "unknown field `title`",
        "remove the key",
    );
}

#[test]
fn light_is_refused_with_the_reason() {
    let why = "scenes have no lights, materials or lenses";
    refused(
        "[[object]]\ntype = \"plane\"",
        "[[▶light]]\nposition = [0.0, 9.0, 0.0]\n\n[[object]]\ntype = \"plane\"",
        why,
        "remove `light`",
    );
    refused(
        "radius = 0.75",
        "radius = 0.75\n▶material = \"glass\"",
        why,
        "remove `material`",
    );
    refused(
        "width = 2.0",
        "width = 2.0\n▶lens = 0.1",
        why,
        "remove `lens`",
    );
}

#[test]
fn missing_key_is_reported_at_its_table() {
    let object = "[[object]]\ntype = \"sphere\"\ncenter = [0.0, 1.0, -1.0]\nradius = 0.75";
    refused(
        object,
        "▶[[object]]\ntype = \"sphere\"\ncenter = [0.0, 1.0, -1.0]",
        "this sphere has no `radius`",
        "a sphere needs: center, radius",
    );
    refused(
        object,
        "▶[[object]]\ncenter = [0.0, 1.0, -1.0]\nradius = 0.75",
        "missing field `type`",
        "in the book",
    );
    refused(
        "[camera]\nprojection = \"perspective\"\neye = [0.0, 1.0, 5.0]",
        "▶[camera]\nprojection = \"perspective\"",
        "missing field `eye`",
        "in the book",
    );
}

#[test]
fn scene_without_a_camera_is_refused() {
    let objects = &GOOD[GOOD.find("[[object]]").unwrap()..];
    refused_text(
        &format!("▶{objects}"),
        "missing field `camera`",
        "in the book",
    );
}

#[test]
fn error_points_at_a_value_of_the_wrong_kind() {
    refused(
        "radius = 0.75",
        "radius = ▶\"big\"",
        "invalid type: string \"big\", expected f64",
        "in the book",
    );
    refused(
        "center = [0.0, 1.0, -1.0]",
        "center = ▶[0.0, 1.0]",
        "invalid length 2",
        "in the book",
    );
}
