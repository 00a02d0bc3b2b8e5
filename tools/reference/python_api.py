"""The Python interface: every name of `freebody`, documented by autodoc from its docstring."""

from __future__ import annotations

from collections.abc import Iterator
from inspect import isclass, isfunction

import freebody as fb
from freebody.model.spec import Spec
from freebody.present.report.result import Result
from freebody.studies import STUDIES
from reference.page import Page, block, joined, words_of

_HEAD = """`import freebody as fb` has the names on this page; each is imported on its first use. Lengths,
masses and times are in SI units, angles in radians; texts may carry units (`"3 kg"`). Descriptions of bodies,
connections and loads take their fields by position or by name, and their pages are [Bodies](bodies.md),
[Connections](connections.md) and [Loads](loads.md)."""


def pages() -> Iterator[Page]:
    groups: dict[str, list[str]] = {
        "Systems": [],
        "Studies": [],
        "Results": [],
        "Errors": [],
        "Descriptions": [],
        "More": [],
    }
    for name in dir(fb):
        if not name.startswith("_"):
            words_of(getattr(fb, name), f"freebody.{name}")
            groups[_group(name)].append(name)
    parts = ["# Python", _HEAD]
    for title, names in groups.items():
        parts += [f"## {title}", *(block("{eval-rst}", _directive(name)) for name in names)]
    yield Page("python", "Python", "every name of the package", 80, joined(parts))


def _group(name: str) -> str:
    one = getattr(fb, name)
    if name == "System":
        return "Systems"
    if name in STUDIES:
        return "Studies"
    if isclass(one) and issubclass(one, Exception):
        return "Errors"
    if isclass(one) and issubclass(one, Spec):
        return "Descriptions"
    return "Results" if isclass(one) and issubclass(one, Result) else "More"


def _directive(name: str) -> str:
    one = getattr(fb, name)
    if isfunction(one):
        return f".. autofunction:: freebody.{name}"
    # of a system its parts as they were read are no part of the interface
    inherited = " SystemDescription" if name == "System" else ""
    members = "" if issubclass(one, (Spec, Exception)) else f"\n   :members:\n   :inherited-members:{inherited}"
    return f".. autoclass:: freebody.{name}{members}"
