"""Questions of the kind `tree`: which binary tree holds triangles with these boxes?

Many trees are right, so the harness measures the submission's: triangles that are not in
exactly one leaf, depth, the largest leaf, and the expected number of tests by the surface
area heuristic. The golden is 0 everywhere; the tolerance is how much of each is allowed.
Depth and tests are compared with trees that are split at the middle of the longest axis or whose
lists are halved along it.
"""

from dataclasses import dataclass

import numpy as np

from chance import as_f32
from kinds.bounds import BOX_CHANNELS

SLOTS = 48
"""How many boxes a question has room for."""

LARGEST_LEAF = 8
"""How many triangles a leaf may have."""

COST = 1.5
"""The expected tests that are allowed, as a multiple of those of our costliest tree. Measured on 150
questions of each group: 80 kinds of good trees (split in the middle, in halves, or by the surface area
heuristic, with leaves of 1 to 8) need at most 1.37 times those of our costliest tree, and triangles
that are halved in the order of the list up to 4.6 times."""

SHOWN_LEAF = 4
"""The most triangles in a leaf of the right tree that is shown beside a wrong one."""

ANY_COST = 1e6
"""More expected tests than any tree over so few triangles needs."""

FRESH = 512
"""How many fresh questions a group has."""


@dataclass(frozen=True)
class Question:
    """Boxes, shape (n, 2, 3): min and max of each; float32 values."""

    boxes: np.ndarray

    answer_channels = ("misplaced", "depth", "leaf", "cost")
    channels = (
        "count",
        *(f"{k}.{channel}" for k in range(SLOTS) for channel in BOX_CHANNELS),
        *(f"{k}.{channel}" for k in range(SLOTS) for channel in ("leaf", "depth")),
    )

    def values(self):
        """The pixel of the question's film: the boxes, and a right tree for pictures. For each
        triangle, it says which leaf it is in, and how deep that leaf is. The depths of
        all leaves, from the first to the last, determine the tree."""
        values = np.zeros(len(self.channels))
        values[0] = len(self.boxes)
        values[1 : 1 + self.boxes.size] = self.boxes.ravel()
        tree = split(self.boxes, SHOWN_LEAF, below_middle)
        for k, (members, deep) in enumerate(leaves(tree)):
            for member in members:
                values[1 + 6 * SLOTS + 2 * member :][:2] = k, deep
        return values

    def answer(self):
        """Golden and tolerance, (4,) each.

        Twice the depth of the deepest of our trees is allowed, and two more, because trees may be
        split in other ways, such as by the surface area heuristic.
        """
        trees = [
            split(self.boxes, largest, is_first)
            for is_first in (below_middle, in_first_half)
            for largest in (1, 4, LARGEST_LEAF)
        ]
        deepest = max(depth(tree) for tree in trees)
        costliest = max(cost(tree, self.boxes) for tree in trees)
        most_deep, most = 2 * deepest + 2, COST * costliest
        # Boxes with one centre can be divided in any way, so their order says nothing. If they
        # are nested, the surface area heuristic takes them off one by one.
        if np.ptp(self.boxes.mean(axis=1), axis=0).max() == 0:
            most_deep = max(most_deep, 2 + depth(split_by_area(self.boxes)))
            most = ANY_COST
        return np.zeros(4), np.array([0, most_deep, LARGEST_LEAF, most])


def ask(boxes):
    """The question about boxes nearest to these that a film can hold."""
    return Question(as_f32(boxes))


def split(boxes, largest, is_first, members=None):
    """A tree over boxes: an array of members, or a pair of trees.

    `is_first` says which go into the first child, given their centres along the longest
    axis. The list is halved where one child would be empty.
    """
    members = np.arange(len(boxes)) if members is None else members
    if len(members) <= largest:
        return members
    centres = boxes[members].mean(axis=1)
    axis = np.argmax(np.ptp(centres, axis=0))
    first = is_first(centres[:, axis])
    if first.all() or not first.any():
        first = np.arange(len(members)) < len(members) // 2
    return tuple(split(boxes, largest, is_first, members[side]) for side in (first, ~first))


def split_by_area(boxes):
    """A tree over boxes with one centre, each in a leaf of its own, split where the surface area
    heuristic expects the fewest tests."""
    if len(boxes) == 1:
        return np.arange(1)
    first, rest = areas_of_first(boxes), areas_of_first(boxes[::-1])[::-1]
    count = np.arange(1, len(boxes))
    here = count[np.argmin(first[:-1] * count + rest[1:] * count[::-1])]
    return split_by_area(boxes[:here]), split_by_area(boxes[here:])


def areas_of_first(boxes):
    """Half of the surface of the box around the first, the first two, and so on."""
    low = np.minimum.accumulate(boxes[:, 0])
    high = np.maximum.accumulate(boxes[:, 1])
    return half_area(np.stack([low, high]))


def below_middle(places):
    """Whether each place lies below the middle of them all."""
    return places < (places.min() + places.max()) / 2


def in_first_half(places):
    """Whether each place is among the smaller half of them."""
    return np.argsort(np.argsort(places, kind="stable")) < len(places) // 2


def depth(tree):
    """How many branches are on the way to the deepest leaf."""
    return 1 + max(map(depth, tree)) if isinstance(tree, tuple) else 0


def leaves(tree, deep=0):
    """The members and the depth of each leaf, from the first to the last."""
    if isinstance(tree, tuple):
        return [leaf for child in tree for leaf in leaves(child, deep + 1)]
    return [(tree, deep)]


def members_of(tree):
    """The places of all its boxes."""
    return np.concatenate([*map(members_of, tree)]) if isinstance(tree, tuple) else tree


def box_of(tree, boxes):
    """The smallest box around all its boxes, (2, 3)."""
    chosen = boxes[members_of(tree)]
    return np.array([chosen[:, 0].min(axis=0), chosen[:, 1].max(axis=0)])


def half_area(box):
    """Half of the surface of a box."""
    x, y, z = np.moveaxis(box[1] - box[0], -1, 0)
    return x * y + y * z + z * x


def cost(tree, boxes):
    """The expected number of tests for a ray that meets the root's box, as the harness
    computes it."""

    def tests(tree):
        area = half_area(box_of(tree, boxes))
        if isinstance(tree, tuple):
            return 2 * area + sum(map(tests, tree))
        return area * len(tree)

    whole = half_area(box_of(tree, boxes))
    return tests(tree) / whole if whole > 0 else 0.0
