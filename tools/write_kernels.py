"""Writes src/freebody/numeric/engine/measures_planar.py from the statements of the measures.

    python tools/write_kernels.py            writes the file
    python tools/write_kernels.py --check    fails if the file is not what would be written

Each statement is run once over symbols. Its gradient and its bias (the second derivative along a motion without
acceleration) follow by a derivation D that knows

    D cos = -sin D angle,   D sin = cos D angle,
    v = l e(a) + rho n(a):  D a = n . D v / l,   D l = e . D v + rho D a,   D e = n D a.

Entries of the gradient that depend on numbers of the model alone are written once, by `fill`.
"""

from __future__ import annotations

import sys
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, fields
from pathlib import Path
from typing import Any

import sympy as sp

from freebody.language.expression import Expr, Number, Symbol
from freebody.measures.angle import Angle
from freebody.measures.displacement import Displacement
from freebody.measures.distance import Bearing, Distance
from freebody.measures.geometry import GROUND, Direction, Point, Pose, Vector
from freebody.measures.lead import Lead

TARGET = Path(__file__).parents[1] / "src/freebody/numeric/engine/measures_planar.py"

# kinds of measure, and the fields whose body is the ground, for which shorter code is written
KINDS: list[tuple[type[Any], tuple[str, ...]]] = [
    (Displacement, ("along",)),
    (Displacement, ()),
    (Angle, ()),
    (Distance, ()),
    (Bearing, ()),
    (Lead, ()),
]


@dataclass
class Statement:
    """One kind of measure over symbols."""

    name: str
    bodies: list[str]
    numbers: list[sp.Symbol]
    value: sp.Expr
    geometry: SymbolGeometry


