"""Our camera against Mitsuba's own sensors, measured in pixels."""

from dataclasses import replace

import numpy as np
import pytest

from camera import Camera
from sensor import sensor_rays
from tolerance import ray_tolerance

AGREEMENT = 2e-4  # px

UPRIGHT = Camera(
    eye=np.array([0.5, 1.0, 3.0]),
    view=np.array([0.0, 0.0, -1.0]),
    up=np.array([0.0, 1.0, 0.0]),
    width=1.6,
    height=0.9,
    focal_length=1.5,
    resolution=(160, 90),
)
ROTATED = replace(
    UPRIGHT, view=np.array([0.7, -0.5, 2.0]), up=np.array([0.4, 3.0, 0.2]), height=1.6,
    resolution=(121, 121),
)
SHORT = replace(ROTATED, focal_length=0.6, eye=np.array([-40.0, 7.0, 90.0]))
LONG = replace(ROTATED, focal_length=12.0, width=6.0, height=6.0)
CAMERAS = {"upright": UPRIGHT, "rotated": ROTATED, "short": SHORT, "long": LONG} | {
    "orthographic": replace(UPRIGHT, focal_length=None),
    "rotated orthographic": replace(ROTATED, focal_length=None, width=5.0, height=5.0),
    "tiny orthographic": replace(
        ROTATED, eye=np.array([1e-5, 2e-5, 3e-5]), focal_length=None, width=1e-5, height=1e-5
    ),
}


def pixels_apart(camera, other):
    """The largest distance in px between the sensor's rays and `other`'s rays."""
    i, j = camera.pixels()
    sensor, ours = sensor_rays(camera, i, j), other.rays(i, j)
    moving = 0 if camera.focal_length is None else 1
    difference = sensor[moving] - ours[moving]
    across, upwards = (
        difference @ step / (step @ step) for step in camera.pixel_steps
    )
    return np.hypot(across, upwards).max()


@pytest.mark.parametrize("name", CAMERAS)
def test_our_camera_agrees_with_mitsubas_sensor(name):
    apart = pixels_apart(CAMERAS[name], CAMERAS[name])
    print(f"{name}: {apart:.1e} px")
    assert apart < AGREEMENT


@pytest.mark.parametrize("name", CAMERAS)
def test_a_camera_shifted_by_a_thousandth_of_a_pixel_is_noticed(name):
    camera = CAMERAS[name]
    step = 1e-3 * camera.pixel_steps[0]
    if camera.focal_length is None:
        shifted = replace(camera, eye=camera.eye + step)
    else:  # a perspective camera's image moves by a pixel when its view turns
        shifted = replace(camera, view=camera.view / np.linalg.norm(camera.view)
                          + step / camera.focal_length)
    assert pixels_apart(camera, shifted) > 4 * AGREEMENT


@pytest.mark.parametrize("name", CAMERAS)
def test_directions_keep_the_focal_length(name):
    camera = CAMERAS[name]
    i, j = camera.pixels()
    for _, directions in (camera.rays(i, j), sensor_rays(camera, i, j)):
        depth = directions @ -camera.frame[2]
        np.testing.assert_allclose(depth, camera.focal_length or 1.0, rtol=1e-6)


@pytest.mark.parametrize("name", CAMERAS)
def test_the_sensors_rays_are_within_the_tolerance_of_ours(name):
    camera = CAMERAS[name]
    i, j = camera.pixels()
    sensor, ours = sensor_rays(camera, i, j), camera.rays(i, j)
    difference = np.abs(np.hstack(sensor) - np.hstack(ours))
    assert (difference < ray_tolerance(camera, *sensor) / 2).all()


def test_a_ray_far_from_the_view_is_within_the_tolerance_of_ours():
    # One of its components divided by the focal length is more than a hundred.
    camera = Camera(
        eye=np.array([4.63745641708374, 4.849339485168457, 3.705766201019287]),
        view=np.array([-0.9642496109008789, -2.0941128730773926, -1.9218367338180542]),
        up=np.array([-0.2206333726644516, -0.017001602798700333, -0.3598101735115051]),
        width=7.484375, height=716.62890625, focal_length=2.5048398971557617,
        resolution=(8, 766),
    )
    sensor, ours = sensor_rays(camera, [0], [765]), camera.rays([0], [765])
    difference = np.abs(np.hstack(sensor) - np.hstack(ours))
    assert (difference < ray_tolerance(camera, *sensor) / 2).all()


def test_row_0_is_the_bottom_row():
    (_, _), (low, high) = UPRIGHT.rays([0, 0], [0, 89])
    assert low[1] < 0 < high[1]
