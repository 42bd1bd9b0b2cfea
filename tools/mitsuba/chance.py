"""Random numbers and vectors for questions and random scenes."""

import hashlib

import numpy as np

from camera import normalize


def generator(seed, name):
    """A random generator for the film of this name.

    It is seeded by the SHA-256 of `SEED:NAME`, so a film depends on its own name and
    the seed alone: adding or moving a group changes no other film.
    """
    digest = hashlib.sha256(f"{seed}:{name}".encode()).digest()
    return np.random.default_rng(int.from_bytes(digest, "big"))


def as_f32(values):
    """`values` rounded to what a film can hold, as float64 again."""
    return np.float64(np.float32(values))


def unit_vector(rng):
    """A direction, uniform on the sphere."""
    return normalize(rng.normal(size=3))


def sometimes_level(rng, vector):
    """A unit vector or, one time in eight, the same without one or two of its components (the
    smallest), so that it is exactly parallel to a coordinate plane or axis."""
    if rng.uniform() >= 1 / 8:
        return vector
    smallest = np.argsort(np.abs(vector))[: rng.integers(1, 3)]
    return normalize(np.where(np.isin(np.arange(3), smallest), 0, vector))


def perpendicular(rng, axis):
    """A unit vector at a right angle to the unit vector `axis`."""
    vector = rng.normal(size=3)
    return normalize(vector - (vector @ axis) * axis)


def log_uniform(rng, low, high):
    """A number whose logarithm is uniform, so that all magnitudes are equally likely."""
    return float(np.exp(rng.uniform(np.log(low), np.log(high))))


def sign(rng):
    """-1 or 1."""
    return float(rng.choice((-1.0, 1.0)))


def tilted_from(rng, axis, low, high):
    """A unit vector whose cosine with the unit vector `axis` is in [low, high]."""
    cosine = rng.uniform(low, high)
    return cosine * axis + np.sqrt(1 - cosine**2) * perpendicular(rng, axis)
