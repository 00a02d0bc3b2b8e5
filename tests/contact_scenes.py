"""Random scenes of things that may touch, and what must hold of their motions, computed from the outlines alone."""

from __future__ import annotations

import math
import re
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

import freebody as fb

G = 9.81
Floats = NDArray[np.float64]


@dataclass(frozen=True)
class Thing:
    """A body: a circle of a radius (0 for a particle), or a convex polygon with corners about its mass centre."""

    name: str
    shape: str
    radius: float = 0.0
    corners: tuple[tuple[float, float], ...] = ()
    at: tuple[float, float] = (0.0, 0.0)
    angle: float = 0.0
    velocity: tuple[float, float] = (0.0, 0.0)
    spin: float = 0.0

    @property
    def reach(self) -> float:
        return self.radius or max((math.hypot(x, y) for x, y in self.corners), default=0.0)

    def text(self) -> str:
        turning = f", angle: {self.angle!r}, angular_velocity: {self.spin!r} rad/s"
        return (
            f"  {self.name}: {{{self.shape}, at: [{self.at[0]!r}, {self.at[1]!r}], "
            f"velocity: [{self.velocity[0]!r} m/s, {self.velocity[1]!r} m/s]"
            f"{'' if self.shape.startswith('particle') else turning}}}"
        )


@dataclass(frozen=True)
class Scene:
    """Things, lines of the ground (a point and an angle; solid on their right), and how all of them touch."""

    things: tuple[Thing, ...]
    lines: tuple[tuple[float, float, float], ...]
    contact: str
    gravity: float = G
    notes: tuple[str, ...] = field(default=())

    def text(self) -> str:
        lines = "\n".join(
            f"    line{k}: {{through: [{x!r}, {y!r}], along: {a!r} rad}}" for k, (x, y, a) in enumerate(self.lines)
        )
        ground = f"ground:\n  lines:\n{lines}\n" if self.lines else ""
        loads = f"loads: {{weight: {{gravity: {self.gravity!r} m/s^2}}}}\n" if self.gravity else ""
        bodies = "\n".join(thing.text() for thing in self.things)
        return f"{ground}bodies:\n{bodies}\nconnections:\n  c: {{contact: {{among: all, {self.contact}}}}}\n{loads}"

    def system(self) -> fb.System:
        return fb.System.from_text(self.text())


# -- depth of penetration ---------------------------------------------------------------------
def depth(scene: Scene, poses: Floats) -> float:
    """How deep things are in each other or in the lines at most, at poses (n, 3) of the things; negative if apart."""
    deepest = -math.inf
    outlines = [_placed(thing, pose) for thing, pose in zip(scene.things, poses, strict=True)]
    for i, (a, r) in enumerate(outlines):
        for x, y, angle in scene.lines:
            heights = (a - [x, y]) @ [-math.sin(angle), math.cos(angle)]
            deepest = max(deepest, r - float(heights.min()))
        for b, s in outlines[:i]:
            deepest = max(deepest, r + s - _apart(a, b))
    return deepest


def _placed(thing: Thing, pose: Floats) -> tuple[Floats, float]:
    """Corners, or the centre, and the radius about them."""
    c, s = math.cos(pose[2]), math.sin(pose[2])
    own = np.array(thing.corners or [(0.0, 0.0)])
    return own @ np.array([[c, s], [-s, c]]) + pose[:2], thing.radius


def _apart(a: Floats, b: Floats) -> float:
    """The distance of two convex outlines (m, 2), (n, 2); below zero the least shift that parts them."""
    if len(a) == 1 and len(b) == 1:
        return float(np.linalg.norm(a - b))
    best = max(_above_edges(a, b), _above_edges(b, a))
    if best > 0.0 and (len(a) == 1 or len(b) == 1):  # nearest to a corner: further away
        return min(_from_edges(a, b), _from_edges(b, a))
    return best


def _above_edges(a: Floats, b: Floats) -> float:
    """The largest height of all points of b above an edge of a; a rod has an edge either way."""
    if len(a) == 1:
        return -math.inf
    along = np.roll(a, -1, axis=0) - a
    normals = np.stack([along[:, 1], -along[:, 0]], axis=1) / np.linalg.norm(along, axis=1)[:, None]
    heights = (b[None, :, :] - a[:, None, :]) @ normals[:, :, None]
    return float(heights[:, :, 0].min(axis=1).max())


