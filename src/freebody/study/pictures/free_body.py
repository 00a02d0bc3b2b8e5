"""What acts on bodies that are cut free: every load, and every reaction of a connection to what is not cut free with
them, at its point and in the direction in which it is counted positive.

The force of a row on a body is multiplier times gradient; so a reaction R = sign * multiplier acts with sign *
gradient: a force f and a moment m about the mass centre. Strings act where they leave their pulleys; for all others
see `Action`.
"""

from __future__ import annotations

import math
from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import replace
from functools import cached_property
from itertools import combinations, groupby

import numpy as np

from freebody.errors import InputError
from freebody.language.expression import Call, Expr, ProductOf, children, free_symbols, multiply
from freebody.language.sentences import Message
from freebody.loads.gravity import Gravity
from freebody.measures.base import Measure
from freebody.measures.geometry import GROUND
from freebody.model.elements import AppliedLoad, ConstraintRow, NonholonomicForm
from freebody.model.glyphs import Rope
from freebody.model.noting import did_you_mean
from freebody.numeric.instant import law
from freebody.numeric.jets import Array
from freebody.numeric.snapshot import Snapshot
from freebody.present.picture.forces import Kind, ShownForce
from freebody.present.picture.label import Label, Run, beside, formula, name
from freebody.study.pictures.action import Action, cross
from freebody.study.pictures.idle import idle_rows
from freebody.study.pictures.line_of_centers import across_the_line
from freebody.study.pictures.load_symbols import LONGEST, LoadSymbols, shorter, without_sign
from freebody.study.pictures.points import own_measures
from freebody.study.pictures.strings import Pull, pulls, rope_of
from freebody.study.senses import drawn_symbols, load_senses
from freebody.system.symbols import ReactionSymbol
from freebody.system.system import System
from freebody.tolerances import ON_LINE, ROUND_OFF


def checked_bodies(system: System, bodies: Sequence[str]) -> tuple[str, ...]:
    """Names of bodies to cut free. Raises InputError for others."""
    known = [name for name in system.bodies if name != GROUND]
    for body in bodies:
        if body == GROUND:
            raise InputError(Message("the ground cannot be cut free; take one of {known}", known=", ".join(known)))
        if body not in known:
            raise InputError(Message("there is no body {name}.{hint}", name=body, hint=did_you_mean(body, known)))
    if not bodies:
        raise InputError(Message("name the bodies to cut free: {known}", known=", ".join(known)))
    return tuple(dict.fromkeys(bodies))


