"""Questions about a system with contacts or dry friction: answered phase by phase, as a case distinction."""

from __future__ import annotations

from contextlib import suppress
from typing import Any

import numpy as np

from freebody.assess.options import judge
from freebody.errors import CannotAnswer, RoutesDisagree
from freebody.language.expression import Expr
from freebody.language.notation import reworded
from freebody.model.question import Conserved, Energy, Equilibrium, Freedom, Question, Small
from freebody.progress import busy_with
from freebody.study.answer import Answer, AnswerCase, Evidence
from freebody.study.phases.evidence import compare
from freebody.study.phases.pieces import Piece, pieces
from freebody.study.phases.result import relations
from freebody.study.phases.tree import NO_FORM, Tree, why
from freebody.study.phases.words import summary
from freebody.symbolic.field import Ratio
from freebody.symbolic.phases.relations import Relation, readable

_ROUND_OFF = 1e-12
NOT_HERE = (Conserved, Equilibrium, Freedom, Small)


def answer(tree: Tree, question: Question) -> Answer:
    """The answer, or the reason why there is none."""
    from freebody.study.solve import unit_text

    unit = unit_text(question.quantity)
    busy_with(f"answering {question.id}: {question.text}")
    try:
        if isinstance(question.quantity, NOT_HERE):
            raise CannotAnswer("the system changes its contacts; ask for a motion, a force, or an energy")
        found = pieces(tree, question)
        parts = _merged(found)
        evidence = [compare(tree, question, group[0]) for group in parts]
    except NO_FORM as error:
        return Answer(question.id, question.text, None, unit, None, reason=why(error))
    except RoutesDisagree as error:
        return Answer(question.id, question.text, None, unit, None, reason=str(error))
    return _answer(tree, question, parts, evidence, unit)


def _merged(found: list[Piece]) -> list[list[Piece]]:
    """Pieces with the same answer together."""
    groups: list[list[Piece]] = []
    for piece in found:
        for group in groups:
            if _shown(group[0]) == _shown(piece):
                group.append(piece)
                break
        else:
            groups.append([piece])
    return groups


def _shown(piece: Piece) -> Expr | tuple[Expr, ...]:
    return tuple(map(readable, piece.value)) if isinstance(piece.value, tuple) else readable(piece.value)


def _answer(tree: Tree, question: Question, parts: list[list[Piece]], evidence: list[Evidence], unit: str) -> Answer:
    main = parts[0][0]
    conditions = _conditions(tree, parts[0])
    value = _value(tree, main) if tree.system.has_values else None
    notes = [*main.notes, f"while the system {summary(main.phase)}"] if main.first is None else list(main.notes)
    if tree.system.has_values and not any(0 in p.sets for p in parts[0]):
        broken = _broken(tree, parts[0])
        notes.append(reworded(f"NOT SO at the model's own values: {broken}", broken))
        value = None
    cases = tuple(AnswerCase(_shown(group[0]), _conditions(tree, group), summary(group[0].phase)) for group in parts)
    judgement: Any = None
    if question.options:
        is_home = main.is_home
        model = tree.home.model if is_home else main.phase.model
        system = tree.system if is_home else main.phase.system
        has_potential = isinstance(question.quantity, Energy) and question.quantity.what != "kinetic"
        region = [c.element for c in main.conditions if c.relation != "!="] if is_home else []
        judgement = judge(
            question,
            main.value if isinstance(main.value, Ratio) else (main.value[0], main.value[1]),
            question.quantity.dimension,
            model,
            system,
            up_to_constant=has_potential,
            region=region,
        )
    return Answer(
        question.id,
        question.text,
        _shown(main),
        unit,
        value,
        conditions or (_for_all(tree),),
        tuple(notes),
        choice=None if judgement is None else judgement.choice,
        options={} if judgement is None else judgement.options,
        author_notes=() if judgement is None else judgement.notes,
        evidence=Evidence(
            sum(e.draws for e in evidence), max(e.worst_relative_difference for e in evidence), evidence[0].route
        ),
        cases=cases if len(cases) > 1 else (),
    )


def _conditions(tree: Tree, group: list[Piece]) -> tuple[str, ...]:
    """The conditions of all pieces with one answer; where there are several, those that they share."""
    lists = [relations(tree, p.conditions) for p in group]
    shared = [r for r in lists[0] if all(any(_same(r, other) for other in more) for more in lists[1:])]
    return tuple(r.text() for r in shared)


def _same(a: Relation, b: Relation) -> bool:
    return a.text() == b.text()


def _broken(tree: Tree, group: list[Piece]) -> str:
    for r in relations(tree, group[0].conditions):
        value = float(tree.numbers(r.element)[0])
        if not (value > 0 or (r.relation == ">=" and value >= 0)):
            return reworded(f"{r.text()} is not true there", r.text())
    return "the model takes another way there"


def _for_all(tree: Tree) -> str:
    from freebody.study.solve import for_all

    return for_all(tree.system)


def _value(tree: Tree, piece: Piece) -> float | tuple[float, ...] | None:
    """In numbers at the model's values; a function of the state at the start."""
    parts = piece.value if isinstance(piece.value, tuple) else (piece.value,)
    values: list[float] = []
    for part in parts:
        if not piece.is_home:
            with suppress(CannotAnswer):
                part = tree.to_home(piece.phase, piece.phase.start_instant.here(part))
        value = float(tree.numbers(part)[0])
        if not np.isfinite(value):
            return None
        values.append(0.0 if abs(value) < _ROUND_OFF else value)
    return tuple(values) if isinstance(piece.value, tuple) else values[0]