def _from_edges(a: Floats, b: Floats) -> float:
    """The least distance of points of b from edges of a."""
    if len(a) == 1:
        return math.inf
    along = np.roll(a, -1, axis=0) - a
    part = ((b[:, None, :] - a[None]) * along).sum(axis=2) / (along * along).sum(axis=1)
    nearest = a[None] + np.clip(part, 0.0, 1.0)[:, :, None] * along
    return float(np.linalg.norm(b[:, None, :] - nearest, axis=2).min())


# -- making scenes ----------------------------------------------------------------------------
def random_thing(rng: np.random.Generator, name: str, kinds: str = "disk sphere particle box rod triangle") -> Thing:
    kind = str(rng.choice(kinds.split()))
    mass, size = float(rng.uniform(0.2, 3.0)), float(rng.uniform(0.05, 0.3))
    if kind in ("disk", "sphere"):
        return Thing(name, f"{kind}: {{mass: {mass!r} kg, radius: {size!r} m}}", radius=size)
    if kind == "particle":
        return Thing(name, f"particle: {{mass: {mass!r} kg}}")
    if kind == "rod":
        return Thing(name, f"rod: {{mass: {mass!r} kg, length: {2 * size!r} m}}", corners=((-size, 0.0), (size, 0.0)))
    if kind == "box":
        w, h = size, float(rng.uniform(0.3, 1.0)) * size
        corners = ((-w, -h), (w, -h), (w, h), (-w, h))
        return Thing(
            name, f"rectangle: {{mass: {mass!r} kg, width: {2 * w!r} m, height: {2 * h!r} m}}", corners=corners
        )
    n = int(rng.integers(3, 6))
    turns = np.sort(np.arange(n) + rng.uniform(-0.3, 0.3, n)) * 2 * math.pi / n
    own = [(size * math.cos(a), size * math.sin(a)) for a in turns.tolist()]
    cx, cy = _centroid(own)
    own = [(x - cx, y - cy) for x, y in own]
    listed = ", ".join(f"[{x!r}, {y!r}]" for x, y in own)
    return Thing(name, f"polygon: {{mass: {mass!r} kg, corners: [{listed}]}}", corners=tuple(own))


def _centroid(corners: list[tuple[float, float]]) -> tuple[float, float]:
    area = sx = sy = 0.0
    for (x1, y1), (x2, y2) in zip(corners, corners[1:] + corners[:1], strict=True):
        cross = x1 * y2 - x2 * y1
        area, sx, sy = area + cross, sx + (x1 + x2) * cross, sy + (y1 + y2) * cross
    return sx / (3 * area), sy / (3 * area)


def random_surface(rng: np.random.Generator) -> str:
    mu = float(rng.choice([0.0, 0.1, 0.3, 0.6, 1.0]))
    e = float(rng.choice([0.0, 0.0, 0.3, 0.6, 0.9, 1.0]))
    friction = f"{{static: {1.3 * mu!r}, kinetic: {mu!r}}}" if rng.random() < 0.3 else repr(mu)
    return f"friction: {friction}, restitution: {e!r}"


def box_of_lines(width: float, tilt: float = 0.0) -> tuple[tuple[float, float, float], ...]:
    """A floor and two walls."""
    return ((0.0, 0.0, tilt), (-width / 2, 0.0, -math.pi / 2), (width / 2, 0.0, math.pi / 2))