class FreeBody:
    """Bodies cut free at one instant. closed: the bounds that are closed then, by name; slips: the sense in which
    dry friction slides, by the name of its row; values: of multipliers, by the name of the row; told: rows that are
    drawn even if they never act; symbols: of the reactions, where they are known."""

    def __init__(
        self,
        snapshot: Snapshot,
        bodies: Sequence[str],
        *,
        closed: frozenset[str] = frozenset(),
        labels: Mapping[str, str] | None = None,
        told: Collection[str] = (),
        symbols: Mapping[str, ReactionSymbol] | None = None,
        other_sides: frozenset[str] = frozenset(),
    ) -> None:
        self.snapshot = snapshot
        self.system = snapshot.reference.system
        self.bodies = checked_bodies(self.system, bodies)
        self.closed, self.other_sides = closed, other_sides
        own = {name: label for name, label in self.system.looks.labels.items() if name in self.system.loads}
        self.labels = own | dict(labels or {})  # of loads as their author has them
        self.told = frozenset(told)
        self._symbols = symbols
        self.size = snapshot.reference.sizes.length
        self.reference = snapshot.reference

    @cached_property
    def symbols(self) -> Mapping[str, ReactionSymbol]:
        return drawn_symbols(self.system) if self._symbols is None else self._symbols

    @cached_property
    def action(self) -> Action:
        return Action(self.snapshot)

    @cached_property
    def load_symbols(self) -> LoadSymbols:
        return LoadSymbols(self.system, self.symbols, self.labels, load_senses(self.system))

    def forces(self) -> tuple[ShownForce, ...]:
        """What acts from outside, in the order of the model: loads, then reactions."""
        return tuple(self._all(only_outside=True))

    def all_forces(self) -> tuple[ShownForce, ...]:
        """Those between the bodies too, on each of both."""
        return tuple(self._all(only_outside=False))

    def loads(self) -> tuple[ShownForce, ...]:
        """The loads, those between the bodies too."""
        return tuple(self._loads(only_outside=False))

    def impulses(self) -> tuple[ShownForce, ...]:
        """Those of the blow at the start."""
        return tuple(force for push in self.system.impulses for force in self._load(push))

    def reaction_values(self, reactions: Mapping[str, float]) -> dict[str, float]:
        """[N] or [N m] of the symbols of rows. reactions: by row, counted as the rows are."""
        own = {row.name: row.sign for row in self.system.rows}
        return {n: x * own[n] * self.symbols[n].sign for n, x in reactions.items() if n in self.symbols}

    def load_value(self, called: str) -> float | None:
        """[N] or [N m] of the symbol of a load, by its name."""
        for applied_loads in self._pushes():
            if len(applied_loads) > 1 and applied_loads[0].load == called:
                return self._total(applied_loads)
            for push in applied_loads:
                if push.name == called:
                    return self.load_symbols.of(push)[1] * self.snapshot.law(push)
        return None

    def _all(self, *, only_outside: bool) -> Iterator[ShownForce]:
        yield from self._loads(only_outside=only_outside)
        for _connection, group in groupby(self.rows, key=lambda row: row.connection):
            yield from self._connection(list(group), only_outside=only_outside)

    @property
    def rows(self) -> tuple[ConstraintRow, ...]:
        """What is held, and of what may touch or rub what is closed."""
        bounds = [bound.row for bound in self.system.bounds if bound.name in self.closed]
        rubs = [rub for rub in self.system.dry_friction if not rub.of or rub.of in self.closed]
        dry_friction = [row for rub in rubs for row in rub.rows]
        own = (row for row in self.system.constraint_rows if row.transmits and row.name not in self.idle)
        held = (
            replace(row, measure=row.pressed.other) if row.pressed and row.name in self.other_sides else row
            for row in own
        )
        return (*held, *bounds, *dry_friction)

    @cached_property
    def idle(self) -> frozenset[str]:
        """Rows that never transmit anything."""
        return idle_rows(self.snapshot) - self.told

    def _is_internal(self, measure: Measure | NonholonomicForm) -> bool:
        others = set(measure.bodies()) - set(self.bodies)
        small = ON_LINE * self.size
        return all(max(map(abs, self.snapshot.gradient(measure, body))) < small for body in others)

    # -- reactions ----------------------------------------------------------------------------
    def _connection(self, rows: Sequence[ConstraintRow], *, only_outside: bool) -> Iterator[ShownForce]:
        rope = None if self.system.space else rope_of(self.system, rows[0].connection)
        leads = rope.sign.leads if rope is not None and isinstance(rope.sign, Rope) else ()
        taut = [row for row in rows if row.component in {lead.row for lead in leads}]
        rims: dict[tuple[str, str], Array] = {}  # where a string leaves a body for another one
        for row, found in pulls(rope, taut, self.reference, self.snapshot) if rope is not None else ():
            rims |= {(body, other): at for body, other, at, _pull in found}
            yield from self._string(row, found, only_outside=only_outside)
        rest = [row for row in rows if row not in taut]
        for row in rest:
            rim = next((at for pair, at in rims.items() if self._rubs_on(row, *pair)), None)
            if rim is not None:
                yield from self._rub(row, rim)
            elif not (only_outside and self._is_internal(row.measure)):
                # each lead of a string has a line of action of its own
                yield from self._reaction(row, [row] if row.reaction == "tension" else rest)

    def _string(self, row: ConstraintRow, found: Sequence[Pull], *, only_outside: bool) -> Iterator[ShownForce]:
        """Its pulls at the bodies that are cut free, without those from each other."""
        label = self._label_of(row)
        own = [
            (body, at, pull)
            for body, other, at, pull in found
            if body in self.bodies and not (only_outside and other in self.bodies)
        ]
        whole = [(body, at, pull) for body, _other, at, pull in found]
        if not self._adds_up(row, whole):
            yield from self._reaction(row, [row])
            return
        for body, at, pull in own:
            away = tuple(map(float, at - self.action.center(body)))
            size = float(np.hypot(*pull))
            yield ShownForce(row.name, scaled(label, size), body, away, _components(pull), (0.0,), about=row.reaction)

    def _rubs_on(self, row: ConstraintRow, drum: str, other: str) -> bool:
        """Whether a string rubs on a body that stands still, of whose turning the row says nothing."""
        is_shown = drum in self.bodies and drum != GROUND and self.system.bodies[drum].fixed
        return is_shown and row.reaction == "friction force" and {drum, other} <= set(row.measure.bodies())

    def _rub(self, row: ConstraintRow, rim: Array) -> Iterator[ShownForce]:
        """Of the string, where it leaves the rim."""
        drum = next(body for body in self.bodies if body in set(row.measure.bodies()))
        f, _m = self.action.wrench(row.measure, drum)
        away = tuple(map(float, rim - self.action.center(drum)))
        force = _components(self.symbols[row.name].sign * f)
        yield ShownForce(row.name, self._label_of(row), drum, away, force, (0.0,), about=row.reaction)

    def _adds_up(self, row: ConstraintRow, found: Sequence[tuple[str, Array, Array]]) -> bool:
        """Whether pulls at points are all that a row does to its bodies."""
        for body in dict.fromkeys(body for body, _at, _pull in found):
            f, m = self.action.wrench(row.measure, body)
            own = [(at - self.action.center(body), pull) for name, at, pull in found if name == body]
            total = sum((pull for _away, pull in own), np.zeros(2))
            turn = sum(away[0] * pull[1] - away[1] * pull[0] for away, pull in own)
            turns = body == GROUND or not self.system.bodies[body].turns
            if np.abs(total - row.sign * f).max() > 1e-6:
                return False
            if not turns and abs(turn - row.sign * float(m[0])) > 1e-6 * self.size:
                return False
        return True

    def _reaction(self, row: ConstraintRow, siblings: Sequence[ConstraintRow]) -> Iterator[ShownForce]:
        for body in self.bodies:
            if body in set(row.measure.bodies()):
                f, m = self.action.wrench(row.measure, body)
                label, sign = self._label_of(row), self.symbols[row.name].sign
                yield from self._placed(row, siblings, body, sign * f, sign * m, label, "reaction")

    def _label_of(self, row: ConstraintRow) -> Label:
        symbol = self.symbols[row.name]
        given = self.labels.get(row.name, self.labels.get(symbol.name))
        return name(symbol.name if given is None else given)

    # -- loads --------------------------------------------------------------------------------
    def _loads(self, *, only_outside: bool) -> Iterator[ShownForce]:
        for applied_loads in self._pushes():
            if len(applied_loads) > 1:
                yield from self._resultant(applied_loads, only_outside=only_outside)
            elif not (only_outside and self._is_internal(applied_loads[0].measure)):
                yield from self._load(applied_loads[0])

    def _pushes(self) -> Iterator[Sequence[AppliedLoad]]:
        """In the order of the model; those together that are components of one force, as of a spring of length 0."""
        for load, group in groupby(self.system.applied_loads, key=lambda push: push.load):
            applied_loads = list(group)
            own = self.system.loads.get(load)
            if own is not None and own.pulls_with([0.0] * len(applied_loads), math.sqrt) is not None:
                yield applied_loads
            else:
                yield from ([push] for push in applied_loads)

    def _total(self, applied_loads: Sequence[AppliedLoad]) -> float:
        """[N] of the force that several pushes are the components of."""
        own = self.system.loads[applied_loads[0].load]
        return float(own.pulls_with([self.snapshot.law(push) for push in applied_loads], math.sqrt))

    def _resultant(self, applied_loads: Sequence[AppliedLoad], *, only_outside: bool) -> Iterator[ShownForce]:
        """A force of several components in the sense in which it acts in this pose: where it is zero it has none."""
        total = self._total(applied_loads)
        if total <= sum(self._unsettled(push) for push in applied_loads):
            return
        parts = {push: self.snapshot.law(push) / total for push in applied_loads}

        def wrench(body: str) -> tuple[Array, Array]:
            both = [(part, *self.action.wrench(push.measure, body)) for push, part in parts.items()]
            return np.sum([part * f for part, f, _m in both], axis=0), np.sum(
                [part * m for part, _f, m in both], axis=0
            )

        pushed = {body for push in applied_loads for body in push.measure.bodies()}
        small = ON_LINE * self.size
        if only_outside and all(np.abs(np.hstack(wrench(body))).max() < small for body in pushed - set(self.bodies)):
            return
        whole = replace(applied_loads[0], component="")
        label, _sign = self.load_symbols.of(whole)
        for body in self.bodies:
            if body in pushed:
                found = self._placed(whole, (), body, *wrench(body), label, "load")
                yield from (replace(force, about=f"load {whole.load}") for force in found)

    def _unsettled(self, push: AppliedLoad) -> float:
        """[N] by how much a law changes where its measure changes by less than a picture shows."""
        reference, geometry = self.reference, self.snapshot.geometry
        here = reference.jet(geometry, push.measure)
        return abs(law(reference, geometry, push, here + ON_LINE * self.size) - law(reference, geometry, push, here))

    def _load(self, push: AppliedLoad) -> Iterator[ShownForce]:
        is_weight = isinstance(self.system.loads.get(push.load), Gravity)
        label, sign = self.load_symbols.of(push)
        about = "weight" if is_weight else f"load {push.load}"
        for body in self.bodies:
            if body in set(push.measure.bodies()):
                f, m = self.action.wrench(push.measure, body)
                kind: Kind = "weight" if is_weight else "load"
                found = self._placed(push, (), body, sign * f, sign * m, label, kind)
                yield from (replace(force, about=about) for force in found)

    # -- where --------------------------------------------------------------------------------
    def _placed(
        self,
        of: ConstraintRow | AppliedLoad,
        siblings: Sequence[ConstraintRow],
        body: str,
        f: Array,
        m: Array,
        label: Label,
        kind: Kind,
    ) -> Iterator[ShownForce]:
        """A force at its point of action, a couple, or both."""
        size, center = float(np.linalg.norm(f)), self.action.center(body)
        about = of.reaction if isinstance(of, ConstraintRow) else ""
        turns = self.system.bodies[body].turns
        nothing = (0.0,) * len(m)
        rest = m if turns else np.zeros(len(m))
        if size > ROUND_OFF:
            at = self.action.point(of, siblings, body, f, rest) if turns else center
            away = at - center
            rest = rest - cross(away, f)
            away_components, label_f = tuple(map(float, away)), self._times(of, body, label, size)
            yield ShownForce(of.name, label_f, body, away_components, _components(f), nothing, kind, about=about)
        if turns and float(np.abs(rest).max()) > ON_LINE * (self.size if size > ROUND_OFF else 1.0):
            amount = float(np.linalg.norm(rest))
            own = self.action.couple_point(of, siblings, body)
            away_components = tuple(map(float, own - center))
            label_m = self._times(of, body, label, amount)
            still = (0.0,) * len(f)
            yield ShownForce(of.name, label_m, body, away_components, still, _components(rest), kind, about=about)

    def _times(self, of: ConstraintRow | AppliedLoad, body: str, label: Label, size: float) -> Label:
        """What a force or a couple is that is `size` times a symbol, in symbols where the model has them."""
        if abs(size - 1.0) < 1e-6:
            return label
        factor = self._factor(of, body, size)
        if factor is not None:
            return beside(factor, label, "\u2009")
        across = across_the_line(self.system, of, body, size, self.reference.number)
        if across is not None:
            arm = in_brackets(formula(shorter(across[0])))
            return divided(beside(arm, label, "\u2009"), across[1])
        cosines = self._cosines(of, size)
        return scaled(label, size) if cosines is None else over(label, cosines)

    def _cosines(self, of: ConstraintRow | AppliedLoad, size: float) -> Expr | None:
        """Of the angles of a flank, whose tangents a measure has for its components: F_t/cos(alpha)."""
        found = [cosine for factor, _part in own_measures(of.measure) for cosine in cosines_of(factor)]
        angles = list(dict.fromkeys(found))
        for n in (1, 2):
            for chosen in combinations(angles, n):
                product = multiply(*chosen)
                if abs(abs(self.reference.number(product)) * size - 1.0) < 1e-9:
                    return product
        return None

    def _factor(self, of: ConstraintRow | AppliedLoad, body: str, amount: float) -> Label | None:
        """The coefficient as the model writes it: the arm R of a couple R F."""
        for coefficient, part in own_measures(of.measure):
            if body in set(part.bodies()) and not free_symbols(coefficient) <= set():
                value = abs(self.reference.number(coefficient))
                if abs(value - amount) < 1e-9 * max(1.0, amount):
                    arm = formula(shorter(without_sign(coefficient)[0]))
                    return in_brackets(arm) if len(arm.text) <= LONGEST else None
        return None


