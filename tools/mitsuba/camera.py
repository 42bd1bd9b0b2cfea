"""The course's camera and its rays, in float64: the definition of a pixel.

The camera stands at `eye`; its frame is w = -normalize(view),
u = normalize(view x up), v = w x u (Marschner & Shirley, Fundamentals of
Computer Graphics, 5th ed., section 4.3). Pixel (i, j) is column i from the
left, row j from the BOTTOM, with its centre at (i + 1/2, j + 1/2); on the image
plane, in scene units,

    u(i) = width/n_x (i + 1/2) - width/2
    v(j) = height/n_y (j + 1/2) - height/2.

A ray is p(t) = o + t d. In perspective o = eye and
d = u(i) u + v(j) v - focal_length w, NOT a unit vector: t = 1 lies on the image
plane. Orthographic rays start on the image plane, which contains the eye, and
have the unit direction d = -w.
"""

from dataclasses import dataclass

import numpy as np


def normalize(vector):
    """`vector` at unit length."""
    return vector / np.linalg.norm(vector)


@dataclass(frozen=True)
class Camera:
    """A camera as its scene file gives it; `view` and `up` of any length."""

    eye: np.ndarray
    view: np.ndarray
    up: np.ndarray
    width: float  # of the image plane, scene units
    height: float
    focal_length: float | None  # scene units; None is orthographic
    resolution: tuple[int, int]  # (n_x, n_y)
    min_t: float = 0.0  # in units of |d|

    @property
    def frame(self):
        """The orthonormal axes (u, v, w): right, up, backwards."""
        w = -normalize(self.view)
        u = normalize(np.cross(self.view, self.up))
        return u, np.cross(w, u), w

    @property
    def pixel_steps(self):
        """What one pixel to the right and one pixel up add to a ray (scene units).

        In perspective, both are added to the direction, otherwise to the origin.
        """
        u, v, _ = self.frame
        n_x, n_y = self.resolution
        return self.width / n_x * u, self.height / n_y * v

    @property
    def has_square_pixels(self):
        """Whether Mitsuba's own sensor, which has square pixels, can be used instead."""
        n_x, n_y = self.resolution
        return bool(np.isclose(self.width * n_y, self.height * n_x, rtol=1e-9, atol=0))

    def pixels(self):
        """The indices (i, j) of all pixels, row after row from the bottom."""
        n_x, n_y = self.resolution
        j, i = np.divmod(np.arange(n_x * n_y), n_x)
        return i, j

    def rays(self, i, j):
        """Origins and directions, each (N, 3), through the pixels (i, j).

        `i` and `j` are arrays and may be fractional: i + 0.001 is a ray displaced
        to the right by a thousandth of a pixel.
        """
        n_x, n_y = self.resolution
        u, v, w = self.frame
        across = self.width / n_x * (np.asarray(i) + 0.5) - self.width / 2
        upwards = self.height / n_y * (np.asarray(j) + 0.5) - self.height / 2
        in_plane = across[:, None] * u + upwards[:, None] * v
        if self.focal_length is None:
            return self.eye + in_plane, np.broadcast_to(-w, in_plane.shape)
        return (
            np.broadcast_to(self.eye, in_plane.shape),
            in_plane - self.focal_length * w,
        )
