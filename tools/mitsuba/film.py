"""Films on disk: OpenEXR, float32, named channels, lossless zip.

In memory a film is (N, channels), pixel after pixel, row j after row j from the
BOTTOM; on disk row r of the file is j = n_y - 1 - r, so that viewers show it
upright. The same film always gives the same bytes.
"""

import os

import OpenImageIO as oiio
import numpy as np

HIT_CHANNELS = ("id", "t", "N.X", "N.Y", "N.Z")
RAY_CHANNELS = ("O.X", "O.Y", "O.Z", "D.X", "D.Y", "D.Z")


def write(path, channels, pixels, resolution):
    """Write `pixels`, shape (n_x * n_y, len(channels)), to the file `path`."""
    n_x, n_y = resolution
    values = np.asarray(pixels, dtype=np.float32).reshape(n_y, n_x, len(channels))
    spec = oiio.ImageSpec(n_x, n_y, len(channels), oiio.FLOAT)
    spec.channelnames = list(channels)
    spec["compression"] = "zip"
    spec["DateTime"] = ""  # an absent one is filled with the present time
    output = oiio.ImageOutput.create("openexr")
    written = output.open(os.fspath(path), spec)
    written = written and output.write_image(np.ascontiguousarray(values[::-1]))
    if not (output.close() and written):
        raise OSError(f"{path}: {output.geterror() or 'cannot write the film'}")


def write_all(films, resolution):
    """Write several films of one resolution, or none of them.

    `films` is {path: (channels, pixels)}. Each is written under another name
    first, so that a crash leaves no half-written film under a real name.
    """
    parts = {path: path.with_name(f".{path.name}.part") for path in films}
    try:
        for path, (channels, pixels) in films.items():
            write(parts[path], channels, pixels, resolution)
        for path, part in parts.items():
            part.replace(path)
    finally:
        for part in parts.values():
            part.unlink(missing_ok=True)
