"""An item of QTI 2.1 as it is read: what can be answered, and the elements of its response processing, which are run.

Source: IMS Question and Test Interoperability, Assessment Test, Section, and Item Information Model 2.1 (2012).
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from xml.etree.ElementTree import Element

from freebody.errors import InputError
from freebody.exercises.selftests import Marked
from freebody.exercises.xml import parsed, words
from freebody.language.sentences import Message

SPACE = "http://www.imsglobal.org/xsd/imsqti_v2p1"
Value = str | float | None


@dataclass(frozen=True)
class QtiItem:
    """An item that can be answered. choices: identifiers by what they show; feedback: by outcome and identifier."""

    name: str
    root: Element
    choices: Mapping[str, str]
    kinds: Mapping[str, str]
    correct: Mapping[str, Value]
    largest: float

    def mark(self, response: str) -> Marked:
        """By the item's own processing of responses."""
        outcomes = _Processing(self, self._given(response)).outcomes()
        score = outcomes.get("SCORE") or 0.0
        said = [
            inside(found)
            for found in self.root.findall(tagged("modalFeedback"))
            if found.get("outcomeIdentifier") == "FEEDBACK" and found.get("identifier") == outcomes.get("FEEDBACK")
        ]
        return Marked("correct" if score == self.largest else "incorrect", "".join(said))

    def _given(self, response: str) -> dict[str, Value]:
        names = list(self.kinds)
        if self.choices:
            if response not in self.choices:
                raise InputError(Message("the question has no such option"))
            return {names[0]: self.choices[response]}
        parts = response.split(";")
        if len(parts) != len(names):
            raise InputError(Message("the question has {n} fields", n=len(names)))
        return {name: _float(part, self.name) for name, part in zip(names, parts, strict=True)}


class _Processing:
    """Runs those elements of response processing that the writer uses."""

    def __init__(self, item: QtiItem, given: Mapping[str, Value]) -> None:
        self.item, self.given = item, given
        self.found: dict[str, Value] = {}

    def outcomes(self) -> Mapping[str, Value]:
        for rule in self.item.root.findall(f"{tagged('responseProcessing')}/*"):
            self._rule(rule)
        return self.found

    def _rule(self, rule: Element) -> None:
        match _tag(rule):
            case "setOutcomeValue":
                self.found[rule.get("identifier", "")] = self._value(rule[0])
            case "responseCondition":
                for branch in rule:
                    test, rules = (None, branch[:]) if _tag(branch) == "responseElse" else (branch[0], branch[1:])
                    if test is None or self._holds(test):
                        for one in rules:
                            self._rule(one)
                        return
            case other:
                raise self._unknown(other)

    def _holds(self, test: Element) -> bool:
        match _tag(test):
            case "and":
                return all(self._holds(part) for part in test)
            case "match":
                first, second = map(self._value, test)
                return first is not None and first == second
            case "equal":
                first, second = map(self._value, test)
                if not isinstance(first, float) or not isinstance(second, float):
                    return False
                below, above = ([float(x) for x in test.get("tolerance", "0").split()] * 2)[:2]
                return second - below * (1 + 1e-9) <= first <= second + above * (1 + 1e-9)
            case other:
                raise self._unknown(other)

    def _value(self, element: Element) -> Value:
        name = element.get("identifier", "")
        match _tag(element):
            case "variable":
                return self.given.get(name, self.found.get(name))
            case "correct":
                return self.item.correct.get(name)
            case "baseValue":
                text = (element.text or "").strip()
                return _float(text, self.item.name) if element.get("baseType") == "float" else text
            case other:
                raise self._unknown(other)

    def _unknown(self, element: str) -> InputError:
        return InputError(Message("the element {element} is not read", element=element))


def item_of(root: Element) -> QtiItem:
    name = root.get("title", "")
    declared = root.findall(tagged("responseDeclaration"))
    kinds = {d.get("identifier", ""): d.get("baseType", "") for d in declared}
    correct: dict[str, Value] = {}
    for d in declared:
        text = (d.findtext(f"{tagged('correctResponse')}/{tagged('value')}") or "").strip()
        correct[d.get("identifier", "")] = _float(text, name) if d.get("baseType") == "float" else text
    choices = {inside(choice): choice.get("identifier", "") for choice in root.iter(tagged("simpleChoice"))}
    largest = root.findtext(
        f"{tagged('outcomeDeclaration')}[@identifier='MAXSCORE']/{tagged('defaultValue')}/{tagged('value')}"
    )
    return QtiItem(name, root, choices, kinds, correct, _float(largest or "1", name))


def tagged(tag: str) -> str:
    return f"{{{SPACE}}}{tag}"


def _tag(element: Element) -> str:
    return element.tag.rpartition("}")[2]


def inside(element: Element) -> str:
    """What stands in an element, in one way of writing it: without the names of spaces."""
    return (words(element.text or "") + "".join(map(_one, element))).strip()


def _one(element: Element) -> str:
    attributes = "".join(f' {name}="{words(value)}"' for name, value in sorted(element.items()))
    own = f"<{_tag(element)}{attributes}>{inside(element)}</{_tag(element)}>"
    return own + words(element.tail or "")


def _float(text: str, name: str) -> float:
    try:
        return float(text)
    except ValueError:
        raise InputError(Message("{name}: '{text}' is no number", name=name, text=text)) from None


def canonical(markup: str) -> str:
    """A piece of an item as it is found when the item is read."""
    return inside(parsed(f'<x xmlns="{SPACE}">{markup}</x>'.encode(), "qti"))
