"""The section `start`: values and rates of named measures, and the assembly mode."""

from __future__ import annotations

import re
from collections.abc import Container, Mapping
from dataclasses import replace

from freebody.language.document.writer import flow_text
from freebody.language.expression import Expr, name_problem
from freebody.language.folded import folded
from freebody.language.sentences import Message
from freebody.language.units import TIME
from freebody.measures.base import Measure
from freebody.measures.geometry import GROUND
from freebody.model.names import Names
from freebody.model.noting import did_you_mean
from freebody.model.phrases import read_measure
from freebody.system.reading.source import Source

_OF_ONE = {  # what people write of the one body that they think of
    **dict.fromkeys(("velocity", "speed", "initial_velocity", "initial_speed", "v0", "v"), "rate(x of {body})"),
    **dict.fromkeys(("angular_velocity", "omega", "initial_angular_velocity"), "rate(angle of {body})"),
    **dict.fromkeys(("position", "displacement", "initial_position", "initial_displacement"), "x of {body}"),
}


def _is_mode(source: Source, key: str) -> bool:
    return key == "mode" and "mode" not in source.names.measures


def read_mode(source: Source) -> str | None:
    """`start: {mode: crossed}`: the assembly mode by name, where the connections leave several."""
    start = source.mapping("start")
    if "mode" not in start or not _is_mode(source, "mode"):
        return None
    if not isinstance(start["mode"], str):
        source.names.problem(Message("mode is the name of an assembly mode, e.g. mode: crossed"), "start", "mode")
    return str(start["mode"])


def read_start(source: Source, measures: Mapping[str, Measure]) -> tuple[dict[str, Expr], dict[str, Expr]]:
    """`start: {theta: 30 deg, rate(theta): 0}`; theta' and theta_dot also mean the rate."""
    start: dict[str, Expr] = {}
    rates: dict[str, Expr] = {}
    names = source.names
    for key, value in source.mapping("start").items():
        if _is_mode(source, key):
            continue
        if key in names.states:
            state = names.states[key]
            names.states[key] = replace(state, start=names.formula(value, state.dimension, "start", key))
            continue
        key, measures = _with_phrase(names, key, measures)
        name = key if key in measures else rate_of(key, {*measures, *names.broken})
        if name not in measures:
            known = [*measures, *names.states, *(f"rate({m})" for m in measures)]
            hint = did_you_mean(key, known)
            body = next((body.name for body in names.bodies.values() if body.name != GROUND and not body.fixed), "")
            of_body, _, coordinate = key.partition(".")
            if of_body in names.bodies and coordinate:
                of = coordinate if coordinate in ("x", "y") else "angle"
                example = (
                    f"measures: {{{coordinate}_{of_body}: {of} of {of_body}}}, start: {{{coordinate}_{of_body}: ...}}"
                )
                hint = Message(" Say what it is, e.g. {example}", example=example)
            elif body and (said := _OF_ONE.get(folded(key))) is not None:
                example = f"{said.format(body=body)}: {flow_text(value)}"
                hint = Message(" Say of what, e.g. start: {{{example}}}", example=example)
            elif not known and body and not name_problem(name):
                of = f"angle of {body} from down" if names.bodies[body].turns else f"x of {body}"
                example = f"measures: {{{name}: {of}}}"
                hint = Message(" Say what it is, e.g. {example}", example=example)
                if names.bodies[body].turns:
                    hint = Message(" Say what it is, e.g. {example}, or from right", example=example)
            if (of := _body_of(names, key)) is not None:
                hint = Message(
                    " How a body moves at the start stands at the body: {body}: {{velocity: {example}}}",
                    body=of,
                    example=f"[{value}, 0]",
                )
            told = Message("{key} is no named measure or rate of one.{hint}", key=key, hint=hint)
            names.unknown(name, told, "start", key)
            continue
        if isinstance(value, Mapping):
            told = Message("start has values: {name}: ..., and the rate beside it as rate({name}): ...", name=name)
            names.problem(told, "start", key)
            continue
        dimension = measures[name].dimension
        if name == key and measures[name].is_angle:
            start[name] = names.angle(value, "start", key)
        elif name == key:
            start[name] = names.formula(value, dimension, "start", key)
        else:
            rates[name] = names.formula(value, dimension / TIME, "start", key)
    return start, rates


def _body_of(names: Names, key: str) -> str | None:
    """The body of which a key says the velocity: `velocity of car`, `v_car`, `v car`."""
    of, own = r"(?:velocity|speed|Geschwindigkeit)(?: (?:of|von))?[ _](\w+)", r"(\w+)[ _.](?:velocity|speed)"
    words = re.fullmatch(rf"{of}|{own}|v[ _](\w+)", key)
    body = next((word for word in words.groups() if word), "") if words else ""
    return body if body in names.bodies and body != GROUND else None


def _with_phrase(names: Names, key: str, measures: Mapping[str, Measure]) -> tuple[str, Mapping[str, Measure]]:
    """A key that says in words what it is a value of, `rate(x of block)`, `angular velocity of wheel`, with a name for
    that among the measures."""
    turning = key.removeprefix("angular velocity of ")
    if turning != key and turning in names.bodies and not names.space:
        key = f"rate(angle of {turning})"
    inner = key.removeprefix("rate(").removesuffix(")") if key.startswith("rate(") else key
    if inner in measures or not ({" ", "."} & {*inner.strip()}):
        return key, measures
    with names.quietly():
        measure = read_measure(names, inner)
    own = re.sub(r"\W+", "_", inner).strip("_")
    if measure is None or name_problem(own) is not None or measures.get(own, measure) != measure:
        return key, measures
    named = next((n for n, m in measures.items() if m == measure), own)
    names.measures.setdefault(named, measure)
    return key.replace(inner, named), names.measures


def rate_of(key: str, known: Container[str]) -> str:
    """What a key is the rate of; the key itself where it is none of these."""
    for before, after in (("rate(", ")"), ("", "'"), ("", "_dot"), ("rate of ", ""), ("velocity of ", "")):
        inner = key.removeprefix(before).removesuffix(after)
        if len(inner) == len(key) - len(before + after) and inner in known:
            return inner
    return key
