"""Questions of the kind `tree_search`: which triangle of a tree does the ray hit first, and
how many tests does it take to find out?

The tree is ours, and the question says what each test of a box or a triangle would
answer, so that a wrong box or tree cannot spoil a right search. Where the ray meets the
triangles, and which is first, is Mitsuba's cast.
"""

from dataclasses import dataclass

import numpy as np

import film
from cast import MISS, cast
from chance import as_f32
from kinds.first_hit import NEAR_TIE, intersections
from kinds.tree import below_middle, members_of, split
from shapes import to_mitsuba
from shapes.triangle import Triangles
from tolerance import hit_tolerance

NODES = 256
"""How many nodes a question has room for."""

HITS = 12
"""A question has room for this many triangles that the ray meets."""

WORK = 0.45
"""How many tests are allowed beyond those of a search that knows the answer in advance, as a
share of these. Measured on layers behind each other and on the teapot: a search that takes the
nearer box first needs 0.01 and 0.01 more, one that does not check again whether a waiting box is
still near enough 0.34 and 0.18 more, one that takes the boxes in the order of the tree 2.52 and
0.65 more, and one that looks into every box that the ray meets 4.23 and 1.44 more."""

ROUNDING = 1e-5
"""By how much, as a share of t, rounding may move where a ray meets a box: ten times what
Mitsuba's float32 may cost."""

QUESTIONS = 160
"""How many questions a group has: few, because each test of a box or a triangle is a message."""

FRESH = 256
"""How many fresh questions a group has."""


@dataclass
class Node:
    """A node of the tree, in the order of its list."""

    second: int  # the place of its second child, or 0 for a leaf
    members: np.ndarray  # the triangles of a leaf
    near: float  # where the ray enters its box, in units of |d|
    far: float  # where it leaves; below `near` if it misses the box
    first: int = 0  # the name of its first triangle; the others follow


@dataclass(frozen=True)
class Question:
    """A tree as one ray sees it, and t >= min_t."""

    nodes: list
    hits: list  # (triangle, t, normal) of each triangle that the ray meets
    min_t: float  # in units of |d|
    golden: np.ndarray  # id, t, N.X, N.Y, N.Z
    tolerance: np.ndarray

    answer_channels = (*film.HIT_CHANNELS, "tests")
    channels = (
        "min_t",
        "nodes",
        "hits",
        *(f"{k}.{name}" for k in range(NODES) for name in ("second", "size", "first", "near", "far")),
        *(
            f"hit.{k}.{name}"
            for k in range(HITS)
            for name in ("triangle", "t", "N.X", "N.Y", "N.Z")
        ),
    )

    def values(self):
        """The pixel of the question's film."""
        values = np.zeros(len(self.channels))
        values[:3] = self.min_t, len(self.nodes), len(self.hits)
        for k, node in enumerate(self.nodes):
            slot = node.second, len(node.members), node.first, node.near, node.far
            values[3 + 5 * k :][:5] = slot
        for k, (triangle, t, normal) in enumerate(self.hits):
            values[3 + 5 * NODES + 5 * k :][:5] = triangle, t, *normal
        return values

    def answer(self):
        """Golden and tolerance, (6,) each."""
        least = self.least_tests()
        return np.array([*self.golden, least]), np.array([*self.tolerance, WORK * least])

    def least_tests(self):
        """How many tests a search needs if it knows the nearest t in advance: the root's
        box, and the children or triangles of each node that the ray enters before it."""
        # A triangle in a face of its box is met a hair before the box.
        nearest = self.golden[1] * (1 + 2 * ROUNDING) if self.golden[0] != MISS else np.inf
        tests = 1
        for node in self.nodes:
            if max(node.near, self.min_t) <= min(node.far, nearest):
                tests += 2 if node.second else len(node.members)
        return tests


