"""Questions of the kind `first_hit`: which of several objects does the ray hit first?

The objects are canned: the question says what each of them would answer alone,
so that a wrong sphere cannot spoil a right search. Their answers are Mitsuba's
casts of each object alone; the golden is its cast of all of them together. As
in `intersect.py`, the origin of space is moved to the ray's origin first.
"""

from dataclasses import dataclass

import numpy as np

import film
from cast import MISS, cast
from chance import as_f32
from shapes import to_mitsuba
from tolerance import hit_tolerance

SLOTS = 6
"""How many objects a question has room for."""

NEAR_TIE = 1e-4
"""A question is redrawn if two objects are this close to each other, or one is this close to
min_t, as a share of t: float32 can't tell them apart."""

FRESH = 512
"""How many fresh questions a group has; each costs as much as five of the other kinds."""


@dataclass(frozen=True)
class Question:
    """A ray o + t d, t >= min_t, and objects, in coordinates relative to o."""

    origin: np.ndarray
    direction: np.ndarray  # any length
    min_t: float  # in units of |d|
    objects: list
    intersections: list  # `intersections[k]` are those of `objects[k]` alone

    answer_channels = film.HIT_CHANNELS
    channels = (*film.RAY_CHANNELS, "min_t", "count") + tuple(
        f"{k}.{name}"
        for k in range(SLOTS)
        for name in ("hits", *(f"{hit}.{c}" for hit in (0, 1) for c in film.HIT_CHANNELS[1:]))
    )

    def values(self):
        """The pixel of the question's film."""
        values = np.zeros(len(self.channels))
        values[:8] = *self.origin, *self.direction, self.min_t, len(self.objects)
        for k, found in enumerate(self.intersections):
            slot = [len(found), *(x for t, n in found for x in (t, *n))]
            values[8 + 9 * k :][: len(slot)] = slot
        return values

    def answer(self):
        """Golden and tolerance, (5,) each, or None for a question to be redrawn.

        Canned answers do not move with the ray, so there are no displaced rays: what
        remains is float32.
        """
        world, start = to_mitsuba(self.objects), np.zeros((1, 3))
        hits = cast(world, start, self.direction[None], self.min_t)
        (tolerance,), _ = hit_tolerance(hits, [hits])
        (golden,) = hits.channels()
        return (golden, tolerance) if self._is_fair(golden, tolerance) else None

    def _is_fair(self, golden, tolerance):
        """Whether there is no near tie, and both kinds of casts agree on the nearest object."""
        every = sorted(
            ((t, k, normal) for k, found in enumerate(self.intersections) for t, normal in found),
            key=lambda hit: hit[0],
        )
        marks = sorted([self.min_t, *(t for t, _, _ in every)])
        if any(far - near < NEAR_TIE * far for near, far in zip(marks, marks[1:])):
            return False
        reached = [hit for hit in every if hit[0] >= self.min_t]
        if not reached:
            return golden[0] == MISS
        t, k, normal = reached[0]
        return bool((np.abs(golden - [k, t, *normal]) <= tolerance / 2).all())


def intersections(thing, direction):
    """All intersections of one object with a ray from the origin of space, nearest
    first: a list of (t, normal). Each cast starts just behind the last hit."""
    world, start, found = to_mitsuba([thing]), np.zeros((1, 3)), []
    min_t = 0.0
    while True:
        hits = cast(world, start, direction[None], min_t)
        if hits.id[0] == MISS:
            return found
        t = float(as_f32(hits.t[0]))
        found.append((t, hits.normal[0]))
        min_t = (1 + NEAR_TIE) * t
