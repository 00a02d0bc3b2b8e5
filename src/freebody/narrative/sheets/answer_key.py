"""The answer key of an exercise sheet: letters, formulas, values."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from freebody.language.expression import Expr
from freebody.language.raising import raised, typeset
from freebody.language.sentences import Sentence
from freebody.narrative.lines.script import ready
from freebody.narrative.telling.catalogue import Catalogue
from freebody.present.report.blocks import Emphasis, Formula, Table, Text
from freebody.study.answering.answer import Answer


@dataclass(frozen=True)
class KeyEntry:
    """What is right in one question of a variant. letter: of the right option, empty without options."""

    label: str
    question: str
    letter: str
    expression: Expr | tuple[Expr, ...] | None
    value: float | tuple[float, ...] | None
    unit: str
    conditions: tuple[str, ...]
    reason: str = ""  # why there is no answer


def key_of(answer: Answer, label: str) -> KeyEntry:
    letter = answer.choice or ""
    if answer.options and not letter:
        right = [k for k, v in answer.options.items() if v.verdict == "right"]
        letter = ", ".join(right)
    return KeyEntry(
        label,
        answer.question,
        letter,
        answer.expression,
        answer.value,
        "" if answer.unit == "1" else answer.unit,
        answer.conditions,
        "" if answer.is_answered else answer.reason,
    )


def key_table(catalogue: Catalogue, keys: Sequence[KeyEntry]) -> Table:
    header = tuple(
        catalogue.tell(Sentence(f"sheet.{name}")) for name in ("exercise_short", "option", "formula", "value")
    )
    rows = tuple(_key_row(catalogue, key) for key in keys)
    return Table(header, rows)


def _key_row(catalogue: Catalogue, key: KeyEntry) -> tuple[Text, ...]:
    letter: Text = (f"({key.letter})",) if key.letter else ()
    formula: Text = () if key.expression is None else (Formula((key.expression,)),)
    if key.reason and key.expression is None:
        formula = catalogue.tell(Sentence("sheet.unanswered", {"reason": ready(key.reason)}))
    elif key.expression is None and key.conditions:
        formula = (", ".join(map(catalogue.said, key.conditions)),)
    values = key.value if isinstance(key.value, tuple) else (() if key.value is None else (key.value,))
    apart = ", " if catalogue.decimal == "." else "; "
    value = apart.join(typeset(f"{v:.4g}").replace(".", catalogue.decimal) for v in values)
    if len(values) > 1:
        value = f"({value})"
    return (Emphasis(key.label),), letter, formula, (_unbroken(f"{value} {raised(key.unit)}"),) if value else ()


def _unbroken(value: str) -> str:
    """A value that stays on the line of its unit."""
    return value.strip().replace(" ", "\u00a0")
