"""The objects of a random scene: a mesh of single triangles, and a lone triangle, all in view."""

import numpy as np

from chance import unit_vector


def objects(rng, view):
    """Tables of the scene file's objects, 2.5 to 8 in front of the eye."""
    mesh = np.array([triangle(rng, view, rng.uniform(0.2, 0.8)) for _ in range(40)])
    lone = triangle(rng, view, rng.uniform(0.5, 1.5))
    return [{"type": "soup", "triangles": mesh}, {"type": "triangle", "corners": lone}]


def triangle(rng, view, size):
    """The corners of a triangle that is not seen from its edge."""
    middle = view.point(rng, rng.uniform(2.5, 8), 0.9)
    return middle + size * np.array([unit_vector(rng) - 0.5 * view.frame[2] for _ in range(3)])
