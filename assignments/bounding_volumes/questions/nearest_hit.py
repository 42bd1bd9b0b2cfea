"""Questions about the search for the nearest triangle in a tree."""

from functools import cache
from pathlib import Path

import numpy as np

from camera import normalize
from chance import as_f32, log_uniform, unit_vector
from kinds.tree_search import ask
from mesh import read_obj

MESHES = Path(__file__).parent.parent / "scenes" / "meshes"


def triangles(rng, count, spread, size):
    """Triangles of about `size` around points in a cube of side `spread`."""
    middles = rng.uniform(-spread, spread, (count, 1, 3)) / 2
    return middles + size * rng.uniform(-1, 1, (count, 3, 3))


def through(rng, corners, *, largest=2, hit=0.8, min_t=0.0):
    """A ray through the mesh from outside, aimed at a triangle with probability `hit`. One in three
    has a very short or very long direction, so that t is large or small."""
    middle, reach = corners.mean(axis=(0, 1)), np.ptp(corners.reshape(-1, 3), axis=0).max()
    origin = middle + 2 * reach * unit_vector(rng)
    if rng.uniform() < hit:
        target = rng.choice(corners).T @ rng.dirichlet((2, 2, 2))
    else:
        target = middle + reach * rng.uniform(-0.7, 0.7, 3)
    length = log_uniform(rng, 1e-9, 1e9) if rng.uniform() < 1 / 3 else rng.uniform(0.3, 2)
    direction = (target - origin) * length
    share = min_t(rng) if callable(min_t) else min_t
    t = np.linalg.norm(target - origin) / np.linalg.norm(direction)
    return ask(rng, corners, origin, direction, share * t, largest)


def one_leaf(rng):
    """A tree of one leaf with up to eight triangles."""
    corners = triangles(rng, rng.integers(1, 9), 1, 1)
    return through(rng, corners, largest=8)


def few(rng):
    """Small trees; in one of four, all triangles lie in a plane parallel to two axes, so that every
    box is flat. With fewer leaves, testing all of them would be a good search."""
    corners = triangles(rng, rng.integers(17, 33), 4, 0.8)
    if rng.uniform() < 0.25:
        corners[..., rng.integers(3)] = rng.uniform(-1, 1)
    return through(rng, corners, largest=1)


def many(rng):
    """Trees of many leaves."""
    return through(rng, triangles(rng, rng.integers(30, 65), 4, 0.5))


def overlapping(rng):
    """Boxes that overlap: the nearest triangle is often not in the box entered first."""
    return through(rng, triangles(rng, rng.integers(40, 65), 1, 0.5), largest=1)


def min_t(rng):
    """Triangles before min_t and after it. Half of the questions have many layers, of which
    some or all lie before min_t."""
    if rng.uniform() < 0.5:
        return layers(rng, min_t=rng.choice([rng.uniform(0.8, 1.3), 2]))
    corners = triangles(rng, rng.integers(12, 33), 2, 0.8)
    return through(rng, corners, min_t=lambda rng: rng.uniform(0.7, 1.2))


def missed(rng):
    """Rays that miss most triangles, and some that miss the root's box."""
    return through(rng, triangles(rng, rng.integers(5, 33), 3, 0.3), hit=0.2)


@cache
def mesh(name):
    """Corners of all triangles of a mesh."""
    return read_obj(MESHES / f"{name}.obj")


def layers(rng, min_t=0.0):
    """A ray through 60 layers, of which the middle is at t = 1."""
    corners = triangles(rng, 60, 1, 0.9) * [1, 1, 0.05] + np.arange(60)[:, None, None] * [0, 0, 0.2]
    origin = np.array([*rng.uniform(-0.3, 0.3, 2), rng.choice([-3, 15])])
    target = np.array([*rng.uniform(-0.3, 0.3, 2), 6])
    return ask(rng, rng.permutation(corners), origin, target - origin, min_t, 2)


def behind_each_other(rng):
    """Many layers behind each other: once the first is hit, the rest need no test."""
    return layers(rng)


def teapot(rng):
    """A mesh of 992 triangles."""
    return through(rng, mesh("teapot"), largest=12)


GROUPS = {
    draw.__name__: draw
    for draw in (one_leaf, few, many, overlapping, min_t, missed, behind_each_other, teapot)
}
