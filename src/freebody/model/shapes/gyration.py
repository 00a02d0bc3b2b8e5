"""Bodies whose moment of inertia may be given, by itself or by the radius of gyration: I = m k^2."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, ClassVar

from freebody.language.sentences import Message
from freebody.model.shapes.base import Shape


class Gyrating(Shape):
    """A shape with a field `inertia`, in place of which a file may write `radius_of_gyration: k`."""

    elsewhere: ClassVar[Mapping[str, str]] = {
        "radius_of_gyration": Message(
            "it is told beside the mass, and in place of the inertia: {{mass: m, radius_of_gyration: k}}"
        ),
    }
    more_words: ClassVar[Mapping[str, tuple[str, ...]]] = {"radius_of_gyration": ("inertia",)}

    @classmethod
    def from_plain(cls, value: object) -> dict[str, Any]:
        """`radius_of_gyration: k` beside the mass is the moment of inertia m k^2."""
        given = super().from_plain(value)
        if "radius_of_gyration" in given and "mass" in given and "inertia" not in given:
            given["inertia"] = f"({given['mass']})*({given.pop('radius_of_gyration')})^2"
        return given
