"""The four films of a scene: its golden and its rays, each with tolerances."""

import numpy as np

import film
from cast import cast
from face_rounding import normal_rounding
from refusal import refuse_ties
from scene import load
from sensor import sensor_rays
from shapes import to_mitsuba
from tolerance import DISPLACEMENT, RING, hit_tolerance, ray_tolerance


def golden(scene):
    """The golden's pixels (N, 5), their tolerances, and which are exempt.

    Raises `SceneError` where a right caster could fail.
    """
    camera, world = scene.camera, to_mitsuba(scene.objects)
    i, j = camera.pixels()
    centre = cast(world, *camera.rays(i, j), camera.min_t)
    displaced = [
        cast(world, *camera.rays(i + across, j + upwards), camera.min_t)
        for across, upwards in DISPLACEMENT * RING
    ]
    flat = normal_rounding(scene.objects, centre)
    tolerance, exempt = hit_tolerance(centre, displaced, flat)
    refuse_ties(scene, centre, displaced, exempt)
    return centre.channels(), tolerance, exempt


def golden_rays(camera):
    """The ray film's pixels (N, 6), their tolerances, and whether a sensor of
    Mitsuba's made them (it has square pixels; else our builder speaks)."""
    pixels = camera.pixels()
    by_sensor = camera.has_square_pixels
    rays = sensor_rays(camera, *pixels) if by_sensor else camera.rays(*pixels)
    return np.hstack(rays), ray_tolerance(camera, *rays), by_sensor


def render(path, folder):
    """Make the films of the scene file `path` in `folder`; return the report."""
    scene = load(path)
    pixels, tolerance, exempt = golden(scene)
    rays, rays_tolerance, by_sensor = golden_rays(scene.camera)
    films = {
        folder / f"{scene.name}.exr": (film.HIT_CHANNELS, pixels),
        folder / f"{scene.name}.tol.exr": (film.HIT_CHANNELS, tolerance),
        folder / f"{scene.name}.rays.exr": (film.RAY_CHANNELS, rays),
        folder / f"{scene.name}.rays.tol.exr": (film.RAY_CHANNELS, rays_tolerance),
    }
    film.write_all(films, scene.camera.resolution)
    return {
        "name": scene.name,
        "files": [path.name for path in films],
        "exempt": int(exempt.sum()),
        "sensor": by_sensor,
    }
