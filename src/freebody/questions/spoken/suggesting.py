"""Complete questions that a model can be asked, made of its own names: the nearest to what was typed come first."""

from __future__ import annotations

import difflib
import re
from collections.abc import Callable, Iterable, Iterator
from itertools import islice, permutations
from typing import TYPE_CHECKING

from freebody.language.expression import free_symbols
from freebody.language.units import DIMENSIONLESS
from freebody.measures.geometry import GROUND
from freebody.questions.spoken import given, joining, lookup, of_axles, rubbing
from freebody.questions.spoken.compounds import in_english_nouns
from freebody.questions.spoken.elements import Elements
from freebody.questions.spoken.lexicon import is_verb, languages, phrases_at, quantity_words, tells_apart, things
from freebody.questions.spoken.naming import linked
from freebody.questions.spoken.words import Unknown, words_of

if TYPE_CHECKING:
    from freebody.model.names import Names

MOST = 5
# words for where something turns back, or is at its largest: a rate is zero there
_FARTHEST = re.compile(
    r"\b(?:max|highest|lowest|farthest|furthest|largest|how (?:far|high)|turn(?:s|ed)?\b|range|amplitude|swing|"
    r"höchst|tiefst|größt|umkehr|wie (?:weit|hoch)|amplitude|ausschlag|wurfweite)",
    re.IGNORECASE,
)
_LEADING = 2  # of what a text may mean, and of the file's own questions, before others
# what a text is about, in any language, and what questions of the grammar about it have
_KINDS = tuple(
    (re.compile(said, re.IGNORECASE), re.compile(asked))
    for said, asked in (
        (
            r"\b(?:must|may|can|could|need|needed|required|at most|at least|at (?:what|which) .*\b(?:does|do|will)\b|"
            r"(?:from|above|below|up to|for) (?:what|which)|m(?:ax|in)|damit|muss|darf|kann|soll|mindestens|höchstens|"
            r"(?:ab|bei|bis zu|für|mit) welche|nötig|erforderlich|größt|kleinst|maximal|minimal)",
            r"^(?:value|range|least|largest) ",
        ),
        (r"\b(?:when|how (?:long|soon)|what time|time|wann|wie lange|zeit|dauer)", r"^time "),
        (r"\b(?:fast|speed|velocity|quick)|schnell|geschw|drehzahl|\brpm", r"\b(?:speed|velocity|rate)\b"),
        (
            r"\b(?:far|high|deep|where|place|position)\b|weit|hoch|höhe|tief|\bwo\b|\blage",
            r"^greatest |^\w+ when |height",
        ),
        (r"force|tension|pull|push|press|load\b|reaction|kraft|zug|last|druck|lager", r"force|tension|reaction"),
        (r"energy|work|heat|dissipat|energie|arbeit|wärme", r"energy|work"),
        (r"accelerat|decelerat|beschleunig|verzöger|brems", r"acceleration"),
        (r"equilib|settle|balance|at rest|gleichgewicht|ruhelage|stellt sich|pendelt sich", r"equilibrium|at rest"),
        (r"period|frequen|oscillat|vibrat|swing|schwing|periode|eigen", r"period|frequenc"),
        (r"steady|uniform|constant|stationär|gleichförm|umlauf|läuft .* um|revol", r"steady motion|terminal"),
    )
)
_COMMON = frozenset(  # words that say nothing of what is meant
    {
        "a",
        "an",
        "the",
        "of",
        "in",
        "at",
        "on",
        "to",
        "is",
        "are",
        "it",
        "its",
        "does",
        "do",
        "has",
        "have",
        "what",
        "how",
    }
)
_LIMIT = re.compile(
    r"\b(?:slip|slid|hold|rest\b|moves?\b|stay|tip|steep|rough|steil|\brau|rutsch|gleit|ruhe|kipp|hält)", re.IGNORECASE
)
_PLACE = re.compile(
    r"\b(?:displacement|position|travel)\b|verschiebung|\b(?:\w+)?weg(?:es|s)?\b|\blage\b", re.IGNORECASE
)
_FASTEST = re.compile(r"\bfastest|(?:max\w*|top|greatest|highest) speed|schnellsten|höchstgeschw", re.IGNORECASE)
_LIMIT_OF_REST = re.compile(r"\b(?:stays? at rest|keeps it at rest|not slip|does it hold|not tip)\b")
_STABLE = re.compile(
    r"stabil|stable|\bupright|\bbalanc|\bfall(?:s|ing)? over|aufrecht|umfäll|umkipp|balancier", re.IGNORECASE
)
_RATIO = re.compile(
    r"\bratio|übersetzung|verhältnis|\bturns?\b.+\b(?:rad/s|rpm|turns?)\b|dreht.+\b(?:rad/s|U/min)\b", re.IGNORECASE
)
_ADVANTAGE = re.compile(r"\bmechanical advantage|kraftübersetzung|kraftverhältnis", re.IGNORECASE)
_EFFICIENCY = re.compile(r"\befficien|wirkungsgrad", re.IGNORECASE)
_TIMES = re.compile(r"\btime ratio|quick return|return (?:stroke|time)|zeitverhältnis", re.IGNORECASE)


