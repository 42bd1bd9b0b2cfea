"""The four films of a scene: its golden and its rays, each with tolerances."""

import numpy as np

import film
from cast import cast
from face_rounding import normal_rounding
from refusal import refuse_ties
from scene import load
from sensor import golden_rays
from shapes import to_mitsuba
from tolerance import DISPLACEMENT, RING, hit_tolerance, ray_tolerance


def golden(scene):
    """The golden's pixels (N, 5) and their tolerances.

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
    return centre.channels(), tolerance


def render(path, folder):
    """Make the films of the scene file `path` in `folder`; return the report."""
    scene = load(path)
    pixels, tolerance = golden(scene)
    rays = golden_rays(scene.camera, *scene.camera.pixels())
    rays_tolerance = ray_tolerance(scene.camera, *rays)
    films = {
        folder / f"{scene.name}.exr": (film.HIT_CHANNELS, pixels),
        folder / f"{scene.name}.tol.exr": (film.HIT_CHANNELS, tolerance),
        folder / f"{scene.name}.rays.exr": (film.RAY_CHANNELS, np.hstack(rays)),
        folder / f"{scene.name}.rays.tol.exr": (film.RAY_CHANNELS, rays_tolerance),
    }
    film.write_all(films, scene.camera.resolution)
    return {"name": scene.name, "files": [path.name for path in films]}
