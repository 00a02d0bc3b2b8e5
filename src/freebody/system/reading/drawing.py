"""The section `drawing`: `{paths: {shaft: [origin, C, B]}, labels: {left: m_1}, scale: {block: 2},
wheels: {car.rear: 0.3 m}, hide: [theta]}`."""

from __future__ import annotations

from collections.abc import Collection, Iterator
from typing import Any, cast

from freebody.language.expression import Expr
from freebody.language.sentences import Message
from freebody.language.units import LENGTH
from freebody.measures.geometry import GROUND, Point
from freebody.model.looks import Looks
from freebody.model.noting import did_you_mean
from freebody.system.reading.sections import OF_DRAWINGS
from freebody.system.reading.source import Source, known_keys

_MOST = 20.0  # times as large


def read_drawing(source: Source, named: Collection[str]) -> Looks:
    """named: measures, connections and loads, beside bodies and parameters, whose labels may be changed or hidden."""
    entry = source.data.get("drawing")
    names = source.names
    if entry is None:
        return Looks()
    if not isinstance(entry, dict):
        names.problem(Message("drawing is a mapping: {keys}", keys=", ".join(OF_DRAWINGS)), "drawing")
        return Looks()
    entry = cast("dict[str, Any]", entry)
    known_keys(names, entry, OF_DRAWINGS, "drawing", "drawing")
    known = {*named, *names.bodies, *names.parameters}
    paths = dict(_paths(source, entry.get("paths")))
    labels = {name: str(label) for name, label in _known(source, entry.get("labels"), "labels", known)}
    scale = dict(_scales(source, entry.get("scale")))
    hide = [str(name) for name in cast("list[Any]", entry.get("hide") or [])]
    for k, name in enumerate(hide):
        if name not in known:
            _unknown(source, name, known, "hide", k)
    return Looks(paths, labels, scale, dict(_wheels(source, entry.get("wheels"))), frozenset(hide))


def _known(source: Source, value: Any, section: str, known: Collection[str]) -> Iterator[tuple[str, Any]]:
    if value is None:
        return
    if not isinstance(value, dict):
        source.names.problem(Message("{section} is a mapping by name", section=section), "drawing", section)
        return
    for name, item in cast("dict[str, Any]", value).items():
        if name in known:
            yield name, item
        else:
            _unknown(source, name, known, section, name)


def _unknown(source: Source, name: str, known: Collection[str], *path: str | int) -> None:
    hint = did_you_mean(name, known)
    source.names.problem(
        Message("there is nothing called {name} to draw.{hint}", name=name, hint=hint), "drawing", *path
    )


def _paths(source: Source, value: Any) -> Iterator[tuple[str, tuple[str, ...]]]:
    for body, points in _known(source, value, "paths", source.names.bodies):
        own = source.names.bodies[body].points
        found = tuple(str(point) for point in cast("list[Any]", points)) if isinstance(points, list) else ()
        if len(found) < 2:
            source.names.problem(
                Message("a path is a list of two or more points of {body}", body=body), "drawing", "paths", body
            )
            continue
        for k, point in enumerate(found):
            if point not in own:
                hint = did_you_mean(point, own)
                source.names.problem(
                    Message("{body} has no point {point}.{hint}", body=body, point=point, hint=hint),
                    *("drawing", "paths", body, k),
                )
        if all(point in own for point in found):
            yield body, found


def _scales(source: Source, value: Any) -> Iterator[tuple[str, float]]:
    for body, factor in _known(source, value, "scale", source.names.bodies):
        if isinstance(factor, (int, float)) and 0.0 < factor <= _MOST:
            yield body, float(factor)
        else:
            source.names.problem(
                Message("a scale is a number above 0, at most {most:g}", most=_MOST), "drawing", "scale", body
            )


def _wheels(source: Source, value: Any) -> Iterator[tuple[Point, Expr]]:
    """Radii of wheels by the point at which they stand on their road. They are drawn in the plane alone."""
    names = source.names
    if value is None:
        return
    if not isinstance(value, dict):
        names.problem(Message("{section} is a mapping by name", section="wheels"), "drawing", "wheels")
        return
    for text, radius in cast("dict[str, Any]", value).items():
        at = ("drawing", "wheels", text)
        point, size = names.point(text, *at), names.formula(radius, LENGTH, *at)
        known = names.numeric(size)
        if point.body == GROUND:
            names.problem(Message("a wheel is at a point of a body that moves"), *at)
        elif known is not None and known <= 0.0:
            names.problem(Message("the radius of a wheel is above 0"), *at)
        else:
            yield point, size
