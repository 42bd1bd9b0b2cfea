"""golden.py run as its callers run it, and its films as others read them."""

import hashlib
import json
import subprocess
import sys
from pathlib import Path

import OpenImageIO
import numpy as np
import pytest

import film
import judge

GOLDEN = Path(__file__).parents[1] / "golden.py"
OIIOTOOL = Path(OpenImageIO.__file__).parent / "bin" / "oiiotool"

SCENE = """
[camera]
projection = "orthographic"
eye = [0.0, 0.0, 5.0]
view = [0.0, 0.0, -1.0]
up = [0.0, 1.0, 0.0]
width = 4.0
height = 2.0
resolution = [32, 16]

[[object]]
type = "sphere"
center = [-1.0, 0.5, 0.0]
radius = {radius}
"""


def golden(*arguments):
    """Exit code, JSON lines, standard error."""
    run = subprocess.run(
        [sys.executable, GOLDEN, *map(str, arguments)], capture_output=True, text=True
    )
    return run.returncode, [json.loads(line) for line in run.stdout.splitlines()], run.stderr


def digests(folder):
    """{file: hash} of all films below `folder`."""
    return {
        path.relative_to(folder): hashlib.sha256(path.read_bytes()).hexdigest()
        for path in folder.rglob("*.exr")
    }


def test_a_scene_rendered_twice_is_the_same_files(tmp_path):
    (tmp_path / "ball.toml").write_text(SCENE.format(radius=0.3))
    for out in ("one", "two"):
        code, lines, errors = golden("scenes", tmp_path / "ball.toml", "--out", tmp_path / out)
        assert (code, errors) == (0, "")
        assert lines[0] == {"mitsuba": "3.9.1", "variant": "scalar_rgb", "total": 1}
    assert len(digests(tmp_path / "one")) == 4
    assert digests(tmp_path / "one") == digests(tmp_path / "two")


def test_a_bad_scene_leaves_no_films_and_does_not_stop_the_others(tmp_path):
    good, bad, absent = (tmp_path / f"{name}.toml" for name in ("good", "bad", "absent"))
    good.write_text(SCENE.format(radius=0.3))
    bad.write_text(SCENE.format(radius='"wide"'))
    code, lines, errors = golden("scenes", absent, bad, good, "--out", tmp_path / "out")
    assert code == 2
    assert [line["name"] for line in lines[1:]] == ["good"]
    assert sorted(line.split(":")[0] for line in errors.splitlines()) == sorted(
        [str(absent), str(bad)]
    )
    assert {path.name for path in (tmp_path / "out").iterdir()} == set(lines[1]["files"])


def test_a_golden_stands_upright_on_disk(tmp_path):
    (tmp_path / "up.toml").write_text(SCENE.format(radius=0.3))
    assert golden("scenes", tmp_path / "up.toml", "--out", tmp_path)[0] == 0
    pixels, (n_x, n_y) = judge.read(tmp_path / "up.exr")
    ids = pixels["id"].reshape(n_y, n_x)
    rows, columns = np.nonzero(ids == 0)
    assert rows.min() >= n_y / 2 and columns.max() < n_x / 2  # upper left
    on_disk = OpenImageIO.ImageBuf(str(tmp_path / "up.exr")).get_pixels()
    assert (on_disk[:8].max(axis=2) > 0).any() and not (on_disk[8:].max(axis=2) > 0).any()


@pytest.mark.parametrize("number", range(5))
def test_oiiotool_finds_every_channel_in_its_place(number, tmp_path):
    values = np.tile([1.0, 2.0, 3.0, 4.0, 5.0], (6, 1))
    film.write(tmp_path / "film.exr", film.HIT_CHANNELS, values, (3, 2))
    shown = subprocess.run(
        [OIIOTOOL, tmp_path / "film.exr", "--ch", film.HIT_CHANNELS[number],
         "--echo", "{TOP.nchannels} {TOP.width} {TOP.height} {TOP.MINCOLOR}",
         "--pop", tmp_path / "film.exr", "--echo", "{TOP.nchannels}"],
        capture_output=True, text=True, check=True,
    ).stdout.split()
    assert shown == ["1", "3", "2", str(number + 1), "5"]


def test_a_film_carries_no_date(tmp_path):
    film.write(tmp_path / "film.exr", film.HIT_CHANNELS, np.zeros((1, 5)), (1, 1))
    assert b"Date" not in (tmp_path / "film.exr").read_bytes()


def test_a_film_that_cannot_be_written_leaves_nothing(tmp_path):
    films = {
        tmp_path / "a.exr": (film.HIT_CHANNELS, np.zeros((1, 5))),
        tmp_path / "b.exr": (film.HIT_CHANNELS, np.zeros((2, 5))),
    }
    with pytest.raises(ValueError):
        film.write_all(films, (1, 1))
    assert not list(tmp_path.iterdir())
