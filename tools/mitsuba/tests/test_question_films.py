"""Questions of a small assignment that no script in this folder's parent knows."""

import numpy as np
import pytest

import judge
from test_command import digests, golden

TASK = """
[[task]]
name = "{name}"
"""

QUESTIONS = """
from chance import unit_vector
from kinds.intersect import ask
from shapes.sphere import Sphere


def towards(rng):
    center = rng.uniform(-1, 1, 3)
    return ask(Sphere(center, rng.uniform(0.5, 1)), center - 3 * (d := unit_vector(rng)), d, 0)


GROUPS = {groups}
"""

RANDOM_SCENE = """
def objects(rng, view):
    return [{"type": "sphere", "center": view.point(rng, 4, 0.5), "radius": rng.uniform(0.2, 1)}]
"""


def assignment(folder, tasks):
    """An assignment with these tasks and their groups, all of which are drawn alike."""
    (folder / "questions").mkdir(parents=True)
    (folder / "assignment.toml").write_text("".join(TASK.format(name=name) for name in tasks))
    (folder / "questions" / "random_scene.py").write_text(RANDOM_SCENE)
    for name, groups in tasks.items():
        table = "{" + ", ".join(f"{group!r}: towards" for group in groups) + "}"
        (folder / "questions" / f"{name}.py").write_text(QUESTIONS.replace("{groups}", table))
    return folder


def ask(folder, out, seed=4):
    """The hashes of the films of a small assignment's questions."""
    code, lines, errors = golden(
        "questions", folder, "--seed", seed, "--count", 32, "--out", out
    )
    assert (code, errors) == (0, "")
    films = digests(out)
    files = [name for line in lines[1:] for name in line["files"]]
    assert len(files) == len(set(files)) == 3 * lines[0]["total"]
    assert {path.as_posix() for path in films} == set(files)
    return films


def test_the_same_seed_makes_the_same_films_and_another_others(tmp_path):
    balls = assignment(tmp_path / "balls", {"ball": ["a", "b"]})
    one, two, other = (
        ask(balls, tmp_path / out, seed) for out, seed in (("one", 4), ("two", 4), ("other", 5))
    )
    assert one == two
    questions = [path for path in one if ".ask." in path.name]
    assert questions and all(one[path] != other[path] for path in questions)


def test_a_group_alone_has_the_films_it_has_among_others(tmp_path):
    alone = ask(assignment(tmp_path / "few", {"ball": ["b"]}), tmp_path / "alone")
    many = {"apple": ["b"], "ball": ["a", "b", "c"], "cherry": ["a"]}
    among = ask(assignment(tmp_path / "many", many), tmp_path / "among")
    assert len(alone) == 3 and len(among) == 15
    assert alone.items() <= among.items()


def test_groups_that_are_drawn_alike_ask_different_questions(tmp_path):
    films = ask(assignment(tmp_path / "fruit", {"apple": ["a", "b"], "ball": ["a"]}), tmp_path)
    questions = [films[path] for path in films if ".ask." in path.name]
    assert len(set(questions)) == 3


TIES = """
from shapes.sphere import Sphere
from whole_numbers import Ray, vector


def starts_in_the_middle(rng):
    center, ray = vector(rng), Ray.draw(rng)
    return ray.ask(Sphere(center, 1)), not (ray.origin - center).any()


TASKS = {"ball": starts_in_the_middle}
"""


def test_a_tie_film_holds_the_same_questions_each_time_and_says_which_are_ties(tmp_path):
    folder = assignment(tmp_path / "balls", {"ball": ["a"]})
    (folder / "questions" / "ties.py").write_text(TIES)
    for out in ("one", "two"):
        code, lines, errors = golden("ties", folder, "--seed", 4, "--out", tmp_path / out)
        assert (code, errors) == (0, "")
        assert lines[1:] == [{"name": "ball.ties", "files": ["ties/ball.ask.exr"]}]
    assert digests(tmp_path / "one") == digests(tmp_path / "two")
    film, _ = judge.read(tmp_path / "one" / "ties" / "ball.ask.exr")
    in_the_middle = np.all([film[f"O.{axis}"] == film[f"center.{axis}"] for axis in "XYZ"], axis=0)
    assert in_the_middle.any() and (film["tie"] == in_the_middle).all()


def test_an_assignment_without_ties_has_no_tie_films(tmp_path):
    folder = assignment(tmp_path / "balls", {"ball": ["a"]})
    code, lines, errors = golden("ties", folder, "--seed", 4, "--out", tmp_path / "out")
    assert (code, errors, lines[0]["total"]) == (0, "", 0)
    assert not list((tmp_path / "out").iterdir())


@pytest.mark.parametrize("count", (1, 2))
def test_a_random_scene_depends_on_its_name_alone(count, tmp_path):
    folder = assignment(tmp_path / "balls", {"ball": ["a"]})
    films = []
    for scenes in (count, 3):
        out = tmp_path / str(scenes)
        line = ("random-scenes", folder, "--seed", 4, "--count", scenes, "--out", out)
        code, lines, errors = golden(*line)
        assert (code, errors) == (0, "") and lines[0]["total"] == scenes
        films.append(digests(out))
    assert len(films[0]) == 4 * count and films[0].items() <= films[1].items()
    assert len(set(films[1].values())) > 6
