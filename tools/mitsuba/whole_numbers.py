"""Questions with small whole numbers, many of which are exact ties.

A tie is a question whose answer depends on comparing two equal numbers: t exactly `min_t`,
a ray exactly through an edge, two objects at the same t. Vectors are numpy arrays of
Python's own whole numbers and fractions, so that arithmetic is exact and says which
questions are ties; a film's float32 values hold all of these numbers exactly.
"""

from dataclasses import dataclass
from fractions import Fraction

import numpy as np

from kinds import intersect


def whole(rng, low, high):
    """A whole number from `low` to `high`, both included."""
    return int(rng.integers(low, high, endpoint=True))


def vector(rng):
    """A vector whose coordinates are whole: from -2 to 2, and for half of the vectors
    from -1 to 1, where products are 0 and 1 more often than not."""
    most = whole(rng, 1, 2)
    return np.array([whole(rng, -most, most) for _ in range(3)], dtype=object)


def not_zero(rng):
    """A whole vector other than 0."""
    while not (drawn := vector(rng)).any():
        pass
    return drawn


@dataclass(frozen=True)
class Ray:
    """A ray o + t d, t >= min_t, from a point in whole numbers or, as often, in quarters."""

    origin: np.ndarray
    direction: np.ndarray  # not 0
    min_t: int  # in units of |d|

    @classmethod
    def draw(cls, rng):
        """Any of them."""
        unit = 1 if rng.uniform() < 0.5 else Fraction(1, 4)
        return cls(unit * vector(rng), not_zero(rng), whole(rng, 0, 3))

    def at_min_t(self):
        """The point at `min_t`."""
        return self.origin + self.min_t * self.direction

    def ask(self, shape):
        """The question where this ray meets `shape`."""
        return intersect.ask(shape, self.origin, self.direction, self.min_t)
