"""Fresh question films: questions that nobody has seen, from a seed of their own.

A mark must not depend on the draw, so fresh questions are spread over everything that
can be drawn. The kind of a group says how many it has (`FRESH`): enough to catch a
mistake that shows in one question of a thousand. `tools/RECORDS.md` has the
measurement. The committed questions are drawn independently and stay as they are.
"""

from importlib import import_module

import numpy as np

from chance import generator
from question_films import films, questions_of

EXTREME = 2
"""One question out of this many is drawn towards the ends of its ranges."""

BELOW_1 = 1 - 2.0**-53


class Strata:
    """A random generator whose numbers are spread evenly over the questions of a group.

    Every number that a function asks for while it draws one question is a dimension:
    the size, the distance, the direction's length, the share of min_t. A dimension is
    identified by its range and by how many numbers from it the question has had before.
    Each is spread evenly by itself and in an order of its own, so the questions are a
    Latin hypercube (McKay, Beckman and Conover, 1979). What is not a number from a range
    is drawn independently.

    A mistake may show only where several numbers are extreme at once: a huge t needs a
    large sphere, far away, and a short direction. So for one question in `EXTREME` all
    numbers are drawn towards the ends of their ranges.
    """

    def __init__(self, rng):
        self._rng, self._dimensions, self._asked = rng, {}, {}
        self._questions, self._is_extreme = 0, False

    def begin(self):
        """Begin a question."""
        self._asked = {}
        self._is_extreme = self._questions % EXTREME == 0
        self._questions += 1

    def __getattr__(self, name):
        return getattr(self._rng, name)

    def uniform(self, low=0.0, high=1.0, size=None):
        """Like the method of numpy's generators, for one number or an array of them."""
        return low + (high - low) * self._numbers((low, high), size)

    def integers(self, low, high=None, size=None):
        """Like the method of numpy's generators, for one number or an array of them."""
        low, high = (0, low) if high is None else (low, high)
        numbers = low + np.floor((high - low) * self._numbers("integers", size))
        return int(numbers) if size is None else numbers.astype(int)

    def choice(self, options, size=None):
        """Like the method of numpy's generators, for one option of a sequence or a row."""
        chosen = self.integers(0, len(options), size)
        return options[chosen] if size is None else np.array([options[k] for k in chosen])

    def _numbers(self, kind, size):
        if size is None:
            return self._number(kind)
        return np.reshape([self._number(kind) for _ in range(np.prod(size))], size)

    def _number(self, kind):
        """The next number in [0, 1) for the dimension that the question has come to."""
        place = self._asked.get(kind, 0)
        self._asked[kind] = place + 1
        dimension = kind, place, self._is_extreme
        if dimension not in self._dimensions:
            self._dimensions[dimension] = _spread(self._rng)
        number = next(self._dimensions[dimension])
        return _towards_an_end(number) if self._is_extreme else number


def _spread(rng):
    """An endless sequence of numbers in [0, 1). Each interval of length 2^-k holds one of the
    first 2^k numbers, so they are spread evenly even if only some of the questions ask for
    them."""
    numbers = rng.uniform(size=1)
    yield from numbers
    while True:
        parts = 2 * len(numbers)
        empty = np.floor(parts * numbers).astype(int) ^ 1
        more = (rng.permutation(empty) + rng.uniform(size=len(empty))) / parts
        yield from more
        numbers = np.concatenate([numbers, more])


def _towards_an_end(number):
    """A number in [0, 1) moved towards 0 or 1: about half of them come within 0.05 of it."""
    if number < 0.5:
        return 4 * number**3
    return min(1 - 4 * (1 - number)**3, BELOW_1)


def count_of(kind):
    """How many fresh questions a group of this kind has."""
    return import_module(f"kinds.{kind}").FRESH


def render(assignment, task, group, seed, count, folder):
    """Make the three films of a group in `folder`; return the report."""
    name = f"{task}.{group}"
    strata = Strata(generator(seed, name))
    draw_question = questions_of(assignment, task).GROUPS[group]

    def draw_spread(rng):
        rng.begin()
        return draw_question(rng)

    return films(name, strata, draw_spread, count, folder)
