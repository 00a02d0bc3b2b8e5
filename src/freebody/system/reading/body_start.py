"""Where a body is at the start, and how it moves, by what stands at the body itself."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Any, cast

from freebody.language.sentences import Message
from freebody.language.units import ANGULAR_VELOCITY, LENGTH, VELOCITY
from freebody.measures.geometry import Components
from freebody.model.chains import read_chain
from freebody.model.elements import Start
from freebody.model.names import Names
from freebody.model.noting import did_you_mean
from freebody.system.reading.source import known_keys

POSE_KEYS = {False: ("at", "angle"), True: ("at", "turned")}  # what says where a body is: in the plane, in space


def start_of_body(names: Names, entry: dict[str, Any], default: str, points: Mapping[str, Any]) -> Start:
    """Place, guess and speeds of a body with some points, of which one is meant where none is named."""
    angle = names.angle(entry["angle"], "angle") if "angle" in entry else None
    velocity = entry.get("velocity")
    start = Start(
        _place(names, entry.get("at"), default, points),
        angle,
        None if velocity is None else names.components(velocity, VELOCITY, "velocity"),
        None,
        _guess(names, entry, default, points),
    )
    spin = entry.get("angular_velocity")
    if names.space:
        return _in_space(names, start, entry, spin)
    if spin is None:
        return start
    return replace(start, angular_velocity=names.formula(spin, ANGULAR_VELOCITY, "angular_velocity"))


def _place(names: Names, at: Any, default: str, points: Mapping[str, Any]) -> tuple[str, Components] | None:
    """`at: [x, y]` of the default point, or `at: {P: [x, y]}` of another."""
    if isinstance(at, dict) and len(cast("dict[str, Any]", at)) == 1:
        ((point, pair),) = cast("dict[str, Any]", at).items()
        if point in points:
            return point, names.components(pair, LENGTH, "at", point)
        names.problem(
            Message("there is no point {name}.{hint}", name=point, hint=did_you_mean(point, points)),
            "at",
            point,
        )
    elif isinstance(at, list):
        return default, names.components(cast("list[Any]", at), LENGTH, "at")
    elif at is not None:
        told = Message("at is a position [x, y], or {{point: [x, y]}} of one point; what turns the body is its angle")
        names.problem(told, "at")
    return None


def _guess(names: Names, entry: dict[str, Any], default: str, points: Mapping[str, Any]) -> Start | None:
    """`near: {angle: 30 deg}`: where the search for the start begins."""
    if isinstance(entry.get("near"), dict):
        guess = cast("dict[str, Any]", entry["near"])
        known = POSE_KEYS[names.space]
        known_keys(names, guess, known, "near", "near")
        with names.at("near"):
            return start_of_body(names, {k: guess[k] for k in known if k in guess}, default, points)
    if "near" in entry:
        names.problem(Message("near is a guess, e.g. near: {{angle: 30 deg}}"), "near")
    return None


def _in_space(names: Names, start: Start, entry: dict[str, Any], spin: Any) -> Start:
    """The rotation, where all of it is known, and `angular_velocity: [wx, wy, wz]` along the axes of the ground, or
    `{body: [...]}` along the body's own."""
    turned = entry.get("turned")
    if turned is not None:
        with names.quietly():  # they are told where the chain is read
            chain = read_chain(names, turned, "turned", named=True)
        if not any(turn.name for turn in chain):
            start = replace(start, turned=chain)
    if spin is None:
        return start
    in_body = isinstance(spin, dict)
    if isinstance(spin, dict):
        given = cast("dict[str, Any]", spin)
        if set(given) - {"body", "ground"} or len(given) != 1:
            message = Message(
                "angular_velocity is [wx, wy, wz] along the ground's axes, or {{body: [...]}} along the body's"
            )
            names.problem(message, "angular_velocity")
        in_body = "body" in given
        spin = next(iter(given.values()), None)
    rates = names.components(spin, ANGULAR_VELOCITY, "angular_velocity")
    return replace(start, rates=rates, rates_in_body=in_body)
