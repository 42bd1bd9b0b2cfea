"""Questions of the kind `intersect`: does this ray hit this shape, and where?

A question is rounded to float32 before anything is computed from it, because
its film is float32. Mitsuba computes in float32 too, which would spoil shapes
that are small or far from the origin of space. Where things are is only a
matter of coordinates, so we move the origin of space to the shape's own point
(a float64 subtraction) and let Mitsuba answer there.
"""

from dataclasses import dataclass

import numpy as np

import film
from camera import normalize
from cast import cast
from chance import as_f32
from face_rounding import normal_rounding
from shapes import to_mitsuba
from tolerance import F32_RELATIVE, RING, hit_tolerance

TILT = 1e-6
"""How far the displaced rays are tilted, rad, and how far min_t is moved, as a
share of itself."""

BLURRED = 2.0**-6
"""A question is redrawn when its tolerance exceeds this share of t, or this much
of a normal: the answer jumps (a root falls on min_t) or says too little."""

FRESH = 2048
"""How many fresh questions a group has."""


@dataclass(frozen=True)
class Question:
    """A ray o + t d, t >= min_t, and the one shape it may meet; float32 values."""

    shape: object  # with the members that `shapes/__init__.py` names
    origin: np.ndarray
    direction: np.ndarray  # any length
    min_t: float  # in units of |d|

    answer_channels = film.HIT_CHANNELS

    @property
    def channels(self):
        """The names of its values."""
        return (*film.RAY_CHANNELS, "min_t", *self.shape.CHANNELS)

    def values(self):
        """The pixel of the question's film."""
        return np.array([*self.origin, *self.direction, self.min_t, *self.shape.values()])

    def answer(self):
        """Golden and tolerance, (5,) each, or None for a question to be redrawn.

        Ten rays are displaced: eight are tilted by `TILT` about their origin, with t
        in units of the untilted |d|, and two have min_t moved. The absolute part of
        t's tolerance is not the 1e-6 of scenes, which would swallow all of t for a
        ray of great |d|, but what the rounding of a start at that distance from the
        shape costs: 2e-6 of the distance, in units of |d|.
        """
        origin, direction = self.origin - self.shape.point, self.direction
        across = np.cross(direction, np.eye(3)[np.argmin(np.abs(direction))])
        upwards = np.cross(across, direction)
        length = np.linalg.norm(direction)
        tilts = RING @ np.array([normalize(across), normalize(upwards)]) * TILT * length
        directions = direction + np.vstack([np.zeros(3), tilts, np.zeros((2, 3))])
        min_t = self.min_t * np.array([1.0] * 9 + [1 - TILT, 1 + TILT])
        origins = np.broadcast_to(origin, directions.shape)
        shape = self.shape.moved(-self.shape.point)
        hits = cast(to_mitsuba([shape]), origins, directions, min_t)
        centre, *displaced = hits.split()
        start = np.linalg.norm(origin + self.min_t * direction)
        tolerance, exempt = hit_tolerance(
            centre, displaced, normal_rounding([shape], centre), F32_RELATIVE * start / length
        )
        golden = centre.channels()
        if exempt[0]:
            return None
        blurred = tolerance[0, 1] > BLURRED * golden[0, 1] or tolerance[0, 2:].max() > BLURRED
        if centre.id[0] == 0 and blurred:
            return None
        return golden[0], tolerance[0]


def ask(shape, origin, direction, min_t):
    """The question nearest to these values that a float32 film can hold."""
    shape = shape.from_values(as_f32(shape.values()))
    return Question(shape, as_f32(origin), as_f32(direction), float(as_f32(min_t)))
