"""Mitsuba's own sensor for a camera of ours: an independent second opinion.

Goldens of scenes are cast along the rays of `camera.py`, whose float64 pixel
centres are the more accurate ones; but the golden of `viewing_ray` must not be
our own opinion of a camera, so it comes from here. Mitsuba's perspective and
orthographic sensors look along +z of their frame, with +x to the LEFT of the
image, and their pixels are square.
"""

import mitsuba as mi
import numpy as np

from camera import Camera

mi.set_variant("scalar_rgb")


def sensor(camera):
    """The Mitsuba sensor that sees what `camera` sees."""
    u, v, w = camera.frame
    n_x, n_y = camera.resolution
    perspective = camera.focal_length is not None
    # Mitsuba's orthographic image plane is 2 wide; only its frame can scale it.
    scale = 1.0 if perspective else camera.width / 2
    to_world = np.eye(4)
    to_world[:3] = np.column_stack([-scale * u, scale * v, -w, camera.eye])
    near_clip = _near_clip(camera)
    description = {
        "type": "perspective" if perspective else "orthographic",
        "near_clip": near_clip,
        "far_clip": 1e4 * near_clip,
        "to_world": mi.ScalarTransform4f(to_world),
        "film": {"type": "hdrfilm", "width": n_x, "height": n_y},
    }
    if perspective:
        half_angle = np.arctan(camera.width / 2 / camera.focal_length)
        description |= {"fov": float(np.degrees(2 * half_angle)), "fov_axis": "x"}
    return mi.load_dict(description)


def sensor_rays(camera, i, j):
    """The sensor's rays through pixels (i, j), in our form: origins, directions.

    A Mitsuba ray starts on the near clip plane and has unit length. Ours starts
    at the eye (perspective) or on the image plane (orthographic), and its
    direction d is scaled so that d.(-w) is the focal length or 1, respectively.
    """
    eye_sensor = sensor(camera)
    n_x, n_y = camera.resolution
    origins, directions = [], []
    for x, y in zip((np.asarray(i) + 0.5) / n_x, 1 - (np.asarray(j) + 0.5) / n_y):
        ray, _ = eye_sensor.sample_ray(0.0, 0.0, [x, y], [0.5, 0.5])
        origins.append((ray.o.x, ray.o.y, ray.o.z))
        directions.append((ray.d.x, ray.d.y, ray.d.z))
    origins, directions = np.array(origins), np.array(directions)
    forward = -camera.frame[2]
    depth = 1.0 if camera.focal_length is None else camera.focal_length
    directions *= depth / (directions @ forward)[:, None]
    if camera.focal_length is None:
        return origins - _near_clip(camera) * forward, directions
    return np.broadcast_to(camera.eye, directions.shape), directions


def golden_rays(camera, i, j):
    """The rays a submission is judged by: the sensor's if the pixels are square, those
    of our own builder if not."""
    return (sensor_rays if camera.has_square_pixels else Camera.rays)(camera, i, j)


def _near_clip(camera):
    """The distance from the eye at which the sensor's rays start. It is as large as the
    image; otherwise its float32 rounding would show in a picture of something tiny."""
    return camera.width if camera.focal_length is None else camera.focal_length
