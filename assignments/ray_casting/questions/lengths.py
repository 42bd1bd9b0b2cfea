"""Lengths of directions."""

from chance import log_uniform


def ordinary_or_long(rng):
    """A length from 0.3 to 3 or, one time in three, from 1e5 to 1e7."""
    return log_uniform(rng, 1e5, 1e7) if rng.uniform() < 1 / 3 else rng.uniform(0.3, 3)
