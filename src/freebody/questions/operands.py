"""What a question that calculates is made of: operators, quantities, and when each quantity is meant."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from freebody.errors import UnitError
from freebody.language.expression import FUNCTIONS
from freebody.language.sentences import Message
from freebody.language.units import parse_quantity
from freebody.language.units.quantity import Quantity as Number
from freebody.model.phrases import PHRASES
from freebody.questions.base import Quantity
from freebody.questions.ends import GREATEST, LEAST
from freebody.questions.forms import FORMS

if TYPE_CHECKING:
    from freebody.model.names import Names

_EVENTS = (" when ", " until ", " to reach ")
_SIZE = re.compile(r"^(?:the )?(?:size|magnitude|absolute value) of (?:the )?")
_START = re.compile(r" at (?:the )?start$")
_OPERATOR_SIGNS = {"+", "-", "*", "**", "/", "^", "(", ")", "|"}
_BEFORE_UNITS = _OPERATOR_SIGNS - {"/", "^"}  # what no unit contains
TIME_ALONE = re.compile(r"(?:the )?time")  # of an event
_PLAIN = re.compile(r"\d+(?:\.\d+)?(?:[eE]\d+)?|[A-Za-z_]\w*")
TURNS_BACK = re.compile(r"^(?P<what>.+?) (?:turns (?:back|round|around)|reverses)$")  # an event
_RATIO = re.compile(r"^(?:the )?ratio of (?P<top>.+) to (?:the )?(?P<bottom>.+)$")

# what belongs to a quantity stands before what is an operator: greatest |acceleration of x|, rate(x), [1, 0], and the
# place of a section, at L/2 from beam.start
_OPERATORS = re.compile(
    rf"(?:{GREATEST}|{LEAST}) (?:value )?(?:of )?(?:the )?\|[^|]*\||rate\(\s*\w+\s*\)|\[[^\]]*\]"
    r"|\bat (?:(?! at | of )[^|=])+? from (?:the )?(?:\w+\.)?(?:start|end)\b|\*\*|[-+*/^()|]"
)
_END = re.compile(rf"(?:the )?(?:{GREATEST}|{LEAST}) ")
_OF_BLOW = re.compile(r"\b(?:energy lost|loss of (?:kinetic )?energy) in\b|\bimpuls(?:e|ive reaction)\b")
_OF_WHOLE = re.compile(rf"(?:the )?(?:{GREATEST}|{LEAST}) (?:value )?(?:of )?\(")  # least (x2 - x1)
_UNTIL = re.compile(rf"^(?P<end>(?:the )?(?:{GREATEST}|{LEAST}) )(?:value )?(?:of )?(?P<of>.+)(?P<until> until .+)$")


@dataclass(frozen=True)
class Operand:
    """A quantity in words, and what is said of when it is meant."""

    phrase: str
    condition: str | None = None
    at_start: bool = False


@dataclass(frozen=True)
class Operands:
    """A text as runs: operators, and what stands between them. phrases: those that are quantities, by their place."""

    runs: tuple[str, ...]
    phrases: Mapping[int, Operand]


def without_start(phrase: str) -> str:
    return _START.sub("", phrase)


def without_size(phrase: str) -> str:
    """A phrase without the words that ask for a size."""
    return _SIZE.sub("", phrase)


def ratio_as_quotient(names: Names, phrase: str, is_vector: Callable[[str], bool]) -> str:
    """The ratio of what is calculated, or is meant at different instants, by a sign of division; of a vector the size.
    is_vector: whether a part asks for one."""
    found = _RATIO.match(phrase)
    if found is None or not _is_of_quantities(phrase):
        return phrase
    top, bottom = found["top"], found["bottom"]
    is_timed = _START.search(top) is not None or any(word in top for word in _EVENTS)
    if _OF_BLOW.search(top) or _END.match(top):  # no state has it: what is said of an instant is said of the other
        is_timed = is_timed or _START.search(bottom) is not None or any(word in bottom for word in _EVENTS)
    is_calculated = any(not _is_quantity(names, event_at_end(names, part)[0]) for part in (top, without_start(bottom)))
    if is_calculated and not is_timed:  # what is said of an instant is said of all of it
        plain = without_start(event_at_end(names, bottom)[0])
        above, below = (f"|{part}|" if is_vector(part) else f"({part})" for part in (top, plain))
        return f"{above}/{below}{bottom[len(plain) :]}"
    return f"({top})/({bottom})" if is_timed or is_calculated else phrase


def _is_of_quantities(phrase: str) -> bool:
    """Whether a ratio is one of two quantities, and not of what the words of a form of its own say."""
    form = next((f for f in FORMS if f.pattern.match(phrase)), None)
    return form is None or {"top", "bottom"} <= form.pattern.groupindex.keys()


def event_at_end(names: Names, phrase: str) -> tuple[str, str | None]:
    """A phrase without the event at which all of it is meant, and that event; none where more quantities follow."""
    for word in _EVENTS:
        if word in phrase:
            head, _, tail = phrase.partition(word)
            is_whole = head.count("(") == head.count(")") and not _goes_on(names, tail)
            return (head, tail) if is_whole else (phrase, None)
    return phrase, None


def _goes_on(names: Names, tail: str) -> bool:
    """Whether behind an event one goes on to calculate: with a further quantity, behind a value of zero, as in `tension
    of rod when theta = 0 / (m*g)`, or behind an event without a value."""
    if (turns := TURNS_BACK.match(tail)) is not None and _is_of_measures(names, turns["what"]):
        return False
    has_value = re.search(r"=|\breaches\b|\bequals\b|\bis\b|\bby\b|\bmove[ds]\b", tail)
    if re.search(r"=\s*0\s*[-+*/^]", tail) or (has_value is None and len(_runs_of(tail)) > 1):
        return True
    behind = tail if has_value is None else tail[has_value.end() :]  # what stands before is what the event is of
    found = _operands(names, behind)
    first = next((k for k, run in enumerate(found.runs) if run not in _OPERATOR_SIGNS), 0)
    is_of_words = has_value is not None and " " in tail[: has_value.start()].strip()
    for k, operand in found.phrases.items():
        if " " in operand.phrase and _is_quantity(names, operand.phrase):
            is_compared = is_of_words and not operand.at_start and operand.condition is None
            if k > first and not is_compared:  # a quantity is compared with others in words
                return True
    return False


def _is_of_measures(names: Names, text: str) -> bool:
    """Whether it calculates with measures, parameters and numbers alone: x1 - x2."""
    words = [run.strip() for run in _runs_of(text) if run not in _OPERATOR_SIGNS]
    return all(word in names.measures or _is_plain(names, word) for word in words)


def operands_of(names: Names, phrase: str) -> Operands | None:
    """What a phrase calculates with; None where it is one quantity. Notes a problem where the sense is open."""
    found = _operands(names, phrase)
    if len(found.runs) < 2 or not found.phrases or _is_of_whole(phrase):
        return None
    first = next(k for k, run in enumerate(found.runs) if run not in _OPERATOR_SIGNS)
    if first in found.phrases and not _is_quantity(names, found.phrases[first].phrase):
        return None
    for k, operand in found.phrases.items():
        following = found.runs[k + 1 :]
        if (
            " " in operand.phrase
            and operand.phrase.split()[-1] in names.measures
            and _is_drawn_in(names, operand.phrase, following)
        ):
            told = Message(
                "what does '{sign}' belong to in '{text}'? Put the quantity in parentheses: ({phrase})",
                sign=following[0],
                text=phrase,
                phrase=operand.phrase,
            )
            names.problem(told, "find")
    return found


def _is_of_whole(phrase: str) -> bool:
    """Whether it is the extreme of what stands in brackets."""
    found = _OF_WHOLE.match(phrase)
    return found is not None and _closing(phrase, found.end() - 1) == len(phrase) - 1


def extreme_until(names: Names, phrase: str) -> tuple[str, list[str]]:
    """`greatest A/B until E` with brackets, and the quantities A and B, of which none says itself when it is meant; the
    phrase as it is where it asks for nothing of the kind."""
    found = _UNTIL.match(phrase)
    if found is None or _is_of_whole(f"{found['end']}{found['of']}"):
        return phrase, []
    parts = _operands(names, found["of"]).phrases.values()
    said = [o for o in parts if o.condition is not None or o.at_start or _END.match(o.phrase)]
    if len(parts) < 2 or said:
        return phrase, []
    return f"{found['end']}({found['of']}){found['until']}", [o.phrase for o in parts]


def has_quantities(names: Names, text: str) -> bool:
    """Whether quantities stand in it, and not numbers and parameters alone."""
    return any(_is_quantity(names, operand.phrase) for operand in _operands(names, text).phrases.values())


def _is_drawn_in(names: Names, phrase: str, following: tuple[str, ...]) -> bool:
    """Whether what follows could as well be part of the measure whose rate, or end, is asked for: velocity of x^2,
    least x2 - x1."""
    if _END.match(phrase) and len(following) > 1 and following[0] in ("+", "-"):
        return following[1].strip() in names.measures
    if not following or following[0] not in ("^", "**", "*", "/"):
        return False
    return following[0] in ("^", "**") or (len(following) > 1 and following[1].strip() in names.measures)


def _operands(names: Names, text: str) -> Operands:
    runs = _runs_with_events(names, _spread(names, text))
    phrases: dict[int, Operand] = {}
    for k, run in enumerate(runs):
        if run not in _OPERATOR_SIGNS and not _is_plain(names, run.strip()):
            phrases[k] = _operand(run.strip())
    return Operands(tuple(runs), phrases)


def _spread(names: Names, text: str) -> str:
    """What is calculated in brackets at one instant, with this instant for each quantity: (A - B when E) as
    ((A when E) - (B when E))."""
    for found in re.finditer(r"\(", text):
        end = _closing(text, found.start())
        inside = text[found.end() : end]
        word = next((word for word in _EVENTS if word in inside), None)
        head, _, tail = inside.partition(word or "\0")
        head = without_start(inside) if word is None else head
        if end < 0 or head == inside or not _OPERATORS.search(head) or head.count("(") != head.count(")"):
            continue
        if word is not None and _goes_on(names, tail):
            continue
        timed, spread = inside[len(head) :], list[str]()
        for run in _runs_of(head):
            is_one = run not in _OPERATOR_SIGNS and not _is_plain(names, run.strip())
            spread.append(f"({run.strip()}{timed})" if is_one else run)
        return text[: found.end()] + "".join(spread) + _spread(names, text[end:])
    return text


def _runs_with_events(names: Names, text: str) -> list[str]:
    """Runs, of which one is what stands in brackets as a quantity at an event: (time when y = h/2)."""
    for found in re.finditer(r"\(", text):
        end = _closing(text, found.start())
        inside = text[found.end() : end]
        word = next((word for word in _EVENTS if word in inside), None)
        head, _, tail = inside.partition(word or "\0")
        if word is None or end < 0 or _OPERATORS.search(head) or not _OPERATORS.search(tail) or _goes_on(names, tail):
            continue
        before, after = text[: found.end()], text[end:]
        return [*_runs_with_events(names, before), inside, *_runs_with_events(names, after)]
    return _runs_of(text)


def _closing(text: str, opening: int) -> int:
    """The place of the bracket that closes another one; -1 where none does."""
    depth = 0
    for k in range(opening, len(text)):
        depth += {"(": 1, ")": -1}.get(text[k], 0)
        if depth == 0:
            return k
    return -1


def _runs_of(text: str) -> list[str]:
    pieces: list[str] = []
    place = 0
    for found in _OPERATORS.finditer(text):
        if found.group() in _OPERATOR_SIGNS:
            pieces += [text[place : found.start()], found.group()]
            place = found.end()
    return _with_units([piece for piece in (*pieces, text[place:]) if piece.strip()])


def _with_units(runs: list[str]) -> list[str]:
    """Runs in which a number and its unit are one: 2 m/s. Behind a sign of division 2 m could be read in two ways."""
    found: list[str] = []
    while runs:
        taken = 1
        if re.match(r"\s*[0-9.]", runs[0]) and (not found or found[-1] not in ("/", "^")):
            most = next((k for k, run in enumerate(runs) if run in _BEFORE_UNITS), len(runs))
            taken = next((k for k in range(most, 0, -1) if number_with_unit("".join(runs[:k])) is not None), 1)
        found.append("".join(runs[:taken]))
        runs = runs[taken:]
    return found


def number_with_unit(run: str) -> Number | None:
    """A number that has a unit; None where it is something else."""
    if not re.search(r"[A-Za-zµμ°]", run):
        return None
    try:
        return parse_quantity(run)
    except UnitError:
        return None


def _is_plain(names: Names, run: str) -> bool:
    """Whether it is a number, a parameter or a function."""
    if not _PLAIN.fullmatch(run):
        return number_with_unit(run) is not None
    return (
        run[0].isdigit() or run == "pi" or run in FUNCTIONS or (run in names.parameters and run not in names.measures)
    )


def _operand(run: str) -> Operand:
    for word in _EVENTS:
        if word in run:
            phrase, _, condition = run.partition(word)
            return Operand(phrase.strip(), condition.strip())
    return Operand(without_start(run), at_start=without_start(run) != run)


def _is_quantity(names: Names, phrase: str) -> bool:
    """Whether its words are those of a quantity, whatever names stand in them."""
    phrase = without_size(phrase)
    if phrase in names.measures or re.fullmatch(r"rate\(\s*\w+\s*\)", phrase) or TIME_ALONE.fullmatch(phrase):
        return True
    return any(p.pattern.match(phrase) for p in PHRASES) or any(f.pattern.match(phrase) for f in FORMS)


def is_between_bars(operands: Operands, k: int) -> bool:
    """Whether an operand stands alone between bars."""
    return _bars_about(operands, k) is not None


def between_bars(names: Names, operands: Operands, k: int, quantity: Quantity) -> Quantity:
    """A quantity, of which the size is meant where it stands alone between bars."""
    return quantity if _bars_about(operands, k) is None else quantity.sized(space=names.space)


def without_bars(operands: Operands, k: int) -> Operands:
    """With brackets in place of the bars about a quantity, which is a size itself."""
    bars = _bars_about(operands, k) or ()
    runs = [dict(zip(bars, "()", strict=False)).get(j, run) for j, run in enumerate(operands.runs)]
    return replace(operands, runs=tuple(runs))


def _bars_about(operands: Operands, k: int) -> tuple[int, int] | None:
    """The places of the bars between which a quantity stands alone, also in brackets of its own."""
    runs, first, last = operands.runs, k - 1, k + 1
    while first > 0 and last < len(runs) - 1 and (runs[first], runs[last]) == ("(", ")"):
        first, last = first - 1, last + 1
    is_sized = first >= 0 and last < len(runs) and runs[first] == runs[last] == "|"
    return (first, last) if is_sized else None
