"""A load whose size the file leaves open, asked for by its symbol: which force Q does the press exert?

Such a load is the one that balances the others, so what is asked for is the size with which the system rests; in an
equation or a ratio (for which beta is Q = 5 F, Q/F) it is the force of that load, where nothing has mass and the pose
is one of equilibrium.
"""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from freebody.language.expression import ZERO, Symbol
from freebody.language.units import FORCE, TORQUE
from freebody.measures.geometry import GROUND
from freebody.questions.spoken import lookup
from freebody.questions.spoken.lexicon import contexts, languages

if TYPE_CHECKING:
    from freebody.model.names import Names


def size_that_balances(names: Names, text: str) -> str:
    """The words for the size of an open load where that is all a text asks for; else nothing."""
    for name in _open_loads(names):
        for language in languages():
            if re.fullmatch(contexts(language)["open_load"].format(name=name), text.strip(" ?.!")):
                return f"range of {name} that keeps it at rest"
    return of_a_press(names, text)


def of_a_press(names: Names, text: str) -> str:
    """The words for the size of the only open load where its kind is asked for: the clamping force."""
    loads = [*_open_loads(names)]
    told = (contexts(language).get("open_load_by_kind") for language in languages())
    is_asked = any(one and re.fullmatch(one, text.strip(" ?.!"), re.IGNORECASE) for one in told)
    return f"range of {loads[0]} that keeps it at rest" if is_asked and len(loads) == 1 else ""


def as_force(names: Names, text: str) -> str:
    """A text with the force of an open load for the symbol of its size, in a machine without mass."""
    if any(body.mass != ZERO for body in names.bodies.values() if body.name != GROUND):
        return text
    for name, load in _open_loads(names).items():
        what = "torque" if names.loads[load] == TORQUE else "force"
        if any(re.search(contexts(language)["sought"].format(name=name), text) for language in languages()):
            continue  # the value of Q for which something is so
        text = re.sub(rf"(?<![\w.«(]){name}(?![\w.(])", f"{what} in {load}", text)
    return text


def _open_loads(names: Names) -> dict[str, str]:
    """The parameters without a value that are the size of a force or torque, or of several, with the first of these
    loads, where nothing drives or moves what they act on."""
    if not lookup.rests(names) or any(row.is_driven for row in names.constraint_rows):
        return {}
    open_ones = [p for p in names.parameters.values() if p.value is None and p.form is None]
    found = dict[str, str]()
    for p in open_ones:
        of = [push.load for push in names.applied_loads if push.law in (Symbol(p.name), -Symbol(p.name))]
        if of and names.loads.get(of[0]) in (FORCE, TORQUE):
            found[p.name] = of[0]
    return found
