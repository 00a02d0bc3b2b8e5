"""The beginning of every derivation: the system in words, its symbols, and how freely it moves."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence
from contextlib import suppress
from typing import Any, cast

import numpy as np

from freebody.errors import CannotAnswer, UnitError
from freebody.language.expression import (
    ONE,
    Expr,
    ProductOf,
    Sum,
    Symbol,
    divide,
    evaluate,
    free_symbols,
    multiply,
    n_operations,
    number,
)
from freebody.language.sentences import Message, Sentence
from freebody.language.units import INERTIA, MASS, Dimension, dimension_of
from freebody.measures.angle import Angle
from freebody.measures.displacement import Displacement
from freebody.measures.distance import Bearing
from freebody.measures.geometry import GROUND, RIGHT, UP, ZERO, Direction, Point
from freebody.model.elements import NonholonomicForm, RigidBody
from freebody.model.named_angles import offered_name
from freebody.model.phrases import phrase_text
from freebody.model.polynomials import polynomial
from freebody.model.states import state_name
from freebody.narrative.context import Context
from freebody.narrative.lines.glossary import of_centre
from freebody.narrative.lines.script import DerivationStage, Diagram, FormulaTable, Legend, Script, ready
from freebody.narrative.questions.blow import tell_blow
from freebody.study.answering.evidence import rank_freedom
from freebody.study.answering.spread import disagreement
from freebody.study.mobility.gruebler import Gruebler, gruebler
from freebody.symbolic.spatial.bodies import SpatialBodies
from freebody.system.system import System
from freebody.tolerances import ROUND_OFF

_ASIDE = 0.1  # of the system's size, or radians: a step away from the start


def opening(context: Context) -> list[DerivationStage]:
    """System, symbols, degrees of freedom."""
    script = Script(context.glossary, context.next_number)
    with script.stage("stage.system"):
        _system(context, script)
    with script.stage("stage.coordinates"):
        _symbols(context, script)
    if context.system.constraint_rows or not context.system.space:
        with script.stage("stage.freedoms", "hint.freedoms"):
            count_freedoms(context, script)
    if context.setup.system.is_struck:
        with suppress(CannotAnswer):
            context.after_blow = tell_blow(context, script)
    context.next_number = script.next_number
    return script.stages


def _system(context: Context, script: Script) -> None:
    system = context.system
    script.add(Diagram((), Sentence("figure.system", {"title": system.title})))
    wanted = ("body", "mass") if system.space else ("body", "mass", "inertia")
    header = tuple(Sentence(f"system.table_{name}") for name in wanted)
    rows = tuple((body.name, *_mass(body), *(() if system.space else _inertia(system, body))) for body in system.moving)
    if rows:
        script.add(FormulaTable(header, rows))
    for text in system.assumptions:
        script.say("system.assumed", text=ready(text))
    script.say("system.rigid")
    script.say("report.conventions_space" if system.space else "report.conventions")


def _mass(body: RigidBody) -> tuple[Sentence | Expr | str]:
    if body.mass == ZERO:  # else only its inertia matters
        return ("–" if body.inertia != ZERO or body.tensor else Sentence("system.massless"),)
    return (_with_unit(_shortened(body.mass), "kg"),)


def _shortened(e: Expr, mass: Expr = ONE) -> Expr:
    """A sum of what parts and holes have, in short, with the mass before lengths: 3 M/4, 5 m R^2/12."""
    whole = polynomial(e).expression()
    if not isinstance(mass, Symbol):  # a product stays as it is written
        return min(*((whole, e) if isinstance(e, Sum) else (e, whole)), key=n_operations)
    return min(multiply(mass, polynomial(divide(e, mass)).expression()), whole, e, key=n_operations)


def _inertia(system: System, body: RigidBody) -> tuple[Sentence | Expr | str]:
    """Where lengths in it are numbers, with their unit: 0.025 m² m, not m/40."""
    if not body.turns or body.inertia == ZERO:
        return ("",)
    inertia = _shortened(body.inertia, body.mass)
    symbols = sorted(free_symbols(inertia) - {"pi"})
    if not symbols or _is_inertia(system, inertia):
        return (_with_unit(inertia, "kg m²"),)
    if len(symbols) == 1 and system.parameters[symbols[0]].dimension == MASS:
        one, *more = (float(evaluate(inertia, {symbols[0]: mass})) for mass in (1.0, 2.0, 3.0))
        if all(abs(x - k * one) <= ROUND_OFF * abs(x) for k, x in enumerate(more, 2)):  # else a body is beside it
            return (Sentence("system.inertia_of", {"size": f"@{one:.4g}", "mass": Symbol(symbols[0])}),)
    return (Sentence("system.in_metres", {"formula": inertia}),)


def _is_inertia(system: System, inertia: Expr) -> bool:
    """Whether its dimension is that of a moment of inertia without the units of its numbers."""
    try:
        return dimension_of(inertia, {p.name: p.dimension for p in system.parameters.values()}) == INERTIA
    except UnitError:
        return False


def _with_unit(e: Expr, unit: str) -> Expr | str:
    """A formula; a plain number with its unit in SI."""
    return e if free_symbols(e) else f"{float(evaluate(e, {})):.6g} {unit}"


def _symbols(context: Context, script: Script) -> None:
    """Parameters, named measures, and the coordinates among them."""
    system = context.system
    entries: list[tuple[Expr, Sentence, str]] = []
    for p in system.parameters.values():
        key = "symbol.function" if p.form is not None else "symbol.parameter"
        entries.append((Symbol(p.name), Sentence(key), _unit(p.dimension)))
    given = cast("dict[str, Any]", system.document.data.get("measures") or {})
    rotations = dict(_rotations(context))
    for name, measure in system.measures.items():
        phrase = phrase_text(given.get(name)) or name
        what = Sentence("symbol.measure", {"phrase": phrase})
        entries.append((Symbol(name), what if name in given else rotations.get(name, what), _unit(measure.dimension)))
    for state in system.states.values():
        entries.append((Symbol(state.name), Sentence("symbol.state"), _unit(state.dimension)))
    context.introduced |= {e[0].name for e in entries if isinstance(e[0], Symbol)} | {"t"}
    hidden, turns = [c for c in _coordinates(context) if c not in context.introduced], _turns_of_balls(context)
    for name in hidden:
        what, unit = (turns[name], "") if name in turns else coordinate_words(context, name)
        entries.append((Symbol(name), what, unit))
        context.introduced.add(name)
    if entries:
        script.add(Legend(tuple(entries)))


def _rotations(context: Context) -> Iterator[tuple[str, Sentence]]:
    """What the angles are by which bodies are turned one after another."""
    for body in context.system.bodies.values():
        named = [turn.name for turn in body.chain if turn.name]
        for n, name in enumerate(named, start=1):
            key = "symbol.rotation_number" if len(named) > 1 else "symbol.rotation_of"
            yield name, Sentence(key, {"body": body.name, "n": f"@{n}"})


def coordinate_words(context: Context, name: str) -> tuple[Sentence, str]:
    """What a coordinate is that the model does not name, and its unit."""
    match context.glossary.measures.get(name):
        case Angle(of, origin, reference) if origin == GROUND and reference == ZERO:
            return Sentence("symbol.angle_of", {"body": of}), ""
        case Bearing(start, end, origin, reference) if origin == GROUND and reference == ZERO:
            return Sentence("symbol.bearing", {"start": str(start), "end": str(end)}), ""
        case Displacement(of, origin, along) if _is_plain(of, origin, along):
            axis = "x" if along.components == RIGHT.components else "y"
            return Sentence(
                "symbol.place", {"of": of_centre(context.system.bodies[of.body]), "axis": f"@letter.{axis}"}
            ), "m"
        case _:
            pass
    for called, connection in context.system.connections.items():  # offered by a joint without a name of its own
        for key, measure in connection.offers(context.system.names):
            if offered_name(called, key, measure) == name:
                kind = "angle_in" if measure.is_angle else "travel_in"
                return Sentence(f"symbol.{kind}", {"connection": called}), "" if measure.is_angle else "m"
    return Sentence("symbol.coordinate"), ""


def _is_plain(of: Point, origin: Point, along: Direction) -> bool:
    """Whether a mass centre is seen along an axis of the ground from its origin."""
    axes = (RIGHT.components, UP.components)
    return (
        origin.body == along.body == GROUND
        and along.components in axes
        and not any(part != ZERO for part in (*of.offset, *origin.offset))
    )


def _coordinates(context: Context) -> list[str]:
    try:
        model = context.setup.model
    except CannotAnswer:
        return []
    return [c.name for c in (*model.coordinates, *model.dependent) if not state_name(c.name)]


def _turns_of_balls(context: Context) -> dict[str, Sentence]:
    """What the coordinates are of which the rates are the components of an angular velocity."""
    bodies = context.setup.model.bodies if context.system.space and context.setup.system.unfollowed else None
    turns = bodies.turns_of_balls if isinstance(bodies, SpatialBodies) else dict[str, tuple[str, int]]()
    return {
        name: Sentence("space.turn_of_ball", {"body": body, "axis": f"@{'xyz'[k]}"})
        for name, (body, k) in turns.items()
    }


def _unit(dimension: Dimension) -> str:
    text = str(dimension)
    return "" if text == "1" else text


def count_freedoms(context: Context, script: Script) -> int:
    """The count by bodies and constraints, and what the rank says; returns the degrees of freedom."""
    found = gruebler(context.setup.system)
    if context.system.blows:
        closing = tuple(name for blow in context.system.blows for name in blow.closing)
        if closing:
            script.say("freedom.closes_later", names=closing)
    elif context.system.bounds or context.system.dry_friction:
        script.say("freedom.first_phase")
    script.say("freedom.count_space" if found.space else "freedom.count")
    header = tuple(Sentence(f"system.table_{name}") for name in ("connection", "kind", "between", "constraints"))
    kinds = {c.kind: Sentence("sheet.kind_of", {"kind": f"@kind.{c.kind}"}) for c in found.connections}
    rows = tuple((c.connection, kinds[c.kind], ", ".join(c.between), number(c.n)) for c in found.connections)
    if rows:
        script.add(FormulaTable(header, rows))
    count_line(script, found)
    return _by_rank(context, script, found.count)


def times(n: int, k: int) -> Expr:
    """n for each of k, as it is counted: 3 times 5, not 15."""
    return ProductOf((number(n), number(k))) if k > 1 else number(n * k)


def count_line(script: Script, found: Gruebler) -> int:
    """Freedoms of the bodies, minus what the rows take away, as a line."""
    terms: list[Expr] = []
    if found.bodies or not found.particles:
        terms.append(times(found.n, len(found.bodies)))
    if found.particles:
        terms.append(times(found.n_point, len(found.particles)))
    terms += [number(-found.n_constraints)] if found.n_constraints else []
    if len(terms) == 1:
        return script.line(number(found.count), label=Sentence("label.freedoms"), when="never")
    return script.line(Sum(tuple(terms)), number(found.count), label=Sentence("label.freedoms"), when="never")


def _binds_more_beside(context: Context) -> bool:
    """Whether velocity constraints bind more a step away from the start than in it, so that no motion goes there."""
    rows, draw = context.system.constraint_rows, context.setup.draws[0]
    if not any(isinstance(row.measure, NonholonomicForm) for row in rows):
        return False
    try:
        draw.reference.wander(draw.q, np.random.default_rng(0), _ASIDE)
    except CannotAnswer:
        return True
    return False


def _by_connection(rows: Sequence[str], connections: Sequence[str]) -> tuple[Sentence, ...]:
    """How many constraints of which connections: a row by itself has no name that a reader knows."""
    counts = Counter(row.partition(".")[0] for row in rows)
    alike: dict[int, list[str]] = {}
    for name in sorted(counts, key=lambda name: connections.index(name) if name in connections else len(connections)):
        alike.setdefault(counts[name], []).append(name)
    return tuple(
        Sentence(
            f"freedom.of_connection{'s' if more else ''}", {"n": n, "connection": (first, *more) if more else first}
        )
        for n, (first, *more) in alike.items()
    )


def _by_rank(context: Context, script: Script, count: int) -> int:
    """What the rank of the constraint Jacobian leaves; raises RoutesDisagree where the coordinates are not as many."""
    n = rank_freedom(context.setup) - len(context.system.states)
    left = Sentence("freedom.left", {"n": n})
    try:
        model = context.setup.model
    except CannotAnswer:
        script.say("freedom.rank_only", left=left)
        return n
    n_free = model.degrees_of_freedom - len(context.system.states)
    if n > n_free and _binds_more_beside(context):
        singular = Message(
            "the start is a singular pose: the velocity constraints leave {n} freedoms in it and {m} a step away. "
            "Start from another pose",
            n=n,
            m=n_free,
        )
        raise CannotAnswer(singular)
    if n != n_free:
        differ = Message("the formulas have {n} independent coordinates, the rank leaves {m}", n=n_free, m=n)
        raise disagreement(differ, context.setup.draws[0].reference)
    if n == count:
        script.say("freedom.confirmed")
    elif model.redundant:
        sets = _by_connection(model.redundant, tuple(context.system.connections))
        script.say("freedom.redundant", sets=sets, left=left)
    else:
        script.say("freedom.rank_only", left=left)
    names = tuple(Symbol(c.name) for c in model.coordinates if not state_name(c.name))
    alone = "freedom.coordinates_driven" if gruebler(context.setup.system).drivers else "freedom.coordinates_none"
    script.say("freedom.coordinates" if names else alone, names=names)
    if model.dependent:
        bound = "freedom.driven" if model.loops else "freedom.rates"
        script.say(bound, names=tuple(Symbol(c.name) for c in model.dependent))
    if context.system.states:
        script.say("freedom.states", names=tuple(map(Symbol, context.system.states)))
    return n
