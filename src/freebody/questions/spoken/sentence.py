"""A question parted into its main clause and the clauses beside it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from freebody.language.units import TIME
from freebody.questions.spoken import along_lines, dimensions, lookup
from freebody.questions.spoken.lexicon import Word
from freebody.questions.spoken.words import Clause

if TYPE_CHECKING:
    from freebody.model.names import Names

_COMMA = Word("preposition", ",")
_IT = Word("pronoun", "it")


@dataclass(frozen=True)
class Sentence:
    """A main clause, and clauses beside it with what leads to each."""

    main: Clause
    others: tuple[tuple[str, Clause], ...] = ()


def parted(words: list[Word]) -> Sentence | None:
    """A question and its clauses: the main one comes first, or behind a comma."""
    if words and words[0] == Word("ask", "when") and _COMMA in words:
        after = words[words.index(_COMMA) + 1 :]
        if any(word.kind in ("ask", "quantity") for word in after[:3]):
            words = [Word("mark", "when"), *words[1:]]
    parts: list[tuple[str, list[Word]]] = [("", [])]
    for k, word in enumerate(words):
        if word.kind == "mark":
            parts.append((word.what, []))
        elif word == _COMMA and parts[0][1] == [] and len(parts) > 1 and k + 1 < len(words):
            parts.append(("", []))
        elif word != _COMMA:
            parts[-1][1].append(word)
        elif k + 1 < len(words) and words[k + 1].kind not in ("mark", "instant", "part"):
            return None  # two questions, or a name and another one
    for mark, own in parts[1:]:  # what did it reach after 2 s: the verb may stand behind the time
        if mark == "after" and len(own) > 1 and own[0].kind == "value" and dimensions.is_time(own[0].what):
            parts[0][1].extend(own[1:])
            del own[1:]
        ends = mark == "until" and [word.kind for word in own] == ["verb", "verb"]  # bis zum Stillstand gerutscht
        if ends and own[0].what in ("stop", "begin_roll"):
            parts[0][1].append(own.pop())
    main = [own for mark, own in parts if not mark and own]
    if len(main) != 1:
        return None
    return Sentence(Clause(main[0]), tuple((mark, Clause(own)) for mark, own in parts if mark))


def told_who(names: Names, sentence: Sentence) -> Sentence:
    """The sentence with the body that `it` is: the only one that the main clause names, where several move. It is also
    who does what nobody is said to do: after falling 1 m, after 3 turns."""
    sentence = _landing(names, sentence)
    main = [name for _, name in sentence.main.names]
    who = [name for name in dict.fromkeys(main) if name in lookup.moving(names)]
    if len(who) != 1 or len(lookup.moving(names)) < 2 or any(name in names.connections for name in main):
        return sentence
    others: list[tuple[str, Clause]] = []
    for mark, own in sentence.others:
        is_open = not any(name in lookup.moving(names) or name in names.measures for _, name in own.names)
        words = [Word("name", who[0]) if word == _IT and is_open else word for word in own.words]
        is_doing = mark == "after" and own.has("verb") and own.has("value") and not own.has("quantity", "time")
        is_doing |= mark == "after" and own.has("turns") and who[0] in lookup.turning(names)
        if is_doing and is_open and _IT not in own.words and Word("pronoun", "system") not in own.words:
            words = [Word("name", who[0]), *words]
        others.append((mark, Clause(words)))
    return Sentence(sentence.main, tuple(others))


def _landing(names: Names, sentence: Sentence) -> Sentence:
    """The sentence with the point that `it` is, the only one of the main clause, which comes down to a line."""
    point = [name for _, name in sentence.main.names if "." in name]
    if len(point) != 1 or len(sentence.main.names) != 1:
        return sentence
    others: list[tuple[str, Clause]] = []
    for mark, own in sentence.others:
        lands = any(along_lines.down_to(names, point[0], name) for _, name in own.names)
        words = [Word("name", point[0]) if word == _IT and lands else word for word in own.words]
        others.append((mark, Clause(words)))
    return Sentence(sentence.main, tuple(others))


def clock(names: Names, clause: Clause) -> str | None:
    """A time since the start that a clause is: 2 s, or a parameter that is a time."""
    times = [name for _, name in clause.names if name in names.parameters and names.parameters[name].dimension == TIME]
    if len(times) == 1 and clause.only("name", "preposition", "pronoun") and len(clause.names) == 1:
        return times[0]
    values = clause.values
    if len(values) == 1 and clause.only("value", "preposition", "pronoun") and dimensions.is_time(values[0][1], names):
        return values[0][1]
    return None
