"""MuJoCo: soft contacts with its default settings, bodies kept in the x-y plane by slides and a hinge."""

from __future__ import annotations

import math
from time import process_time
from typing import Any

import mujoco
import numpy as np
import scenes

_JOINTS = '<joint type="slide" axis="1 0 0"/><joint type="slide" axis="0 1 0"/><joint type="hinge" axis="0 0 1"/>'


def _model(step: float, ground: str, bodies: str) -> Any:
    return mujoco.MjModel.from_xml_string(
        f'<mujoco><option timestep="{step}" gravity="0 {-scenes.GRAVITY} 0"/>'
        f"<worldbody>{ground}{bodies}</worldbody></mujoco>"
    )


def _plane(x: float, y: float, nx: float, ny: float, friction: float) -> str:
    """A plane with the given normal."""
    return f'<geom type="plane" size="0 0 1" pos="{x} {y} 0" zaxis="{nx} {ny} 0" friction="{friction} 0 0" condim="3"/>'


def _body(x: float, y: float, angle: float, inertia: float, geom: str) -> str:
    return (
        f'<body pos="{x} {y} 0" euler="0 0 {math.degrees(angle)}">{_JOINTS}'
        f'<inertial pos="0 0 0" mass="1" diaginertia="{inertia} {inertia} {inertia}"/>{geom}</body>'
    )


def settling(step: float) -> dict[str, Any]:
    centres, radii = scenes.circles()
    mu, width = scenes.CIRCLE_FRICTION, scenes.WIDTH
    ground = _plane(0, 0, 0, 1, mu) + _plane(0, 0, 1, 0, mu) + _plane(width, 0, -1, 0, mu)
    bodies = "".join(
        _body(x, y, 0.0, 0.5 * r * r, f'<geom type="sphere" size="{r}" friction="{mu} 0 0" condim="3"/>')
        for (x, y), r in zip(centres, radii, strict=True)
    )
    model = _model(step, ground, bodies)
    data = mujoco.MjData(model)
    begin = process_time()
    for _ in range(round(scenes.SETTLING_TIME / step)):
        mujoco.mj_step(model, data)
    seconds = process_time() - begin
    end = data.xpos[1:, :2].copy()
    speed = float(np.abs(data.qvel.reshape(-1, 3)[:, :2]).max())
    return {"seconds": seconds, "penetration_m": scenes.penetration(end, radii), "speed": speed, "note": "defaults"}


def _slope(angle: float, friction: float) -> str:
    return _plane(0, 0, math.sin(angle), math.cos(angle), friction)


def creep(step: float) -> float:
    width, height = scenes.BLOCK
    box = f'<geom type="box" size="{width / 2} {height / 2} 0.1" friction="{scenes.SLOPE_FRICTION} 0 0" condim="3"/>'
    x, y = scenes.block_centre()
    model = _model(step, _slope(scenes.SLOPE, scenes.SLOPE_FRICTION), _body(x, y, -scenes.SLOPE, 0.02, box))
    data = mujoco.MjData(model)
    for _ in range(round(scenes.SLOPE_TIME / step)):
        mujoco.mj_step(model, data)
    return math.dist(data.xpos[1, :2], (x, y))


def sphere(step: float) -> dict[str, Any]:
    r, mu = scenes.SPHERE_RADIUS, scenes.SPHERE_FRICTION
    c, s = math.cos(scenes.INCLINE), math.sin(scenes.INCLINE)
    ball = f'<geom type="sphere" size="{r}" friction="{mu} 0 0" condim="3"/>'
    model = _model(step, _slope(scenes.INCLINE, mu), _body(r * s, r * c, 0.0, 0.4 * r * r, ball))
    data = mujoco.MjData(model)
    data.qvel[:] = (scenes.SPHERE_SPEED * c, -scenes.SPHERE_SPEED * s, 0.0)
    times, speeds, slips, seconds = [0.0], [scenes.SPHERE_SPEED], [scenes.SPHERE_SPEED], 0.0
    for _ in range(round(scenes.SPHERE_TIME / step)):
        begin = process_time()
        mujoco.mj_step(model, data)
        seconds += process_time() - begin
        times.append(float(data.time))
        speeds.append(math.hypot(data.qvel[0], data.qvel[1]))
        slips.append(speeds[-1] + r * float(data.qvel[2]))
    return {"seconds": seconds, "times": np.array(times), "speed": np.array(speeds), "slip": np.array(slips)}
