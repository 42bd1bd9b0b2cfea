"""OBJ files as triangles, in the order and with the corners tobj gives them."""

import numpy as np
import pytest

from mesh import read_obj

SQUARE = "v 0 0 0\nv 1 0 0 # right\nv 1 1 0\nv 0 1 0\n"


def obj(folder, text):
    """The triangles of this text."""
    path = folder / "mesh.obj"
    path.write_text(text)
    return read_obj(path)


def test_a_polygon_becomes_a_fan_around_its_first_corner(tmp_path):
    a, b, c, d = [0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]
    np.testing.assert_array_equal(obj(tmp_path, SQUARE + "f 1 2 3 4"), [[a, b, c], [a, c, d]])


def test_slashes_and_negative_indices_name_the_same_corners(tmp_path):
    plain = obj(tmp_path, SQUARE + "f 1 2 4")
    np.testing.assert_array_equal(obj(tmp_path, SQUARE + "f 1/9/9 2//3 -1"), plain)


@pytest.mark.parametrize("line", ("f 1 2 5", "f 1 2 0", "f 1 2 x", "v 1 2 high"))
def test_an_unreadable_line_is_named(line, tmp_path):
    with pytest.raises(ValueError, match="mesh.obj, line 5"):
        obj(tmp_path, SQUARE + line + "\nf 1 2 3")


def test_a_mesh_without_faces_is_refused(tmp_path):
    with pytest.raises(ValueError, match="no faces"):
        obj(tmp_path, SQUARE)
