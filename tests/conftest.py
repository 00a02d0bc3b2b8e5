"""Comparing formulas: two texts in the same symbols are the same function of them."""

from __future__ import annotations

import cProfile
import gc
import os
import random
import re
from collections import Counter
from collections.abc import Callable, Mapping
from functools import cache
from pathlib import Path
from typing import Any

import mpmath
import pytest
import sympy
from tests.declared import GIVEN
from tests.studio_browser import browser, page, pendulum  # noqa: F401  (fixtures of what looks at the studio)

import freebody as fb

Agree = Callable[..., None]
Within = Callable[[int, Callable[[], object]], None]
_FUNCTIONS = ["sin", "cos", "tan", "asin", "acos", "atan", "sinh", "cosh", "tanh", "sqrt", "exp", "log", "pi"]
_NUMBER = re.compile(r"(?<![\w.])\d+(?:\.\d+)?(?:[eE][+-]?\d+)?")
_SEED = 20
_DIGITS = 60


def pytest_configure(config: pytest.Config) -> None:
    gc.set_threshold(50_000, 20, 100)  # what the tests keep for each other is looked through less often
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # of the workers, which have a core each


_LONG = Path(__file__).with_name("long_tests.txt")  # written by tools/list_long_tests.py


@cache
def long_tests() -> tuple[frozenset[str], frozenset[str]]:
    """Examples all of whose cases are slow, and tests that are."""
    lines = [line for line in _LONG.read_text(encoding="utf-8").splitlines() if not line.startswith("#")]
    examples = frozenset(line.partition(" ")[2] for line in lines if line.startswith("example "))
    return examples, frozenset(lines) - {f"example {name}" for name in examples}


@pytest.hookimpl(tryfirst=True)
def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    examples, tests = long_tests()
    for item in items:
        case = item.nodeid.partition("[")[2].removesuffix("]").partition("-")[0]
        if item.nodeid in tests or case in examples:
            item.add_marker(pytest.mark.slow)


@pytest.hookimpl(optionalhook=True)
def pytest_terminal_summary(terminalreporter: Any) -> None:
    """What was left out for want of a tool is said in any case, not with `-rs` alone."""
    said = [str(report.longrepr[2]) for report in terminalreporter.stats.get("skipped", []) if report.longrepr]
    missing = Counter(text.removeprefix("Skipped: ") for text in said if "NOT RUN" in text)
    if missing:
        terminalreporter.section("left out")
    for text, n in sorted(missing.items()):
        terminalreporter.line(f"{text} ({n} {'test' if n == 1 else 'tests'})", yellow=True)


# files that share explained examples (`examples_told`), and so one worker
_TOGETHER = {"test_examples", "test_narrative", "test_narrative_phrases", "test_shared_derivations"}
_SHARES = re.compile(r'@(functools\.)?(lru_)?cache\b|scope="module"')  # what a file keeps for all of its tests


@pytest.hookimpl(optionalhook=True)
def pytest_xdist_make_scheduler(config: pytest.Config, log: Any) -> Any:
    """The tests of a file that keeps something for all of them run on one worker; of other files those of a function,
    so that no worker has a long file left when the others are done. Said here and not by marks of groups, whose names
    pytest-xdist 3.8 writes where pytest 9.2 does not read them any more."""
    from xdist.scheduler import LoadFileScheduling

    class BySharing(LoadFileScheduling):
        def _split_scope(self, nodeid: str) -> str:
            path, _, test = nodeid.partition("::")
            if Path(path).stem in _TOGETHER:
                return "examples"
            return path if _shares(config.rootpath / path) else f"{path}::{test.partition('[')[0]}"

    return BySharing(config, log)


@cache
def _shares(path: Path) -> bool:
    return _SHARES.search(path.read_text(encoding="utf-8")) is not None


class _Symbols(dict[str, Any]):
    """Every name that is no function is a symbol."""

    def __missing__(self, name: str) -> sympy.Symbol:
        return sympy.Symbol(name)


def formula(text: str) -> sympy.Expr:
    """A formula in Python's notation; rate(x) is a symbol of its own."""
    names = _Symbols({name: getattr(sympy, name) for name in _FUNCTIONS})
    names["rate"] = lambda measure: sympy.Symbol(f"rate({measure.name})")
    names["abs"] = sympy.Abs
    names["elliptic_K"] = lambda k: sympy.elliptic_k(k**2)  # of the modulus; SymPy's are of the parameter
    names["elliptic_F"] = lambda phi, k: sympy.elliptic_f(phi, k**2)
    names |= {"fresnel_c": sympy.fresnelc, "fresnel_s": sympy.fresnels}
    names |= {n: sympy.Function(n) for n in GIVEN if f"{n}(" in text}  # in numbers, by points
    names["exact"] = sympy.Rational  # numbers as fractions, not as floats
    return sympy.S(eval(_NUMBER.sub(r"exact('\g<0>')", text), {"__builtins__": {}}, names))


def assert_same_function(found: str, expected: str, near: Mapping[str, float]) -> None:
    """Both agree to 20 digits at ten random points about the values in `near`, other symbols between 0.2 and 1:
    an identity of elementary functions holds at a random point only if it holds (Schwartz and Zippel)."""
    a, b = formula(found), formula(expected)
    numbers = random.Random(_SEED)
    symbols = sorted(a.free_symbols | b.free_symbols, key=str)
    both = sympy.lambdify(symbols, (a, b), "mpmath")
    for _ in range(10):
        point = [near.get(str(s), 0.0) * numbers.uniform(0.9, 1.1) or numbers.uniform(0.2, 1.0) for s in symbols]
        with mpmath.workdps(_DIGITS):
            x, y = both(*(mpmath.mpf(round(value * 10**6)) / 10**6 for value in point))
            size = max(abs(x), abs(y), mpmath.mpf("1e-6"))
            told = f"seed {_SEED}: {found} is {x}, {expected} is {y} at {dict(zip(symbols, point, strict=True))}"
            assert abs(x - y) < size / mpmath.mpf(10) ** 20, told


def calls_of(action: Callable[[], object]) -> int:
    """How many functions an action calls."""
    profile = cProfile.Profile()
    profile.runcall(action)
    return sum(entry.callcount for entry in profile.getstats())


@pytest.fixture
def within() -> Within:
    """Asserts that an action takes at most so many calls of functions: a measure of its work that is the same on every
    machine. On an ordinary one a million calls take about half a second."""

    def check(most: int, action: Callable[[], object]) -> None:
        calls = calls_of(action)
        if calls > most:  # the first time something may be imported, or kept for later
            calls = calls_of(action)
        assert calls <= most, f"{calls} calls, {most} are allowed"

    return check


@pytest.fixture
def agrees() -> Agree:
    """Asserts that an answer of a solution is the expected formula (a list of them for a vector)."""

    def check(solution: fb.Solution, id: str, expected: str | list[str]) -> None:
        answer = solution[id]
        assert answer.expression is not None, answer.reason
        near = {p.name: p.value for p in solution.system.parameters.values() if p.value}
        found = answer.to_plain()["expression"]
        pairs = zip(found, expected, strict=True) if isinstance(found, list) else [(found, expected)]
        for one, other in pairs:
            assert_same_function(one, other, near)

    return check
