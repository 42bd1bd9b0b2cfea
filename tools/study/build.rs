//! Compiles the C wrapper around Embree if Embree's header is installed (Debian:
//! `libembree-dev`). Otherwise, the study says that it did not compare our caster with Embree.

use std::path::Path;

fn main() {
    println!("cargo::rustc-check-cfg=cfg(embree)");
    println!("cargo::rerun-if-changed=build.rs");
    println!("cargo::rerun-if-changed=src/embree/binding.c");
    let headers = Path::new("/usr/include");
    let header = |version: &u32| headers.join(format!("embree{version}/rtcore.h"));
    if let Some(version) = [4, 3].into_iter().find(|version| header(version).exists()) {
        println!("cargo::rerun-if-changed={}", header(&version).display());
        cc::Build::new()
            .file("src/embree/binding.c")
            .define("EMBREE", version.to_string().as_str())
            .opt_level(3)
            .compile("pinhole_embree");
        println!("cargo::rustc-link-lib=embree{version}");
        println!("cargo::rustc-cfg=embree");
    } else if headers.exists() {
        // Notices when Embree is installed. Cargo would take a file that is missing for one that
        // changed, and build the study every time.
        println!("cargo::rerun-if-changed={}", headers.display());
    }
}
