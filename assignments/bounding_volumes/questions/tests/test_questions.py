"""The goldens of this assignment's questions agree with exact arithmetic."""

import itertools
import tomllib
from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest

import float64_caster as caster
import judge
from chance import generator
from fresh_questions import Strata
from kinds import tree
from kinds.ray_box import ENDLESS
from kinds.tree_search import ROUNDING
from question_films import draw, questions_of
from random_scenes import render_random
from scene import load

ASSIGNMENT = Path(__file__).parents[2]
TASKS = tomllib.loads((ASSIGNMENT / "assignment.toml").read_text())["task"]
MISS = -1


def drawn(task, group, count=48):
    """Questions of a group, each with golden and tolerance."""
    draw_question = questions_of(ASSIGNMENT, task).GROUPS[group]
    rng = generator(1, f"{task}.{group}")
    return [draw(rng, draw_question) for _ in range(count)]


def groups(task):
    return questions_of(ASSIGNMENT, task).GROUPS


@pytest.mark.parametrize("task", TASKS, ids=lambda task: task["name"])
def test_every_group_with_points_is_drawn_and_no_other(task):
    assert set(groups(task["name"])) == {group for group, *_ in task["points"]}


@pytest.mark.parametrize("group", groups("triangle_box"))
def test_a_box_has_the_smallest_and_greatest_coordinates(group):
    for question, golden, tolerance in drawn("triangle_box", group):
        if question.boxes is None:
            points = question.triangle
        else:
            points = question.boxes.reshape(4, 3)
        assert (golden == [*points.min(axis=0), *points.max(axis=0)]).all()
        assert (tolerance == 0).all()


def exact_entry(question):
    """The t at which a ray enters a box, in exact arithmetic; None if it does not."""
    enter, leave = Fraction(question.min_t), Fraction(question.max_t)
    for axis in range(3):
        low, high, start, along = (
            Fraction(float(value))
            for value in (*question.box[:, axis], question.origin[axis], question.direction[axis])
        )
        if along == 0:
            if not low <= start <= high:
                return None
            continue
        first, last = sorted(((low - start) / along, (high - start) / along))
        enter, leave = max(enter, first), min(leave, last)
    return enter if enter <= leave else None


@pytest.mark.parametrize("group", groups("ray_box"))
def test_a_ray_enters_a_box_where_exact_arithmetic_says(group):
    hits = 0
    for question, golden, tolerance in drawn("ray_box", group):
        t = exact_entry(question)
        assert (t is None) == (golden[0] == MISS)
        if t is not None:
            hits += 1
            assert abs(float(t) - golden[1]) <= tolerance[1]
    assert 8 <= hits
    assert hits <= 44 or group == "inside"


def test_groups_of_rays_and_boxes_ask_what_they_say():
    for question, *_ in drawn("ray_box", "in_face"):
        still = question.direction == 0
        assert (question.box[:, still] == question.origin[still]).any()
    for question, *_ in drawn("ray_box", "flat"):
        assert (question.box[0] == question.box[1]).sum() == 1
    ends = [question.max_t for question, *_ in drawn("ray_box", "max_t")]
    assert max(ends) < ENDLESS
    assert {(q.direction == 0).sum() for q, *_ in drawn("ray_box", "zero_direction")} == {1, 2}


def up_to_middle(places):
    return places <= (places.min() + places.max()) / 2


def in_larger_half(places):
    return np.argsort(np.argsort(places, kind="stable")) < (len(places) + 1) // 2


GOOD_SPLITS = (tree.below_middle, up_to_middle, tree.in_first_half, in_larger_half)


@pytest.mark.parametrize("group", groups("build_tree"))
def test_good_trees_are_accepted_and_chains_are_not(group):
    accepts_chain = []
    for question, golden, (misplaced, depth, leaf, cost) in drawn("build_tree", group):
        assert (golden == 0).all() and misplaced == 0
        for is_first, largest in itertools.product(GOOD_SPLITS, range(1, tree.LARGEST_LEAF + 1)):
            split = tree.split(question.boxes, largest, is_first)
            assert tree.depth(split) <= depth
            assert tree.cost(split, question.boxes) <= cost
        chain = np.arange(1)
        for triangle in range(1, len(question.boxes)):
            chain = chain, np.array([triangle])
        if len(question.boxes) >= 16:
            cheap = tree.cost(chain, question.boxes) <= cost
            accepts_chain.append(cheap and tree.depth(chain) <= depth)
    # The boxes of `crowded` may happen to be listed nearly from the farthest to the nearest.
    assert sum(accepts_chain) <= len(accepts_chain) // 10


