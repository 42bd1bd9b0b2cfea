"""Questions of the kind `soup`: which of one object's triangles does the ray hit first?

They are like those of `first_hit`, but all triangles are one object, with the id 0.
"""

from cast import MISS
from kinds import first_hit

FRESH = first_hit.FRESH


class Question(first_hit.Question):
    """A question of `first_hit` about the triangles of one soup."""

    def answer(self):
        """Golden and tolerance, (5,) each, or None for a question to be redrawn."""
        answer = super().answer()
        if answer and answer[0][0] != MISS:
            answer[0][0] = 0.0
        return answer
