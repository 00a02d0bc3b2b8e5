"""A body that drives lead along lines and nothing else holds: it falls under its weight across them."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from freebody.language.sentences import Message
from freebody.measures.displacement import Displacement
from freebody.measures.geometry import GROUND
from freebody.model.elements import AppliedLoad, ConstraintRow
from freebody.numeric.jets import Array
from freebody.study.model_warnings.base import ModelWarning, Opened, WarningKind
from freebody.system.system import System

_ALONG = 1e-6  # of the weight: what is left of it across the ways on which a body is led


class LedAndFalling(WarningKind, name="led and falling"):
    """`x of truck` is driven, and nothing says what carries the truck and what lies on it: no connection or load but
    drives and weight leads to the ground."""

    def look(self, model: Opened) -> Iterator[ModelWarning]:
        system = model.system
        for body in system.moving:
            rows = [row for row in system.constraint_rows if body.name in row.measure.bodies()]
            leads = [row for row in rows if row.is_driven and isinstance(row.measure, Displacement)]
            weights = [p for p in system.applied_loads if body.name in p.measure.bodies() and _is_weight(system, p)]
            if not leads or not weights:
                continue
            ways = np.array([model.slope(row.measure, model.start) for row in leads])
            weight = np.sum([model.slope(push.measure, model.start) for push in weights], axis=0)
            across = weight - ways.T @ np.linalg.lstsq(ways.T, weight, rcond=None)[0]
            if np.linalg.norm(across) <= _ALONG * np.linalg.norm(weight) or GROUND in _carried_with(
                model, body.name, across / np.linalg.norm(across)
            ):
                continue
            told = Message(
                "{driver} leads {body} along one way alone, and nothing carries it: it falls. Give it a guide, as "
                "guide: {{slider: {{body: {body}, along: {way}}}}}, or a contact with what it stands on",
                driver=leads[0].connection,
                body=body.name,
                way=_way_of(leads[0]),
            )
            yield self.warning(told, "connections", leads[0].connection, about=frozenset((body.name,)))


def _way_of(row: ConstraintRow) -> str:
    """The direction in which a drive leads, as the file says it."""
    assert isinstance(row.measure, Displacement)
    return row.measure.along.name or "right"


def _is_weight(system: System, push: AppliedLoad) -> bool:
    return push.load in system.loads and system.loads[push.load].spread_over == "mass"


def _carried_with(model: Opened, body: str, way: Array) -> set[str]:
    """All that connections and loads join to a body, without drives and weights, and without what acts on it across the
    way on which it would fall, as a level spring."""
    system = model.system
    joined = [set(row.measure.bodies()) for row in system.constraint_rows if not row.is_driven]
    joined += [set(bound.row.measure.bodies()) for bound in system.bounds]
    pushes = [p for p in system.applied_loads if not _is_weight(system, p)]
    pushes = [p for p in pushes if body not in p.measure.bodies() or _acts_along(model, p, way)]
    joined += [set(p.measure.bodies()) for p in pushes]
    found = {body}
    while more := [group for group in joined if group & found and not group <= found]:
        found |= set[str]().union(*more)
    return found


def _acts_along(model: Opened, push: AppliedLoad, way: Array) -> bool:
    slope = model.slope(push.measure, model.start)
    return bool(abs(slope @ way) > _ALONG * np.linalg.norm(slope))
