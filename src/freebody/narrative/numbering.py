"""Numbers of equations: they run through all derivations, and an equation has one if something refers to it.

What follows from the lines right above needs no reference ("Differentiating:" instead of "Differentiating (3):"), where
the catalogue has words for that, and a reason that has just been given is not given again.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace

from freebody.language.sentences import Sentence
from freebody.narrative.lines.script import REFERENCES, DerivationStage, Item, Legend, NumberedFormula
from freebody.narrative.sharing import referred, referred_in, referring, renumbered_item
from freebody.narrative.telling.catalogue import Catalogue

Stages = tuple[DerivationStage, ...]


def numbered(parts: Sequence[Sequence[DerivationStage]], words: Catalogue) -> list[Stages]:
    """The parts of an explanation, in the order in which they are read, with their final numbers. words: those of which
    every language has a translation."""
    said = [tuple(_without_needless(part, words)) for part in parts]
    named = {n for part in said for stage in part for item in stage.items for n in referred_in(item)}
    named |= {n for part in said for stage in part for n in referred(stage.hint)}
    numbers: dict[int, int] = {}
    n_silent = 0
    for line in (item for part in said for stage in part for item in stage.items if isinstance(item, NumberedFormula)):
        n_silent += line.number not in named
        numbers[line.number] = len(numbers) - n_silent + 1 if line.number in named else -n_silent
    return [tuple(_renumbered(stage, numbers) for stage in part) for part in said]


def _renumbered(stage: DerivationStage, numbers: Mapping[int, int]) -> DerivationStage:
    return replace(stage, items=tuple(renumbered_item(item, numbers) for item in stage.items))


def _without_needless(part: Sequence[DerivationStage], words: Catalogue) -> Iterator[DerivationStage]:
    """The stages with reasons that need no number of the lines right above, and not the same reason twice."""
    above: list[int] = []  # the lines so far
    for stage in part:
        items: list[Item] = []
        reason = ""
        begins = len(above)
        for item in stage.items:
            if isinstance(item, NumberedFormula):
                own = _in_words(item.why, words)
                why = None if own and own == reason else _near(_spoken(item.why, words), above, begins, words)
                items.append(replace(item, why=why))
                above.append(item.number)
                reason = own
            else:
                items.append(item)
                if not isinstance(item, Legend):
                    reason = ""
        yield replace(stage, items=tuple(items))


def _in_words(why: Sentence | None, words: Catalogue) -> str:
    return "" if why is None else words.plain(referring(why, {}))


def _spoken(why: Sentence | None, words: Catalogue) -> Sentence | None:
    """The reason without lines of which its words do not speak."""
    if why is None:
        return None
    said = words.template(why.key)
    return Sentence(why.key, {k: v for k, v in why.args.items() if k not in REFERENCES or f"{{{k}}}" in said})


def _near(why: Sentence | None, above: Sequence[int], begins: int, words: Catalogue) -> Sentence | None:
    """The reason without numbers, where it names the last lines alone: one of this stage, or several."""
    if why is None:
        return None
    lines = set(referred(why))
    first = len(above) - len(lines)
    if lines and lines == set(above[first:]) and (first >= begins or len(lines) > 1) and words.has(f"{why.key}_next"):
        return Sentence(f"{why.key}_next", {k: v for k, v in why.args.items() if k not in REFERENCES})
    return why
