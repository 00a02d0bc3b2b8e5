"""The base of everything a user writes: an immutable description with named fields.

A description can be given by position or by name, in Python (`Pin("ground.axle", "pulley")`) and in a file
(`pin: [ground.axle, pulley]`, `gravity: g`, `pin: {first: ground.axle, second: pulley}`).
"""

from __future__ import annotations

from typing import Any, ClassVar, cast

from pydantic import BaseModel, ConfigDict

# What stands for a number: an expression in the parameters, a quantity with unit, or a plain SI number.
Formula = str | int | float
# What stands for a direction: right, left, up, down, an angle, components, or a line or axis of a body.
Heading = str | int | float | list[Formula] | tuple[Formula, Formula]


class Spec(BaseModel):
    """One described thing."""

    model_config = ConfigDict(frozen=True, extra="forbid", strict=False, defer_build=True)

    kind: ClassVar[str] = ""
    # what people call such a thing beside its kind: questions know it by these words
    called: ClassVar[tuple[str, ...]] = ()

    def __init__(self, *args: Any, **named: Any) -> None:
        fields = list(type(self).model_fields)
        if len(args) > len(fields):
            raise TypeError(f"{type(self).__name__} takes {', '.join(fields)}")
        super().__init__(**dict(zip(fields, args, strict=False)), **named)

    @classmethod
    def from_plain(cls, value: object) -> dict[str, Any]:
        """A file's value as named fields: a mapping is taken as it is, a list by position, anything else
        as the first field."""
        fields = list(cls.model_fields)
        if isinstance(value, dict):
            return dict(cast("dict[str, Any]", value))
        if value is None:
            return {}
        if isinstance(value, list):
            items = cast("list[Any]", value)
            spread = next((f for f in fields if f in cls.spread), None)
            if spread is not None:
                return {spread: items}
            return dict(zip(fields, items, strict=False)) | (
                {f"item {len(fields) + 1}": items[len(fields)]} if len(items) > len(fields) else {}
            )
        return {fields[0]: value}

    @classmethod
    def words(cls) -> tuple[str, ...]:
        """What such a thing is called."""
        return (cls.kind.replace("_", " "), *cls.called)

    # names of a field that takes a whole list when the value is a list
    spread: ClassVar[tuple[str, ...]] = ()

    def to_plain(self) -> dict[str, Any]:
        """The fields that differ from their defaults, as plain data."""
        return self.model_dump(exclude_defaults=True)
