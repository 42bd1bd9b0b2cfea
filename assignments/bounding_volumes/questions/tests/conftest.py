"""Lets the tests import this assignment's questions, the scripts that all assignments share,
and the tests' caster and judge."""

import sys
from pathlib import Path

ASSIGNMENT = Path(__file__).parents[2]
MITSUBA = ASSIGNMENT.parents[1] / "tools" / "mitsuba"

sys.path[:0] = map(str, (ASSIGNMENT, MITSUBA, MITSUBA / "tests"))
