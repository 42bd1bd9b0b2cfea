"""The sphere."""

from dataclasses import dataclass

import numpy as np

from shapes import vector


@dataclass(frozen=True)
class Sphere:
    """All points at distance `radius` (> 0) from `center`."""

    center: np.ndarray
    radius: float

    CHANNELS = ("center.X", "center.Y", "center.Z", "radius")

    @classmethod
    def from_values(cls, values):
        """The sphere whose channels hold these values."""
        return cls(values[:3], float(values[3]))

    def values(self):
        """The values of its channels."""
        return np.array([*self.center, self.radius])

    @property
    def point(self):
        """Its centre."""
        return self.center

    def moved(self, offset):
        """The sphere translated by `offset`."""
        return Sphere(self.center + offset, self.radius)

    def to_mitsuba(self):
        """What Mitsuba loads."""
        return {"type": "sphere", "center": self.center.tolist(), "radius": self.radius}


def read(table, _folder):
    """The sphere of a scene file's table."""
    return Sphere(vector(table["center"]), float(table["radius"]))
