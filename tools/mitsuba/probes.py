"""Probes: films whose every pixel is a question of its own about one task.

A picture of a scene asks little of a task; a probe asks it alone, from every
side. For a task and a group there are three films of 32 columns: `ask` holds
the questions (float32 values), and beside it lie the golden and its tolerance.
"""

import numpy as np

import film
import probe_first_hit
import probe_plane
import probe_shape
import probe_sphere
import probe_triangle
import probe_viewing_ray

COLUMNS = 32

SHAPES = {"sphere": probe_sphere, "plane": probe_plane, "triangle": probe_triangle}

OBJECTS = {
    "first_hit": (probe_first_hit.first_hit, probe_first_hit.FIRST_HIT_GROUPS),
    "triangle_soup": (probe_first_hit.triangle_soup, probe_first_hit.TRIANGLE_SOUP_GROUPS),
}

PROBES = [
    ("viewing_ray", group) for group in probe_viewing_ray.GROUPS
] + [
    (task, group) for task, shape in SHAPES.items() for group in shape.GROUPS
] + [
    (task, group) for task, (_, groups) in OBJECTS.items() for group in groups
]
"""Every (task, group); the place in this list is part of the seed, so append."""


def question_channels(task):
    """The names of the channels of a task's questions."""
    if task == "viewing_ray":
        return probe_viewing_ray.CHANNELS
    if task in SHAPES:
        return (*probe_shape.RAY_CHANNELS, *SHAPES[task].CHANNELS)
    return probe_first_hit.CHANNELS


def draw(rng, task, group):
    """One question: its values, golden and tolerance; redrawn until it is fair."""
    while True:
        if task == "viewing_ray":
            return probe_viewing_ray.draw(rng, group)
        if task in SHAPES:
            question = SHAPES[task].GROUPS[group](rng)
            answered = probe_shape.answer(question)
            drawn = answered and (question.values(), *answered)
        else:
            drawn = OBJECTS[task][0](rng, group)
        if drawn:
            return drawn


def render(task, group, seed, count, folder):
    """Make the three films of one probe in `folder`; return the report."""
    rng = np.random.default_rng([seed, PROBES.index((task, group))])
    rows = [draw(rng, task, group) for _ in range(count)]
    ask, golden, tolerance = (np.array(columns) for columns in zip(*rows))
    answers = film.RAY_CHANNELS if task == "viewing_ray" else film.HIT_CHANNELS
    name = f"{task}.{group}"
    films = {
        folder / f"{name}.ask.exr": (question_channels(task), ask),
        folder / f"{name}.exr": (answers, golden),
        folder / f"{name}.tol.exr": (answers, tolerance),
    }
    film.write_all(films, (COLUMNS, count // COLUMNS))
    return {
        "name": name,
        "files": [f"{folder.name}/{path.name}" for path in films],
        "exempt": 0,
        "sensor": task == "viewing_ray" and group != "non_square",
    }
