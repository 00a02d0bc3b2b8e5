"""Families of mechanisms of any size."""

from __future__ import annotations

import freebody as fb


def chain(n: int) -> fb.System:
    bodies = {
        f"b{k}": {"rod": {"mass": "1 kg", "length": "1 m"}, "at": {"start": [f"{k} m", 0]}, "angle": 0}
        for k in range(n)
    }
    pins = {f"p{k}": {"pin": ["ground.O" if k == 0 else f"b{k - 1}.end", f"b{k}.start"]} for k in range(n)}
    return fb.System.from_data({"bodies": bodies, "connections": pins, "loads": {"g": {"gravity": 9.81}}})


def tree(n: int) -> fb.System:
    """Rods hanging on rods, two on each."""
    bodies = {f"b{k}": {"rod": {"mass": "1 kg", "length": "1 m"}} for k in range(n)}
    pins = {f"p{k}": {"pin": ["ground.O" if k == 0 else f"b{(k - 1) // 2}.end", f"b{k}.start"]} for k in range(n)}
    return fb.System.from_data({"bodies": bodies, "connections": pins, "loads": {"g": {"gravity": 9.81}}})


def ladder(n: int) -> fb.System:
    """n windows of uprights and rungs."""
    bodies: dict[str, object] = {}
    pins: dict[str, object] = {}
    for k in range(n + 1):
        bodies[f"c{k}"] = {"rod": {"mass": "1 kg", "length": "1 m"}, "at": {"start": [f"{k} m", 0]}, "angle": "90 deg"}
        pins[f"A{k}"] = {"pin": [f"ground.A{k}", f"c{k}.start"]}
    bodies["c0"]["angular_velocity"] = "-1 rad/s"  # type: ignore[index]
    for k in range(n):
        bodies[f"r{k}"] = {"rod": {"mass": "1 kg", "length": "1 m"}, "at": {"start": [f"{k} m", "1 m"]}, "angle": 0}
        pins[f"B{k}"] = {"pin": [f"c{k}.end", f"r{k}.start"]}
        pins[f"C{k}"] = {"pin": [f"c{k + 1}.end", f"r{k}.end"]}
    ground = {"points": {f"A{k}": [f"{k} m", 0] for k in range(n + 1)}}
    return fb.System.from_data(
        {"ground": ground, "bodies": bodies, "connections": pins, "loads": {"g": {"gravity": 9.81}}}
    )
