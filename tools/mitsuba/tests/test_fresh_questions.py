"""Fresh questions are spread evenly over what can be drawn."""

import numpy as np

from chance import generator, log_uniform
from fresh_questions import EXTREME, Strata, _towards_an_end
from question_films import questions_of
from test_question_films import assignment


def drawn(count, draw, seed=1, extremes=False):
    """What `draw` draws for `count` ordinary questions, or for the extreme ones among them."""
    strata, questions = Strata(generator(seed, "a name")), []
    for _ in range(count * EXTREME // (EXTREME - 1)):
        strata.begin()
        questions.append(draw(strata))
    extreme = np.arange(len(questions)) % EXTREME == 0
    return np.array(questions)[extreme if extremes else ~extreme]


def strata_met(numbers, parts):
    """In how many of the equal parts of [0, 1) these numbers lie."""
    return len(set(np.floor(parts * numbers).astype(int)))


def test_each_number_of_a_question_meets_every_stratum():
    def draw(rng):
        length = log_uniform(rng, 1e-3, 1e3)
        return np.log(length) / np.log(1e6) + 0.5, rng.uniform(), *rng.uniform(2, 4, 2) / 2 - 1

    for seed in range(5):
        questions = drawn(1024, draw, seed)
        assert [strata_met(numbers, 1024) for numbers in questions.T] == [1024] * 4
        # Each needs an order of its own; otherwise the questions would lie along a diagonal.
        correlation = np.corrcoef(questions.T) - np.eye(4)
        assert np.abs(correlation).max() < 0.2


def test_numbers_that_only_some_questions_ask_for_are_spread_too():
    questions = drawn(1024, lambda rng: rng.uniform(0, 2) / 2 if rng.uniform() < 0.3 else -1)
    asked = questions[questions >= 0]
    assert 300 < len(asked) < 314 and strata_met(asked, 256) == 256


def test_whole_numbers_and_choices_come_equally_often():
    questions = drawn(960, lambda rng: (rng.integers(3, 6), rng.choice((0, 1)), rng.integers(5)))
    for numbers, options in zip(questions.T, ((3, 4, 5), (0, 1), range(5))):
        counts = [int((numbers == option).sum()) for option in options]
        assert sum(counts) == 960 and max(counts) - min(counts) < 100


def test_ordinary_generators_draw_what_these_do(tmp_path):
    draw = questions_of(assignment(tmp_path / "balls", {"ball": ["a"]}), "ball").GROUPS["a"]
    rng, strata = generator(1, "a"), Strata(generator(1, "a"))
    assert draw(rng).channels == draw(strata).channels
    assert rng.choice((-1, 1), 3).shape == strata.choice((-1, 1), 3).shape == (3,)


def test_extreme_questions_have_several_numbers_near_the_ends_of_their_ranges():
    def corners(extremes):
        questions = drawn(1024, lambda rng: rng.uniform(0, 1, 3), extremes=extremes)
        return int((questions > 0.95).all(axis=1).sum())

    assert corners(extremes=False) <= 1 and corners(extremes=True) >= 3


def test_numbers_of_extreme_questions_stay_below_1():
    numbers = [_towards_an_end(number) for number in (0.0, 0.25, 0.5, 1 - 2.0**-30, 1 - 2.0**-53)]
    assert numbers == sorted(numbers) and numbers[0] == 0 and numbers[-1] < 1
