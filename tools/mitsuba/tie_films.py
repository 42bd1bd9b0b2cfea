"""Tie films: questions without answers. Many of the questions are ties.

A tie is a question on the border between two answers: a ray that touches a sphere, a hit
exactly at `min_t`, or two objects at the same t. Goldens contain no ties, because
rounding to float32 can move one to either side. A mutant of the reference that passes all
goldens may still differ from it on ties. `pinhole validate --mutants` gives the questions
of tie films to both, to find out whether ties are the only difference. A tie film is a
question film with one additional channel, `tie`, which is 1 for a tie and 0 for any other
question.

The questions are chosen at random by an assignment's module `questions/ties.py`, if it has
one. Its dictionary TASKS maps names of tasks to functions. Each function chooses one
question with a given random generator, and says whether it is a tie.
"""

import film
from chance import generator
from question_films import questions_of

SIDE = 64
"""How many columns and rows a tie film has."""


def tasks(assignment):
    """By name, the functions for the tasks that have ties, of the assignment in this folder."""
    if not (assignment / "questions" / "ties.py").is_file():
        return {}
    return questions_of(assignment, "ties").TASKS


def render(assignment, task, seed, folder):
    """Write the tie film of a task to `folder`; return its name and files."""
    name = f"{task}.ties"
    rng, draw = generator(seed, name), tasks(assignment)[task]
    drawn = [draw(rng) for _ in range(SIDE * SIDE)]
    question, _ = drawn[0]
    pixels = [[*question.values(), is_tie] for question, is_tie in drawn]
    path = folder / f"{task}.ask.exr"
    film.write_all({path: ((*question.channels, "tie"), pixels)}, (SIDE, SIDE))
    return {"name": name, "files": [f"{folder.name}/{path.name}"]}
