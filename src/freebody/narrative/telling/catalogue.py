"""What derivations say, in one language: sentences by key, with places for names, formulas and numbers.

One file per language (`words/en.toml`), or several; a key that a language lacks is said in English. A place {name} is
filled with what a sentence names: a name of the model, a formula, a number, a reference to a line ({line}, {lines},
{given}), a word of the catalogue, or another sentence. {name:accusative} asks for a point of a body in that case, and
{name:holds} for what is said of a motion as a clause: tables of their own. Where a key with `_one` exists it is taken
for a list with one member.
Sentences that the layers below hand over ready-made are looked up among the phrases of the language (`phrases.py`).
"""

from __future__ import annotations

import re
from functools import cache
from itertools import takewhile
from typing import Any, Literal, cast

from freebody.errors import InputError
from freebody.language.expression import Call, Number, PowerOf, ProductOf, Sum, Symbol
from freebody.language.notation import Stated
from freebody.language.notation.parts import LETTER_OF
from freebody.language.raising import raised
from freebody.language.sentences import Argument, Message, Sentence
from freebody.language.units import Dimension
from freebody.messages import Shown
from freebody.model.noting import did_you_mean
from freebody.narrative.lines.script import REFERENCES
from freebody.narrative.telling.dollars import formula_of, with_rates
from freebody.narrative.telling.phrases import GENERAL, MESSAGES, POINT, TABLE, phrases_of
from freebody.narrative.words import languages, tables_of
from freebody.present.report.blocks import Emphasis, Formula, Piece, Reference, Relation, Text
from freebody.present.report.words import ENGLISH

_KEY = re.compile(r"(reaction|joint|axis|kind)\.[a-z _]+")
_PLACE = re.compile(r"\{(\w+)(?::(\w+))?\}")
_OF_MODELS = "en"  # the language of model files and of the layers below
_FIRST = {"text": "happening", "event": "happening"}  # the phrases that a place asks for before all others
SYMBOL = re.compile(rf"(?:[A-Za-z]|{'|'.join(sorted(LETTER_OF, key=len, reverse=True))})(?:_?\d+|_[A-Za-z0-9])?")
_EXPRESSIONS = (Number, Symbol, Sum, ProductOf, PowerOf, Call)


