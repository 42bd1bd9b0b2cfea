"""Several objects along a ray: questions for `first_hit` and `triangle_soup`.

All positions are relative to the ray's origin.
"""

import numpy as np

from camera import normalize
from chance import as_f32, log_uniform, perpendicular, sign, tilted_from, unit_vector
from kinds.first_hit import SLOTS, intersections
from questions.triangle import around, corners, within
from shapes.plane import Plane
from shapes.sphere import Sphere
from shapes.triangle import Triangles

GROUPS = ("near_first", "far_first", "shuffled", "absent", "min_t", "empty")
"""The groups that both tasks have."""


def sphere(rng, direction, t, hit):
    """A sphere whose centre the ray passes at `t`; it hits the sphere or just misses."""
    length = np.linalg.norm(direction)
    radius = rng.uniform(0.1, 0.8) * t * length
    impact = 0.95 * np.sqrt(rng.uniform()) if hit else rng.uniform(1.02, 2)
    nearest = t * direction
    return Sphere(nearest + impact * radius * perpendicular(rng, direction / length), radius)


def plane(rng, direction, t, hit):
    """A plane the ray meets at `t`, or at -`t` if it is not to be hit."""
    met = (t if hit else -t) * direction
    normal = sign(rng) * tilted_from(rng, normalize(direction), 0.2, 1)
    return Plane(met + rng.uniform(0, 2) * perpendicular(rng, normal), normal)


def triangle(rng, direction, t, hit):
    """A triangle whose plane the ray meets at `t`, inside or outside."""
    shape = corners(rng, rng.uniform(0.3, 1.5), rng.uniform(0.8, 3))
    normal = normalize(np.cross(shape[1] - shape[0], shape[2] - shape[0]))
    if abs(normal @ normalize(direction)) < 0.2:
        return triangle(rng, direction, t, hit)
    at = within(rng) if hit else around(rng)
    return Triangles((shape + t * direction - at @ shape)[None])


def draw(rng, group, kind, things):
    """A question of `group` and `kind` about objects that the functions `things` draw, or
    None if it must be drawn again."""
    wanted = _wanted(rng, group)
    # With a long direction, t is so small that no margin can be added to min_t. With a short one,
    # t is so large that a search can't begin with a large number instead of infinity.
    long = log_uniform(rng, 1, 1e4) if group == "min_t" else 1
    if group == "shuffled" and rng.uniform() < 0.25:
        long = log_uniform(rng, 1e-12, 1e-2)
    direction = as_f32(long * rng.uniform(0.5, 2) * unit_vector(rng))
    origin = as_f32(rng.uniform(-3, 3, 3))
    objects = [
        rng.choice(things)(rng, direction, log_uniform(rng, 0.5, 8) / long, hit) for hit in wanted
    ]
    found = [intersections(thing, direction) for thing in objects]
    if [bool(hits) for hits in found] != wanted:
        return None
    min_t = _min_t(rng, group, found)
    firsts = [min((t for t, _ in hits if t >= min_t), default=np.inf) for hits in found]
    order = _order(rng, group, np.array(firsts))
    return kind.Question(
        origin, direction, min_t, [objects[k] for k in order], [found[k] for k in order]
    )


def _wanted(rng, group):
    """Which objects the ray is to hit."""
    if group == "empty":  # with a hit now and then, or "no hit" would always be right
        hit = [True] if rng.uniform() < 0.25 else []
        return hit + [False] * int(rng.choice((0, rng.integers(1, SLOTS + 1 - len(hit)))))
    if group == "last_only":
        return [False] * int(rng.integers(1, SLOTS)) + [True]
    if group == "absent":
        hits = int(rng.integers(1, SLOTS - 2))
        return [True] * hits + [False] * int(rng.integers(2, SLOTS - hits + 1))
    hits = int(rng.integers(2, SLOTS + 1))
    return [True] * hits + [False] * int(rng.integers(0, SLOTS - hits + 1))


def _min_t(rng, group, found):
    """A value for min_t. In the group `min_t` it is above at least the nearest
    intersection, and in three questions of ten above all of them. In all other groups
    it is below all intersections."""
    every = sorted(t for hits in found for t, _ in hits)
    if not every:
        return float(as_f32(rng.uniform(0, 1)))
    if group != "min_t":
        return float(as_f32(rng.uniform(0, 0.9) * every[0]))
    if len(every) == 1 or rng.uniform() < 0.3:
        return float(as_f32(rng.uniform(1.1, 2) * every[-1]))
    k = int(rng.integers(1, len(every)))
    return float(as_f32(rng.uniform(every[k - 1], every[k])))


def _order(rng, group, firsts):
    """The order in the list, given the t of each object's hit (inf for none)."""
    shuffled = rng.permutation(len(firsts))
    if group == "last_only":
        return np.arange(len(firsts))
    if group == "absent":  # a missed object at either end, the rest between
        missed = [k for k in shuffled if np.isinf(firsts[k])]
        return [missed[0], *(k for k in shuffled if k not in missed[:2]), missed[1]]
    if group not in ("near_first", "far_first"):
        return shuffled
    hits = iter(sorted(
        (k for k in shuffled if np.isfinite(firsts[k])),
        key=lambda k: firsts[k],
        reverse=group == "far_first",
    ))
    return [k if np.isinf(firsts[k]) else next(hits) for k in shuffled]