def right_search(question):
    """The nearest triangle by asking all of them, without a box."""
    after = [hit for hit in question.hits if hit[1] >= question.min_t]
    return min(after, key=lambda hit: hit[1], default=None)


@pytest.mark.parametrize("group", groups("nearest_hit"))
def test_the_nearest_triangle_of_a_search_is_the_nearest_of_all(group):
    for question, golden, tolerance in drawn("nearest_hit", group, 24):
        nearest = right_search(question)
        assert (nearest is None) == (golden[0] == MISS)
        if nearest is not None:
            triangle, t, normal = nearest
            off = np.abs(golden[:5] - [triangle, t, *normal])
            assert (off <= tolerance[:5]).all()


@pytest.mark.parametrize("group", groups("nearest_hit"))
def test_a_triangle_that_is_met_lies_in_every_box_above_it(group):
    for question, *_ in drawn("nearest_hit", group, 24):
        for triangle, t, _ in question.hits:
            above = boxes_above(question.nodes, 0, triangle)
            assert above and all(entry(node) <= t <= node.far for node in above)


def test_the_shape_of_a_tree_says_nothing_about_the_ray():
    shapes = {
        tuple((node.second, len(node.members)) for node in question.nodes)
        for question, *_ in drawn("nearest_hit", "teapot", 24)
    }
    assert len(shapes) == 1


def entry(node):
    """Where a ray enters a box. A flat one is entered slightly late, as rounding may cause."""
    is_flat = node.near == node.far
    return node.near / (1 + 2 * ROUNDING) if is_flat else node.near


def boxes_above(nodes, place, triangle):
    """The nodes from this one to the leaf of a triangle; none if it is not below."""
    node = nodes[place]
    if not node.second:
        return [node] if 0 <= triangle - node.first < len(node.members) else []
    below = boxes_above(nodes, place + 1, triangle) or boxes_above(nodes, node.second, triangle)
    return [node, *below] if below else []


def test_the_least_number_of_tests_counts_what_every_search_must_test():
    for question, golden, _ in drawn("nearest_hit", "one_leaf"):
        root = question.nodes[0]
        meets = max(root.near, question.min_t) <= root.far
        assert golden[5] == 1 + (len(root.members) if meets else 0)


WITHOUT_BOXES = {"one_leaf", "few", "overlapping"}
"""Groups in which boxes save little, so that a search may do without them."""


@pytest.mark.parametrize("group", groups("nearest_hit"))
def test_a_search_without_boxes_takes_too_many_tests_where_boxes_help(group):
    tests = limit = 0
    for question, golden, tolerance in drawn("nearest_hit", group):
        tests += sum(len(node.members) for node in question.nodes)
        limit += golden[5] + tolerance[5]
    assert (tests > 1.5 * limit) == (group not in WITHOUT_BOXES)


@pytest.mark.parametrize("task", ["triangle_box", "ray_box", "build_tree", "nearest_hit"])
def test_fresh_questions_can_be_drawn(task):
    for group, draw_question in groups(task).items():
        strata = Strata(generator(2, group))
        for _ in range(4):
            strata.begin()
            question = draw_question(strata)
            assert question is None or question.answer() is None or len(question.values())


@pytest.mark.parametrize("seed", (1, 2, 3))
def test_a_right_caster_passes_random_scenes(seed, tmp_path):
    report = render_random(ASSIGNMENT, seed, 0, tmp_path)
    assert all((tmp_path / file).is_file() for file in report["files"])
    scene = load(tmp_path / "scenes" / f"{report['name']}.toml")
    assert any(len(thing.corners) > 1 for thing in scene.objects), "no object needs a tree"
    rays = caster.scene_rays(scene.camera)
    film = caster.cast(scene.objects, *rays, scene.camera.min_t)
    assert judge.failing(film, tmp_path, report["name"]) == 0
