"""Questions about one sphere.

A ray is placed by two numbers in units of the radius: its impact parameter
(the distance of its line from the centre) and how far before the nearest point it
starts. A parameter below 1 is a hit. Drawn evenly over a disc of radius 1.29, 60 % hit.
"""

import numpy as np

from chance import log_uniform, perpendicular, sometimes_level, unit_vector
from kinds.intersect import ask
from questions.lengths import ordinary_or_long
from shapes.sphere import Sphere


def place(
    rng, *, along=None, impact=None, before=None, radius=None, center=None, length=None, min_t=None
):
    """A question; arguments that are not given are drawn.

    `along` is the ray's unit direction, `min_t` a function of the two roots (None where the line
    misses).
    """
    impact = 1.29 * np.sqrt(rng.uniform()) if impact is None else impact
    before = rng.uniform(1.5, 6) if before is None else before
    radius = rng.uniform(0.3, 2) if radius is None else radius
    center = rng.uniform(-3, 3, 3) if center is None else center
    length = rng.uniform(0.3, 3) if length is None else length
    along = unit_vector(rng) if along is None else along
    origin = center + radius * (impact * perpendicular(rng, along) - before * along)
    half_chord = np.sqrt(max(0.0, 1 - impact**2))
    near, far = (radius / length * (before + side * half_chord) for side in (-1, 1))
    if min_t is None:
        least = rng.uniform(0, 0.5) * max(near, 0.0)
    else:
        least = min_t(near, far)
    return ask(Sphere(center, radius), origin, length * along, least)


def outside(rng):
    """From outside, the near root counts. One ray in eight is parallel to a coordinate plane or
    axis."""
    return place(rng, along=sometimes_level(rng, unit_vector(rng)))


def inside(rng):
    """The near root lies below min_t, so only the far one can be the answer.

    The origin is inside, or t = min_t lies inside the sphere. In one question of five
    min_t is behind the far root too.
    """
    impact = 0.95 * np.sqrt(rng.uniform())
    half_chord = np.sqrt(1 - impact**2)
    beyond = rng.uniform() < 0.2
    if rng.uniform() < 0.5:
        share = rng.uniform(1.1, 2) if beyond else rng.choice((0.0, rng.uniform(0, 0.9)))
        before = rng.uniform(-0.9, 0.9) * half_chord
        return place(rng, impact=impact, before=before, min_t=lambda near, far: share * far)
    share = rng.uniform(1.1, 2) if beyond else rng.uniform(0.1, 0.9)
    return place(rng, impact=impact, min_t=lambda near, far: near + share * (far - near))


def behind(rng):
    """Mostly spheres behind the origin, which are missed."""
    forwards = rng.uniform() < 0.4
    before = rng.uniform(1.5, 6) * (1 if forwards else -1)
    return place(rng, impact=0.95 * np.sqrt(rng.uniform()), before=before)


def min_t(rng):
    """min_t below both roots, between them, or above both, equally often. If d is long, the
    roots are so small that no margin can be added to min_t."""
    impact = 0.95 * np.sqrt(rng.uniform())
    below, between, above = rng.uniform(0.1, 0.9), rng.uniform(0.1, 0.9), rng.uniform(1.1, 2)
    case = rng.choice(("below", "between", "above"))

    def least(near, far):
        if case == "below":
            return below * near
        return near + between * (far - near) if case == "between" else above * far

    return place(rng, impact=impact, length=ordinary_or_long(rng), min_t=least)


def direction_length(rng):
    """|d| from 1e-3 to 1e3, because t counts in units of |d|."""
    return place(rng, length=log_uniform(rng, 1e-3, 1e3))


def scale(rng):
    """Tiny and huge spheres near the origin of space; half the directions are as
    long as the sphere is wide, half have the length of ordinary scenes.

    For half of them, min_t lies between the roots or behind both, so that min_t is
    tested with small and large discriminants too.
    """
    tiny = rng.uniform() < 0.6
    radius = log_uniform(rng, 1e-6, 1e-2) if tiny else log_uniform(rng, 1e2, 1e4)
    unit = rng.choice((1.0, radius))
    between, above = rng.uniform(0.1, 0.9), rng.uniform(1.1, 2)
    late = rng.uniform() < 0.5
    above_both = rng.uniform() < 0.4

    def least(near, far):
        return above * far if above_both else near + between * (far - near)

    return place(
        rng,
        impact=0.95 * np.sqrt(rng.uniform()) if late else None,
        radius=radius,
        center=radius * rng.uniform(-3, 3, 3),
        length=unit * rng.uniform(0.3, 3),
        min_t=least if late else None,
    )


def offset(rng):
    """Ray and sphere 10 to 100 from the origin of space along every axis. In one question of
    four, min_t lies behind both roots."""
    center = rng.uniform(10, 100, 3) * rng.choice((-1, 1), 3)
    if rng.uniform() < 0.75:
        return place(rng, center=center)
    above, impact = rng.uniform(1.1, 2), 0.95 * np.sqrt(rng.uniform())
    return place(rng, center=center, impact=impact, min_t=lambda _, far: above * far)


def grazing(rng):
    """Within 1e-4 to 1e-2 radii of the silhouette, 60 % on its inner side."""
    gap = log_uniform(rng, 1e-4, 1e-2)
    return place(rng, impact=1 - gap if rng.uniform() < 0.6 else 1 + gap)


def radius(rng):
    """Radii for which r, r^2, 1/r and 1/(2r) are all different."""
    size = rng.uniform(0.1, 5)
    while min(abs(size - 0.5), abs(size - 1)) < 0.05:
        size = rng.uniform(0.1, 5)
    return place(rng, radius=size)


GROUPS = {
    draw.__name__: draw
    for draw in (
        outside, inside, behind, min_t, direction_length, scale, offset, grazing, radius,
    )
}
