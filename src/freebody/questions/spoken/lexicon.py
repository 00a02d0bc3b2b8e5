"""The words of each language, a file `xx.toml` each: kinds of words, what each means, and the phrases for it.

A phrase is words, with choices (a|b), parts that may be left out (a)?, an open end (turn*), a gap, for what stands
between its words (comes _ back), verbs in all their forms (~tug, inflecting.py), and families of words that stand for
one another (<keeps>). The table `spelling` is of rules
for the whole text, before its words are looked up.
A table of its own may stand in a further file: `xx.values.toml`.
A file other than the English one says what things are called in English (`nouns`), with their endings, and which words
are written as one with them (`compounds`).
"""

from __future__ import annotations

import re
import tomllib
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache, cached_property, lru_cache
from pathlib import Path
from typing import Any, cast

from freebody.questions.spoken.inflecting import ENDS_CLAUSE, inflected

ENGLISH = "en"
OPEN, CLOSE = "«", "»"  # marks of names in a text
MARKED = rf"{OPEN}[^{OPEN}{CLOSE}]+{CLOSE}"
GAP = "_"
_MANY = 1 << 14  # words, and texts, whose meaning is kept
_SHORT = 3  # letters of a word that has no plural here
_NO_WORDS = (
    "signs",
    "indices",
    "units",
    "spelling",
    "families",
    "several",
    "nouns",
    "endings",
    "compounds",
    "before",
    "behind",
    "things",
    "numbered",
    "compared",
    "adjectives",
    "adverbs",
    "values",
    "stated",
    "measured",
    "symbols",
    "assumptions",
    "contexts",
    "changes",
    "comparatives",
    "relations",
    "restated",
    "recast",
    "shares",
    "levels",
    "numerals",
)  # tables that are not kinds of words
_CLAUSES = r"(?:so|such|when|if|wenn|damit|nachdem|sodass|from) "  # words into and beyond which no gap goes
# behind a prefix that stands apart: what follows would make it a preposition (gibt nach einer Sekunde nach)
_NOT_LED = r"(?! (?:\0|\d|d(?:er|ie|as|em|en|es)\b|(?:k?ein|dies|jed|welch|sein|ihr)(?:e[rmns]?)?\b))"
_CHOICE = re.compile(r"\(([^()]*)\)(\?)?")


@dataclass(frozen=True)
class Word:
    """What a phrase means. kind: the table it stands in."""

    kind: str
    what: str


@dataclass(frozen=True)
class Phrase:
    """A phrase as the files write it, and what it means."""

    written: str
    means: Word

    @cached_property
    def pattern(self) -> re.Pattern[str]:
        """Of words with one space between them; those between the words of the phrase are the group `gap`."""
        end = _NOT_LED if self.written.endswith(ENDS_CLAUSE) else ""
        text = self.written.rstrip(ENDS_CLAUSE).replace(")?", "\0").replace("(", "(?:").replace("\0", ")?")
        text = re.sub(r"(?<=\w)\*", r"[^ ,]*", text).replace(f" {GAP}", "\1").replace(" ", " *")
        return re.compile(text.replace("\1", r"(?P<gap>(?: (?!" + _CLAUSES + r")[^ ,]+)*?)(?= )") + f"(?= |$){end}")

    def found_in(self, line: str) -> tuple[int, ...] | None:
        """The places in a line of words at which words of it begin, from its first on; None where it is not there."""
        found = self.pattern.match(line)
        if found is None:
            return None
        gap = found.span("gap") if "gap" in self.pattern.groupindex else (found.end(), found.end())
        begins = [0, *(k + 1 for k in range(found.end()) if line[k] == " ")]
        return tuple(k for k in begins if k < found.end() and not gap[0] <= k < gap[1])

    def first_words(self) -> Iterator[str]:
        """The words that it can begin with; a few letters of one whose end is open."""
        for part in _parts(self.written):
            said = list(dict.fromkeys(spelt_out(part)))
            yield from (text.split()[0] for text in said if text)
            if "" not in said:
                return


def _parts(text: str) -> list[str]:
    """A phrase where a space stands outside of choices."""
    parts, depth = [""], 0
    for letter in text.removesuffix(ENDS_CLAUSE):
        depth += (letter == "(") - (letter == ")")
        if letter == " " and depth == 0:
            parts.append("")
        else:
            parts[-1] += letter
    return [part for part in parts if part]


