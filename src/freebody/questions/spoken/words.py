"""A text as what its words mean, one after the other: names, values, and words of the lexicon."""

from __future__ import annotations

import difflib
import re
from collections.abc import Container, Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from functools import lru_cache
from itertools import accumulate

from freebody.errors import UnitError
from freebody.language.units.reader import parse_unit
from freebody.questions.spoken.compounds import in_english_nouns
from freebody.questions.spoken.lexicon import (
    MARKED,
    Word,
    changes_value,
    digraphs,
    goes_beside,
    is_adjective,
    is_adverb,
    languages,
    phrases_at,
    places,
    plurals,
    quantity_words,
    ruled,
    spelt,
    tells_apart,
    translated,
    umlauts,
    vocabulary,
)
from freebody.questions.spoken.naming import plain_names

_NUMBER = r"\d+(?:\.\d+)?(?:e[+-]?\d+)?"
_FACTOR = r"(?: (?:[kcm]?[mgsNJW]|rad)(?:\^?[23]|[²³])?(?:/[a-z]+(?:\^?[23]|[²³])?)*(?![\w’'«(]))"  # 20 N m
_UNIT = rf"(?: ?(?:[A-Za-zµ°%Ω][\w/^*²³·«»]*){_FACTOR}*)"
_OPERAND = rf"(?:{_NUMBER}|{MARKED}|[a-z]+\([^()]*\)|\([^()]*\)|pi\b)"
_TOKEN = re.compile(
    rf"(?P<rate>rate\({MARKED}\))"
    rf"|(?P<formula>-?{_OPERAND}(?: ?(?:[*/^+]|- ) ?-?{_OPERAND})+|-{MARKED}|-?pi\b)"
    rf"|(?P<name>{MARKED})"
    rf"|(?P<number>-?{_NUMBER})(?P<unit>{_UNIT})?"
    r"|(?P<relation>->|→|<=|>=|≤|≥|=|<|>)"
    r"|(?P<axis>[^\W\d]\w*\.[xyz]\b)"
    r"|(?P<word>’s|[^\W\d_][\w’-]*|,)"
    r"|(?P<other>\S)",
    re.IGNORECASE,
)
_SIGNS = {"≤": "<=", "≥": ">=", "→": "->"}
_ARTICLES = ("the", "a", "an")
_BARE = ("verb", "filler")  # kinds of words that no adjective is
_NO_WORD = "\0"  # stands for names, values and words that are taken
_TURNS = re.compile(r"(?:turn|revolution|rotation|umdrehung|rev)", re.IGNORECASE)
_LEAST_LIKE = 0.8  # of a word to one that is misspelt
_SHORTENED = re.compile(r"(?<![\w-])(?P<first>[^\W\d_]{2,})- (?P<joint>und|oder|and|or) (?P<second>[^\W\d_]{5,})")
_NO_UNITS = ("", "in", "a", "as", "at")
_KEYBOARD = ("qwertyuiop", "qwertzuiopü", "asdfghjklöä", "zxcvbnm", "yxcvbnm")
_MANY = 1 << 12  # texts whose words are kept
_LONG = 9  # letters of a word in which two may be wrong
_SHORTEST = 5  # letters of a word that may be misspelt
_UNSLIPPED = 2  # letters of one in which none have changed places


class _Said(str):
    """A word of a text in lower case."""

    is_capital: bool = False


@dataclass(frozen=True)
class Unknown(Exception):
    """Words that a language does not have. known: the others."""

    words: tuple[str, ...]
    known: tuple[Word, ...]


@dataclass
class Clause:
    """What the words of a clause mean, by kind, in their order; whoever uses a word takes it, so that none is lost.

    names, values: each with the preposition before it."""

    words: list[Word] = field(default_factory=list[Word])

    def all(self, kind: str) -> list[str]:
        return [word.what for word in self.words if word.kind == kind]

    def has(self, kind: str, *whats: str) -> bool:
        return any(word.kind == kind and (not whats or word.what in whats) for word in self.words)

    def without(self, kind: str, *whats: str) -> Clause:
        """The clause without words of a kind (and meaning)."""
        return Clause([w for w in self.words if not (w.kind == kind and (not whats or w.what in whats))])

    def only(self, *kinds: str) -> bool:
        """Whether nothing else than words of some kinds is left."""
        return all(word.kind in kinds for word in self.words)

    def placed(self, kind: str) -> list[tuple[str, str]]:
        """Names or values, each with the preposition before it."""
        found: list[tuple[str, str]] = []
        before = ""
        for word in self.words:
            if word.kind in ("preposition", "updown"):
                before = "on" if word.what == "to" else word.what
            elif word.kind == kind:
                found.append((before, word.what))
                before = ""
            elif word.kind != "filler":
                before = ""
        return found

    @property
    def names(self) -> list[tuple[str, str]]:
        return self.placed("name")

    @property
    def values(self) -> list[tuple[str, str]]:
        return self.placed("value")


