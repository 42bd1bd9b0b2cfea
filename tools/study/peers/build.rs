//! Compiles the few lines of C that call Embree, if its header is there (Debian:
//! `libembree-dev`); the benchmark says so if it is not.

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
