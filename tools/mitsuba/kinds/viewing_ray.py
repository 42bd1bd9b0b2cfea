"""Questions of the kind `viewing_ray`: the ray through one pixel of one camera."""

from dataclasses import dataclass

import numpy as np

import film
from camera import Camera
from sensor import golden_rays
from tolerance import ray_tolerance

FRESH = 2048
"""How many fresh questions a group has."""


@dataclass(frozen=True)
class Question:
    """Pixel (i, j) of a camera; float32 values."""

    camera: Camera
    i: int
    j: int

    answer_channels = film.RAY_CHANNELS
    channels = (
        *(f"{vector}.{axis}" for vector in ("eye", "view", "up") for axis in "XYZ"),
        "width", "height", "focal_length", "n_x", "n_y", "i", "j",
    )

    def values(self):
        """The pixel of the question's film; a focal length of 0 is orthographic."""
        camera = self.camera
        return np.array([
            *camera.eye, *camera.view, *camera.up, camera.width, camera.height,
            camera.focal_length or 0.0, *camera.resolution, self.i, self.j,
        ])

    def answer(self):
        """Golden and tolerance, (6,) each."""
        rays = golden_rays(self.camera, [self.i], [self.j])
        return np.hstack(rays)[0], ray_tolerance(self.camera, *rays)[0]
