//! The virtual camera: a frame, an image plane, and the grid of pixels on it.

use glam::DVec3;
use serde::{Deserialize, Serialize};

/// A virtual pinhole camera with its image plane in front of the eye.
///
/// The frame (`u`, `v`, `w`) is orthonormal and right-handed: `u` points right,
/// `v` up, and `w` *backwards*, so the camera looks along −`w` (Marschner &
/// Shirley, 4th ed., §4.3). [`Camera::new`] guarantees it.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Camera {
    /// The camera's position; world space, scene units.
    pub eye: DVec3,
    /// Unit vector towards the right of the picture, world space.
    pub u: DVec3,
    /// Unit vector towards the top of the picture, world space.
    pub v: DVec3,
    /// Unit vector *against* the viewing direction, world space.
    pub w: DVec3,
    /// Width of the image plane, scene units, positive.
    pub width: f64,
    /// Height of the image plane, scene units, positive.
    pub height: f64,
    /// How points are projected onto the image plane.
    pub projection: Projection,
}

/// How a camera projects.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub enum Projection {
    /// All rays leave the eye; the image plane is `focal_length` in front of it.
    Perspective {
        /// Distance from the eye to the image plane, scene units, positive.
        focal_length: f64,
    },
    /// All rays run along −`w`; the image plane contains the eye.
    Orthographic,
}

impl Camera {
    /// A camera at `eye` that looks along `view`, turned so that `up` points towards the top of the
    /// picture.
    ///
    /// Neither vector needs unit length, and `up` need not be perpendicular to `view`: w =
    /// −normalize(view), u = normalize(view × up), v = w × u. `None` if they are parallel or one of
    /// them is zero, because then they define no frame.
    ///
    /// ```
    /// use glam::DVec3;
    /// use pinhole::{Camera, Projection};
    ///
    /// let projection = Projection::Perspective { focal_length: 1.0 };
    /// let leaning = DVec3::new(0.0, 1.0, 0.3);
    /// let camera = Camera::new(DVec3::ZERO, -5.0 * DVec3::Z, leaning, (2.0, 1.0), projection);
    /// let camera = camera.expect("up is not parallel to view");
    /// assert_eq!((camera.u, camera.v, camera.w), (DVec3::X, DVec3::Y, DVec3::Z));
    /// ```
    pub fn new(
        eye: DVec3,
        view: DVec3,
        up: DVec3,
        (width, height): (f64, f64),
        projection: Projection,
    ) -> Option<Camera> {
        let forward = view.try_normalize()?;
        let w = -forward;
        let u = forward.cross(up.try_normalize()?);
        // This is the sine of the angle between the two. Below this limit, rounding errors would
        // decide the frame.
        if u.length() < PARALLEL {
            return None;
        }
        let u = u.normalize();
        let v = w.cross(u);
        // At the smallest angle, rounding tilts `u` by 1e-7; see PARALLEL.
        debug_assert!(v.is_normalized() && u.dot(w).abs() < 1e-6);
        Some(Camera {
            eye,
            u,
            v,
            w,
            width,
            height,
            projection,
        })
    }

    /// The distance of `point` from the eye along the viewing direction, scene
    /// units; negative behind the eye. This is what `depth` pictures show.
    pub fn depth(&self, point: DVec3) -> f64 {
        (point - self.eye).dot(-self.w)
    }

    /// The factor from a ray's t to [`depth`](Camera::depth): the length of its
    /// direction along −`w`, in scene units.
    pub fn depth_per_t(&self) -> f64 {
        match self.projection {
            Projection::Perspective { focal_length } => focal_length,
            Projection::Orthographic => 1.0,
        }
    }
}

/// The smallest sine between `view` and `up` that still makes a frame: at 1e-9
/// rounding turns `u` by up to 1e-7 rad, a thousandth of a pixel at 10,000 pixels.
const PARALLEL: f64 = 1e-9;

/// How many pixels a picture has.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Resolution {
    /// Columns, n_x, at least 1.
    pub n_x: usize,
    /// Rows, n_y, at least 1.
    pub n_y: usize,
}

impl Resolution {
    /// How many pixels there are.
    pub fn pixels(&self) -> usize {
        self.n_x * self.n_y
    }

    /// The pixel at `index` in a film's order: rows from the **top** of the
    /// picture, as image files have them.
    ///
    /// ```
    /// use pinhole::{Pixel, Resolution};
    ///
    /// let resolution = Resolution { n_x: 4, n_y: 3 };
    /// assert_eq!(resolution.pixel(0), Pixel { i: 0, j: 2 });
    /// assert_eq!(resolution.index(Pixel { i: 0, j: 0 }), 8);
    /// ```
    pub fn pixel(&self, index: usize) -> Pixel {
        Pixel {
            i: index % self.n_x,
            j: self.n_y - 1 - index / self.n_x,
        }
    }

    /// The inverse of [`pixel`](Resolution::pixel).
    pub fn index(&self, pixel: Pixel) -> usize {
        (self.n_y - 1 - pixel.j) * self.n_x + pixel.i
    }
}

impl std::fmt::Display for Resolution {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{}×{}", self.n_x, self.n_y)
    }
}

/// A pixel: column `i` from the left, row `j` from the **bottom**, both from 0.
///
/// Its centre in pixel space is (i + ½, j + ½).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(from = "[usize; 2]", into = "[usize; 2]")]
pub struct Pixel {
    /// Column, from the left.
    pub i: usize,
    /// Row, from the bottom.
    pub j: usize,
}

impl From<[usize; 2]> for Pixel {
    fn from([i, j]: [usize; 2]) -> Pixel {
        Pixel { i, j }
    }
}

impl From<Pixel> for [usize; 2] {
    fn from(pixel: Pixel) -> [usize; 2] {
        [pixel.i, pixel.j]
    }
}

impl std::fmt::Display for Pixel {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "({}, {})", self.i, self.j)
    }
}

#[cfg(test)]
mod tests;
