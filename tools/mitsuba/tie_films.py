"""Tie films: questions of which many are exact ties, without answers.

A tie is a question that lies exactly on a limit: a ray that touches a sphere, a hit
exactly at `min_t`, or two objects at the same t. Goldens have float32 values, which can't
tell on which side a tie lies, so they contain none. `pinhole validate --mutants` asks the
questions of tie films. They show whether a mutant that passes all goldens differs from
the reference only on ties. A tie film is a question film with one additional channel,
`tie`, which is 1 for a tie and 0 for any other question.

The questions are drawn by the module `questions/ties.py` of an assignment, if it has
one. Its dictionary TASKS maps names of tasks to functions. Each function draws one
question with a given random generator, and says whether it is a tie.
"""

import film
from chance import generator
from question_films import questions_of

SIDE = 64
"""How many columns and rows a tie film has."""


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
