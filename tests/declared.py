"""Which symbols of a solution nobody introduced: neither parameters, nor coordinates or measures of the model, nor the
time, nor explained by an assumption or by a note of the answer."""

from __future__ import annotations

import re
from typing import Any

import freebody as fb
from freebody.language.expression import Symbol, free_symbols
from freebody.language.notation import to_text
from freebody.language.parser import parse

_WORD = re.compile(r"[A-Za-z_]\w*")
_FUNCTIONS = {"rate", "sqrt", "sin", "cos", "tan", "asin", "acos", "atan", "atan2", "exp", "log", "abs", "sign", "pi"}
_FUNCTIONS |= {"sinh", "cosh", "tanh", "coth", "acosh", "asinh", "atanh", "max", "min", "True", "False", "none"}
GIVEN = {f"{name}{order}" for name in ("f", "lift") for order in ("", "_d", "_dd", "_ddd")}  # in numbers, by points
_FUNCTIONS |= GIVEN


def symbols_of(formula: Any) -> set[str]:
    """Of a formula in a JSON document, a list of them, or a statement of comparisons."""
    if formula is None:
        return set()
    if isinstance(formula, list):
        return set[str]().union(*map(symbols_of, formula))
    if isinstance(formula, dict):
        return symbols_of(formula.get("expression"))
    try:
        return set(free_symbols(parse(str(formula))))
    except fb.FreebodyError:
        return set(_WORD.findall(str(formula))) - _FUNCTIONS


def undeclared(solution: fb.Solution) -> set[str]:
    """Symbols in answers, their conditions, cases and phases that the document does not introduce."""
    document = solution.to_plain()
    known = {"t", "pi", *solution.system.parameters, *solution.system.measures}
    known |= {*document["coordinates"], *document["dependent_coordinates"], *document.get("states", ())}
    known |= {f"{name}_0" for name in solution.system.measures}
    known |= {text.split()[0] for text in document["assumptions"] if " at the start" in text}
    return _everywhere(document["answers"], known) | _everywhere(document.get("phases"), known)


def _everywhere(part: Any, known: set[str]) -> set[str]:
    if isinstance(part, dict):
        said = " ".join(n["text"] for n in part.get("notes", ()) if isinstance(n, dict) and n["expression"] is None)
        known = known | {name for name in symbols_of(part.get("expression")) if to_text(Symbol(name)) in said.split()}
        known = known | {named["name"] for named in part.get("chain", {}).get("named", ())}
        found = symbols_of(part["expression"]) - known if "expression" in part else set[str]()
        return found.union(*(_everywhere(value, known) for key, value in part.items() if key != "options"))
    if isinstance(part, list):
        return set[str]().union(*(_everywhere(item, known) for item in part))
    return set()