def suggestions(names: Names, text: str, near: Iterable[str], read: Callable[[str], object | None]) -> list[str]:
    """At most five questions that can be read: first those that are near, then by how many of their words are those of
    the text. No two of them ask for the same.

    read: what a question asks for, None where it cannot be read."""
    typed = _words(text)
    askable = dict.fromkeys((*names.usual_questions, *_askable(names)))
    others = sorted(askable, key=lambda question: -_likeness(typed, _words(question)))
    found: dict[str, object] = {}
    first = [*_time_ratios(names, text), *_ratios(names, text), *_advantages(names, text)]
    first += [*_places(names, text), *_efficiencies(names, text), *_stability(names, text), *_fastest(names, text)]
    nearest = iter(near)
    leading = (*first, *islice(nearest, _LEADING), *_usual(names, text, typed), *nearest)
    for question in (*leading, *_limits(names, text), *_turning_points(names, text), *others):
        if len(found) >= MOST:
            break
        asked = None if question in found else read(question)
        if asked is not None and asked not in found.values():
            found[question] = asked
    return list(found)


def absent(elements: Elements, text: str) -> str:
    """The first thing that a text names, as it names it, and the model has not; nothing where it has all of them."""
    known = {word for element in elements.exact.values() for word in element.words}
    known |= {word for key in elements.spoken for word in key}
    for word in re.findall(r"[^\W\d_]{3,}", text):
        if any(m.kind == "filler" for language in languages() for m, _ in phrases_at(word.lower(), 0, language)):
            continue  # Germans say `man` of anyone
        if any(tells_apart(word.lower().replace("ß", "ss"), language) for language in languages()):
            continue  # which thing, or which value: mittlere
        for language in languages():
            said = in_english_nouns(word, language).lower()
            does = is_verb(said) or (word.islower() and is_verb(word))  # hang is no Hang
            is_thing = not ({said, word.lower()} & known or does) and said not in quantity_words(language)
            if is_thing and any(form in things() for form in (said, said.removesuffix("s"))):
                return word if said.removesuffix("s") not in known else ""
    return ""


def not_understood(parameters: Iterable[str], elements: Elements, text: str) -> list[str]:
    """The words of a text, as they are typed, that nothing is known of in the language that knows most of them; none
    where these are words that rules put in place of what was typed."""
    found: list[set[str]] = []
    for language in languages():
        for way in islice(linked(elements, in_english_nouns(text, language, elements.taken)), MOST):
            try:
                words_of(way.text, language, parameters=parameters)
                return []  # each has a meaning, but not all of them together
            except Unknown as error:
                strange = set(error.words)
                typed = {
                    word
                    for word in re.findall(r"[^\W\d_][\w’'-]*", text)
                    if strange & {*in_english_nouns(word, language, elements.taken).lower().replace("ß", "ss").split()}
                }
                found.append(typed or strange)
    fewest = min(found, key=len, default=set[str]())
    return [word for word in dict.fromkeys(re.findall(r"[^\W\d_][\w’'-]*", text)) if word in fewest]


def _usual(names: Names, text: str, typed: list[str]) -> list[str]:
    """The file's own questions that are about what a text is about, and have most of its words."""
    about = [asked for said, asked in _KINDS if said.search(text)]
    found = {one: sum(asked.search(one) is not None for asked in about) for one in names.usual_questions}
    fitting = [one for one, n in found.items() if n]
    return sorted(fitting, key=lambda one: -(found[one] + _likeness(typed, _words(one))))[:_LEADING]


def _askable(names: Names) -> Iterator[str]:
    for name, measure in names.measures.items():
        is_angle = measure.dimension == DIMENSIONLESS
        yield f"{'angular ' if is_angle else ''}acceleration of {name}"
        yield f"{'angular ' if is_angle else ''}velocity of {name}"
        yield f"equilibrium of {name}"
    for row in names.constraint_rows:
        if row.reaction != "force":  # of a pin, which is its reaction
            yield f"{row.reaction} of {row.connection}"
        for end in row.ends:
            yield f"{row.reaction} of {row.connection} at {end}"
        yield f"reaction of {row.connection}"
    for name, body in names.bodies.items():
        if name == GROUND or body.fixed:
            continue
        yield from (f"{what} of {name}" for what in ("acceleration", "speed", "kinetic energy", "linear momentum"))
        if body.turns:
            yield from (f"angular {what} of {name}" for what in ("velocity", "acceleration", "momentum"))
    for name in names.loads:
        yield f"force in {name}"
    rough, bound = bool(rubbing.rough(names, "")), any(row.unilateral for row in names.constraint_rows)
    events = {"rolling begins": rough and lookup.can_roll(names), "slipping ends": rough, "contact opens": bound}
    for event in (event for event, is_possible in events.items() if is_possible):
        yield f"time when {event}"
        yield f"energy lost until {event}"
    yield from ("degrees of freedom", "natural frequencies", "period of small oscillations", "total energy")
    yield from ("is total energy conserved", "does it hold")