def words_of(text: str, language: str, *, guess: bool = False, parameters: Iterable[str] = ()) -> list[Word]:
    """The words of a text in which names are marked. Raises Unknown for those that the language does not have, unless
    one alone is to be taken for a name (guess). parameters: names before which a word only says what they are."""
    found = _read(text, language, guess, frozenset(parameters))
    if isinstance(found, Unknown):
        raise found
    return [*found]


@lru_cache(_MANY)
def _read(text: str, language: str, guess: bool, parameters: frozenset[str]) -> tuple[Word, ...] | Unknown:
    """The words of a text, or those that the language does not have: a part of it may be tried in many questions."""
    found = _without_parentheses(list(_tokens(spelt(text, language))), language)
    tokens = [token if isinstance(token, str) else _NO_WORD for token in found]
    words: list[Word] = []
    unknown: list[str] = []
    for k, token in enumerate(found):
        if not isinstance(token, str):
            words.append(token)
            continue
        if tokens[k] == _NO_WORD or _is_beside_name(token, found, k, language):
            continue  # it belongs to a phrase before, or says no more than a name
        if token.endswith("ing") and _is_after_article(found, k) and _describes(found, k, language):
            continue  # the hauling rope
        line, begins = " ".join(tokens), list(accumulate((len(t) + 1 for t in tokens), initial=0))
        meant = [] if _is_letter(token) and k > 0 else phrases_at(line, begins[k], language)
        meant = meant or _of_singular(line, begins[k], token, language)
        is_telling = _is_after_article(found, k) and (  # the lower rope is lowered by none, and the hoist no verb
            places(token, language) or (not token.endswith("ing") and any(m[0] == _SYSTEM for m in meant))
        )
        is_telling |= found[k - 1 : k] == ["of"] and any(m[0] == _SYSTEM for m in meant)
        means = next((m for m in meant if _fits(m[0], words) and not (is_telling and m[0].kind in _BARE)), None)
        if means is None and (
            _describes(found, k, language) or is_adverb(token, language) or _is_title(found, k, language, parameters)
        ):
            continue
        if means is None:
            last = next((word for word in reversed(words) if word.kind != "filler"), None)
            is_placed = last is not None and last.kind == "preposition"
            unknown += [token] if is_placed else [token, token]  # behind `of` or `in` stands something
            words.append(Word("name", token))
            continue
        for place in means[1]:
            tokens[begins.index(place)] = _NO_WORD
        words.append(means[0])
    if unknown and not (guess and len(unknown) == 1):
        strange = {Word("name", token) for token in unknown}
        return Unknown(tuple(unknown), tuple(word for word in words if word not in strange))
    return tuple(words)


def _of_singular(line: str, begin: int, token: str, language: str) -> list[tuple[Word, tuple[int, ...]]]:
    """What an unknown word means that is the plural of a quantity, with the words behind it: periods, Seilkräfte."""
    singulars = (f"{token[: -len(end)]}{put}" for end, put in plurals(language) if token.endswith(end))
    for one in dict.fromkeys(word for said in singulars for word in _without_umlaut(said, language)):
        found = (
            []
            if len(one) < _SHORTEST
            else phrases_at(f"{line[:begin]}{one}{line[begin + len(token) :]}", begin, language)
        )
        alone = [meant for meant in found if meant[0].kind == "quantity" and len(meant[1]) == 1]
        if alone:
            return alone
    return []


def _without_umlaut(word: str, language: str) -> list[str]:
    """A word, and what it is without the other letters of a plural: kräft, kraft."""
    plain = word
    for letter, own in umlauts(language).items():
        plain = plain.replace(letter, own)
    return [word, plain]


def _is_after_article(found: Sequence[str | Word], k: int) -> bool:
    return k > 0 and found[k - 1] in _ARTICLES


def _is_letter(token: str) -> bool:
    """Whether a word is a capital letter but I: the point A, which is no article."""
    return isinstance(token, _Said) and len(token) == 1 and token.is_capital and token != "i"