def scaled(label: Label, size: float) -> Label:
    """What a force is that is `size` times a symbol."""
    if abs(size - 1.0) < 1e-6:
        return label
    told = next((text for text in (f"{size:.{n}g}" for n in (3, 4, 5)) if text != "1"), f"{size:.6f}")
    return beside(Label((Run(told),), told), label, "\u2009")


def over(label: Label, divisor: Expr) -> Label:
    """A label divided by what is positive: F_t/cos(alpha)."""
    below = formula(divisor)
    return divided(label, below, is_product=isinstance(divisor, ProductOf))


def divided(label: Label, below: Label, *, is_product: bool = False) -> Label:
    """A label over another one."""
    shown = bracketed(below) if is_product else in_brackets(below)
    return Label((*label.runs, Run("/"), *shown.runs), rf"\frac{{{label.latex}}}{{{below.latex}}}")


def in_brackets(label: Label) -> Label:
    """As a factor: a sum in brackets, anything else as it is."""
    is_sum = any(run.level == 0 and set(run.text) & set("+\u2212") for run in label.runs)
    return bracketed(label) if is_sum else label


def bracketed(label: Label) -> Label:
    """A label in brackets."""
    return Label((Run("("), *label.runs, Run(")")), rf"\left({label.latex}\right)")


def cosines_of(factor: Expr) -> Iterator[Expr]:
    """Of the angles whose tangents or cosines stand in a factor."""
    if isinstance(factor, Call) and factor.function in ("tan", "cos"):
        yield Call("cos", factor.argument)
    for part in children(factor):
        yield from cosines_of(part)


def _components(v: Array) -> tuple[float, ...]:
    return tuple(float(x) + 0.0 for x in v)
