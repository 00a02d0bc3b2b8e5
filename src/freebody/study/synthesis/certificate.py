"""What the numeric route says of a candidate: an ordinary model of it, which is assembled and moved all round.

The model holds lengths as numbers. At every precision position the pose is known; that its constraints are kept there,
that the motion from position 1 comes through it, and whether the crank turns fully, is found by following the curve of
poses, which knows nothing of how the candidate was made.
"""

from __future__ import annotations

import json
import math
from dataclasses import dataclass

import numpy as np

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message
from freebody.numeric.jets import Array
from freebody.numeric.mobility.path import MotionPath, trace
from freebody.numeric.reference import Reference
from freebody.study.mobility.grashof import dimensions
from freebody.study.mobility.linkages import linkages
from freebody.study.synthesis.linkage import Defect, Linkage
from freebody.study.synthesis.positions import rotation
from freebody.system.system import System

_KEPT = 1e-7  # of the size: gaps in a position
_NEAR = 0.03  # [rad], and in sizes: a position is on the followed curve if the chord between two stations is as near


@dataclass(frozen=True)
class Certificate:
    """system: the model; case: of Grashof in words; transmission: least and greatest angle over the motion [deg];
    turns_fully: the crank; defects: what the motion has shown."""

    system: System
    case: str
    transmission: tuple[float, float] | None
    turns_fully: bool
    defects: tuple[Defect, ...]


def model_text(linkage: Linkage, title: str) -> str:
    """The candidate in position 1 as a model file."""
    names = _bodies(linkage)
    lines = ["freebody: 1", f"title: {json.dumps(title, ensure_ascii=False)}", ""]
    points = [f"A: {_point(linkage.A)}"] + ([] if linkage.D is None else [f"D: {_point(linkage.D)}"])
    if linkage.is_slider:
        assert linkage.along is not None
        points.append(f"S: {_point(linkage.C[0])}")
    lines += ["ground:", f"  points: {{{', '.join(points)}}}"]
    if linkage.is_slider:
        assert linkage.along is not None
        lines.append(f"  lines: {{slide: {{through: ground.S, along: {_numbers(linkage.along)}}}}}")
    lines += ["", "bodies:"]
    pose = pose_of(linkage, 0)
    lengths = [_length(linkage.A, linkage.B[0]), _length(linkage.B[0], linkage.C[0])]
    lengths += [] if linkage.D is None else [_length(linkage.D, linkage.C[0])]
    for k, name in enumerate(names):
        if name == "slider":
            continue
        traced = ""
        if name == "coupler" and linkage.P is not None:
            traced = f", points: {{P: {_point(_local(linkage, linkage.P[0], pose[1][2]))}}}"
        if name == "coupler" and linkage.is_inverted:
            traced += f", lines: {{slot: {{through: coupler.end, along: {_numbers(_slot(linkage, pose[1][2]))}}}}}"
        near = f", near: {{angle: {float(pose[k][2])!r} rad}}"
        lines.append(f"  {name}: {{rod: {{mass: 1 kg, length: {lengths[k]!r} m}}{traced}{near if k else ''}}}")
    if linkage.is_slider:
        lines.append("  slider: {particle: {mass: 1 kg}}")
    lines += ["", "connections:", "  A: {pin: [ground.A, crank.start]}", "  B: {pin: [crank.end, coupler.start]}"]
    if linkage.is_slider:
        lines += ["  C: {pin: [coupler.end, slider]}", "  slide: {slider: {body: slider, along: slide}}"]
    elif linkage.is_inverted:
        lines.append("  D: {slot: {pin: ground.D, on: coupler, along: coupler.slot}}")
    else:
        lines += ["  C: {pin: [coupler.end, rocker.end]}", "  D: {pin: [ground.D, rocker.start]}"]
    lines += ["", "measures:", "  theta: {angle of crank}", "", f"start: {{theta: {float(pose[0][2])!r} rad}}", ""]
    return "\n".join(lines)


def _point(at: Array) -> str:
    return f"[{float(at[0])!r} m, {float(at[1])!r} m]"


def _numbers(v: Array) -> str:
    return f"[{float(v[0])!r}, {float(v[1])!r}]"


def _length(a: Array, b: Array) -> float:
    return float(np.linalg.norm(b - a))


def _bodies(linkage: Linkage) -> list[str]:
    return ["crank", "coupler", *(["slider"] if linkage.is_slider else [] if linkage.is_inverted else ["rocker"])]