def _is_beside_name(token: str, found: Sequence[str | Word], k: int, language: str) -> bool:
    """Whether a word only says what a name beside it is: planet P1, the hanging weight, the left side."""
    after = found[k + 1] if k + 1 < len(found) else ""
    before = found[k - 1] if k else ""
    return (isinstance(after, Word) and after.kind == "name" and goes_beside(token, "before", language)) or (
        isinstance(before, Word) and before.kind == "name" and goes_beside(token, "behind", language)
    )


def _is_title(found: Sequence[str | Word], k: int, language: str, parameters: Container[str]) -> bool:
    """Whether an unknown word only says what the parameter behind it is: the delay tau, but not the double force F."""
    token, after = found[k], found[k + 1] if k + 1 < len(found) else ""
    is_parameter = isinstance(after, Word) and after.kind == "name" and after.what in parameters
    is_beside = isinstance(after, _Said) and goes_beside(after, "before", language)  # the integral gain k_i
    is_parameter |= is_beside and _is_title(found, k + 1, language, parameters)
    return isinstance(token, _Said) and len(token) > 2 and is_parameter and not changes_value(token, language)


_SYSTEM = Word("pronoun", "system")
_OPEN, _SHUT = Word("other", "("), Word("other", ")")


def _without_parentheses(found: list[str | Word], language: str) -> list[str | Word]:
    """`the motor (engine)` is called engine, `(theta = 90 deg)` says when."""
    kept: list[str | Word] = []
    k = 0
    while k < len(found):
        inside = found[k + 1 : k + 5]
        if found[k] == _OPEN and inside[1:2] == [_SHUT] and isinstance(inside[0], Word) and inside[0].kind == "name":
            before = kept[-1] if kept else ""
            if (isinstance(before, Word) and before.kind == "name") or (
                isinstance(before, _Said) and not phrases_at(before, 0, language)
            ):
                kept.pop()  # the name says what it is
            kept.append(inside[0])
            k += 3
        elif found[k] == _OPEN and inside[3:4] == [_SHUT] and inside[1] == Word("relation", "="):
            kept += [Word("preposition", "in"), *inside[:3]]
            k += 5
        else:
            kept.append(found[k])
            k += 1
    return kept


def _describes(found: Sequence[str | Word], k: int, language: str) -> bool:
    """Whether an unknown word is an adjective before a name that does not tell it from another: the supporting rope."""
    token = found[k]
    if not isinstance(token, _Said) or not is_adjective(token, language) or (token.is_capital and k > 0):
        return False
    if any(phrases_at(token, 0, other) for other in languages() if other != language):
        return False  # a word of another language, however it ends: average, torque, over
    after = found[k + 1] if k + 1 < len(found) else ""
    is_thing = isinstance(after, Word) and after.kind == "name"
    is_all = isinstance(after, _Said) and any(word == _SYSTEM for word, _ in phrases_at(after, 0, language))
    is_article = isinstance(after, _Said) and any(word.kind == "filler" for word, _ in phrases_at(after, 0, language))
    return is_thing or is_all or (k + 1 < len(found) and not is_article and _describes(found, k + 1, language))


def _tokens(text: str) -> Iterator[str | Word]:
    """Words to be looked up, and what is none: names, values, signs."""
    at = 0
    while at < len(text):
        found = _TOKEN.match(text, at)
        if found is None:
            at += 1
            continue
        at = found.end()
        if found["word"]:
            said = _Said(found["word"].lower())
            said.is_capital = found["word"][0].isupper()
            owner = said.removesuffix("’s")
            if owner and owner != said:  # the system’s momentum
                yield from (_Said(owner), _Said("’s"))
            else:
                yield said
        elif found["name"] or found["rate"] or found["axis"]:
            yield Word("name", plain_names(found[0]))
        elif found["relation"]:
            yield Word("relation", _SIGNS.get(found[0], found[0]))
        elif found["number"] is None:
            yield Word("value" if found["formula"] else "other", plain_names(found[0]))
        else:
            said_unit = found["unit"] or ""
            while " " in said_unit.strip() and not _is_unit(plain_names(said_unit).strip()):
                said_unit = said_unit.rpartition(" ")[0]  # 5 s m is said of 5 s
            at, unit = found.end("number") + len(said_unit), plain_names(said_unit).strip()
            if _TURNS.match(unit):
                yield Word("turns", found["number"])
            elif unit in _NO_UNITS or not _is_unit(unit):
                yield Word("value", found["number"])
                at = found.end("number")
            else:
                yield Word("value", f"{found['number']} {unit}")


def _fits(word: Word, before: list[Word]) -> bool:
    """Whether a word can stand behind others: one asks where a sentence begins."""
    return word.kind != "ask" or all(w.kind in ("filler", "ask") for w in before) or _is_new_start(before)


