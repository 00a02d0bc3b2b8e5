"""The part of a question in which a formula is typed, or the components of a vector in square brackets."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from functools import cached_property

from freebody.assess.names import named_in
from freebody.errors import ExpressionError
from freebody.exercises.bank import Item, SymbolUsed
from freebody.exercises.markup import Markup
from freebody.exercises.stack.castext import string
from freebody.exercises.stack.comparing import COMPARING, PLAIN, Points, points_of
from freebody.exercises.stack.maxima import MaximaNames
from freebody.exercises.stack.part import Part, expected, place_of
from freebody.exercises.stack.question import Input, Node, QuestionTest, Tree
from freebody.exercises.typed import parts_of
from freebody.language.expression import Call, Expr, Symbol
from freebody.language.parser import parse
from freebody.language.raising import raised
from freebody.language.sentences import Sentence
from freebody.narrative.telling.catalogue import Catalogue
from freebody.present.report.blocks import Emphasis, Formula, Text

INPUT, TREE = "ans1", "prt1"
RIGHT, AS_FORMULA = "right", "right-as-formula"
MOST_WRONG = 8
_OPTIONS = "consolidatesubscripts, nounits"  # m_1 is m1; k is no misspelt unit where a number is asked for as well
Parts = tuple[Expr, ...]


@dataclass(frozen=True)
class Wrong:
    """A wrong answer that has a node. said: CASText."""

    parts: Parts
    note: str
    said: str


class FormulaPart:
    """Raises ExpressionError where the answer cannot be written in Maxima."""

    def __init__(self, item: Item, markup: Markup, catalogue: Catalogue) -> None:
        self.item, self.markup, self.catalogue = item, markup, catalogue
        assert item.expression is not None
        self.key: Parts = item.expression if isinstance(item.expression, tuple) else (item.expression,)
        self.names = self._names()
        self.key_text = self.written(self.key)

    def part(self) -> Part:
        tree = Tree(TREE, tuple(self._nodes()), "\n".join(self._feedback_variables()))
        return Part(tuple(self._variables()), self._asked(), self._input(), tree, tuple(self._tests(tree)))

    def written(self, parts: Parts) -> str:
        """In Maxima; a vector as a list."""
        texts = [self.names.written(part) for part in parts]
        return f"[{','.join(texts)}]" if isinstance(self.item.expression, tuple) else texts[0]

    # -- what is known ------------------------------------------------------------------------
    @cached_property
    def points(self) -> Points:
        sampling = self.item.sampling
        if sampling is None or not sampling.units.keys() >= _keys(self.key).keys():
            return Points(())
        return points_of(sampling, self.names.maxima, self.key, self.item.unit)

    @cached_property
    def equivalent(self) -> list[Parts]:
        """Other ways to write the answer, as they agree with it here."""
        found = [parts for text in self.item.equivalent if (parts := _read(text, len(self.key))) is not None]
        return [parts for parts in found if self._is_known(parts)]

    @cached_property
    def wrong(self) -> list[Wrong]:
        """Wrong answers that differ from the right one and from each other."""
        found: list[Wrong] = []
        for answer in self.item.wrong:
            parts = _read(answer.text, len(self.key))
            if parts is None or not self._is_known(parts) or len(found) == MOST_WRONG:
                continue
            others = [self.key, *(w.parts for w in found)]
            if self.has_numbers and (
                None in self.points.series(parts) or any(self.points.same(parts, o) for o in others)
            ):
                continue
            note = f"{answer.mistake or 'wrong'}-{len(found) + 1}".replace(" ", "_")
            found.append(Wrong(parts, note, self.markup.text(answer.feedback).strip()))
        return found

    @property
    def has_numbers(self) -> bool:
        """Whether formulas can be compared in numbers."""
        return bool(self.points.states) and None not in self.points.series(self.key)

    def _is_known(self, parts: Parts) -> bool:
        return all(name in self.names.maxima for name in _keys(parts))

    def _names(self) -> MaximaNames:
        """Of what the exercise offers, and of what a wrong answer names beside it."""
        texts = [*self.item.equivalent, *(w.text for w in self.item.wrong)]
        others = [part for text in texts for part in _read(text, len(self.key)) or ()]
        return MaximaNames.of(_keys([*self.key, *(e for s in self.item.symbols for e in _offered(s)), *others]))

    # -- variables ----------------------------------------------------------------------------
    def _variables(self) -> Iterator[str]:
        """Of the whole question: what the input needs. STACK sends these to Maxima again and again."""
        maxima = self.names.maxima
        positive = [maxima[s.name] for s in self.item.symbols if s.sign == "positive" and s.name in maxima]
        if positive:
            yield f"assume({','.join(f'{name}>0' for name in positive)});"
        for name, latex in self.names.latex():
            yield f"texput({name},{string(latex)});"
        yield f"fbkey:{self.key_text};"

    def _feedback_variables(self) -> Iterator[str]:
        """A letter before a bracket is a factor, not a function: g(m1+m2)."""
        for k, wrong in enumerate(self.wrong, 1):
            yield f"fbwrong{k}:{self.written(wrong.parts)};"
        if self.has_numbers:
            yield from self.points.written(self.names)
            yield from COMPARING
        for name in self.names.maxima.values():
            if len(name) == 1:
                yield f"{name}(fbx):={name}*fbx;"
        yield PLAIN
        yield f"fbans:ev(fbplain({INPUT}));"

    # -- the tree -----------------------------------------------------------------------------
    def _nodes(self) -> Iterator[Node]:
        """In numbers first: that is quick, knows the mechanics and the range, and says of each wrong answer what it is.
        AlgEquiv is left for what has no value at the states: it may take longer than a site allows."""
        alike = Node("AlgEquiv", "fbans", "fbkey", AS_FORMULA if self.has_numbers else RIGHT, is_right=True)
        if not self.has_numbers:
            yield alike
            for k, wrong in enumerate(self.wrong, 1):
                yield Node("AlgEquiv", "fbans", f"fbwrong{k}", wrong.note, wrong.said)
            return
        yield Node("AlgEquiv", "fbsame(fbans,fbkey)", "true", RIGHT, is_right=True)
        for k, wrong in enumerate(self.wrong, 1):
            yield Node("AlgEquiv", f"fbsame(fbans,fbwrong{k})", "true", wrong.note, wrong.said)
        yield Node("AlgEquiv", "fbsame(-fbans,fbkey)", "true", "sign", self._say("stack.sign"))
        if self.points.scaled is not None:
            unit = raised(self.item.unit)
            said = self._say("stack.dimension", unit=unit) if unit else self._say("stack.no_dimension")
            yield Node("AlgEquiv", "fbunits(fbans)", "false", "dimension", said)
        yield Node("AlgEquiv", "fbfactor(fbans,fbkey)", "true", "factor", self._say("stack.factor"))
        yield Node("AlgEquiv", "fbvalued(fbans)", "true", "differs")
        yield alike

    def _say(self, key: str, **args: str) -> str:
        return self.markup.text(self.catalogue.tell(Sentence(key, {k: f"@{v}" for k, v in args.items()})))

    # -- what is typed ------------------------------------------------------------------------
    def _input(self) -> Input:
        several = tuple(name for name in self.names.maxima.values() if len(name) > 1)
        return Input(INPUT, "algebraic", "fbkey", several, _OPTIONS)

    def _asked(self) -> str:
        return f"{self._how_to_type()}{place_of(INPUT)}"

    def _how_to_type(self) -> str:
        """The names of several letters, as they are typed."""
        offered = _keys([*self.key, *(e for s in self.item.symbols for e in _offered(s))])
        pairs: list[Text] = [
            (Formula((parse(name),)), " ", Emphasis(self.names.maxima[name], "code"))
            for name in offered
            if len(self.names.maxima[name]) > 1
        ]
        typed = f"{self._say('exercise.typed')} {', '.join(map(self.markup.text, pairs))}" if pairs else ""
        told = " ".join(filter(None, (self._shape(), typed)))
        return f"<p>{told}</p>" if told else ""

    def _shape(self) -> str:
        """How an answer of several parts is typed."""
        if not isinstance(self.item.expression, tuple):
            return ""
        labels = self.item.labels
        if any(label.isdigit() for label in labels):
            return self._say("stack.values")
        return self._say("stack.vector", parts=f"[{', '.join(labels)}]" if labels else "[...]")

    # -- tests --------------------------------------------------------------------------------
    def _tests(self, tree: Tree) -> Iterator[QuestionTest]:
        yield expected("key", INPUT, "fbkey", tree, 0)
        for parts in self.equivalent:
            yield expected("equivalent", INPUT, self.written(parts), tree, 0)
        for k in range(1, len(self.wrong) + 1):
            yield expected("distractor", INPUT, self.written(self.wrong[k - 1].parts), tree, k)
        if self.has_numbers:
            notes = [node.note for node in tree.nodes]
            for factor, note in ((-1, "sign"), (7, "factor")):
                made = tuple(factor * part for part in self.key)
                if not any(self.points.same(made, known) for known in (self.key, *(w.parts for w in self.wrong))):
                    yield expected("distractor", INPUT, self.written(made), tree, notes.index(note))


def _read(text: str, n: int) -> Parts | None:
    """A formula in the notation of models, or the n components of a vector; None where it is none."""
    try:
        found = parts_of(text)
    except ExpressionError:
        return None
    return found if len(found) == n else None


def _keys(parts: Iterable[Expr]) -> dict[str, None]:
    """The names of symbols, and rates as "rate(x)", in the order in which they appear."""
    return dict.fromkeys(key for part in parts for key in named_in(part))


def _offered(symbol: SymbolUsed) -> tuple[Expr, ...]:
    name = Symbol(symbol.name)
    return (name, Call("rate", name)) if symbol.is_moving else (name,)
