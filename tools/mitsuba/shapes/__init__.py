"""The shapes of objects: one file for each `type` of a scene file.

Each file has a function `read(table, folder)`, which makes an object from a scene
file's `[[object]]` table, and the object has a method `to_mitsuba()`, which gives
what Mitsuba loads. A shape that questions of the kind `intersect` are asked about
has these too: the names of its `CHANNELS` in a question film, `values()` and
`from_values()`, which take it there and back, and `point` and `moved()`, which move
the origin of space to it.

Mitsuba computes in float32 ("scalar_rgb" is the wheel's only variant whose
sphere solves its quadratic in float64; there is none in double precision), so
the data are rounded once, in `to_mitsuba`, and never again.
"""

from importlib import import_module

import mitsuba as mi
import numpy as np

mi.set_variant("scalar_rgb")
mi.set_log_level(mi.LogLevel.Error)  # stdout belongs to golden.py


def read(table, folder):
    """The object of a scene file's table; `ValueError` if no shape has its type.

    Shapes are found by name, not listed, so that adding one changes no file that the
    goldens of the others depend on.
    """
    module = f"shapes.{table['type']}"
    try:
        shape = import_module(module)
    except ModuleNotFoundError as error:
        if error.name != module:
            raise
        raise ValueError(f"unknown object type {table['type']!r}") from error
    return shape.read(table, folder)


def to_mitsuba(objects):
    """A Mitsuba scene in which the shape of `objects[k]` has the id `str(k)`."""
    described = {str(k): thing.to_mitsuba() for k, thing in enumerate(objects)}
    return mi.load_dict({"type": "scene", **described})


def vector(values):
    """Three finite numbers of a TOML file, float64; `ValueError` for anything else."""
    array = np.array(values, dtype=np.float64)
    if array.shape != (3,) or not np.isfinite(array).all():
        raise ValueError(f"{values} is not a vector of three finite numbers")
    return array