def _is_word(word: str, token: str) -> bool:
    return token.startswith(word[:-1]) if word.endswith("*") else token == word


@cache
def languages() -> tuple[str, ...]:
    """The languages that are understood, English first."""
    found = {path.name.partition(".")[0] for path in Path(__file__).parent.glob("*.toml")}
    return (ENGLISH, *sorted(found - {ENGLISH}))


@cache
def _file(language: str) -> dict[str, Any]:
    parts = (tomllib.loads(path.read_text("utf-8")) for path in Path(__file__).parent.glob(f"{language}.*toml"))
    return {table: words for part in parts for table, words in part.items()}


@cache
def tables(language: str) -> dict[str, dict[str, list[str]]]:
    """The phrases of a language by kind and by what they mean, with all forms of their verbs."""
    found = {kind: table for kind, table in _file(language).items() if kind not in _NO_WORDS}
    families = cast("dict[str, list[str]]", _file(language).get("families", {}))

    def spread(text: str) -> Iterator[str]:
        if (prefixes := re.search(r"(?<=~)<(\w+)>(?=\|)", text)) is not None:  # a verb with each of some prefixes
            for one in families[prefixes[1]]:
                yield from spread(f"{text[: prefixes.start()]}{one}{text[prefixes.end() :]}")
        else:
            yield re.sub(r"<(\w+)>", lambda family: f"({'|'.join(families[family[1]])})", text)

    return {
        kind: {
            what: [form for text in written for one in spread(text) for form in inflected(one, language)]
            for what, written in table.items()
        }
        for kind, table in found.items()
    }


@cache
def _phrases(language: str) -> dict[str, tuple[Phrase, ...]]:
    """The phrases of a language by the first two letters of what they can begin with."""
    found: dict[str, dict[Phrase, None]] = {}
    for kind, table in tables(language).items():
        for what, written in table.items():
            for phrase in (Phrase(text, Word(kind, what)) for text in written):
                for first in phrase.first_words():
                    found.setdefault(first[:2].rstrip("*"), {})[phrase] = None
    return {key: tuple(own) for key, own in found.items()}


def spelt_out(text: str) -> Iterator[str]:
    """A phrase with every choice made."""
    choice = _CHOICE.search(text)
    if choice is None:
        yield " ".join(text.split())
        return
    for option in (*choice[1].split("|"), *([""] if choice[2] else [])):
        yield from spelt_out(text[: choice.start()] + option + text[choice.end() :])


def phrases_at(line: str, start: int, language: str) -> list[tuple[Word, tuple[int, ...]]]:
    """What the words of a line from a place on can mean, the longest phrases first, and where their words begin."""
    return [(word, tuple(start + k for k in places)) for word, places in _phrases_before(line[start:], language)]


@lru_cache(_MANY)
def _phrases_before(line: str, language: str) -> tuple[tuple[Word, tuple[int, ...]], ...]:
    """What the first words of a line can mean, the longest phrases first, and where their words begin."""
    table = _phrases(language)
    found: list[tuple[Word, tuple[int, ...]]] = []
    for key in dict.fromkeys((line[:2].rstrip(), line[:1])):
        for phrase in table.get(key, ()):
            places = phrase.found_in(line)
            if places is not None:
                found.append((phrase.means, places))
    return tuple(sorted(found, key=lambda one: -len(one[1])))


@cache
def is_verb(token: str) -> bool:
    """Whether an English word alone is a verb."""
    return any(word.kind == "verb" for word, _ in phrases_at(token, 0, ENGLISH))


@cache
def is_verb_of(token: str, language: str) -> bool:
    """Whether a word alone is an infinitive, or a third person, of another language."""
    ends = token.endswith(("en", "et", "t"))
    return ends and any(word.kind == "verb" for word, _ in phrases_at(token, 0, language))


@cache
def stands_for_all(token: str) -> bool:
    """Whether a word alone, in any language, stands for the whole system: the machine."""
    return any(word == Word("pronoun", "system") for own in languages() for word, _ in phrases_at(token, 0, own))


def is_left_out(token: str) -> bool:
    """Whether a word alone says nothing in a language: the person."""
    return any(word == Word("filler", "drop") for own in languages() for word, _ in phrases_at(token, 0, own))


