//! Compiles the C wrapper around Embree if Embree's header is installed (Debian:
//! `libembree-dev`). Otherwise, the benchmark prints that it skips Embree.

fn main() {
    println!("cargo::rerun-if-changed=src/embree.c");
    for version in [4, 3] {
        let header = format!("/usr/include/embree{version}/rtcore.h");
        println!("cargo::rerun-if-changed={header}");
        if std::path::Path::new(&header).exists() {
            cc::Build::new()
                .file("src/embree.c")
                .define("EMBREE", version.to_string().as_str())
                .opt_level(3)
                .compile("pinhole_embree");
            println!("cargo::rustc-link-lib=embree{version}");
            println!("cargo::rustc-cfg=embree");
            break;
        }
    }
}
