"""Draws fresh questions from many seeds, to find out whether marks depend on the draw.

usage: PYTHONPATH=tools/mitsuba:assignments/ray_casting python many_draws.py DIR FIRST LAST
       [TASK.GROUP…]

Writes the films of every seed from FIRST to LAST, of these groups or of all, to
DIR/SEED/probes, for `pinhole validate --draws DIR`. Questions are drawn as `golden.py
fresh-questions` draws them, and tolerances are computed by the same code. But Mitsuba would
need minutes for each seed, so a float64 caster of all rays at once answers instead. Questions
that would not be fair are left out, not drawn again.
"""

import sys
import tomllib
from pathlib import Path

import numpy as np

import film
from camera import Camera
from cast import MISS, Hits
from chance import generator
from face_rounding import _normals
from fresh_questions import Strata, count_of
from kinds import first_hit, intersect, viewing_ray
from question_films import COLUMNS, questions_of
from shapes.plane import PLANE_RADIUS
from shapes.sphere import Sphere
from shapes.triangle import Triangles
from tolerance import F32_RELATIVE, RING, hit_tolerance

ASSIGNMENT = Path(__file__).resolve().parents[2]


def dot(a, b):
    return (a * b).sum(axis=-1)


def first_hits(shapes, starts, directions):
    """t >= 0 and normal where each ray of a row meets the row's shape; NaN at a miss.

    The rays are (N, rays, 3) and relative to the shape's own point.
    """
    with np.errstate(all="ignore"):
        if isinstance(shapes[0], Sphere):
            radius = np.array([shape.radius for shape in shapes])[:, None]
            a, b = dot(directions, directions), dot(starts, directions)
            # Squares that almost cancel are not subtracted.
            nearest = starts - (b / a)[..., None] * directions
            half = np.sqrt((radius**2 - dot(nearest, nearest)) / a)
            near, far = -b / a - half, -b / a + half
            t = np.where(near >= 0, near, np.where(far >= 0, far, np.nan))
            return t, (starts + t[..., None] * directions) / radius[..., None]
        if isinstance(shapes[0], Triangles):
            corners = np.array([shape.corners[0] for shape in shapes])
            e1, e2 = ((corners[:, k] - corners[:, 0])[:, None] for k in (1, 2))
            normal = np.cross(e1, e2)
            down = dot(directions, normal)
            t = -dot(starts, normal) / down
            across = np.cross(starts, directions)
            u, v = dot(e2, across) / -down, dot(e1, across) / down
            is_hit = (t >= 0) & (u >= 0) & (v >= 0) & (u + v <= 1)
        else:
            normal = np.array([shape.normal for shape in shapes])[:, None]
            t = -dot(starts, normal) / dot(directions, normal)
            reach = np.linalg.norm(starts + t[..., None] * directions, axis=-1)
            is_hit = (t >= 0) & (reach <= PLANE_RADIUS)
        normal = normal / np.linalg.norm(normal, axis=-1, keepdims=True)
        return np.where(is_hit, t, np.nan), np.broadcast_to(normal, directions.shape)


def intersect_answers(questions):
    """Like `intersect.Question.answer`, for all questions at once: golden, tolerance, is fair."""
    shapes = [question.shape for question in questions]
    origin = np.array([question.origin - question.shape.point for question in questions])
    direction = np.array([question.direction for question in questions])
    least = np.array([question.min_t for question in questions])
    across = np.cross(direction, np.eye(3)[np.argmin(np.abs(direction), axis=1)])
    upwards = np.cross(across, direction)
    length = np.linalg.norm(direction, axis=1)
    unit = [v / np.linalg.norm(v, axis=1, keepdims=True) for v in (across, upwards)]
    tilts = np.einsum("rk,knc->nrc", RING, unit) * (intersect.TILT * length)[:, None, None]
    still = np.zeros((len(questions), 1, 3))
    directions = direction[:, None] + np.concatenate([still, tilts, still, still], axis=1)
    min_t = least[:, None] * np.array([1.0] * 9 + [1 - intersect.TILT, 1 + intersect.TILT])
    starts = origin[:, None] + min_t[..., None] * directions
    t, normal = first_hits(shapes, starts, directions)
    miss = np.isnan(t)
    t, normal = np.where(miss, 0, t + min_t), np.where(miss[..., None], 0, normal)
    identity = np.where(miss, MISS, 0)
    rays = [
        Hits(identity[:, k], np.zeros(len(t), dtype=int), t[:, k], normal[:, k]) for k in range(11)
    ]
    rounding = np.zeros(len(t))
    if isinstance(shapes[0], Triangles):
        corners = np.array([shape.corners[0] - shape.point for shape in shapes])
        (exact, sharpness), (rounded, _) = map(_normals, (corners, np.float64(np.float32(corners))))
        turned = np.linalg.norm(rounded - exact, axis=1) + 2.0**-22 * sharpness
        rounding = np.where(miss[:, 0], 0, turned)
    start = np.linalg.norm(starts[:, 0], axis=1)
    tolerance, exempt = hit_tolerance(rays[0], rays[1:], rounding, F32_RELATIVE * start / length)
    golden = rays[0].channels()
    blurred = tolerance[:, 1] > intersect.BLURRED * golden[:, 1]
    blurred |= tolerance[:, 2:].max(axis=1) > intersect.BLURRED
    return golden, tolerance, ~exempt & ~(~miss[:, 0] & blurred)


