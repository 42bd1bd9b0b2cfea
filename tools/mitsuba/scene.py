"""A scene file (TOML) as numpy data: a camera and the objects in file order.

Everything is float64 and in scene units, as written; no vector is normalised
here. The Rust side owns the full validation of scene files (line, column,
unknown keys); this reader only refuses what would make a golden meaningless.
"""

import tomllib
from dataclasses import dataclass
from pathlib import Path

import shapes
from camera import Camera
from shapes import vector


class SceneError(Exception):
    """A scene that gets no golden. Its text is one line, `path: problem`."""


@dataclass(frozen=True)
class Scene:
    """`objects[k]` is the object whose id in a film is k."""

    path: Path
    camera: Camera
    objects: list

    @property
    def name(self):
        """The name its films carry."""
        return self.path.stem


def load(path):
    """Read the scene file at `path`; raise `SceneError` when it is unusable."""
    path = Path(path)
    try:
        table = tomllib.loads(path.read_text(encoding="utf-8"))
        camera = _camera(table["camera"])
        objects = [shapes.read(entry, path.parent) for entry in table.get("object", [])]
    except KeyError as error:
        raise SceneError(f"{path}: the key {error} is missing") from error
    except (OSError, ValueError) as error:  # a TOML error is a ValueError
        problem = f"cannot read {error.filename}" if isinstance(error, OSError) else error
        raise SceneError(f"{path}: {problem}") from error
    return Scene(path, camera, objects)


def _camera(table):
    perspective = {"perspective": True, "orthographic": False}.get(table["projection"])
    if perspective is None:
        raise ValueError(f"unknown projection {table['projection']!r}")
    return Camera(
        eye=vector(table["eye"]),
        view=vector(table["view"]),
        up=vector(table["up"]),
        width=float(table["width"]),
        height=float(table["height"]),
        focal_length=float(table["focal_length"]) if perspective else None,
        resolution=tuple(int(n) for n in table["resolution"]),
        min_t=float(table.get("min_t", 1.0 if perspective else 0.0)),
    )
