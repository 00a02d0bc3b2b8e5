"""Dataclasses whose methods are written when they are first called: they do what the standard ones do."""

from __future__ import annotations

import copy
import dataclasses
import pickle
import subprocess
import sys
from collections.abc import Callable
from dataclasses import field
from typing import Any, ClassVar

import pytest

from freebody.dataclass import dataclass

Made = Callable[..., Any]


@dataclass(frozen=True)
class Point:
    x: float
    y: float = 0.0
    names: list[str] = field(default_factory=list[str], compare=False)
    n: ClassVar[int] = 2


@dataclass(frozen=True)
class Named(Point):
    name: str = field(default="O", kw_only=True)
    size: float = field(init=False, repr=False, default=1.0)

    def __post_init__(self) -> None:
        object.__setattr__(self, "size", abs(self.x) + abs(self.y))


def pair_of(make: Any, **how: bool) -> type[Any]:
    """A class of the same body by one decorator or the other."""

    class Pair:
        first: Any
        second: Any = 3
        rest: list[int] = field(default_factory=list[int])

    return make(**how)(Pair)


HOW = [{}, {"frozen": True}, {"eq": False}, {"repr": False}, {"frozen": True, "eq": False}, {"kw_only": True}]


@pytest.mark.parametrize("how", HOW, ids=str)
def test_it_does_what_the_standard_one_does(how: dict[str, bool]) -> None:
    ours, theirs = pair_of(dataclass, **how), pair_of(dataclasses.dataclass, **how)
    assert [f.name for f in dataclasses.fields(ours)] == [f.name for f in dataclasses.fields(theirs)]
    assert ours.__match_args__ == theirs.__match_args__

    def told(make: Made) -> list[Any]:
        def tried(*does: Callable[[], Any]) -> Any:
            try:
                return [do() for do in does]
            except Exception as error:
                return type(error), str(error).partition(" takes ")[0]

        one, same = make(first=1), make(first=1, second=3)
        return [
            tried(lambda: vars(one)),
            tried(lambda: one == same, lambda: one != same, lambda: one == 5, lambda: one == make(first=2)),
            tried(lambda: hash(make(first=1, rest=())) == hash(make(first=1, rest=()))),
            tried(lambda: repr(one) if how.get("repr", True) else "by its place"),
            tried(lambda: setattr(one, "first", 2), lambda: one.first),
            tried(lambda: delattr(one, "second")),
            tried(lambda: make(1, 2, [3])),
            tried(lambda: make()),
            tried(lambda: make(first=1, third=2)),
            tried(lambda: vars(dataclasses.replace(same, second=4))),
            one.rest is not same.rest,
        ]

    for mine, its in zip(told(ours), told(theirs), strict=True):
        assert str(mine).replace("test_dataclass.", "") == str(its).replace("test_dataclass.", "") or (
            isinstance(mine, list) and type(mine[0]).__name__ == "Pair"
        )


def test_a_subclass_has_methods_of_its_own() -> None:
    one = Named(1.0, 2.0, name="A")
    assert (one.size, one.name, one.names) == (3.0, "A", [])
    assert repr(one) == "Named(x=1.0, y=2.0, names=[], name='A')"
    assert one == Named(1.0, 2.0, ["other"], name="A") != Named(1.0, 2.0, name="B")
    assert one != Point(1.0, 2.0)
    assert Point(1.0, 2.0) != one
    assert len({one, Named(1.0, 2.0, name="A"), Point(1.0, 2.0)}) == 2
    assert copy.deepcopy(one) == pickle.loads(pickle.dumps(one)) == dataclasses.replace(one)
    with pytest.raises(dataclasses.FrozenInstanceError, match="cannot assign to field 'x'"):
        one.x = 2.0  # type: ignore[misc]


def test_methods_of_ones_own_stay() -> None:
    @dataclass(frozen=True)
    class Turn:
        angle: float

        def __eq__(self, other: object) -> bool:
            return isinstance(other, Turn) and (self.angle - other.angle) % 360 == 0

        def __hash__(self) -> int:
            return hash(self.angle % 360)

        def __repr__(self) -> str:
            return f"{self.angle}°"

    assert Turn(10) == Turn(370)
    assert len({Turn(10), Turn(370)}) == 1
    assert repr(Turn(10)) == "10°"


def test_nothing_is_written_while_the_rooms_of_a_model_are_imported() -> None:
    """Six functions a class, of hundreds of classes, took two fifths of the time of these imports."""
    code = (
        "import sys\n"
        "import freebody.studio.reading, freebody.studio.moving, freebody.questions\n"
        "modules = [m for name, m in sys.modules.items() if name.startswith('freebody.')]\n"
        "classes = {c for m in modules for c in vars(m).values() if isinstance(c, type)}\n"
        "made = {c for c in classes if '__dataclass_fields__' in vars(c)}\n"
        "made = {c for c in made if c.__module__.startswith('freebody.') and '.kernels.' not in c.__module__}\n"
        # kernels are compiled beside their sources, which stay as they are
        "with_slots = {c for c in made if '__slots__' in vars(c)}\n"
        "standard = {c for c in made - with_slots if c.__init__.__code__.co_filename == '<string>'}\n"
        "print(len(made) > 300, *standard)\n"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout == "True\n"
