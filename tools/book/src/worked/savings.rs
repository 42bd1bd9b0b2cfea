//! What boxes save: tests counted in the bunny's picture and in scenes of ever more triangles.

use std::mem::size_of;

use glam::DVec3;
use pinhole::tree::FlatNode;
use pinhole::{BoundingBox, Ray, Resolution, Scene, Shape, Triangle, TriangleSoup};
use pinhole_course::assignment::Assignment;

use super::Values;
use super::boxes::LARGEST_LEAF;
use crate::boxes::{MeshTree, Search, Tests, box_of, enters_in_f32, inside, meet};
use crate::error::{Error, Result};
use crate::rasterizer::{camera, strewn};
use crate::reference::Reference;

/// The picture of scattered triangles.
pub const SCATTERED_RESOLUTION: Resolution = Resolution { n_x: 160, n_y: 90 };

/// Adds the counts.
pub fn add(values: &mut Values, reference: &Reference, assignment: &Assignment) -> Result<()> {
    let scene = Scene::read(&assignment.scene("bunny"))?;
    let rays = reference.viewing_rays(scene.camera, scene.resolution)?;
    bunny(values, &scene, &rays)?;
    sizes(values, reference)
}

/// What the bunny costs.
fn bunny(values: &mut Values, scene: &Scene, rays: &[Ray]) -> Result<()> {
    let Some(Shape::Soup(TriangleSoup { triangles })) = scene.objects.first() else {
        return Err(Error::environment(
            "the bunny's scene has no bunny",
            "report this",
        ));
    };
    let mut add = |name: &str, text: String| values.insert(format!("bunny_{name}"), text);
    let per_ray = |tests: usize| format!("{:.1}", tests as f64 / rays.len() as f64);
    add("triangles", grouped(triangles.len()));
    add("rays", grouped(rays.len()));
    add("brute", grouped(triangles.len() * rays.len()));
    let tests = |largest: usize, how: Search| -> (usize, usize, Tests) {
        let boxed = MeshTree::new(triangles.clone(), largest);
        (
            boxed.nodes(),
            boxed.depth(),
            boxed.tests(rays, scene.min_t, how),
        )
    };
    let unordered = Search {
        nearer_first: false,
        ..Search::FULL
    };
    let endless = Search {
        stops: false,
        ..Search::FULL
    };
    for (name, how) in [
        ("full", Search::FULL),
        ("unordered", unordered),
        ("endless", endless),
    ] {
        let (_, _, tests) = tests(LARGEST_LEAF, how);
        add(&format!("{name}_tests"), grouped(tests.sum()));
        add(&format!("{name}_boxes_per_ray"), per_ray(tests.boxes));
        add(
            &format!("{name}_triangles_per_ray"),
            per_ray(tests.triangles),
        );
        add(&format!("{name}_per_ray"), per_ray(tests.sum()));
        let saved = (triangles.len() * rays.len()) as f64 / tests.sum() as f64;
        add(&format!("{name}_fewer"), format!("{saved:.0}"));
    }
    let root = box_of(triangles);
    let meet_root = |ray: &&Ray| inside(&root, ray, scene.min_t, f64::INFINITY).is_some();
    add(
        "rays_at_root",
        grouped(rays.iter().filter(meet_root).count()),
    );
    for largest in [1, 2, 4, 8, 16] {
        let (nodes, depth, tests) = tests(largest, Search::FULL);
        add(&format!("leaf_{largest}_nodes"), grouped(nodes));
        add(&format!("leaf_{largest}_depth"), depth.to_string());
        add(&format!("leaf_{largest}_boxes"), per_ray(tests.boxes));
        add(
            &format!("leaf_{largest}_triangles"),
            per_ray(tests.triangles),
        );
        add(&format!("leaf_{largest}_per_ray"), per_ray(tests.sum()));
    }
    // A ray to each corner of each triangle, all of which lie on their boxes' faces.
    let eye = scene.camera.eye;
    let aimed = triangles.iter().flat_map(|triangle| {
        let ray = |corner: DVec3| Ray {
            origin: eye,
            direction: corner - eye,
        };
        triangle.corners.map(|corner| (*triangle, ray(corner)))
    });
    let met: Vec<(Triangle, Ray)> = aimed
        .filter(|(triangle, ray)| meet(triangle, ray, 0.0).is_some())
        .collect();
    add("corner_rays", grouped(met.len()));
    let lost = |enters: &dyn Fn(&BoundingBox, &Ray) -> bool| {
        let lost = met
            .iter()
            .filter(|(triangle, ray)| !enters(&box_of(&[*triangle]), ray));
        grouped(lost.count())
    };
    let whole = (root.max - root.min).max_element() as f32;
    let f64_slabs =
        |bounds: &BoundingBox, ray: &Ray| inside(bounds, ray, 0.0, f64::INFINITY).is_some();
    add("lost_f64", lost(&f64_slabs));
    add(
        "lost_f32",
        lost(&|bounds, ray| enters_in_f32(bounds, ray, 0.0)),
    );
    add(
        "lost_f32_padded",
        lost(&|bounds, ray| enters_in_f32(bounds, ray, 1e-6 * whole)),
    );
    Ok(())
}

/// A tree over this many scattered triangles, which always cover the same share of the picture, and
/// how many tests each of these rays takes on average.
pub fn scattered(count: usize, rays: &[Ray]) -> (MeshTree, f64) {
    let triangles = strewn(count, 10.0 / (count as f64).sqrt());
    let boxed = MeshTree::new(triangles, LARGEST_LEAF);
    let tests = boxed.tests(rays, 1.0, Search::FULL).sum() as f64 / rays.len() as f64;
    (boxed, tests)
}

/// Meshes of ever more triangles.
fn sizes(values: &mut Values, reference: &Reference) -> Result<()> {
    let rays = reference.viewing_rays(camera(), SCATTERED_RESOLUTION)?;
    for exponent in 1..=5 {
        let count = 10_usize.pow(exponent);
        let (boxed, tests) = scattered(count, &rays);
        let bytes = boxed.nodes() * (size_of::<FlatNode>() + size_of::<BoundingBox>())
            + count * size_of::<usize>();
        let mut add = |name: &str, text| values.insert(format!("size_1e{exponent}_{name}"), text);
        add("tests", format!("{tests:.1}"));
        add("fewer", format!("{:.0}", count as f64 / tests));
        add("nodes", grouped(boxed.nodes()));
        add("depth", boxed.depth().to_string());
        add("kilobytes", grouped(bytes.div_ceil(1000)));
    }
    Ok(())
}

fn grouped(number: usize) -> String {
    crate::record::grouped(number as u64)
}
