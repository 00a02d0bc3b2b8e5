"""The text of the functions that follow one copy, written out operation by operation.

    constants(p)              what hangs on the parameters alone, computed once
    begin(p)                  the state at t = 0
    rates(t, y, c)            its derivative
    watched(t, y, c), turning(t, y, c), gaps(t, y, c)
    follow(i, ...)            copy i to its end: steps of an explicit pair by its tableau, unrolled

The step is that of the engine (`kernels.stages`, `kernels.stepping`): the same norm of the error, relative to the size
of the system and to its largest speed and move so far, the same choice of steps; so a tolerance means the same.
Extremes are looked for at `N_PARTS` parts of each step by its dense output, and between two parts on the cubic through
values and rates, whose error goes with the fourth power of an eighth of the step.
Source: Hairer, Norsett & Wanner, Solving Ordinary Differential Equations I, 1993, sec. II.4 to II.6.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from freebody.errors import CannotAnswer
from freebody.language.expression import FRESNEL
from freebody.language.sentences import Message
from freebody.numeric.engine.operations import ProgramNode
from freebody.numeric.ensemble.copies import Copies, Extreme
from freebody.numeric.kernels.operations import (
    ABS,
    ADD,
    ARGUMENT,
    CONSTANT,
    DIVIDE,
    FUNCTIONS,
    INPUT,
    MULTIPLY,
    POWER,
    SIGN,
    SQRT,
    SUBTRACT,
    TIME,
)
from freebody.numeric.kernels.stepped_run import EPSILON, Tableau

FAILED, DONE = 0, 1  # what has come of a copy
N_PARTS = 8  # of a step, at which extremes are looked for
LOOSE = 1e3  # errors of a step, by the tolerance, by which closed loops may be open
_SIGNS = {ADD: "+", SUBTRACT: "-", MULTIPLY: "*", DIVIDE: "/"}


def source_of(copies: Copies, tableau: Tableau) -> str:
    """The text of a module for some copies and a method with two embedded formulas."""
    return "\n".join(_Writer(copies, tableau).lines()) + "\n"


class _Writer:
    """Writes the functions of one model."""

    def __init__(self, copies: Copies, tableau: Tableau) -> None:
        self.copies, self.tableau, self.graph = copies, tableau, copies.graph
        self.n = len(copies.rates)
        self.turning = [node for e in copies.extremes for node in (e.node, e.rate)]
        self.moving = {
            "rates": list(copies.rates),
            "watched": list(copies.watched),
            "turning": self.turning,
            "gaps": list(copies.gaps),
        }
        self.constants = self._constants()
        self.y = [f"y{k}" for k in range(self.n)]
        self.c = [f"c{k}" for k in self.constants]
        self.p = [f"p{k}" for k in range(self.graph.n_parameters)]

    def lines(self) -> Iterator[str]:
        yield from self._function("constants", self.p, [ProgramNode(self.graph, k) for k in self.constants], "v")
        yield from self._function("begin", self.p, list(self.copies.start), "v")
        for name, results in self.moving.items():
            only_where = self.copies.positive if name == "rates" else ()
            yield from self._function(name, ["t", *self.y, *self.c], results, "c", only_where)
        yield from self._follow()

    # -- operations ---------------------------------------------------------------------------
    def _constants(self) -> list[int]:
        """Operations on parameters alone that moving ones, or results, take."""
        found = set[int]()
        for result in (node for nodes in (*self.moving.values(), self.copies.positive) for node in nodes):
            below = [k for k in self.graph.below(result) if self.graph.moves(k)]
            taken = {part for k in below for part in self.graph.taken(k)} | {result.at}
            found |= {k for k in taken if not self.graph.moves(k) and self.graph.operation(k)[0] != CONSTANT}
        return sorted(found)

    def _function(
        self,
        name: str,
        arguments: Sequence[str],
        results: Sequence[ProgramNode],
        still: str,
        only_where: Sequence[ProgramNode] = (),
    ) -> Iterator[str]:
        """A function of some names; nothing where it has no results. still: the letter of what does not move;
        only_where: what has to be positive, or all results are NaN, so that no step goes beyond."""
        if not results:
            return
        needed = set[int]().union(*(self.graph.below(r) for r in (*results, *only_where)))
        yield f"def {name}({', '.join(arguments)}):"
        for k in sorted(needed):
            is_here = still == "v" or self.graph.moves(k)
            if is_here and self.graph.operation(k)[0] not in (CONSTANT, TIME, INPUT):
                yield f"    v{k} = {self._operation(k, still)}"
        if only_where:
            yield f"    if not ({' and '.join(f'{self._named(r.at, still)} > 0.0' for r in only_where)}):"
            yield f"        return ({'math.nan, ' * len(results)})"
        yield f"    return ({''.join(self._named(r.at, still) + ', ' for r in results)})"
        yield ""

    def _operation(self, k: int, still: str) -> str:
        op, i, j, c = self.graph.operation(k)
        x = self._named(i, still)
        if op in _SIGNS:
            return f"{x} {_SIGNS[op]} {self._named(j, still)}"
        if op == POWER:
            return f"{x} ** {_number(c)}"
        if op == ARGUMENT:
            return f"math.atan2({self._named(j, still)}, {x})"
        if op == ABS:
            return f"abs({x})"
        if op == SIGN:
            return f"(1.0 if {x} > 0.0 else (-1.0 if {x} < 0.0 else 0.0))"
        if FUNCTIONS[op - SQRT] in FRESNEL:
            raise CannotAnswer(Message("many copies together know no Fresnel integrals"))
        return f"math.{FUNCTIONS[op - SQRT]}({x})"

    def _named(self, k: int, still: str) -> str:
        op, i, _j, c = self.graph.operation(k)
        if op == CONSTANT:
            return _number(c)
        if op == TIME:
            return "t"
        if still == "c" and not self.graph.moves(k):
            return f"c{k}"
        if op == INPUT:
            return f"y{i}" if i < self.n else f"p{i - self.n}"
        return f"v{k}"

    # -- one copy -----------------------------------------------------------------------------
    def _follow(self) -> Iterator[str]:
        yield "def follow(i, P, times, tolerance, most, out, top, code):"
        yield from _inside(1, self._beginning())
        yield "    while j < n_times:"
        yield "        left = times[j] - t"
        yield "        if left <= 0.0:"
        yield from _inside(3, self._looked_at())
        yield "            j += 1"
        yield "            continue"
        yield from _inside(2, self._tried())
        yield from _inside(2, self._accepted())
        yield "    code[i] = 1"

    def _beginning(self) -> Iterator[str]:
        yield "code[i] = 0"
        yield from (f"p{k} = P[i, {k}]" for k in range(len(self.p)))
        if self.c:
            yield f"{_tuple(self.c)} = constants({', '.join(self.p)})"
        yield f"{_tuple(self.y)} = begin({', '.join(self.p)})"
        yield "t, j, n_tries, n_times, moved = 0.0, 0, 0, len(times), 0.0"
        yield "end = times[n_times - 1]"
        yield f"{self._k(0)} = {self._call('rates', 't', self.y)}"
        speeds = [k for k, is_speed in enumerate(self.copies.is_speed) if is_speed]
        yield "fastest, hardest = 0.0, 0.0"
        for k in speeds:
            yield f"fastest = max(fastest, abs(y{k}) * {self._per(k)})"
            yield f"hardest = max(hardest, abs(k0_{k}) * {self._per(k)})"
        # as the engine begins: a speed that moves nothing by a thousandth of its size does not matter
        yield "speed, rate, coming = max(fastest, 1e-3 / end), fastest + math.sqrt(hardest), end"
        yield "if rate > 0.0:"
        yield f"    coming = min(end, 0.1 / rate * (tolerance * 1e6) ** {_number(1.0 / self._order)})"
        yield from (f"f{k} = y{k}" for k in self._places)
        for e, one in enumerate(self.copies.extremes):
            yield f"w{e}, r{e} = 0.0, 0.0"
            yield f"best{e} = 0.0"
            _ = one
        if self.turning:
            yield f"{self._turned('w', 'r')} = {self._call('turning', 't', self.y)}"
            yield from (f"best{e} = {_side(one)}w{e}" for e, one in enumerate(self.copies.extremes))
            yield from self._best()

    def _tried(self) -> Iterator[str]:
        """Tries steps until one is allowed."""
        yield "h, was_rejected = coming, False"
        yield "while True:"
        yield f"    if n_tries >= most or not h >= {_number(16.0 * EPSILON)} * end:"
        yield "        return"
        yield "    n_tries += 1"
        yield "    is_last = h >= left * (1.0 - 1e-12)"
        yield "    if is_last:"
        yield "        h = left"
        yield "    elif 2.0 * h > left:"
        yield "        h = 0.5 * left"
        yield from _inside(1, self._stages())
        yield from _inside(1, self._error())
        yield "    if error <= 1.0:"
        yield "        break"
        yield "    was_rejected = True"
        yield "    if error < math.inf:"
        yield f"        h *= max(0.2, 0.9 * error ** {_number(-1.0 / self._order)})"
        yield "    else:"
        yield "        h *= 0.2"

    def _stages(self) -> Iterator[str]:
        a, c, n_stages = self.tableau.a, self.tableau.c, int(self.tableau.sizes[0])
        for s in range(1, n_stages + 1):
            names = [f"z{k}" for k in range(self.n)]
            for k, name in enumerate(names):
                yield f"{name} = y{k} + h * ({self._sum(a[s], k)})"
            yield f"{self._k(s)} = {self._call('rates', f't + {_number(c[s])} * h', names)}"

    def _error(self) -> Iterator[str]:
        """The norm of `kernels.stages.error_of`."""
        yield "hard = 0.0"
        for k, is_speed in enumerate(self.copies.is_speed):
            if is_speed:
                yield f"hard = max(hard, abs(k0_{k}) * {self._per(k)})"
        yield "by_speed = max(speed, h * hard)"
        yield "by_move = min(1.0, max(moved, h * by_speed))"
        yield "first, second = 0.0, 0.0"
        for k, is_speed in enumerate(self.copies.is_speed):
            size = "by_speed" if is_speed else "by_move"
            yield f"scale = tolerance * {_number(self.copies.units[k])} * {size} + {_number(4.0 * EPSILON)} * abs(y{k})"
            for name, row in zip(("first", "second"), self.tableau.error, strict=True):
                yield f"e = abs({self._sum(row, k)}) / scale"
                yield f"if not e <= {name}:"
                yield f"    {name} = e"
        yield "error = h * first"
        yield "if second > 0.0:"
        yield "    error *= first / math.sqrt(first * first + 0.01 * second * second)"
        last = int(self.tableau.sizes[0])
        yield f"if not ({' + '.join(f'abs(k{last}_{k})' for k in range(self.n))}) < math.inf:"
        yield "    error = math.nan"

    def _accepted(self) -> Iterator[str]:
        last = int(self.tableau.sizes[0])
        yield f"growth = min(5.0, 0.9 * max(error, 1e-30) ** {_number(-1.0 / self._order)})"
        yield "if was_rejected:"
        yield "    growth = min(1.0, growth)"
        yield "if not (is_last and growth * h < coming):"
        yield "    coming = h * max(0.2, growth)"
        if self.turning:
            yield from self._looked_all_along()
        for k in range(self.n):
            yield f"y{k} = z{k}"
            yield f"k0_{k} = k{last}_{k}"
        for k, is_speed in enumerate(self.copies.is_speed):
            if is_speed:
                yield f"speed = max(speed, abs(y{k}) * {self._per(k)})"
            else:
                yield f"moved = max(moved, abs(y{k} - f{k}) * {self._per(k)})"
        yield "t = times[j] if is_last else t + h"
        yield from self._closed()
        yield "if is_last:"
        yield from _inside(1, self._looked_at())
        yield "    j += 1"

    def _closed(self) -> Iterator[str]:
        """Gives up a copy whose loops have opened."""
        names = [f"g{k}" for k in range(len(self.copies.gaps))]
        if names:
            yield f"{_tuple(names)} = {self._call('gaps', 't', self.y)}"
            yield f"if not ({' and '.join(f'abs({g}) <= {_number(LOOSE)} * tolerance' for g in names)}):"
            yield "    return"

    def _looked_at(self) -> Iterator[str]:
        names = [f"s{k}" for k in range(len(self.copies.watched))]
        if names:
            yield f"{_tuple(names)} = {self._call('watched', 't', self.y)}"
            yield from (f"out[i, j, {k}] = {name}" for k, name in enumerate(names))

    # -- extremes -----------------------------------------------------------------------------
    def _looked_all_along(self) -> Iterator[str]:
        """Extremes in a step, by its dense output (`kernels.stages.interpolant`)."""
        a, c, dense = self.tableau.a, self.tableau.c, self.tableau.dense
        n_stages, n_extra = int(self.tableau.sizes[0]), int(self.tableau.sizes[1])
        for s in range(n_stages + 1, n_stages + 1 + n_extra):
            names = [f"x{k}" for k in range(self.n)]
            yield from (f"{x} = y{k} + h * ({self._sum(a[s], k)})" for k, x in enumerate(names))
            yield f"{self._k(s)} = {self._call('rates', f't + {_number(c[s])} * h', names)}"
        for k in range(self.n):
            yield f"d0_{k} = z{k} - y{k}"
            yield f"d1_{k} = h * k0_{k} - d0_{k}"
            yield f"d2_{k} = 2.0 * d0_{k} - h * (k0_{k} + k{n_stages}_{k})"
            yield from (f"d{3 + m}_{k} = h * ({self._sum(row, k)})" for m, row in enumerate(dense))
        yield f"for part in range(1, {N_PARTS + 1}):"
        yield f"    s = part / {N_PARTS}.0"
        for k in range(self.n):
            text = f"d{2 + len(dense)}_{k}"
            for m in range(2 + len(dense), 0, -1):
                text = f"({text} * {'s' if m % 2 == 0 else '(1.0 - s)'} + d{m - 1}_{k})"
            yield f"    x{k} = y{k} + s * {text}"
        yield f"    {self._turned('v', 'q')} = {self._call('turning', 't + s * h', [f'x{k}' for k in range(self.n)])}"
        yield from _inside(1, (line for e, one in enumerate(self.copies.extremes) for line in self._turn(e, one)))
        yield from self._best()

    def _turn(self, e: int, one: Extreme) -> Iterator[str]:
        """The value at a part of a step, and that at which a rise turned into a fall since the last one: the top of the
        cubic with these values and rates, as `records.extremes` has it."""
        side, length = _side(one), f"h / {N_PARTS}.0"
        yield f"best{e} = max(best{e}, {side}v{e})"
        yield f"up, down = {side}r{e} * {length}, {side}q{e} * {length}"
        yield "if up > 0.0 and down < 0.0:"
        yield f"    rise = {side}v{e} - {side}w{e}"
        yield "    a3, a2 = up + down - 2.0 * rise, 3.0 * rise - 2.0 * up - down"
        yield "    at = up / (math.sqrt(max(a2 * a2 - 3.0 * a3 * up, 0.0)) - a2)"
        yield f"    best{e} = max(best{e}, {side}w{e} + at * (up + at * (a2 + at * a3)))"
        yield f"w{e}, r{e} = v{e}, q{e}"

    def _best(self) -> Iterator[str]:
        yield from (f"top[i, {e}] = {_side(one)}best{e}" for e, one in enumerate(self.copies.extremes))

    def _turned(self, value: str, rate: str) -> str:
        return _tuple([f"{letter}{e}" for e in range(len(self.copies.extremes)) for letter in (value, rate)])

    # -- parts of lines -----------------------------------------------------------------------
    @property
    def _order(self) -> int:
        return int(self.tableau.sizes[2])

    @property
    def _places(self) -> list[int]:
        return [k for k, is_speed in enumerate(self.copies.is_speed) if not is_speed]

    def _per(self, k: int) -> str:
        return _number(1.0 / self.copies.units[k])

    def _k(self, s: int) -> str:
        return _tuple([f"k{s}_{k}" for k in range(self.n)])

    def _sum(self, row: Iterable[float], k: int) -> str:
        return " + ".join(f"{_number(x)} * k{s}_{k}" for s, x in enumerate(row) if x != 0.0)

    def _call(self, name: str, time: str, states: Sequence[str]) -> str:
        return f"{name}({', '.join([time, *states, *self.c])})"


def _tuple(names: Sequence[str]) -> str:
    return "".join(f"{name}, " for name in names).rstrip() if len(names) == 1 else ", ".join(names)


def _inside(depth: int, lines: Iterable[str]) -> Iterator[str]:
    for line in lines:
        yield "    " * depth + line


def _side(one: Extreme) -> str:
    return "" if one.side > 0 else "-"


def _number(x: float) -> str:
    """A number as it stands in the text; what is negative in brackets."""
    text = repr(float(x))
    text = {"inf": "math.inf", "-inf": "(-math.inf)", "nan": "math.nan"}.get(text, text)
    return f"({text})" if text.startswith("-") else text
