"""Questions on small whole numbers, and whether each is a tie."""

from functools import partial

import numpy as np

from kinds import first_hit, soup
from shapes.plane import Plane
from shapes.sphere import Sphere
from shapes.triangle import Triangles
from whole_numbers import Ray, not_zero, vector, whole

NORMALS = (*np.eye(3), *-np.eye(3))
"""A normal for each object that a question has room for. The answer's normal shows which
object was hit, and float32 holds it exactly."""


def sphere(rng):
    """Ties: tangent, or a root exactly at min_t."""
    shape, ray = Sphere(vector(rng), whole(rng, 1, 3)), Ray.draw(rng)
    # The roots are those of a t^2 + 2 h t + c = 0.
    from_center = ray.origin - shape.center
    a, h = ray.direction @ ray.direction, ray.direction @ from_center
    c = from_center @ from_center - shape.radius**2
    root_at_min_t = a * ray.min_t**2 + 2 * h * ray.min_t + c == 0
    return ray.ask(shape), h**2 == a * c or root_at_min_t


def plane(rng):
    """Ties: t exactly min_t. A parallel ray is not a tie: it misses, wherever it is."""
    shape, ray = Plane(vector(rng), not_zero(rng)), Ray.draw(rng)
    parallel = ray.direction @ shape.normal == 0
    return ray.ask(shape), not parallel and (ray.at_min_t() - shape.point) @ shape.normal == 0


def triangle(rng):
    """Ties: exactly on the line of an edge, or t exactly min_t. A parallel ray is
    not a tie: it misses, even in the triangle's own plane."""
    a, b, c = (vector(rng) for _ in range(3))
    t1, t2 = b - a, c - a
    if not np.cross(t1, t2).any():
        return triangle(rng)
    ray = Ray.draw(rng)
    # o - a = alpha t1 + beta t2 - t d by Cramer's rule, each times the determinant.
    to_eye = ray.origin - a
    across = np.cross(ray.direction, t2)
    upwards = np.cross(to_eye, t1)
    determinant = t1 @ across
    alpha, beta, t = to_eye @ across, ray.direction @ upwards, t2 @ upwards
    on_edge = alpha == 0 or beta == 0 or alpha + beta == determinant
    at_min_t = t == ray.min_t * determinant
    question = ray.ask(Triangles(np.array([[a, b, c]])))
    return question, determinant != 0 and (on_edge or at_min_t)


def objects(rng, kind):
    """Ties: two objects are first met at the same t. A question of `kind` about up to
    six objects, each met nowhere, once or twice."""
    ray = Ray.draw(rng)
    met = [
        sorted({whole(rng, -2, 8) for _ in range(whole(rng, 0, 2))})
        for _ in range(whole(rng, 0, first_hit.SLOTS))
    ]
    firsts = [next((t for t in ts if t >= ray.min_t), np.inf) for ts in met]
    nearest = min(firsts, default=np.inf)
    # The question holds the hits of each object, and no shapes.
    found = [[(t, normal) for t in ts] for ts, normal in zip(met, NORMALS)]
    question = kind.Question(ray.origin, ray.direction, ray.min_t, met, found)
    return question, nearest < np.inf and firsts.count(nearest) > 1


TASKS = {
    "sphere": sphere,
    "plane": plane,
    "triangle": triangle,
    "triangle_soup": partial(objects, kind=soup),
    "first_hit": partial(objects, kind=first_hit),
}
