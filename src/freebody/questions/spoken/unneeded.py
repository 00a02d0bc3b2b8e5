"""Words that say no more than others beside them do: the pivot about which alone it swings, the tension of the cable
whose work is asked for, the best angle for the greatest range."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from freebody.questions.spoken import driving, given, joining, lookup, of_axles
from freebody.questions.spoken.frames import OSCILLATION
from freebody.questions.spoken.lexicon import Word

if TYPE_CHECKING:
    from freebody.model.names import Names

_HOW_STEEP = (Word("ask", "steep"), Word("ask", "flat"))
_STOPPING = ("stopping distance", "stopping time")
_AMPLITUDES = (Word("quantity", "steady amplitude"), Word("quantity", "free amplitude"))
_HOW_LARGE = (Word("ask", "what"), Word("ask", "large"))
_COUNTED = ("work", "power", "energy")
_PUSHES = ("force", "torque", "moment", "tension", "spring force", "driving force", "driving torque")


def without_unneeded(names: Names, words: list[Word]) -> list[Word]:
    if not words:
        return words
    words = steadily(names, until_it_stops(at_best_angle(words)))
    return named_as_push(names, of_driven(names, of_slope(names, about_axle(names, on_what_is_fixed(names, words)))))


def until_it_stops(words: list[Word]) -> list[Word]:
    """The stopping distance until it stands still, which is where it ends."""
    is_asked = any(word.kind == "quantity" and word.what in _STOPPING for word in words)
    end = [Word("mark", "until"), Word("verb", "stop")]
    return words[:-2] if is_asked and words[-2:] == end else words


def steadily(names: Names, words: list[Word]) -> list[Word]:
    """The amplitude in the steady state is the steady one, and so is the greatest value there of what swings."""
    steady, greatest = Word("instant", "in steady motion"), Word("degree", "greatest")
    if steady not in words or not lookup.is_forced(names) or not lookup.springs(names):
        return words
    asked = [word for word in words if word.kind == "quantity"]
    kept = [word for word in words if word not in (steady, greatest)]
    if len(asked) == 1 and asked[0] in _AMPLITUDES:
        return kept
    if len(asked) == 1 and greatest in words and kept[0] in (asked[0], *_HOW_LARGE):
        k = kept.index(asked[0])
        return [*kept[:k], _AMPLITUDES[0], Word("preposition", "of"), *kept[k:]]
    return words


def at_best_angle(words: list[Word]) -> list[Word]:
    """The range at the best angle is the greatest range."""
    reach, greatest = Word("quantity", "horizontal range"), Word("degree", "greatest")
    best = [Word("preposition", "in"), greatest, Word("quantity", "angle")]
    k = next((k for k in range(len(words) - 2) if words[k : k + 3] == best), None)
    if k is None or reach not in words:
        return words
    return [greatest, *(word for word in (*words[:k], *words[k + 3 :]) if word != greatest)]


def of_slope(names: Names, words: list[Word]) -> list[Word]:
    """The angle of the ramp at which the crate slips: the ramp leans by no other."""
    angle, is_asked = Word("quantity", "angle"), words[0].kind == "ask"
    if is_asked and words[2:3] == [angle] and words[1].kind == "name":  # bei welcher Hangneigung
        words = [words[0], angle, words[1], *words[3:]]
    k = words.index(angle) + 1 if angle in words and is_asked else len(words)
    k = 1 if words[0] in _HOW_STEEP else k
    begin = k
    k += words[k : k + 1] == [Word("preposition", "of")]
    owner = words[k].what if k < len(words) and words[k].kind == "name" else ""
    is_alone = not any(word.kind == "name" for word in words[k + 1 :])
    return words if is_alone or not given.leaning_by(names, owner) else [*words[:begin], *words[k + 1 :]]


def about_axle(names: Names, words: list[Word]) -> list[Word]:
    """The frequency of what swings about its pivot, which it cannot leave."""
    k = next((k for k in range(len(words)) if is_pivot(names, words, k)), None)
    return words if k is None else [*words[: k - 1], *words[k + 1 :]]


def on_what_is_fixed(names: Names, words: list[Word]) -> list[Word]:
    """The frequency of what rocks on a drum that does not move."""
    k = next((k for k in range(len(words)) if _is_fixed_below(names, words, k)), None)
    return words if k is None else [*words[: k - 1], *words[k + 1 :]]


def _is_fixed_below(names: Names, words: Sequence[Word], k: int) -> bool:
    """Whether a word names a fixed body on which something else moves whose frequency is asked for."""
    said = [word for word in words[:k] if word.kind != "filler"]
    asked = [word.what for word in said if word.kind == "quantity"]
    on = (Word("preposition", "on"), Word("preposition", "in"))
    is_led = bool(said) and said[-1] in on and asked[:1] != [] and asked[0] in OSCILLATION
    is_other = any(word.kind == "name" and word.what in lookup.moving(names) for word in said)
    body = names.bodies.get(words[k].what) if words[k].kind == "name" else None
    return is_led and is_other and body is not None and body.fixed


def is_unneeded(names: Names, words: Sequence[Word], k: int) -> bool:
    return _is_fixed_below(names, words, k) or is_pivot(names, words, k) or is_driven(names, words, k)


def of_driven(names: Names, words: list[Word]) -> list[Word]:
    """The critical speed of the rotor, the speed of the rotor at which there is resonance: where what is shaken by it
    resonates."""
    k = next((k for k in range(len(words)) if is_driven(names, words, k)), None)
    if k is None:
        return words
    resonance = Word("quantity", "resonance frequency")
    return [resonance] if resonance in words[k:] else [*words[: k - 1], *words[k + 1 :]]


def is_driven(names: Names, words: Sequence[Word], k: int) -> bool:
    """Whether a word names what is driven at the frequency that is asked for."""
    said = [word for word in words[:k] if word.kind != "filler"]
    resonance = Word("quantity", "resonance frequency")
    is_led = said[-2:] == [resonance, Word("preposition", "of")]
    said = [word for word in said if word.kind not in ("ask", "preposition")]
    is_led |= said in ([Word("quantity", "angular velocity")], [Word("quantity", "velocity")]) and (
        [word for word in words[k + 1 :] if word.kind not in ("filler", "verb")] == [resonance]
    )
    is_named = is_led and k < len(words) and words[k].kind == "name"
    return is_named and any(
        one in driving.driven_bodies(names, p)
        for p in driving.drive_parameters(names)
        for one in (words[k].what, *joining.joined_by(names, words[k].what))
    )


def is_pivot(names: Names, words: Sequence[Word], k: int) -> bool:
    """Whether a word names the axle about which something swings whose frequency is asked for."""
    said = [word for word in words[:k] if word.kind != "filler"]
    asked = [word.what for word in said if word.kind == "quantity"]
    is_led = said[-1:] == [Word("preposition", "about")] and asked[:1] != [] and asked[0] in OSCILLATION
    axles = of_axles.axles(names) if is_led and k < len(words) and words[k].kind == "name" else []
    return any(words[k].what in (axle, *joining.ends_of(names, axle)) for axle in axles)


def named_as_push(names: Names, words: list[Word]) -> list[Word]:
    """The work of the cable tension, the power of the gas force, the work of F: of the load itself, whose kind, or
    size, needs no word."""
    counted = any(w.kind == "quantity" and w.what in _COUNTED for w in words)
    pull, pulling = Word("quantity", "tension"), joining.strings_that_pull(names)
    if (
        counted
        and pull in words
        and len(pulling) == 1
        and not any(w.kind == "name" for w in words[: words.index(pull)])
    ):
        words = [Word("name", pulling[0]) if word == pull else word for word in words]
    if counted:
        words = [Word("name", given.load_of(names, word.what)) if _is_size(names, word) else word for word in words]
    return [
        word
        for k, word in enumerate(words)
        if not (
            counted
            and k > 1
            and word.kind == "quantity"
            and word.what in _PUSHES
            and words[k - 1].kind == "name"
            and words[k - 1].what in names.loads
        )
    ]


def _is_size(names: Names, word: Word) -> bool:
    """Whether a word names a parameter that is how strongly one load pushes: the work of F."""
    is_parameter = word.kind == "name" and word.what in names.parameters
    return is_parameter and word.what not in names.loads and bool(given.load_of(names, word.what))