class SymbolGeometry:
    """A `Geometry` whose scalars are symbols; tangents are named and remembered."""

    def __init__(self, bodies: list[str]) -> None:
        self._bodies = bodies
        self.tangents: list[tuple[sp.Symbol, sp.Symbol, sp.Symbol, sp.Symbol, Vector[sp.Expr], sp.Expr]] = []

    def scalar(self, expr: Expr) -> sp.Expr:
        match expr:
            case Number(value):
                return sp.Rational(value.numerator, value.denominator)
            case Symbol(name):
                return sp.Symbol(name, real=True)
        raise TypeError(f"a field of a measure holds {expr}")

    def pose(self, body: str) -> Pose[sp.Expr]:
        if body == GROUND:
            return Pose(sp.S(0), sp.S(0), sp.S(0), sp.S(1), sp.S(0))
        k = self._bodies.index(body)
        x, y, angle, cos, sin = (sp.Symbol(f"{n}{k}", real=True) for n in ("x", "y", "angle", "cos", "sin"))
        return Pose(x, y, angle, cos, sin)

    def tangent(self, v: Vector[sp.Expr], offset: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
        k = len(self.tangents)
        length, angle, ex, ey = (sp.Symbol(f"{n}_{k}", real=True) for n in ("length", "bearing", "ex", "ey"))
        self.tangents.append((length, angle, ex, ey, v, offset))
        return length, angle

    def apply(self, expr: Expr, values: dict[str, Any]) -> Any:
        raise TypeError("expressions are evaluated by tapes, not by kernels")

    # -- the derivation -----------------------------------------------------------------------
    def derivative(self, f: sp.Expr, d: Mapping[str, sp.Expr]) -> sp.Expr:
        """D f, where D of x0, y0, angle0 ... is given."""
        known: dict[sp.Symbol, sp.Expr] = {}
        for name, value in d.items():
            known[sp.Symbol(name, real=True)] = value
            if name.startswith("angle"):
                k = name.removeprefix("angle")
                cos, sin = sp.Symbol(f"cos{k}", real=True), sp.Symbol(f"sin{k}", real=True)
                known[cos], known[sin] = -sin * value, cos * value

        def along(g: sp.Expr) -> sp.Expr:
            return sum((sp.diff(g, s) * ds for s, ds in known.items()), sp.S(0))

        for length, angle, ex, ey, v, rho in self.tangents:
            dx, dy = along(v.x), along(v.y)
            turn = (ex * dy - ey * dx) / length
            known[angle], known[length] = turn, ex * dx + ey * dy + rho * turn
            known[ex], known[ey] = -ey * turn, ex * turn
        return along(f)


def statement(kind: type[Any], on_ground: tuple[str, ...]) -> Statement:
    """Runs the statement of a kind over symbols: one body for each field that has one, numbers in their order."""
    bodies: list[str] = []
    numbers: list[sp.Symbol] = []

    def new_number() -> Symbol:
        numbers.append(sp.Symbol(f"p{len(numbers)}", real=True))
        return Symbol(f"p{len(numbers) - 1}")

    def new_body(name: str) -> str:
        if name in on_ground:
            return GROUND
        bodies.append(name)
        return name

    values: dict[str, Any] = {}
    for f in fields(kind):
        if f.type == "Point":
            values[f.name] = Point(new_body(f.name), (new_number(), new_number()))
        elif f.type == "Direction":
            values[f.name] = Direction(new_body(f.name), (new_number(), new_number()))
        elif f.type == "str":
            values[f.name] = new_body(f.name)
        elif f.type == "Expr":
            values[f.name] = new_number()
        else:
            raise TypeError(f"{kind.__name__}.{f.name}: no kernel can be written for a field of type {f.type}")
    geometry = SymbolGeometry(bodies)
    value = kind(**values).value(geometry)
    name = kind.__name__ + "".join(f", {field} fixed" for field in on_ground)
    return Statement(name, bodies, numbers, value, geometry)


# -- writing ----------------------------------------------------------------------------------
def code(expr: sp.Expr) -> str:
    return sp.pycode(expr, fully_qualified_modules=False)


def names(expr: sp.Expr) -> set[str]:
    return {str(s) for s in expr.free_symbols}


def loads_of(n_bodies: int, needed: set[str]) -> Iterator[str]:
    """Reads what the lines to come need, and nothing else."""
    for k in range(n_bodies):
        arrays = {
            f"x{k}": f"q[b{k}, 0]",
            f"y{k}": f"q[b{k}, 1]",
            f"angle{k}": f"q[b{k}, 2]",
            f"cos{k}": f"turn[b{k}, 0]",
            f"sin{k}": f"turn[b{k}, 1]",
            f"vx{k}": f"v[b{k}, 0]",
            f"vy{k}": f"v[b{k}, 1]",
            f"w{k}": f"v[b{k}, 2]",
        }
        used = [(name, where) for name, where in arrays.items() if name in needed]
        if used:
            yield f"b{k} = bodies[k, {k}]"
            yield from (f"{name} = {where}" for name, where in used)


def numbers_of(numbers: list[sp.Symbol], needed: set[str]) -> Iterator[str]:
    for j, p in enumerate(numbers):
        if str(p) in needed:
            yield f"{p} = numbers[k, {j}]"


def loop(index: int, s: Statement) -> tuple[list[str], list[str], list[int]]:
    """The lines inside the loops of `measure` and of `fill` for one kind, and which entries never change."""
    n = len(s.bodies)
    g = s.geometry
    coordinates = [f"{c}{k}" for k in range(n) for c in ("x", "y", "angle")]
    speeds = [sp.Symbol(f"{c}{k}", real=True) for k in range(n) for c in ("vx", "vy", "w")]
    gradient = [sp.factor_terms(g.derivative(s.value, {c: sp.S(1)})) for c in coordinates]
    motion = dict(zip(coordinates, speeds, strict=True))
    bias = sum((g.derivative(entry, motion) * speed for entry, speed in zip(gradient, speeds, strict=True)), sp.S(0))

    tangent_lines: list[str] = []
    for length, angle, ex, ey, v, rho in g.tangents:
        tangent_lines += [
            f"dx, dy, rho = {code(v.x)}, {code(v.y)}, {code(rho)}",
            f"{length} = math.sqrt(dx * dx + dy * dy - rho * rho)",
            "square = dx * dx + dy * dy",
            f"{ex}, {ey} = ({length} * dx + rho * dy) / square, ({length} * dy - rho * dx) / square",
            f"{angle} = math.atan2({ey}, {ex})",
            f"{angle} += TURN * math.floor((out[k, NEAR] - {angle}) / TURN + 0.5)",
            f"out[k, BEARING] = {angle}",
        ]
    fixed = [j for j, entry in enumerate(gradient) if names(entry) <= {str(p) for p in s.numbers}]
    moving = [(j, entry) for j, entry in enumerate(gradient) if j not in fixed]
    results = [s.value, bias, *(entry for _j, entry in moving)]
    shared, (value, last, *entries) = sp.cse(results, sp.numbered_symbols("u"), order="none")
    used = set().union(*(names(e) for e in results)) | set().union(
        *(names(v.x) | names(v.y) | names(sp.sympify(rho)) for *_r, v, rho in g.tangents)
    )
    offset = f"starts[{index}] + {3 * n} * (k - kinds[{index}])"
    body = [*loads_of(n, used), *numbers_of(s.numbers, used), *tangent_lines]
    body += [f"{name} = {code(e)}" for name, e in shared]
    body += [f"out[k, VALUE] = {code(value)}", f"out[k, BIAS] = {code(last)}"]
    if moving:
        body += [f"o = {offset}"]
        body += [f"gradient[o + {j}] = {code(e)}" for (j, _), e in zip(moving, entries, strict=True)]

    constant = [(j, gradient[j]) for j in fixed if gradient[j] != 0]
    fill: list[str] = []
    if constant:
        fill = [*numbers_of(s.numbers, set().union(*(names(e) for _j, e in constant))), f"o = {offset}"]
        fill += [f"gradient[o + {j}] = {code(e)}" for j, e in constant]
    return body, fill, fixed


def text() -> str:
    statements = [statement(kind, ground) for kind, ground in KINDS]
    measure: list[str] = []
    fill: list[str] = []
    unchanging: list[tuple[int, ...]] = []
    for index, s in enumerate(statements):
        body, constants, fixed = loop(index, s)
        unchanging.append(tuple(fixed))
        head = [
            f"    # {s.name}: bodies {', '.join(s.bodies)}",
            f"    for k in range(kinds[{index}], kinds[{index + 1}]):",
        ]
        measure += head + [f"        {line}" for line in body]
        if constants:
            fill += head + [f"        {line}" for line in constants]
    n_bodies = max(len(s.bodies) for s in statements)
    n_numbers = max(len(s.numbers) for s in statements)
    listed = [
        f'    Kind("{kind.__name__}", {ground!r}, {len(s.bodies)}, {len(s.numbers)}, '
        f"{bool(s.geometry.tangents)}, {fixed!r}),"
        for (kind, ground), s, fixed in zip(KINDS, statements, unchanging, strict=True)
    ]
    return "\n".join(
        [
            '"""Value, gradient and bias of every kind of measure. Written by tools/write_kernels.py; do not edit.',
            "",
            "Measures of a kind stand together: those of kind i are kinds[i] <= k < kinds[i + 1]. The gradient of",
            "measure k has three entries (x, y, angle) for each of its bodies and begins at",
            "starts[i] + 3 n_bodies (k - kinds[i]).",
            '"""',
            "",
            "# pyright: basic",
            "",
            "import math",
            "from typing import Any, NamedTuple",
            "",
            "from freebody.numeric.engine.jit import kernel",
            "",
            "TURN = 2.0 * math.pi",
            f"MAX_BODIES = {n_bodies}",
            f"MAX_NUMBERS = {n_numbers}",
            "VALUE, BIAS, BEARING, NEAR = range(4)  # what stands in `out` of every measure",
            "",
            "",
            "class Kind(NamedTuple):",
            '    """A kind of measure: the fields whose body is fixed, how many bodies and numbers it has."""',
            "",
            "    name: str",
            "    fixed: tuple[str, ...]",
            "    n_bodies: int",
            "    n_numbers: int",
            "    has_bearing: bool",
            "    unchanging: tuple[int, ...]  # entries of the gradient that are the same in every pose",
            "",
            "",
            "KINDS = (",
            *listed,
            ")",
            "",
            "",
            "@kernel",
            "def measure(kinds, starts, bodies, numbers, q, v, turn, out, gradient):",
            *measure,
            "",
            "",
            "def fill(kinds: Any, starts: Any, numbers: Any, gradient: Any) -> None:",
            *fill,
            "",
        ]
    )


def formatted(source: str) -> str:
    import subprocess

    done = subprocess.run(
        [sys.executable, "-m", "ruff", "format", "--line-length", "120", "-"],
        input=source,
        capture_output=True,
        text=True,
        check=True,
    )
    return done.stdout


if __name__ == "__main__":
    written = formatted(text())
    if "--check" in sys.argv:
        sys.exit(0 if TARGET.read_text(encoding="utf-8") == written else f"{TARGET} is not current; run {sys.argv[0]}")
    TARGET.write_text(written, encoding="utf-8")
