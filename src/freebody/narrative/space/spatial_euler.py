"""A body that turns freely: Euler's equations in the components of the angular velocity, without any angles.

    I_x w_x' + (I_z - I_y) w_y w_z = M_x    and so on in turn, along principal axes

Source: Goldstein, Poole & Safko, Classical Mechanics, 3rd ed. 2002, sec. 5.5.
"""

from __future__ import annotations

from collections.abc import Sequence

from freebody.language.expression import Call, Expr, Symbol, add, multiply, number, power, rate_key
from freebody.language.sentences import Argument, Sentence
from freebody.measures.geometry import GROUND
from freebody.model.elements import RigidBody
from freebody.narrative.context import Context
from freebody.narrative.lines.glossary import Meaning, World
from freebody.narrative.lines.naming import asked_entry, asked_symbol, fresh, named, side_of
from freebody.narrative.lines.rates import rate_of
from freebody.narrative.lines.script import Script
from freebody.narrative.questions.state import AnswerParts
from freebody.narrative.space.spatial_frames import axes_of, axes_of_body
from freebody.narrative.space.spatial_kinematics import SpatialKinematics
from freebody.questions.energy import Energy
from freebody.questions.motion import AngularVelocity, OfPoint
from freebody.questions.reading import Question
from freebody.questions.vectors import Group, is_among
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.tidy import tidy


def turns_freely(context: Context, q: AngularVelocity) -> bool:
    """Whether the angular acceleration of a body is asked along its own principal axes, and nothing held turns it."""
    if q.order != 2 or q.size or q.along is not None or q.relative_to != GROUND:
        return False
    return axes_of(q.basis).body == q.body and _is_free(context, q.body)


def free_bodies(context: Context, group: Group) -> bool:
    """Whether all bodies that are meant are turned by angles that only formulas need: nothing is attached to them."""
    bodies = [b for b in context.system.moving if is_among(b.name, group)]
    return (
        all(b.turns and not b.chain and _is_free(context, b.name) for b in bodies)
        and not context.system.constraint_rows
    )


def _is_free(context: Context, body: str) -> bool:
    model = context.setup.model
    turning = model.bodies.slots[model.bodies.n_places :]
    for row in context.system.constraint_rows:
        if any(owner == body and slot in turning for owner, slot in model.gradient(row.measure)):
            return False
    return all(x.is_zero() for x in model.dynamics.inertias[body][6:])


def by_euler(
    context: Context, script: Script, kinematics: SpatialKinematics, question: Question, q: AngularVelocity
) -> None:
    """The angular acceleration along the body's own axes, from Euler's equations."""
    model, f = kinematics.model, kinematics.field
    axes = axes_of_body(context.system, q.body)
    moments_of_inertia = model.dynamics.inertias[q.body][3:6]
    inertia = [tidy(x) for x in moments_of_inertia]
    moments = [f.lowest_terms(model.in_independent_speeds(x)) for x in model.loads.wrenches[q.body][3:]]
    with script.stage("space.euler_stage", "space.euler_hint"):
        w = omega_symbols(context, kinematics, q.body)
        rates = _rates(context, script, w)
        x, y, z = moments_of_inertia
        differences = [f.lowest_terms(d) for d in (z - y, x - z, y - x)]
        gyroscopic = [multiply(tidy(d), w[(k + 1) % 3], w[(k + 2) % 3]) for k, d in enumerate(differences)]
        left = tuple(add(multiply(i, rate), g) for i, rate, g in zip(inertia, rates, gyroscopic, strict=True))
        args: dict[str, Argument] = {"body": q.body, "axes": axes.words}
        is_free = all(m.is_zero() for m in moments)
        why = "space.euler_free" if is_free else "space.euler_moment"
        first = script.line(left, tuple(map(tidy, moments)), why=why, args=args)
    name = asked_symbol(context, question, 3)
    with script.stage("stage.value", "hint.value"):
        script.add(asked_entry(name, question, n=3))
        solved = tuple((tidy(m) - g) / i for m, g, i in zip(moments, gyroscopic, inertia, strict=True))
        divide: dict[str, Argument] = {"line": first}
        second = script.line(side_of(name, 3), solved, why="solve.divide", args=divide, uses=(first,))
        values = _asked(context, question)
        if question.at_start:
            start = start_line(context, script, kinematics, q.body, w)
            uses = (second, start)
            why_start: dict[str, Argument] = {"lines": uses}
            script.line(side_of(name, 3), values, why="space.put_in", args=why_start, uses=uses, when="start")
            return
        _symbols, line = kinematics.omega(q.body, axes)
        more: dict[str, Argument] = {"lines": (second, line)}
        script.line(side_of(name, 3), values, why="space.put_in", args=more, uses=(second, line))


