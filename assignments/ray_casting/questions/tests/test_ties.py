"""A question is marked as a tie exactly if it depends on a comparison of equal numbers."""

from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest

import judge
import tie_films

ASSIGNMENT = Path(__file__).parents[2]
TASKS = tie_films.tasks(ASSIGNMENT)


@pytest.fixture(scope="module")
def films(tmp_path_factory):
    """{task: the questions of its tie film, each as {channel: value}}"""
    folder = tmp_path_factory.mktemp("ties")
    films = {}
    for task in TASKS:
        tie_films.render(ASSIGNMENT, task, 1, folder)
        film, _ = judge.read(folder / f"{task}.ask.exr")
        rows = zip(*film.values())
        films[task] = [dict(zip(film, map(Fraction.from_float, map(float, row)))) for row in rows]
    return films


@pytest.mark.parametrize("task", TASKS)
def test_ties_are_many_but_fewer_than_other_questions(films, task):
    ties = sum(row["tie"] for row in films[task])
    assert 100 < ties < len(films[task]) / 2


@pytest.mark.parametrize("task", TASKS)
def test_every_value_is_whole_or_in_quarters(films, task):
    values = {value for row in films[task] for value in row.values()}
    assert all(4 % value.denominator == 0 and abs(value) <= 8 for value in values)


@pytest.mark.parametrize("task", TASKS)
def test_a_question_is_a_tie_exactly_if_the_geometry_says_so(films, task):
    is_tie = {
        "sphere": sphere, "plane": plane, "triangle": triangle,
        "triangle_soup": objects, "first_hit": objects,
    }[task]
    assert [row for row in films[task] if bool(row["tie"]) != is_tie(row)] == []


def vector(row, name):
    return np.array([row[f"{name}.{axis}"] for axis in "XYZ"])


def sphere(row):
    from_center, d = vector(row, "O") - vector(row, "center"), vector(row, "D")
    moment = np.cross(from_center, d)
    tangent = moment @ moment == row["radius"] ** 2 * (d @ d)
    at_min_t = from_center + row["min_t"] * d
    return tangent or at_min_t @ at_min_t == row["radius"] ** 2


def met(row, point, normal):
    """The t at which the ray meets a plane; None if it is parallel."""
    along = vector(row, "D") @ normal
    return (point - vector(row, "O")) @ normal / along if along else None


def plane(row):
    return met(row, vector(row, "point"), vector(row, "normal")) == row["min_t"]


def triangle(row):
    corners = [vector(row, corner) for corner in "abc"]
    a, b, c = corners
    normal = np.cross(b - a, c - a)
    t = met(row, a, normal)
    if t is None:
        return False
    at = vector(row, "O") + t * vector(row, "D")
    edges = zip(corners, (b, c, a))
    on_edge = any(not np.cross(end - start, at - start).any() for start, end in edges)
    return on_edge or t == row["min_t"]


def objects(row):
    all_ts = [
        [row[f"{k}.{n}.t"] for n in range(int(row[f"{k}.hits"]))] for k in range(int(row["count"]))
    ]
    firsts = sorted(min(ts) for ts in ([t for t in ts if t >= row["min_t"]] for ts in all_ts) if ts)
    return len(firsts) > 1 and firsts[0] == firsts[1]
