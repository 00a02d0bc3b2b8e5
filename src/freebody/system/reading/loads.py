"""The section `loads`: what pushes, by laws of its own measure, and what strikes at the start."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from freebody.connections.base import Connection
from freebody.language.expression import free_symbols, substitute
from freebody.language.notation import to_text
from freebody.loads.base import Load
from freebody.loads.law import Law
from freebody.model.elements import AppliedLoad
from freebody.model.names import Names
from freebody.questions.event import AskedEvent, read_event
from freebody.system.reading.parameters import forms


def read_loads(names: Names, loads: Mapping[str, Load]) -> list[AppliedLoad]:
    found: list[AppliedLoad] = []
    by_form = forms(names)
    for name, load in loads.items():
        with names.reading("loads", name, load.kind):
            for given in load.applied_loads(names):
                push = given.in_own_measure()
                if free_symbols(push.law) & by_form.keys():
                    push = replace(push, law=substitute(push.law, by_form), general=push.law)
                found.append(replace(push, load=name))
    with names.quietly():  # what is wrong with them has been told
        return [meant for push in found for meant in loads[push.load].among(names, push, found)]


class BroughtLoad(Law):
    """A law that a connection brings."""

    brought_by: str
    called_here: str

    def applied_loads(self, names: Names) -> list[AppliedLoad]:
        connection = names.connections.get(self.brought_by)
        with names.quietly():  # what is wrong with it is told where it stands
            found = {} if connection is None else connection.brings(names)
        return [found[self.called_here]] if self.called_here in found else []


def brought_loads(names: Names, connections: Mapping[str, Connection]) -> dict[str, Load]:
    """The loads that belong to connections."""
    found: dict[str, Load] = {}
    for name, connection in connections.items():
        with names.reading("connections", name, connection.kind):
            for load, push in connection.brings(names).items():
                between = " to ".join(push.measure.bodies())
                found[load] = BroughtLoad(
                    measure=f"distance from {between}",
                    force=str(to_text(push.law)),
                    brought_by=name,
                    called_here=load,
                )
    return found


def striking_when(names: Names, loads: Mapping[str, Load]) -> dict[str, AskedEvent]:
    """The impulses that act in mid-motion, and at which event."""
    found: dict[str, AskedEvent] = {}
    for name, load in loads.items():
        if load.strikes_when:
            event = None
            with names.reading("loads", name, load.kind):
                event = read_event(names, happening(load.strikes_when), ("when",))
            if event is not None:
                found[name] = event
    return found


def happening(words: str) -> str:
    """An event without the word that leads it in."""
    return " ".join(words.split()).removeprefix("when ")


def read_impulses(names: Names, loads: Mapping[str, Load]) -> tuple[AppliedLoad, ...]:
    """What is struck, and by which impulse."""
    found: list[AppliedLoad] = []
    for name, load in loads.items():
        with names.reading("loads", name, load.kind):
            found += [replace(push, load=name) for push in load.impulses(names)]
    return tuple(found)
