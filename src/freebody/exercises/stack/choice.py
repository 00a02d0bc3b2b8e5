"""The part of a question in which an option is chosen: of statements, which STACK cannot compute with."""

from __future__ import annotations

from collections.abc import Iterator

from freebody.exercises.bank import Item
from freebody.exercises.markup import Markup
from freebody.exercises.stack.castext import VARIANT, string
from freebody.exercises.stack.part import Part, expected, place_of
from freebody.exercises.stack.question import Input, Node, QuestionTest, Tree

INPUT, TREE = "ans1", "prt1"


class ChoicePart:
    """An option is known by its number in the first variant; each variant has them in an order of its own."""

    def __init__(self, item: Item, markup: Markup) -> None:
        self.item, self.markup = item, markup
        self.options = item.variants[0].options
        self.number = {option.text: k for k, option in enumerate(self.options, 1)}

    def part(self) -> Part:
        tree = Tree(TREE, tuple(self._nodes()))
        box = Input(INPUT, "radio", "fbchoice", is_shown=False)
        return Part(tuple(self._variables()), place_of(INPUT), box, tree, tuple(self._tests(tree)))

    def _variables(self) -> Iterator[str]:
        lists: list[str] = []
        for variant in self.item.variants:
            shown = [
                f"[{self.number[o.text]},{'true' if o.is_right else 'false'},{string(self.markup.text(o.shown))}]"
                for o in variant.options
            ]
            lists.append(f"[{','.join(shown)}]")
        yield f"fbchoices:[{','.join(lists)}];"
        yield f"fbchoice:fbchoices[{VARIANT}];"

    def _nodes(self) -> Iterator[Node]:
        for k, option in sorted(enumerate(self.options, 1), key=lambda each: not each[1].is_right):
            said = self.markup.text(option.feedback).strip()
            note = f"right-{k}" if option.is_right else f"wrong-{k}"
            yield Node("AlgEquiv", INPUT, str(k), note, said, is_right=option.is_right)

    def _tests(self, tree: Tree) -> Iterator[QuestionTest]:
        for k, node in enumerate(tree.nodes):
            yield expected("key" if node.is_right else "distractor", INPUT, node.wanted, tree, k)
