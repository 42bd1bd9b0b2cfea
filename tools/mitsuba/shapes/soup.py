"""The soup: all triangles of a mesh as one object."""

from mesh import read_obj
from shapes.triangle import Triangles


def read(table, folder):
    """The soup of a scene file's table; its mesh lies beside the scene file."""
    return Triangles(read_obj(folder / table["obj"]))
