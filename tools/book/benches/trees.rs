//! What a tree saves as meshes grow: `cargo bench -p pinhole-book`.
//!
//! The meshes are those of the chapter "What it bought, and what it cost", and larger ones. Their
//! triangles are scattered by a fixed sequence, and are smaller the more there are. One thread does
//! all the work. The last table counts the tests, which are the same on every machine.

use std::sync::LazyLock;

use divan::Bencher;
use divan::counter::ItemsCount;
use pinhole::{Ray, Resolution, Triangle};
use pinhole_book::boxes::{MeshTree, Search};
use pinhole_book::rasterizer::{camera, strewn};
use pinhole_book::reference::Reference;
use pinhole_book::worked::boxes::LARGEST_LEAF;
use pinhole_course::checkout::Checkout;

const SIZES: [usize; 6] = [10, 100, 1_000, 10_000, 100_000, 1_000_000];

/// Without a tree, more triangles take too long.
const SMALL: [usize; 4] = [10, 100, 1_000, 10_000];

/// Where the image plane is.
const MIN_T: f64 = 1.0;

static RAYS: LazyLock<Vec<Ray>> = LazyLock::new(|| {
    let checkout = Checkout::find().expect("benchmarks run in a checkout");
    let reference = Reference::build(&checkout).expect("it builds");
    let resolution = Resolution { n_x: 160, n_y: 90 };
    let rays = reference.viewing_rays(camera(), resolution);
    rays.expect("the reference answers")
});

fn main() {
    divan::main();
    if std::env::args().all(|argument| argument != "--test") {
        print_tests_per_ray();
    }
}

/// Triangles that cover about the same share of the picture, however many there are.
fn mesh(count: usize) -> Vec<Triangle> {
    strewn(count, 10.0 / (count as f64).sqrt())
}

#[divan::bench(args = SIZES, sample_count = 5, sample_size = 1)]
fn build(bencher: Bencher, count: usize) {
    let inputs = bencher.with_inputs(|| mesh(count));
    inputs.bench_values(|triangles| MeshTree::new(triangles, LARGEST_LEAF));
}

#[divan::bench(args = SIZES, sample_count = 11, sample_size = 1)]
fn cast_with_tree(bencher: Bencher, count: usize) {
    cast(bencher, &MeshTree::new(mesh(count), LARGEST_LEAF));
}

#[divan::bench(args = SMALL, sample_count = 5, sample_size = 1)]
fn cast_without_tree(bencher: Bencher, count: usize) {
    cast(bencher, &MeshTree::new(mesh(count), count));
}

fn cast(bencher: Bencher, boxed: &MeshTree) {
    let rays = ItemsCount::new(RAYS.len());
    bencher
        .counter(rays)
        .bench(|| boxed.tests(&RAYS, MIN_T, Search::FULL).sum());
}

fn print_tests_per_ray() {
    let tests = |boxed: MeshTree| {
        let tests = boxed.tests(&RAYS, MIN_T, Search::FULL).sum();
        format!("{:.1}", tests as f64 / RAYS.len() as f64)
    };
    println!("tests for each of {} rays", RAYS.len());
    println!("triangles  with a tree  in one leaf");
    for count in SIZES {
        let with = tests(MeshTree::new(mesh(count), LARGEST_LEAF));
        let without = match SMALL.contains(&count) {
            true => tests(MeshTree::new(mesh(count), count)),
            false => "not counted".into(),
        };
        println!("{count:>9}  {with:>11}  {without:>11}");
    }
}
