"""Questions of the kind `ray_box`: where does a ray enter a solid box, from min_t to max_t?

Mitsuba's cube answers, or its rectangle where the box is flat. They are surfaces: a ray
that starts inside meets the far side first, from within. Such a ray is in the box at
min_t already. As in `intersect.py`, the origin of space is moved to the box first, and
the box is scaled to a unit cube, so that Mitsuba's float32 spoils nothing.
"""

from dataclasses import dataclass

import mitsuba as mi
import numpy as np

import film
from camera import normalize
from cast import MISS, cast
from chance import as_f32
from kinds.bounds import BOX_CHANNELS
from tolerance import F32_RELATIVE, RING, hit_tolerance

TILT = 1e-6
"""How far the displaced rays are tilted, rad, and how far min_t and max_t are moved, as a
share of themselves."""

ENDLESS = 1e30
"""A max_t of this much means that there is none."""

FRESH = 2048
"""How many fresh questions a group has."""


@dataclass(frozen=True)
class Question:
    """A ray o + t d, min_t <= t <= max_t, and a box; float32 values."""

    box: np.ndarray  # (2, 3): min and max
    origin: np.ndarray
    direction: np.ndarray  # any length
    min_t: float  # in units of |d|
    max_t: float  # in the same units, or ENDLESS

    answer_channels = film.HIT_CHANNELS
    channels = (
        *film.RAY_CHANNELS,
        "min_t",
        "max_t",
        *(f"0.{channel}" for channel in BOX_CHANNELS),
    )

    def values(self):
        """The pixel of the question's film."""
        return np.array(
            [*self.origin, *self.direction, self.min_t, self.max_t, *self.box.ravel()]
        )

    def answer(self):
        """Golden and tolerance, (5,) each, or None for a question to be redrawn.

        Twelve rays are displaced: eight are tilted by `TILT` about their origin, and four
        have min_t or max_t moved. A component of the direction that is 0 stays 0, since a
        tilt would turn a ray that runs beside a flat box into one that crosses it.
        """
        box = self.thickened()
        size = box[1] - box[0]
        scale = size.max()
        origin = (self.origin - box[0]) / scale
        direction = self.direction / scale
        length = np.linalg.norm(direction)
        across = np.cross(direction, np.eye(3)[np.argmin(np.abs(direction))])
        upwards = np.cross(across, direction)
        tilts = RING @ np.array([normalize(across), normalize(upwards)]) * TILT * length
        tilts = np.where(direction == 0, 0.0, tilts)
        directions = direction + np.vstack([np.zeros(3), tilts, np.zeros((4, 3))])
        low, high = 1 - TILT, 1 + TILT
        min_t = self.min_t * np.array([1.0] * 9 + [low, high, 1, 1])
        max_t = self.max_t * np.array([1.0] * 11 + [low, high])
        origins = np.broadcast_to(origin, directions.shape)
        hits = cast(solid(size / scale), origins, directions, min_t)
        met = hits.id != MISS
        leaves = met & (np.einsum("nd,nd->n", hits.normal, directions) > 0) & (size.min() > 0)
        hits.t[leaves] = min_t[leaves]
        hits.normal[:] = 0
        beyond = met & (hits.t > max_t)
        hits.id[beyond], hits.t[beyond] = MISS, 0.0
        centre, *displaced = hits.split()
        start = np.linalg.norm(origin + self.min_t * direction)
        tolerance, exempt = hit_tolerance(
            centre, displaced, 0.0, F32_RELATIVE * start / length
        )
        if exempt[0]:
            return None
        return centre.channels()[0], tolerance[0]


    def thickened(self):
        """The box, thickened along each axis that has a face in which the ray runs.

        The faces belong to the box, and a ray that does not move along an axis enters and
        leaves a thicker box at the same t.
        """
        in_face = (self.direction == 0) & (self.box == self.origin).any(axis=0)
        thickness = np.where(in_face, (self.box[1] - self.box[0]).max() / 8, 0)
        return self.box + np.array([-thickness, thickness])


def solid(size):
    """Mitsuba's scene of a box from 0 to `size`, flat in one axis at most."""
    transform = mi.ScalarTransform4f
    flat = [axis for axis in range(3) if size[axis] == 0]
    half = transform().translate(size / 2).scale(np.where(size == 0, 1, size) / 2)
    if flat:
        turn = {0: ([0, 1, 0], 90), 1: ([1, 0, 0], 90), 2: ([0, 0, 1], 0)}[flat[0]]
        half = half.rotate(*turn)
    kind = "rectangle" if flat else "cube"
    return mi.load_dict({"type": "scene", "0": {"type": kind, "id": "0", "to_world": half}})


def ask(box, origin, direction, min_t, max_t=ENDLESS):
    """The question nearest to these values that a float32 film can hold."""
    return Question(
        as_f32(box),
        as_f32(origin),
        as_f32(direction),
        float(as_f32(min_t)),
        float(as_f32(max_t)),
    )
