"""Random scenes: fresh goldens nobody has seen, with every shape in view.

The scene is drawn in the camera's frame (right, up, towards the eye), where "in
view" is easy, and written in the coordinates of space, rounded to four digits.
"""

import numpy as np

from camera import normalize
from chance import log_uniform, perpendicular, sign, unit_vector
from probe_triangle import corners
from scene import SceneError
from scene_films import render

RESOLUTION = (120, 80)
TRIES = 50


def render_random(seed, index, folder):
    """Draw scene `index` of `seed` until it is not refused; films and report."""
    rng = np.random.default_rng([seed, index])
    scenes = folder / "scenes"
    scenes.mkdir(exist_ok=True)
    path = scenes / f"random_{seed}_{index}.toml"
    for _ in range(TRIES):
        path.write_text(_toml(rng, seed, index), encoding="utf-8")
        try:
            report = render(path, folder)
        except SceneError as error:
            problem = error
            continue
        return report | {"files": [*report["files"], f"scenes/{path.name}"]}
    path.unlink()
    raise SceneError(f"{path}: refused {TRIES} times, last: {problem}")


def _toml(rng, seed, index):
    """The text of a scene."""
    view, eye = unit_vector(rng), rng.uniform(-3, 3, 3)
    up = normalize(perpendicular(rng, view) + rng.uniform(-0.5, 0.5) * view)
    right = normalize(np.cross(view, up))
    frame = np.array([right, np.cross(right, view), -view])
    perspective = rng.uniform() < 0.75
    focal_length = rng.uniform(0.5, 2)
    pixel = round((focal_length if perspective else 5.0) * rng.uniform(0.007, 0.012), 4)
    tall = pixel if rng.uniform() < 0.7 else round(pixel * rng.uniform(0.7, 1.4), 4)
    width, height = RESOLUTION[0] * pixel, RESOLUTION[1] * tall
    lines = [
        f"# Random scene {index} of seed {seed}: made by tools/mitsuba/golden.py, not by hand.",
        "[camera]",
        f'projection = "{"perspective" if perspective else "orthographic"}"',
        f"eye = {_vector(eye)}",
        f"view = {_vector(view * rng.uniform(0.5, 2))}",
        f"up = {_vector(up * rng.uniform(0.5, 2))}",
        *([f"focal_length = {focal_length:.4f}"] if perspective else []),
        f"width = {width:.4f}",
        f"height = {height:.4f}",
        f"resolution = [{RESOLUTION[0]}, {RESOLUTION[1]}]",
    ]

    def in_view(depth, spread):
        """A point `depth` before the eye, within `spread` half widths of the axis."""
        reach = 0.5 * spread * (depth / focal_length if perspective else 1)
        offset = rng.uniform(-reach, reach, 2) * (width, height)
        return eye + np.array([*offset, -depth]) @ frame

    for thing in rng.permutation(["sphere"] * 4 + ["plane"] + ["triangle"] * 4):
        depth = rng.uniform(2.5, 8)
        lines += ["", "[[object]]", f'type = "{thing}"']
        if thing == "sphere":
            lines += [
                f"center = {_vector(in_view(depth, 0.9))}",
                f"radius = {log_uniform(rng, 0.1, 0.2 * depth):.4f}",
            ]
        elif thing == "plane":  # behind the rest, and tilted less than the view is wide
            normal = sign(rng) * (normalize(frame[2] + 0.3 * unit_vector(rng)))
            lines += [
                f"point = {_vector(in_view(rng.uniform(6, 10), 0.5))}",
                f"normal = {_vector(normal * log_uniform(rng, 0.2, 5))}",
            ]
        else:
            shape = in_view(depth, 0.7) + corners(rng, rng.uniform(0.5, 2.5), rng.uniform(0.8, 3))
            lines.append(f"corners = [{', '.join(_vector(corner) for corner in shape)}]")
    return "\n".join(lines) + "\n"


def _vector(values):
    """A TOML array, each number to four decimals."""
    return "[" + ", ".join(f"{x:.4f}" for x in values) + "]"
