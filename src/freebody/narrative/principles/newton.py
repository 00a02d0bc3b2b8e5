"""Newton and Euler: the planned principles written, joined with what is known of the forces, and solved.

There is one way for the plane and for space, for one phase of a motion and for rest: what acts, the table of principles
and the rates of momentum are handed in.
"""

from __future__ import annotations

from collections.abc import Container, Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Any

import numpy as np

from freebody.errors import RoutesDisagree
from freebody.language.expression import Call, Expr, add, multiply, negate, power
from freebody.language.expression import number as number_of
from freebody.language.sentences import Argument, Message, Sentence
from freebody.narrative.lines.glossary import Glossary
from freebody.narrative.lines.script import Diagram, Script
from freebody.narrative.principles.acting import Acting, FrictionLaw
from freebody.narrative.principles.elimination import EliminationRow, Solver, Unknowns
from freebody.narrative.principles.formal import ValueOf, formal_parts, unknowns_in
from freebody.narrative.principles.planner import IN_SPACE, IN_THE_PLANE, Plan, Planner, Preferences
from freebody.narrative.principles.rates import MomentumRate, MomentumRates
from freebody.narrative.principles.reactions import name_reactions
from freebody.narrative.principles.sides import ZERO, n_minus, positive_first, scaled, taking_out_roots
from freebody.narrative.principles.symmetry import Symmetry
from freebody.narrative.principles.table import PrincipleTable, WritablePrinciple
from freebody.questions.base import Quantity
from freebody.study.pictures.idle import idle_rows
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.tidy import tidy

Solved = dict[int, tuple[Ratio, int]]  # values of unknowns, and the lines in which they stand
_FEW = 4  # reactions that are named one by one where a principle keeps them out


@dataclass(frozen=True)
class Words:
    """Keys of the catalogue: the group that names a principle, its stage, and that of what is known of the forces;
    whether equations are labelled by their direction or point."""

    group: str
    stage: str = "principles"
    known: str = "friction"
    intro: str = ""
    has_labels: bool = True


IN_PLANE_WORDS = Words("principle")
IN_SPACE_WORDS = Words("space", has_labels=False)
AT_REST_WORDS = Words("balance", "equilibrium", "verge", intro="rest.no_acceleration")
_NAMED = 2  # bodies together whose names are said
ALONG_WORDS = replace(AT_REST_WORDS, intro="rest.along")


@dataclass
class WrittenPrinciple:
    """A principle as it was written: its line, and both sides as elements with symbols for what moves."""

    number: int
    left: MomentumRate
    rest: Ratio  # loads
    reactions: dict[str, Ratio] = field(default_factory=dict[str, Ratio])  # coefficients on the right, by row


