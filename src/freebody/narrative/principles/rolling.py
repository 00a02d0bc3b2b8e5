"""What rolls on a fixed plane in space, and the arm from its centre to the point of contact."""

from __future__ import annotations

from typing import Any

from freebody.connections.rolling import Rolling
from freebody.measures.geometry import GROUND, Direction
from freebody.model.elements import BodyPlane, RigidBody
from freebody.model.state import State
from freebody.questions.vectors import components_of, dot
from freebody.system.system import System


def rolling_body(system: System, connection: str) -> tuple[RigidBody, BodyPlane] | None:
    """A disk or a sphere and the fixed plane on which it rolls."""
    data = system.connections.get(connection)
    if not isinstance(data, Rolling) or data.on is None or data.radius is not None:
        return None
    owner, _, name = data.on.rpartition(".")
    ground = system.bodies[owner or GROUND]
    body, plane = system.bodies[data.body], ground.planes.get(name)
    if plane is None or not ground.fixed or body.round not in ("disk", "sphere") or body.radius is None:
        return None
    return body, plane


def contact_arm(body: RigidBody, plane: BodyPlane, state: State[Any]) -> tuple[Any, ...]:
    """From the centre to the point of contact: -R n for a sphere, -R (n - (n.a) a)/|n x a| for a rim."""
    n = components_of(plane.normal, state, 3)
    assert body.radius is not None
    radius = state.scalar(body.radius)
    if body.round == "sphere":
        return tuple(-radius * x for x in n)
    a = components_of(Direction(body.name, body.axis), state, 3)
    share = dot(n, a)
    across = tuple(x - share * y for x, y in zip(n, a, strict=True))
    size = state.sqrt(dot(across, across))
    return tuple(-radius * x / size for x in across)
