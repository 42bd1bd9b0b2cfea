"""Tie films: questions of which many are exact ties, without answers.

Goldens in float32 cannot judge ties and hold none. `pinhole validate --mutants` asks
these questions to find out whether a mutant that passes all goldens differs from the
reference elsewhere than on ties. A tie film is a question film of one task with one
channel more, `tie`, which is 1 for a tie and 0 for any other question.

The module `questions/ties.py` of an assignment, if it has one, draws them. Its
dictionary TASKS has for some or all tasks a function that draws one question, given a
random generator, and says whether it is a tie.
"""

import film
from chance import generator
from question_films import questions_of

SIDE = 64
"""Columns and rows."""


def tasks(assignment):
    """The tasks of the assignment in this folder that have ties, by name."""
    if not (assignment / "questions" / "ties.py").is_file():
        return {}
    return questions_of(assignment, "ties").TASKS


def render(assignment, task, seed, folder):
    """Make the tie film of a task in `folder`; return the report."""
    name = f"{task}.ties"
    rng, draw = generator(seed, name), tasks(assignment)[task]
    drawn = [draw(rng) for _ in range(SIDE * SIDE)]
    question, _ = drawn[0]
    pixels = [[*question.values(), is_tie] for question, is_tie in drawn]
    path = folder / f"{task}.ask.exr"
    film.write_all({path: ((*question.channels, "tie"), pixels)}, (SIDE, SIDE))
    return {"name": name, "files": [f"{folder.name}/{path.name}"]}
