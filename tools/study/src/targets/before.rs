//! The figures that were there before this instrument: `NOTES.md` of this package.

use super::sweeps::{Kernel, Place};

/// Wrong decisions of `f64` kernels on spheres, at distance/radius 1e6, 1e7 and 1e8.
pub const SPHERE_WRONG: [(&str, [f64; 3]); 4] = [
    ("textbook", [0.0005, 0.029, 0.48]),
    ("half-b", [0.0005, 0.029, 0.48]),
    ("stable-q", [0.0005, 0.029, 0.48]),
    ("fma discriminant", [0.0005, 0.023, 0.46]),
];

/// Wrong decisions elsewhere.
pub const WRONG: [(Place, Kernel, f64); 3] = [
    (("sphere", "distance", 2), ("textbook", "f32"), 0.0005),
    (("sphere", "distance", 3), ("textbook", "f32"), 0.16),
    (("sphere", "distance", 4), ("textbook", "f32"), 0.52),
];

/// Of true hits, the share that is lost.
pub const HITS_LOST: [(Place, Kernel, f64); 3] = [
    (("triangle", "small", 4), ("M–T with epsilon", "f64"), 0.63),
    (("triangle", "small", 5), ("M–T with epsilon", "f64"), 1.0),
    (("plane", "parallel", 6), ("epsilon cut", "f64"), 0.49),
];

/// Median errors of t, in ulp.
pub const MEDIAN_ULP: [(Place, Kernel, f64); 5] = [
    (("sphere", "distance", 8), ("textbook", "f64"), 3e7),
    (("sphere", "distance", 8), ("fma discriminant", "f64"), 7e7),
    (("sphere", "distance", 9), ("Haines et al.", "f64"), 0.65),
    (("plane", "offset", 9), ("shifted origin", "f64"), 0.6),
    (("plane", "offset", 9), ("plain", "f64"), 2e8),
];

/// Costs relative to the fastest kernel, in `f64`.
pub const COSTS: [(&str, &str, f64); 13] = [
    ("sphere", "textbook", 1.25),
    ("sphere", "half-b", 1.35),
    ("sphere", "stable-q", 1.54),
    ("sphere", "fma discriminant", 1.59),
    ("sphere", "Haines et al.", 2.36),
    ("sphere", "Haines scaled", 2.92),
    ("sphere", "adaptive exact", 3.45),
    ("plane", "shifted origin", 1.06),
    ("triangle", "Cramer", 1.1),
    ("triangle", "Möller–Trumbore", 1.0),
    ("triangle", "edge functions", 1.04),
    ("triangle", "Woop–Benthin–Wald", 1.15),
    ("triangle", "adaptive exact", 2.0),
];

/// Leaks and double hits in `f64`: at edges, at vertices.
/// (What owns edges is younger, and was promised.)
pub const MESHES: [(&str, [f64; 2], [f64; 2]); 6] = [
    ("Cramer", [0.061, 0.027], [0.33, 0.83]),
    ("Möller–Trumbore", [0.055, 0.018], [0.37, 0.87]),
    ("edge functions", [0.0, 0.0011], [0.30, 0.91]),
    ("Woop–Benthin–Wald", [0.0, 0.0], [0.0, 0.47]),
    ("Woop, edges owned", [0.0, 0.0], [0.0, 0.0]),
    ("adaptive exact", [0.0, 0.0], [0.0, 0.0]),
];
