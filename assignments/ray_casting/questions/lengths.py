"""Lengths of directions, and values of min_t."""

from chance import log_uniform


def ordinary_or_long(rng):
    """A length from 0.3 to 3 or, one time in three, from 1e5 to 1e7."""
    return log_uniform(rng, 1e5, 1e7) if rng.uniform() < 1 / 3 else rng.uniform(0.3, 3)


def usually_below(rng):
    """A share of t for min_t: up to 0.5 or, one time in eight, 1.1 to 2, so that nothing is hit."""
    return rng.uniform(1.1, 2) if rng.uniform() < 1 / 8 else rng.uniform(0, 0.5)


def usually_ahead(rng):
    """Whether a shape lies ahead: seven times in eight."""
    return rng.uniform() < 7 / 8
