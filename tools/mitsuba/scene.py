"""A scene file (TOML) as numpy data: a camera and the objects in file order.

Lengths and vectors are float64, in scene units, exactly as in the file; no
vector is normalised here. The Rust code validates scene files in full (line,
column, unknown keys). This module rejects only files from which no correct
golden could be made.
"""

import tomllib
from dataclasses import dataclass
from pathlib import Path

import shapes
from camera import Camera
from shapes import vector


class SceneError(Exception):
    """No golden can be made for a scene. The message is one line, `path: problem`."""


@dataclass(frozen=True)
class Scene:
    """A camera and objects. Pixels that show `objects[k]` have the id k in a film."""

    path: Path
    camera: Camera
    objects: list

    @property
    def name(self):
        """The file's name without its extension. Films of the scene have it too."""
        return self.path.stem


def load(path):
    """Read the scene file at `path`; raise `SceneError` if that fails."""
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
