"""From the text of a unit to the unit.

    unit   = part {("*" | " ") part | "/" part}       m/s^2, kg m^2, N/m
    part   = (name | "1" | "(" unit ")") ["^" power]         kg/(m s)^(1/2)
    power  = number | "(" number ["/" integer] ")"

A name is looked up in the table, then with an SI prefix, and only then asked of pint.
"""

from __future__ import annotations

import re
from dataclasses import replace
from fractions import Fraction

from freebody.errors import UnitError
from freebody.language.sentences import Message
from freebody.language.units.dimension import DIMENSIONLESS
from freebody.language.units.table import PREFIXED, PREFIXES, UNITS, Unit

MAX_EXPONENT = 12
MAX_CHARACTERS = 200

_TOKEN = re.compile(
    r"\s*(?:(?P<name>[A-Za-zµμΩ°][A-Za-z_µμ]*)|(?P<operator>\*\*|[-*/^()·⋅−+])|(?P<digits>[0-9]+(?:\.[0-9]+)?)"
    r"|(?P<superscript>⁻?[⁰¹²³⁴⁵⁶⁷⁸⁹]))"
)
# To pint a Nm is a "number metre".
_RUN_TOGETHER = re.compile(r"([kMm]?N|kg|lbf)(mm|cm|m|ft|in|s)(s)?|(ft|in)(lbf?)")
_SUPERSCRIPTS = str.maketrans("⁻⁰¹²³⁴⁵⁶⁷⁸⁹", "-0123456789")


def parse_unit(text: str, *, with_rare: bool = True) -> Unit:
    """The unit a text stands for; the empty text is the dimensionless 1. with_rare: pint is asked for what is not in
    the table. Raises UnitError."""
    if len(text) > MAX_CHARACTERS:
        raise UnitError(
            Message("the unit has {n} characters, at most {most} are read", n=len(text), most=MAX_CHARACTERS)
        )
    return _UnitReader(text, with_rare).unit() if text.strip() else Unit(DIMENSIONLESS)


def is_unit(name: str) -> bool:
    """Whether a name is that of one unit, such as m or kN."""
    try:
        _named_unit(name)
    except UnitError:
        return False
    return True


_DEGREES = ("Grad", "GRAD")  # as Germans write degrees
_TURNS = ("U", "Umdr", "Umdrehung", "Umdrehungen")  # as they write revolutions: U/min


