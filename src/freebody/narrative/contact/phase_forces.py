"""What acts in one phase: dry friction that slides is a force of its own, with its law beside it.

In a phase a contact that is closed has a row like any connection, and so has friction that sticks. Friction that slides
is F = -s c N along its slip (s the sense of the slip, c the kinetic coefficient): F stands in the principles as an
unknown like N, and the law is one more equation.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping

from freebody.language.expression import Symbol
from freebody.model.elements import DryFriction
from freebody.narrative.lines.glossary import Glossary, Meaning, World
from freebody.narrative.lines.script import Script
from freebody.narrative.principles.acting import Acting, FrictionLaw, Known
from freebody.narrative.principles.newton import AT_REST_WORDS, Newton
from freebody.narrative.principles.planar_rates import PlanarRates
from freebody.narrative.principles.planner import SLIDING_IN_SPACE, WITH_CONTACTS
from freebody.narrative.principles.reactions import words_of
from freebody.narrative.principles.symmetry import Symmetry
from freebody.narrative.space.spatial_kinematics import SpatialKinematics
from freebody.narrative.space.spatial_rates import SpatialRates
from freebody.study.phases.phase import Phase
from freebody.study.phases.quantities import value_in_mode
from freebody.study.senses import drawn_symbols
from freebody.symbolic.phases.friction import pressing
from freebody.system.symbols import ReactionSymbol


def newton_of_phase(phase: Phase, glossary: Glossary) -> Newton:
    """Derives accelerations, normal forces and frictions of one phase; no place of contact stands for another one."""
    symbols = drawn_symbols(phase.base)
    laws = {law.rub.name: law for law in _laws(phase, symbols)}
    sliding = {name: law.rub.row for name, law in laws.items()}
    rows = {**{row.name: row for row in phase.system.constraint_rows}, **sliding}
    acting = Acting(phase.model, symbols=symbols, rows=rows, known=Known(laws, {}))
    for name in sliding:
        reads = _reads_friction(name, symbols[name].sign)
        glossary.introduce(Meaning(Symbol(acting.symbols[name].name), words_of(acting, name), reads))
    symmetry = Symmetry(acting, glossary, is_sought=False)
    rates = (
        SpatialRates(SpatialKinematics(phase.setup, glossary, Script(glossary)))
        if phase.system.space
        else PlanarRates(acting, glossary, symmetry)
    )
    return Newton(
        acting,
        glossary,
        rates,
        symmetry,
        words=AT_REST_WORDS if acting.stands_still else None,
        preferences=SLIDING_IN_SPACE if phase.system.space else WITH_CONTACTS,
        value_of=lambda quantity, state: value_in_mode(quantity, phase.base, phase.system, state),
    )


def _reads_friction(name: str, sign: int) -> Callable[[World], float]:
    """A sliding friction is read from the load that the numeric route has for it."""

    def read(world: World) -> float:
        applied_loads = world.snapshot.reference.system.applied_loads
        return sign * float(world.snapshot.law(next(p for p in applied_loads if p.load == name)))

    return read


def _laws(phase: Phase, symbols: Mapping[str, ReactionSymbol]) -> list[FrictionLaw]:
    found: list[FrictionLaw] = []
    for name, sense in phase.mode.states.items():
        if sense:
            rub = phase.dry_friction[name]
            sign = symbols[name].sign
            share = -sense * sign * phase.coefficient(rub, sense, at_rest=False)
            way = "forward" if sense * sign > 0 else "backward"
            key, place = f"friction.slides_{way}", rub.row.connection
            if len(pressed := pressing(phase.model, rub, phase.rows)) > 1:
                whole = phase.model.field.lowest_terms(share * phase.load(rub))
                both = tuple(row.name for row, _x in pressed)
                found.append(FrictionLaw(rub, whole, "", key, place, resultant=both, share=share))
                continue
            load, is_back = _load(phase, rub, symbols)
            found.append(FrictionLaw(rub, -share if is_back else share, load, key, place))
    return found


def _load(phase: Phase, rub: DryFriction, symbols: Mapping[str, ReactionSymbol]) -> tuple[str, bool]:
    """The row that presses, and whether its reaction is negative."""
    if not rub.load:
        return "", False
    model = phase.model
    name = next((row.name for row, _x in pressing(model, rub, phase.rows)), rub.load[0])
    row = phase.rows[name]
    return name, not row.unilateral and model.samples.is_negative(symbols[name].sign * model.reactions.multiplier(row))
