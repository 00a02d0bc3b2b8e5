"""Curves over time: one panel for each unit, with the instants of events.

The lines are told apart by colour and by dashes, so that they also differ in print and for people of all kinds of
colour vision.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any, cast

import numpy as np

from freebody.errors import InputError
from freebody.messages import Message
from freebody.model.noting import did_you_mean
from freebody.present.figures import Array
from freebody.present.files import replaced
from freebody.present.recording import Recording
from freebody.present.theme import THEMES, Theme

if TYPE_CHECKING:
    from matplotlib.figure import Figure

_SUFFIXES = (".png", ".svg", ".pdf")
_DASHES = ((), (6.0, 2.0), (2.0, 1.5), (6.0, 2.0, 1.5, 2.0))
# what can be asked of a body: body.<word> by the variable that holds it, and its axis
_OF_BODIES = {
    "x": ("body_position", "x"),
    "y": ("body_position", "y"),
    "angle": ("body_angle", ""),
    "x_velocity": ("body_velocity", "x"),
    "y_velocity": ("body_velocity", "y"),
    "angular_velocity": ("body_angular_velocity", ""),
    "x_acceleration": ("body_acceleration", "x"),
    "y_acceleration": ("body_acceleration", "y"),
    "angular_acceleration": ("body_angular_acceleration", ""),
}


@dataclass(frozen=True)
class Curve:
    """One line: its name, what it is in words, its unit and its values (n_times,)."""

    name: str
    label: str
    unit: str
    values: Array


def plot(
    recording: Recording,
    names: Sequence[str] = (),
    *,
    events: Iterable[tuple[str, float]] = (),
    dark: bool = False,
    time: str = "time",
) -> Figure:
    """Curves of a simulation over time, one panel for each unit.

    names: variables over time, variables over time and bodies (then all bodies), or one component of a body
    (`crank.angle`, `crank.x`, `crank.y`, `crank.angular_velocity`, `crank.x_velocity` ...). Without names: the named
    measures of the model (`recording.attributes["measures"]`), else angles and positions of all bodies. events: (name,
    time [s]), drawn as thin vertical lines; time: what the axis is called. Raises InputError for a name that is not
    there."""
    found = list(curves(recording, names))
    panels: dict[str, list[Curve]] = {}
    for curve in found:
        panels.setdefault(curve.unit, []).append(curve)
    return figure_over(recording.times, panels, f"{time} [s]", list(events), dark=dark)


def save(figure: Figure, path: str | Path) -> Path:
    """Writes a figure as `.png`, `.svg` or `.pdf`, by the suffix of the path. Returns the path. Raises InputError for
    another suffix, or if the file cannot be written."""
    path = Path(path)
    if path.suffix.lower() not in _SUFFIXES:
        raise InputError(f"{path.name}: a plot is written as {', '.join(_SUFFIXES)}; give one of these suffixes")
    with replaced(path) as file:
        cast("Any", figure).savefig(file, dpi=150, facecolor=figure.get_facecolor())
    return path


def _nearest(name: str, everything: Iterable[str], series: Sequence[str]) -> str:
    """The nearest of all curves, or else the measures, reactions and loads that there are."""
    nearest = did_you_mean(name, everything)
    return nearest if "Did you mean" in nearest else f" There is: {', '.join(series)}, and crank.x for a body crank."


def curves(recording: Recording, names: Sequence[str] = ()) -> Iterator[Curve]:
    """The curves that names stand for. Raises InputError naming all that are not there."""
    everything = _offered(recording)
    chosen = list(names) or _usual(recording)
    unknown = [name for name in chosen if name not in everything]
    if unknown:
        series = recording.over_time
        raise InputError("\n".join(f"there is no curve {n}.{_nearest(n, everything, series)}" for n in unknown))
    for each in dict.fromkeys(part for name in chosen for part in everything[name]):
        yield _curve(recording, each)


def _offered(recording: Recording) -> dict[str, list[str]]:
    """What each name stands for: itself, or one curve for each body and axis."""
    offered = {name: [name] for name in recording.over_time}
    bodies = recording.labels.get("body", ())
    for word, (variable, _axis) in _OF_BODIES.items():
        if variable in recording.series:
            each = [f"{body}.{word}" for body in bodies]
            offered.update((name, [name]) for name in each if name not in offered)
            offered.setdefault(variable, []).extend(each)
    return offered


def _usual(recording: Recording) -> list[str]:
    measures = [str(name) for name in recording.attributes.get("measures", ())]
    return measures or [name for name in ("body_angle", "body_position") if name in recording.series]


def _curve(recording: Recording, name: str) -> Curve:
    if name in recording.series:
        series, words = recording.series[name], recording.series[name].long_name
        values = series.values
    else:
        body, _, word = name.rpartition(".")
        variable, axis = _OF_BODIES[word]
        series, words = recording.series[variable], ""
        values = recording.of(variable, **({"body": body} | ({"axis": axis} if axis else {})))
    label = Message("{name}: {what}", name=name, what=words) if words and words != name else name
    return Curve(name, label, series.unit or "1", np.asarray(values, dtype=np.float64))


# -- drawing ----------------------------------------------------------------------------------
def figure_over(
    times: Array,
    panels: dict[str, list[Curve]],
    x_label: str,
    events: Sequence[tuple[str, float]] = (),
    *,
    dark: bool = False,
) -> Figure:
    """Panels by unit over the time, or whatever else goes on evenly, with the instants of events."""
    from freebody.present.shown_figure import shown_figure

    theme = THEMES["dark" if dark else "light"]
    figure: Any = shown_figure(9.0, 0.8 + 2.4 * max(1, len(panels)))
    figure.set_facecolor(theme.paper)
    stack = figure.subplots(max(1, len(panels)), 1, sharex=True, squeeze=False)[:, 0]
    for axes, (unit, group) in zip(stack, panels.items(), strict=False):
        _panel(axes, times, unit, group, theme)
    for k, axes in enumerate(stack):
        for name, time in events:
            axes.axvline(time, color=theme.muted, linewidth=0.8, zorder=1)
            if k == 0:
                at = axes.get_xaxis_transform()
                text = {"fontsize": 8, "color": theme.muted, "parse_math": False, "rotation": 35}
                axes.text(time, 1.02, name, transform=at, ha="left", va="bottom", rotation_mode="anchor", **text)
    stack[-1].set_xlabel(_literal(x_label), color=theme.ink)
    return figure


def _panel(axes: Any, times: Array, unit: str, group: Sequence[Curve], theme: Theme) -> None:
    for k, curve in enumerate(group):
        n = len(theme.bodies)
        style: dict[str, Any] = {"color": theme.bodies[k % n], "linewidth": 1.6, "zorder": 2}
        dashes = _DASHES[k % len(_DASHES)]
        marker = "o" if len(times) == 1 else ""
        axes.plot(times, curve.values, label=_literal(curve.label), dashes=dashes, marker=marker, **style)
    quantity = group[0].label.partition(": ")[2] if len(group) == 1 else ""
    text = _literal(f"{quantity or (group[0].name if len(group) == 1 else '')} [{unit}]".strip())
    axes.set_ylabel(text, color=theme.ink, wrap=True)
    axes.set_facecolor(theme.paper)
    axes.grid(True, color=theme.faint, linewidth=0.6, zorder=0)
    axes.tick_params(colors=theme.muted, labelcolor=theme.ink)
    axes.margins(x=0.0)
    for spine in axes.spines.values():
        spine.set_color(theme.muted)
    beside = {"loc": "upper left", "bbox_to_anchor": (1.01, 1.0), "borderaxespad": 0.0}
    axes.legend(frameon=False, labelcolor=theme.ink, fontsize=9, **beside)


def _literal(text: str) -> str:
    """Text in which Matplotlib sees no mathematics."""
    return text.replace("$", r"\$")
