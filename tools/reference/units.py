"""Units of the fields of a description, listened for while its example is read.

No field says its unit: the reader asks for a formula of a dimension (`Formulas.formula` and those who call it). These
questions are noted here, with the field that they are about.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any
from unittest.mock import patch

from freebody.language.units import DIMENSIONLESS, LENGTH, Dimension
from freebody.model.formulas import Formulas
from freebody.model.spec import Spec

Units = dict[str, str]


@contextmanager
def listening(kind: type[Spec]) -> Iterator[Units]:
    """What becomes known inside of the units of the fields of a kind."""
    units: Units = {}

    def note(field: object, dimension: Dimension) -> None:
        if isinstance(field, str) and field in kind.model_fields:
            units.setdefault(field, str(dimension))

    def of_spec(wrapped: Callable[..., Any]) -> Callable[..., Any]:
        def asked(names: Formulas, spec: Spec, field: str, dimension: Any = LENGTH, *rest: Any) -> Any:
            if isinstance(spec, kind):
                note(field, dimension if isinstance(dimension, Dimension) else LENGTH)
            return wrapped(names, spec, field, dimension, *rest)

        return asked

    def length_or(wrapped: Callable[..., Any]) -> Callable[..., Any]:
        def asked(names: Formulas, spec: Spec, field: str, *rest: Any) -> Any:
            if isinstance(spec, kind):
                note(field, LENGTH)
            return wrapped(names, spec, field, *rest)

        return asked

    def formula(wrapped: Callable[..., Any]) -> Callable[..., Any]:
        def asked(names: Any, value: Any, dimension: Dimension, *path: str | int, **more: Any) -> Any:
            whole = (*names._path, *path)
            if "it" in whole:
                note(
                    next((step for step in whole[whole.index("it") + 1 :] if step in kind.model_fields), None),
                    dimension,
                )
            return wrapped(names, value, dimension, *path, **more)

        return asked

    def angle(wrapped: Callable[..., Any]) -> Callable[..., Any]:
        def asked(names: Any, value: Any, *path: str | int) -> Any:
            if path and isinstance(path[0], str) and path[0] in kind.model_fields:
                units.setdefault(path[0], "rad")
            return wrapped(names, value, *path)

        return asked

    listeners = {
        "positive": of_spec,
        "optional": of_spec,
        "vector": of_spec,
        "vectors": of_spec,
        "length_or": length_or,
        "formula": formula,
        "angle": angle,
    }
    with patch.multiple(Formulas, **{name: made(getattr(Formulas, name)) for name, made in listeners.items()}):
        yield units


def shown(unit: str) -> str:
    """1 for a pure number is said in words."""
    return "a number" if unit == str(DIMENSIONLESS) else unit