def _is_new_start(before: list[Word]) -> bool:
    """Whether a main clause may begin: behind a comma, or an `and`, where it is one too many."""
    last = next((w for w in reversed(before) if w.kind != "filler"), None)
    return last in (Word("preposition", ","), Word("preposition", "and"))


def _is_unit(text: str) -> bool:
    try:
        parse_unit(text)
    except UnitError:
        return False
    return True


def _are_neighbours(one: str, other: str) -> bool:
    """Whether two letters lie side by side on a keyboard."""
    return any(one in row and other in row and abs(row.index(one) - row.index(other)) == 1 for row in _KEYBOARD)


def _is_slip(word: str, meant: str) -> bool:
    """Whether one letter is missing, too much or another, or two have changed places; two such in a long word."""
    blocks = difflib.SequenceMatcher(None, word, meant, autojunk=False).get_opcodes()
    others = [(word[a:b], meant[c:d]) for kind, a, b, c, d in blocks if kind == "replace"]
    if any(len(one) != len(other) or not all(map(_are_neighbours, one, other)) for one, other in others):
        return sorted(word) == sorted(meant) and len(others) <= 1  # Ausschlag is no Aufschlag
    slips = sum(max(b - a, d - c) for kind, a, b, c, d in blocks if kind != "equal")
    is_swapped = sorted(word) == sorted(meant) and slips == 2
    return slips <= 1 + (len(word) >= _LONG) or is_swapped


def _is_thing(word: str) -> bool:
    """Whether a word is what a thing is called in some language."""
    return any(word.lower() in translated(own) or in_english_nouns(word, own) != word for own in languages())


def _with_letters_in_order(word: str, words: Container[str]) -> str:
    """A short word of which two letters beside each other have changed places, or the word as it is."""
    swapped = {f"{word[:k]}{word[k + 1]}{word[k]}{word[k + 2 :]}" for k in range(len(word) - 1)}
    right = [other for other in sorted(swapped) if other in words]
    return right[0] if len(right) == 1 else word


def written_out(text: str) -> str:
    """The text with a word that ends with the next one written out: Vorder- und Hinterachse."""

    def told(found: re.Match[str]) -> str:
        first, joint, second = found["first"], found["joint"], found["second"]
        whole = (first + second[k:] for k in range(2, len(second) - 2))
        meant = next(
            (word for word in whole if _is_thing(word) or any(word.lower() in vocabulary(own) for own in languages())),
            None,
        )
        return found[0] if meant is None else f"{meant} {joint} {second}"

    return _SHORTENED.sub(told, text) if "- " in text else text


def in_own_letters(text: str, language: str, taken: Container[str]) -> str:
    """The text with waehrend as während, where that is a word of the language, and waehrend is none.

    taken: words for what the model has."""

    def told(found: re.Match[str]) -> str:
        put = word = found[0]
        for pair, letter in digraphs(language).items():
            put = put.replace(pair, letter).replace(pair.capitalize(), letter.upper())
        said = put.lower().replace("ß", "ss")
        is_own = word.lower() in taken or word.lower() in vocabulary(language) or _is_thing(word)
        is_word = said in vocabulary(language) or said in ruled(language) or _is_thing(put)
        return word if put == word or is_own or not (is_word or phrases_at(said, 0, language)) else put

    return re.sub(r"(?<![\w.])[^\W\d_]+(?![\w.(])", told, text) if digraphs(language) else text


def respelt(text: str, language: str, taken: Container[str]) -> str:
    """The text with misspelt words of the language put right, where each is like one word alone.

    taken: words for what the model has; they are never put in, for a name is not guessed."""
    words = vocabulary(language)

    def right(found: re.Match[str]) -> str:
        word = found[0].lower()
        is_known = any(word in vocabulary(own) for own in languages())  # least is no slip of Last
        if is_known or word in taken or _is_thing(found[0]):
            return found[0]
        if len(word) < _SHORTEST:
            return _with_letters_in_order(word, words) if len(word) > _UNSLIPPED else found[0]
        if any(tells_apart(word.replace("ß", "ss"), own) for own in languages()):  # the half: no slip of a filler
            return found[0]
        near = difflib.get_close_matches(word, words, n=3, cutoff=_LEAST_LIKE)
        right = [other for other in near if (other[0], other[-1]) == (word[0], word[-1]) and _is_slip(word, other)]
        is_guessed = right[:1] != [] and right[0] in taken and right[0] not in quantity_words(language)
        return right[0] if right and not is_guessed else found[0]

    return re.sub(r"(?<!\w)[^\W\d_]+(?![\w'’])", right, text)
