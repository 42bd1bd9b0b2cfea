"""Questions about the nearest of several objects, for `first_hit` and `triangle_soup`.

The objects are canned: the question says what each of them would answer alone,
so that a wrong sphere cannot spoil a right search. Their answers are Mitsuba's
casts of each object alone; the golden is its cast of all of them together. As
in `probe_shape.py`, the origin of space is moved to the ray's origin first.
"""

import numpy as np

from camera import normalize
from cast import MISS, cast
from chance import as_f32, log_uniform, perpendicular, sign, tilted_from, unit_vector
from probe_shape import RAY_CHANNELS
from probe_triangle import around, corners, within
from scene import Plane, Sphere, Triangles
from shapes import to_mitsuba
from tolerance import hit_tolerance

SLOTS = 6
"""How many objects a question has room for."""

NEAR_TIE = 1e-4
"""Two objects this near to each other, or an object this near to min_t, as a
share of t, are no question for float32."""

ANSWER_CHANNELS = ("t", "N.X", "N.Y", "N.Z")
CHANNELS = (*RAY_CHANNELS, "count") + tuple(
    f"{k}.{name}"
    for k in range(SLOTS)
    for name in ("hits", *(f"{hit}.{c}" for hit in (0, 1) for c in ANSWER_CHANNELS))
)


def sphere(rng, direction, t, hit):
    """A sphere whose middle is passed at `t`, hit or just missed by the ray."""
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


def lone_hits(thing, direction):
    """All intersections with t > 0 of one object: a list of (t, normal), t rising.

    A sphere's far root is what a ray from the middle of its chord sees.
    """
    starts = [0.0]
    if isinstance(thing, Sphere):
        starts.append(max(0.0, thing.center @ direction / (direction @ direction)))
    rays = (np.zeros((len(starts), 3)), np.tile(direction, (len(starts), 1)))
    hits = cast(to_mitsuba([thing]), *rays, np.array(starts))
    found = {float(as_f32(t)): n for k, t, n in zip(hits.id, hits.t, hits.normal) if k != MISS}
    return sorted(found.items())


def draw(rng, group, kinds, one_object):
    """A question of `group` with its golden and tolerance, or None to redraw."""
    wanted = _wanted(rng, group)
    direction = as_f32(rng.uniform(0.5, 2) * unit_vector(rng))
    origin = as_f32(rng.uniform(-3, 3, 3))
    things = [
        rng.choice(kinds)(rng, direction, log_uniform(rng, 0.5, 8), hit) for hit in wanted
    ]
    answers = [lone_hits(thing, direction) for thing in things]
    if [bool(answer) for answer in answers] != wanted:
        return None
    min_t = _min_t(rng, group, answers)
    firsts = [min((t for t, _ in answer if t >= min_t), default=np.inf) for answer in answers]
    order = _order(rng, group, np.array(firsts))
    things, answers = [things[k] for k in order], [answers[k] for k in order]
    golden, tolerance = _golden(things, direction, min_t)
    if not _fair(answers, min_t, golden, tolerance):
        return None
    if one_object and golden[0] != MISS:
        golden[0] = 0.0
    values = np.zeros(len(CHANNELS))
    values[:8] = *origin, *direction, min_t, len(things)
    for k, answer in enumerate(answers):
        slot = [len(answer), *(x for t, n in answer for x in (t, *n))]
        values[8 + 9 * k :][: len(slot)] = slot
    return values, golden, tolerance


def _wanted(rng, group):
    """Which objects the ray shall meet."""
    if group == "empty":
        return [False] * int(rng.choice((0, rng.integers(1, SLOTS + 1))))
    if group == "last_only":
        return [False] * int(rng.integers(1, SLOTS)) + [True]
    if group == "absent":
        hits = int(rng.integers(1, SLOTS - 2))
        return [True] * hits + [False] * int(rng.integers(2, SLOTS - hits + 1))
    hits = int(rng.integers(2, SLOTS + 1))
    return [True] * hits + [False] * int(rng.integers(0, SLOTS - hits + 1))


def _min_t(rng, group, answers):
    """In the group min_t above at least the nearest intersection, and in three
    questions of ten above all of them; below all intersections elsewhere."""
    every = sorted(t for answer in answers for t, _ in answer)
    if not every:
        return float(as_f32(rng.uniform(0, 1)))
    if group != "min_t":
        return float(as_f32(rng.uniform(0, 0.9) * every[0]))
    if len(every) == 1 or rng.uniform() < 0.3:
        return float(as_f32(rng.uniform(1.1, 2) * every[-1]))
    k = int(rng.integers(1, len(every)))
    return float(as_f32(rng.uniform(every[k - 1], every[k])))


def _order(rng, group, firsts):
    """The order in the list, given the t each object answers (inf for none)."""
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


def _golden(things, direction, min_t):
    """Golden and tolerance, (5,) each: the cast of all. Canned answers do not move
    with the ray, so there are no displaced rays: what remains is float32."""
    hits = cast(to_mitsuba(things), np.zeros((1, 3)), direction[None], min_t)
    tolerance, _ = hit_tolerance(hits, [hits])
    return hits.channels()[0], tolerance[0]


def _fair(answers, min_t, golden, tolerance):
    """No near tie, and the casts alone and together agree on who is nearest."""
    every = sorted(
        ((t, k, normal) for k, answer in enumerate(answers) for t, normal in answer),
        key=lambda hit: hit[0],
    )
    marks = sorted([min_t, *(t for t, _, _ in every)])
    if any(far - near < NEAR_TIE * far for near, far in zip(marks, marks[1:])):
        return False
    reached = [hit for hit in every if hit[0] >= min_t]
    if not reached:
        return golden[0] == MISS
    t, k, normal = reached[0]
    return bool((np.abs(golden - [k, t, *normal]) <= tolerance / 2).all())


FIRST_HIT_GROUPS = ("near_first", "far_first", "shuffled", "absent", "min_t", "empty")
TRIANGLE_SOUP_GROUPS = (*FIRST_HIT_GROUPS, "last_only")


def first_hit(rng, group):
    """A question about spheres, planes and triangles; the id is the object's index."""
    return draw(rng, group, (sphere, plane, triangle), one_object=False)


def triangle_soup(rng, group):
    """A question about the triangles of one soup; the id is 0 for any of them."""
    return draw(rng, group, (triangle,), one_object=True)
