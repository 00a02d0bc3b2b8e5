"""Bodies, connections and loads: a page each, a section for every kind."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path

from pydantic.fields import FieldInfo
from pydantic_core import PydanticUndefined

import freebody as fb
from freebody.connections.base import Connection
from freebody.errors import ModelError
from freebody.language.units import ENERGY
from freebody.loads.base import Load
from freebody.model.shapes.base import Shape
from freebody.model.spec import FieldType, Spec
from reference.page import NothingSaid, Page, block, code, joined, picture, table, words_of
from reference.units import Units, listening, shown

_SHAPES = """A body has one of these shapes, which gives it its mass, its moment of inertia and its points. A
mass that is left out is zero. Beside the shape an entry may say `at`, `angle`, `velocity`, `angular_velocity`,
`near`, `points`, `lines`, `outline`, `fixed`, and in space `turned`, `frame`, `planes` (see [the model
language](../guide/language.md))."""
_CONNECTIONS = """A connection holds measures, or bounds them. What it transmits can be asked for by the names
in its second table. Beside the kind an entry may say `closes: at start` or `closes: when EVENT` (see
[blows](../guide/language.md))."""
_LOADS = """A load pushes measures. Extension and pulling are positive. Magnitudes are formulas in the
parameters; those of `force`, `torque` and `law` may depend on the time `t`, on named measures and on their
rates `rate(x)`."""


@dataclass(frozen=True)
class Family:
    """What is described by kinds of one base."""

    name: str
    title: str
    about: str
    place: int
    head: str
    section: str
    kinds: Mapping[str, type[Spec]]


FAMILIES = (
    Family(
        "bodies",
        "Bodies",
        "shapes with their masses, moments of inertia and points",
        10,
        _SHAPES,
        "bodies",
        Shape.kinds,
    ),
    Family(
        "connections",
        "Connections",
        "joints, gears, strings, contacts",
        20,
        _CONNECTIONS,
        "connections",
        Connection.kinds,
    ),
    Family("loads", "Loads", "gravity, forces, springs, impulses", 30, _LOADS, "loads", Load.kinds),
)


BESIDE = str(Path(__file__).with_name("model.yaml"))  # the file that examples name stands in that folder


def pages() -> Iterator[Page]:
    for family in FAMILIES:
        parts, pictures = [f"# {family.title}", family.head], dict[str, str]()
        for kind, spec in family.kinds.items():
            if spec.__module__.startswith("freebody."):
                parts.append(_section(family, kind, spec, pictures))
        yield Page(family.name, family.title, family.about, family.place, joined(parts), pictures)


def model_of(section: str, kind: str, spec: type[Spec]) -> str:
    """The smallest model with a kind, as a file. Raises NothingSaid where it has no example."""
    example = str(getattr(spec, "example", "")).strip()
    if not example:
        raise NothingSaid(f"{kind} has no example")
    if section != "bodies":
        return example
    plane = f"bodies: {{it: {{{kind}: {example}}}}}"
    try:
        fb.System.from_text(plane, BESIDE)
    except ModelError:
        return f"space: true\n{plane}"
    return plane


def _section(family: Family, kind: str, spec: type[Spec], pictures: dict[str, str]) -> str:
    model = model_of(family.section, kind, spec)
    with listening(spec) as units:
        system = fb.System.from_text(model, BESIDE)
    drawn = system.picture()
    for paper in ("light", "dark"):
        pictures[f"pictures/{family.name}-{kind}-{paper}.svg"] = drawn.svg(dark=paper == "dark")
    called = ", ".join(spec.called)
    return joined(
        [
            f"## `{kind}`",
            words_of(spec, f"{family.section}: {kind}"),
            f"Also called: {called}." if called else "",
            table(
                ("field", "takes", "unit", "default"), (_row(spec, *each, units) for each in spec.model_fields.items())
            ),
            f"In Python: {code(f'fb.{spec.__name__}({_arguments(spec)})')}.",
            block("yaml", model),
            picture(f"pictures/{family.name}-{kind}", f"A small model with {kind.replace('_', ' ')}"),
            _gives(family, system),
        ]
    )


def _row(spec: type[Spec], name: str, info: FieldInfo, units: Units) -> tuple[str, ...]:
    takes = _takes(name, info, spec.field_types()[name])
    unit = shown(units[name]) if name in units else ""
    if unit and "measure" in spec.model_fields and name != "restitution":
        unit = f"by the measure; here {unit}"
    default = "needed" if info.is_required() else _default(info)
    return code(info.alias or name), takes, unit, default


def _takes(name: str, info: FieldInfo, of: FieldType) -> str:
    """What may stand in a field, of its type."""
    kind = str(info.annotation)
    if of in ("direction", "formula"):
        return of
    if name == "measure":
        return "measure"
    if "bool" in kind:
        return "true or false"
    if "dict[str, typing.Any]" in kind and "str" in kind.replace("dict[str, typing.Any]", ""):
        return "formula, or two by name"
    if kind.startswith(("list", "typing.Optional[list", "list")):
        return "list"
    if "dict" in kind:
        return "mapping"
    return "list or formula" if "list" in kind else "name or text"


def _default(info: FieldInfo) -> str:
    value = info.get_default(call_default_factory=True) if info.default is PydanticUndefined else info.default
    if value is None or value == "" or value == []:
        return ""
    return code(str(value).lower() if isinstance(value, bool) else str(value))


def _arguments(spec: type[Spec]) -> str:
    """The fields in the order in which they may be given by position."""
    return ", ".join(spec.model_fields)


def _gives(family: Family, system: fb.System) -> str:
    """What a body has, what a load exerts, what a connection transmits."""
    if family.section == "bodies":
        body = system.bodies["it"]
        points = ", ".join(map(code, body.points))
        return f"Points: {points}; the plain name of the body means its {code(body.default_point)}."
    if family.section == "loads":
        unit = system.names.loads.get("it")
        return "" if unit is None else f"What it exerts here is measured in {unit}."
    rows = {row.name: row for row in system.rows if row.connection == "it"}
    said = ((code(name), row.reaction, str(ENERGY / row.measure.dimension)) for name, row in rows.items())
    return table(("constraint", "what it transmits", "unit here"), said)
