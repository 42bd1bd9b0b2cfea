"""Questions about the ray of one pixel of one camera, a new camera every time.

Width and height are a pixel's size, of ten binary digits, times the resolution,
so they are float32 values of exactly square pixels, and Mitsuba's own sensor
can answer; only in `non_square` and half of `orthographic` are pixels not square.
The half width stays below 1.5 focal lengths, because the sensor keeps its field of
view as a float32 angle.
"""

from functools import partial

import numpy as np

from camera import Camera
from chance import as_f32, log_uniform, unit_vector
from kinds.viewing_ray import Question


def draw(rng, group):
    """A question of `group`."""
    camera = _camera(rng, group)
    return Question(camera, *_pixel(rng, group, camera.resolution))


def _camera(rng, group):
    resolution = tuple(int(n) for n in rng.integers(8, 800, 2))
    focal_length = 1.0 if group == "orthographic" else rng.uniform(0.5, 3)
    if group == "focal_length":
        focal_length = log_uniform(rng, 0.05, 20)
    width = focal_length * rng.uniform(0.4, 3)
    pixel = _ten_digits(width / resolution[0])
    is_square = group != "non_square" and (group != "orthographic" or rng.uniform() < 0.5)
    tall = pixel if is_square else _ten_digits(pixel * rng.uniform(0.3, 3))
    if group == "perspective":  # upright, level, looking anywhere near -z
        view, up = np.array([rng.uniform(-0.3, 0.3), 0, -1]), np.array([0, 1, 0])
    else:
        view, up = _view_and_up(rng)
    return Camera(
        eye=as_f32(rng.uniform(-5, 5, 3)),
        view=as_f32(view),
        up=as_f32(up),
        width=pixel * resolution[0],
        height=tall * resolution[1],
        focal_length=None if group == "orthographic" else float(as_f32(focal_length)),
        resolution=resolution,
    )


def _ten_digits(x):
    """`x` with its first ten binary digits."""
    mantissa, exponent = np.frexp(x)
    return float(np.ldexp(np.round(mantissa * 1024) / 1024, exponent))


def _view_and_up(rng):
    """Two vectors at least 20 degrees from parallel, neither unit nor orthogonal."""
    view, up = unit_vector(rng), unit_vector(rng)
    if abs(view @ up) > np.cos(np.radians(20)):
        return _view_and_up(rng)
    return log_uniform(rng, 0.2, 5) * view, log_uniform(rng, 0.2, 5) * up


def _pixel(rng, group, resolution):
    """A pixel (i, j). In the group `corners` it is on the border, every second time in a corner."""
    i, j = (int(rng.integers(n)) for n in resolution)
    if group != "corners":
        return i, j
    ends = [int(rng.choice((0, n - 1))) for n in resolution]
    return ends if rng.uniform() < 0.5 else ((ends[0], j) if rng.uniform() < 0.5 else (i, ends[1]))


GROUPS = {
    group: partial(draw, group=group)
    for group in (
        "perspective", "rotated", "focal_length", "corners", "orthographic", "non_square",
    )
}
