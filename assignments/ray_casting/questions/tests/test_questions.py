"""A right float64 caster passes every golden of this assignment's questions."""

import tomllib
from pathlib import Path

import numpy as np
import pytest

import float64_caster as caster
import fresh_questions
import judge
import right_answers
from question_films import questions_of, render
from random_scenes import render_random
from scene import load

ASSIGNMENT = Path(__file__).parents[2]
TASKS = {
    task["name"]: task
    for task in tomllib.loads((ASSIGNMENT / "assignment.toml").read_text())["task"]
}
GROUPS = [(task, group) for task in TASKS for group in questions_of(ASSIGNMENT, task).GROUPS]
SEEDS = (1, 2, 3)


@pytest.mark.parametrize("task", TASKS)
def test_every_group_with_points_is_drawn_and_no_other(task):
    with_points = {group for group, *_ in TASKS[task]["points"]} - {"scenes"}
    assert set(questions_of(ASSIGNMENT, task).GROUPS) == with_points


@pytest.mark.parametrize("task, group", GROUPS)
def test_a_right_caster_passes_every_group(task, group, tmp_path):
    for seed, draw in zip(SEEDS, (render, render, fresh_questions.render)):
        draw(ASSIGNMENT, task, group, seed, 64, tmp_path)
        questions, _ = judge.read(tmp_path / f"{task}.{group}.ask.exr")
        answers = right_answers.answers(TASKS[task], questions)
        assert judge.failing(answers, tmp_path, f"{task}.{group}") == 0, f"seed {seed}"


@pytest.mark.parametrize("task, group", GROUPS)
def test_no_question_is_exempt(task, group, tmp_path):
    render(ASSIGNMENT, task, group, 1, 32, tmp_path)
    golden, _ = judge.read(tmp_path / f"{task}.{group}.exr")
    tolerance, _ = judge.read(tmp_path / f"{task}.{group}.tol.exr")
    if "O.X" in golden:
        assert all((tolerance[c] < 0.1).all() for c in tolerance)
    else:
        hit = golden["id"] >= 0
        assert (tolerance["id"] == 0.25).all()
        assert (tolerance["t"][hit] < 0.02 * golden["t"][hit]).all()
        assert all((tolerance[c][hit] < 0.02).all() for c in ("N.X", "N.Y", "N.Z"))


@pytest.mark.parametrize("bound", (1e-4, 1e-8, 1e-12))
def test_some_ray_below_any_angle_meets_its_plane(bound, tmp_path):
    render(ASSIGNMENT, "plane", "parallel", 1, 256, tmp_path)
    asked, _ = judge.read(tmp_path / "plane.parallel.ask.exr")
    golden, _ = judge.read(tmp_path / "plane.parallel.exr")
    d, n = (
        np.column_stack([asked[f"{name}.{axis}"] for axis in "XYZ"]).astype(float)
        for name in ("D", "normal")
    )
    sine = abs((d * n).sum(axis=1)) / np.linalg.norm(d, axis=1) / np.linalg.norm(n, axis=1)
    assert (sine[golden["id"] >= 0] < bound).any()


@pytest.mark.parametrize(
    "task, group",
    (("plane", "direction_length"), ("first_hit", "min_t"), ("triangle_soup", "min_t")),
)
def test_some_hits_are_barely_beyond_min_t(task, group, tmp_path):
    render(ASSIGNMENT, task, group, 1, 256, tmp_path)
    asked, _ = judge.read(tmp_path / f"{task}.{group}.ask.exr")
    golden, _ = judge.read(tmp_path / f"{task}.{group}.exr")
    assert ((golden["id"] >= 0) & (golden["t"] - asked["min_t"] < 1e-3)).sum() > 4


@pytest.mark.parametrize("seed", SEEDS)
def test_a_right_caster_passes_random_scenes(seed, tmp_path):
    for index in range(3):
        name = render_random(ASSIGNMENT, seed, index, tmp_path)["name"]
        scene = load(tmp_path / "scenes" / f"{name}.toml")
        rays = caster.scene_rays(scene.camera)
        film = caster.cast(scene.objects, *rays, scene.camera.min_t)
        seen = {type(scene.objects[int(k)]) for k in film[:, 0] if k >= 0}
        assert len(seen) == 3, "a shape is not in view"
        assert judge.failing(film, tmp_path, name) == 0
        assert judge.failing(np.hstack(rays), tmp_path, f"{name}.rays") == 0