@cache
def vocabulary(language: str) -> frozenset[str]:
    """All words of a language that are written in full."""
    said = (
        text
        for own in _phrases(language).values()
        for phrase in own
        for part in _parts(phrase.written)
        for text in spelt_out(part)
    )
    return frozenset(word for text in said for word in text.split() if word[-1] not in "*_")


@lru_cache(_MANY)
def goes_beside(token: str, where: str, language: str) -> bool:
    """Whether a word may stand `before` or `behind` a name, and says no more than the name does."""
    own = (*_file(language)[where]["name"], *_file(ENGLISH)[where]["name"])  # into whose nouns others are put
    alone = token.removesuffix("s")  # the bearings A and B
    return any(_is_word(word, token) or (_is_word(word, alone) and len(word) > _SHORT) for word in own)


@cache
def kinds_apart() -> tuple[frozenset[str], ...]:
    """Words for kinds of things that are not the same: what is a block is no cart."""
    return tuple(frozenset(cast("list[str]", words)) for words in _file(ENGLISH)["things"]["apart"])


# -- before words are looked up ---------------------------------------------------------------
@cache
def _spelling(language: str) -> tuple[tuple[re.Pattern[str], str], ...]:
    rules = cast("list[list[str]]", _file(language)["spelling"]["rules"])
    return tuple((re.compile(rule[0].replace("{N}", f"(?:{MARKED})"), re.IGNORECASE), rule[1]) for rule in rules)


@lru_cache(_MANY)
def spelt(text: str, language: str) -> str:
    """A text in which names are marked, spelt as the phrases are, without the mark at its end."""
    text = re.sub(r"(?<![.?! ])[.?! ]+$", "", text) if not text.rstrip().endswith("..") else text
    for pattern, replacement in _spelling(language):
        if pattern.search(text):  # most do not, and each replacement would be parsed anew
            text = pattern.sub(replacement, text)
    return " ".join(text.split())


@cache
def several(language: str, what: str) -> re.Pattern[str]:
    """A pattern for what parts several questions in one, or for what stands for several things."""
    return re.compile(_file(language)["several"][what], re.IGNORECASE)


@cache
def rivals(language: str) -> tuple[tuple[re.Pattern[str], str], ...]:
    """Patterns for questions which of two things is larger, and how both are asked for."""
    rules = cast("list[list[str]]", _file(language)["several"]["rivals"])
    return tuple((re.compile(pattern, re.IGNORECASE), written) for pattern, written in rules)


@cache
def comparisons(language: str) -> tuple[tuple[re.Pattern[str], str, str], ...]:
    """Patterns for questions which of two things is greater, and what both sides are. In them {comparative} stands for
    words that compare."""
    rules = cast("list[list[str]]", _file(language)["several"]["compared"])
    told = cast("dict[str, dict[str, str]]", compared_in(language, "comparatives"))
    words = "|".join(sorted([word for side in told.values() for word in side], key=lambda word: -len(word)))
    return tuple(
        (re.compile(pattern.replace("{comparative}", f"(?:{words})"), re.IGNORECASE), first, second)
        for pattern, first, second in rules
    )


@cache
def pairs(language: str) -> tuple[tuple[re.Pattern[str], str], ...]:
    """Patterns for what stands for two things, and how it is said of them by their names."""
    rules = cast("list[list[str]]", _file(language)["several"]["pairs"])
    return tuple((re.compile(pattern, re.IGNORECASE), written) for pattern, written in rules)


@cache
def counted_by(language: str) -> dict[str, int]:
    """Words that say how many things are meant."""
    table = _file(language)["several"]
    return {word: n for n, what in ((2, "two"), (3, "three"), (4, "four")) for word in table[what]}


@lru_cache(_MANY)
def is_adjective(token: str, language: str) -> bool:
    """Whether a word looks like an adjective, by its ending, that does not tell a thing from another of its kind."""
    table = _file(language)["adjectives"]
    is_like = token in table.get("whole", ()) or token.endswith(tuple(table["endings"]))
    telling = (*table["telling"], *_file(ENGLISH)["adjectives"]["telling"])  # into whose words others are put
    return is_like and not changes_value(token, language) and not any(_is_word(word, token) for word in telling)


@lru_cache(_MANY)
def is_adverb(token: str, language: str) -> bool:
    """Whether a word looks like an adverb of manner, which does not say where or how much."""
    table = _file(language)["adverbs"]
    return token.endswith(tuple(table["endings"])) and not any(_is_word(word, token) for word in table["telling"])


