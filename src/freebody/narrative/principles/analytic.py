"""Lagrange's equations, and the rate of energy: accelerations without reactions.

Lagrange: d/dt dT/du_k - dT/dq_k = Q_k with the generalized forces Q_k = sum of loads * d(measure)/dq_k, for independent
coordinates of holonomic systems. Energy: dT/dt is the power of all loads, for one degree of freedom.
Source: Goldstein, Poole & Safko, Classical Mechanics, 3rd ed. 2002, sec. 1.4.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

from freebody.errors import CannotAnswer
from freebody.language.expression import Expr, Symbol, add, multiply, number
from freebody.language.sentences import Message, Sentence
from freebody.model.elements import NonholonomicForm
from freebody.narrative.context import Context
from freebody.narrative.lines.glossary import Meaning, World
from freebody.narrative.lines.script import Script
from freebody.narrative.principles.elimination import EliminationRow, Solver, Unknowns
from freebody.present.report.blocks import Derivative, Difference
from freebody.questions.energy import Energy
from freebody.questions.loads import Power
from freebody.questions.motion import rates_of
from freebody.symbolic.model import SymbolicModel
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.tidy import tidy
from freebody.symbolic.unknowns import Coordinate


def by_lagrange(context: Context, script: Script, asked: Sequence[int]) -> dict[int, tuple[Ratio, int]]:
    """The accelerations of coordinates by Lagrange's equations. Raises CannotAnswer for reactions, closed loops and
    velocity constraints."""
    model = context.setup.model
    _check(model, asked, Message("Lagrange's equations"))
    T = kinetic_energy(context)
    with script.stage("stage.lagrange", "hint.lagrange"):
        t_line = _kinetic_line(context, script, T)
        rows: list[EliminationRow] = []
        for c in model.coordinates:
            rows.append(_equation(context, script, c, T, t_line))
    solver = Solver(model, script, _unknowns(model))
    rows = [solver.cleared(row) for row in rows]
    with script.stage("stage.solution", "hint.solution", n=len(rows)):
        _collected(script, solver, rows)
        return solver.solve(rows, list(asked))


def by_energy(context: Context, script: Script, asked: Sequence[int]) -> dict[int, tuple[Ratio, int]]:
    """The acceleration by the rate of energy, for one degree of freedom."""
    model = context.setup.model
    _check(model, asked, Message("the rate of energy"))
    if model.degrees_of_freedom != 1:
        raise CannotAnswer(
            Message(
                "energy gives one equation, and there are {n} degrees of freedom; take newton or lagrange",
                n=model.degrees_of_freedom,
            )
        )
    f, (c,) = model.field, model.coordinates
    T = kinetic_energy(context)
    u = f.variable(c.speed)
    with script.stage("stage.energy", "hint.energy"):
        t_line = _kinetic_line(context, script, T)
        rate = f.lowest_terms(model.rate(T))
        power = f.lowest_terms(model.dynamics.generalized_force(c) * u)
        d_line = script.line(
            Derivative(kinetic_symbol(context), Symbol("t")),
            tidy(rate),
            why="energy.rate",
            args={"line": t_line},
            uses=(t_line,),
        )
        p_line = script.line(_power_symbol(context, script), tidy(power), why="energy.power")
        rows = [_row(model, f.lowest_terms(rate / u), f.lowest_terms(power / u), d_line)]
    solver = Solver(model, script, _unknowns(model))
    with script.stage("stage.solution", "hint.solution", n=1):
        row = solver.cleared(rows[0])
        left, right = solver.sides(row)
        row.number = script.line(
            left, right, why="energy.equal", args={"lines": (d_line, p_line)}, uses=(d_line, p_line)
        )
        return solver.solve([row], list(asked))


def _power_symbol(context: Context, script: Script) -> Symbol:
    loads = list(context.system.loads)

    def read(world: World) -> float:
        return float(sum(Power(load).value(context.system, world.snapshot) for load in loads))

    what, symbol = Sentence("symbol.power", {"loads": tuple(loads)}), context.symbol("P", "P_loads")
    script.introduce(Meaning(symbol, what, read, "W"))
    return symbol


def energy_terms(context: Context, script: Script, *, is_kept: bool = True) -> list[int]:
    """Kinetic and potential energy as lines: what the integral of energy is made of. is_kept: whether their sum is."""
    f = context.setup.model.field
    with script.stage("stage.energy", "hint.energy"):
        t_line = _kinetic_line(context, script, kinetic_energy(context))
        value = Energy("potential", None).value(context.system, context.setup.state)
        V = f.element(value) if not isinstance(value, Ratio) else f.lowest_terms(value)
        what = Sentence("symbol.potential")
        symbol = context.symbol("V", "E_pot")
        script.introduce(Meaning(symbol, what, Energy("potential"), "J"))
        v_line = script.line(symbol, tidy(V), why="energy.potential")
        if is_kept:
            script.say("energy.no_work")
    return [t_line, v_line]


def kinetic_symbol(context: Context) -> Symbol:
    return context.symbol("T", "E_kin")


# -- parts ------------------------------------------------------------------------------------
def kinetic_energy(context: Context) -> Ratio:
    """In coordinates and independent speeds."""
    state, f = context.setup.state, context.setup.model.field
    return f.lowest_terms(f.element(Energy("kinetic", None).value(context.system, state)))


def _check(model: SymbolicModel, asked: Sequence[int], what: str) -> None:
    if not set(asked) <= set(model.accelerations):
        raise CannotAnswer(Message("{what} know no reactions; take newton, or ask for an acceleration", what=what))
    if model.dependent:
        names = ", ".join(c.name for c in model.dependent)
        raise CannotAnswer(
            Message(
                "{names} are bound by closed loops, and {what} are written for independent coordinates here",
                names=names,
                what=what,
            )
        )
    rows = model.system.constraint_rows
    if any(isinstance(row.measure, NonholonomicForm) for row in rows):
        raise CannotAnswer(
            Message("a constraint on velocities is at work; {what} are written for holonomic systems here", what=what)
        )
    if what.startswith("the rate") and any(row.is_driven for row in rows):
        raise CannotAnswer(Message("a driver does work that is not known beforehand; take newton or lagrange"))


def _kinetic_line(context: Context, script: Script, T: Ratio) -> int:
    """T as a sum over the bodies, then collected."""
    what, symbol = Sentence("symbol.kinetic"), kinetic_symbol(context)
    script.introduce(Meaning(symbol, what, Energy("kinetic"), "J"))
    f = context.setup.model.field
    parts: list[Expr] = []
    for body in context.system.moving:
        own = f.element(Energy("kinetic", body.name).value(context.system, context.setup.state))
        if not own.is_zero():
            parts.append(tidy(f.lowest_terms(own)))
    parts = [multiply(number(n), part) if (n := parts.count(part)) > 1 else part for part in dict.fromkeys(parts)]
    shown = tidy(T)
    context.glossary.formulas[symbol.name] = shown
    sides = (symbol, add(*parts), shown) if len(parts) > 1 and add(*parts) != shown else (symbol, shown)
    return script.line(*sides, why="energy.kinetic")


def _equation(context: Context, script: Script, c: Coordinate, T: Ratio, t_line: int) -> EliminationRow:
    """d/dt dT/du - dT/dq = Q for one coordinate."""
    model, f = context.setup.model, context.setup.model.field
    u, q = rates_of(c.name, 1), Symbol(c.name)
    momentum = f.lowest_terms(f.partial(T, c.speed))
    energy = kinetic_symbol(context)
    of_speed, of_place = Derivative(energy, u, True), Derivative(energy, q, True)
    script.say("lagrange.coordinate", name=q)
    p_line = script.line(of_speed, tidy(momentum), why="", uses=(t_line,))
    rate = f.lowest_terms(model.rate(momentum))
    r_line = script.line(Derivative(of_speed, Symbol("t")), tidy(rate), uses=(p_line,))
    slope = f.lowest_terms(f.derivative(T, c.index)) if _moves_with(model, T, c) else f.zero
    s_line = script.line(of_place, tidy(slope), uses=(t_line,))
    force = model.dynamics.generalized_force(c)
    symbol = context.symbol(f"Q_{c.name}", f"Q_gen_{c.name}")
    what = Sentence("symbol.generalized_force", {"name": q})
    script.introduce(Meaning(symbol, what, _force_reader(context, c)))
    q_line = script.line(symbol, tidy(force), why="lagrange.force", args={"name": q})
    number = script.line(
        Difference(Derivative(of_speed, Symbol("t")), of_place),
        symbol,
        why="lagrange.equation",
        args={"lines": (r_line, s_line, q_line)},
        uses=(r_line, s_line, q_line),
    )
    return _row(model, f.lowest_terms(rate - slope), force, number)


def _force_reader(context: Context, c: Coordinate) -> Callable[[World], float]:
    """Q_k in numbers: laws of the loads times the change of their measures' rates with the speed."""
    model = context.setup.model

    def read(world: World) -> float:
        total = 0.0
        numbers = world.numbers
        k = model.coordinates.index(c)
        for push in model.system.applied_loads:
            law = world.snapshot.law(push)
            for body in [b.name for b in model.system.moving]:
                slopes = world.snapshot.gradient(push.measure, body)
                for slope, part in zip(slopes, model.kinematics.partial_velocities[body][k], strict=False):
                    total += law * slope * float(model.field.evaluate(part, numbers))
        return total

    return read


def _moves_with(model: SymbolicModel, x: Ratio, c: Coordinate) -> bool:
    return c.index in model.field.ingredients(x)


def _row(model: SymbolicModel, left: Ratio, right: Ratio, number: int) -> EliminationRow:
    """An equation collected by the accelerations."""
    f = model.field
    entries: dict[int, Ratio] = {}
    rest = right - left
    for a in model.accelerations:
        slope = f.partial(left, a)
        if not slope.is_zero():
            entries[a] = f.lowest_terms(slope)
            rest = rest + slope * f.variable(a)
    return EliminationRow(entries, f.lowest_terms(rest), number)


def _collected(script: Script, solver: Solver, rows: list[EliminationRow]) -> None:
    """Every equation with the accelerations on the left."""
    for row in rows:
        left, right = solver.sides(row)
        row.number = script.line(left, right, why="lagrange.collected", args={"line": row.number}, uses=(row.number,))


def _unknowns(model: SymbolicModel) -> Unknowns:
    return Unknowns({a: model.field.generators[a].display for a in model.accelerations})
