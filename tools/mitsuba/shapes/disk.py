"""The disk."""

from dataclasses import dataclass

import mitsuba as mi
import numpy as np

from camera import normalize
from shapes import vector


@dataclass(frozen=True)
class Disk:
    """The points of a plane through `center` no farther than `radius` (> 0) from it;
    `normal` is non-zero, of any length."""

    center: np.ndarray
    normal: np.ndarray
    radius: float

    CHANNELS = (
        "center.X", "center.Y", "center.Z", "normal.X", "normal.Y", "normal.Z", "radius",
    )

    @classmethod
    def from_values(cls, values):
        """The disk whose channels hold these values."""
        return cls(values[:3], values[3:6], float(values[6]))

    def values(self):
        """The values of its channels."""
        return np.array([*self.center, *self.normal, self.radius])

    @property
    def point(self):
        """Its centre."""
        return self.center

    def moved(self, offset):
        """The disk translated by `offset`."""
        return Disk(self.center + offset, self.normal, self.radius)

    def to_mitsuba(self):
        """What Mitsuba loads: its unit disk in z = 0, scaled, turned and moved."""
        normal = normalize(self.normal)
        # The coordinate axis least along the normal is never parallel to it.
        axis = np.eye(3)[np.argmin(np.abs(normal))]
        tangent = normalize(np.cross(axis, normal))
        frame = np.eye(4)
        frame[:3] = np.column_stack([
            self.radius * tangent,
            self.radius * np.cross(normal, tangent),
            normal,
            self.center,
        ])
        return {"type": "disk", "to_world": mi.ScalarTransform4f(frame)}


def read(table, _folder):
    """The disk of a scene file's table."""
    return Disk(vector(table["center"]), vector(table["normal"]), float(table["radius"]))
