"""A fingerprint changes with what makes the pixels, and with nothing else."""

import json
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

MITSUBA = Path(__file__).parents[1]

ALL = {"round", "flat", "probes/ball", "probes/floor", "ties"}

FRESH = ALL - {"ties"} | {"random_scenes"}

SCENE = """
[[object]]
type = "sphere"
[[object]]
type = "{other}"
"""
ASSIGNMENT = """
[[task]]
name = "ball"
[[task]]
name = "floor"
"""
BALL = """
from shapes.sphere import Sphere
from questions.both import size
"""
FLOOR = """
from shapes.plane import Plane

def draw(rng):
    return size(rng)
"""
RANDOM_SCENE = """
def objects(rng, view):
    return []
"""
TIES = """
from shapes.plane import Plane
from whole_numbers import Ray
"""


@pytest.fixture
def folder(tmp_path):
    """A copy of the scripts that may be changed, with an assignment and two scenes."""
    shutil.copytree(
        MITSUBA, tmp_path / "mitsuba", ignore=shutil.ignore_patterns(".venv", "tests")
    )
    (tmp_path / "questions").mkdir()
    (tmp_path / "assignment.toml").write_text(ASSIGNMENT)
    (tmp_path / "questions" / "ball.py").write_text(BALL)
    (tmp_path / "questions" / "floor.py").write_text(FLOOR)
    (tmp_path / "questions" / "both.py").write_text("size = 1.0\n")
    (tmp_path / "questions" / "random_scene.py").write_text(RANDOM_SCENE)
    (tmp_path / "questions" / "ties.py").write_text(TIES)
    (tmp_path / "round.toml").write_text(SCENE.format(other="sphere"))
    (tmp_path / "flat.toml").write_text(SCENE.format(other="soup"))
    return tmp_path


def fingerprints(folder, what="--questions"):
    """The fingerprints that the command prints if it can't see any installed package."""
    line = ["round.toml", "flat.toml", what, "."]
    run = subprocess.run(
        [sys.executable, "-I", "-S", "mitsuba/fingerprint.py", *line],
        cwd=folder, capture_output=True, text=True, check=True,
    )
    return json.loads(run.stdout)


def changed(folder, file, old, new, what="--questions", names=ALL):
    """The names of everything whose fingerprint changes with this edit of a file."""
    before, text = fingerprints(folder, what), (folder / file).read_text()
    assert old in text
    (folder / file).write_text(text.replace(old, new))
    after = fingerprints(folder, what)
    assert before.keys() == after.keys() == names
    return {name for name in before if before[name] != after[name]}


@pytest.mark.parametrize("file, old, new", (
    ("mitsuba/camera.py", '"""`vector` at unit length."""', '"""Unit length."""'),
    ("mitsuba/camera.py", '"""`vector` at unit length."""', ""),
    ("mitsuba/camera.py", "  # scene units; None is orthographic", ""),
    ("mitsuba/tolerance.py", "DISPLACEMENT = 1e-3", "DISPLACEMENT = (\n    0.001\n)"),
    ("mitsuba/tolerance.py", '"""The eight directions', '"""Eight directions'),
    ("mitsuba/requirements.txt", "numpy==", "# a comment\n\nnumpy=="),
    ("mitsuba/golden.py", "parser.parse_args()", "parser.parse_args(None)"),
    ("round.toml", "[[object]]", "# a comment\n[[object]]"),
))
def test_words_and_layout_leave_all_goldens_fresh(folder, file, old, new):
    assert changed(folder, file, old, new) == set()


@pytest.mark.parametrize("file, old, new, stale", (
    ("mitsuba/camera.py", "+ 0.5", "+ 0.25", ALL),
    ("mitsuba/requirements.txt", "numpy==", "numpy==9", ALL),
    ("mitsuba/scene_films.py", "displaced = [", "displaced = [] and [", {"round", "flat"}),
    ("mitsuba/shapes/sphere.py", '"sphere"', '"ball"', {"round", "flat", "probes/ball"}),
    ("mitsuba/mesh.py", "k in range(1", "k in range(2", {"flat"}),
    ("questions/floor.py", "size(rng)", "2 * size(rng)", {"probes/floor"}),
    ("questions/both.py", "1.0", "2.0", {"probes/ball"}),
    ("questions/ties.py", "import Ray", "import vector", {"ties"}),
    ("mitsuba/tie_films.py", "SIDE = ", "SIDE = 2 * ", {"ties"}),
    ("mitsuba/whole_numbers.py", "whole(rng, 1, 2)", "whole(rng, 1, 4)", {"ties"}),
))
def test_what_makes_the_pixels_makes_its_own_goldens_stale(folder, file, old, new, stale):
    assert changed(folder, file, old, new) == stale


@pytest.mark.parametrize("file, old, new, stale", (
    ("mitsuba/random_scenes.py", "TRIES = 50", "TRIES = 5", {"random_scenes"}),
    ("questions/random_scene.py", "[]", "[None]", {"random_scenes"}),
    ("mitsuba/fresh_questions.py", "EXTREME = ", "EXTREME = 1 + ", {"probes/ball", "probes/floor"}),
    ("mitsuba/question_films.py", "QUESTIONS = ", "QUESTIONS = 2 * ", FRESH - {"round", "flat"}),
    ("questions/floor.py", "size(rng)", "2 * size(rng)", {"probes/floor"}),
    ("questions/ties.py", "import Ray", "import vector", set()),
))
def test_what_draws_fresh_questions_makes_them_stale(folder, file, old, new, stale):
    assert changed(folder, file, old, new, "--fresh", FRESH) == stale


@pytest.mark.parametrize("file, old, new", (
    ("mitsuba/random_scenes.py", "TRIES = 50", "TRIES = 5"),
    ("mitsuba/fresh_questions.py", "EXTREME = ", "EXTREME = 1 + "),
    ("questions/random_scene.py", "[]", "[None]"),
))
def test_what_draws_fresh_questions_leaves_committed_goldens_fresh(folder, file, old, new):
    assert changed(folder, file, old, new) == set()
