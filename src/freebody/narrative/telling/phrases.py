"""Sentences that the layers below hand over ready-made, in another language.

A `Message` knows the template that it was made of; a language has what is said for it in a table of its files. A place
may ask for a form that stands there, {event:happens}, which has a table of its own:

    [message]
    "just before {event}" = "unmittelbar bevor {event:happens}"

    [message.happens]
    "{contact} opens" = "sich {contact} öffnet"

What people write themselves, measures, questions and options, is recognised by its pattern, in a table of phrases:

    [phrase]
    "travel of {p:name} along {d:along}" = "Weg von {p} {d}"

    [phrase.along]
    "up" = "nach oben"

A place {p} stands for a formula or a name, which nothing alters; {p:most} for one that reaches as far as it can, and
{p:name} for one word. {p:words} is a sentence that is looked up in turn, {p:list} several of them; any other word
behind the colon is a table of its own, of which the place takes nothing else. The phrase with the most letters of its
own is tried first. What no phrase fits stays as it is.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cache, cached_property
from itertools import zip_longest
from string import Formatter
from typing import Any, cast

from freebody.language.expression import Symbol
from freebody.language.notation import Stated
from freebody.language.parser import GREEK
from freebody.language.sentences import Message
from freebody.messages import Shown
from freebody.narrative.words import tables_of

GENERAL = ""
TABLE = "phrase"  # of a file of words
MESSAGES = "message"
REACTION = "reaction"  # a table that names what a row transmits
KIND = "kind"  # a table of kinds of connections, by their names
ROW = "row"  # a table of rows of connections, where they stand as a name
POINT = "place"  # a table of points of bodies
_CASES = ("nominative", "accusative", "at")  # tables of the same with their article, for where they are told in parts
PLACE = re.compile(r"\{(\w+)(?::(\w+))?\}")
_ANYTHING = r".+?"
# what places of these kinds take; a connection is a name without the points in it
_OWN = {"name": r"[^\s,;:()=]+", "connection": r"\w+", "most": r".+"}
_GREEK = "|".join(sorted(GREEK.values(), key=len, reverse=True))
_SYMBOL = re.compile(rf"(?:{_GREEK})(?:_?\d+|_\w+)?|[A-Za-z](?:\d+|_\w+)")
_POINT = re.compile(r"[A-Za-z_]\w*\.\w+")
_BETWEEN = re.compile(r"(, then |, | and | or )")
_CALCULATED = re.compile(r"(?P<before>(?:[\w.]+ ?(?:[*/]|[-+] ) ?)*)[(|]")
_CALCULATED_ON = re.compile(r"(?P<sign>(?:\^\d+)? ?[-+*/] ?)(?P<rest>.+)|(?P<power>(?:\^\d+)?)")


@dataclass(frozen=True)
class _Place:
    """What was put into a place of a message, as format() asks for it."""

    phrases: Phrases
    value: object

    def __format__(self, form: str) -> str:
        return self.phrases.put(self.value, form)


@dataclass(frozen=True)
class TextPattern:
    """A pattern, and what is said for it."""

    english: str
    text: str
    kind: str = GENERAL

    @property
    def n_own(self) -> int:
        """Letters outside of places."""
        return len(PLACE.sub("", self.english))

    @cached_property
    def longest(self) -> str:
        """The longest part between places, which every text that fits contains."""
        return max(PLACE.sub("\n", self.english).split("\n"), key=len)


class Phrases:
    """The phrases of a language, in the order in which they are tried."""

    def __init__(
        self,
        phrases: tuple[TextPattern, ...],
        messages: Mapping[str, Mapping[str, str]],
        decimal: str = ".",
        contracted: Mapping[str, str] | None = None,
    ) -> None:
        self.messages = messages
        self._contracted = [(re.compile(rf"\b{p}"), own) for p, own in (contracted or {}).items()]
        self.decimal = decimal
        ordered = sorted(phrases, key=lambda p: -p.n_own)
        self.kinds: dict[str, list[TextPattern]] = {}
        for p in ordered:
            self.kinds.setdefault(p.kind, []).append(p)
        self._compiled = {kind: [(self._pattern(p), p) for p in own] for kind, own in self.kinds.items()}
        self._known: dict[tuple[str, str], str | None] = {}

    def said(self, text: str, kind: str = GENERAL) -> str | None:
        """A sentence in this language; None where no phrase fits, or none changes anything."""
        text = text.words if isinstance(text, Stated) else text
        if isinstance(text, Message):
            return self._told(text, kind)
        key = (text, kind)
        if key not in self._known:
            found = self._find(text, kind)
            self._known[key] = found.replace("_", " ") if found and kind in (POINT, *_CASES) else found
        return self._known[key]

    def _told(self, message: Message, kind: str) -> str | None:
        """A message by its template; in its own words around what is said in its places where there is none."""
        own = self._template(message, kind)
        places = {name: _Place(self, value) for name, value in message.arguments.items()}
        said = own.format_map(places)
        return None if said == message else said

    def parts(self, text: str, kind: str = GENERAL) -> list[str]:
        """A message in this language, in parts: words, and whole what is shown otherwise than in words (`Shown`,
        `Stated` with sides)."""
        if isinstance(text, Stated) and text.sides is None:
            return self.parts(text.words, kind)
        if isinstance(text, Stated | Shown):
            return [text]
        if not isinstance(text, Message) and _SYMBOL.fullmatch(text):
            return [Shown(text, Symbol(text))]
        if not isinstance(text, Message):
            point = self.said(text, POINT) if _POINT.fullmatch(text) else None
            return [self.said(text, kind) or point or self._rows(text, measures=kind == GENERAL)]
        own = self._template(text, kind)
        found: list[str] = []
        for literal, name, form, _conversion in Formatter().parse(own):
            found += [literal] if literal else []
            if name is not None:
                value = text.arguments[name]
                is_text = isinstance(value, str)
                inside = GENERAL if form == "words" else form or GENERAL
                found += self.parts(value, inside) if is_text else [_Place(self, value).__format__(form or "")]
        return found

    def _template(self, message: Message, kind: str) -> str:
        general = self.messages.get(GENERAL, {}).get(message.template, message.template)
        return self.messages.get(kind, {}).get(message.template, general)

    def put(self, value: object, form: str) -> str:
        """What stands in a place of a message."""
        value = value.words if isinstance(value, Stated) else value
        if isinstance(value, Message):
            return self._told(value, form) or value
        return self._inside(value, form) if isinstance(value, str) else format(value, form).replace(".", self.decimal)

    def _find(self, text: str, kind: str) -> str | None:
        if kind == GENERAL and (several := self._listed(text, strict=True) or self._computed(text)) is not None:
            return several
        for pattern, phrase in self._compiled.get(kind, ()):
            found = pattern.fullmatch(text) if phrase.longest in text else None
            if found:
                kinds = dict(PLACE.findall(phrase.english))
                inside = {name: self._inside(part, kinds[name]) for name, part in found.groupdict().items()}
                if (said := phrase.text.format_map(inside)) != text:
                    return self.with_articles(said) if kind == GENERAL else said
        return None

    def with_articles(self, said: str) -> str:
        """A preposition before what a language says with an article: vom Anfang, zur Ecke."""
        for pattern, own in self._contracted:
            said = pattern.sub(own, said)
        return said

    def _computed(self, text: str) -> str | None:
        """A calculation with quantities in brackets, each looked up: (work of motor until ...) / (2*pi)."""
        begin = _CALCULATED.match(text)
        if begin is None:
            return None
        opened = begin.end() - 1
        shut = _end_of_bracket(text, opened)
        after = None if shut is None else _CALCULATED_ON.fullmatch(text, shut + 1)
        if shut is None or after is None:
            return None
        inside, rest = text[opened + 1 : shut], after["rest"] or ""
        said = f"{begin['before']}{text[opened]}{self.said(inside) or inside}{text[shut]}"
        return f"{said}{after['sign'] or after['power']}{self.said(rest) or rest}"

    def _inside(self, inside: str, kind: str) -> str:
        """What is said in a place."""
        match kind:
            case "most" | "connection":
                return inside
            case "" | "name":
                return self._rows(inside, measures=True)
            case _ if kind in _CASES:  # a point is said where it is told in parts, else it stays as it is written
                return inside
            case "words":
                return self.said(inside) or inside
            case "list":
                return self.said(inside) or self._listed(inside) or inside
            case _:
                return self.said(inside, kind) or inside

    def _rows(self, text: str, *, measures: bool) -> str:
        """Names, among them those of rows and of measures: wall.slip of ladder.end on wall, x of ball."""
        each = text.split(", ")
        return ", ".join(self.said(one, ROW) or (measures and " " in one and self.said(one)) or one for one in each)

    def _listed(self, text: str, *, strict: bool = False) -> str | None:
        """a, b and c, each looked up; strict: None unless all of them are found."""
        parts = _BETWEEN.split(text)
        if strict and len(parts) == 1:
            return None
        members = [self.said(p) or (None if strict else self.said(p, "word") or p) for p in parts[::2]]
        if None in members:
            return None
        between = [self.said(p, "joined") or p for p in parts[1::2]]
        return "".join(str(x) for pair in zip_longest(members, between, fillvalue="") for x in pair)

    # -- patterns -----------------------------------------------------------------------------
    def _pattern(self, phrase: TextPattern) -> re.Pattern[str]:
        return re.compile(self._written(phrase.english, inside=False), re.DOTALL)

    def _written(self, english: str, *, inside: bool) -> str:
        """A pattern as a regular expression; inside of another one without groups, and open where it has sentences."""
        parts: list[str] = []
        end = 0
        for place in PLACE.finditer(english):
            parts.append(re.escape(english[end : place.start()]))
            kind = place[2] or ""
            if inside:
                parts.append(self._fits(kind if kind in _OWN else ""))
            else:
                parts.append(f"(?P<{place[1]}>{self._fits(kind)})")
            end = place.end()
        return "".join(parts) + re.escape(english[end:])

    def _fits(self, kind: str) -> str:
        """What a place takes."""
        if kind in _OWN:
            return _OWN[kind]
        own = self.kinds.get(kind, ()) if kind else ()
        return "|".join(self._written(p.english, inside=True) for p in own) or _ANYTHING


def _end_of_bracket(text: str, opened: int) -> int | None:
    """Where the bracket ends that begins at a place."""
    if text[opened] == "|":
        found = text.find("|", opened + 1)
        return None if found < 0 else found
    depth = 0
    for k in range(opened, len(text)):
        depth += (text[k] == "(") - (text[k] == ")")
        if depth == 0:
            return k
    return None


@cache
def phrases_of(language: str) -> Phrases:
    """The phrases of a language, from all of its files; none for the language in which they are handed over."""
    found: list[TextPattern] = []
    messages: dict[str, dict[str, str]] = {}
    decimal, contracted = ".", dict[str, str]()
    for tables in tables_of(language):
        contracted |= tables.get("contracted", {})
        found += _flat(tables.get(TABLE, {}), GENERAL)
        decimal = tables.get("report", {}).get("decimal", decimal)
        found += [TextPattern(key, text, REACTION) for key, text in tables.get(REACTION, {}).items()]
        found += [TextPattern(key.replace(" ", "_"), text, KIND) for key, text in tables.get(KIND, {}).items()]
        for p in _flat(tables.get(MESSAGES, {}), GENERAL):
            messages.setdefault(p.kind, {})[p.english] = p.text
    return Phrases(tuple(found), messages, decimal, contracted)


def _flat(table: Mapping[str, Any], kind: str) -> Iterator[TextPattern]:
    for english, text in table.items():
        if isinstance(text, dict):
            yield from _flat(cast("dict[str, Any]", text), english)
        else:
            yield TextPattern(english, str(text), kind)
