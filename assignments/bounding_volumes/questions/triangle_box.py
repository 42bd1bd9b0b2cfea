"""Questions about the smallest box around a triangle, or around two boxes."""

import numpy as np

from chance import log_uniform, unit_vector
from kinds.bounds import of_boxes, of_triangle


def corners(rng, size):
    """Three corners anywhere within `size` of a point up to 3 from the origin."""
    return rng.uniform(-3, 3, 3) + size * rng.uniform(-1, 1, (3, 3))


def triangle(rng):
    """Any triangle."""
    return of_triangle(corners(rng, rng.uniform(0.3, 3)))


def flat(rng):
    """A triangle in a plane parallel to two axes."""
    shape = corners(rng, 2)
    shape[:, rng.integers(3)] = rng.uniform(-3, 3)
    return of_triangle(shape)


def far(rng):
    """All coordinates of one sign, and far from the origin."""
    away = np.abs(unit_vector(rng)) * log_uniform(rng, 10, 1e4) + 5
    return of_triangle(rng.choice([-1, 1]) * (away + rng.uniform(-1, 1, (3, 3))))


def box(rng):
    """Min and max of a box."""
    return np.sort(rng.uniform(-3, 3, (2, 3)), axis=0)


def join(rng):
    """Two boxes, which may overlap; one in three pairs is far from the origin."""
    away = log_uniform(rng, 10, 1e4) * unit_vector(rng) * (rng.uniform() < 1 / 3)
    return of_boxes(box(rng) + away, box(rng) + away)


def inside(rng):
    """Two boxes, one within the other."""
    outer = box(rng)
    shares = np.sort(rng.uniform(0.1, 0.9, (2, 3)), axis=0)
    inner = outer[0] + shares * (outer[1] - outer[0])
    return of_boxes(*((outer, inner) if rng.uniform() < 0.5 else (inner, outer)))


GROUPS = {draw.__name__: draw for draw in (triangle, flat, far, join, inside)}
