"""Runs of letters as names of a problem: mgR is m g R where the problem has m, g and R and no mgR.

A run is taken for one name if it is one, underscores and braces aside (v_0, v_{0} and v0 are the same); else it is cut
into the fewest names and functions. M and m, T and t are different letters, and are never taken for each other.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Literal

from freebody.errors import ExpressionError
from freebody.language.expression import LAMBERT
from freebody.language.parser import GREEK
from freebody.language.sentences import Message

FUNCTIONS = {
    **{
        name: name
        for name in ("sin", "cos", "tan", "sinh", "cosh", "tanh", "exp", "log", "sqrt", "asin", "acos", "atan")
    },
    **{"arcsin": "asin", "arccos": "acos", "arctan": "atan", "arctg": "atan", "tg": "tan", "ln": "log", "abs": "abs"},
    **{"cot": "cot", "ctg": "cot", "sec": "sec", "csc": "csc", "sgn": "sign", "sign": "sign", "√": "sqrt"},
    **{name: name for name in ("elliptic_K", "elliptic_F", "fresnel_c", "fresnel_s", *LAMBERT, "rate")},
}
_VARIANTS = {"ς": "sigma", "ϑ": "theta", "ϕ": "phi", "ϵ": "epsilon", "\u00b5": "mu", "\u2126": "Omega"}
_LETTERS = {**GREEK, **_VARIANTS}
_INDICES: dict[str, str] = dict(zip("₀₁₂₃₄₅₆₇₈₉", "0123456789", strict=True))
_SPELT = {"lambda": "lam", "varphi": "phi", "vartheta": "theta", "varepsilon": "epsilon", "Lambda": "Lambda"}
_DOTTED = (("ddot", 2), ("dot", 1))
MAX_WORD = 60

Kind = Literal["name", "function"]


@dataclass(frozen=True)
class Word:
    """A part of a run of letters: what it is, and with how many dots."""

    kind: Kind
    name: str
    dots: int = 0


class Vocabulary:
    """The names of a problem, and what typed words mean beside them."""

    def __init__(self, names: Iterable[str]) -> None:
        self.names = frozenset(names)
        self._bare: dict[str, set[str]] = {}
        for name in self.names:
            self._bare.setdefault(name.replace("_", ""), set()).add(name)

    def known(self, word: str) -> str | None:
        """The name that a word is, underscores aside."""
        word = _SPELT.get(word, word)
        if word in self.names:
            return word
        alike = self._bare.get(word.replace("_", ""), set())
        return next(iter(alike)) if len(alike) == 1 else None

    def words(self, run: str, column: int) -> list[Word]:
        """A run of letters, digits and underscores as names and functions; one that is none stays as it is. Raises
        ExpressionError where it can be cut in several ways."""
        atoms = _atoms(run)
        if len(atoms) > MAX_WORD:
            raise ExpressionError(Message("a name has at most {most} characters", most=MAX_WORD), column)
        whole = "".join(atoms)
        if (word := self._word(whole)) is not None:
            return [word]
        cuts = self._cuts(atoms)
        if len(cuts) > 1:
            first, second = (" ".join(word.name for word in cut) for cut in cuts[:2])
            told = Message("'{run}' is {first} or {second}: write *", run=run, first=first, second=second)
            raise ExpressionError(told, column)
        return cuts[0] if cuts else [Word("name", _SPELT.get(whole, whole).rstrip("_") or whole)]

    def _word(self, text: str) -> Word | None:
        name = self.known(text)
        if name is not None:
            return Word("name", name)
        if text in FUNCTIONS:
            return Word("function", FUNCTIONS[text])
        if text == "pi":
            return Word("name", text)
        for ending, dots in _DOTTED:
            if text.endswith(ending) and (name := self.known(text[: -len(ending)].rstrip("_"))) is not None:
                return Word("name", name, dots)
        return None

    def _cuts(self, atoms: list[str]) -> list[list[Word]]:
        """All ways to cut a run into the fewest words, two at most."""
        best: list[list[list[Word]]] = [[[]]]
        for end in range(1, len(atoms) + 1):
            found: list[list[Word]] = []
            for start in range(end):
                if not best[start] or atoms[start] == "_":
                    continue
                word = self._word("".join(atoms[start:end]))
                if word is not None:
                    found += [[*before, word] for before in best[start]]
            fewest = min(map(len, found), default=0)
            best.append([cut for cut in found if len(cut) == fewest][:2])
        return best[-1]


def _atoms(run: str) -> list[str]:
    """Letters and digits; a Greek letter is its name, and never a part of another word."""
    return [_LETTERS.get(c, _INDICES.get(c, c)) for c in run if c not in "{}"]
