"""Start poses that are given outright: found by linear equations, the same that a search finds, at a cost that does not
grow with the way to them."""

from __future__ import annotations

import math

import numpy as np
import pytest

from freebody.errors import CannotAnswer
from freebody.numeric import start
from freebody.numeric.outright import given_outright
from freebody.numeric.placing import Placing
from freebody.numeric.reference import Reference
from freebody.system.system import System


def chain(n: int, angles: str) -> str:
    """Rods of 0.1 m, the first on the ground. angles: the start of each, with {k}, {before}"""
    bodies = "".join(f"  r{k}: {{rod: {{mass: 1 kg, length: 0.1 m}}}}\n" for k in range(n))
    pins = "".join(f"  c{k}: {{pin: [{f'r{k - 1}.end' if k else 'ground.A'}, r{k}.start]}}\n" for k in range(n))
    first = "a0: {angle of r0}"
    if angles == "between":
        named = ", ".join([first, *(f"a{k}: {{angle of r{k} relative to r{k - 1}}}" for k in range(1, n))])
    else:
        named = ", ".join([first, *(f"a{k}: {{angle of r{k}}}" for k in range(1, n))])
    at = ", ".join(f"a{k}: {-60 + 3 * k if angles == 'alone' or not k else 3} deg" for k in range(n))
    return f"bodies:\n{bodies}connections:\n{pins}measures: {{{named}}}\nstart: {{{at}}}\n"


@pytest.fixture
def n_looked(monkeypatch: pytest.MonkeyPatch) -> list[int]:
    """Of every look at all gaps how many these were."""
    looked: list[int] = []
    look = Placing._gaps  # pyright: ignore[reportPrivateUsage]

    def counted(self: Placing, q, equations, t, near):  # type: ignore[no-untyped-def]
        looked.append(len(equations))
        return look(self, q, equations, t, near)

    monkeypatch.setattr(Placing, "_gaps", counted)
    return looked


@pytest.mark.parametrize("angles", ["alone", "between"])
@pytest.mark.parametrize("n", [5, 10])
def test_a_chain_of_given_angles_stands_where_they_put_it(n: int, angles: str, n_looked: list[int]) -> None:
    """Its mass centres are sums of rods; all gaps are looked at five times, however far it has to go."""
    q = Reference(System.from_text(chain(n, angles))).assemble()
    tip = np.zeros(2)
    for k in range(n):
        a = math.radians(-60 + 3 * k)
        along = 0.1 * np.array([math.cos(a), math.sin(a)])
        assert q[3 * k : 3 * k + 3] == pytest.approx([*(tip + along / 2), a], abs=1e-13)
        tip = tip + along
    assert n_looked == [3 * n] * 5


def test_a_search_finds_the_same_pose(monkeypatch: pytest.MonkeyPatch) -> None:
    system = System.from_text(chain(5, "between"))
    outright = Reference(system).assemble()
    monkeypatch.setattr(start, "given_outright", lambda *_given: None)
    assert Reference(system).assemble() == pytest.approx(outright, abs=1e-12)


@pytest.mark.parametrize(
    "text",
    [
        chain(5, "alone").replace(", a4: -48 deg", ""),  # the last rod may hang as it likes
        chain(5, "alone")
        .replace("a4: {angle of r4}", "a4: {distance of r4.end from ground.A}")
        .replace("-48 deg", "0.45 m"),
    ],
)
def test_what_is_open_or_has_two_poses_is_not_given_outright(text: str) -> None:
    reference = Reference(System.from_text(text))
    equations = start._equations(reference, ())  # pyright: ignore[reportPrivateUsage]
    assert given_outright(reference.placing, start.guessed(reference), equations) is None
    assert reference.placing.placed(reference.assemble(), equations, 0.0, {}).error < 1e-11


def test_angles_that_contradict_each_other_are_told_as_before() -> None:
    text = (
        chain(5, "alone")
        .replace("measures: {", "measures: {b: {angle of r1 relative to r0}, ")
        .replace("start: {", "start: {b: 9 deg, ")
    )
    with pytest.raises(CannotAnswer, match="cannot be assembled"):
        Reference(System.from_text(text)).assemble()