def _local(linkage: Linkage, point: Array, angle: float) -> Array:
    """A point of position 1 in axes of the coupler, whose origin is the middle of the rod."""
    return rotation(-angle) @ (point - 0.5 * (linkage.B[0] + linkage.C[0]))


def _slot(linkage: Linkage, angle: float) -> Array:
    """The direction of the coupler's line in its axes."""
    assert linkage.along is not None
    return rotation(-angle) @ linkage.along


def pose_of(linkage: Linkage, k: int) -> list[Array]:
    """(x, y, angle) of the middles of crank, coupler and rocker, or of the slider, in position k."""
    A, B, C, D = linkage.A, linkage.B[k], linkage.C[k], linkage.D
    found = [_rod(A, B), _rod(B, C)]
    if linkage.is_inverted:
        return found
    return [*found, np.append(C, 0.0) if D is None else _rod(D, C)]


def _rod(start: Array, end: Array) -> Array:
    d = end - start
    return np.append(0.5 * (start + end), math.atan2(d[1], d[0]))


def certified(linkage: Linkage, title: str, *, full_turn: bool) -> Certificate:
    """Raises CannotAnswer where the model cannot be followed."""
    system = System.from_text(model_text(linkage, title))
    reference = Reference(system)
    poses = [_q(reference, linkage, k) for k in range(linkage.n)]
    defects: list[Defect] = []
    for k, q in enumerate(poses):
        gap = max(
            (abs(e.gap(reference.geometry(q, np.zeros_like(q), 0.0)).value) for e in reference.held_where(q, 0.0)),
            default=0.0,
        )
        if gap > _KEPT * linkage.size:
            defects.append(
                Defect(Message("not assembled"), Message("position {k} is missed by {x:.1e} m", k=k + 1, x=gap))
            )
    path = trace(reference, poses[0], system.measures["theta"])
    away = [k for k in range(linkage.n) if not _is_on(path, poses[k], reference, linkage.size)]
    if away:
        others = ", ".join(str(k + 1) for k in away)
        defects.append(
            Defect(Message("circuit"), Message("the motion from position 1 does not come to {others}", others=others))
        )
    if full_turn and not path.full_turn:
        defects.append(Defect(Message("no full turn"), Message("the crank does not turn fully")))
    loops = linkages(system)
    numbers = dimensions(loops[0], reference, poses[0]) if loops else None
    case = "" if numbers is None else numbers.case
    extremes = None if numbers is None else numbers.transmission_extremes
    return Certificate(system, case, extremes, path.full_turn, tuple(defects))


def _q(reference: Reference, linkage: Linkage, k: int) -> Array:
    """The pose as the model counts its coordinates."""
    q = np.array(reference.assemble(), dtype=np.float64)
    at = 0
    for part, name in zip(pose_of(linkage, k), _bodies(linkage), strict=True):
        n = 2 if name == "slider" else 3
        q[at : at + n] = part[:n]
        at += n
    if at != len(q):
        raise CannotAnswer(Message("the model of the candidate has other coordinates than its links"))
    return q


def _is_on(path: MotionPath, q: Array, reference: Reference, size: float) -> bool:
    """Whether a pose lies on the curve between two stations, angles modulo full turns."""
    scale = np.where([k % 3 == 2 for k in range(len(q))], 1.0, 1.0 / size)
    turning = np.array([k % 3 == 2 for k in range(len(q))])

    def difference(a: Array, b: Array) -> Array:
        d = a - b
        d[..., turning] = np.mod(d[..., turning] + math.pi, math.tau) - math.pi
        return d * scale

    chord = difference(path.poses[1:], path.poses[:-1])
    r = difference(np.broadcast_to(q, chord.shape).copy(), path.poses[:-1])
    part = np.clip((r * chord).sum(axis=1) / np.maximum((chord * chord).sum(axis=1), 1e-300), 0.0, 1.0)
    return bool(np.linalg.norm(r - part[:, None] * chord, axis=1).min() < _NEAR)


def seen_alike(linkage: Linkage, certificate: Certificate) -> Defect | None:
    """Where formulas and motion do not agree, the candidate is not certified."""
    by_formula = "circuit" in {d.name for d in linkage.defects(full_turn=False)}
    by_motion = "circuit" in {d.name for d in certificate.defects}
    if by_formula != by_motion or linkage.turns_fully != certificate.turns_fully:
        return Defect(Message("not certified"), Message("formulas and the followed motion do not agree about circuits"))
    return None
