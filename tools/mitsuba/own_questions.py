"""Films of the questions that a student has written, each about a ray and one shape.

They are read from a file of examples (`pinhole examples`) and answered like all questions.
"""

import tomllib
from itertools import chain, cycle, islice

import numpy as np

import shapes
from kinds.intersect import ask
from question_films import COLUMNS, films
from scene import SceneError


def render(path, shape, name, folder):
    """Make the three films of the file's own questions in `folder`; return the report.

    The questions fill the first pixels of the image, from the top row down, in the order of the
    file. To fill the last row, they are repeated.
    """
    with path.open("rb") as file:
        examples = tomllib.load(file)["example"]
    questions = []
    for example in examples:
        if "ray" in example:
            ray, thing = example["ray"], shapes.read({**example["shape"], "type": shape}, None)
            question = ask(thing, ray["e"], ray["d"], ray["min_t"])
            if not np.isfinite(question.values()).all():
                raise SceneError(f"{path}: own ray {len(questions)} has a number beyond float32")
            if not is_kept(thing.values()):
                raise SceneError(f"{path}: own ray {len(questions)} has a number below float32")
            answer = question.answer()
            if answer is None or not np.isfinite(answer).all():
                raise SceneError(f"{path}: own ray {len(questions)} is too close to call")
            questions.append(question)
    folder.mkdir(parents=True, exist_ok=True)
    rows = -(-len(questions) // COLUMNS)
    filled = list(islice(cycle(questions), rows * COLUMNS))
    # The rows of a film are counted from the bottom.
    upwards = [filled[row * COLUMNS:(row + 1) * COLUMNS] for row in reversed(range(rows))]
    return films(name, chain.from_iterable(upwards), next, rows * COLUMNS, folder)


def is_kept(numbers):
    """Whether no number is so small that float32 turns it into 0 or loses its precision."""
    numbers = np.abs(np.asarray(numbers, dtype=float))
    return bool(((numbers == 0) | (numbers >= np.finfo(np.float32).tiny)).all())
