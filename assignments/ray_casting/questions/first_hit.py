"""Questions about the nearest of several spheres, planes and triangles."""

from functools import partial

from kinds import first_hit
from questions import objects

GROUPS = {
    group: partial(
        objects.draw,
        group=group,
        kind=first_hit,
        things=(objects.sphere, objects.plane, objects.triangle),
    )
    for group in objects.GROUPS
}
