"""Properties of a single cast."""

import numpy as np
import pytest

from cast import cast
from shapes import to_mitsuba
from shapes.plane import Plane
from shapes.sphere import Sphere
from shapes.triangle import Triangles

SHAPES = {
    "sphere": Sphere(np.array([0.1, 0.2, 0.3]), 0.9),
    "plane": Plane(np.array([0.1, 0.2, 0.3]), np.array([0.3, 0.4, -2.0])),
    "triangle": Triangles(np.array([[[-2, -2, 0.3], [3, -2, 0.1], [0.2, 3, 0.5]]])),
}
ORIGIN = np.array([[0.4, -0.3, -3.7]])
DIRECTION = np.array([[-0.03, 0.11, 0.87]])


@pytest.mark.parametrize("power", (-10, -1, 1, 10))
@pytest.mark.parametrize("name", SHAPES)
def test_a_direction_twice_as_long_halves_t_and_costs_no_digit(name, power):
    world, scale = to_mitsuba([SHAPES[name]]), 2.0**power
    plain = cast(world, ORIGIN, DIRECTION, 0.0)
    scaled = cast(world, ORIGIN, scale * DIRECTION, 0.0)
    assert plain.id[0] == 0
    assert scaled.t[0] * scale == plain.t[0]
    np.testing.assert_array_equal(scaled.normal, plain.normal)


@pytest.mark.parametrize("name", SHAPES)
def test_normals_are_the_same_from_both_sides(name):
    world = to_mitsuba([SHAPES[name]])
    ahead = cast(world, ORIGIN, DIRECTION, 0.0)
    beyond = ORIGIN + (ahead.t[0] + 0.01) * DIRECTION
    behind = cast(world, beyond, -DIRECTION, 0.0)
    assert behind.t[0] == pytest.approx(0.01, rel=1e-3)
    np.testing.assert_allclose(behind.normal, ahead.normal, atol=1e-6)


def test_min_t_lets_the_far_root_of_a_sphere_answer():
    world = to_mitsuba([SHAPES["sphere"]])
    near = cast(world, ORIGIN, DIRECTION, 0.0)
    far = cast(world, ORIGIN, DIRECTION, near.t[0] + 0.01)
    assert far.t[0] > near.t[0] + 0.5
    assert far.normal[0] @ DIRECTION[0] > 0  # outward, away from the ray's origin
