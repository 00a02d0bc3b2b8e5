"""Dataclasses whose methods are written when they are first called.

`dataclasses.dataclass` writes and compiles six functions for each class while its module is imported. That is two
fifths of the time in which the rooms of a model are imported, and most of these functions are never called in one
process. Here the fields are there at once (`fields`, `replace`, `is_dataclass` and `match` know them), and `__init__`,
`__eq__`, `__hash__` and `__repr__`, which do what the standard ones do, are written by their first call.
"""

from __future__ import annotations

import dataclasses
from copy import copy
from dataclasses import MISSING
from functools import partial
from typing import TYPE_CHECKING, Any

_fields_of = dataclasses.dataclass

if TYPE_CHECKING:
    from dataclasses import dataclass
else:

    def dataclass(cls=None, /, *, slots=False, **given):
        """As `dataclasses.dataclass`, which makes another class of one with slots, all at once."""
        if slots:
            return _fields_of(cls, slots=True, **given)

        def described(cls, *, init=True, repr=True, eq=True, frozen=False, kw_only=False):
            own = set(vars(cls))
            hashes = "__hash__" in own and cls.__hash__ is not None  # None stands there beside an `__eq__` of one's own
            cls.__doc__ = cls.__doc__ or cls.__name__  # or the signature is looked for, to be written there
            _fields_of(cls, init=False, repr=False, eq=False, kw_only=kw_only)
            if init:
                _write_when_called(cls, "__init__", frozen=frozen)
            if repr and "__repr__" not in own:
                _write_when_called(cls, "__repr__", repr=True)
            if eq and "__eq__" not in own:
                _write_when_called(cls, "__eq__", eq=True)
            if eq and frozen and not hashes:
                _write_when_called(cls, "__hash__", unsafe_hash=True)
            elif eq and not hashes:
                cls.__hash__ = None
            if frozen:
                cls.__setattr__, cls.__delattr__ = _refuse_to_set, _refuse_to_delete
            return cls

        return partial(described, **given) if cls is None else described(cls, **given)


def _refuse_to_set(self: object, name: str, _value: object) -> None:
    raise dataclasses.FrozenInstanceError(f"cannot assign to field {name!r}")


def _refuse_to_delete(self: object, name: str) -> None:
    raise dataclasses.FrozenInstanceError(f"cannot delete field {name!r}")


def _write_when_called(cls: type[Any], name: str, **wanted: bool) -> None:
    """A method that puts the written one in its place, and does what that does."""

    def method(self: Any, *given: Any, **named: Any) -> Any:
        written = _initial(cls, **wanted) if name == "__init__" else _standard(cls, name, wanted)
        written.__qualname__ = f"{cls.__qualname__}.{name}"
        setattr(cls, name, written)
        return written(self, *given, **named)

    method.__qualname__ = f"{cls.__qualname__}.{name}"
    setattr(cls, name, method)


def _standard(cls: type[Any], name: str, wanted: dict[str, Any]) -> Any:
    """A method as the standard library has it: that of a class with the same fields and nothing else."""
    own = [(field.name, field.type, copy(field)) for field in dataclasses.fields(cls)]
    wanted = {"init": False, "repr": False, "eq": False, **wanted}
    return vars(dataclasses.make_dataclass(cls.__name__, own, **wanted))[name]


def _initial(cls: type[Any], *, frozen: bool) -> Any:
    """`__init__`; frozen: it goes past a `__setattr__` that refuses."""
    known: dict[str, Any] = {"_missing": MISSING, "_set": object.__setattr__}
    positional, named, lines = ["self"], ["*"], list[str]()
    for field in dataclasses.fields(cls):
        name = value = field.name
        known[f"_make_{name}"], known[f"_default_{name}"] = field.default_factory, field.default
        is_made = field.default_factory is not MISSING
        if field.init:
            has_default = is_made or field.default is not MISSING
            default = f"=_{'missing' if is_made else f'default_{name}'}" if has_default else ""
            (named if field.kw_only else positional).append(f"{name}{default}")
            value = f"_make_{name}() if {name} is _missing else {name}" if is_made else name
        elif is_made:
            value = f"_make_{name}()"
        else:
            continue  # its default is found in the class
        lines.append(f"_set(self, {name!r}, {value})" if frozen else f"self.{name} = {value}")
    head = ", ".join([*positional, *(named if len(named) > 1 else [])])
    after = ["self.__post_init__()"] if hasattr(cls, "__post_init__") else []
    body = "\n    ".join([*lines, *after] or ["pass"])
    code = compile(f"def __init__({head}):\n    {body}", f"<fields of {cls.__qualname__}>", "exec")
    exec(code, known)
    return known["__init__"]
