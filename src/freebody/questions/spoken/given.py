"""Parameters that are meant by what they are of: the mass of a body, the force of a load, the only angle."""

from __future__ import annotations

from typing import TYPE_CHECKING

from freebody.language.expression import Symbol, free_symbols
from freebody.language.units import FORCE, LENGTH, MASS, TIME, TORQUE
from freebody.measures.geometry import ZERO
from freebody.questions.spoken.lookup import given_of, is_at, is_joined

if TYPE_CHECKING:
    from freebody.model.names import Names


def parameters(names: Names, kind: str, of: str) -> list[str]:
    """Parameters that are the mass of a body, the stiffness of a spring, the coefficient of friction."""
    if kind == "mass":
        masses = [body.mass for name, body in names.bodies.items() if name == of]
        return [mass.name for mass in masses if isinstance(mass, Symbol)]
    if kind == "stiffness":
        return [name for name, parameter in names.parameters.items() if parameter.dimension == FORCE / LENGTH]
    if kind == "length" and not of:  # of the only thing that has one
        sizes = [body.sizes[0] for body in names.bodies.values() if body.solid == "rod" and body.sizes]
        own = {str(given_of(spec).get("length")) for spec in names.connections.values()} | {str(size) for size in sizes}
        return [name for name in names.parameters if name in own]
    word = {"friction coefficient": "friction"}.get(kind, kind)
    own = [spec for name, spec in names.connections.items() if not of or name == of or is_at(names, name, of)]
    written = {str(value) for spec in own for key, value in given_of(spec).items() if word in key}
    return [name for name in names.parameters if name in written]


def of_kind(names: Names, kind: str) -> list[str]:
    """Parameters that are a force, an angle, a speed, as their units say."""
    dimensions = {
        **dict.fromkeys(("force", "reaction", "tension"), FORCE),
        **dict.fromkeys(("torque", "moment", "driving torque"), TORQUE),
        **dict.fromkeys(("speed", "velocity"), LENGTH / TIME),
        **dict.fromkeys(("height", "distance"), LENGTH),
    }
    given = [parameter for parameter in names.parameters.values() if parameter.form is None]
    if kind == "angle":
        return [parameter.name for parameter in given if parameter.is_angle]
    return [parameter.name for parameter in given if kind in dimensions and parameter.dimension == dimensions[kind]]


def chosen(names: Names, kind: str, of: list[str]) -> list[str]:
    """Parameters that are of a kind and can be chosen: a force that a load exerts, a length that is no size of a body.

    of: what is named beside it."""
    given = [parameter for parameter in names.parameters.values() if parameter.form is None]
    held = [load for load in names.applied_loads if load.load in of]
    if kind == "mass" and held and not any(name in names.bodies for name in of):  # how heavy a load is
        weights = frozenset[str]().union(*(free_symbols(load.law) for load in held))
        return [p.name for p in given if p.name in weights and p.dimension in (MASS, FORCE)]
    if kind == "mass":
        own = [name for body in of for name in parameters(names, "mass", body)]
        bodies = frozenset[str]().union(*(free_symbols(body.mass) for body in names.bodies.values()))
        others = [p.name for p in given if p.dimension == MASS and p.name not in bodies]
        return own or ([] if any(name in names.bodies for name in of) else others)
    if kind in ("friction coefficient", "friction force"):
        return parameters(names, "friction coefficient", next((name for name in of if is_joined(names, name)), ""))
    if kind in ("force", "torque", "moment"):
        exerted = [load for load in names.applied_loads if "gravity" not in names.called.get(load.load, ())]
        loads = [load for load in exerted if load.load in of] or exerted
        pushed = frozenset[str]().union(*(free_symbols(load.law) for load in loads))
        return [name for name in of_kind(names, kind) if name in pushed]
    sizes = frozenset[str]().union(
        *(free_symbols(body.inertia) | free_symbols(body.radius or ZERO) for body in names.bodies.values())
    )
    return [name for name in of_kind(names, kind) if kind == "angle" or name not in sizes]
