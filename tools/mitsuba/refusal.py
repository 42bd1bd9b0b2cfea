"""Scenes that get no golden, because a right caster could fail it.

Two things are beyond a float32 caster and are decided in float64 here: a pixel
centre that lies on a triangle's edge (either answer is right, and correct
casters leak through), and a plane seen at so flat an angle that the ray misses
the disk that represents it (at the horizon).
"""

import numpy as np

from cast import MISS
from scene import SceneError
from shapes.plane import PLANE_RADIUS, Plane
from shapes.triangle import Triangles
from tolerance import exempt_allowed

EDGE_DISTANCE = 1e-7
"""An edge this near to a pixel's centre, in px, is a tie. Float64 casters are
wrong by about 1e-12 px, so the margin is wide and still rarely met."""

PLANE_REACH = PLANE_RADIUS / 10
"""How far from its point a plane may be seen, scene units."""

REMEDY = "shift the camera a little"


def refuse_ties(scene, centre, displaced, exempt):
    """Raise `SceneError` unless every pixel of `scene` can be judged fairly."""
    _refuse_edges(scene, centre, displaced)
    _refuse_horizon(scene, centre)
    allowed = exempt_allowed(len(exempt))
    if exempt.sum() > allowed:
        raise SceneError(
            f"{scene.path}: {exempt.sum()} pixels lie on edges, {allowed} may; {REMEDY}"
        )


def edge_distances(camera, i, j, triangle):
    """Distances in px from the centre of pixel (i, j) to `triangle`'s three edges.

    In perspective the edge p0 p1 and the eye e span a plane with the normal
    n = (p0 - e) x (p1 - e). A ray's n.d is 0 on it and changes by n.du, n.dv
    per pixel, so the edge is |n.d| / hypot(n.du, n.dv) pixels away. Orthographic
    rays share d and move their origin o: n = (p1 - p0) x d, and n.(o - p0) takes
    the place of n.d.
    """
    (origin,), (direction,) = camera.rays(np.array([i]), np.array([j]))
    du, dv = camera.pixel_steps
    distances = []
    for p0, p1 in zip(triangle, np.roll(triangle, -1, axis=0)):
        if camera.focal_length is None:
            normal = np.cross(p1 - p0, direction)
            height = normal @ (origin - p0)
        else:
            normal = np.cross(p0 - origin, p1 - origin)
            height = normal @ direction
        slope = np.hypot(normal @ du, normal @ dv)
        distances.append(abs(height) / slope if slope > 0 else np.inf)
    return distances


def _refuse_edges(scene, centre, displaced):
    seen = [centre, *displaced]
    ids = np.array([hits.id for hits in seen])
    faces = np.array([hits.face for hits in seen])
    changed = ((ids != ids[0]) | (faces != faces[0])).any(axis=0)
    columns, rows = scene.camera.pixels()
    for pixel in np.flatnonzero(changed):
        i, j = int(columns[pixel]), int(rows[pixel])
        for which, face in set(zip(ids[:, pixel].tolist(), faces[:, pixel].tolist())):
            if which == MISS or not isinstance(scene.objects[which], Triangles):
                continue
            corners = scene.objects[which].corners[face]
            if min(edge_distances(scene.camera, i, j, corners)) < EDGE_DISTANCE:
                raise SceneError(
                    f"{scene.path}: an edge of object {which} passes through the centre"
                    f" of pixel ({i}, {j}); {REMEDY}"
                )


def _refuse_horizon(scene, centre):
    """Raise `SceneError` if a ray looks along a plane, close to its horizon.

    A ray that misses the disk looks like a ray that misses the plane, so the plane's
    own t decides. Both sides of the horizon are refused, because rounding decides
    whether a ray that is exactly parallel to the plane meets it.
    """
    camera = scene.camera
    columns, rows = camera.pixels()
    origins, directions = camera.rays(columns, rows)
    nearest = np.where(centre.id == MISS, np.inf, centre.t)
    for which, thing in enumerate(scene.objects):
        if not isinstance(thing, Plane):
            continue
        with np.errstate(divide="ignore", invalid="ignore"):
            t = (thing.point - origins) @ thing.normal / (directions @ thing.normal)
            points = origins + t[:, None] * directions
            reach = np.linalg.norm(points - thing.point, axis=1)
        in_reach = reach <= PLANE_REACH  # False for a NaN
        hidden = (nearest < np.abs(t)) & (centre.id != which)
        for pixel in np.flatnonzero(~in_reach & ~hidden)[:1]:
            raise SceneError(
                f"{scene.path}: pixel ({columns[pixel]}, {rows[pixel]}) looks along the plane"
                f" that is object {which}, at its horizon; {REMEDY}"
            )