@lru_cache(_MANY)
def changes_value(token: str, language: str) -> bool:
    """Whether a word before a value makes it another one: the double load."""
    return any(_is_word(word, token) for word in _file(language)["values"]["changed"])


def tells_apart(token: str, language: str) -> bool:
    """Whether a word says which of several things, or how much of a quantity, is meant: what is dropped by none."""
    telling = (*_file(language)["adjectives"]["telling"], *_file(language)["adverbs"]["telling"])
    is_counted = token in numbered() or token in compared()
    return is_counted or changes_value(token, language) or any(_is_word(word, token) for word in telling)


def places(token: str, language: str) -> bool:
    """Whether a word behind an article says where a thing is, though it may be a verb elsewhere: the lower rope."""
    return token in _file(language)["adjectives"].get("placing", ())


@cache
def translated(language: str) -> dict[str, str]:
    """What things are called in a language, and in English: the commonest word first, others behind bars."""
    return cast("dict[str, str]", _file(language).get("nouns", {}))


@cache
def endings(language: str) -> str:
    """The endings of nouns, as a pattern."""
    return str(_file(language).get("endings", {}).get("nouns", ""))


@cache
def umlauts(language: str) -> dict[str, str]:
    """Letters of a plural that are others in the singular."""
    return dict(_file(language).get("endings", {}).get("umlauts", {}))


@cache
def digraphs(language: str) -> dict[str, str]:
    """Pairs of letters that are written for a letter of the language: ae for ä."""
    return dict(_file(language).get("endings", {}).get("digraphs", {}))


@cache
def ruled(language: str) -> frozenset[str]:
    """The words that rules of spelling know."""
    rules = cast("list[list[str]]", _file(language)["spelling"]["rules"])
    return frozenset(word.lower() for rule in rules for word in re.findall(r"[^\W\d_]+", rule[0]))


def is_in_language(word: str) -> bool:
    """Whether a phrase, or a rule of spelling, of any language has a word."""
    return any(word in vocabulary(language) or word in ruled(language) for language in languages())


@cache
def plurals(language: str) -> tuple[tuple[str, str], ...]:
    """The endings of plurals of quantities, and what stands in their place in the singular."""
    return tuple(dict(_file(language).get("endings", {}).get("quantities", {})).items())


@cache
def no_nouns(language: str) -> tuple[str, ...]:
    """What looks like a noun with an ending."""
    return tuple(_file(language).get("endings", {}).get("verbs", ()))


@cache
def said_of_quantity(language: str) -> dict[str, str]:
    """First parts of words that are written as one with a quantity, and what they say of it."""
    return cast("dict[str, str]", _file(language).get("compounds", {}).get("of_quantity", {}))


@cache
def silent_of_thing(language: str) -> frozenset[str]:
    """First parts of words for things that say no more of a thing than its kind."""
    return frozenset(_file(language).get("compounds", {}).get("of_thing", {}).get("silent", ()))


@cache
def owned(language: str) -> dict[str, str]:
    """Words for things that are quantities where something has them, and what these are called."""
    return dict(_file(language).get("compounds", {}).get("owned", {}))


@cache
def quantity_words(language: str) -> frozenset[str]:
    """Single words for quantities."""
    said = (text for own in tables(language)["quantity"].values() for phrase in own for text in spelt_out(phrase))
    return frozenset(text for text in said if text and " " not in text and "*" not in text)


@cache
def symbols(language: str) -> dict[str, tuple[str, ...]]:
    """Words for the symbols of quantities, those that may stand before them behind the first."""
    return {symbol: tuple(words) for symbol, words in _file(language)["symbols"].items()}


@cache
def signs(language: str) -> dict[str, str]:
    """What symbols mean as a whole."""
    return dict(_file(language).get("signs", {}))


@cache
def indices(language: str, where: str) -> dict[str, str]:
    """What indices say that stand for no thing, `before` or `behind` the quantity."""
    return dict(_file(language).get("indices", {}).get(where, {}))


def ratios(language: str) -> str:
    """How the ratio of two quantities is said."""
    return str(_file(language).get("indices", {})["ratio"])


def mass_center(language: str) -> str:
    """What a mass centre is called."""
    return next(text for phrase in tables(language)["pronoun"]["mass_center"] for text in spelt_out(phrase))