def ask(rng, corners, origin, direction, min_t, largest):
    """The question about a mesh, shape (n, 3, 3), and leaves of at most `largest`
    triangles, or None if it must be drawn again.

    The origin of space is moved to the ray's origin, as for `first_hit`.
    """
    direction, min_t = as_f32(direction), float(as_f32(min_t))
    corners = as_f32(corners - origin)
    boxes = np.stack([corners.min(axis=1), corners.max(axis=1)], axis=1)
    tree = split(boxes, largest, below_middle)
    nodes = []
    flatten(nodes, tree, boxes, direction)
    if len(nodes) > NODES:
        # Leaving some out could tell a search what it need not enter.
        raise ValueError(f"a tree of {len(nodes)} nodes; a question has room for {NODES}")
    leaves = [node for node in nodes if not node.second]
    names, first = [], 0
    for leaf in rng.permutation(np.array(leaves, dtype=object)):
        leaf.first = first
        first += len(leaf.members)
        names.extend(leaf.members)
    mesh = corners[names]
    met = met_triangles(mesh, direction)
    if len(met) > HITS or not is_fair(met, min_t):
        return None
    world, start = to_mitsuba([Triangles(mesh)]), np.zeros((1, 3))
    hits = cast(world, start, direction[None], min_t)
    hits.id[:] = np.where(hits.id == MISS, MISS, hits.face)
    (tolerance,), _ = hit_tolerance(hits, [hits])
    (golden,) = hits.channels()
    after = [hit for hit in met if hit[1] >= min_t]
    if (golden[0] == MISS) != (not after):
        return None
    if after:
        triangle, t, normal = min(after, key=lambda hit: hit[1])
        if (np.abs(golden - [triangle, t, *normal]) > tolerance / 2).any():
            return None
    return Question(nodes, met, min_t, golden, tolerance)


def met_triangles(mesh, direction):
    """The triangles that a ray from the origin of space meets: (triangle, t, normal) of
    each, in no order of t."""
    size = direction @ direction
    along = mesh @ direction / size
    # What the ray can meet lies on both sides of it in every direction.
    aside = mesh - along[..., None] * direction
    near = np.flatnonzero(
        (aside.min(axis=1) <= 0).all(axis=1) & (aside.max(axis=1) >= 0).all(axis=1)
    )
    return [
        (int(triangle), t, normal)
        for triangle in near
        for t, normal in intersections(Triangles(mesh[[triangle]]), direction)
    ]


def is_fair(met, min_t):
    """Whether no two triangles are met at nearly the same t, and none near min_t."""
    marks = sorted([min_t, *(t for _, t, _ in met)])
    return all(far - near >= NEAR_TIE * far for near, far in zip(marks, marks[1:]))


def flatten(nodes, tree, boxes, direction):
    """Append the nodes of a tree to the list: a branch, its first child, its second."""
    members = members_of(tree)
    near, far = interval(boxes[members, 0].min(axis=0), boxes[members, 1].max(axis=0), direction)
    node = Node(0, members, near, far)
    nodes.append(node)
    if isinstance(tree, tuple):
        node.members = members[:0]
        flatten(nodes, tree[0], boxes, direction)
        node.second = len(nodes)
        flatten(nodes, tree[1], boxes, direction)


def interval(low, high, direction):
    """Where a ray from the origin of space enters and leaves a box, in t of any sign;
    (1, 0) if it misses. Both are moved outwards, so that no triangle is met outside its box.
    A flat box, which lies at one t, is moved away instead: rounding may do this to an answer's
    own boxes, so a search that passes over what lies before a box's entry loses hits."""
    near, far = -1e30, 1e30
    for axis in range(3):
        if direction[axis] == 0:
            if low[axis] > 0 or high[axis] < 0:
                return 1.0, 0.0
            continue
        a, b = sorted((low[axis] / direction[axis], high[axis] / direction[axis]))
        near, far = max(near, a), min(far, b)
    if near > far or far < 0:
        return 1.0, 0.0
    entry = ROUNDING if near == far else -ROUNDING
    return near + entry * abs(near), far + ROUNDING * abs(far)