def random_scene(seed: int, n: int, kinds: str = "disk sphere particle box rod triangle") -> Scene:
    """Things above a floor, between walls or not, at rest or thrown at each other."""
    rng = np.random.default_rng(seed)
    width = 1.0 + 0.5 * n
    lines = [((0.0, 0.0, float(rng.choice([0.0, 0.0, -0.2, 0.3]))),), box_of_lines(width), ()][
        int(rng.choice(3, p=[0.4, 0.45, 0.15]))
    ]
    thrown = float(rng.choice([0.0, 1.0, 4.0]))
    things: list[Thing] = []
    while len(things) < n:
        thing = random_thing(rng, f"b{len(things)}", kinds)
        for _ in range(200):
            x, y = float(rng.uniform(-width / 2, width / 2)), float(rng.uniform(0.0, 1.5 + 0.4 * n))
            above = all((x - px) * -math.sin(a) + (y - py) * math.cos(a) > thing.reach + 1e-3 for px, py, a in lines)
            if above and all(math.hypot(x - o.at[0], y - o.at[1]) > thing.reach + o.reach + 1e-3 for o in things):
                break
        else:
            continue
        towards = (-x * thrown, (0.5 - y) * thrown * 0.5) if rng.random() < 0.5 else (0.0, 0.0)
        angle = float(rng.choice([0.0, rng.uniform(-3.0, 3.0)]))
        spin = float(rng.choice([0.0, rng.uniform(-5.0, 5.0)])) if not thing.shape.startswith("particle") else 0.0
        things.append(Thing(thing.name, thing.shape, thing.radius, thing.corners, (x, y), angle, towards, spin))
    gravity = 0.0 if not lines else G
    return Scene(tuple(things), tuple(lines), random_surface(rng), gravity)


# -- what must hold ---------------------------------------------------------------------------
def faults(scene: Scene, result: fb.Simulation, *, deepest: float = 1e-9) -> list[str]:
    """What a motion does that no motion may."""
    course, found = result.course, []
    unknown = result.status.name == "INCONSISTENT" and len(course.times) == 1
    for name in ("times", "poses", "velocities", "work") + (() if unknown else ("accelerations", "multipliers")):
        if not np.isfinite(getattr(course, name)).all():
            found.append(f"{name} are not finite")
    if found:
        return found
    if not (np.diff(course.times) > 0.0).all():
        found.append("output times do not increase")
    times = [e.time for e in result.events]
    if times != sorted(times):
        found.append("events are not in order")
    if times and (
        times[0] < course.times[0] or (times[-1] > course.t_end and result.events[-1].kind != "comes to rest")
    ):
        found.append(f"events from {times[0]} to {times[-1]}, motion to {course.t_end}")
    deep = [depth(scene, poses[:-1]) for poses in course.poses]
    worst = int(np.argmax(deep))
    if deep[worst] > deepest:
        found.append(f"{deep[worst]:.3g} m deep at t = {course.times[worst]:.9g}")
    grew = course.contact is not None and any(c.energy_grew for c in course.contact.collisions)
    if result.energy.relative_error > 1e-6:
        found.append(f"energy is off by {result.energy.relative_error:.2g}")
    size = max(float(result.energy.kinetic.max()), 1e-4 * result.energy.typical)
    allowed = max(1e-9 * size, 1.01 * _said_too_high(result.message))
    if not grew and (np.diff(course.work) > allowed).any():
        found.append(
            f"friction gave {np.diff(course.work).max():.3g} J at {course.times[np.diff(course.work).argmax()]}"
        )
    if not unknown:
        found += _outside_cones(result)
    return found


def _said_too_high(message: str) -> float:
    """The energy [J] that the result itself says to be too high for a moment."""
    found = re.search(r"for that moment the energy is (\S+) J too high", message)
    return 0.0 if found is None else float(found[1])


def _outside_cones(result: fb.Simulation) -> list[str]:
    system, course = result.system, result.course
    place = {row.name: k for k, row in enumerate(system.rows)}
    size = float(np.abs(course.multipliers).max(initial=0.0)) or 1.0
    found = []
    for bound in system.bounds:
        k = place[bound.name]
        least = float((bound.row.sign * course.multipliers[:, k]).min())
        if least < -1e-9 * size and course.unique[:, k].all():
            found.append(f"{bound.name} pulls with {-least:.3g} N")
    for rub in system.dry_friction:
        T, N = course.multipliers[:, place[rub.name]], course.multipliers[:, place[rub.load[0]]]
        known = course.unique[:, place[rub.name]] & course.unique[:, place[rub.load[0]]]
        excess = np.abs(T) - float(result.simulator.numbers.number(rub.static)) * np.abs(N)
        if (excess[known] > 1e-9 * size).any():
            found.append(f"{rub.name} exceeds its cone by {excess[known].max():.3g} N")
    return found