class Newton:
    """Derives accelerations and reactions by momentum and angular momentum."""

    def __init__(
        self,
        acting: Acting,
        glossary: Glossary,
        rates: MomentumRates,
        symmetry: Symmetry,
        *,
        preferences: Preferences | None = None,
        words: Words | None = None,
        value_of: ValueOf | None = None,
        numbers: Mapping[int, Any] | None = None,
    ) -> None:
        """value_of: a quantity in a formal state, where it is not that of the system itself; numbers: values at which
        principles are chosen, where the glossary's motions are not general enough."""
        self.acting, self.glossary, self.rates, self.symmetry = acting, glossary, rates, symmetry
        self.model, self.field = acting.model, acting.model.field
        self.table = PrincipleTable(acting)
        in_space = acting.system.space
        self.preferences = preferences or (IN_SPACE if in_space else IN_THE_PLANE)
        self.words = words or (IN_SPACE_WORDS if in_space else IN_PLANE_WORDS)
        self._value_of, self._numbers = value_of, numbers
        self._named: set[str] = set()
        self._pressed: Solved = {}  # what presses with a resultant where something rubs
        self._withheld = False  # that is being found, and what rubs there is not known yet
        self.solved: Solved = {}  # all unknowns of the last solution
        self.is_drawn = True  # diagrams show the start: not what touches only later

    def begin(self) -> None:
        """A derivation begins: nothing has been explained in it yet."""
        self.rates.begin()
        self._named.clear()

    # -- what is asked ------------------------------------------------------------------------
    def asked(self, quantity: Quantity) -> tuple[Ratio, ...]:
        """The quantity in coordinates, speeds, accelerations and reactions."""
        f, acting = self.field, self.acting
        parts = formal_parts(acting, quantity, self._value_of)
        same = {acting.generator(row): acting.reactions[other] for row, other in self.symmetry.merged.items()}
        return tuple(f.lowest_terms(f.follow(part, same)) for part in parts) if same else parts

    def unknowns_in(self, parts: Iterable[Ratio]) -> list[int]:
        """Generators of accelerations and reactions in some elements."""
        return unknowns_in(self.acting, parts)

    # -- what is chosen -----------------------------------------------------------------------
    @cached_property
    def planner(self) -> Planner:
        return self._planner()

    @cached_property
    def _before_friction(self) -> Planner:
        """A friction that a resultant presses is not known before that."""
        return self._planner(knows_resultants=False)

    def _planner(self, *, counts_loads: bool = False, knows_resultants: bool = True) -> Planner:
        numbers = self._numbers or list(self.glossary.worlds("always"))[-1].numbers
        same = self.symmetry.merged
        how = {"counts_loads": counts_loads, "knows_resultants": knows_resultants}
        return Planner(self.table, numbers, self.preferences, same, **how)

    def plan(self, unknowns: Sequence[int], known: Container[int] = (), planner: Planner | None = None) -> Plan:
        """Principles that determine some unknowns; a friction that slides is known with its normal force. known:
        unknowns that have been found before."""
        planner = planner or self.planner
        found = [k for k, a in enumerate(self.model.accelerations) if a in known]
        found += [planner.column(row) for row in self.acting.rows if self.acting.generator(row) in known]
        targets = [self._target(unknown) for unknown in unknowns]
        for target in targets:
            target[found] = 0.0
        targets = [target for target in targets if target.any()]
        sets = [[target] for target in targets] if self.preferences.one_by_one else [targets] if targets else []
        return Plan.united([planner.plan(np.array(own), self.symmetry.speaking, found) for own in sets])

    def condition(self) -> Plan:
        """Principles from which every force that is not known drops out: what is left binds the parameters."""
        planner = self._planner(counts_loads=True)
        target = np.zeros((1, planner.n))
        target[0, planner.loads] = 1.0
        return planner.plan(target)

    def _target(self, unknown: int) -> np.ndarray[Any, np.dtype[np.float64]]:
        if unknown not in self.model.accelerations:
            return self.planner.target(next(r for r in self.acting.rows if self.acting.generator(r) == unknown))
        target = np.zeros(self.planner.n)
        target[self.model.accelerations.index(unknown)] = 1.0
        return target

    # -- writing ------------------------------------------------------------------------------
    def write(
        self,
        script: Script,
        plan: Plan,
        asked: Sequence[int],
        known_values: Mapping[int, tuple[Ratio, int]] | None = None,
    ) -> Solved:
        """Free-body diagrams, principles, what is known of the forces, and the solution; the values of the unknowns and
        their lines. known_values: of unknowns that have been found before."""
        before = dict(known_values or {})
        if pressing := self._pressing(script, plan, asked, before):
            before |= pressing
            plan = self.plan(asked, before)
        written, known = self.equations(script, plan, asked)
        with script.stage("stage.solution", "hint.solution", n=len(written) + len(known)):
            rows = [self.in_coordinates(script, w) for w in written]
            solver = self.solver(script)
            found = solver.solve([*rows, *known], list(asked), before)
            self.solved = solver.values
            return found

    def _pressing(self, script: Script, plan: Plan, asked: Sequence[int], before: Solved) -> Solved:
        """What presses with its resultant where something rubs that acts in a plan, found first. Raises CannotAnswer
        where that friction changes it."""
        found: Solved = {}
        if self._withheld:
            return found
        for name, law in self.acting.known.laws.items():
            if not law.resultant or not self._acts(name, plan, asked):
                continue
            unknowns = [g for g in map(self.acting.generator, law.resultant) if g not in before | found]
            first = self.plan(unknowns, before | found, self._before_friction) if unknowns else None
            if first is not None:
                self._withheld = True
                found |= self.write(script, first, unknowns, before | found)
                self._withheld = False
            self._pressed |= {g: (before | found)[g] for g in map(self.acting.generator, law.resultant)}
        return found

    def _acts(self, name: str, plan: Plan, asked: Sequence[int]) -> bool:
        """Whether a friction that slides stands in the equations of a plan, or is asked for."""
        slopes = self.acting.directions[name]
        arms = [self.acting.arm(p.weights, slopes) for p in plan.principles]
        return self.acting.generator(name) in asked or not all(map(self.model.samples.vanishes, arms))

    def equations(
        self, script: Script, plan: Plan, asked: Sequence[int]
    ) -> tuple[list[WrittenPrinciple], list[EliminationRow]]:
        """All but the solution."""
        words = self.words
        with script.stage("stage.bodies", "hint.bodies", bodies=plan.bodies):
            self._cut_free(script, plan)
        self.rates.prepare(script, plan)
        with script.stage(f"stage.{words.stage}", f"hint.{words.stage}", n=len(plan.principles)):
            if words.intro and not script.has_said(words.intro):
                script.say(words.intro)
            written = [
                self._principle(script, p, avoided) for p, avoided in zip(plan.principles, plan.avoided, strict=True)
            ]
        with script.stage(f"stage.{words.known}", f"hint.{words.known}"):
            known = self._known(script, {row for w in written for row in w.reactions}, asked)
        self.rates.explain(script, [w.left for w in written])
        return written, known

    def _cut_free(self, script: Script, plan: Plan) -> None:
        """A diagram of every set of bodies used, and the meaning of the reactions in the equations."""
        for group in self.symmetry.copies:
            if group.bodies[0] in plan.bodies:
                script.say("symmetry.said", bodies=group.bodies, first=group.bodies[0])
        told = tuple(sorted(row for row in self.idle if self._is_told(row, plan)))
        for bodies in dict.fromkeys(p.bodies for p in plan.principles) if self.is_drawn else ():
            key = "free_body" if len(bodies) == 1 else "free_whole" if self._is_whole(bodies) else "free_bodies"
            script.add(Diagram(bodies, Sentence(f"figure.{key}", {"bodies": bodies}), told))
        acting = [
            row for p in plan.principles for row in self.acting.from_outside(p.bodies) if self._is_told(row, plan)
        ]
        self._name(script, [self.symmetry.merged.get(row, row) for row in acting])

    @cached_property
    def idle(self) -> frozenset[str]:
        """Reactions that never act, which the diagrams leave out."""
        world = next(self.glossary.worlds("always"), None)
        return frozenset() if world is None else idle_rows(world.snapshot)

    def _is_told(self, row: str, plan: Plan) -> bool:
        """Whether a reaction acts, or stands in an equation, or tells a point by its line of action."""
        if any(p.centre and self.acting.symbol(row) in p.centre.words.args.values() for p in plan.principles):
            return True
        slopes = self.acting.directions[row]
        arms = (self.acting.arm(p.weights, slopes) for p in plan.principles)
        return row not in self.idle or any(not self.model.samples.vanishes(arm) for arm in arms)

    def _name(self, script: Script, rows: Iterable[str]) -> None:
        name_reactions(script, self.glossary, self.acting, rows, self._named)

    # -- principles ---------------------------------------------------------------------------
    def _principle(self, script: Script, p: WritablePrinciple, avoided: Sequence[str]) -> WrittenPrinciple:
        p = self._without_roots(self._oriented(p))
        kind = f"{p.kind}_whole" if self._is_whole(p.bodies) else p.kind
        script.say(f"{self.words.group}.{kind}", bodies=p.bodies, **_where(p))
        self._say_why(script, p, avoided)
        if p.kind == "angular":
            self.rates.say_of_centre(script, p)
        left = self.rates.rate(p)
        right, rest, reactions = self._forces(p)
        self.rates.announce(script, left.terms)
        label = Sentence(f"label.{p.kind}{'_clockwise' if p.is_clockwise else ''}", _where(p))
        number = script.line(
            left.shown,
            right,
            why="space.written" if left.lines else "",
            args={"lines": left.lines},
            uses=left.lines,
            label=label if self.words.has_labels else None,
        )
        return WrittenPrinciple(number, left, rest, reactions)

    def _is_whole(self, bodies: Sequence[str]) -> bool:
        """Whether some bodies are all of a frame or truss at rest, so many that nobody reads out their names."""
        n = len(self.acting.system.moving)
        return self.words.group == "balance" and len(bodies) == n > _NAMED

    def _oriented(self, p: WritablePrinciple) -> WritablePrinciple:
        """Moments in the plane are counted in the sense that leaves fewer minus signs."""
        if p.kind != "angular" or p.aim is not None:
            return p
        other = replace(p, weights={slot: -w for slot, w in p.weights.items()}, is_clockwise=True)
        return min((p, other), key=lambda p: n_minus(self.rates.rate(p).shown) + n_minus(self._forces(p)[0]))

    def _without_roots(self, p: WritablePrinciple) -> WritablePrinciple:
        """Where nothing has inertia the length of the axis is free: it takes a root out of all terms, 0 = M/r - N/r."""
        if self.rates.rate(p).shown != ZERO:
            return p
        _shown, rest, reactions = self._forces(p)
        factor = taking_out_roots([x for x in (rest, *reactions.values()) if not x.is_zero()])
        if factor is None:
            return p
        return replace(p, weights={slot: self.field.lowest_terms(w * factor) for slot, w in p.weights.items()})

    def _say_why(self, script: Script, p: WritablePrinciple, avoided: Sequence[str]) -> None:
        """Which reactions the principle keeps out, and how."""
        # couples are no forces
        rows = [row for row in avoided if row not in self.idle and (p.kind == "angular" or self.acting.is_force(row))]
        forces: tuple[Argument, ...] = tuple(
            dict.fromkeys(self.acting.symbol(self.symmetry.merged.get(row, row)) for row in rows)
        )
        if forces:
            key = "across" if p.kind == "linear" else "through" if p.aim is None else "about_axis"
            if len(forces) > _FEW:
                script.say(f"why.{key}_many")
            else:
                script.say(f"why.{key}", forces=forces, **_where(p))
        if len(p.bodies) > 1:
            script.say("why.internal_whole" if self._is_whole(p.bodies) else "why.internal", bodies=p.bodies)

    def _forces(self, p: WritablePrinciple) -> tuple[Expr, Ratio, dict[str, Ratio]]:
        """Loads and reactions on the right: as written, the loads as an element, coefficients of reactions."""
        f, model = self.field, self.model
        shown: list[Expr] = []
        rest = f.zero
        for x in self._impressed(p):
            if not model.samples.vanishes(x):
                rest = rest + x
                shown.append(tidy(f.lowest_terms(x)))
        coefficients: dict[str, Ratio] = {}
        for row, slopes in self.acting.directions.items():
            arm = self.acting.arm(p.weights, slopes)
            if not model.samples.vanishes(arm):
                same = self.symmetry.merged.get(row, row)
                coefficients[same] = f.lowest_terms(coefficients.get(same, f.zero) + arm)
        coefficients = {row: arm for row, arm in coefficients.items() if not model.samples.vanishes(arm)}
        shown += [scaled(arm, self.acting.symbol(row)) for row, arm in coefficients.items()]
        return (positive_first(shown) if shown else ZERO), rest, coefficients

    def _impressed(self, p: WritablePrinciple) -> list[Ratio]:
        """What the loads contribute: each push by itself in the plane, each load with all its components in space."""
        if not self.acting.system.space:
            return [self.acting.arm(p.weights, slopes) * law for _push, law, slopes in self.acting.loads]
        by_load: dict[str, Ratio] = {}
        for push, law, slopes in self.acting.loads:
            arm = self.acting.arm(p.weights, slopes)
            by_load[push.load] = by_load.get(push.load, self.field.zero) + law * arm
        return [self.field.lowest_terms(self.model.in_independent_speeds(x)) for x in by_load.values()]

    # -- what is known of the forces ----------------------------------------------------------
    def _known(self, script: Script, standing: set[str], asked: Sequence[int]) -> list[EliminationRow]:
        """What is known of the reactions that stand in the equations or are asked for."""
        wanted = standing | {row for row in self.acting.rows if self.acting.generator(row) in asked}
        known = self.acting.known
        laws = {n: law for n, law in known.laws.items() if n in wanted and not (law.resultant and self._withheld)}
        found = [self._absent(script, name, why) for name, why in known.absent.items() if name in wanted]
        return [*found, *(self._law(script, name, law) for name, law in laws.items())]

    def _absent(self, script: Script, name: str, why: str) -> EliminationRow:
        """What opens transmits nothing."""
        self._name(script, [name])
        symbol = self.acting.symbol(name)
        number = script.line(symbol, ZERO, why=why, args={"force": symbol})
        return EliminationRow({self.acting.generator(name): self.field.one}, self.field.zero, number)

    def _law(self, script: Script, name: str, law: FrictionLaw) -> EliminationRow:
        """F = mu N against the slip, or Euler and Eytelwein for a string round a drum, as a line and an equation."""
        f, acting = self.field, self.acting
        self._name(script, [name, *([law.load] if law.load else [])])
        symbol, factor = acting.symbol(name), f.lowest_terms(law.factor)
        args: dict[str, Argument] = {"connection": law.place, "force": symbol}
        if law.resultant and law.share is not None:
            size = Call("sqrt", add(*(power(acting.symbol(row), number_of(2)) for row in law.resultant)))
            first = script.line(symbol, scaled(f.lowest_terms(law.share), size), why=law.why, args=args)
            lines = tuple(self._pressed[acting.generator(row)][1] for row in law.resultant)
            put_in = {"lines": lines, "line": first}
            number = script.line(symbol, tidy(factor), why="condition.put_in", args=put_in, uses=(first, *lines))
            return EliminationRow({acting.generator(name): f.one}, factor, number)
        if not law.load:
            number = script.line(symbol, tidy(factor), why=law.why, args=args)
            return EliminationRow({acting.generator(name): f.one}, factor, number)
        pressing = acting.symbol(law.load)
        sides: tuple[Expr, Expr] = symbol, scaled(factor, pressing)
        if law.drum:  # the tension before the drum is T - F, F as the row counts it
            turned = acting.symbols[name].sign * law.rub.row.sign
            before = f.lowest_terms(1 - turned * factor)
            sides = add(pressing, symbol if turned < 0 else negate(symbol)), multiply(tidy(before), pressing)
            args |= {"after": pressing, "before": sides[0], "drum": law.drum}
        number = script.line(*sides, why=law.why, args=args)
        entries = {acting.generator(name): f.one, acting.generator(law.load): f.lowest_terms(-factor)}
        return EliminationRow({k: x for k, x in entries.items() if not x.is_zero()}, f.zero, number)

    # -- solving ------------------------------------------------------------------------------
    def in_coordinates(self, script: Script, w: WrittenPrinciple) -> EliminationRow:
        """A principle with the symbols of motion replaced by the coordinates, collected by its unknowns."""
        row = self._collected(w)
        lines = self.rates.replaced(w.left)
        if lines is None:
            return row
        solver = self.solver(script)
        row = solver.cleared(row)
        args: dict[str, Argument] = {"line": w.number, "lines": lines}
        row.number = script.line(*solver.sides(row), why="solve.kinematics", args=args, uses=(w.number, *lines))
        return row

    def _collected(self, w: WrittenPrinciple) -> EliminationRow:
        f, motion = self.field, w.left.motion
        reactions = {self.acting.generator(row): f.lowest_terms(arm) for row, arm in w.reactions.items()}
        if self.acting.is_at_rest:  # the forces are the unknowns
            return EliminationRow(reactions, f.lowest_terms(motion - w.rest), w.number)
        entries: dict[int, Ratio] = {}
        rest = w.rest - motion
        for a in self.model.accelerations:
            slope = f.partial(motion, a)
            if not self.model.samples.vanishes(slope):
                entries[a] = f.lowest_terms(slope)
            rest = rest + slope * f.variable(a)
        return EliminationRow(entries | {g: -arm for g, arm in reactions.items()}, f.lowest_terms(rest), w.number)

    def unknowns(self) -> Unknowns:
        names = {a: self.field.generators[a].display for a in self.model.accelerations}
        reactions: dict[int, Expr] = {self.acting.generator(row): self.acting.symbol(row) for row in self.acting.rows}
        return Unknowns({**names, **reactions}, set(reactions))

    def solver(self, script: Script) -> Solver:
        return Solver(self.model, script, self.unknowns())


def _where(p: WritablePrinciple) -> dict[str, Argument]:
    """The direction and the point of a principle."""
    found: dict[str, Argument] = {} if p.aim is None else {"direction": p.aim.words}
    return found if p.centre is None else {**found, "point": p.centre.words}


def same_answer(found: Sequence[Ratio], wanted: Sequence[Ratio]) -> None:
    """Raises RoutesDisagree unless a derivation ends in the solver's answer."""
    if any(not (a - b).is_zero() for a, b in zip(found, wanted, strict=True)):
        raise RoutesDisagree(
            Message("the derivation ends in another formula than the solver. This is a defect of freebody")
        )
