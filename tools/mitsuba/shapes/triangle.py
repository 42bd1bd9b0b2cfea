"""Triangles: a lone one, or the faces of one object."""

from dataclasses import dataclass

import mitsuba as mi
import numpy as np

from shapes import vector


@dataclass(frozen=True)
class Triangles:
    """One or more triangles seen as one object, shape (faces, 3 corners, 3).

    The outward normal of a face (a, b, c) is (b - a) x (c - a), normalised.
    A lone triangle and a soup differ only in their number of faces; questions are
    asked about a lone one.
    """

    corners: np.ndarray

    CHANNELS = tuple(f"{corner}.{axis}" for corner in "abc" for axis in "XYZ")

    @classmethod
    def from_values(cls, values):
        """The lone triangle whose channels hold these values."""
        return cls(values.reshape(1, 3, 3))

    def values(self):
        """The values of its channels."""
        return self.corners.ravel()

    @property
    def point(self):
        """The first corner."""
        return self.corners[0, 0]

    def moved(self, offset):
        """The triangles translated by `offset`."""
        return Triangles(self.corners + offset)

    def to_mitsuba(self):
        """What Mitsuba loads: a mesh whose faces share no vertex."""
        faces = len(self.corners)
        mesh = mi.Mesh("soup", vertex_count=3 * faces, face_count=faces)
        parameters = mi.traverse(mesh)
        parameters["vertex_positions"] = self.corners.astype(np.float32).ravel()
        parameters["faces"] = np.arange(3 * faces, dtype=np.uint32)
        parameters.update()
        return mesh


def read(table, _folder):
    """The lone triangle of a scene file's table."""
    return Triangles(np.array([[vector(corner) for corner in table["corners"]]]))
