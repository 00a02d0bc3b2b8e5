"""What has come of a case: a number with where it is from, or why there is none."""

from __future__ import annotations

from freebody.numeric.engine.course import Status

NOT_DONE = "not done"
FORMULA = "formula"  # the closed form, where its conditions hold
NUMBERS = "numbers"  # the numeric route, where no closed form is known to hold
OUTSIDE = "outside"  # no case of the answer holds, and no number is known
NO_VALUE = "no value"
NOT_ASSEMBLED = "cannot be assembled"
NOT_ADMISSIBLE = "not admissible"  # a parameter has a sign that the model excludes

STATUSES = (
    NOT_DONE,
    FORMULA,
    NUMBERS,
    OUTSIDE,
    NO_VALUE,
    NOT_ASSEMBLED,
    NOT_ADMISSIBLE,
    *(str(status) for status in Status),
)
CODES = {word: code for code, word in enumerate(STATUSES)}
GOOD = frozenset({FORMULA, NUMBERS, *(str(status) for status in Status if status.is_complete)})
