"""Question films: films whose every pixel is a question of its own about one task.

A picture of a scene tests a task only a little. A task's questions test it alone, and
in every case. For each group of a task's questions there are three films of 32 columns: `ask`
holds the questions (float32 values), and beside it lie the golden and its tolerance.

A task's questions are drawn by the module of its name in the folder `questions` of
the assignment. Its dictionary GROUPS has for each group a function that draws one
question, given a random generator: a `Question` of one of `kinds`, or None to be
called again.
"""

import sys
from importlib import import_module

import numpy as np

import film
from chance import generator

COLUMNS = 32

QUESTIONS = 512
"""The default number of questions in a group."""


def questions_of(assignment, name):
    """The module `questions/NAME.py` of the assignment in this folder."""
    if str(assignment) not in sys.path:
        sys.path.insert(0, str(assignment))
    return import_module(f"questions.{name}")


def draw(rng, draw_question):
    """One question with its golden and tolerance; redrawn until it is fair."""
    while True:
        question = draw_question(rng)
        answer = question and question.answer()
        if answer:
            return question, *answer


def render(assignment, task, group, seed, count, folder):
    """Make the three films of a group in `folder`; return the report."""
    name = f"{task}.{group}"
    draw_question = questions_of(assignment, task).GROUPS[group]
    return films(name, generator(seed, name), draw_question, count, folder)


def films(name, rng, draw_question, count, folder):
    """Draw questions and make their three films in `folder`; return the report."""
    rows = [draw(rng, draw_question) for _ in range(count)]
    questions, golden, tolerance = zip(*rows)
    channels, answer_channels = questions[0].channels, questions[0].answer_channels
    made = {
        folder / f"{name}.ask.exr": (channels, [question.values() for question in questions]),
        folder / f"{name}.exr": (answer_channels, golden),
        folder / f"{name}.tol.exr": (answer_channels, tolerance),
    }
    film.write_all(made, (COLUMNS, count // COLUMNS))
    return {"name": name, "files": [f"{folder.name}/{path.name}" for path in made]}