def intersections(thing, direction):
    """Like `first_hit.intersections`."""
    point = thing.point
    start, ray = -point[None, None], direction[None, None]
    found, least = [], 0.0
    while True:
        t, normal = first_hits([thing.moved(-point)], start + least * ray, ray)
        if np.isnan(t[0, 0]):
            return found
        found.append((float(np.float32(least + t[0, 0])), normal[0, 0]))
        least = (1 + first_hit.NEAR_TIE) * found[-1][0]


def nearest(question):
    """Like `first_hit.Question.answer`; None if the question is not fair."""
    hits = [
        (t, k, normal) for k, found in enumerate(question.intersections) for t, normal in found
        if t >= question.min_t
    ]
    t, k, normal = min(hits, key=lambda hit: hit[0], default=(0.0, MISS, np.zeros(3)))
    hits = Hits(np.array([k]), np.zeros(1, dtype=int), np.array([t]), np.array([normal]))
    (golden,), ((tolerance,), _) = hits.channels(), hit_tolerance(hits, [hits])
    if not question._is_fair(golden, tolerance):
        return None
    golden[0] = min(golden[0], 0) if isinstance(question, SOUP) else golden[0]
    return golden, tolerance


def films(task, group, draw_question, seed):
    """The rows of the three films of a group."""
    strata, questions = Strata(generator(seed, f"{task['name']}.{group}")), []
    while len(questions) < count_of(task["kind"]):
        strata.begin()
        question = draw_question(strata)
        questions += [question] if question else []
    if isinstance(questions[0], intersect.Question):
        golden, tolerance, fair = intersect_answers(questions)
        rows = [row for row, ok in zip(zip(questions, golden, tolerance), fair) if ok]
    else:
        rows = [(question, question.answer()) for question in questions]
        rows = [(question, *answer) for question, answer in rows if answer]
    return rows + rows[: -len(rows) % COLUMNS]


def main():
    """Draw and write."""
    out, first, last, *wanted = sys.argv[1:]
    tasks = tomllib.loads((ASSIGNMENT / "assignment.toml").read_text("utf-8"))["task"]
    for seed in range(int(first), int(last) + 1):
        folder = Path(out) / str(seed) / "probes"
        folder.mkdir(parents=True, exist_ok=True)
        for task in tasks:
            for group, draw_question in questions_of(ASSIGNMENT, task["name"]).GROUPS.items():
                name = f"{task['name']}.{group}"
                if wanted and name not in wanted:
                    continue
                questions, golden, tolerance = zip(*films(task, group, draw_question, seed))
                channels = questions[0].answer_channels
                made = {
                    folder / f"{name}.ask.exr":
                        (questions[0].channels, [question.values() for question in questions]),
                    folder / f"{name}.exr": (channels, golden),
                    folder / f"{name}.tol.exr": (channels, tolerance),
                }
                film.write_all(made, (COLUMNS, len(questions) // COLUMNS))


if __name__ == "__main__":
    from kinds import soup

    SOUP = soup.Question
    viewing_ray.golden_rays = Camera.rays
    soup.Question.answer = first_hit.Question.answer = nearest
    import questions.objects

    questions.objects.intersections = intersections
    main()
