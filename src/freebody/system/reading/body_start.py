"""Where a body is at the start, and how it moves, by what stands at the body itself."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Any, cast

from freebody.language.document.writer import flow_text
from freebody.language.expression import ZERO
from freebody.language.sentences import Message
from freebody.language.units import ANGULAR_VELOCITY, VELOCITY
from freebody.measures.geometry import Components
from freebody.model.chains import read_chain
from freebody.model.elements import Start
from freebody.model.names import Names
from freebody.model.noting import did_you_mean
from freebody.system.reading.source import known_keys
from freebody.system.reading.two_places import angle_by_two, place_of_point, turn_by_two, two_points

POSE_KEYS = {False: ("at", "angle"), True: ("at", "turned")}  # what says where a body is: in the plane, in space


def start_of_body(names: Names, entry: dict[str, Any], default: str, points: Mapping[str, Any]) -> Start:
    """Place, guess and speeds of a body with some points, of which one is meant where none is named."""
    angle = names.angle(entry["angle"], "angle") if "angle" in entry else None
    two = two_points(names, entry.get("at"))
    if names.space and two and not _is_straight(points):
        two = None
    if two and set(two) <= set(points) and not names.space:
        if angle is not None:
            told = Message("at gives two points of the body, which say how it is turned: leave out its angle")
            names.problem(told, "angle")
        angle = angle_by_two(names, entry["at"], points)
    velocity = entry.get("velocity")
    if not names.space and isinstance(velocity, str | int | float) and "angle" in entry:
        told = Message(
            "a velocity has two components, and angle says how the body is turned: velocity: [{v}*cos({a}), "
            "{v}*sin({a})]",
            v=velocity,
            a=entry["angle"],
        )
        names.problem(told, "velocity")
        velocity = None
    start = Start(
        _place(names, entry.get("at"), default, points, two is not None),
        angle,
        None if velocity is None else names.components(velocity, VELOCITY, "velocity"),
        None,
        _guess(names, entry, default, points),
    )
    spin = entry.get("angular_velocity")
    if names.space:
        by_ends = turn_by_two(names, entry["at"], points) if two and "turned" not in entry else None
        return _in_space(names, start if by_ends is None else replace(start, turned=by_ends), entry, spin)
    if spin is None:
        return start
    return replace(start, angular_velocity=names.formula(spin, ANGULAR_VELOCITY, "angular_velocity"))


def _is_straight(points: Mapping[str, Components]) -> bool:
    """Whether the ends of a body are on its x axis, as those of a rod."""
    ends = [points[each] for each in ("start", "end") if each in points]
    return len(ends) == 2 and all(part == ZERO for end in ends for part in end[1:])


def _place(
    names: Names, at: Any, default: str, points: Mapping[str, Any], are_two: bool
) -> tuple[str, Components] | None:
    """`at: [x, y]` of the default point, `at: {P: [x, y]}` of another, or in the plane `{P: [x, y], Q: [x, y]}` of two;
    a point of the ground may stand for its coordinates."""
    if isinstance(at, dict) and (len(cast("dict[str, Any]", at)) == 1 or are_two):
        given = cast("dict[str, Any]", at)
        for point in given.keys() - set(points):
            told = Message("there is no point {name}.{hint}", name=point, hint=did_you_mean(point, points))
            names.problem(told, "at", point)
        point = next(iter(given))
        return (point, place_of_point(names, given[point], "at", point)) if set(given) <= set(points) else None
    if isinstance(at, list) or (isinstance(at, str) and at.strip()):
        return default, place_of_point(names, at, "at")
    if names.space and isinstance(at, dict) and at:
        of = [*cast("dict[str, Any]", at)][-1]
        told = Message(
            "in space at puts one point, {example}; joints put the others, or turned says how the body is turned, as "
            "turned: [30 deg about z]",
            example=f"at: {{{of}: {flow_text(at[of])}}}",
        )
        names.problem(told, "at")
    elif names.space and at is not None:
        names.problem(Message("at is a position in space, as {example}", example=f"at: {{{default}: [0, 0, 0]}}"), "at")
    elif at is not None:
        told = Message(
            "at is a position [x, y], {{point: [x, y]}} of one point, or in the plane of two, as {{start: [0, 0], end: "
            "[a, h]}}"
        )
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
