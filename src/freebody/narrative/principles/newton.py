"""A question about an instant answered by Newton and Euler: the planned principles, written, joined and solved."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property

import numpy as np

from freebody.errors import RoutesDisagree
from freebody.language.expression import Expr, Sum, Symbol, add, negate
from freebody.language.notation.parts import signed_terms
from freebody.language.sentences import Message
from freebody.model.elements import ConstraintRow
from freebody.narrative.lines.glossary import Glossary, Meaning, World
from freebody.narrative.lines.script import Argument, Diagram, Legend, Script, Sentence
from freebody.narrative.principles.elimination import EliminationRow, Solver, Unknowns, positive_first
from freebody.narrative.principles.formal import FormalState, elements
from freebody.narrative.principles.kinematics import Kinematics, Term, scaled, total
from freebody.narrative.principles.places import words_of
from freebody.narrative.principles.planner import Plan, Planner
from freebody.narrative.principles.symmetry import Copies, copies
from freebody.narrative.principles.table import PrincipleTable, Slot, WritablePrinciple
from freebody.questions.base import Quantity
from freebody.study.setup import Setup
from freebody.symbolic.field import Ratio
from freebody.symbolic.tidy import tidy


@dataclass
class WrittenPrinciple:
    """A principle as it was written: its line, and both sides as elements with symbols for what moves."""

    principle: WritablePrinciple
    number: int
    terms: list[Term] = field(default_factory=list[Term])
    rest: Ratio | None = None  # loads
    reactions: dict[str, Ratio] = field(default_factory=dict[str, Ratio])  # coefficients on the right, by row


class Newton:
    """Derives unknowns of a system in the plane by momentum and angular momentum."""

    principle_words = "principle"  # group of the catalogue

    def __init__(self, setup: Setup, glossary: Glossary) -> None:
        self.setup = setup
        self.model = setup.model
        self.field = setup.model.field
        self.glossary = glossary
        self.table = PrincipleTable(setup.model)
        self.kinematics = Kinematics(self.table, glossary)
        self.told: dict[Expr, int] = {}  # symbols of motion that have been explained, and the line
        self.constraint_lines: dict[str, int] = {}
        self.introduced: set[str] = set()
        self.loop_lines: tuple[int, ...] | None = None
        self.is_drawn = True  # diagrams show the start: not what touches only later

    def begin(self) -> None:
        """A derivation begins: nothing has been explained in it yet."""
        self.told.clear()
        self.constraint_lines.clear()
        self.introduced.clear()
        self.loop_lines = None

    @cached_property
    def copies(self) -> list[Copies]:
        """Bodies that are treated once."""
        return copies(self.table, list(self.glossary.worlds("always")))

    @cached_property
    def merged(self) -> dict[str, str]:
        """Rows whose reaction is that of another one by symmetry."""
        return {row: same for group in self.copies for row, same in group.rows.items()}

    @cached_property
    def planner(self) -> Planner:
        world = list(self.glossary.worlds("always"))[-1]
        numbers = self.model.samples.numbers(world.draw.sample(world.snapshot), world.draw.sample())
        return Planner(self.table, numbers, self.merged)

    # -- what is asked ------------------------------------------------------------------------
    def asked(self, quantity: Quantity) -> tuple[Ratio, ...]:
        """The quantity in coordinates, speeds, accelerations and reactions."""
        value = quantity.value(self.setup.system, FormalState(self.table))
        f, reactions = self.field, self.table.reactions
        same = {f.index(reactions[row]): reactions[other] for row, other in self.merged.items()}
        return tuple(f.lowest_terms(f.follow(part, same)) for part in elements(f, value))

    def unknowns_in(self, parts: Iterable[Ratio]) -> list[int]:
        """Generators of accelerations and reactions in some elements."""
        reactions = {self.field.index(r) for r in self.table.reactions.values()}
        used = {g for p in parts for g in self.field.ingredients(p)}
        return sorted(g for g in used if g in reactions or g in set(self.model.accelerations))

    def plan(self, unknowns: Sequence[int]) -> Plan:
        """Principles that determine some unknowns."""
        planner = self.planner
        targets = np.zeros((len(unknowns), planner.n))
        for k, unknown in enumerate(unknowns):
            targets[k, self._column(unknown)] = 1.0
        others = {name for group in self.copies for name in group.bodies[1:]}
        among = [body.name for body in self.model.system.moving if body.name not in others]
        return planner.plan(targets, among)

    def _column(self, unknown: int) -> int:
        if unknown in self.model.accelerations:
            return self.model.accelerations.index(unknown)
        row = next(row for row, r in self.table.reactions.items() if self.field.index(r) == unknown)
        return self.planner.column(row)

    # -- writing ------------------------------------------------------------------------------
    def write(self, script: Script, plan: Plan, asked: Sequence[int]) -> dict[int, tuple[Ratio, int]]:
        """Free-body diagrams, principles, and their solution; the values of the unknowns and their lines."""
        with script.stage("stage.bodies", "hint.bodies", bodies=self._bodies(plan)):
            self._cut_free(script, plan)
        with script.stage("stage.principles", "hint.principles", n=len(plan.principles)):
            written = [self._principle(script, plan, k) for k in range(len(plan.principles))]
        with script.stage("stage.kinematics", "hint.kinematics"):
            for w in written:
                self.explain(script, w.terms)
        with script.stage("stage.solution", "hint.solution", n=len(written)):
            rows = [self._in_coordinates(script, w) for w in written]
            return self._solve(script, rows, asked)

    def _bodies(self, plan: Plan) -> tuple[str, ...]:
        return tuple(dict.fromkeys(body for p in plan.principles for body in p.bodies))

    def _cut_free(self, script: Script, plan: Plan) -> None:
        """A diagram of every set of bodies used, and the meaning of the reactions in the equations."""
        for group in self.copies:
            if group.bodies[0] in self._bodies(plan):
                script.say("symmetry.said", bodies=group.bodies, first=group.bodies[0])
        for bodies in dict.fromkeys(p.bodies for p in plan.principles) if self.is_drawn else ():
            key = "figure.free_body" if len(bodies) == 1 else "figure.free_bodies"
            script.add(Diagram(bodies, Sentence(key, {"bodies": bodies})))
        acting = [row for body in self._bodies(plan) for row in self.table.acting_on(body)]
        self.name_reactions(script, [self.merged.get(row, row) for row in acting])

    def name_reactions(self, script: Script, rows: Iterable[str]) -> None:
        """Introduces the symbols of reactions that have not been introduced."""
        entries: list[tuple[Expr, Sentence, str]] = []
        for name in dict.fromkeys(rows):
            row, symbol = self.table.rows[name], self.table.symbols[name]
            if symbol.name in self.introduced:
                continue
            self.introduced.add(symbol.name)
            at = tuple(row.ends) if len([r for r in self.table.rows.values() if _is_like(r, row)]) > 1 else ()
            what = self._reaction_words(name, at)
            self.glossary.introduce(Meaning(Symbol(symbol.name), what, _reaction_of(name), ""))
            entries.append((Symbol(symbol.name), what, ""))
        if entries:
            script.add(Legend(tuple(entries)))

    def _reaction_words(self, name: str, ends: tuple[str, ...]) -> Sentence:
        row = self.table.rows[name]
        own = words_of(row) if ends else None
        if own is not None:
            return own
        args: dict[str, Argument] = {"reaction": f"@reaction.{row.reaction}", "connection": row.connection}
        if len(row.component) <= 1 or row.component.split()[-1] in ("x", "y", "z"):
            return Sentence("symbol.reaction_component", {**args, "axis": row.component.split()[-1]})
        if ends:
            return Sentence("symbol.reaction_between", {**args, "ends": ends})
        return Sentence("symbol.reaction", args)

    # -- principles ---------------------------------------------------------------------------
    def _principle(self, script: Script, plan: Plan, k: int) -> WrittenPrinciple:
        p = self._oriented(plan.principles[k])
        script.say(f"{self.principle_words}.{p.kind}", bodies=p.bodies, **self._where(p))
        self._say_why(script, p, plan.avoided[k])
        if p.kind == "angular":
            self._say_of_moving_point(script, p)
        left, terms = self._momentum(p)
        right, rest, reactions = self._forces(p)
        self.introduce_terms(script, terms)
        label = Sentence(f"label.{p.kind}{'_clockwise' if p.is_clockwise else ''}", self._where(p))
        number = script.line(left, right, why="", label=label)
        return WrittenPrinciple(p, number, terms, rest, reactions)

    def _oriented(self, p: WritablePrinciple) -> WritablePrinciple:
        """Moments are counted in the sense that leaves fewer minus signs."""
        if p.kind != "angular":
            return p
        other = replace(p, weights={slot: -w for slot, w in p.weights.items()}, is_clockwise=True)
        return min((p, other), key=self._n_minus)

    def _n_minus(self, p: WritablePrinciple) -> int:
        """Minus signs in a principle as it is written."""
        found = 0
        for side in (self._momentum(p)[0], self._forces(p)[0]):
            terms = side.terms if isinstance(side, Sum) else (side,)
            found += sum(minus for minus, _e in signed_terms(terms))
        return found

    def _where(self, p: WritablePrinciple) -> dict[str, Argument]:
        if p.aim is not None:
            return {"direction": p.aim.words}
        assert p.centre is not None
        return {"point": p.centre.words}

    def _say_why(self, script: Script, p: WritablePrinciple, avoided: Sequence[str]) -> None:
        """Which reactions the principle keeps out, and how."""
        forces = [row for row in avoided if p.kind == "angular" or self._is_force(row)]  # couples stay out of momentum
        names = tuple(dict.fromkeys(self.table.symbols[self.merged.get(row, row)].name for row in forces))
        symbols: tuple[Argument, ...] = tuple(Symbol(n) for n in names)
        if names:
            key = "why.across" if p.kind == "linear" else "why.through"
            script.say(key if len(names) > 1 else f"{key}_one", forces=symbols, **self._where(p))
        if len(p.bodies) > 1:
            script.say("why.internal", bodies=p.bodies)

    def _is_force(self, row: str) -> bool:
        """Whether a reaction is more than a couple."""
        return any(slot != "angle" for _body, slot in self.table.directions[row])

    def _say_of_moving_point(self, script: Script, p: WritablePrinciple) -> None:
        """The term v_O x P of a moving centre, or why it is not there."""
        assert p.centre is not None
        if p.centre.is_fixed or p.centre.mass_center_of:
            return
        f = self.field
        velocity = tuple(f.lowest_terms(self.model.in_independent_speeds(self.model.rate(x))) for x in p.centre.place)
        term = f.zero
        for body in p.bodies:
            m = self.model.dynamics.inertias[body][0]
            vx, vy, _w = (self.model.in_independent_speeds(v) for v in self.model.kinematics.velocities[body])
            term = term + m * (velocity[0] * vy - velocity[1] * vx)
        if self.model.samples.vanishes(term):
            script.say("moving_point.parallel", point=p.centre.words)
        else:
            script.say("moving_point.instant", point=p.centre.words, term=tidy(f.lowest_terms(term)))

    def _momentum(self, p: WritablePrinciple) -> tuple[Expr, list[Term]]:
        """The rate of momentum as it is written, and its terms with mass or inertia in the coefficient."""
        terms: list[Term] = []
        shown: list[Expr] = []
        for body in p.bodies:
            mass, _mass, inertia = self.model.dynamics.inertias[body]
            wx, wy = (p.weights.get((body, slot), self.field.zero) for slot in ("x", "y"))
            turning = self.kinematics.turning(body, 2) if (body, "angle") in p.weights else None
            if turning is not None and p.is_clockwise:
                turning = _times(turning, -self.field.one)
            if turning is not None and self._turns_about(p, body, (wx, wy)):
                r2 = self.field.lowest_terms(wx * wx + wy * wy)
                about = self.field.lowest_terms(inertia + mass * r2)
                if not about.is_zero():
                    terms.append(_times(turning, about))
                    shown.append(terms[-1].expression)
                continue
            if turning is not None and not inertia.is_zero():
                terms.append(_times(turning, inertia))
                shown.append(terms[-1].expression)
            if not mass.is_zero() and not (wx.is_zero() and wy.is_zero()):
                for term in self.kinematics.along(body, (wx, wy), 2):
                    terms.append(_times(term, mass))
                    shown.append(scaled(term.coefficient * mass, term.symbol))
        return (positive_first(shown) if shown else tidy(self.field.zero)), terms

    def _turns_about(self, p: WritablePrinciple, body: str, w: tuple[Ratio, Ratio]) -> bool:
        """Whether the centre is a fixed point of the body, so that I + m r^2 is its inertia there."""
        assert p.centre is None or p.kind == "angular"
        if p.centre is None or not p.centre.is_fixed:
            return False
        vx, vy, omega = self.model.kinematics.velocities[body]
        omega = -omega if p.is_clockwise else omega
        # v_G = omega x r with r from the centre: (-r_y, r_x) are the weights
        return self.model.samples.vanishes(vx - omega * w[0]) and self.model.samples.vanishes(vy - omega * w[1])

    def _forces(self, p: WritablePrinciple) -> tuple[Expr, Ratio, dict[str, Ratio]]:
        """Loads and reactions on the right: as written, the loads as an element, coefficients of reactions."""
        f = self.field
        shown: list[Expr] = []
        rest = f.zero
        for _push, law, slopes in self.table.loads:
            arm = self._weighted(p.weights, slopes)
            if not self.model.samples.vanishes(arm * law):
                rest = rest + arm * law
                shown.append(tidy(f.lowest_terms(arm * law)))
        coefficients: dict[str, Ratio] = {}
        for row, slopes in self.table.directions.items():
            arm = self._weighted(p.weights, slopes)
            if not self.model.samples.vanishes(arm):
                same = self.merged.get(row, row)
                coefficients[same] = f.lowest_terms(coefficients.get(same, f.zero) + arm)
        for row, arm in coefficients.items():
            if not self.model.samples.vanishes(arm):
                shown.append(scaled(arm, Symbol(self.table.symbols[row].name)))
        return (positive_first(shown) if shown else tidy(f.zero)), rest, coefficients

    def _weighted(self, weights: Mapping[Slot, Ratio], slopes: Mapping[Slot, Ratio]) -> Ratio:
        result = self.field.zero
        for slot, slope in slopes.items():
            if slot in weights:
                result = result + weights[slot] * slope
        return result

    # -- kinematics ---------------------------------------------------------------------------
    def explain(self, script: Script, terms: Sequence[Term]) -> None:
        """Says what the symbols of motion are in the coordinates, from the constraints or by differentiation."""
        for term in terms:
            if term.is_plain or term.symbol in self.told:
                continue
            self._introduce(script, term)
            if self._is_linear(term):
                uses = self.constraints_of(script, term.body)
                key = "kinematics.differentiated" if uses else "kinematics.seen"
            else:
                uses = self._positions_of(script, term)
                key = "kinematics.twice" if uses else "kinematics.loops"
            self.told[term.symbol] = script.line(
                term.symbol, tidy(term.explicit), why=key, args={"lines": uses, "body": term.body}, uses=uses
            )

    def explain_velocities(self, script: Script, terms: Sequence[Term]) -> list[int]:
        """Says what symbols of velocities are in the coordinates."""
        found: list[int] = []
        for term in terms:
            if term.is_plain:
                continue
            if term.symbol not in self.told:
                self._introduce(script, term)
                constant = self._is_linear(term, order=1)
                uses = self.constraints_of(script, term.body) if constant else self._positions_of(script, term)
                key = "kinematics.follows" if constant and uses else "kinematics.once" if uses else "kinematics.seen"
                self.told[term.symbol] = script.line(
                    term.symbol, tidy(term.explicit), why=key, args={"lines": uses, "body": term.body}, uses=uses
                )
            found.append(self.told[term.symbol])
        return list(dict.fromkeys(found))

    def introduce_terms(self, script: Script, terms: Sequence[Term]) -> None:
        """Introduces the symbols of some terms."""
        for term in terms:
            self._introduce(script, term)

    def _introduce(self, script: Script, term: Term) -> None:
        name = str(term.symbol.name) if isinstance(term.symbol, Symbol) else ""
        if name and name not in self.introduced:
            self.introduced.add(name)
            meaning = self.glossary.meanings[name]
            script.add(Legend(((meaning.symbol, meaning.what, meaning.unit),)))

    def _is_linear(self, term: Term, order: int = 2) -> bool:
        """Whether the symbol is a constant combination of the accelerations (or speeds) of the coordinates."""
        known = set(self.model.accelerations) if order == 2 else {c.speed for c in self.model.coordinates}
        slopes = [self.field.partial(term.explicit, a) for a in known]
        rest = term.explicit
        for a, slope in zip(known, slopes, strict=True):
            rest = rest - slope * self.field.variable(a)
        return all(s.is_constant() for s in slopes) and rest.is_constant()

    def constraints_of(self, script: Script, body: str) -> tuple[int, ...]:
        """The velocity forms of the constraints that lead from a body to the coordinates, each written once."""
        found: list[int] = []
        reached, waiting = {body}, [body]
        while waiting:
            here = waiting.pop(0)
            for row in self.table.acting_on(here):
                if row in self.merged:
                    continue
                if row in self.constraint_lines:
                    found.append(self.constraint_lines[row])
                    continue
                slopes = self.model.gradient(self.table.rows[row].measure)
                terms = self.kinematics.velocity_form(dict(slopes))
                if len(terms) < 2 or not all(t.coefficient.is_constant() for t in terms):
                    continue
                self.constraint_lines[row] = self._constraint_line(script, row, terms)
                found.append(self.constraint_lines[row])
                for t in terms:
                    if t.body not in reached:
                        reached.add(t.body)
                        waiting.append(t.body)
        return tuple(dict.fromkeys(found))

    def _constraint_line(self, script: Script, row: str, terms: Sequence[Term]) -> int:
        """The rate of what a row holds: positive terms left, negative right."""
        for term in terms:
            self._introduce(script, term)
        held = self.table.rows[row]
        rest = total(terms, self.field.zero)  # what drives it
        shown = [term.expression for term in terms] + (
            [] if self.model.samples.vanishes(rest) else [negate(tidy(rest))]
        )
        signs = signed_terms(tuple(shown))
        left = [e for e, (minus, _x) in zip(shown, signs, strict=True) if not minus]
        right = [negate(e) for e, (minus, _x) in zip(shown, signs, strict=True) if minus]
        if not left:
            left, right = right, left
        args: dict[str, Argument] = {"connection": held.connection, "component": held.component}
        key = f"constraint.{held.reaction.replace(' ', '_')}"
        zero = tidy(self.field.zero)
        return script.line(add(*left) if left else zero, add(*right) if right else zero, why=key, args=args)

    def _positions_of(self, script: Script, term: Term) -> tuple[int, ...]:
        """Where the mass centre is, in the coordinates."""
        if term.is_turning:
            return ()
        name = str(term.symbol.name) if isinstance(term.symbol, Symbol) else ""
        axes = name[-1] if name.endswith(("_x", "_y")) else "xy"
        return tuple(line for axis in axes for line in self._place_line(script, term.body, axis))

    def _place_line(self, script: Script, body: str, axis: str) -> tuple[int, ...]:
        """One coordinate of a mass centre, as a line."""
        from freebody.measures.geometry import RIGHT, UP
        from freebody.questions.motion import OfPoint

        place = self.table.position(body)["xy".index(axis)]
        symbol = Symbol(f"{axis}_{body}")
        if symbol.name in self.setup.system.measures or symbol in self.told:
            return (self.told[symbol],) if symbol in self.told else ()
        center = self.setup.system.bodies[body].mass_center
        what = Sentence("symbol.place", {"body": body, "axis": f"@axis.{axis}"})
        self.glossary.introduce(Meaning(symbol, what, OfPoint(center, 0, RIGHT if axis == "x" else UP), "m"))
        script.add(Legend(((symbol, what, "m"),)))
        self.introduced.add(symbol.name)
        self.told[symbol] = script.line(symbol, tidy(place), why="kinematics.place", args={"body": body})
        return (self.told[symbol],)

    # -- solving ------------------------------------------------------------------------------
    def _in_coordinates(self, script: Script, w: WrittenPrinciple) -> EliminationRow:
        """A principle with the symbols of motion replaced by the coordinates, collected."""
        f = self.field
        motion = total(w.terms, f.zero)
        entries: dict[int, Ratio] = {}
        rest = (w.rest or f.zero) - motion
        for a in self.model.accelerations:
            slope = f.partial(motion, a)
            if not self.model.samples.vanishes(slope):
                entries[a] = f.lowest_terms(slope)
            rest = rest + slope * f.variable(a)
        for row, arm in w.reactions.items():
            if not self.model.samples.vanishes(arm):
                entries[f.index(self.table.reactions[row])] = f.lowest_terms(-arm)
        row = EliminationRow(entries, f.lowest_terms(rest), w.number)
        plain = all(term.is_plain for term in w.terms)
        if plain and len(w.terms) == len({term.symbol for term in w.terms}):
            return row
        solver = Solver(self.model, script, self._unknowns())
        row = solver.cleared(row)
        left, right = solver.sides(row)
        uses = (w.number, *(self.told[t.symbol] for t in w.terms if t.symbol in self.told))
        row.number = script.line(
            left,
            right,
            why="solve.kinematics",
            args={"line": w.number, "lines": tuple(dict.fromkeys(uses[1:]))},
            uses=uses,
        )
        return row

    def _unknowns(self) -> Unknowns:
        f = self.field
        names = {a: f.generators[a].display for a in self.model.accelerations}
        reactions = {f.index(r): Symbol(self.table.symbols[row].name) for row, r in self.table.reactions.items()}
        return Unknowns({**names, **reactions}, set(reactions))

    def _solve(self, script: Script, rows: list[EliminationRow], asked: Sequence[int]) -> dict[int, tuple[Ratio, int]]:
        return Solver(self.model, script, self._unknowns()).solve(rows, list(asked))


def _reaction_of(row: str) -> Callable[[World], float]:
    """Reads the reaction of a row: sign times its multiplier."""

    def read(world: World) -> float:
        held = next(r for r in world.snapshot.reference.system.held if r.name == row)
        return held.sign * world.snapshot.multiplier(held)

    return read


def _times(term: Term, factor: Ratio) -> Term:
    coefficient = term.coefficient.field.lowest_terms(term.coefficient * factor)
    return Term(coefficient, term.symbol, term.generator, term.explicit, term.body, term.is_turning)


def _is_like(a: ConstraintRow, b: ConstraintRow) -> bool:
    return (a.connection, a.reaction) == (b.connection, b.reaction)


def same_answer(found: Sequence[Ratio], wanted: Sequence[Ratio]) -> None:
    """Raises RoutesDisagree unless a derivation ends in the solver's answer."""
    for a, b in zip(found, wanted, strict=True):
        if not (a - b).is_zero():
            raise RoutesDisagree(
                Message("the derivation ends in another formula than the solver. This is a defect of freebody")
            )
