"""Questions about one triangle.

A ray is aimed at a point of the triangle's plane given by its barycentric
coordinates: all positive is inside; one or two negative are the six regions
around it.
"""

import numpy as np

from camera import normalize
from chance import log_uniform, perpendicular, sign, tilted_from, unit_vector
from kinds.intersect import ask
from questions.lengths import ordinary_or_long, usually_ahead, usually_below
from shapes.triangle import Triangles


def corners(rng, size, aspect, normal=None):
    """Three corners around the origin: a side of about `size`, and an altitude on it
    of `size / aspect`, in any order and direction, but at right angles to `normal`."""
    along = unit_vector(rng) if normal is None else perpendicular(rng, normal)
    up = perpendicular(rng, along) if normal is None else np.cross(normal, along)
    foot = rng.uniform(0.1, 0.9)
    triangle = size * np.array([0 * along, along, foot * along + up / aspect])
    return rng.permutation(triangle - triangle.mean(axis=0))


def within(rng):
    """Barycentric coordinates at least 0.02 inside every edge."""
    return 0.02 + 0.94 * rng.dirichlet((1, 1, 1))


def around(rng):
    """Barycentric coordinates of one of the six outer regions, near or far."""
    reach = log_uniform(rng, 0.02, 2)
    share = rng.uniform(0.1, 0.9)
    if rng.uniform() < 0.5:
        outer = np.array([-reach, share * (1 + reach), (1 - share) * (1 + reach)])
    else:
        outer = np.array([-share * reach, -(1 - share) * reach, 1 + reach])
    return rng.permutation(outer)


def place(
    rng, *, at=None, side=None, ahead=True, size=None, aspect=None,
    center=None, away=None, length=None, min_t=None, cosines=(0.2, 1), axis=None,
):
    """A question; arguments that are not given are drawn.

    `at` are barycentric coordinates, `side` is 1 for an origin on the side of the
    normal (b - a) x (c - a), `away` the origin's distance in sizes, `min_t` a share
    of the plane's t, `cosines` the range of the angle's between ray and normal, `axis` a
    coordinate axis at right angles to the triangle.
    """
    at = (within(rng) if rng.uniform() < 0.6 else around(rng)) if at is None else at
    side = sign(rng) if side is None else side
    size = rng.uniform(0.5, 3) if size is None else size
    aspect = rng.uniform(0.8, 3) if aspect is None else aspect
    center = rng.uniform(-3, 3, 3) if center is None else center
    away = rng.uniform(1, 6) if away is None else away
    length = rng.uniform(0.3, 3) if length is None else length
    share = rng.uniform(0, 0.5) if min_t is None else min_t
    triangle = center + corners(rng, size, aspect, axis)
    a, b, c = triangle
    back_along = side * tilted_from(rng, normalize(np.cross(b - a, c - a)), *cosines)
    distance = away * size
    direction = -back_along * length if ahead else back_along * length
    return ask(
        Triangles(triangle[None]),
        at @ triangle + distance * back_along,
        direction,
        share * distance / length,
    )


def plain(rng):
    """A triangle in one of the planes x = 0, y = 0 and z = 0, with numbers that need no
    rounding: the determinant of its 3 x 3 system is exactly 1."""
    over, height = np.array([*rng.integers(1, 4, 2) / 8, 0]), float(rng.integers(1, 5))
    origin = over + np.array([0, 0, height])
    triangle = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0]])
    turn = rng.integers(3)
    origin, direction, triangle = (
        np.roll(vectors, turn, axis=-1) for vectors in (origin, np.array([0, 0, -1]), triangle)
    )
    return ask(Triangles(triangle[None]), origin, direction, 0)


def front(rng):
    """The normal points to the ray's side; one question in twenty is `plain`."""
    return plain(rng) if rng.uniform() < 0.05 else place(rng, side=1)


def back(rng):
    """Seen from behind: it is hit too, and its normal stays as it is. One triangle in ten
    is seen nearly edge-on, and hit well inside: no bound on the angle tells hits from misses."""
    if rng.uniform() < 0.1:
        cosine = log_uniform(rng, 3e-4, 3e-2)
        at = 0.2 + 0.4 * rng.dirichlet((1, 1, 1))
        return place(rng, side=-1, at=at, aspect=1, cosines=(cosine, cosine))
    return place(rng, side=-1)


def outside(rng):
    """All six outer regions, near and far; two questions in five hit. One triangle in eight is
    parallel to a coordinate plane."""
    axis = np.eye(3)[rng.integers(3)] if rng.uniform() < 1 / 8 else None
    return place(rng, at=within(rng) if rng.uniform() < 0.4 else around(rng), axis=axis)


def edges(rng):
    """Within 1e-4 to 1e-2 (barycentric) of an edge, 60 % on its inner side."""
    gap = log_uniform(rng, 1e-4, 1e-2) * (1 if rng.uniform() < 0.6 else -1)
    share = rng.uniform(0.1, 0.9)
    return place(rng, at=rng.permutation([gap, share * (1 - gap), (1 - share) * (1 - gap)]))


def behind(rng):
    """Mostly triangles behind the origin, which are missed."""
    return place(rng, at=within(rng), ahead=rng.uniform() < 0.4)


def min_t(rng):
    """min_t below and above the triangle's t. If d is long, t is so small that no margin can be
    added to min_t."""
    share = rng.uniform(0.1, 0.9) if rng.uniform() < 0.6 else rng.uniform(1.1, 3)
    return place(rng, at=within(rng), length=ordinary_or_long(rng), min_t=share)


def direction_length(rng):
    """|d| from 1e-3 to 1e3, because t counts in units of |d|. A few triangles lie behind the
    origin or before min_t."""
    length = log_uniform(rng, 1e-3, 1e3)
    return place(rng, ahead=usually_ahead(rng), length=length, min_t=usually_below(rng))


def scale(rng):
    """Tiny and huge triangles near the origin of space; half the directions are as
    long as the triangle is wide, half have the length of ordinary scenes. A few triangles lie
    behind the origin or before min_t."""
    size = log_uniform(rng, 1e-6, 1e-2) if rng.uniform() < 0.6 else log_uniform(rng, 1e2, 1e4)
    unit = rng.choice((1.0, size))
    return place(
        rng,
        ahead=usually_ahead(rng),
        size=size,
        center=size * rng.uniform(-3, 3, 3),
        away=log_uniform(rng, 1, 50),
        length=unit * rng.uniform(0.3, 3),
        min_t=usually_below(rng),
    )


def offset(rng):
    """Ray and triangle 10 to 100 from the origin of space along every axis."""
    return place(rng, center=rng.uniform(10, 100, 3) * rng.choice((-1, 1), 3))


def sliver(rng):
    """Triangles 10 to 50 times as long as they are high."""
    return place(rng, aspect=log_uniform(rng, 10, 50))


GROUPS = {
    draw.__name__: draw
    for draw in (
        front, back, outside, edges, behind, min_t, direction_length, scale, offset, sliver,
    )
}
