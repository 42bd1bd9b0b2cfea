"""Questions about one plane.

A ray is aimed at a target on the plane from a distance; a negative distance puts
the plane behind the ray, which is a miss.
"""

from dataclasses import dataclass

import numpy as np

from chance import log_uniform, perpendicular, sign, sometimes_level, tilted_from, unit_vector
from kinds.intersect import Question, ask
from questions.lengths import ordinary_or_long, usually_below
from shapes.plane import Plane


def place(
    rng, *, side=None, ahead=None, point=None, normal=None, away=None, stored=None, length=None,
    min_t=None,
):
    """A question; arguments that are not given are drawn.

    `side` is 1 for an origin on the side the normal points to, `ahead` whether the
    plane lies ahead, `normal` its unit normal, `away` the unit vector from the plane to the
    origin, `stored` the length of the normal that is given, `min_t` a share of the plane's t.
    """
    side = sign(rng) if side is None else side
    ahead = rng.uniform() < 0.6 if ahead is None else ahead
    point = rng.uniform(-3, 3, 3) if point is None else point
    stored = rng.uniform(0.5, 2) if stored is None else stored
    length = rng.uniform(0.3, 3) if length is None else length
    share = rng.uniform(0, 0.5) if min_t is None else min_t
    normal = unit_vector(rng) if normal is None else normal
    target = point + rng.uniform(0, 5) * perpendicular(rng, normal)
    away = side * tilted_from(rng, normal, 0.1, 1) if away is None else away
    distance = rng.uniform(1, 8)
    direction = -away * length if ahead else away * length
    least = share * distance / length
    return ask(Plane(point, stored * normal), target + distance * away, direction, least)


def front(rng):
    """The normal points to the ray's side. One ray in eight is parallel to a coordinate plane or
    axis."""
    away = sometimes_level(rng, unit_vector(rng))
    return place(rng, side=1, normal=tilted_from(rng, away, 0.1, 1), away=away)


def back(rng):
    """Seen from behind: the normal stays as it is."""
    return place(rng, side=-1)


def behind(rng):
    """Mostly planes behind the ray's origin, which is on either side of them."""
    return place(rng, ahead=rng.uniform() < 0.3)


def min_t(rng):
    """min_t below and above the plane's t. If d is long, t is so small that no margin can be
    added to min_t."""
    share = rng.uniform(0.1, 0.9) if rng.uniform() < 0.6 else rng.uniform(1.1, 3)
    return place(rng, ahead=rng.uniform() < 0.95, min_t=share, length=ordinary_or_long(rng))


def direction_length(rng):
    """|d| from 1e-3 to 1e6, because t counts in units of |d|."""
    return place(rng, length=log_uniform(rng, 1e-3, 1e6), min_t=usually_below(rng))


def stored_normal(rng):
    """Normals of length 1e-4 to 1e2. The answer's normal must be a unit vector all the same.

    Half the directions are short too, so that n . d is small without the ray being
    anywhere near parallel to the plane.
    """
    length = log_uniform(rng, 1e-3, 1) if rng.uniform() < 0.5 else None
    return place(rng, stored=log_uniform(rng, 1e-4, 1e2), length=length, min_t=usually_below(rng))


def offset(rng):
    """Ray and plane 10 to 100 from the origin of space along every axis."""
    point = rng.uniform(10, 100, 3) * rng.choice((-1, 1), 3)
    return place(rng, point=point, min_t=usually_below(rng))


@dataclass(frozen=True)
class Flattened(Question):
    """A question about a space that was flattened towards the plane, and the question
    before flattening, which Mitsuba answers: flattening changes neither t nor the normal."""

    before: Question

    def answer(self):
        """Golden and tolerance of the question before."""
        return self.before.answer()


def flattened(rng):
    """A ray at an angle of 1e-14 to 1e-4 rad to the plane, or a little more.

    The normal lies along an axis, so n . d is a single product, and every right caster can tell
    the ray from a parallel one. For other normals, the rounding of n . d is about 2.2e-16
    (`f64::EPSILON`) times |n| |d|. So we accept a caster that takes a smaller n . d for 0.
    """
    axis = np.eye(3)[rng.integers(3)]
    point = rng.uniform(-3, 3, 3) * (1 - axis)
    before = place(rng, point=point, normal=axis, min_t=usually_below(rng))
    flat = np.where(axis, 2.0 ** -int(rng.integers(14, 44)), 1.0)
    origin, direction = flat * before.origin, flat * before.direction
    return Flattened(before.shape, origin, direction, before.min_t, before)


def parallel(rng):
    """Rays that reach the plane at an angle of 1.5e-4 to 5e-2 rad, leave it at such an
    angle, or are exactly parallel to it (one in five) and miss. At smaller angles, Mitsuba's
    own answer changes too much when the ray is tilted for the tolerance, so those rays are
    `flattened` (one in five).

    In half of the others, d is very short, so that n . d is tiny at any angle: no fixed bound
    on it tells which rays are parallel.

    The exactly parallel rays are parallel in every right caster's arithmetic, even after the
    normal is normalised and with fused multiply-adds: the normal has one component,
    or two of equal size, and then the direction has two components of 1. They start
    at least 2 above the plane. So when they are tilted for the tolerance, they miss
    the disk that represents the plane, because they meet the plane 2e6 away.
    """
    stored, length = rng.uniform(0.5, 2), rng.uniform(0.3, 3)
    point = rng.uniform(-3, 3, 3)
    which = rng.uniform()
    if which < 0.2:
        return flattened(rng)
    if which < 0.4:
        x, y, z = np.eye(3)[rng.permutation(3)]
        a, b = rng.uniform(0.3, 3, 2)
        axis, along = (x, a * y + b * z) if rng.uniform() < 0.5 else (x + y, x - y + b * z)
        height = sign(rng) * rng.uniform(2, 5)
        origin = point + height * axis / np.linalg.norm(axis)
        return ask(Plane(point, sign(rng) * stored * axis), origin, along, 0.0)
    normal = unit_vector(rng)
    along = perpendicular(rng, normal)
    side, angle = sign(rng), log_uniform(rng, 1.5e-4, 5e-2)
    length = log_uniform(rng, 1e-17, 1) if rng.uniform() < 0.5 else length
    towards = -side if rng.uniform() < 0.75 else side
    direction = length * (np.cos(angle) * along + towards * np.sin(angle) * normal)
    height = rng.uniform(0.5, 3)
    origin = point + rng.uniform(0, 5) * along + side * height * normal
    least = usually_below(rng) * height / (length * np.sin(angle))
    return ask(Plane(point, stored * normal), origin, direction, least)


GROUPS = {
    draw.__name__: draw
    for draw in (
        front, back, behind, min_t, direction_length, stored_normal, offset, parallel,
    )
}
