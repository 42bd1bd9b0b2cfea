"""The objects of a random scene: triangles, all in view."""

import numpy as np

from chance import unit_vector


def objects(rng, view):
    """Tables of the scene file's objects: lone triangles 2.5 to 8 in front of the eye."""
    return [triangle(rng, view) for _ in range(8)]


def triangle(rng, view):
    """A triangle that is not seen from its edge."""
    middle = view.point(rng, rng.uniform(2.5, 8), 0.7)
    across = [unit_vector(rng) - 0.5 * view.frame[2] for _ in range(3)]
    return {"type": "triangle", "corners": middle + rng.uniform(0.5, 1.5) * np.array(across)}