def _asked(context: Context, question: Question) -> tuple[Expr, ...]:
    setup = context.setup
    f = setup.model.field
    state = setup.start_instant if question.at_start else setup.state
    value = question.quantity.value(setup.system, state)
    return tuple(tidy(f.lowest_terms(f.element(x))) for x in value)


def omega_symbols(context: Context, kinematics: SpatialKinematics, body: str) -> tuple[Symbol, ...]:
    """Components of an angular velocity along the body's own axes, without saying by which angles."""

    def reads(world: World) -> Sequence[float]:
        return tuple(AngularVelocity(body, 1).value(context.system, world.snapshot))

    axes = axes_of_body(context.system, body)
    return kinematics.introduce(f"omega_{body}", "omega", body, axes, reads, "rad/s")


def _rates(context: Context, script: Script, w: Sequence[Symbol]) -> tuple[Expr, ...]:
    meanings: list[Meaning] = []
    for symbol in w:
        read = context.glossary.meanings[rate_key(symbol)].read
        assert callable(read)
        what = Sentence("space.rate_of", {"name": symbol})
        meanings.append(Meaning(Call("rate", symbol), what, rate_of(read), "rad/s^2"))
    named(context, script, *meanings)
    return tuple(m.symbol for m in meanings)


def start_line(context: Context, script: Script, kinematics: SpatialKinematics, body: str, w: Sequence[Symbol]) -> int:
    """The angular velocity at the start."""
    model, here = kinematics.model, context.setup.start_instant
    values = tuple(tidy(kinematics.field.lowest_terms(here.here(x))) for x in model.kinematics.velocities[body][3:])
    return script.line(tuple(w), values, why="space.start_turning", args={"body": body}, when="start")


def kinetic_energy_of_free(context: Context, script: Script, kinematics: SpatialKinematics, q: Energy) -> AnswerParts:
    """m v^2/2 + sum of I w^2/2 in components, with their values at the start."""
    lines: list[int] = []
    terms: list[Expr] = []
    with script.stage("space.energies", "space.energies_hint"):
        for b in context.system.moving:
            if is_among(b.name, q.body):
                lines += _energy(context, script, kinematics, b, terms)
    return AnswerParts(tuple(lines), add(*terms))


def _energy(
    context: Context, script: Script, kinematics: SpatialKinematics, b: RigidBody, terms: list[Expr]
) -> list[int]:
    model, half = kinematics.model, number(1) / 2
    w = omega_symbols(context, kinematics, b.name)

    def reads(world: World) -> Sequence[float]:
        return tuple(OfPoint(b.mass_center, 1).value(context.system, world.snapshot))

    v = kinematics.introduce(f"v_{b.name}", "velocity", b.name, axes_of(None), reads, "m/s")
    mass, inertia = tidy(model.dynamics.inertias[b.name][0]), [tidy(x) for x in model.dynamics.inertias[b.name][3:6]]
    squares = add(*(power(x, number(2)) for x in v))
    turning = [multiply(i, power(x, number(2))) for i, x in zip(inertia, w, strict=True)]
    symbol = Symbol(fresh(context, f"T_{b.name}", f"T_{b.name}_k"))
    what = Sentence("symbol.kinetic_of", {"body": b.name})
    named(context, script, Meaning(symbol, what, Energy("kinetic", b.name), "J"))
    terms.append(symbol)
    value = add(multiply(half, mass, squares), multiply(half, add(*turning)))
    line = script.line(symbol, value, why="space.kinetic_formal", args={"body": b.name})
    here, f = context.setup.start_instant, kinematics.field
    at: tuple[Ratio, ...] = model.kinematics.velocities[b.name]
    shown = tuple(tidy(f.lowest_terms(here.here(x))) for x in at)
    first = script.line(tuple(v), shown[:3], why="space.start_moving", args={"body": b.name}, when="start")
    second = script.line(tuple(w), shown[3:], why="space.start_turning", args={"body": b.name}, when="start")
    return [line, first, second]
