"""Words of the grammar, which a name may also be."""

from __future__ import annotations

import re
from functools import cache

from freebody.model.phrases import PHRASES
from freebody.questions.forms import FORMS

_EVENTS = "rate when until begins slips opens slides rolls leaves goes slack contact sliding rolling energy tip slide"
_COMPASS = "right left up down x y z origin center start end t pi"


@cache
def reserved_words() -> frozenset[str]:
    """In small letters."""
    forms = " ".join(f.form for f in (*PHRASES, *FORMS))
    return frozenset(w.lower() for w in re.findall(r"[A-Za-z_]+", f"{forms} {_EVENTS} {_COMPASS}"))
