//! Calls Embree for one ray at a time (`rtcIntersect1`).

#![expect(
    unsafe_code,
    reason = "Embree is a C library, and no crate for Debian's version is maintained"
)]

use std::ffi::{c_float, c_uint, c_void};

use super::Cast;
use super::mesh::Mesh;
use crate::shape::Ray;

unsafe extern "C" {
    fn pinhole_embree_build(corners: *const [c_float; 3], triangles: c_uint) -> *mut c_void;
    fn pinhole_embree_cast(
        scene: *mut c_void,
        rays: *const [c_float; 6],
        count: c_uint,
        t: *mut c_float,
    );
}

/// Casts with Embree's `RTC_SCENE_FLAG_ROBUST`. The scene is never released.
pub fn robust(mesh: &Mesh, rays: &[Ray<f32>]) -> Cast {
    let numbers = |ray: &Ray<f32>| {
        let ([a, b, c], [x, y, z]) = (ray.origin.array(), ray.direction.array());
        [a, b, c, x, y, z]
    };
    let rays: Vec<[f32; 6]> = rays.iter().map(numbers).collect();
    let [triangles, count] =
        [mesh.triangles.len(), rays.len()].map(|all| c_uint::try_from(all).expect("it is small"));
    // SAFETY: there are three corners for each triangle, and Embree copies them.
    let scene = unsafe { pinhole_embree_build(mesh.triangles.as_flattened().as_ptr(), triangles) };
    Box::new(move || {
        let mut t = vec![0.0; rays.len()];
        // SAFETY: the scene is built, and `t` has room for one number per ray.
        unsafe { pinhole_embree_cast(scene, rays.as_ptr(), count, t.as_mut_ptr()) };
        t.into_iter().map(f64::from).collect()
    })
}
