"""Models for benchmarks, made for any size."""

from __future__ import annotations

from typing import Any


def pendulums_on_a_cart(n: int) -> dict[str, Any]:
    """A cart and a chain of n point masses on massless rods, angles from the downward vertical."""
    parameters: dict[str, Any] = {"m0": "kg", "g": "m/s^2"}
    bodies: dict[str, Any] = {"cart": {"particle": {"mass": "m0"}}}
    connections: dict[str, Any] = {"track": {"slider": {"body": "cart", "along": "right"}}}
    measures: dict[str, Any] = {"x": "x of cart"}
    above = "cart"
    for k in range(1, n + 1):
        parameters[f"m{k}"], parameters[f"L{k}"] = "kg", "m"
        bodies[f"bob{k}"] = {"particle": {"mass": f"m{k}"}}
        connections[f"rod{k}"] = {"link": [above, f"bob{k}", f"L{k}"]}
        measures[f"q{k}"] = f"angle of line from {above} to bob{k} from down"
        above = f"bob{k}"
    return {
        "title": f"{n} pendulums on a cart",
        "parameters": parameters,
        "bodies": bodies,
        "connections": connections,
        "loads": {"weight": {"gravity": "g"}},
        "measures": measures,
    }