class _UnitReader:
    def __init__(self, text: str, with_rare: bool) -> None:
        self._text = text.strip()
        self._with_rare = with_rare
        self._tokens: list[str] = []
        place = 0
        while place < len(self._text):
            found = _TOKEN.match(self._text, place)
            if found is None:
                if self._text[place] == ",":
                    raise self._fault(Message("decimals stand after a point, as in 0.5"))
                raise self._fault(Message("'{x}' cannot be used in a unit", x=self._text[place]))
            words = self._words(found)
            if words[0].isdigit() and self._is_run_on(place, words[0]):
                words = ["^", *words]  # m/s2
            self._tokens += words
            place = found.end()
        self._at = 0

    def _words(self, found: re.Match[str]) -> list[str]:
        if superscript := found["superscript"]:
            return ["^", *re.findall("-|[0-9]", superscript.translate(_SUPERSCRIPTS))]
        word = found.group().strip()
        parts = _RUN_TOGETHER.fullmatch(word)
        if parts and parts[1] and (parts[2] != "s" or parts[3]):  # kgm^2 is kg m^2; Ns may be newtons, a pound a force
            return [part for part in parts.groups() if part]
        return [{"**": "^", "·": "*", "⋅": "*", "−": "-"}.get(word, word)]

    def _is_run_on(self, place: int, digit: str) -> bool:
        """Whether a digit stands at a name without a space, in a unit of several: `m2` alone may be a name."""
        follows = bool(self._tokens) and self._tokens[-1].isalpha() and self._text[place : place + 1] == digit
        return follows and digit in "23456" and sum(token.isalpha() for token in self._tokens) > 1

    @property
    def _now(self) -> str:
        return self._tokens[self._at] if self._at < len(self._tokens) else ""

    def _take(self) -> str:
        word = self._now
        self._at += 1
        return word

    def _fault(self, reason: Message) -> UnitError:
        return UnitError(Message("the unit '{text}' cannot be read: {reason}", text=self._text, reason=reason))

    def unit(self) -> Unit:
        result = self._product()
        if self._now:
            raise self._fault(Message("'{x}' is not expected here", x=self._now))
        return result

    def _product(self, nesting: int = 0) -> Unit:
        if nesting > 10:
            raise self._fault(Message("too many brackets"))
        result = self._part(nesting) if self._now != "/" else Unit(DIMENSIONLESS)
        is_below = False
        while self._now and self._now != ")":
            if self._now in ("*", "/"):
                is_below = self._take() == "/"
            elif is_below:
                raise self._fault(Message("a/b c can be read in two ways, write a/(b c) or a c/b"))
            part = self._part(nesting)
            result = result * (part**-1 if is_below else part)
        return result

    def _part(self, nesting: int) -> Unit:
        word = self._take()
        if word == "(":
            part = self._product(nesting + 1)
            if self._take() != ")":
                raise self._fault(Message("a bracket is never closed"))
        elif word == "1":
            part = Unit(DIMENSIONLESS)
        elif word and (word[0].isalpha() or word == "°"):
            part = self._named(word)
        else:
            before = Message("a unit is needed before '{word}'", word=word)
            raise self._fault(before if word else Message("a unit is needed at its end"))
        return part ** self._exponent() if self._now == "^" else part

    def _named(self, name: str) -> Unit:
        if self._now.isdigit() and len(self._now) == 1:
            raise self._fault(Message("write {name}^{exponent} for a power", name=name, exponent=self._now))
        return _named_unit(name, with_rare=self._with_rare)

    def _exponent(self) -> Fraction:
        """A power: a number, in brackets a fraction as well."""
        self._take()
        is_bracketed = self._now == "(" and bool(self._take())
        sign = -1 if self._now == "-" and self._take() else 1
        power = sign * self._number()
        if is_bracketed and self._now == "/":
            self._take()
            below = self._number()
            if not below:
                raise self._fault(Message("a power is divided by zero"))
            power /= below
        if is_bracketed and self._take() != ")":
            raise self._fault(Message("a bracket is never closed"))
        return power

    def _number(self) -> Fraction:
        digits = self._take()
        if not digits.replace(".", "", 1).isdigit() or len(digits) > 4 or Fraction(digits) > MAX_EXPONENT:
            raise self._fault(
                Message("a power is a number up to {most}, or a fraction in brackets: m^(1/2)", most=MAX_EXPONENT)
            )
        return Fraction(digits)


def _named_unit(name: str, *, with_rare: bool = True) -> Unit:
    if unit := UNITS.get(name):
        return unit
    if name in _DEGREES:  # with a prefix it would be a thousand million radians
        raise UnitError(
            Message(
                "the unit '{name}' is not known: write deg for degrees; grad is the 400th part of a turn", name=name
            )
        )
    if name in _TURNS:  # U alone is a unit of enzymes
        raise UnitError(
            Message(
                "the unit '{name}' is not known: write rev for revolutions, or rpm for those in a minute", name=name
            )
        )
    for n_letters in (1, 2):
        prefix, rest = PREFIXES.get(name[:n_letters]), PREFIXED.get(name[n_letters:])
        if prefix is not None and rest is not None:
            return replace(rest, factor=rest.factor * Fraction(10) ** prefix)
    if parts := _RUN_TOGETHER.fullmatch(name):
        if parts[1]:
            raise UnitError(
                Message(
                    "the unit '{name}' is not known: write {unit}, or {unit} s for {unit} times seconds",
                    name=name,
                    unit=parts[1],
                )
            )
        raise UnitError(
            Message("the unit '{name}' is not known: write {names}", name=name, names=f"{parts[4]} {parts[5]}")
        )
    if not with_rare:
        raise UnitError(Message("the unit '{name}' is not known", name=name))
    from freebody.language.units.rare import unit_of_pint

    return unit_of_pint(name)
