"""Messages: what a layer says in English at once, on the terminal, in JSON, in an exception, and what of.

A message remembers its template, which is the key under which the catalogue of another language has it, and what was
put into its places. A place may hold another message:

    Message("the start cannot be assembled: {why}", why=Message("the gap of {pin} stays {gap:.2g} m", pin=..., gap=...))
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from numbers import Number as Figure


class Shown(str):
    """How something stands in a text: a formula, a unit. of: the thing itself, for those who show it otherwise."""

    of: object

    def __new__(cls, text: str, of: object) -> Shown:
        shown = super().__new__(cls, text)
        shown.of = of
        return shown

    def __getnewargs_ex__(self) -> tuple[tuple[str, object], dict[str, object]]:
        return (str.__str__(self), self.of), {}


class Message(str):
    """A sentence in English that can be told in other languages too. Arguments are messages, names, formulas as they
    are shown, and numbers with a format in the template."""

    template: str
    arguments: Mapping[str, object]

    def __new__(cls, template: str, /, **arguments: object) -> Message:
        filled = {k: v if isinstance(v, (str, Figure)) else _as_text(v) for k, v in arguments.items()}
        message = super().__new__(cls, template.format_map(filled))
        message.template = template
        message.arguments = filled
        return message

    @classmethod
    def of_parts(cls, parts: Sequence[str]) -> Message:
        """Parts that are told one after the other, each of which may remember a formula."""
        return cls("".join(f"{{p{k}}}" for k in range(len(parts))), **{f"p{k}": p for k, p in enumerate(parts)})

    def of(self, **arguments: object) -> Message:
        """The same sentence with other arguments."""
        return type(self)(self.template, **arguments)

    def __str__(self) -> str:
        return self  # str(error) is still the message that was raised

    def __getnewargs_ex__(self) -> tuple[tuple[str], dict[str, object]]:
        return (self.template,), dict(self.arguments)


def _as_text(of: object) -> str:
    """A thing as it stands in a text; an error as the message that it was raised with."""
    text = str(of)
    return text if isinstance(text, Message) else Shown(text, of)


def as_found(value: object) -> str:
    """What a file has where something else belongs, as it stands in a message."""
    return Message("nothing") if value is None else repr(value)


def listed(parts: Sequence[str], joined: str = "{first} and {second}") -> str:
    """a, b and c; joined: how the last two stand together, as a template. Messages that are joined stay messages."""
    if not parts:
        return ""
    *before, last = parts
    if not before:
        return last
    return Message(joined, first=in_turn(before), second=last)


def in_turn(parts: Sequence[str], joined: str = "{first}, {second}") -> str:
    """a, b, c"""
    if not parts:
        return ""
    told = parts[0]
    for part in parts[1:]:
        told = Message(joined, first=told, second=part)
    return told


def turns(text: str) -> list[str]:
    """What `in_turn` put together."""
    if isinstance(text, Message) and text.template == "{first}, {second}":
        return [*turns(str(text.arguments["first"])), str(text.arguments["second"])]
    return [text] if text else []


def further(*parts: str) -> str:
    """a; b; c"""
    return in_turn(parts, "{first}; {second}")


def lines(parts: Sequence[str]) -> str:
    """Each on a line of its own. Halves are joined, as a file may have thousands of mistakes: every message keeps the
    text of its parts, so that adding them one by one would keep the square of that."""
    if len(parts) < 2:
        return parts[0] if parts else ""
    half = len(parts) // 2
    return Message("{first}\n{second}", first=lines(parts[:half]), second=lines(parts[half:]))