class Catalogue:
    """The sentences of a language."""

    def __init__(self, language: str = "en") -> None:
        if language not in languages():
            raise InputError(
                Message(
                    "there are no words for the language {language}.{hint}",
                    language=language,
                    hint=did_you_mean(language, languages()),
                )
            )
        self.language = language
        self._words = _read(language)
        self._english = _read(_OF_MODELS)
        self._phrases = phrases_of(language)

    def has(self, key: str) -> bool:
        return key in self._words or key in self._english

    def template(self, key: str) -> str:
        """The sentence with its places; that of `group.any` where a group has none of its own for a key. Raises
        KeyError for a key that no language has."""
        other = f"{key.rpartition('.')[0]}.any"
        for words in (self._words, self._english):
            if key in words or other in words:
                return words[key] if key in words else words[other]
        return self._english[key]

    def tell(self, sentence: Sentence) -> Text:
        """A sentence as text with formulas in it."""
        key = sentence.key
        if _is_single(sentence) and self.has(f"{key}_one"):
            key += "_one"
        pieces: list[Piece] = []
        template, end = self.template(key), 0
        for found in _PLACE.finditer(template):
            pieces += _with_formulas(template[end : found.start()])
            pieces += self._filled(found[1], sentence.args.get(found[1], ""), found[2] or POINT)
            end = found.end()
        pieces += _with_formulas(template[end:])
        kept = [one for p in pieces if p != "" for one in (with_rates(p) if isinstance(p, str) else [p])]
        is_sentence = template.endswith(".") or (template.endswith(":") and " " in template)
        if template.startswith("{") and is_sentence and kept:
            kept[0] = _with_capital(kept[0])
        return tuple(kept)

    def titled(self, sentence: Sentence) -> Text:
        """A sentence as a title has it: without its article, and with a capital."""
        pieces = self.tell(sentence)
        words = list(takewhile(lambda piece: isinstance(piece, str), pieces))
        first = re.sub(rf"^(?:{self.word('list.articles')}) ", "", "".join(map(str, words)))
        return (first[:1].upper() + first[1:], *pieces[len(words) :])

    def plain(self, sentence: Sentence) -> str:
        """A sentence as plain words, for titles and labels."""
        from freebody.present.report.formulas.line import LineFormulas

        words: list[str] = []
        for piece in self.tell(sentence):
            match piece:
                case str():
                    words.append(piece)
                case Emphasis(text, _look):
                    words.append(text)
                case Formula():
                    words.append(LineFormulas().formula(piece))
                case Reference(number, _what):
                    words.append(f"({number})")
        return "".join(words)

    def short(self, sentence: Sentence) -> str:
        """A point or direction as a label has it."""
        key = f"{sentence.key}_short"
        return self.plain(Sentence(key, sentence.args) if self.has(key) else sentence)

    def word(self, key: str) -> str:
        return self.template(key)

    @property
    def decimal(self) -> Literal[".", ","]:
        """The sign of decimals."""
        return "," if self.word("report.decimal") == "," else "."

    @property
    def report_words(self) -> dict[str, str]:
        """What the writers of reports say themselves."""
        return {name: self.word(f"report.{name.replace(' ', '_')}") for name in ENGLISH}

    def said(self, text: str, place: str = "") -> str:
        """A ready-made sentence in this language; itself where there is no phrase for it. A single word is a name."""
        if place == "title":
            return text
        text = text.words if isinstance(text, Stated) else text
        if isinstance(text, Message):
            return self._phrases.said(text, _FIRST.get(place, GENERAL)) or text
        if " " not in text:
            return text
        kinds = (_FIRST[place], GENERAL) if place in _FIRST else (GENERAL,)
        return next((said for kind in kinds if (said := self._phrases.said(text, kind)) is not None), text)

    def parts(self, text: str) -> list[str]:
        """A message said in this language, in parts: a formula in it is one that still knows what it is."""
        return [*self._phrases.parts(text, GENERAL)]

    def pieces(self, text: str, place: str = "") -> list[Piece]:
        """The same with its formulas and units as such."""
        if not isinstance(text, Message | Stated):
            return with_rates(self.said(text, place))
        found: list[Piece] = []
        for part in self._phrases.parts(text, _FIRST.get(place, GENERAL)):
            if isinstance(part, Stated) and part.sides is not None:
                left, relation, right = part.sides
                found.append(Formula((left, right), (cast("Relation", relation),)))
            elif isinstance(part, Shown) and isinstance(part.of, _EXPRESSIONS):
                found.append(Formula((part.of,)))
            elif isinstance(part, Shown) and isinstance(part.of, Dimension):
                found.append(raised(part))
            else:
                found += with_rates(str(part))
        return found

    def option(self, text: str) -> str:
        """The words of an option, which may be a single one."""
        return self._phrases.said(text, "answer") or self.said(text)

    def _filled(self, name: str, value: Argument, case: str = POINT) -> list[Piece]:
        if isinstance(value, tuple):
            return self._listed([self._filled(name, v, case) for v in value], "; " if name == "cases" else "")
        if isinstance(value, Sentence):
            return list(self.tell(value))
        if isinstance(value, _EXPRESSIONS):
            return [Formula((value,))]
        if isinstance(value, (Message, Stated)):
            return self.pieces(value, name)
        if isinstance(value, int):
            if name == "figure":
                return [Reference(value, "figure")]
            return [Reference(value)] if name in REFERENCES else [str(value)]
        if value.startswith("@"):
            return [self._worded(value[1:], name, case)]
        said = self._clause(value, case) or self.said(value, name)
        return [said if said != value else self.name(value, case)] if value else []

    def name(self, name: str, case: str = POINT) -> Piece:
        """A name of the model: a letter with an index is a symbol, a point is said of what it belongs to. case: the
        table of points from which it is taken, where the language has it."""
        if " " in name:  # words of a user's own
            return name
        if "." in name and (said := self._phrases.said(name, case) or self._phrases.said(name, POINT)) is not None:
            return said
        return Formula((Symbol(name),)) if SYMBOL.fullmatch(name) else Emphasis(name.replace("_", " "), "name")

    def _clause(self, text: str, case: str) -> str | None:
        """What is said of a motion, as the table that a place asks for has it."""
        return self._phrases.said(text, case) if case != POINT and " " in text else None

    def _worded(self, text: str, place: str, case: str = POINT) -> str:
        """A word of the catalogue; a key that it lacks says its last part; anything else is a ready-made sentence."""
        is_key = _KEY.fullmatch(text) is not None
        key = text.replace("_", " ") if is_key else text
        found = self._words.get(key) or self._english.get(key)
        if found is not None:
            return found
        return key.partition(".")[2] if is_key else self._clause(text, case) or self.said(text, place)

    def _listed(self, parts: list[list[Piece]], between: str = "") -> list[Piece]:
        """a, b and c; a; b; c"""
        pieces: list[Piece] = []
        for k, part in enumerate(parts):
            if k:
                pieces.append(between or (self.word("list.and") if k == len(parts) - 1 else ", "))
            pieces += part
        return pieces


def _with_formulas(words: str) -> list[Piece]:
    """Words of the catalogue, in which $t > 0$ is a formula."""
    found: list[Piece] = []
    for k, part in enumerate(words.split("$")):
        if k % 2:
            found.append(formula_of(part))
        elif part:
            found.append(part)
    return found


def _with_capital(piece: Piece) -> Piece:
    """What begins a sentence; a formula stays as it is, and so does the name of something."""
    return piece[:1].upper() + piece[1:] if isinstance(piece, str) else piece


def _is_single(sentence: Sentence) -> bool:
    """Whether a sentence names one thing where it could name several."""
    if sentence.args.get("n") == 1:
        return True
    lists = [v for v in sentence.args.values() if isinstance(v, tuple)]
    return bool(lists) and len(lists[0]) == 1


@cache
def _read(language: str) -> dict[str, str]:
    """All sentences of a language by dotted key."""
    found: dict[str, str] = {}
    for tables in tables_of(language):
        _flatten(tables, "", found)
    return found


def _flatten(table: dict[str, Any], prefix: str, found: dict[str, str]) -> None:
    for key, value in table.items():
        if prefix + key in (TABLE, MESSAGES):
            continue
        if isinstance(value, dict):
            _flatten(cast("dict[str, Any]", value), f"{prefix}{key}.", found)
        else:
            found[prefix + key] = str(value)
