"""Our objects as a Mitsuba scene.

Mitsuba computes in float32 ("scalar_rgb" is the wheel's only variant whose
sphere solves its quadratic in float64; there is none in double precision), so
the data are rounded once here and never again.
"""

import mitsuba as mi
import numpy as np

from camera import normalize
from scene import Plane, Sphere

mi.set_variant("scalar_rgb")
mi.set_log_level(mi.LogLevel.Error)  # stdout belongs to golden.py

PLANE_RADIUS = 1e6
"""Radius of the disk that stands for a plane, scene units. Measured: relative
error of t at most 3e-7 (99th percentile); a rectangle of that size loses 3e-2."""


def to_mitsuba(objects):
    """A Mitsuba scene in which the shape of `objects[k]` has the id `str(k)`."""
    shapes = {str(k): _shape(thing) for k, thing in enumerate(objects)}
    return mi.load_dict({"type": "scene", **shapes})


def _shape(thing):
    if isinstance(thing, Sphere):
        return {"type": "sphere", "center": thing.center.tolist(), "radius": thing.radius}
    if isinstance(thing, Plane):
        return {"type": "disk", "to_world": mi.ScalarTransform4f(_disk_frame(thing))}
    faces = len(thing.corners)
    mesh = mi.Mesh("soup", vertex_count=3 * faces, face_count=faces)
    parameters = mi.traverse(mesh)
    parameters["vertex_positions"] = thing.corners.astype(np.float32).ravel()
    parameters["faces"] = np.arange(3 * faces, dtype=np.uint32)
    parameters.update()
    return mesh


def _disk_frame(plane):
    """The matrix that takes Mitsuba's unit disk in z = 0 onto `plane`."""
    normal = normalize(plane.normal)
    # The coordinate axis least along the normal is never parallel to it.
    axis = np.eye(3)[np.argmin(np.abs(normal))]
    tangent = normalize(np.cross(axis, normal))
    frame = np.eye(4)
    frame[:3] = np.column_stack([
        PLANE_RADIUS * tangent,
        PLANE_RADIUS * np.cross(normal, tangent),
        normal,
        plane.point,
    ])
    return frame
