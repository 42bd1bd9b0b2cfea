"""Questions about the nearest triangle of a soup."""

from functools import partial

from kinds import soup
from questions import objects

GROUPS = {
    group: partial(objects.draw, group=group, kind=soup, things=(objects.triangle,))
    for group in (*objects.GROUPS, "last_only")
}
