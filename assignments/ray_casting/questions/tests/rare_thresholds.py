"""Asks whether a draw of fresh questions could miss a mistake that shows now and then.

usage: PYTHONPATH=tools/mitsuba:tools/mitsuba/tests:assignments/ray_casting
       python rare_thresholds.py DIR TASK.GROUP…

DIR is what `many_draws.py` wrote. Each mistake answers wrongly wherever t, the distance to the hit,
the direction's length or min_t is above or below a threshold. The threshold is chosen so that one
in a thousand everyday questions is wrong. Everyday questions are drawn independently, as the
committed ones are. For each mistake this prints how many seeds ask no question that shows it, and
the smallest number of questions of a seed that do.
"""

import sys
from pathlib import Path

import numpy as np

import judge
from chance import generator
from many_draws import ASSIGNMENT, intersect_answers
from question_films import questions_of

RATE = 0.001
EVERYDAY = 20_000
"""How many questions determine a threshold."""


def quantities(t, is_hit, length, min_t):
    """The numbers of each question that a mistake may compare with a threshold; NaN for a miss."""
    t = np.where(is_hit, t, np.nan)
    return {"t": t, "distance": t * length, "|d|": length, "min_t": min_t}


def everyday(group):
    """The quantities of questions that are drawn independently."""
    task, name = group.split(".")
    draw, rng = questions_of(ASSIGNMENT, task).GROUPS[name], generator(99, group)
    questions = [draw(rng) for _ in range(EVERYDAY)]
    golden, _, is_fair = intersect_answers(questions)
    length = np.array([np.linalg.norm(question.direction) for question in questions])
    min_t = np.array([question.min_t for question in questions])
    found = quantities(golden[:, 1], golden[:, 0] >= 0, length, min_t)
    return {name: values[is_fair] for name, values in found.items()}


def drawn(folder, group):
    """The quantities of the fresh questions of each seed."""
    for film in sorted(Path(folder).glob(f"*/probes/{group}.exr")):
        golden, _ = judge.read(film)
        questions, _ = judge.read(film.with_suffix(".ask.exr"))
        length = np.sqrt(sum(questions[f"D.{axis}"].astype(float) ** 2 for axis in "XYZ"))
        yield quantities(golden["t"], golden["id"] >= 0, length, questions["min_t"])


def main():
    """Compare and print."""
    folder, *groups = sys.argv[1:]
    mistakes = missed = 0
    for group in groups:
        seeds = list(drawn(folder, group))
        for name, values in everyday(group).items():
            for sign, word in ((1, "above"), (-1, "below")):
                known = np.sort(sign * values[~np.isnan(values)])
                threshold = known[-1 - int(RATE * len(values))]
                if threshold == known[-1]:
                    continue  # many are equal, so all or none of them lie beyond
                wrong = [int((sign * seed[name] > threshold).sum()) for seed in seeds]
                mistakes, without = mistakes + 1, sum(count == 0 for count in wrong)
                missed += without > 0
                print(f"{group}: {name} {word} {sign * threshold:.3g}: missed by {without} of"
                      f" {len(seeds)} seeds, shown by {min(wrong)} questions at least")
    print(f"{missed} of {mistakes} mistakes are missed by some seed")


if __name__ == "__main__":
    main()
