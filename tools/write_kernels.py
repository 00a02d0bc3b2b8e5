"""Writes the kernels of the measures, of the plane and of space, from their statements.

    python tools/write_kernels.py            writes src/freebody/numeric/kernels/measures_planar.py, measures_spatial.py
    python tools/write_kernels.py --check    fails if the files are not what would be written

Each statement is run once over symbols. Its gradient and its bias (the second derivative along a motion without
acceleration) follow by a derivation D that knows

    D cos = -sin D angle,   D sin = cos D angle,   D sqrt(x) = D x / (2 sqrt(x)),
    v = l e(a) + rho n(a):  D a = n . D v / l,   D l = e . D v + rho D a,   D e = n D a.

In space a vector fixed in a body, u = R p, is named where a statement uses it. With w the angular velocity by body
components, D u = R (w x p) and D D u = R (w x (w x p)) without acceleration; so a value f(u) has the gradient
p x R^T df/du by w.

Entries of the gradient that depend on numbers of the model alone are written once, by `fill`.
"""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, fields
from pathlib import Path
from typing import Any

import sympy as sp

from freebody.language.expression import Expr, Number, Symbol
from freebody.measures.angle import Angle
from freebody.measures.displacement import Displacement
from freebody.measures.distance import Bearing, Distance
from freebody.measures.geometry import GROUND, Direction, Point, Pose, SpatialPose, Vector
from freebody.measures.lead import Lead, LeadInPlane
from freebody.measures.turn import Alignment, Turn

ENGINE = Path(__file__).parents[1] / "src/freebody/numeric/kernels"
Kinds = list[tuple[type[Any], tuple[str, ...]]]

# kinds of measure, and the fields whose body is the ground, for which shorter code is written
PLANAR: Kinds = [
    (Displacement, ("along",)),
    (Displacement, ()),
    (Angle, ()),
    (Distance, ()),
    (Bearing, ()),
    (Lead, ()),
]
SPATIAL: Kinds = [
    (Displacement, ("along",)),
    (Displacement, ()),
    (Distance, ()),
    (Alignment, ("of",)),
    (Alignment, ("along",)),
    (Alignment, ()),
    (Turn, ()),
    (Angle, ()),
    (Bearing, ()),
    (Lead, ()),
    (LeadInPlane, ()),
]


def symbol(name: str) -> sp.Symbol:
    return sp.Symbol(name, real=True)


@dataclass
class Statement:
    """One kind of measure over symbols."""

    name: str
    bodies: list[str]
    numbers: list[sp.Symbol]
    offsets: list[tuple[sp.Symbol, ...]]  # which of the numbers are the components of one point
    value: sp.Expr
    geometry: SymbolGeometry