def _turning_points(names: Names, text: str) -> Iterator[str]:
    """Where measures have their turning points, if that is what a text is about."""
    if _FARTHEST.search(text) is not None:
        measures = list(names.measures)[: MOST // 2]
        yield from (f"{name} when rate({name}) = 0" for name in measures)


def _places(names: Names, text: str) -> Iterator[str]:
    """Measures, if it is about where something is: those of what it names first."""
    if _PLACE.search(text) is not None:
        typed = _words(text)
        is_named = {name: any(body.lower() in typed for body in m.bodies()) for name, m in names.measures.items()}
        yield from sorted(names.measures, key=lambda name: not is_named[name])[: MOST // 2]


def _fastest(names: Names, text: str) -> Iterator[str]:
    """How fast things get, if that is what a text is about: those that it names first."""
    if _FASTEST.search(text) is not None:
        typed = _words(text)
        moving = sorted(lookup.moving(names), key=lambda name: name.lower() not in typed)
        yield from (f"greatest speed of {name}" for name in moving[: MOST // 2])


def _limits(names: Names, text: str) -> Iterator[str]:
    """Limits of rest, if that is what a text is about: of the parameters that it names, of the friction, and of what
    can be chosen of the kind that it asks for; what a drive turns never rests."""
    if _LIMIT.search(text) is None:
        return
    yield from (usual for usual in names.usual_questions if _LIMIT_OF_REST.search(usual) is not None)
    named = [name for name in re.findall(r"\w+", text) if name in names.parameters]
    if lookup.rests(names):
        yield from (f"range of {name} that keeps it at rest" for name in dict.fromkeys(named))
    rough = given.parameters(names, "friction coefficient", "")
    yield from (f"least {name} so that it does not slip" for name in rough)
    for word in [word for word in text.split() if given.can_end_rest(word)]:
        chosen = given.chosen(names, given.KIND_OF[word], [])
        yield from (f"range of {name} that keeps it at rest" for name in chosen)


def _stability(names: Names, text: str) -> Iterator[str]:
    """What is asked of stability, if that is what a text is about: with which values of a controller there is one."""
    if _STABLE.search(text) is None:
        return
    yield from (usual for usual in names.usual_questions if "stab" in usual)
    kind = "steady motion" if lookup.is_controlled(names) else "equilibrium"
    yield f"stability of {kind}"
    pushes = [load.law for load in names.applied_loads if load.load in lookup.driving(names)]
    used = frozenset[str]().union(*map(free_symbols, pushes)) if lookup.is_controlled(names) else frozenset[str]()
    yield from (f"least {name} so that the {kind} is stable" for name in names.parameters if name in used)


def _ratios(names: Names, text: str) -> Iterator[str]:
    """Ratios of how bodies turn, if that is what a text is about: of those that it names first."""
    if _RATIO.search(text) is not None:
        typed = _words(text)
        turning = [name for name, body in names.bodies.items() if name != GROUND and body.turns and not body.fixed]
        turning.sort(key=lambda name: name.lower() not in typed)
        pairs = permutations(turning[:2], 2)
        yield from (f"ratio of angular velocity of {a} to angular velocity of {b}" for a, b in pairs)


def _advantages(names: Names, text: str) -> Iterator[str]:
    """By how much one load outweighs another, if that is what a text is about: of all pairs of them."""
    if _ADVANTAGE.search(text) is not None:
        pairs = permutations(names.loads, 2)
        yield from (f"mechanical advantage of {load} to {other}" for load, other in pairs)


def _efficiencies(names: Names, text: str) -> Iterator[str]:
    """The power of one load over that of another, and the efficiency of a planetary train, if an efficiency is what a
    text is about."""
    if _EFFICIENCY.search(text) is not None:
        pairs = permutations(names.loads, 2)
        yield from (f"ratio of power of {load} to power of {other}" for load, other in pairs)
        members = [name for name, body in names.bodies.items() if name != GROUND and body.turns]
        for driving, driven, held in permutations(members, 3) if of_axles.planets(names) else ():
            yield f"efficiency from {driving} to {driven} with {held} held and basic efficiency 0.97"


def _time_ratios(names: Names, text: str) -> Iterator[str]:
    """Time ratios of what is measured and of what is guided, if that is what a text is about."""
    if _TIMES.search(text) is not None:
        yield from (f"time ratio of {name}" for name in names.measures)
        yield from (
            f"time ratio of position of {body} along {guide}"
            for body in lookup.moving(names)
            for guide in joining.guides(names, body)
        )


def _words(text: str) -> list[str]:
    return [word for word in re.findall(r"\w+", text.lower()) if word not in _COMMON]


def _likeness(typed: list[str], question: list[str]) -> float:
    """How much of a question was typed, where words may be misspelt."""
    if not question:
        return 0.0
    near = [
        max((difflib.SequenceMatcher(None, word, other).ratio() for other in typed), default=0.0) for word in question
    ]
    return sum(share for share in near if share > 0.7) / (1.0 + len(question))
