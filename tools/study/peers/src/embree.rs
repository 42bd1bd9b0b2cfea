//! Embree, one ray at a time (`rtcIntersect1`).

#![expect(
    unsafe_code,
    reason = "Embree is a C library, and no crate for Debian's version is maintained"
)]

use std::ffi::{c_float, c_uint, c_void};

use crate::mesh::Mesh;
use crate::peer::Cast;
use crate::rays::Ray;

/// The same layout as in `embree.c`. Only the C code uses the pointers.
#[repr(C)]
struct Handles {
    device: *mut c_void,
    scene: *mut c_void,
}

unsafe extern "C" {
    fn pinhole_embree_build(
        mesh: *mut Handles,
        corners: *const [c_float; 3],
        corner_count: c_uint,
        indices: *const c_uint,
        triangle_count: c_uint,
    );
    fn pinhole_embree_cast(
        mesh: *const Handles,
        rays: *const [c_float; 6],
        count: c_uint,
        t: *mut c_float,
    );
    fn pinhole_embree_release(mesh: *mut Handles);
}

struct Scene(Handles);

/// Casts with Embree's `RTC_SCENE_FLAG_ROBUST`.
pub fn robust(mesh: &Mesh, rays: &[Ray]) -> Cast {
    let mut scene = Scene(Handles {
        device: std::ptr::null_mut(),
        scene: std::ptr::null_mut(),
    });
    let corners = mesh.triangles.as_flattened();
    let count = c_uint::try_from(corners.len()).expect("the mesh is small");
    // Triangles share no corners here, which changes nothing for Embree: it copies them to leaves.
    let indices: Vec<c_uint> = (0..count).collect();
    // SAFETY: both buffers have the lengths that are passed, and are copied before the call
    // returns.
    unsafe {
        pinhole_embree_build(
            &mut scene.0,
            corners.as_ptr(),
            count,
            indices.as_ptr(),
            count / 3,
        );
    }
    let numbers = |ray: &Ray| {
        let ([a, b, c], [x, y, z]) = (ray.origin.array(), ray.direction.array());
        [a, b, c, x, y, z]
    };
    let rays: Vec<[f32; 6]> = rays.iter().map(numbers).collect();
    Box::new(move || {
        let mut t = vec![0.0; rays.len()];
        let count = c_uint::try_from(rays.len()).expect("there are few rays");
        // SAFETY: the scene is built, and `t` has room for one number per ray.
        unsafe {
            pinhole_embree_cast(&scene.0, rays.as_ptr(), count, t.as_mut_ptr());
        }
        t.into_iter().map(f64::from).collect()
    })
}

impl Drop for Scene {
    fn drop(&mut self) {
        // SAFETY: the scene was built, and `drop` runs once.
        unsafe { pinhole_embree_release(&mut self.0) }
    }
}
