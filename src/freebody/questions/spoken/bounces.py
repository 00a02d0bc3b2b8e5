"""What is asked of an impact by its number: how high it gets after ten bounces, nach dem zehnten Aufprall.

The words of people know the first five impacts. A later one is read as the third is, and then put in its place; the
grammar reads it by its number (`nth_impact`)."""

from __future__ import annotations

import re

_EN = ("two", "three", "four", "five", "six", "seven", "eight", "nine", "ten", "eleven", "twelve")
_DE = ("zwei", "drei", "vier", "fünf", "sechs", "sieben", "acht", "neun", "zehn", "elf", "zwölf")
_NUMBERS = {word: n for words in (_EN, _DE) for n, word in enumerate(words, 2)}
_NUMBERS |= {"twice": 2, "zweimal": 2, "dreimal": 3, "viermal": 4, "fünfmal": 5, "zehnmal": 10}
_ORDINALS = ("sixth", "seventh", "eighth", "ninth", "tenth", "eleventh", "twelfth")
_NUMBERS |= {word: n for n, word in enumerate(_ORDINALS, 6)}
_NUMBERS |= {f"{word}ten": n for n, word in enumerate(_DE, 2) if n > 5} | {"siebten": 7, "achten": 8}
_IMPACTS = r"(?:impacts|bounces|collisions|hits|rebounds)"
_AUFPRALLE = r"(?:aufprallen|aufschlägen|stößen|stössen|sprüngen|aufprallern|mal aufprallen)"
_AUFPRALL = r"(?:aufprall|aufschlag|stoß|stoss|sprung)"
_BOUNCED = r"(?:bounced|rebounded|bounces|(?:hit|touched|struck|hits) the (?:ground|floor|table))"
_AUFGEPRALLT = (
    r"(?:(?:auf dem|auf den) \w+ )?(?:aufgeprallt|aufgeschlagen|aufgesprungen|aufgekommen|abgeprallt)(?: ist)?\b"
)
_ALL = "|".join(sorted(_NUMBERS, key=len, reverse=True))
_SAID = (
    (rf"\bafter (?:the )?(?P<n>{_ALL}|\d+) {_IMPACTS}\b", "after the third impact"),
    (rf"\bafter (?:the |its )?(?P<n>{_ALL}|\d+(?=th|st|nd|rd))(?:th|st|nd|rd)? (?:bounce|impact|hit|rebound)\b",
     "after the third impact"),
    (rf"\bafter (?:it|they|(?:the )?\w+) (?:has |have |had )?{_BOUNCED} "
     rf"(?P<n>twice|(?:{_ALL}|\d+)(?= times))(?: times)?\b", "after the third impact"),
    (rf"\b(?:nachdem|wenn|sobald) (?:er|sie|es|(?:der|die|das) \w+) (?P<n>\w+mal|(?:{_ALL}|\d+)(?= Mal))(?: Mal)? "
     rf"{_AUFGEPRALLT}", "nach dem dritten Aufprall"),
    (rf"\bnach (?P<n>{_ALL}|\d+) {_AUFPRALLE}\b", "nach dem dritten Aufprall"),
    (rf"\bnach (?:dem|seinem) (?P<n>{_ALL}|\d+(?=\.))\.? {_AUFPRALL}\b", "nach dem dritten Aufprall"),
)  # fmt: skip
_COUNTED = r"(?:first|second|third|fourth|fifth|\d+(?:st|nd|rd|th))"
_BETWEEN = (
    rf"how much later (?:does|is|will|do) (?:the )?(?P<b>{_COUNTED}) (?:impact|bounce|hit|rebound|landing)"
    rf"(?: (?:come|comes|occur|happen|follow|take place|be))? (?:than|after) (?:the )?(?P<a>{_COUNTED})"
    r"(?: (?:one|impact|bounce|hit|rebound|landing))?[?. ]*",
    r"(?:how long(?: (?:is it|does it take|is there|(?:is|does|will) (?:the )?\w+ (?:stay |be )?"
    r"(?:in the air|airborne|in flight)))?|(?:how much |what )?(?:is the |the )?(?:time|interval))"
    rf"(?: (?:passes|elapses|goes by|lies|is there))? (?:between|from) (?:the |its )?(?P<a>{_COUNTED})"
    r"(?: (?:impact|bounce|hit|rebound|landing))? (?:and|to|until|till) (?:the |its )?"
    rf"(?P<b>{_COUNTED}) (?:impact|bounce|hit|rebound|landing)[?. ]*",
    r"(?:wie lange dauert es|(?:wie ?viel |welche |die )?zeit)(?: (?:vergeht|liegt))? "
    rf"(?:zwischen (?:dem )?|vom )(?P<a>\w+t)en(?: {_AUFPRALL})? (?:und|bis zum)(?: dem)? "
    rf"(?P<b>\w+t)en {_AUFPRALL}[?. ]*",
)
_ERSTER = {"ers": "first", "zwei": "second", "drit": "third", "vier": "fourth", "fünf": "fifth"}
_THIRD = re.compile(r"\bafter (?:the )?third (?:impact|blow|bounce)\b")
_FIRST_FIVE = ("first", "second", "third", "fourth", "fifth")


def as_third(text: str) -> tuple[str, int] | None:
    """A text with the third impact in place of the one that is counted in it, and the number of that."""
    for pattern, third in _SAID:
        if (found := re.search(pattern, text, re.IGNORECASE)) is not None:
            said = found["n"].lower()
            n = int(said) if said.isdigit() else _NUMBERS.get(said, 0)
            return (f"{text[: found.start()]}{third}{text[found.end() :]}", n) if n > 0 else None
    return None


def at_nth(words: str, n: int) -> str | None:
    """Words of the grammar with the n-th impact in place of the third; None where they do not name it once."""
    nth = _FIRST_FIVE[n - 1] if n <= len(_FIRST_FIVE) else f"{n}th"
    put, times = _THIRD.subn(f"after the {nth} impact", words)
    return put if times == 1 else None


def between_impacts(text: str) -> str | None:
    """In words of the grammar the time between two impacts that are counted."""
    for pattern in _BETWEEN:
        if (found := re.fullmatch(pattern, text, re.IGNORECASE)) is not None:
            one, other = (_ERSTER.get(said.lower().removesuffix("t"), said.lower()) for said in found.group("a", "b"))
            return f"time between the {one} and {other} impact"
    return None
