"""Texts that ask otherwise than by words that are looked up one by one, each in its room: it puts the text in other
words, in those of the grammar, or says why nothing is asked. They are tried in the order of `FORMS`; the first whose
case it is has the text.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Generic

from freebody.language.sentences import Message
from freebody.questions.spoken.at_distances import at_a_distance
from freebody.questions.spoken.averages import over_a_turn
from freebody.questions.spoken.bounces import as_third, at_nth, between_impacts
from freebody.questions.spoken.changing import changed_by, changed_together
from freebody.questions.spoken.composing import JOINT
from freebody.questions.spoken.context import without_context
from freebody.questions.spoken.existing import for_which_there_is_one, where_there_is_one
from freebody.questions.spoken.for_good import at_last_rest, without_for_good
from freebody.questions.spoken.in_terms_of import misspelt
from freebody.questions.spoken.later import later
from freebody.questions.spoken.leaving_out import at_rest_without, without_load, without_several
from freebody.questions.spoken.levels import told_above, with_height_of_mass_center
from freebody.questions.spoken.naming import elements_of
from freebody.questions.spoken.open_loads import as_force, size_that_balances
from freebody.questions.spoken.pointing import pointing
from freebody.questions.spoken.restating import restated
from freebody.questions.spoken.shares import halfway, with_shares
from freebody.questions.spoken.unread import AskedT, Unread, read_quietly
from freebody.questions.spoken.ways import with_own_letters
from freebody.questions.spoken.weights import presses_upright, share_among_others, share_of_weight, without_gs
from freebody.questions.spoken.words import written_out

if TYPE_CHECKING:
    from freebody.model.names import Names

Found = list[tuple[AskedT, str]]  # what is asked for, and the words of the grammar in which it is


@dataclass(frozen=True)
class Asking(Generic[AskedT]):
    """A text that is asked of a model. again: what another text asks for; one_way: the same, where it can be meant in
    one way only."""

    names: Names
    text: str
    read: Callable[[str], AskedT | None]
    again: Callable[[str], Found[AskedT]]
    one_way: Callable[[str], Found[AskedT]]

    def quietly(self, text: str) -> Found[AskedT]:
        """What another text asks for, no problem noted."""
        with self.names.quietly():
            return self.again(text)

    def in_grammar(self, text: str) -> str:
        """A text in the words of the grammar; nothing where it has none."""
        return JOINT.join(dict.fromkeys(words for _asked, words in self.quietly(text)))

    def of_grammar(self, words: str | None) -> Found[AskedT] | None:
        """What words of the grammar ask for; None where they ask for nothing."""
        if not words or isinstance(asked := read_quietly(self.names, words, self.read), Unread):
            return None
        return [*zip(asked, words.split(JOINT), strict=True)]

    def refused(self, told: Message | None) -> Found[AskedT] | None:
        """Nothing, with why, where there is a reason."""
        if told is None:
            return None
        self.names.problem(told, "find")
        return []

    def over(self, text: str, unit: str) -> Found[AskedT] | None:
        """What a text asks for, over what it is to be told in."""
        found = self.quietly(text)
        each = [self.of_grammar(f"({words})/({unit})") for _asked, words in found]
        return [one for part in each for one in part or ()] if found and None not in each else None


Form = Callable[[Asking[AskedT]], Found[AskedT] | None]


def otherwise(asking: Asking[AskedT]) -> Found[AskedT] | None:
    """What a text asks for by one of the forms; None where it is none of their cases."""
    return next((found for form in FORMS if (found := form(asking)) is not None), None)


def _reworded(put: Callable[[Names, str], str]) -> Form[AskedT]:
    """Asked again as it is put, where that differs."""
    return lambda a: a.again(said) if (said := put(a.names, a.text)) != a.text else None


def _told(tell: Callable[[Names, str, Callable[[str], str]], str]) -> Form[AskedT]:
    """Words of the grammar, made of those for parts of the text."""
    return lambda a: a.of_grammar(tell(a.names, a.text, a.in_grammar))


def _told_again(tell: Callable[[Names, str, Callable[[str], str]], str]) -> Form[AskedT]:
    """Words made of those of the grammar for parts of the text, which are understood in their turn."""
    return lambda a: a.again(words) if (words := tell(a.names, a.text, a.in_grammar)) else None


def _at_later_impact(a: Asking[AskedT]) -> Found[AskedT] | None:
    """What a text asks of the third impact, asked of the n-th."""
    if (counted := as_third(a.text)) is None:
        return None
    text, n = counted
    words = [at_nth(said, n) for _asked, said in a.quietly(text)]
    each = [(asked, said) for said in words if said is not None and (asked := a.read(said)) is not None]
    return each if words and len(each) == len(words) else None


def _without_a_load(a: Asking[AskedT]) -> Found[AskedT] | None:
    if (left_out := without_load(a.names, a.text)) is None:
        return None
    return at_rest_without(a.names, left_out[1], a.again(left_out[0]), a.read)


def _for_good(a: Asking[AskedT]) -> Found[AskedT] | None:
    once = without_for_good(a.text)
    return None if once is None else at_last_rest(a.names, a.again(once), a.read)


def _in_gs(a: Asking[AskedT]) -> Found[AskedT] | None:
    return None if (in_gs := without_gs(a.names, a.text)) is None else a.over(*in_gs)


def _share_of_weight(a: Asking[AskedT]) -> Found[AskedT] | None:
    share = share_of_weight(a.names, a.text)
    found = None if share is None else a.over(*share)
    return found if found and all(presses_upright(a.names, words) for _asked, words in found) else None


def _balancing(a: Asking[AskedT]) -> Found[AskedT] | None:
    return a.again(size) if (size := size_that_balances(a.names, a.text)) else None


def _as_force(a: Asking[AskedT]) -> Found[AskedT] | None:
    return (a.one_way(put) or None) if (put := as_force(a.names, a.text)) != a.text else None


def _with_an_equilibrium(a: Asking[AskedT]) -> Found[AskedT] | None:
    exists = for_which_there_is_one(a.names, a.text)
    return (a.one_way(exists) or None) if exists else None


FORMS: tuple[Form, ...] = (
    _reworded(lambda names, text: with_own_letters(names, written_out(text))),
    _reworded(lambda _names, text: restated(text)),
    _reworded(lambda names, text: without_context(names, elements_of(names), text)),
    _at_later_impact,
    lambda a: a.of_grammar(between_impacts(a.text)),
    _told(later),
    lambda a: a.refused(without_several(a.names, a.text)),
    _without_a_load,
    _for_good,
    _in_gs,
    _share_of_weight,
    lambda a: a.refused(share_among_others(a.names, a.text)),
    _balancing,
    _as_force,
    _with_an_equilibrium,
    lambda a: a.refused(where_there_is_one(a.names, a.text)),
    lambda a: a.refused(misspelt(a.names, a.text)),
    _reworded(with_height_of_mass_center),
    _told(told_above),
    _told(halfway),
    _reworded(with_shares),
    lambda a: a.refused(changed_together(a.names, a.text)),
    _told(changed_by),
    _told_again(over_a_turn),
    _told_again(at_a_distance),
    _told(pointing),
)