@cache
def assumptions(language: str) -> dict[str, str]:
    """Patterns for clauses that assume something, by what it is."""
    return cast("dict[str, str]", _file(language)["assumptions"])


@cache
def unit_words(language: str) -> dict[str, str]:
    """How units, and what joins them, are said, by how they are written."""
    said = cast("dict[str, list[str]]", _file(language)["units"])
    return {word: unit for unit, words in said.items() for word in words}


@cache
def numerals(language: str, what: str) -> dict[str, float]:
    """Numbers in words: `counts`, and `parts` of one."""
    return dict(_file(language).get("numerals", {}).get(what, {}))


@cache
def values_stated(language: str) -> dict[str, str]:
    """Patterns for values that are said in passing, by how they are said."""
    return cast("dict[str, str]", _file(language)["stated"])


@cache
def compared_in(language: str, table: str) -> dict[str, Any]:
    """Patterns for what is compared, and what comparatives are compared in. Nothing where a language has none."""
    own = cast("dict[str, Any]", _file(language).get(table, {}))
    return {**cast("dict[str, Any]", _file(language).get("comparatives", {})), **own} if own else {}


@cache
def comparing(language: str, table: str, key: str, k: int | None = None) -> re.Pattern[str]:
    """One of these patterns, with words for what stands in it for several. k: which of a list."""
    told = compared_in(language, table)
    written: Any = told[key] if k is None else told[key][k]
    written = str(written if isinstance(written, str) else written[0])
    while (place := re.search(r"\{([a-z]+)\}", written)) is not None:
        words: str | dict[str, str] = told[place[1]]
        listed = words if isinstance(words, str) else "|".join(sorted(words, key=len, reverse=True))
        written = f"{written[: place.start()]}{listed}{written[place.end() :]}"
    return re.compile(written, re.IGNORECASE)


@cache
def restatements(language: str) -> tuple[tuple[re.Pattern[str], str], ...]:
    """Patterns for what is said otherwise than it is asked for elsewhere, and how it is asked for."""
    return _rules(language, "restated")


@cache
def recastings(language: str) -> tuple[tuple[re.Pattern[str], str], ...]:
    """Patterns for constructions that are not understood as they stand, and plainer ones."""
    return _rules(language, "recast")


def _rules(language: str, table: str) -> tuple[tuple[re.Pattern[str], str], ...]:
    """The rules of a table, with what its other entries stand for in them."""
    told = cast("dict[str, Any]", _file(language).get(table, {}))
    n_rules = len(told.get("rules", ()))
    return tuple((comparing(language, table, "rules", k), str(told["rules"][k][1])) for k in range(n_rules))


@cache
def contexts(language: str) -> dict[str, str]:
    """Patterns for what stands before a question, and for what says of an instant no more than itself: at_once."""
    return cast("dict[str, str]", _file(language)["contexts"])


@cache
def measured_in(word: Word) -> tuple[str, ...]:
    """What a quantity, or a question word that stands for one, can be measured in: dimensions by their names."""
    table = cast("dict[str, dict[str, list[str]]]", _file(ENGLISH)["measured"]).get(word.kind, {})
    return tuple(dimension for dimension, whats in table.items() if word.what in whats)


@cache
def numbered() -> dict[str, str]:
    """Words for the first, the second, in all languages."""
    return {
        word: number
        for language in languages()
        for number, words in cast("dict[str, list[str]]", _file(language).get("numbered", {})).items()
        for word in words
    }


@cache
def compared() -> dict[str, str]:
    """Words for the heavier, the lighter of two, in all languages."""
    return {
        word: what
        for language in languages()
        for what, words in cast("dict[str, list[str]]", _file(language).get("compared", {})).items()
        for word in words
    }


@cache
def things_alike() -> tuple[frozenset[str], ...]:
    """Words for things of one kind."""
    return tuple(frozenset(cast("list[str]", words)) for words in _file(ENGLISH)["things"]["alike"])


@cache
def things() -> frozenset[str]:
    """Words for things that are bodies, or hold them."""
    held = cast("list[str]", _file(ENGLISH)["things"]["held"])
    return frozenset[str]().union(held, *kinds_apart(), *things_alike())


@cache
def leading() -> frozenset[str]:
    """Words for what leads something round: a track, which a file may describe as a link."""
    return frozenset(cast("list[str]", _file(ENGLISH)["things"]["leading"]))
