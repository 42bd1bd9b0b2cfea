"""Random scenes: fresh goldens that nobody has seen before.

The camera is drawn here. The objects come from the assignment: the function
`objects(rng, view)` in its `questions/random_scene.py` gives the tables of a scene
file's objects. The table of a soup holds `triangles`, shape (n, 3, 3), which become a mesh
beside the scene file. Numbers are written to four decimals.
"""

from dataclasses import dataclass

import numpy as np

from camera import normalize
from cast import MISS, cast
from chance import generator, perpendicular, unit_vector
from question_films import questions_of
from scene import SceneError, load
from scene_films import render
from shapes import to_mitsuba

RESOLUTION = (120, 80)
TRIES = 50


@dataclass(frozen=True)
class View:
    """What the camera sees, for the code that places objects."""

    eye: np.ndarray
    frame: np.ndarray  # rows: right, up, towards the eye; unit
    size: np.ndarray  # width and height of the image plane, scene units
    focal_length: float | None  # scene units; None is orthographic

    def point(self, rng, depth, spread):
        """A point `depth` in front of the eye, within `spread` half widths of the axis."""
        reach = 0.5 * spread * (depth / self.focal_length if self.focal_length else 1)
        offset = rng.uniform(-reach, reach, 2) * self.size
        return self.eye + np.array([*offset, -depth]) @ self.frame


def render_random(assignment, seed, index, folder):
    """Draw scene `index` of `seed` until it shows every shape and is not refused; films
    and report."""
    # Students see the name, and must not learn the seed from it.
    name = f"random_{index}"
    rng = generator(seed, f"random_{seed}_{index}")
    scenes = folder / "scenes"
    scenes.mkdir(exist_ok=True)
    path = scenes / f"{name}.toml"
    draw_objects = questions_of(assignment, "random_scene").objects
    for _ in range(TRIES):
        camera, view = _camera(rng)
        objects = draw_objects(rng, view)
        meshes = [table for table in objects if "triangles" in table]
        for k, table in enumerate(meshes):
            table["obj"] = f"{name}_{k}.obj"
            (scenes / table["obj"]).write_text(_obj(table.pop("triangles")), encoding="utf-8")
        tables = [("[camera]", camera), *(("[[object]]", table) for table in objects)]
        head = f"# Random scene {index}: made by tools/mitsuba/golden.py, not by hand."
        path.write_text("\n\n".join([head, *map(_toml, tables)]) + "\n", encoding="utf-8")
        try:
            _require_every_shape(load(path))
            report = render(path, folder)
        except SceneError as error:
            problem = error
            continue
        files = [path.name, *(table["obj"] for table in meshes)]
        return report | {"files": [*report["files"], *(f"scenes/{file}" for file in files)]}
    path.unlink()
    raise SceneError(f"{path}: refused {TRIES} times, last: {problem}")


def _require_every_shape(scene):
    """Raise `SceneError` unless every shape is seen, looking at every seventh pixel."""
    i, j = scene.camera.pixels()
    rays = scene.camera.rays(i[::7], j[::7])
    seen = set(cast(to_mitsuba(scene.objects), *rays, scene.camera.min_t).id) - {MISS}
    if {type(scene.objects[k]) for k in seen} != {type(thing) for thing in scene.objects}:
        raise SceneError(f"{scene.path}: a shape is not in view")


def _camera(rng):
    """A camera as a scene file's table, and what it sees."""
    view, eye = unit_vector(rng), rng.uniform(-3, 3, 3)
    up = normalize(perpendicular(rng, view) + rng.uniform(-0.5, 0.5) * view)
    right = normalize(np.cross(view, up))
    focal_length = rng.uniform(0.5, 2) if rng.uniform() < 0.75 else None
    pixel = round((focal_length or 5.0) * rng.uniform(0.007, 0.012), 4)
    tall = pixel if rng.uniform() < 0.7 else round(pixel * rng.uniform(0.7, 1.4), 4)
    size = np.array(RESOLUTION) * (pixel, tall)
    table = {
        "projection": "perspective" if focal_length else "orthographic",
        "eye": eye,
        "view": view * rng.uniform(0.5, 2),
        "up": up * rng.uniform(0.5, 2),
        **({"focal_length": focal_length} if focal_length else {}),
        "width": size[0],
        "height": size[1],
        "resolution": list(RESOLUTION),
    }
    return table, View(eye, np.array([right, np.cross(right, view), -view]), size, focal_length)


def _toml(table):
    """A table of a scene file: its head, and a line for each key."""
    head, entries = table
    return "\n".join([head, *(f"{key} = {_value(value)}" for key, value in entries.items())])


def _value(value):
    if isinstance(value, str):
        return f'"{value}"'
    if isinstance(value, int):
        return str(value)
    if np.ndim(value) == 0:
        return f"{value:.4f}"
    return "[" + ", ".join(map(_value, value)) + "]"


def _obj(triangles):
    """A mesh file of triangles that share no vertex."""
    vertices = ["v " + " ".join(map(_value, vertex)) for vertex in triangles.reshape(-1, 3)]
    faces = [f"f {k} {k + 1} {k + 2}" for k in range(1, len(vertices), 3)]
    return "\n".join(vertices + faces) + "\n"
