"""Scenes that must not become goldens."""

import numpy as np
import pytest

from camera import Camera
from refusal import edge_distances
from scene import SceneError
from scene_films import render

CAMERA = """
[camera]
projection = "perspective"
eye = [{x}, {height}, 3.0]
view = [0.0, {slope}, -1.0]
up = [0.0, 1.0, 0.0]
focal_length = 1.0
width = 1.0
height = 1.0
resolution = [{n}, {n}]
"""
TRIANGLE = """
[[object]]
type = "triangle"
corners = [[0.0, -0.3, 0.0], [0.0, 0.35, 0.0], [-0.9, 0.1, 0.1]]
"""
QUAD = """
[[object]]
type = "soup"
obj = "quad.obj"
"""
FLOOR = """
[[object]]
type = "plane"
point = [0.0, 0.0, 0.0]
normal = [0.0, 1.0, 0.0]
"""


def scene(folder, objects, *, x=0.0, height=0.0, slope=0.0, n=31):
    """A scene file. If n is odd, the middle column of pixels looks along the plane of this x."""
    (folder / "quad.obj").write_text(
        "v -1 -1 0\nv 0 -1 0\nv 1 -1 0\nv 1 1 0\nv 0 1 0\nv -1 1 0\nf 1 2 5 6\nf 2 3 4 5\n"
    )
    path = folder / "scene.toml"
    path.write_text(CAMERA.format(x=x, height=height, slope=slope, n=n) + objects)
    return path


def refused(path):
    """The message of the refusal; no films may be left."""
    with pytest.raises(SceneError) as refusal:
        render(path, path.parent)
    assert not list(path.parent.glob("*.exr"))
    assert "shift the camera a little" in str(refusal.value)
    assert str(path) in str(refusal.value)
    return str(refusal.value)


@pytest.mark.parametrize("objects", (TRIANGLE, QUAD))
def test_an_edge_through_a_pixel_centre_is_refused(objects, tmp_path):
    assert "pixel (15, " in refused(scene(tmp_path, objects))


@pytest.mark.parametrize("objects", (TRIANGLE, QUAD))
def test_an_edge_beside_a_pixel_centre_is_accepted(objects, tmp_path):
    render(scene(tmp_path, objects, x=0.0123), tmp_path)


def test_the_pixel_of_a_refusal_is_counted_from_the_bottom(tmp_path):
    path = scene(tmp_path, TRIANGLE, x=-0.2, n=1)
    text = path.read_text().replace("resolution = [1, 1]", "resolution = [1, 3]")
    path.write_text(text.replace("[0.0, -0.3, 0.0]", "[0.0, 0.7, 0.0]").replace(
        "[0.0, 0.35, 0.0]", "[0.0, 1.4, 0.0]").replace("[-0.9, 0.1, 0.1]", "[-0.2, 1.0, 0.0]"))
    assert "pixel (0, 2)" in refused(path)


def test_a_hit_far_out_on_the_disk_is_refused(tmp_path):
    # The middle row looks down by 5e-6: it meets the floor 200,000 away.
    assert "horizon" in refused(scene(tmp_path, FLOOR, height=1.0, slope=-5e-6))


def test_a_row_of_pixels_along_the_horizon_is_refused(tmp_path):
    assert "horizon" in refused(scene(tmp_path, FLOOR, height=1.0))


def test_a_horizon_between_two_rows_is_accepted(tmp_path):
    render(scene(tmp_path, FLOOR, height=1.0, n=30), tmp_path)


def test_too_many_pixels_on_edges_are_refused(tmp_path):
    # The edge is 7e-4 px from the centres: displaced rays cross it, but it is not a tie.
    shift = 7e-4 * 3 / 31
    assert "pixels lie on edges" in refused(scene(tmp_path, TRIANGLE, x=shift))


@pytest.mark.parametrize("focal_length", (1.0, None))
def test_an_edge_moved_by_a_tenth_of_a_pixel_is_a_tenth_of_a_pixel_away(focal_length):
    camera = Camera(
        eye=np.zeros(3), view=np.array([0.2, 0.1, -1]), up=np.array([0.0, 1, 0]),
        width=2.0, height=2.0, focal_length=focal_length, resolution=(64, 64),
    )
    (o,), (d,) = camera.rays([40.1], [21.0])
    (p,), (q,) = camera.rays([40.1], [30.0])
    (r,), (s,) = camera.rays([50.0], [25.0])
    triangle = np.array([o + 3 * d, p + 5 * q, r + 4 * s])
    assert edge_distances(camera, 40, 25, triangle)[0] == pytest.approx(0.1, abs=1e-9)