class SymbolGeometry:
    """A `Geometry` whose scalars are symbols; tangents and roots are named and remembered."""

    def __init__(self, bodies: list[str]) -> None:
        self._bodies = bodies
        self.tangents: list[tuple[sp.Symbol, sp.Symbol, sp.Symbol, sp.Symbol, Vector[sp.Expr], sp.Expr]] = []
        self.roots: list[tuple[sp.Symbol, sp.Expr]] = []

    def scalar(self, expr: Expr) -> sp.Expr:
        match expr:
            case Number(value):
                return sp.Rational(value.numerator, value.denominator)
            case Symbol(name):
                return symbol(name)
        raise TypeError(f"a field of a measure holds {expr}")

    def pose(self, body: str) -> Any:
        if body == GROUND:
            return Pose(sp.S(0), sp.S(0), sp.S(0), sp.S(1), sp.S(0))
        k = self._bodies.index(body)
        return Pose(*(symbol(f"{n}{k}") for n in ("x", "y", "angle", "cos", "sin")))

    def root(self, x: sp.Expr) -> sp.Expr:
        self.roots.append((symbol(f"root_{len(self.roots)}"), x))
        return self.roots[-1][0]

    def tangent(self, v: Vector[sp.Expr], offset: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
        k = len(self.tangents)
        length, angle, ex, ey = (symbol(f"{n}_{k}") for n in ("length", "bearing", "ex", "ey"))
        self.tangents.append((length, angle, ex, ey, v, offset))
        return length, angle

    def apply(self, expr: Expr, values: dict[str, Any]) -> Any:
        raise TypeError("expressions are evaluated by tapes, not by kernels")

    # -- the derivation -----------------------------------------------------------------------
    def derivative(self, f: sp.Expr, d: Mapping[str, sp.Expr]) -> sp.Expr:
        """D f, where D of x0, y0, angle0 ... is given."""
        known: dict[sp.Symbol, sp.Expr] = {}
        for name, value in d.items():
            known[symbol(name)] = value
            if name.startswith("angle"):
                k = name.removeprefix("angle")
                cos, sin = symbol(f"cos{k}"), symbol(f"sin{k}")
                known[cos], known[sin] = -sin * value, cos * value

        def along(g: sp.Expr) -> sp.Expr:
            return sum((sp.diff(g, s) * ds for s, ds in known.items()), sp.S(0))

        for length, angle, ex, ey, v, rho in self.tangents:
            dx, dy = along(v.x), along(v.y)
            turn = (ex * dy - ey * dx) / length
            known[angle], known[length] = turn, ex * dx + ey * dy + rho * turn
            known[ex], known[ey] = -ey * turn, ex * turn
        for root, x in self.roots:
            known[root] = along(x) / (2 * root)
        return along(f)

    def lines(self) -> tuple[list[str], set[str]]:
        """What names tangents and roots in a kernel, and the names that it reads."""
        lines: list[str] = []
        used: set[str] = set()
        for length, angle, ex, ey, v, rho in self.tangents:
            used |= names(v.x) | names(v.y) | names(sp.sympify(rho))
            lines += [
                f"dx, dy, rho = {code(v.x)}, {code(v.y)}, {code(rho)}",
                f"{length} = math.sqrt(dx * dx + dy * dy - rho * rho)",
                "square = dx * dx + dy * dy",
                f"{ex}, {ey} = ({length} * dx + rho * dy) / square, ({length} * dy - rho * dx) / square",
                f"{angle} = math.atan2({ey}, {ex})",
                f"{angle} += TURN * math.floor((out[k, NEAR] - {angle}) / TURN + 0.5)",
                f"out[k, BEARING] = {angle}",
            ]
        for root, x in self.roots:
            used |= names(x)
            lines.append(f"{root} = math.sqrt({code(x)})")
        return lines, used


@dataclass(frozen=True)
class Fixed:
    """u = R p of a body: its ground components, and p."""

    name: str
    body: int
    components: tuple[sp.Expr, sp.Expr, sp.Expr]

    @property
    def vector(self) -> list[sp.Symbol]:
        return [symbol(f"{self.name}{c}") for c in "xyz"]

    @property
    def rate(self) -> list[sp.Symbol]:
        return [symbol(f"d{self.name}{c}") for c in "xyz"]

    @property
    def pull(self) -> list[sp.Symbol]:
        """R^T df/du."""
        return [symbol(f"pull_{self.name}{c}") for c in "xyz"]

    @property
    def turning(self) -> list[sp.Symbol]:
        """w x p, by body components."""
        return [symbol(f"t_{self.name}{c}") for c in "xyz"]

    @property
    def moment(self) -> list[sp.Symbol]:
        """p x R^T df/du."""
        return [symbol(f"m_{self.name}{c}") for c in "xyz"]

    @property
    def centripetal(self) -> list[sp.Symbol]:
        """w x (w x p), by body components."""
        return [symbol(f"c_{self.name}{c}") for c in "xyz"]


class NamedPose(SpatialPose[sp.Expr]):
    """A pose that names the vectors which it turns."""

    def __init__(self, geometry: SpaceGeometry, body: int, axes: Sequence[sp.Expr]) -> None:
        self._geometry, self._body = geometry, body
        triples = [Vector(*axes[i : i + 3]) for i in range(0, len(axes), 3)]
        object.__setattr__(self, "center", Vector(*(symbol(f"{c}{body}") for c in "xyz")))
        object.__setattr__(self, "axes", tuple(self.turn(v) for v in triples))

    def turn(self, v: Vector[sp.Expr]) -> Vector[sp.Expr]:
        return self._geometry.named(self._body, v)


class SpaceGeometry(SymbolGeometry):
    """Space: vectors fixed in bodies are named and remembered. axes: of bodies whose axes a statement reads, these by
    nine components in the frame of the kernel."""

    def __init__(self, bodies: list[str], axes: Mapping[str, list[sp.Symbol]]) -> None:
        super().__init__(bodies)
        self._axes = axes
        self.fixed: list[Fixed] = []

    def pose(self, body: str) -> SpatialPose[sp.Expr]:
        if body == GROUND:
            o, i = sp.S(0), sp.S(1)
            return SpatialPose(Vector(o, o, o), (Vector(i, o, o), Vector(o, i, o), Vector(o, o, i)))
        return NamedPose(self, self._bodies.index(body), self._axes.get(body, []))

    def named(self, body: int, v: Vector[sp.Expr]) -> Vector[sp.Expr]:
        assert v.z is not None
        p = (v.x, v.y, v.z)
        known = next((u for u in self.fixed if u.body == body and u.components == p), None)
        if known is None:
            known = Fixed(f"r{len(self.fixed)}", body, p)
            self.fixed.append(known)
        return Vector(*known.vector)


def statement(kind: type[Any], on_ground: tuple[str, ...], n_axes: int) -> Statement:
    """Runs the statement of a kind over symbols: one body for each field that has one, numbers in their order. n_axes:
    dimensions; in space a body whose axes are read has these among its numbers."""
    bodies: list[str] = []
    numbers: list[sp.Symbol] = []
    offsets: list[tuple[sp.Symbol, ...]] = []
    axes: dict[str, list[sp.Symbol]] = {}

    def new_number() -> Symbol:
        numbers.append(symbol(f"p{len(numbers)}"))
        return Symbol(f"p{len(numbers) - 1}")

    def new_vector() -> tuple[Symbol, ...]:
        return tuple(new_number() for _ in range(n_axes))

    def new_body(name: str) -> str:
        if name in on_ground:
            return GROUND
        bodies.append(name)
        return name

    values: dict[str, Any] = {}
    for f in fields(kind):
        if f.type == "Point":
            offset = new_vector()
            offsets.append(tuple(symbol(n.name) for n in offset))
            values[f.name] = Point(new_body(f.name), offset)
        elif f.type == "Direction":
            values[f.name] = Direction(new_body(f.name), new_vector())
        elif f.type == "str":
            values[f.name] = new_body(f.name)
            if n_axes == 3:
                axes[f.name] = [symbol(n.name) for _ in range(3) for n in new_vector()]
        elif f.type == "Expr":
            values[f.name] = new_number()
        else:
            raise TypeError(f"{kind.__name__}.{f.name}: no kernel can be written for a field of type {f.type}")
    geometry = SymbolGeometry(bodies) if n_axes == 2 else SpaceGeometry(bodies, axes)
    value = kind(**values).value(geometry)
    name = kind.__name__ + "".join(f", {field} fixed" for field in on_ground)
    return Statement(name, bodies, numbers, offsets, value, geometry)


# -- writing ----------------------------------------------------------------------------------
def code(expr: sp.Expr) -> str:
    return sp.pycode(expr, fully_qualified_modules=False)


def names(expr: sp.Expr) -> set[str]:
    return {str(s) for s in expr.free_symbols}


def reads(k: int, arrays: Mapping[str, str], needed: set[str]) -> Iterator[str]:
    """Reads what the lines to come need of body k, and nothing else."""
    used = [(name, where) for name, where in arrays.items() if name in needed]
    if used or f"b{k}" in needed:
        yield f"b{k} = bodies[k, {k}]"
    yield from (f"{name} = {where}" for name, where in used)


def numbers_of(numbers: list[sp.Symbol], needed: set[str]) -> Iterator[str]:
    for j, p in enumerate(numbers):
        if str(p) in needed:
            yield f"{p} = numbers[k, {j}]"


@dataclass
class Loop:
    """The lines inside the loops of `measure` and of `fill` for one kind; which entries never change; entries that
    vanish where all of some numbers do."""

    body: list[str]
    fill: list[str]
    fixed: list[int]
    vanishing: list[tuple[int, tuple[int, ...]]]


def constants_of(
    s: Statement, gradient: Sequence[sp.Expr], offset: str
) -> tuple[list[int], list[tuple[int, sp.Expr]], list[str]]:
    """Which entries of a gradient never change, those that do, and the lines that fill the former."""
    fixed = [j for j, entry in enumerate(gradient) if names(entry) <= {str(p) for p in s.numbers}]
    moving = [(j, entry) for j, entry in enumerate(gradient) if j not in fixed]
    constant = [(j, gradient[j]) for j in fixed if gradient[j] != 0]
    fill: list[str] = []
    if constant:
        fill = [*numbers_of(s.numbers, set().union(*(names(e) for _j, e in constant))), f"o = {offset}"]
        fill += [f"gradient[o + {j}] = {code(e)}" for j, e in constant]
    return fixed, moving, fill


def planar_loop(index: int, s: Statement) -> Loop:
    n = len(s.bodies)
    g = s.geometry
    coordinates = [f"{c}{k}" for k in range(n) for c in ("x", "y", "angle")]
    speeds = [symbol(f"{c}{k}") for k in range(n) for c in ("vx", "vy", "w")]
    gradient = [sp.factor_terms(g.derivative(s.value, {c: sp.S(1)})) for c in coordinates]
    motion = dict(zip(coordinates, speeds, strict=True))
    bias = sum((g.derivative(entry, motion) * speed for entry, speed in zip(gradient, speeds, strict=True)), sp.S(0))

    named_lines, named = g.lines()
    offset = f"starts[{index}] + {3 * n} * (k - kinds[{index}])"
    fixed, moving, fill = constants_of(s, gradient, offset)
    results = [s.value, bias, *(entry for _j, entry in moving)]
    shared, (value, last, *entries) = sp.cse(results, sp.numbered_symbols("u"), order="none")
    used = set().union(*(names(e) for e in results)) | named
    body: list[str] = []
    for k in range(n):
        arrays = {f"x{k}": f"q[b{k}, 0]", f"y{k}": f"q[b{k}, 1]", f"angle{k}": f"q[b{k}, 2]"}
        arrays |= {f"cos{k}": f"turn[b{k}, 0]", f"sin{k}": f"turn[b{k}, 1]"}
        arrays |= {f"vx{k}": f"v[b{k}, 0]", f"vy{k}": f"v[b{k}, 1]", f"w{k}": f"v[b{k}, 2]"}
        body += reads(k, arrays, used)
    body += [*numbers_of(s.numbers, used), *named_lines]
    body += [f"{name} = {code(e)}" for name, e in shared]
    body += [f"out[k, VALUE] = {code(value)}", f"out[k, BIAS] = {code(last)}"]
    if moving:
        body += [f"o = {offset}"]
        body += [f"gradient[o + {j}] = {code(e)}" for (j, _), e in zip(moving, entries, strict=True)]
    places = {p: j for j, p in enumerate(s.numbers)}
    vanishing = [
        (j, tuple(places[p] for p in point))
        for j, entry in moving
        for point in s.offsets
        if entry.subs(dict.fromkeys(point, 0)) == 0
    ]
    return Loop(body, fill, fixed, vanishing)


def dot(a: Iterable[sp.Expr], b: Iterable[sp.Expr]) -> sp.Expr:
    return sum((x * y for x, y in zip(a, b, strict=True)), sp.S(0))


@dataclass
class Line:
    """Names, what they are set to, and what must be known before."""

    names: list[str]
    code: str
    uses: set[str]

    @classmethod
    def of(cls, name: object, value: sp.Expr) -> Line:
        return cls([str(name)], code(value), names(value))

    @classmethod
    def called(cls, results: Sequence[sp.Symbol], function: str, arguments: Sequence[str | sp.Expr]) -> Line:
        """Three names, set to what a function of `rotating` returns."""
        given = [a if isinstance(a, str) else code(a) for a in arguments]
        uses = {name for a in arguments for name in ({a} if isinstance(a, str) else names(a))}
        return cls([str(r) for r in results], f"{function}({', '.join(given)})", uses)

    def __str__(self) -> str:
        return f"{', '.join(self.names)} = {self.code}"


def spatial_loop(index: int, s: Statement) -> Loop:
    n = len(s.bodies)
    g = s.geometry
    assert isinstance(g, SpaceGeometry)
    centers = [f"{c}{k}" for k in range(n) for c in "xyz"]
    by_vector = {u.name: [g.derivative(s.value, {str(c): sp.S(1)}) for c in u.vector] for u in g.fixed}
    vectors = [u for u in g.fixed if any(by_vector[u.name])]

    # the gradient: of centres by D; of angular velocities p x pull, summed over the vectors of a body
    gradient: list[sp.Expr] = []
    for k in range(n):
        gradient += [sp.factor_terms(g.derivative(s.value, {c: sp.S(1)})) for c in centers[3 * k : 3 * k + 3]]
        gradient += [sum((u.moment[i] for u in vectors if u.body == k), sp.S(0)) for i in range(3)]
    # the bias: D D f with D D u = 0, and what that leaves out, pull . (w x (w x p))
    motion: dict[str, sp.Expr] = {c: symbol(f"v{c}") for c in centers}
    motion |= {str(c): rate for u in vectors for c, rate in zip(u.vector, u.rate, strict=True)}
    bias = g.derivative(g.derivative(s.value, motion), motion)
    bias += sum((dot(u.pull, u.centripetal) for u in vectors), sp.S(0))
    value = s.value
    named_lines, named = g.lines()
    rest = named | set().union(*(names(e) for e in (bias, *(e for part in by_vector.values() for e in part))))
    for u in vectors:  # where f is linear in u, u itself need not be computed: df/du . u = pull . p
        if not {str(c) for c in u.vector} & rest:
            value = value.subs(dict.fromkeys(u.vector, 0)) + dot(u.pull, u.components)

    offset = f"starts[{index}] + {6 * n} * (k - kinds[{index}])"
    fixed, moving, fill = constants_of(s, gradient, offset)
    entries = [e for _j, e in moving]
    pulls = [e for u in vectors for e in by_vector[u.name]]
    shared, reduced = sp.cse([*pulls, value, bias, *entries], sp.numbered_symbols("u"), order="none")
    turning = {u.name: reduced[3 * i : 3 * i + 3] for i, u in enumerate(vectors)}
    last_value, last_bias, *entries = reduced[len(pulls) :]
    late = [Line.of(name, e) for name, e in shared]
    late += [Line.called(u.pull, "returned", ["frames", f"b{u.body}", *turning[u.name]]) for u in vectors]
    late += [Line.called(u.moment, "crossed", [*u.components, *u.pull]) for u in vectors]
    late = in_order(late)
    final = [Line.of("out[k, VALUE]", last_value), Line.of("out[k, BIAS]", last_bias), Line(["o"], offset, set())]
    final += [Line.of(f"gradient[o + {j}]", e) for (j, _), e in zip(moving, entries, strict=True)]
    needed = named | set().union(*(line.uses for line in (*late, *final)))
    early, needed = needed_of(carried(vectors), needed)
    body: list[str] = []
    for k in range(n):
        arrays = {f"{c}{k}": f"q[2 * b{k}, {i}]" for i, c in enumerate("xyz")}
        arrays |= {f"v{c}{k}": f"v[2 * b{k}, {i}]" for i, c in enumerate("xyz")}
        arrays |= {f"w{c}{k}": f"v[2 * b{k} + 1, {i}]" for i, c in enumerate("xyz")}
        body += reads(k, arrays, needed)
    body += [*numbers_of(s.numbers, needed), *map(str, early), *named_lines, *map(str, late), *map(str, final)]
    return Loop(body, fill, fixed, vanishing_of(s, vectors))


def carried(vectors: Sequence[Fixed]) -> list[Line]:
    """What is known of vectors fixed in bodies before anything else."""
    found: list[Line] = []
    for u in vectors:
        w = [symbol(f"w{c}{u.body}") for c in "xyz"]
        frame = ["frames", f"b{u.body}"]
        found += [
            Line.called(u.vector, "carried", [*frame, *u.components]),
            Line.called(u.turning, "crossed", [*w, *u.components]),
            Line.called(u.rate, "carried", [*frame, *u.turning]),
            Line.called(u.centripetal, "crossed", [*w, *u.turning]),
        ]
    return found


def needed_of(lines: Sequence[Line], needed: set[str]) -> tuple[list[Line], set[str]]:
    """The lines that are needed for some names, and all names that are needed then."""
    chosen: list[Line] = []
    for line in reversed(lines):
        if needed & set(line.names):
            needed = needed | line.uses
            chosen.insert(0, line)
    return chosen, needed


def in_order(lines: Sequence[Line]) -> list[Line]:
    """Lines each after what it uses."""
    waiting, found = list(lines), list[Line]()
    while waiting:
        unknown = {name for line in waiting for name in line.names}
        ready = next(i for i, line in enumerate(waiting) if not line.uses & unknown)
        found.append(waiting.pop(ready))
    return found


def vanishing_of(s: Statement, vectors: Sequence[Fixed]) -> list[tuple[int, tuple[int, ...]]]:
    """Entry i of p x pull vanishes where the other two components of p do."""
    places = {p: j for j, p in enumerate(s.numbers)}
    found: list[tuple[int, tuple[int, ...]]] = []
    for k in range(len(s.bodies)):
        own = [u for u in vectors if u.body == k]
        for i in range(3):
            others = [u.components[j] for u in own for j in range(3) if j != i]
            if own:
                found.append((6 * k + 3 + i, tuple(places[p] for p in others)))
    return found


@dataclass(frozen=True)
class File:
    """One of the files that are written."""

    name: str
    kinds: Kinds
    n_axes: int
    loop: Callable[[int, Statement], Loop]
    head: list[str]
    arguments: str


KIND = [
    "class Kind(NamedTuple):",
    '    """A kind of measure: the fields whose body is fixed, how many bodies and numbers it has."""',
    "",
    "    name: str",
    "    fixed: tuple[str, ...]",
    "    n_bodies: int",
    "    n_numbers: int",
    "    has_bearing: bool",
    "    unchanging: tuple[int, ...]  # entries of the gradient that are the same in every pose",
    "    vanishing: tuple[tuple[int, tuple[int, ...]], ...] = ()  # entries that are zero where these numbers are",
    "",
    "",
]

FILES = [
    File(
        "measures_planar",
        PLANAR,
        2,
        planar_loop,
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
            "from freebody.numeric.kernels.declaring import kernel",
            "",
            "TURN = 2.0 * math.pi",
            "VALUE, BIAS, BEARING, NEAR = range(4)  # what stands in `out` of every measure",
            "",
            "",
            *KIND,
        ],
        "kinds, starts, bodies, numbers, q, v, turn, out, gradient",
    ),
    File(
        "measures_spatial",
        SPATIAL,
        3,
        spatial_loop,
        [
            '"""Value, gradient and bias of measures in space. Written by tools/write_kernels.py; do not edit.',
            "",
            "Measures of a kind stand together: those of kind i are kinds[i] <= k < kinds[i + 1]. The gradient of",
            "measure k has six entries for each of its bodies (velocity of the mass centre along the ground's axes,",
            "angular velocity along the axes of the body's frame) and begins at starts[i] + 6 n_bodies (k - kinds[i]).",
            "Body b has the cells 2 b and 2 b + 1 of q and v; row b of `frames` is its rotation matrix, row by row.",
            '"""',
            "",
            "# pyright: basic",
            "",
            "import math",
            "from typing import Any",
            "",
            "from freebody.numeric.kernels.declaring import kernel",
            "from freebody.numeric.kernels.measures_planar import BEARING, BIAS, NEAR, TURN, VALUE, Kind",
            "from freebody.numeric.kernels.rotating import carried, crossed, returned",
            "",
        ],
        "kinds, starts, bodies, numbers, q, v, frames, out, gradient",
    ),
]


