"""TESTS ONLY: the judge's one rule, |film - golden| <= tolerance everywhere."""

import os

import OpenImageIO as oiio
import numpy as np

import film


def read(path):
    """A film as {channel: pixels}, rows from the bottom, and its (n_x, n_y)."""
    image = oiio.ImageInput.open(os.fspath(path))
    assert image, f"{path}: {oiio.geterror()}"
    spec = image.spec()
    values = np.array(image.read_image("float"), dtype=np.float64)[::-1]
    image.close()
    columns = values.reshape(-1, spec.nchannels).T
    return dict(zip(spec.channelnames, columns)), (spec.width, spec.height)


def excess(answers, folder, name):
    """|film - golden| / tolerance per pixel and channel, for the golden `name`.

    `answers` are float64; they are rounded to float32 as a film on disk is.
    """
    golden, tolerance = (read(folder / f"{name}{end}.exr")[0] for end in ("", ".tol"))
    names = film.RAY_CHANNELS if "O.X" in golden else film.HIT_CHANNELS
    assert set(golden) == set(tolerance) == set(names)
    golden, tolerance = (np.column_stack([f[c] for c in names]) for f in (golden, tolerance))
    return np.abs(np.float64(np.float32(answers)) - golden) / tolerance


def failing(answers, folder, name):
    """How many pixels break the rule."""
    return int((excess(answers, folder, name) > 1).any(axis=1).sum())
