"""What a file says of a toothed wheel, by whatever words: its teeth and its module, its mass and its inertia.

    {z: 20, m: 4 mm}         {teeth: 20, module: 4 mm}
    {N: 20, m: 2 kg}         {teeth: 20, mass: 2 kg}       m is what its unit says: a length is a module

All that knows gears by their teeth reads these words here: trains, planetary gears, bevel gears.
"""

from __future__ import annotations

from typing import Any, cast

from freebody.language.folded import folded
from freebody.language.units import DIMENSIONLESS, LENGTH, MASS
from freebody.system.reading.written.dimensions import dimension_said
from freebody.system.reading.written.form import Entry, Written

TEETH = ("teeth", "z", "number_of_teeth", "n_teeth", "zaehne", "zaehnezahl")
N = "n"  # of a wheel a number of teeth, of planets how many there are
MODULE = ("module", "modul")
M = "m"
MASSES = ("mass", "inertia")
_WORDS = {
    **dict.fromkeys(TEETH, "teeth"),
    **dict.fromkeys(MODULE, "module"),
    **dict.fromkeys(("mass", "masse"), "mass"),
    **dict.fromkeys(("inertia", "moment_of_inertia", "mass_moment_of_inertia", "traegheitsmoment"), "inertia"),
}
WORDS = (*_WORDS, N, M)


def of_wheel(w: Written, given: Any, *, n_is_teeth: bool = False) -> Any:
    """The fields of a wheel under one word each; what is said twice, and any other word, stays as it is, and so does
    what has no fields."""
    if not isinstance(given, dict):
        return given
    fields, read = cast("Entry", given), {}
    for key, value in fields.items():
        word = folded(str(key))
        is_teeth = n_is_teeth and word == N and dimension_said(w, value) == DIMENSIONLESS
        meant = "teeth" if is_teeth else _of_m(w, value) if word == M else _WORDS.get(word)
        taken = meant is None or meant in read or (meant != key and meant in fields)
        read[key if taken else str(meant)] = value
    return read


def _of_m(w: Written, value: Any) -> str | None:
    """What `m` is: by its unit; without one a module, in mm as in catalogues, is not guessed."""
    dimension = dimension_said(w, value)
    return None if dimension is None else {LENGTH: "module", MASS: "mass"}.get(dimension)


def one_of(fields: Any, words: tuple[str, ...]) -> Any:
    """The value under one of some words; None where none or several are said."""
    found = [each for key, each in fields.items() if folded(str(key)) in words] if isinstance(fields, dict) else []
    return found[0] if len(found) == 1 else None
