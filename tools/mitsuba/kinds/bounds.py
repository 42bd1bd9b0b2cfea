"""Questions of the kind `bounds`: which is the smallest box around a triangle, or around
two boxes?

The answer is the smallest and the greatest of each coordinate, which is exact. It is
Mitsuba's own bounding box of a mesh, of the triangle or of the boxes' corners.
"""

from dataclasses import dataclass

import mitsuba as mi
import numpy as np

from chance import as_f32
from shapes.triangle import Triangles

FRESH = 2048
"""How many fresh questions a group has."""

AXES = "XYZ"
BOX_CHANNELS = tuple(f"{corner}.{axis}" for corner in ("min", "max") for axis in AXES)


def bounding_box(corners):
    """Mitsuba's box around triangles, shape (faces, 3 corners, 3): min and max, (6,)."""
    box = Triangles(corners).to_mitsuba().bbox()
    return np.array([*box.min, *box.max])


@dataclass(frozen=True)
class Question:
    """A triangle, shape (3, 3), or two boxes, shape (2, 2, 3); float32 values."""

    triangle: np.ndarray | None
    boxes: np.ndarray | None

    answer_channels = BOX_CHANNELS
    channels = (
        "boxes",
        *Triangles.CHANNELS,
        *(f"{box}.{channel}" for box in (0, 1) for channel in BOX_CHANNELS),
    )

    def values(self):
        """The pixel of the question's film."""
        if self.boxes is None:
            return np.array([0, *self.triangle.ravel(), *np.zeros(12)])
        return np.array([2, *np.zeros(9), *self.boxes.ravel()])

    def answer(self):
        """Golden and tolerance, (6,) each."""
        if self.boxes is None:
            corners = self.triangle[None]
        else:
            corners = self.boxes.reshape(4, 3)[[[0, 1, 2], [1, 2, 3]]]
        return bounding_box(corners), np.zeros(6)


def of_triangle(corners):
    """The question about the triangle nearest to this one that a film can hold."""
    return Question(as_f32(corners), None)


def of_boxes(first, second):
    """The question about two boxes, each (2, 3): min and max."""
    return Question(None, as_f32([first, second]))
