"""Rates of momentum in the plane: accelerations by the symbols a person would use, which the constraints then explain.

P' = sum of m a,        H' = I w' about a mass centre, (I + m r^2) w' about a fixed point of a body
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

from freebody.connections.shared_by_copies import copy_of_row
from freebody.language.expression import Expr, Symbol, add, n_operations
from freebody.language.sentences import Argument, Sentence
from freebody.measures.geometry import GROUND, RIGHT, UP
from freebody.narrative.lines.glossary import Glossary, Meaning, of_centre
from freebody.narrative.lines.script import Legend, Script
from freebody.narrative.principles.acting import Acting
from freebody.narrative.principles.kinematics import Kinematics, Term, total
from freebody.narrative.principles.loops import bound_speeds, closed_loops, however_long
from freebody.narrative.principles.places import place_in_plane
from freebody.narrative.principles.planner import Plan
from freebody.narrative.principles.rates import MomentumRate
from freebody.narrative.principles.sides import balanced, positive_first, scaled, without_common_factor
from freebody.narrative.principles.symmetry import Symmetry
from freebody.narrative.principles.table import WritablePrinciple
from freebody.questions.motion import OfPoint
from freebody.study.setup import Setup
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.tidy import tidy


class PlanarRates:
    """Writes what moves how in the plane, each symbol once in a derivation."""

    def __init__(self, acting: Acting, glossary: Glossary, symmetry: Symmetry) -> None:
        self.acting, self.glossary, self.symmetry = acting, glossary, symmetry
        self.model, self.system, self.field = acting.model, acting.system, acting.model.field
        self.kinematics = Kinematics(acting.model, glossary)
        self.told: dict[Expr, int] = {}  # symbols of motion that have been explained, and the line
        self.constraint_lines: dict[str, int] = {}
        self._constraint_terms: dict[str, tuple[Term, ...]] = {}  # that stand in these lines
        self._introduced: set[str] = set()
        self._for_copies: set[str] = set()  # bodies of which it is told that they stand for their copies
        self._loop_lines: tuple[int, ...] | None = None

    def begin(self) -> None:
        """A derivation begins: nothing has been explained in it yet."""
        self.told.clear()
        self.constraint_lines.clear()
        self._constraint_terms.clear()
        self._introduced.clear()
        self._for_copies.clear()
        self._loop_lines = None

    def prepare(self, script: Script, plan: Plan) -> None:
        """The symbols are explained where they stand."""

    def loops(self, setup: Setup, script: Script) -> tuple[int, ...]:
        """The loops differentiated, or else what rolls, and solved for the bound speeds, once in a derivation."""
        if self._loop_lines is None and self.model.dependent:
            called = "loops" if self.model.loops else "bound_rates"
            with script.stage(f"stage.{called}", f"hint.{called}"):
                rates = closed_loops(setup, script, in_rates=True, limit=however_long)
                self._loop_lines = tuple(bound_speeds(setup, script, rates, however_long))
        return self._loop_lines or ()

    # -- rates of momentum --------------------------------------------------------------------
    def rate(self, p: WritablePrinciple) -> MomentumRate:
        """By terms with mass or inertia in the coefficient."""
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
        whole = positive_first(shown) if shown else tidy(self.field.zero)
        return MomentumRate(whole, total(terms, self.field.zero), tuple(terms))

    def _turns_about(self, p: WritablePrinciple, body: str, w: tuple[Ratio, Ratio]) -> bool:
        """Whether the centre is a fixed point of the body, so that I + m r^2 is its inertia there."""
        assert p.centre is None or p.kind == "angular"
        if p.centre is None or not p.centre.is_fixed:
            return False
        vx, vy, omega = self.model.kinematics.velocities[body]
        omega = -omega if p.is_clockwise else omega
        # v_G = omega x r with r from the centre: (-r_y, r_x) are the weights
        return self.model.samples.vanishes(vx - omega * w[0]) and self.model.samples.vanishes(vy - omega * w[1])

    def announce(self, script: Script, terms: Sequence[Term]) -> None:
        """Introduces the symbols of some terms."""
        for term in terms:
            self._introduce(script, term)

    def replaced(self, rate: MomentumRate) -> tuple[int, ...] | None:
        """The lines that say what its symbols are; None where it stands in the coordinates already."""
        if all(term.is_plain for term in rate.terms) and len(rate.terms) == len({term.symbol for term in rate.terms}):
            return None
        return tuple(dict.fromkeys(self.told[t.symbol] for t in rate.terms if t.symbol in self.told))

    def say_of_centre(self, script: Script, p: WritablePrinciple) -> None:
        """The term v_O x P of a moving centre, or why it is not there."""
        if p.centre is None or p.centre.is_fixed or p.centre.mass_center_of:
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

    def explain(self, script: Script, rates: Sequence[MomentumRate]) -> None:
        with script.stage("stage.kinematics", "hint.kinematics"):
            for rate in rates:
                self._explain(script, rate.terms)

    def _explain(self, script: Script, terms: Sequence[Term]) -> None:
        """Says what the symbols of motion are in the coordinates, from the constraints or by differentiation."""
        for term in terms:
            if term.is_plain or term.symbol in self.told:
                continue
            self._introduce(script, term)
            if self._is_linear(term):
                uses = self.leading_to(script, term.body)
                key = "kinematics.differentiated" if uses else "kinematics.seen"
            else:
                uses = self._positions_of(script, term)
                key = "kinematics.twice" if uses else "kinematics.loops" if self.model.loops else "kinematics.seen"
            self.told[term.symbol] = script.line(
                term.symbol,
                self._by_acceleration(term.explicit),
                why=key,
                args={"lines": uses, "body": term.body},
                uses=uses,
            )

    def _by_acceleration(self, x: Ratio) -> Expr:
        """What is linear in accelerations, each with its coefficient, where that is no longer than the whole."""
        whole, f = tidy(x), self.field
        parts, rest = list[Expr](), x
        for a in self.model.accelerations:
            slope = f.lowest_terms(f.partial(x, a))
            if not slope.is_zero():
                rest = rest - slope * f.variable(a)
                parts.append(scaled(slope, tidy(f.variable(a))))
        rest = f.lowest_terms(rest)
        split = positive_first([*parts, *([] if rest.is_zero() else [tidy(rest)])]) if parts else whole
        return split if n_operations(split) < n_operations(whole) else whole

    def explain_velocities(self, script: Script, terms: Sequence[Term]) -> list[int]:
        """Says what symbols of velocities are in the coordinates."""
        found: list[int] = []
        for term in terms:
            if term.is_plain:
                continue
            if term.symbol not in self.told:
                self._introduce(script, term)
                constant = self._is_linear(term, order=1)
                if constant:
                    uses = self._enough(self.constraints_of(script, term.body), term)
                else:
                    uses = self._positions_of(script, term)
                key = "kinematics.follows" if constant and uses else "kinematics.once" if uses else "kinematics.seen"
                self.told[term.symbol] = script.line(
                    term.symbol, tidy(term.explicit), why=key, args={"lines": uses, "body": term.body}, uses=uses
                )
            found.append(self.told[term.symbol])
        return list(dict.fromkeys(found))

    def _introduce(self, script: Script, term: Term) -> None:
        name = str(term.symbol.name) if isinstance(term.symbol, Symbol) else ""
        if name and name not in self._introduced:
            self._introduced.add(name)
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
        for row, terms in self._rows_from(body):
            if row not in self.constraint_lines:
                self.constraint_lines[row] = self._constraint_line(script, row, terms)
                self._constraint_terms[row] = terms
            found.append(self.constraint_lines[row])
        return tuple(dict.fromkeys(found))

    def is_led(self, body: str) -> bool:
        """Whether constraints with constant coefficients lead from a body to the speed of a coordinate."""
        return any(t.is_plain for _row, terms in self._rows_from(body) for t in terms)

    def _rows_from(self, body: str) -> Iterator[tuple[str, tuple[Term, ...]]]:
        """The constraints with constant coefficients that lead from a body to others, in turn."""
        reached, waiting = {body}, [body]
        while waiting:
            for row in self.acting.acting_on(waiting.pop(0)):
                copy = copy_of_row(self.acting.rows[row].component)
                if copy and copy not in reached:  # of the others it is said once what one of them does
                    continue
                terms = () if row in self.symmetry.merged else self._terms_of(row)
                if len(terms) < 2 or not all(t.coefficient.is_constant() for t in terms):
                    continue
                yield row, terms
                new = dict.fromkeys(t.body for t in terms if t.body not in reached)
                reached |= new.keys()
                waiting += new

    def _terms_of(self, row: str) -> tuple[Term, ...]:
        slopes = self.model.gradient(self.acting.rows[row].measure)
        if row in self._constraint_terms:
            return self._constraint_terms[row]
        terms = tuple(self.kinematics.velocity_form(dict(slopes)))
        return terms if copy_of_row(self.acting.rows[row].component) else self._of_one_copy(terms)

    def _of_one_copy(self, terms: tuple[Term, ...]) -> tuple[Term, ...]:
        """With the symbols of one copy for those of all that move as it does, as in the sum that a mesh of planets
        holds."""
        first = {copy: body.name for body in self.system.moving for copy in body.copies}
        found = dict[Expr, Term]()
        for term in terms:
            own = term
            for other in terms:
                is_alike = other.body == first.get(term.body) and other.is_turning == term.is_turning
                if is_alike and self.model.samples.vanishes(other.explicit - term.explicit):
                    own = other
            before = found.get(own.symbol)
            added = term.coefficient if before is None else before.coefficient + term.coefficient
            found[own.symbol] = replace(own, coefficient=self.field.lowest_terms(added))
        return tuple(found.values())

    def leading_to(self, script: Script, body: str) -> tuple[int, ...]:
        """The constraints that lead from a body to the coordinates, and what they leave open: how its mass centre and
        those beside it move in the coordinates."""
        lines = self.constraints_of(script, body)
        terms = [t for row, line in self.constraint_lines.items() if line in lines for t in self._constraint_terms[row]]
        unknown = {t.symbol: t for t in terms if not t.is_plain}
        open_ = [t for t in unknown.values() if not t.is_turning and self._is_linear(t, order=1)]
        more = open_[: max(0, len(unknown) - len(lines))]
        for t in more:
            if t.symbol not in self.told:
                self.told[t.symbol] = script.line(t.symbol, tidy(t.explicit), why="kinematics.seen")
        return (*lines, *(self.told[t.symbol] for t in more))

    def _enough(self, lines: Sequence[int], wanted: Term) -> tuple[int, ...]:
        """Of lines of constraints those that lead from the speeds of the coordinates to a symbol, one unknown a line;
        all of them where the unknowns are not found one by one."""
        terms = {line: self._constraint_terms[row] for row, line in self.constraint_lines.items()}

        def leads_there(kept: Sequence[int]) -> bool:
            unknown = [{t.symbol for t in terms[line] if not t.is_plain} for line in kept]
            known = set[Expr]()
            while found := {s for symbols in unknown for s in symbols - known if len(symbols - known) == 1}:
                known |= found
            return wanted.symbol in known

        kept = list(lines)
        if leads_there(kept):
            for line in lines:
                if leads_there(fewer := [other for other in kept if other != line]):
                    kept = fewer
        return tuple(kept)

    def _constraint_line(self, script: Script, row: str, terms: Sequence[Term]) -> int:
        """The rate of what a row holds: positive terms left, negative right."""
        for term in terms:
            self._introduce(script, term)
        held = self.acting.rows[row]
        mine = {term.body for term in terms}
        for body in self.system.moving if not copy_of_row(held.component) else ():
            is_for_all = body.copies and body.name in mine and set(body.copies) <= set(held.measure.bodies())
            if is_for_all and body.name not in self._for_copies:
                self._for_copies.add(body.name)
                script.say("symmetry.copies", first=body.name, names=body.copies)
        rest = self.model.in_independent_speeds(total(terms, self.field.zero))  # what drives it
        own = [term.coefficient for term in terms] + ([] if self.model.samples.vanishes(rest) else [-rest])
        own = without_common_factor(own)
        shown = [scaled(x, term.symbol) for x, term in zip(own, terms, strict=False)]
        shown += [tidy(x) for x in own[len(terms) :]]
        alike = {row.connection for row in self.acting.rows.values() if row.reaction == held.reaction}
        # the only one of its kind needs no name
        args: dict[str, Argument] = {"connection": held.connection, "component": held.component, "n": len(alike)}
        is_rod = held.reaction == "tension" and not (held.unilateral or held.stretches)  # which may push
        key = "constraint.length" if is_rod else f"constraint.{held.reaction.replace(' ', '_')}"
        if copy := copy_of_row(held.component):
            return script.line(*balanced(add(*shown)), why="constraint.copy", args={"copy": copy})
        bodies = tuple(dict.fromkeys(body for body in held.measure.bodies() if body != GROUND))
        if len(bodies) == 2:
            args["bodies"] = bodies
        elif key == "constraint.tooth_force":
            key = "constraint.tooth_force_at"
        return script.line(*balanced(add(*shown)), why=key, args=args)

    def _positions_of(self, script: Script, term: Term) -> tuple[int, ...]:
        """Where the mass centre is, in the coordinates."""
        if term.is_turning:
            return ()
        name = str(term.symbol.name) if isinstance(term.symbol, Symbol) else ""
        axes = name[-1] if name.endswith(("_x", "_y")) else "xy"
        return tuple(line for axis in axes for line in self._place_line(script, term.body, axis))

    def _place_line(self, script: Script, body: str, axis: str) -> tuple[int, ...]:
        """One coordinate of a mass centre, as a line."""
        place = place_in_plane(self.model, body)["xy".index(axis)]
        symbol = Symbol(f"{axis}_{body}")
        if tidy(place) in [Symbol(name) for name in self.system.measures]:  # it is a coordinate by itself
            return ()
        if symbol.name in self.system.measures or symbol in self.told:
            return (self.told[symbol],) if symbol in self.told else ()
        center = self.system.bodies[body].mass_center
        what = Sentence("symbol.place", {"of": of_centre(self.system.bodies[body]), "axis": f"@letter.{axis}"})
        script.introduce(Meaning(symbol, what, OfPoint(center, 0, RIGHT if axis == "x" else UP), "m"))
        self._introduced.add(symbol.name)
        self.told[symbol] = script.line(symbol, tidy(place), why="kinematics.place", args={"body": body})
        return (self.told[symbol],)


def _times(term: Term, factor: Ratio) -> Term:
    coefficient = term.coefficient.field.lowest_terms(term.coefficient * factor)
    return Term(coefficient, term.symbol, term.generator, term.explicit, term.body, term.is_turning)
