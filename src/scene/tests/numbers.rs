//! Numbers that no scene may contain.

use super::*;

#[test]
fn nan_and_infinity_are_refused_in_scenes() {
    let remedy = "replace nan or inf with a number";
    refused(
        "radius = 0.75",
        "radius = ▶nan",
        "`radius` is not a finite",
        remedy,
    );
    refused(
        "width = 2.0",
        "width = ▶inf",
        "`width` is not a finite",
        remedy,
    );
    refused(
        "eye = [0.0, 1.0, 5.0]",
        "eye = ▶[0.0, nan, 5.0]",
        "`eye` is not a finite",
        remedy,
    );
    refused(
        "[[0.0, 0.0, 0.0], [1.0,",
        "▶[[0.0, 0.0, 0.0], [-inf,",
        "`corners` is not a finite",
        remedy,
    );
    refused(
        "width = 2.0",
        "width = 2.0\nmin_t = ▶nan",
        "`min_t` is not a finite",
        remedy,
    );
}

#[test]
fn vector_of_nearly_no_length_has_no_direction() {
    for (key, value) in [
        ("view", "[0.0, 0.0, -2.0]"),
        ("up", "[0.0, 3.0, 1.0]"),
        ("normal", "[0.0, 4.0, 0.0]"),
    ] {
        for (bad, length) in [("0.0, 0.0, 0.0", "0"), ("0.0, 1.3e-161, 0.0", "1.")] {
            refused(
                &format!("{key} = {value}"),
                &format!("{key} = ▶[{bad}]"),
                &format!("`{key}` has no direction: its length is {length}"),
                "it need not be a unit vector",
            );
        }
    }
}

#[test]
fn length_of_zero_or_less_is_refused() {
    for (key, value) in [
        ("width", "2.0"),
        ("height", "1.25"),
        ("radius", "0.75"),
        ("focal_length", "1.5"),
    ] {
        for bad in ["0", "-0", "-2"] {
            refused(
                &format!("{key} = {value}"),
                &format!("{key} = ▶{bad}.0"),
                &format!("`{key}` is {bad}"),
                "greater than 0",
            );
        }
    }
}

#[test]
fn negative_min_t_is_refused() {
    refused(
        "width = 2.0",
        "width = 2.0\nmin_t = ▶-0.5",
        "`min_t` is -0.5, behind the eye",
        "use 0 (the eye) or more",
    );
}
