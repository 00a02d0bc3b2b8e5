"""What a sweep looks like: curves over one axis, cells over two, parallel coordinates over more and over samples."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray

from freebody.errors import InputError
from freebody.language.sentences import Message
from freebody.numeric.jets import Array
from freebody.present.charts.cells import heat_map, kinds_map
from freebody.present.charts.lines import line_chart
from freebody.present.charts.parallel import parallel_chart
from freebody.present.picture.picture import Picture
from freebody.study.sweeps.statuses import STATUSES
from freebody.study.sweeps.swept import Swept

KINDS = ("line", "heat", "parallel", "regions")
_MOST_CURVES = 7


def chart(result: Swept, name: str, kind: str = "") -> Picture:
    """A picture of a column, or, as regions, of which formula or status holds. Raises InputError for what is not there,
    and for a kind that the axes do not allow."""
    kind = kind or _usual(result)
    if kind not in KINDS:
        raise InputError(Message("there is no chart {kind}; take {kinds}", kind=kind, kinds=", ".join(KINDS)))
    axes = list(result.plan.axes)
    needed = {"heat": 2, "regions": 2}.get(kind, 0)
    if needed and (len(axes) != needed or len(result.plan.dimensions) != needed):
        told = Message(
            "a chart {kind} needs a grid of two names, not {n} axes", kind=kind, n=len(result.plan.dimensions)
        )
        raise InputError(told)
    if kind == "line" and len(result.plan.dimensions) > 2:
        raise InputError(Message("a chart {kind} needs a grid of two names, not {n} axes", kind=kind, n=len(axes)))
    return {"line": _lines, "heat": _heat, "parallel": _parallel, "regions": _regions}[kind](result, name)


def charts(result: Swept) -> Iterator[Picture]:
    """One of each column that has two different numbers, and of what holds where if that is not everywhere the same."""
    kind = _usual(result)
    for column in result.columns:
        s = result.statistics[column.name]
        if s.n > 1 and s.least < s.greatest:
            yield chart(result, column.name, kind)
    if kind == "heat":
        for evaluator in result.evaluators:
            if (
                len(np.unique(evaluator.kinds(result.parameters(), result.n)[0])) > 1
                or len(result.counts[evaluator.name]) > 1
            ):
                yield chart(result, evaluator.name, "regions")


def _usual(result: Swept) -> str:
    sizes = list(result.plan.dimensions.values())
    if len(result.plan.axes) < len(sizes):  # cases are drawn
        return "line" if len(sizes) == 1 and len(result.plan.names) == 1 else "parallel"
    if len(sizes) == 1 or (len(sizes) == 2 and min(sizes) <= _MOST_CURVES < max(sizes)):
        return "line"
    return "heat" if len(sizes) == 2 else "parallel"


def _shown(result: Swept, name: str) -> tuple[str, float]:
    """The name with its unit, and by what numbers in SI are multiplied; angles are shown in degrees."""
    units = {v.name: v.unit for v in result.plan.names} | {c.name: c.unit for c in result.columns}
    unit = units[name]
    if unit == "rad":
        return f"{name} [deg]", 180.0 / math.pi
    return (name if unit in ("", "1") else f"{name} [{unit}]"), 1.0


def _scaled(result: Swept, name: str, values: Array) -> tuple[str, Array]:
    label, factor = _shown(result, name)
    return label, values * factor


def _lines(result: Swept, name: str) -> Picture:
    y_label, z = _scaled(result, name, result.values(name))
    if len(result.plan.axes) < len(result.plan.dimensions):  # of drawn cases, dots
        only = result.plan.names[0].name
        x_label, x = _scaled(result, only, result.values(only).ravel())
        return line_chart(_over(result, name, only), x_label, x, y_label, [(name, z.ravel())], is_joined=False)
    sizes = result.plan.dimensions
    across = max(sizes, key=lambda axis: sizes[axis])
    x_label, x = _scaled(result, across, result.plan.axes[across])
    others = [axis for axis in sizes if axis != across]
    if not others:
        return line_chart(_over(result, name, across), x_label, x, y_label, [(name, z)])
    label, values = _scaled(result, others[0], result.plan.axes[others[0]])
    z = np.moveaxis(z, list(sizes).index(across), -1)
    head, _, unit = label.partition(" [")
    curves = [(f"{head} = {value:.6g} {unit.rstrip(']')}".strip(), row) for value, row in zip(values, z, strict=True)]
    return line_chart(_over(result, name, across), x_label, x, y_label, curves[:_MOST_CURVES])


def _over(result: Swept, name: str, axis: str) -> str:
    return result.in_language(Message("{name} over {x}", name=name, x=axis))


def _plane(result: Swept) -> tuple[str, Array, str, Array]:
    y, x = result.plan.axes
    return (*_scaled(result, x, result.plan.axes[x]), *_scaled(result, y, result.plan.axes[y]))


def _heat(result: Swept, name: str) -> Picture:
    label, z = _scaled(result, name, result.values(name))
    x_label, x, y_label, y = _plane(result)
    title = result.in_language(Message("{name} over {x} and {y}", name=name, x=x_label, y=y_label))
    return heat_map(title, x_label, x, y_label, y, label, z, missing=result.in_language(Message("no number")))


def _regions(result: Swept, name: str) -> Picture:
    names = [e.name for e in result.evaluators]
    own = next((e for e in result.evaluators if name == e.name or name in [c.name for c in e.columns]), None)
    if own is None:
        raise InputError(Message("the sweep has no {name}; it has {names}", name=name, names=", ".join(names)))
    which, words = own.kinds(result.parameters(), result.n)
    status = result.status(own.name).ravel()
    kinds = [*words, *STATUSES]
    index: NDArray[np.int64] = np.where(
        which >= 0, which, len(words) + np.array([STATUSES.index(str(s)) for s in status])
    )
    x_label, x, y_label, y = _plane(result)
    shape: Any = tuple(result.plan.dimensions.values())
    title = result.in_language(Message("{name}: what holds over {x} and {y}", name=own.name, x=x_label, y=y_label))
    used, places = np.unique(index, return_inverse=True)
    shown = [result.in_language(kinds[int(k)]) for k in used]
    missing = result.in_language(Message("not known"))
    return kinds_map(title, x_label, x, y_label, y, shown, places.reshape(shape), missing=missing)


def _parallel(result: Swept, name: str) -> Picture:
    names = [*(v.name for v in result.plan.names), name]
    pairs = [_scaled(result, each, result.values(each).ravel()) for each in names]
    title = result.in_language(Message("{name} by case", name=name))
    return parallel_chart(title, [label for label, _x in pairs], np.column_stack([x for _label, x in pairs]))
