"""The objects of a random scene: one of every shape, all in view."""

from camera import normalize
from chance import log_uniform, sign, unit_vector
from questions.triangle import corners


def objects(rng, view):
    """Tables of the scene file's objects."""
    shapes = {"sphere": sphere, "plane": plane, "triangle": triangle}
    names = rng.permutation(["sphere"] * 4 + ["plane"] + ["triangle"] * 4)
    return [{"type": name, **shapes[name](rng, view)} for name in names]


def sphere(rng, view):
    """A sphere at a depth of 2.5 to 8, with a radius of at most a fifth of that."""
    depth = rng.uniform(2.5, 8)
    return {
        "center": view.point(rng, depth, 0.9),
        "radius": log_uniform(rng, 0.1, 0.2 * depth),
    }


def plane(rng, view):
    """A plane behind most other objects, and tilted by less than the angle of view."""
    normal = sign(rng) * normalize(view.frame[2] + 0.3 * unit_vector(rng))
    return {
        "point": view.point(rng, rng.uniform(6, 10), 0.5),
        "normal": normal * log_uniform(rng, 0.2, 5),
    }


def triangle(rng, view):
    """A triangle at a depth of 2.5 to 8."""
    middle = view.point(rng, rng.uniform(2.5, 8), 0.7)
    return {"corners": middle + corners(rng, rng.uniform(0.5, 2.5), rng.uniform(0.8, 3))}
