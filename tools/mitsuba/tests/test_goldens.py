"""A right float64 caster passes the golden of a scene, and a slightly wrong one does not."""

import numpy as np
import pytest

import float64_caster as caster
import judge
from scene import load
from scene_films import render as render_scene

ROOM = """
[camera]
projection = "{projection}"
eye = [0.3, 1.1, 4.0]
view = [-0.1, -0.25, -1.0]
up = [0.1, 1.0, 0.05]
{focal_length}
width = {width}
height = {width}
resolution = [90, 80]

[[object]]
type = "sphere"
center = [0.0, 0.6, 0.0]
radius = 0.8
[[object]]
type = "sphere"
center = [0.4, 0.9, 2.55]
radius = 0.25
[[object]]
type = "plane"
point = [0.0, -0.2, 0.0]
normal = [0.0, 2.0, 0.1]
[[object]]
type = "soup"
obj = "roof.obj"
"""

ROOF = """
v 1 0 0
v 2 0 0.5
v 2 1 0.2
v 1 1 0
v 1.5 0.5 1.1
f 1/1/1 2/2/2 5
f 2 3 5
f 3 4 5
f 4 1 -1
f 4 3 2 1
"""


@pytest.fixture(params=("perspective", "orthographic"))
def room(request, tmp_path):
    """A scene of all shapes, one of them across the image plane."""
    perspective = request.param == "perspective"
    (tmp_path / "roof.obj").write_text(ROOF)
    path = tmp_path / "room.toml"
    path.write_text(ROOM.format(
        projection=request.param,
        focal_length="focal_length = 1.5" if perspective else "",
        width=1.6 if perspective else 4.8,
    ))
    return path


def films_of_right_caster(path, shift=0.0):
    """The answers for its golden and its ray film, with the camera `shift` px to the right."""
    scene = load(path)
    rays = caster.scene_rays(scene.camera, shift)
    return caster.cast(scene.objects, *rays, scene.camera.min_t), np.hstack(rays)


def test_a_right_caster_passes_a_scene_of_all_shapes(room, tmp_path):
    render_scene(room, tmp_path)
    film, rays = films_of_right_caster(room)
    assert set(film[:, 0]) == {-1, 0, 1, 2, 3}
    assert judge.failing(film, tmp_path, "room") == 0
    assert judge.failing(rays, tmp_path, "room.rays") == 0


def test_a_camera_shifted_by_a_fiftieth_of_a_pixel_fails(room, tmp_path):
    render_scene(room, tmp_path)
    film, rays = films_of_right_caster(room, shift=0.02)
    assert judge.failing(film, tmp_path, "room") > 1000
    assert judge.failing(rays, tmp_path, "room.rays") == len(rays)


def test_small_faces_far_from_the_origin_of_space_are_judged_fairly(tmp_path):
    rng = np.random.default_rng(1)
    heights = 3.3 + 0.01 * rng.random((12, 12))
    vertices = [f"v {2.1 + 0.017 * i:.6f} {4.7 + 0.017 * j:.6f} {heights[i, j]:.6f}"
                for i in range(12) for j in range(12)]
    quads = [f"f {k} {k + 12} {k + 13} {k + 1}" for k in range(1, 131) if k % 12]
    (tmp_path / "roof.obj").write_text("\n".join(vertices + quads))
    path = tmp_path / "room.toml"
    text = ROOM.format(projection="orthographic", focal_length="", width=0.2)
    text = text.replace("[0.3, 1.1, 4.0]", "[2.19, 4.79, 5.0]")
    path.write_text(text.replace("[-0.1, -0.25, -1.0]", "[0.0, 0.0, -1.0]"))
    render_scene(path, tmp_path)
    film, _ = films_of_right_caster(path)
    assert (film[:, 0] == 3).mean() > 0.5
    assert judge.failing(film, tmp_path, "room") == 0
