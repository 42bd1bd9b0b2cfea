"""The tolerance of every pixel: how far a right film may be from its golden.

Goldens are float32 and a ray has no width, so a single threshold is either too
tight at a silhouette or blind everywhere else. We let Mitsuba say how much its
answer moves when the ray moves by much less than any mistake would move it,
and add what float32 rounding costs. Chosen among twelve settings on one seed
and checked on another: no correct float64 caster failed in 45 random scenes.
"""

import numpy as np

DISPLACEMENT = 1e-3
"""How far the eight displaced rays of a scene's pixel lie from its centre, px."""

RING = np.array([(np.cos(a), np.sin(a)) for a in np.arange(8) * np.pi / 4])
"""The eight directions of displacement, unit vectors."""

ID_SLACK = 0.25  # ids are whole numbers
F32_STEP = 1.2e-7  # between float32 numbers just above 1
F32_RELATIVE = 2e-6  # Mitsuba's float32: p99 of t is 7e-7, of a normal below that
T_ABSOLUTE = 1e-6  # of t, for starts rounded near t = 0

EXEMPT = float(np.finfo(np.float32).max)
"""The tolerance that every finite float32 passes."""

EXEMPT_SHARE = 0.0005
"""The largest share of a scene's pixels that may be exempt."""


def round_up(x):
    """The smallest powers of two that are at least `x` > 0, because they compress well."""
    mantissa, exponent = np.frexp(x)
    return np.ldexp(1.0, np.where(mantissa == 0.5, exponent - 1, exponent))


def exempt_allowed(pixels):
    """How many of a scene's `pixels` may be exempt."""
    return max(1, int(EXEMPT_SHARE * pixels))


def hit_tolerance(centre, displaced, normal_rounding=0.0, t_absolute=T_ABSOLUTE):
    """Tolerances (N, 5) of the channels id, t, N.X, N.Y, N.Z, and which pixels are exempt.

    `centre` are the golden `Hits`, `displaced` those of the displaced rays.
    Where the id changes among them, the pixel lies on an edge and is exempt. At
    a golden miss t and the normal mean nothing, so only the id is compared.
    `normal_rounding`, one number or one per ray, is added for flat faces: see
    `face_rounding.py`.
    """
    golden = centre.channels()
    others = np.array([hits.channels() for hits in displaced])
    deviation = np.abs(others - golden).max(axis=0)
    tolerance = np.empty_like(golden)
    tolerance[:, 0] = deviation[:, 0] + ID_SLACK
    tolerance[:, 1] = (
        deviation[:, 1] + F32_RELATIVE * (np.abs(golden[:, 1]) + deviation[:, 1]) + t_absolute
    )
    flat = np.broadcast_to(normal_rounding, len(golden))[:, None]
    tolerance[:, 2:] = deviation[:, 2:] + F32_RELATIVE + flat
    tolerance = round_up(tolerance)
    tolerance[centre.id < 0, 1:] = EXEMPT
    exempt = deviation[:, 0] > 0
    tolerance[exempt] = EXEMPT
    return tolerance, exempt


def ray_tolerance(camera, origins, directions):
    """Tolerances (N, 6) of the channels O.X .. D.Z of rays of one camera.

    Per component the sum of three terms: how far a displacement of 1e-3 px in
    any direction moves it (Mitsuba's sensor is within 2e-4 px of our builder);
    2e-6 of the largest component of that vector (its float32 rounding, which a
    rotation spreads over all components), or more for slanted rays, because the
    sensor's direction is a unit vector and is divided by its forward component,
    whose float32 rounding is at most 1.2e-7; and 1e-6 of the image plane's larger
    side, so that a component that is 0 in exact arithmetic (an eye in the origin,
    an unrotated axis) may differ by the rounding of what cancelled. That last
    term is below 1e-3 px for every image narrower than 1000 pixels.
    """
    moved = DISPLACEMENT * np.hypot(*camera.pixel_steps)
    still = np.zeros(3)
    orthographic = camera.focal_length is None
    shifts = (moved, still) if orthographic else (still, moved)
    floor = 1e-6 * max(camera.width, camera.height)
    lengths = np.linalg.norm(directions, axis=1, keepdims=True)
    slanted = 0.0 if orthographic else F32_STEP * lengths / camera.focal_length
    relatives = (F32_RELATIVE, np.maximum(F32_RELATIVE, slanted))
    columns = [
        shift + relative * np.abs(vectors).max(axis=1, keepdims=True) + floor
        for shift, relative, vectors in zip(shifts, relatives, (origins, directions))
    ]
    return round_up(np.hstack(columns))
