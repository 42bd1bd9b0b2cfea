"""TESTS ONLY: what a right submission answers to a task's questions."""

import numpy as np

import float64_caster as caster
from shapes.plane import Plane
from shapes.sphere import Sphere
from shapes.triangle import Triangles


def answers(task, questions):
    """The film of right answers to `questions`, which are {channel: pixels}; `task` is
    its table in assignment.toml."""
    answer = {
        "viewing_ray": _viewing_ray, "intersect": _shape, "first_hit": _first_hit, "soup": _soup,
    }[task["kind"]]
    rows = [dict(zip(questions, row)) for row in zip(*questions.values())]
    return np.array([answer(row) for row in rows])


def _vector(row, name):
    return np.array([row[f"{name}.{axis}"] for axis in "XYZ"])


def _viewing_ray(row):
    vectors = [_vector(row, name) for name in ("eye", "view", "up")]
    numbers = ("width", "height", "focal_length", "n_x", "n_y", "i", "j")
    return np.hstack(caster.camera_rays(*vectors, *(row[name] for name in numbers)))


def _shape(row):
    if "radius" in row:
        thing = Sphere(_vector(row, "center"), row["radius"])
    elif "normal.X" in row:
        thing = Plane(_vector(row, "point"), _vector(row, "normal"))
    else:
        thing = Triangles(np.array([[_vector(row, corner) for corner in "abc"]]))
    ray = _vector(row, "O")[None], _vector(row, "D")[None]
    return caster.cast([thing], *ray, row["min_t"])[0]


def _first_hit(row):
    best = np.array([-1.0, 0, 0, 0, 0])
    for k in range(int(row["count"])):
        for hit in range(int(row[f"{k}.hits"])):
            t = row[f"{k}.{hit}.t"]
            if t >= row["min_t"] and (best[0] < 0 or t < best[1]):
                best = np.array([k, t, *_vector(row, f"{k}.{hit}.N")])
    return best


def _soup(row):
    best = _first_hit(row)
    best[0] = min(best[0], 0.0)
    return best
