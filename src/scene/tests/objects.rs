//! Objects as a scene file describes them.

use std::fs;

use super::*;

#[test]
fn unknown_shape_lists_all_shapes() {
    refused(
        "type = \"sphere\"",
        "type = ▶\"cube\"",
        "unknown variant `cube`, expected one of `sphere`, `plane`, `triangle`, `soup`, `disk`",
        "in the book",
    );
}

#[test]
fn every_shape_names_each_key_it_misses() {
    for (shape, keys) in [
        ("sphere", ["center", "radius"].as_slice()),
        ("plane", &["point", "normal"]),
        ("triangle", &["corners"]),
        ("soup", &["obj"]),
        ("disk", &["center", "normal", "radius"]),
    ] {
        let value = |key: &str| match key {
            "radius" => "1.0",
            "corners" => "[[0, 0, 0], [1, 0, 0], [0, 1, 0]]",
            _ => "[0, 0, 1]",
        };
        for missing in keys {
            let given: String = keys
                .iter()
                .filter(|key| key != &missing)
                .map(|key| format!("{key} = {}\n", value(key)))
                .collect();
            refused_text(
                &format!("{GOOD}\n▶[[object]]\ntype = \"{shape}\"\n{given}"),
                &format!("this {shape} has no `{missing}`"),
                &keys.join(", "),
            );
        }
    }
}

#[test]
fn a_key_of_another_shape_is_refused() {
    refused(
        "radius = 0.75",
        "radius = 0.75\nnormal = ▶[0.0, 1.0, 0.0]",
        "a sphere has no `normal`",
        "a sphere takes: center, radius; remove `normal` or change the type",
    );
}

#[test]
fn corners_on_one_line_are_refused() {
    for corners in [
        "[[0, 0, 0], [1, 1, 1], [3, 3, 3]]",
        "[[1, 2, 3], [1, 2, 3], [4, 4, 5]]",
        "[[1, 2, 3], [4, 4, 5], [4, 4, 5]]",
        // Rounded to binary, these points are not on one line.
        "[[0.1, 0.2, 0.3], [0.2, 0.4, 0.6], [0.3, 0.6, 0.9]]",
    ] {
        refused(
            "[[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]",
            &format!("▶{corners}"),
            "no area and no normal",
            "move one corner",
        );
    }
}

#[test]
fn thin_triangle_is_accepted() {
    let thin = "[[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1e-12, 0.0]]";
    let corners = "[[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]";
    assert_eq!(read(&with(corners, thin)).unwrap().objects.len(), 3);
}

#[test]
fn triangle_may_be_of_any_size() {
    let corners = "[[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]";
    for size in ["1e-300", "1e200", "1.7e308"] {
        let of_size = format!("[[-{size}, 0, 0], [{size}, 0, 0], [0, {size}, 0]]");
        assert!(read(&with(corners, &of_size)).is_ok(), "{size}");
    }
}

#[test]
fn a_mesh_is_looked_for_beside_its_scene() {
    let (folder, path) = testing::file(
        "a scene.toml",
        format!("{GOOD}\n[[object]]\ntype = \"soup\"\nobj = \"meshes/one.obj\"\n"),
    );
    fs::create_dir(folder.path().join("meshes")).unwrap();
    let mesh = folder.path().join("meshes/one.obj");
    fs::write(mesh, "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").unwrap();

    let objects = Scene::read(&path).unwrap().objects;
    let Some(Shape::Soup(soup)) = objects.last() else {
        panic!("the last object is {:?}", objects.last());
    };
    assert_eq!(soup.triangles.len(), 1);
}

#[test]
fn error_points_at_the_line_that_names_a_missing_mesh() {
    refused_text(
        &format!("{GOOD}\n[[object]]\ntype = \"soup\"\nobj = ▶\"no such.obj\"\n"),
        "no such.obj: cannot read this mesh",
        "relative to the scene's folder",
    );
}

#[test]
fn error_points_into_a_broken_mesh() {
    let (folder, path) = testing::file(
        "a scene.toml",
        format!("{GOOD}\n[[object]]\ntype = \"soup\"\nobj = \"broken.obj\"\n"),
    );
    let mesh = folder.path().join("broken.obj");
    fs::write(&mesh, "v 0 0 0\nf 1 2 3\n").unwrap();
    let error = Scene::read(&path).unwrap_err();
    assert_eq!((error.path, error.position), (mesh, Some((2, 1))));
}

#[test]
fn disk_is_read_as_described() {
    let disk =
        "\n[[object]]\ntype = \"disk\"\ncenter = [1, 2, 3]\nnormal = [0, 0, 2]\nradius = 0.5\n";
    let objects = read(&format!("{GOOD}{disk}")).unwrap().objects;
    let expected = Disk {
        center: dvec3(1.0, 2.0, 3.0),
        normal: dvec3(0.0, 0.0, 2.0),
        radius: 0.5,
    };
    assert_eq!(objects.last(), Some(&Shape::Disk(expected)));
}
