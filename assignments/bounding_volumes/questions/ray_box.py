"""Questions about a ray and a solid box."""

import numpy as np

from chance import log_uniform, unit_vector
from kinds.ray_box import ENDLESS, ask


def box(rng, size=None):
    """Min and max of a box whose sides are up to `size` long."""
    size = rng.uniform(0.5, 3) if size is None else size
    low = rng.uniform(-3, 3, 3)
    return np.array([low, low + size * rng.uniform(0.2, 1, 3)])


def within(rng, shape):
    """A point inside, well away from the faces."""
    return shape[0] + rng.uniform(0.05, 0.95, 3) * (shape[1] - shape[0])


def beside(rng, shape):
    """A point outside, but not far."""
    middle, half = shape.mean(axis=0), (shape[1] - shape[0]) / 2
    point = middle + half * rng.uniform(-0.95, 0.95, 3)
    axis = rng.integers(3)
    point[axis] = middle[axis] + rng.choice([-1, 1]) * (half[axis] + half.max()) * rng.uniform(1.05, 1.6)
    return point


def aim(
    rng, shape, target, *, away=None, length=None, min_t=None, max_t=None, zeros=0, in_face=False
):
    """A ray through `target` that starts `away` box sizes before it.

    `min_t` and `max_t` are shares of the target's t; `zeros` is the number of components of
    the direction that are 0. With `in_face`, the ray lies in a face of the box that is
    perpendicular to the first of these axes.
    """
    away = rng.uniform(2, 6) if away is None else away
    length = rng.uniform(0.3, 3) if length is None else length
    direction = unit_vector(rng)
    still = rng.permutation(3)[:zeros]
    direction[still] = [rng.choice([0.0, -0.0]) for _ in still]
    direction /= np.linalg.norm(direction)
    size = (shape[1] - shape[0]).max()
    t = away * size / length
    min_t = rng.uniform(0, 0.2) if min_t is None else min_t
    max_t = ENDLESS if max_t is None else max_t * t
    origin = target - away * size * direction
    if in_face:
        origin[still[0]] = rng.choice(shape[:, still[0]])
    return ask(shape, origin, direction * length, min_t * t, max_t)


def target(rng, shape, hit=0.6):
    """A point inside for a share of the questions, else beside the box."""
    return within(rng, shape) if rng.uniform() < hit else beside(rng, shape)


def anywhere(rng, shape, point, **more):
    """A ray through a point in one of the other groups' ways: two in five start inside, lie behind
    the origin or before min_t, or end at max_t."""
    match rng.integers(10):
        case 0:
            return aim(rng, shape, point, min_t=1, **more)
        case 1:
            return aim(rng, shape, point, away=-rng.uniform(2, 6), min_t=0, **more)
        case 2:
            return aim(rng, shape, point, min_t=rng.uniform(1.5, 3), **more)
        case 3:
            ends = (rng.uniform(0.2, 0.7), rng.uniform(1.5, 3))
            return aim(rng, shape, point, min_t=0, max_t=rng.choice(ends), **more)
    return aim(rng, shape, point, **more)


def outside(rng):
    """From outside; two rays in five miss, more or less."""
    shape = box(rng)
    return aim(rng, shape, target(rng, shape))


def inside(rng):
    """From inside, or with min_t inside; one ray in three begins outside."""
    shape = box(rng)
    if rng.uniform() < 0.33:
        return aim(rng, shape, target(rng, shape))
    point = within(rng, shape)
    if rng.uniform() < 0.5:
        return aim(rng, shape, point, away=0, min_t=0)
    return aim(rng, shape, point, min_t=1)


def behind(rng):
    """The box lies behind the origin, or before min_t; one in three lies ahead."""
    shape = box(rng)
    if rng.uniform() < 0.33:
        return aim(rng, shape, within(rng, shape))
    if rng.uniform() < 0.5:
        return aim(rng, shape, target(rng, shape), away=-rng.uniform(2, 6), min_t=0)
    return aim(rng, shape, target(rng, shape), min_t=rng.uniform(1.5, 3))


def max_t(rng):
    """max_t before the box, inside it, or behind it. Of the rays, some start inside, some end
    inside, too, some are parallel to one or two coordinate planes, and some are short; some boxes
    are flat."""
    shape = box(rng)
    point = within(rng, shape)
    share = rng.choice([rng.uniform(0.2, 0.7), 1, rng.uniform(1.5, 3)])
    match rng.integers(6):
        case 0:
            return aim(rng, shape, point, min_t=1, max_t=rng.uniform(1.1, 3))
        case 1:
            return aim(rng, shape, point, zeros=rng.integers(1, 3), max_t=share)
        case 2:
            return aim(rng, shape, point, length=log_uniform(rng, 1e-9, 1e3), max_t=share)
        case 3:
            axis = rng.integers(3)
            shape[1, axis] = point[axis] = shape[0, axis]
            share = rng.choice([rng.uniform(0.2, 0.7), rng.uniform(1.5, 3)])
        case 4:
            reach = np.minimum(point - shape[0], shape[1] - point).min()
            return ask(shape, point, unit_vector(rng), 0, rng.uniform(0.2, 0.9) * reach)
    return aim(rng, shape, point, max_t=share)


def zero_direction(rng):
    """Rays parallel to one or two coordinate planes, inside or outside the box's slab."""
    shape = box(rng)
    return anywhere(rng, shape, target(rng, shape), zeros=rng.integers(1, 3))


def in_face(rng):
    """Rays that run exactly in the plane of a face; some boxes are flat there."""
    shape = box(rng)
    if rng.uniform() < 0.3:
        axis = rng.integers(3)
        shape[1, axis] = shape[0, axis]
    zeros = rng.integers(1, 3)
    return anywhere(rng, shape, target(rng, shape), zeros=zeros, in_face=True)


def flat(rng):
    """Flat boxes, met at any angle."""
    shape = box(rng)
    axis = rng.integers(3)
    shape[1, axis] = shape[0, axis]
    point = target(rng, shape)
    point[axis] = shape[0, axis]
    return anywhere(rng, shape, point)


def direction_length(rng):
    """Directions whose length is anything from a billionth to a thousand."""
    shape = box(rng)
    return anywhere(rng, shape, target(rng, shape), length=log_uniform(rng, 1e-9, 1e3))


def scale(rng):
    """Tiny and huge boxes; one ray in five is parallel to one or two coordinate planes."""
    size = log_uniform(rng, 1e-4, 1e4)
    shape = size * box(rng, 1)
    zeros = rng.integers(1, 3) if rng.uniform() < 0.2 else 0
    return anywhere(rng, shape, target(rng, shape), zeros=zeros)


GROUPS = {
    draw.__name__: draw
    for draw in (
        outside,
        inside,
        behind,
        max_t,
        zero_direction,
        in_face,
        flat,
        direction_length,
        scale,
    )
}
