"""Where something is meant, said within a main clause: at x = 2 m, at the height h, at a crank angle of 60 deg."""

from __future__ import annotations

from typing import TYPE_CHECKING

from freebody.questions.spoken import dimensions
from freebody.questions.spoken.events import conditions
from freebody.questions.spoken.lexicon import Word
from freebody.questions.spoken.words import Clause

if TYPE_CHECKING:
    from freebody.model.names import Names


def equation_at_end(main: Clause) -> tuple[Clause, str] | None:
    """A measure and its value, as in `at x = 2 m`, and the clause without them."""
    words = main.words
    k = next(k for k, word in enumerate(words) if word.kind == "relation")
    before, after = words[max(k - 2, 0) : k], words[k + 1 : k + 2]
    if before and before[0].kind == "quantity" and k > 2:  # at the height z = 2 m
        before = [words[k - 3], words[k - 1]]
        words = [*words[: k - 2], *words[k - 1 :]]
        k -= 1
    is_placed = [word.kind for word in before] == ["preposition", "name"] and before[0].what in (
        "in",
        "of",
        "with",
        "on",
        "to",
    )
    if words[k].what != "=" or not after or after[0].kind not in ("value", "name") or not is_placed:
        return None
    return Clause([*words[: k - 2], *words[k + 2 :]]).without(
        "verb", "return", "reach"
    ), f"{before[1].what} = {after[0].what}"


def place_by_parameter(names: Names, main: Clause) -> tuple[Clause, Clause] | None:
    """The end of a main clause that says where by a parameter: at the height h."""
    words = main.words
    kinds = [word.kind for word in words[-3:]]
    last = names.parameters.get(words[-1].what) if words and words[-1].kind == "name" else None
    if last is not None and last.is_angle and words[-2:-1] == [Word("preposition", "in")] and len(words) > 2:
        return Clause(words[:-2]), Clause([Word("quantity", "angle"), words[-1]])  # at beta_1
    is_place = kinds == ["preposition", "quantity", "name"] and words[-1].what in names.parameters
    if not is_place or words[-3].what != "in" or words[-2].what not in ("height", "distance", "angle", "displacement"):
        return None
    return Clause(words[:-3]), Clause(words[-2:])


def place_within(main: Clause, value: str) -> tuple[Clause, Clause] | None:
    """The part of a main clause that says where: at a crank angle of 60 deg, at 30 deg."""
    words = main.words
    at = words.index(Word("value", value))
    begin = next((k for k in range(at, -1, -1) if words[k] == Word("preposition", "in")), None)
    if begin is None or begin == 0:
        return None
    inner = [*words[begin + 1 :]]
    if not any(word.kind == "quantity" for word in inner):
        inner = [Word("quantity", "angle"), *inner] if dimensions.is_angle(value) else inner
        is_speed = dimensions.is_speed(value) or dimensions.is_turning_speed(value)
        is_alone = not any(word.kind == "name" for word in inner)
        inner = [Word("quantity", "speed"), *inner] if is_speed and is_alone else inner
    return Clause(words[:begin]), Clause(inner)


def where_it_is(names: Names, main: Clause) -> tuple[Clause, list[list[str]]] | None:
    """At what angle is the speed 4 m/s? The angle, when that is so."""
    places = [
        k
        for k, word in enumerate(main.words)
        if word.kind == "quantity" and word.what in ("angle", "position", "height")
    ]
    if len(main.all("quantity")) != 2 or not places or not (main.has("value") or main.has("verb", "vanish")):
        return None
    k = places[0]
    named = k + 1 < len(main.words) and main.words[k + 1].kind == "name" and main.words[k + 1].what in names.measures
    head = [main.words[k], *main.words[k + 1 : k + 1 + named]]
    found = list(conditions(names, Clause([w for w in main.words[k + 1 + named :] if w.kind != "ask"])))
    return (Clause(head), found) if found else None


def two_compared(main: Clause) -> tuple[Clause, Clause] | None:
    """A quantity, and the equation of two others at which it is meant: at which y is one energy twice the other."""
    words = main.words
    sign = next((k for k, word in enumerate(words) if word == Word("relation", "=")), -1)
    said = [k for k, word in enumerate(words) if word.kind == "quantity"]
    before = [k for k in said if k < sign]
    if len(before) != 2 or len(said) != 3:
        return None
    return Clause([*words[: before[1]]]), Clause([*words[before[1] :]])
