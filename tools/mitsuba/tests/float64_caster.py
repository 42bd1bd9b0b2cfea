"""TESTS ONLY: a second ray caster, in float64 and from the textbook.

It shares no formula with the generator: its camera multiplies pixel centres
through a matrix, its triangle is a 3 x 3 solve. It plays a right submission.
"""

import numpy as np

from shapes.plane import Plane
from shapes.sphere import Sphere


def camera_rays(eye, view, up, width, height, focal_length, n_x, n_y, i, j):
    """Origin and direction (3,) of one pixel; focal length 0 is orthographic."""
    back = -np.asarray(view) / np.sqrt(np.dot(view, view))
    right = np.cross(up, back)
    right /= np.sqrt(np.dot(right, right))
    frame = np.column_stack([right, np.cross(back, right), back])
    x = width * ((i + 0.5) / n_x - 0.5)
    y = height * ((j + 0.5) / n_y - 0.5)
    if focal_length:
        return np.array(eye), frame @ [x, y, -focal_length]
    return eye + frame @ [x, y, 0.0], -back


def scene_rays(camera, shift=0.0):
    """Origins and directions of all pixels, moved right by `shift` px."""
    i, j = camera.pixels()
    rays = [
        camera_rays(
            camera.eye, camera.view, camera.up, camera.width, camera.height,
            camera.focal_length or 0.0, *camera.resolution, column + shift, row,
        )
        for column, row in zip(i, j)
    ]
    return tuple(np.array(part) for part in zip(*rays))


def sphere(origins, directions, min_t, center, radius):
    """t (inf at a miss) and outward normals, by the quadratic formula."""
    e = origins - center
    a = (directions**2).sum(1)
    b = 2 * (directions * e).sum(1)
    c = (e**2).sum(1) - radius**2
    disc = b * b - 4 * a * c
    root = np.sqrt(np.maximum(disc, 0))
    near, far = (-b - root) / (2 * a), (-b + root) / (2 * a)
    t = np.where(near >= min_t, near, np.where(far >= min_t, far, np.inf))
    t = np.where(disc >= 0, t, np.inf)
    reached = np.where(np.isfinite(t), t, 0)[:, None]
    return t, (e + reached * directions) / radius


def plane(origins, directions, min_t, point, normal):
    """t (inf at a miss) and the plane's own normal."""
    n = normal / np.linalg.norm(normal)
    with np.errstate(divide="ignore", invalid="ignore"):
        t = ((point - origins) @ n) / (directions @ n)
    t = np.where(np.isfinite(t) & (t >= min_t), t, np.inf)
    return t, np.broadcast_to(n, origins.shape)


def triangle(origins, directions, min_t, a, b, c):
    """t (inf at a miss) and (b - a) x (c - a) at unit length, by a linear solve."""
    t1, t2 = b - a, c - a
    scale = np.linalg.norm(directions, axis=1)
    columns = [np.broadcast_to(t1, origins.shape), np.broadcast_to(t2, origins.shape)]
    matrix = np.stack([*columns, -directions], axis=2)
    flat = np.abs(np.linalg.det(matrix)) < 1e-14 * np.linalg.norm(np.cross(t1, t2)) * scale
    matrix[flat] = np.eye(3)
    alpha, beta, t = np.linalg.solve(matrix, (origins - a)[:, :, None])[:, :, 0].T
    hit = ~flat & (alpha >= 0) & (beta >= 0) & (alpha + beta <= 1) & (t >= min_t)
    n = np.cross(t1, t2)
    return np.where(hit, t, np.inf), np.broadcast_to(n / np.linalg.norm(n), origins.shape)


def cast(objects, origins, directions, min_t):
    """The film (N, 5) of these rays: id, t, normal of the nearest object."""
    film = np.zeros((len(origins), 5))
    film[:, 0] = -1
    nearest = np.full(len(origins), np.inf)
    for k, thing in enumerate(objects):
        if isinstance(thing, Sphere):
            found = [sphere(origins, directions, min_t, thing.center, thing.radius)]
        elif isinstance(thing, Plane):
            found = [plane(origins, directions, min_t, thing.point, thing.normal)]
        else:
            found = [triangle(origins, directions, min_t, *face) for face in thing.corners]
        for t, normal in found:
            closer = t < nearest
            nearest[closer] = t[closer]
            film[closer] = np.column_stack([np.full(len(t), k), t, normal])[closer]
    return film
