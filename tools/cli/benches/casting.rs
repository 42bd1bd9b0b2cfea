//! The cost of reading, casting and judging: `cargo bench -p pinhole-cli`.
//!
//! The reference casts, in a process of its own as always. The last table subtracts the start of
//! that process: it compares each film with one of a single pixel, and divides the difference by
//! the number of rays.

use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::{Duration, Instant};

use divan::{Bencher, black_box};
use pinhole::ask::{Ending, ask};
use pinhole::job::Job;
use pinhole::judge::{Golden, judge};
use pinhole::{Film, Resolution, Scene};

const SCENES: [&str; 12] = [
    "sphere_and_plane",
    "two_spheres_and_plane",
    "slide_example",
    "lone_triangle",
    "inside_a_box",
    "inside_a_sphere",
    "tilted_camera",
    "in_front_of_the_image_plane",
    "soup_order",
    "sphere_packing",
    "teapot_orthographic",
    "bunny",
];

/// How often each film of the last table is cast. The table shows the median.
const ROUNDS: usize = 11;

fn main() {
    build_reference();
    divan::main();
    if std::env::args().all(|argument| argument != "--test") {
        print_time_per_ray();
    }
}

#[divan::bench(args = SCENES)]
fn read_scene(name: &str) -> Scene {
    scene(name)
}

#[divan::bench(args = SCENES)]
fn read_and_judge_film(bencher: Bencher, name: &str) {
    let golden = golden(name);
    let film = Golden::read(&golden)
        .expect("goldens are committed")
        .film()
        .clone();
    bencher.bench(|| {
        let golden = Golden::read(&golden).expect("goldens are committed");
        judge(black_box(&golden), &film).map(|verdict| verdict.passes())
    });
}

#[divan::bench(args = SCENES)]
fn judge_film(bencher: Bencher, name: &str) {
    let golden = Golden::read(&golden(name)).expect("goldens are committed");
    let film = golden.film().clone();
    bencher.bench(|| judge(black_box(&golden), &film).map(|verdict| verdict.passes()));
}

#[divan::bench(args = SCENES, sample_count = 10, sample_size = 1)]
fn cast_film(bencher: Bencher, name: &str) {
    let scene = scene(name);
    bencher.bench(|| cast(scene.clone()));
}

fn print_time_per_ray() {
    println!(
        "\n{:<30}{:>10}{:>12}{:>14}",
        "scene", "rays", "film, ms", "ns per ray"
    );
    let mut whole = Duration::ZERO;
    for name in SCENES {
        let scene = scene(name);
        let mut one_pixel = scene.clone();
        one_pixel.resolution = Resolution { n_x: 1, n_y: 1 };
        let rays = scene.resolution.pixels() - 1;
        // Interleave the two, so that a busy machine slows both.
        let times = (0..ROUNDS).map(|_| (time(&scene), time(&one_pixel)));
        let (mut films, mut starts): (Vec<_>, Vec<_>) = times.unzip();
        films.sort();
        starts.sort();
        let (film, start) = (films[ROUNDS / 2], starts[ROUNDS / 2]);
        let each = film.saturating_sub(start).as_nanos() as f64 / rays as f64;
        println!(
            "{name:<30}{rays:>10}{:>12.2}{each:>14.0}",
            film.as_secs_f64() * 1e3
        );
        whole += film;
    }
    println!("{:<30}{:>10}{:>12.2}", "all", "", whole.as_secs_f64() * 1e3);
}

fn time(scene: &Scene) -> Duration {
    let start = Instant::now();
    cast(scene.clone());
    start.elapsed()
}

fn cast(scene: Scene) -> Film {
    let resolution = scene.resolution;
    let wall = Duration::from_secs(60);
    let reply = ask(
        Command::new(reference()),
        &Job::Film(scene),
        wall,
        &mut |_| {},
    )
    .expect("the reference was built");
    assert_eq!(reply.ending, Ending::Complete);
    reply.film(resolution)
}

fn scene(name: &str) -> Scene {
    let folder = root().join("assignments/ray_casting/scenes");
    Scene::read(&folder.join(name).with_extension("toml")).expect("the scene is committed")
}

fn golden(name: &str) -> PathBuf {
    root()
        .join("golden/ray_casting")
        .join(name)
        .with_extension("exr")
}

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
        .ancestors()
        .nth(2)
        .expect("tools/cli is in the checkout")
}

fn reference() -> PathBuf {
    Path::new(env!("CARGO_BIN_EXE_pinhole")).with_file_name("ray-casting-reference")
}

fn build_reference() {
    let mut cargo = Command::new(std::env::var_os("CARGO").unwrap_or("cargo".into()));
    cargo
        .current_dir(root())
        .args(["build", "--release", "-p", "ray-casting-reference"]);
    assert!(
        cargo.status().expect("cargo runs").success(),
        "the reference builds"
    );
}
