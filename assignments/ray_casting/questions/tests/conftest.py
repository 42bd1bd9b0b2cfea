"""Lets the tests import this assignment's questions, what all assignments share, and
the tests' own caster and judge."""

import sys
from pathlib import Path

ASSIGNMENT = Path(__file__).parents[2]
MITSUBA = ASSIGNMENT.parents[1] / "tools" / "mitsuba"

sys.path[:0] = map(str, (ASSIGNMENT, MITSUBA, MITSUBA / "tests"))