def text(file: File) -> str:
    statements = [statement(kind, ground, file.n_axes) for kind, ground in file.kinds]
    measure: list[str] = []
    fill: list[str] = []
    listed: list[str] = []
    for index, ((kind, ground), s) in enumerate(zip(file.kinds, statements, strict=True)):
        loop = file.loop(index, s)
        head = [
            f"    # {s.name}: bodies {', '.join(s.bodies)}",
            f"    for k in range(kinds[{index}], kinds[{index + 1}]):",
        ]
        measure += head + [f"        {line}" for line in loop.body]
        if loop.fill:
            fill += head + [f"        {line}" for line in loop.fill]
        vanishing = f", {tuple(loop.vanishing)!r}" if loop.vanishing else ""
        listed.append(
            f'    Kind("{kind.__name__}", {ground!r}, {len(s.bodies)}, {len(s.numbers)}, '
            f"{bool(s.geometry.tangents)}, {tuple(loop.fixed)!r}{vanishing}),"
        )
    return "\n".join(
        [
            *file.head,
            f"MAX_BODIES = {max(len(s.bodies) for s in statements)}",
            f"MAX_NUMBERS = {max(len(s.numbers) for s in statements)}",
            "",
            "KINDS = (",
            *listed,
            ")",
            "",
            "",
            "@kernel",
            f"def measure({file.arguments}):",
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
    for file in FILES:
        target = ENGINE / f"{file.name}.py"
        written = formatted(text(file))
        if "--check" not in sys.argv:
            target.write_text(written, encoding="utf-8")
        elif not target.exists() or target.read_text(encoding="utf-8") != written:
            sys.exit(f"{target} is not current; run {sys.argv[0]}")
