"""What a text asks for, in the words of the grammar: the way to mean it that is nearest to its words."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Sequence
from itertools import islice
from typing import TYPE_CHECKING

from freebody.errors import Problem
from freebody.language.expression import FLOAT_FUNCTIONS
from freebody.language.sentences import Message
from freebody.questions.spoken import joining
from freebody.questions.spoken.accounting import loses_quantity
from freebody.questions.spoken.asked_otherwise import Asking, otherwise
from freebody.questions.spoken.assumed import takes_cut_for_whole, takes_held_for_stopped, what_does_not_hold
from freebody.questions.spoken.braking import limits_of_braking
from freebody.questions.spoken.composing import JOINT
from freebody.questions.spoken.elements import Elements
from freebody.questions.spoken.in_the_impact import slip_in_impact
from freebody.questions.spoken.keeping import (
    chooses_of_what_is_asked,
    is_kept,
    is_of_itself,
    is_one_without_other,
    loses_failure,
    loses_height,
    loses_joint,
    loses_mass_center,
    loses_other,
    loses_sign,
    may_change,
)
from freebody.questions.spoken.kinds import is_of_kind
from freebody.questions.spoken.leaving_out import holds_without_which
from freebody.questions.spoken.lexicon import Word, languages, several, vocabulary
from freebody.questions.spoken.naming import elements_of
from freebody.questions.spoken.other_values import other_value, same_value
from freebody.questions.spoken.relating import loses_share, related
from freebody.questions.spoken.restating import recast
from freebody.questions.spoken.several import (
    asks_again,
    completed,
    each_of,
    multiple_of,
    named_instead,
    of_owner,
    of_rivals,
    parts,
    sides_of,
)
from freebody.questions.spoken.sought import sought
from freebody.questions.spoken.suggesting import MOST, absent, not_understood, suggestions
from freebody.questions.spoken.symbols import parameter_asked
from freebody.questions.spoken.unread import (
    Asked,
    AskedT,
    Unread,
    condition_in_words,
    each_value,
    is_misspelt,
    is_of_an_instant,
    is_of_kinds,
    is_of_words,
    is_specific,
    leave_open,
    read_quietly,
    unknown_parameters,
)
from freebody.questions.spoken.ways import (
    concepts,
    is_strange,
    spelt_as_known,
    ways_to_mean,
    what_is_near,
)
from freebody.questions.whether import stated_of

if TYPE_CHECKING:
    from freebody.language.units import Dimension
    from freebody.model.names import Names

# along a direction at an instant, in the order of the grammar
_TIMED_ALONG = re.compile(
    r"^(?P<of>.+?) (?P<at>(?:just )?(?:after|before) the impact|in the impact|at (?:the )?start) "
    r"(?P<along>along (?:the )?[\w.-]+)[?]?$"
)
_WHAT_IS = re.compile(
    r"^(?:what(?:[’' ]s| is| are)|find|determine|calculate|compute|give|tell) (?:me )?(?:the )?", re.IGNORECASE
)
_UNKNOWN = re.compile(r"\s*=\s*[?]+[\s.!]*$")  # v_B = ?
_SYMBOL = re.compile(r"(?<=[^\W\d]),? (?P<symbol>[^\W\d]_(?:[a-z]{1,3}|[RNHZ]))[ ?.!]*$")
_OF_EVENTS = re.compile(r" (?:when|until|between) ")
_VALUE = re.compile(r"\d[\d.]*(?: [\w/^*° ]+)?")
_AT_ONE = re.compile(r".+?(?P<when> (?:at start|when .+))\n.+(?P=when)")
_CALL = re.compile(rf"\b(?:{'|'.join(FLOAT_FUNCTIONS)})(?=\()")
ONE_BY_ONE = 8  # things of which one phrase may ask for each
LONGEST = 300  # characters of a question: what is longer is none
_OF_EVERY_TURN = ("repeated motion", "small motion", "structure")
_TIMELESS = ("whole motion", "repeated motion", "small motion", "every motion", "structure", "linkage")


def understood(
    names: Names, text: str, read: Callable[[str], AskedT | None], *, as_put: bool = False
) -> list[tuple[AskedT, str]]:
    """What a text asks for, and the words of the grammar in which it does; several where it asks for several things.

    read: what words of the grammar ask for, None after noting a problem. What it does not read is taken as people
    speak; what can be meant in several ways is refused with all of them. as_put: not in plainer constructions."""
    n_before = len(names.problems)
    if names.is_undeclared_in(text):
        return []
    found = read(text)
    if found is not None and len(names.problems) == n_before:
        return [(found, text)]
    if found is None and (plain := _asked_plainly(names, text, read)):
        del names.problems[n_before:]
        return plain
    if names.is_broken_in(text):  # told where that stands, and nowhere else
        del names.problems[n_before:]
        return []
    if len(text) > LONGEST:
        return []
    if (put := _UNKNOWN.sub("", text)) != text:
        del names.problems[n_before:]
        return understood(names, put, read)
    if (put := _TIMED_ALONG.sub(r"\g<of> \g<along> \g<at>", text)) != text:
        del names.problems[n_before:]
        return understood(names, put, read)
    if JOINT in text and not isinstance(each := read_quietly(names, text, read), Unread):
        del names.problems[n_before:]
        return [*zip(each, text.split(JOINT), strict=True)]
    told = names.problems[n_before:]
    del names.problems[n_before:]
    asking = Asking(
        names,
        text,
        read,
        lambda other: understood(names, other, read),
        lambda other: _quietly_one(names, other, read),
    )
    if asks_again(text) and (parted := _several(names, text, read)):
        return parted
    if (found := otherwise(asking)) is not None:
        return found
    if (sides := sides_of(elements_of(names), text)) is not None:
        if found := _compared(names, text, sides, read):
            return found
        if is_specific(told):
            names.problems += told
            return []
    nearest, instead = _nearest(names, text, read)
    if not nearest and (relation := _related(names, text, read)):
        return relation
    if not nearest and (so := _whether(names, text, read)):
        return so
    if not nearest and (by_value := _turned_round(names, text, read)):
        return by_value
    if (len(nearest) != 1 or _is_of_all(names, text)) and (parted := _several(names, text, read)):
        return parted
    if not nearest and not instead:
        instead = _lacking(names, text, read)
    if not nearest and (put := _named_besides(names, text)):
        return understood(names, put, read)
    if not nearest and not instead:
        right = {language: spelt_as_known(names, text, language) for language in languages()}
        for said in dict.fromkeys(other for other in right.values() if other != text):
            nearest = nearest or _nearest(names, said, read)[0]
            if not nearest and (parted := _several(names, said, read)):
                return parted
    if len(nearest) > 1 and len(nearest) <= ONE_BY_ONE and _is_of_each(text, nearest):
        return [one for words, asked in nearest.items() for one in zip(asked, words.split(JOINT), strict=True)]
    if len(nearest) == 1:
        return next([*zip(asked, words.split(JOINT), strict=True)] for words, asked in nearest.items())
    if not nearest and (passing := same_value(names, text)) is not None:
        return understood(names, passing, read)
    if not nearest and not as_put and (put_otherwise := _recast(names, text, read)):
        return put_otherwise
    of_train = bool(joining.toothed(names)) and is_specific(told)
    if not nearest and any(map(names.is_of_broken_kind, (text, *(p.message.replace("_", " ") for p in told)))):
        return []
    words = {word for language in languages() for word in vocabulary(language)}  # `after impact` is no parameter
    strange = {*not_understood(names.parameters, elements_of(names), text), *words} & unknown_parameters(told)
    if nearest:
        ways = "\n    ".join(islice(nearest, MOST))
        several_ways = Message("'{text}' can be meant in several ways. Ask for\n    {ways}", text=text, ways=ways)
        names.problem(several_ways, "find")
    elif (which := holds_without_which(names, text)) is not None:
        names.problem(which, "find")
    elif (other := other_value(names, text) or what_does_not_hold(names, text, is_of_train=of_train)) is not None:
        names.problem(other, "find")
    elif (slips := _told_of_words(names, text)) is not None:
        names.problem(slips, "find")
    elif (
        instead
        or (is_specific(told) and not (is_of_kinds(names, told) or condition_in_words(told)) and not strange)
        or is_misspelt(told, text)
    ):
        names.problems += told if is_specific(told) and not (is_of_words(names, told) and instead) else instead or told
    else:
        fits = suggestions(
            names,
            " ".join((text, *concepts(names, text))),
            what_is_near(names, text),
            lambda question: (
                None
                if isinstance(asked := read_quietly(names, question, read), Unread)
                or not _have_instants(question, asked)
                else asked
            ),
        )
        askable = "\n    ".join(fits)
        none = Message("cannot read '{text}'. One can ask for\n    {askable}", text=text, askable=askable)
        condition = condition_in_words(told)
        is_strange = absent(elements_of(names), text) or not_understood(names.parameters, elements_of(names), text)
        if condition and not is_strange:
            none = Message(
                "cannot read the condition '{condition}'. One can ask for\n    {askable}",
                condition=condition,
                askable=askable,
            )
        elif thing := absent(elements_of(names), text):
            none = Message(
                "cannot read '{text}': there is no {thing} in this model. One can ask for\n    {askable}",
                text=text,
                thing=thing,
                askable=askable,
            )
        elif given := parameter_asked(names.parameters, text):
            turned = (f"value of {given} for which {question} = 0" for question in fits)
            turned = (one for one in turned if is_of_an_instant(read_quietly(names, one, read)))
            none = Message(
                "{name} is a parameter of the model. Ask for the value of it with which something is so, or for "
                "what follows from it\n    {askable}",
                name=given,
                askable="\n    ".join([*islice(turned, 1), *fits][:MOST]),
            )
        elif strange := not_understood(names.parameters, elements_of(names), text):
            none = Message(
                "cannot read '{text}' (not understood: {words}). One can ask for\n    {askable}",
                text=text,
                words=", ".join(strange),
                askable=askable,
            )
        if not names.lacks_elements:  # else it may be about what could not be read
            names.unknown(text, none, "find")
    return []


def _recast(names: Names, text: str, read: Callable[[str], AskedT | None]) -> list[tuple[AskedT, str]]:
    """What a text asks for in the first plainer construction that is understood."""
    with names.quietly():
        each = (understood(names, said, read, as_put=True) for said in recast(text))
        return next((found for found in each if found), [])


def _related(names: Names, text: str, read: Callable[[str], AskedT | None]) -> list[tuple[AskedT, str]]:
    """What compares two quantities, each asked for by itself."""

    def unit(words: str) -> Dimension | None:
        asked = read_quietly(names, words, read)
        return None if isinstance(asked, Unread) else asked[0].quantity.dimension

    for words in related(names, text, lambda said: _said_plainly(names, said, read), unit):
        if not isinstance(asked := read_quietly(names, words, read), Unread):
            return [*zip(asked, (words,), strict=True)]
    return []


def _whether(names: Names, text: str, read: Callable[[str], AskedT | None]) -> list[tuple[AskedT, str]]:
    """What asks if something is so in the motion: does the crate slip, whether the crate slips."""
    if not (stated := stated_of(text)):
        return []
    words = f"whether {stated}"
    asked = read_quietly(names, words, read)
    return [] if isinstance(asked, Unread) else [(one, words) for one in asked]


def _turned_round(names: Names, text: str, read: Callable[[str], AskedT | None]) -> list[tuple[AskedT, str]]:
    """What asks for a parameter by what it is."""
    for words in sought(names, text, lambda said: _said_plainly(names, said, read)):
        if not isinstance(asked := read_quietly(names, words, read), Unread):
            return [*zip(asked, words.split(JOINT), strict=True)]
    return []


def _named_besides(names: Names, text: str) -> str:
    """A text without the symbol at its end that only names what stands before it: the friction torque M_R."""
    found = _SYMBOL.search(text)
    elements = elements_of(names)
    is_known = found is not None and (
        found["symbol"] in elements.exact or (found["symbol"].lower(),) in elements.spoken
    )
    return text[: found.start()] if found is not None and not is_known else ""


def _asked_plainly(names: Names, text: str, read: Callable[[str], AskedT | None]) -> list[tuple[AskedT, str]]:
    """What a text asks for that only begins with what is the ..., before words of the grammar."""
    words = _WHAT_IS.sub("", text).rstrip("?!. ")
    found = None if words == text.rstrip("?!. ") else read_quietly(names, words, read)
    return [] if found is None or isinstance(found, Unread) else [(found[0], words)]


def _compared(
    names: Names,
    text: str,
    sides: tuple[str, str],
    read: Callable[[str], AskedT | None],
) -> list[tuple[AskedT, str]]:
    """Which of two is greater: of sides that are read by themselves, or the second by what it shares with the first.
    Where each is up to an event of its own, by how much the first exceeds the second."""
    elements = elements_of(names)
    owned = (sides[0], of_owner(names, elements, sides[1], sides[0]))
    each = [words for side in owned if (words := _words(names, side, read))]
    if len(each) < len(sides) and _VALUE.fullmatch(sides[1]):
        return []
    if len(each) < len(sides) and (first := _words(names, sides[0], read)):  # and the lower: what the first is of
        texts = (text for own in languages() for text in completed(elements, *sides, own))
        second = next((words for text in texts if (words := _words(names, text, read)) not in ("", first)), "")
        each = [first, second] if second else each
    if len(each) < len(sides):
        both = _several(names, text, read)
        each = [words for _asked, words in both] if len(both) == len(sides) else each
    if len(each) < len(sides):
        return []
    is_timed = _OF_EVENTS.search(each[0]) is not None or each[0].endswith(" at start")
    if _VALUE.fullmatch(each[1]) and not is_timed and may_change(names):
        return []  # it is more at one time, and less at another one
    same = _AT_ONE.fullmatch(f"{each[0]}\n{each[1]}")  # the instant of both is said once
    first, second = (each[0].removesuffix(same["when"]), each[1]) if same is not None else each
    at_events = [f"({each[0]}) - ({each[1]})"] if _OF_EVENTS.search(" ".join(each)) else []
    for words in (f"which is greater, {first} or {second}", *at_events):
        if not isinstance(asked := read_quietly(names, words, read), Unread):
            return [*zip(asked, (words,), strict=True)]
    return []


def _words(names: Names, text: str, read: Callable[[str], AskedT | None]) -> str:
    """A side of a comparison in the words of the grammar: a quantity, a multiple of one, or an expression in the
    parameters."""
    if _VALUE.fullmatch(text):
        return text
    if (multiple := multiple_of(text)) is not None:
        of = _words(names, multiple[1], read)
        return f"({of})*{multiple[0]}" if of else ""
    found = _one(names, text, read)
    if found:
        return found[0][1] if len(found) == 1 else ""
    return "" if isinstance(read_quietly(names, f"which is greater, {text} or {text}", read), Unread) else text


def _several(names: Names, text: str, read: Callable[[str], AskedT | None]) -> list[tuple[AskedT, str]]:
    """What a text asks for that is several questions in one, each read by itself; nothing where one cannot be."""
    elements = elements_of(names)
    if is_one_without_other(text):
        return []
    text = of_rivals(elements, text)
    if each := each_of(names, elements, text):
        found = [_one(names, said, read) for said in each[:ONE_BY_ONE]]
        every = [one for some in found for one in some]
        if all(found) and len({*(asked for asked, _ in every)}) == len(every):  # each of them is another thing
            return every
    for way in parts(elements, text):
        if any(is_strange(names, part.said) for part in way):
            continue
        found_here: list[tuple[AskedT, str]] = []
        for part in way:
            texts = (
                [*part.texts, *_of_first(names, elements, part.texts, way[0].said)]
                if part is not way[0]
                else part.texts
            )
            every = (_one_or_each(names, elements, said, read) for said in texts)
            before = [asked for asked, _ in found_here]
            fitting = (one for one in every if one and all(_fits_event(asked) for asked, _ in one))
            some = next((one for one in fitting if all(asked not in before for asked, _ in one)), None)
            some = some or []
            if found_here and part.there:
                told_there = (part.there, named_instead(names, elements, part.there, way[0].said))
                each = (_there(names, said, found_here[0][1], read) for said in dict.fromkeys(told_there))
                some = some or next((one for one in each if one), [])
            if found_here and found_here[0][1].startswith("time when ") and not any(one.event for one, _ in some):
                some = _then(names, part.texts, found_here[0][1], read) or some
            if not some or any(asked in before for asked, _ in some):  # nothing that is said is dropped
                break
            found_here += some
        else:
            return found_here
    return []


def _of_first(names: Names, elements: Elements, texts: Sequence[str], first: str) -> list[str]:
    """Texts in which what is its own is that of the body that the first question names."""
    owned = (of_owner(names, elements, text, first) for text in texts)
    return [text for text in dict.fromkeys(owned) if text not in texts]


def _have_instants(words: str, asked: Iterable[Asked]) -> bool:
    """Whether what is asked of an instant has a value there: a stroke, or a period, is that of a whole turn."""
    timed = [one for one in asked if one.event is not None or one.transition is not None]
    is_end = words.startswith(("greatest ", "least ")) and " when " in words
    if any((one.at_start or is_end) and one.quantity.scope == "whole motion" for one in asked):
        return False  # what is greatest over the motion is so at no instant
    lasts = any(one.quantity.scope in _OF_EVERY_TURN for one in timed)
    return not timed or not (lasts or words.startswith(("stroke of ", "phase lag of ", "mass of ")))


def _fits_event(asked: Asked) -> bool:
    """Whether what is asked can be meant when it is said to be: a period has no instant."""
    is_timed = asked.event is not None or asked.transition is not None
    return not is_timed or asked.quantity.scope not in _TIMELESS


def _one(names: Names, text: str, read: Callable[[str], AskedT | None]) -> list[tuple[AskedT, str]]:
    """What a text asks for that can be meant in one way only."""
    text = text.rstrip(" ?!")
    plain = read_quietly(names, text, read)
    if not isinstance(plain, Unread):
        return [*zip(plain, text.split(JOINT), strict=True)]
    nearest, _ = _nearest(names, text, read)
    if len(nearest) != 1:
        return []
    return next([*zip(asked, words.split(JOINT), strict=True)] for words, asked in nearest.items())


def _quietly_one(names: Names, text: str, read: Callable[[str], AskedT | None]) -> list[tuple[AskedT, str]]:
    with names.quietly():
        return _one(names, text, read)


def _said_plainly(names: Names, text: str, read: Callable[[str], AskedT | None]) -> str:
    """A text in the words of the grammar; nothing where it has none."""
    with names.quietly():
        return JOINT.join(dict.fromkeys(words for _asked, words in understood(names, text, read)))


def _one_or_each(
    names: Names, elements: Elements, text: str, read: Callable[[str], AskedT | None]
) -> list[tuple[AskedT, str]]:
    if found := _one(names, text, read):
        return found
    each = [_one(names, said, read) for said in each_of(names, elements, text)[:ONE_BY_ONE]]
    return [one for some in each for one in some] if all(each) else []


def _there(names: Names, text: str, first: str, read: Callable[[str], AskedT | None]) -> list[tuple[AskedT, str]]:
    """What is asked of the event at which, or up to which, the first question is meant."""
    event = re.search(r"(?<=\s)(?:when|until) (.+)$", first)
    if event is None:
        return _one(names, f"{text} at start", read) if first.endswith(" at start") else []
    plain = _one(names, text, read)
    heads = (text, *([plain[0][1]] if len(plain) == 1 else []))  # as it is understood: in the words of the event
    said = (f"{head} {mark} {event[1]}" for head in heads for mark in ("when", "until"))
    return next((found for one in said if (found := _one(names, one, read))), None) or []


def _then(
    names: Names, texts: Iterable[str], first: str, read: Callable[[str], AskedT | None]
) -> list[tuple[AskedT, str]]:
    """What is asked beside a time, at that time: how long does it take, and how far does it get?"""
    each = (_there(names, text, first, read) for text in texts)
    return next((found for found in each if found and all(_fits_event(asked) for asked, _ in found)), [])


def _is_of_all(names: Names, text: str) -> bool:
    """Whether a text asks for quantities of all things of a kind, of which there are several: speeds of all gears."""
    said = any(several(language, "quantities").search(text) for language in languages())
    return said and len(each_of(names, elements_of(names), text)) > 1


def _is_of_each(text: str, ways: dict[str, tuple[AskedT, ...]]) -> bool:
    """Whether a text that can be meant in several ways is answered by all of them."""
    return _is_plural(text, ways) or _are_tensions(ways) or _are_of_one_pose(ways)


def _are_of_one_pose(ways: dict[str, tuple[AskedT, ...]]) -> bool:
    """Whether the ways to mean a text differ only in where something is upright: above and below."""
    told = [re.fullmatch(r"(?P<head>.+ when \w+ = )-?\d+(?: deg)?", words) for words in ways]
    return all(told) and len({one["head"] for one in told if one is not None}) == 1


def _is_plural(text: str, ways: dict[str, tuple[AskedT, ...]]) -> bool:
    """Whether a text asks for several things of a kind, and the ways to mean it are these."""
    heads = {words.partition(" of ")[0].removeprefix("angular ") for words in ways}
    said = any(several(language, "quantities").search(text) for language in languages())
    return said and len(heads) == 1


def _are_tensions(ways: dict[str, tuple[AskedT, ...]]) -> bool:
    """Whether a text can be meant of several strings: it is asked of all."""
    strings_ = [re.match(r"tension of (\w+)", words) for words in ways]
    named = [found[1] for found in strings_ if found is not None]
    return len(set(named)) == len(ways)


def _nearest(
    names: Names, text: str, read: Callable[[str], AskedT | None]
) -> tuple[dict[str, tuple[AskedT, ...]], list[Problem]]:
    """What can be meant by the names that are nearest to those written, by its words; and, where nothing can, what is
    wrong with the first text that has words of the grammar."""
    if takes_cut_for_whole(names, text):
        return {}, []
    nearest: dict[str, tuple[AskedT, ...]] = {}
    calls = set(_CALL.findall(text))  # cos(theta) = 1/2 is not theta = 1/2
    left_open: dict[str, int] = {}  # questions for each of several values, where of which is meant is not said
    distance: int | None = None
    instead: list[Problem] = []
    tried_at = 0
    plain: tuple[Word, ...] | None = None  # the words of the nearest meaning: no name is taken for a quantity in it
    for meaning in ways_to_mean(names, text):
        plain = meaning.words if plain is None else plain
        if distance is not None and meaning.distance > distance:
            break
        if distance is None and meaning.distance > tried_at and leave_open(instead):
            break  # which of several values is meant says no other name that the words may be
        tried_at = meaning.distance
        lacking: list[Problem] = []
        open_ = ""
        for wordings in meaning.texts:
            tried = {words: read_quietly(names, words, read) for words in wordings}
            here = {words: asked for words, asked in tried.items() if not isinstance(asked, Unread)}
            here = {words: asked for words, asked in here.items() if _have_instants(words, asked)}
            here = {words: asked for words, asked in here.items() if is_kept(names, meaning.words, words)}
            here = {words: asked for words, asked in here.items() if not loses_joint(names, text, words)}
            here = {words: asked for words, asked in here.items() if not loses_quantity(plain, words)}
            here = {words: asked for words, asked in here.items() if chooses_of_what_is_asked(names, plain, words)}
            here = {words: asked for words, asked in here.items() if not loses_other(names, text, words)}
            here = {words: asked for words, asked in here.items() if not loses_height(names, text, words)}
            here = {
                words: asked for words, asked in here.items() if not (loses_sign(text, words) or is_of_itself(words))
            }
            here = {words: asked for words, asked in here.items() if not loses_failure(text, words)}
            here = {words: asked for words, asked in here.items() if not loses_mass_center(text, words)}
            here = {words: asked for words, asked in here.items() if not loses_share(text, words)}
            here = {words: asked for words, asked in here.items() if not takes_held_for_stopped(text, words)}
            here = {words: asked for words, asked in here.items() if calls <= set(_CALL.findall(words))}
            if any(is_of_kind(names, meaning.words, one, (a.quantity for a in here[one])) for one in here):
                distance = meaning.distance
                nearest |= {words: asked for words, asked in here.items() if asked not in nearest.values()}
                break
            for words, asked in tried.items():
                if not lacking and isinstance(asked, Unread) and is_specific(asked.problems):
                    lacking, instead = asked.problems, instead or asked.problems
                    open_ = JOINT.join(each_value(names, words, lacking))
        else:
            is_open = bool(open_) and not takes_held_for_stopped(text, open_)
            if is_open and is_kept(names, meaning.words, open_):
                left_open.setdefault(open_, meaning.distance)
    for words, at in left_open.items():
        distance = at if distance is None else distance
        asked = read_quietly(names, words, read)
        if at == distance and not isinstance(asked, Unread) and asked not in nearest.values():
            nearest[words] = asked
    return nearest, instead


def _told_of_words(names: Names, text: str) -> Message | None:
    """What is said of a text that asks for what is told with the answers to other questions."""
    ways = [meaning.words for meaning in ways_to_mean(names, text)]
    told = (find(names, words) for words in ways for find in (slip_in_impact, limits_of_braking))
    return next((message for message in told if message is not None), None)


def _lacking(names: Names, text: str, read: Callable[[str], AskedT | None]) -> list[Problem]:
    """What is said of a text in which something has a name that the model has not."""
    for meaning in ways_to_mean(names, text, guess=True):
        for wordings in meaning.texts:
            for words in wordings:
                asked = read_quietly(names, words, read)
                if isinstance(asked, Unread) and is_specific(asked.problems):
                    return asked.problems
    return []
