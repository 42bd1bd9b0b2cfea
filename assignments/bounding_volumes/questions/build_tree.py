"""Questions about the tree over a list of triangles, given by their boxes."""

import numpy as np

from chance import log_uniform, unit_vector
from kinds.tree import SLOTS, ask


def around(rng, centres, size):
    """Boxes with these centres and sides up to `size`."""
    half = size * rng.uniform(0.05, 0.5, centres.shape)
    return np.stack([centres - half, centres + half], axis=1)


def few(rng):
    """One triangle, or up to twelve."""
    return ask(around(rng, rng.uniform(-3, 3, (rng.integers(1, 13), 3)), 1))


def spread(rng):
    """Many triangles, spread evenly; half of the questions are far from the origin."""
    away = log_uniform(rng, 10, 1e3) * unit_vector(rng) * (rng.uniform() < 0.5)
    return ask(around(rng, away + rng.uniform(-3, 3, (rng.integers(16, SLOTS + 1), 3)), 1))


def long(rng):
    """Many triangles along one axis, all together much longer than wide.

    In half of the questions, the centres lie at multiples of 4 along that axis. Most lists
    to split then have centres exactly in the middle, which must not be lost.
    """
    reach = rng.permutation([30, 1, 1])
    count = rng.integers(16, SLOTS + 1)
    centres = rng.uniform(-1, 1, (count, 3)) * reach
    if rng.uniform() < 0.5:
        return ask(around(rng, centres, 0.5))
    axis = np.argmax(reach)
    centres[:, axis] = 4 * np.round(centres[:, axis] / 4)
    half = rng.uniform(0.02, 0.25, (count, 3))
    # Min and max are stored as float32. Their mean is exact with these sides.
    half[:, axis] = rng.integers(1, 9, count) / 32
    return ask(np.stack([centres - half, centres + half], axis=1))


def flat(rng):
    """Triangles in a plane parallel to two axes: their boxes have no thickness."""
    boxes = around(rng, rng.uniform(-3, 3, (rng.integers(16, SLOTS + 1), 3)), 1)
    boxes[:, :, rng.integers(3)] = rng.uniform(-3, 3)
    return ask(boxes)


def same_centre(rng):
    """Boxes that all have the same centre, so that no plane separates the centres."""
    count = rng.integers(9, SLOTS + 1)
    centres = np.broadcast_to(rng.integers(-3, 4, 3) / 1.0, (count, 3))
    half = rng.integers(1, 64, (count, 3)) / 32
    return ask(np.stack([centres - half, centres + half], axis=1))


def one_huge(rng):
    """One triangle that is far larger than all others."""
    count = rng.integers(16, SLOTS + 1)
    boxes = around(rng, rng.uniform(-3, 3, (count, 3)), 0.5)
    boxes[rng.integers(count)] = rng.uniform(-1, 1, 3) + np.array([[-4] * 3, [4] * 3])
    return ask(boxes)


def crowded(rng):
    """Triangles that crowd towards one end: each is half as far from it as the next."""
    count = rng.integers(12, 25)
    places = 8 * 0.5 ** np.arange(count)
    along = rng.permutation(np.eye(3))[0]
    centres = places[:, None] * along + 0.01 * rng.uniform(-1, 1, (count, 3))
    return ask(around(rng, rng.permutation(centres), 0.02))


GROUPS = {
    draw.__name__: draw for draw in (few, spread, long, flat, same_centre, one_huge, crowded)
}
