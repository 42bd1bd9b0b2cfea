"""The triangles of a Wavefront OBJ file, from its `v` and `f` lines alone.

We do not use Mitsuba's own loader: the harness reads OBJ with tobj, and the
two would have to agree on every corner case. A mesh here is a list of faces in
file order, each polygon (p0, p1, p2, ..) cut into the fan (p0, p1, p2),
(p0, p2, p3), .. as tobj cuts it; texture coordinates and vertex normals are
ignored, because the normal of a soup is the normal of its face.
"""

import numpy as np


def read_obj(path):
    """Corners of all faces, float64, shape (faces, 3, 3); `ValueError` if none."""
    vertices, faces = [], []
    for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
        word, *rest = line.split("#")[0].split() or [""]
        try:
            if word == "v":
                vertices.append([float(x) for x in rest[:3]])
            elif word == "f":
                polygon = [_index(corner, len(vertices)) for corner in rest]
                faces += [
                    (polygon[0], polygon[k], polygon[k + 1])
                    for k in range(1, len(polygon) - 1)
                ]
        except (ValueError, IndexError) as error:
            raise ValueError(f"{path.name}, line {number}: cannot read {line!r}") from error
    if not faces:
        raise ValueError(f"{path.name} has no faces")
    return np.array(vertices, dtype=np.float64)[np.array(faces)]


def _index(corner, count):
    """`7/1/3` is vertex 7 counted from 1; `-1` is the latest of `count`."""
    index = int(corner.split("/")[0])
    index = index - 1 if index > 0 else count + index
    if not 0 <= index < count:
        raise IndexError(corner)
    return index
