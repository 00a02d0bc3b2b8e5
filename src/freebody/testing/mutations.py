"""Mutated model files: what a tired hand, a wrong copy or a hostile hand makes of a model.

A mutated file must be read, or refused with a message that says where and why; nothing else. Every mutation is a small
function from text to text; the table `MUTATIONS` has them by name.
"""

from __future__ import annotations

import random
import re
from collections.abc import Callable

from freebody.api import System
from freebody.errors import FreebodyError
from freebody.testing.outcomes import End, Outcome, OutOfWork, limited, untyped

Mutation = Callable[[str, random.Random], str]
MUTATIONS: dict[str, Mutation] = {}

_NUMBER = re.compile(r"(?<![\w.])\d+(?:\.\d+)?(?![\w.])")
_UNIT = re.compile(r"(?<=\d )(?:kg m\^2|kg|m/s\^2|m/s|N m s|N m|N s/m|N/m|N|m|rad/s|rad|deg|s)(?![\w^/])")
_NAME = re.compile(r"(?<![\w.])[A-Za-z_]\w*")
_EXTREME = (
    *("0", "-1", "1e-300", "1e300", "1e400", "-1e400", "1e99999", "1e999999999", ".nan", ".inf", "-.inf", "nan", "inf"),
    *("0x10", "1_000", "010", "1:30", "~", "null", "true", "1e-400", "9007199254740993", "1234567890" * 4),
)
_UNITS = ("kg", "m", "s", "N", "deg", "m^-1", "furlong", "kg^0.5", "m m m m", "1/0", "m^99999", "", "°", "%", "µm")
_TYPES = ("[]", "{}", "[1, 2, 3, 4]", "{a: b}", "true", "null", "''", "'  '", "[[[[1]]]]", "2026-11-22", "!!str 1")
_TRICKS = (
    "&a [*a, *a]",
    "*missing",
    "!!python/object/apply:os.system ['true']",
    "!!binary SGVsbG8=",
    "? complex",
    "<<: {mass: 1 kg}",
    "'unclosed",
    '"\\u0000"',
    "\t tab",
    "@at",
    "`tick`",
    "%percent",
    "|\n    block",
    "--- {}",
    "${HOME}",
    "__import__('os')",
    "((((((((((1))))))))))",
    "2**2**2**2**9",
    "9**9**9",
    "sin(" * 40 + "1" + ")" * 40,
    "1/0",
    "0/0",
    "sqrt(-1)",
    "log(0)",
    "a" * 3000,
)


def _mutation(name: str) -> Callable[[Mutation], Mutation]:
    def register(change: Mutation) -> Mutation:
        MUTATIONS[name] = change
        return change

    return register


def _replaced(text: str, pattern: re.Pattern[str], rng: random.Random, make: Callable[[str], str]) -> str:
    """One match of the pattern replaced."""
    found = list(pattern.finditer(text))
    if not found:
        return text
    one = rng.choice(found)
    return text[: one.start()] + make(one[0]) + text[one.end() :]


@_mutation("typo")
def _typo(text: str, rng: random.Random) -> str:
    """A letter too many, too few, or two in the wrong order."""

    def make(word: str) -> str:
        k = rng.randrange(len(word))
        return rng.choice((word[:k] + word[k + 1 :], word[:k] + word[k] * 2 + word[k + 1 :], word[::-1], word.upper()))

    return _replaced(text, _NAME, rng, make)


@_mutation("line deleted")
def _deleted(text: str, rng: random.Random) -> str:
    lines = text.splitlines(keepends=True)
    del lines[rng.randrange(len(lines))]
    return "".join(lines)


@_mutation("line doubled")
def _doubled(text: str, rng: random.Random) -> str:
    lines = text.splitlines(keepends=True)
    k = rng.randrange(len(lines))
    return "".join([*lines[: k + 1], lines[k], *lines[k + 1 :]])


@_mutation("lines swapped")
def _swapped_lines(text: str, rng: random.Random) -> str:
    lines = text.splitlines(keepends=True)
    j, k = rng.randrange(len(lines)), rng.randrange(len(lines))
    lines[j], lines[k] = lines[k], lines[j]
    return "".join(lines)


@_mutation("indented otherwise")
def _indented(text: str, rng: random.Random) -> str:
    lines = text.splitlines(keepends=True)
    k = rng.randrange(len(lines))
    lines[k] = " " * rng.randrange(5) + lines[k].lstrip()
    return "".join(lines)


@_mutation("names swapped")
def _swapped_names(text: str, rng: random.Random) -> str:
    words = sorted(set(_NAME.findall(text)))
    return _replaced(text, _NAME, rng, lambda _word: rng.choice(words))


@_mutation("extreme number")
def _extreme(text: str, rng: random.Random) -> str:
    return _replaced(text, _NUMBER, rng, lambda _n: rng.choice(_EXTREME))


@_mutation("wrong unit")
def _wrong_unit(text: str, rng: random.Random) -> str:
    return _replaced(text, _UNIT, rng, lambda _u: rng.choice(_UNITS))


@_mutation("wrong type")
def _wrong_type(text: str, rng: random.Random) -> str:
    return _replaced(text, re.compile(r"(?<=: )[^\s{}\[\],][^{}\[\],\n]*"), rng, lambda _v: rng.choice(_TYPES))


@_mutation("trick")
def _trick(text: str, rng: random.Random) -> str:
    return _replaced(text, re.compile(r"(?<=: )[^\s{}\[\],][^{}\[\],\n]*"), rng, lambda _v: rng.choice(_TRICKS))


@_mutation("cut short")
def _cut(text: str, rng: random.Random) -> str:
    return text[: rng.randrange(len(text))]


@_mutation("odd character")
def _odd(text: str, rng: random.Random) -> str:
    k = rng.randrange(len(text))
    return text[:k] + rng.choice("\0\x1b\u202e\ufeff\t\r{}[]:,&*!|>'\"%@`#\u2028\ud800é∂") + text[k:]


def mutated(text: str, rng: random.Random, times: int = 1) -> str:
    """A model text with random mutations, one after the other."""
    for _ in range(times):
        if text:
            text = MUTATIONS[rng.choice(sorted(MUTATIONS))](text, rng)
    return text


def read(text: str, seconds: float | None = None) -> Outcome:
    """How a text is read: into a model, or refused in words."""
    try:
        with limited(seconds):
            System.from_text(text)
    except FreebodyError as error:
        return Outcome("read", End.REFUSED, str(error))
    except OutOfWork:
        return Outcome("read", End.TOO_LONG, f"no end after {seconds:g} s of processor time")
    except Exception as error:
        return untyped("read", error)
    return Outcome("read", End.ANSWERED)
