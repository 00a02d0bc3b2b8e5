"""Words as they are compared: capital or not, `koerper` for `Körper`, `Hinge-Joint` for `hinge_joint`."""

from __future__ import annotations

import re

_GERMAN = str.maketrans({"ä": "ae", "ö": "oe", "ü": "ue"})
_BETWEEN = re.compile(r"[\s-]+")


def folded(word: str) -> str:
    """The word by which all spellings of it are known."""
    return _BETWEEN.sub("_", word.strip().casefold().translate(_GERMAN))
