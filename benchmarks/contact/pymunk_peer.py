"""pymunk (Chipmunk 7): impulses with bias, 10 iterations."""

from __future__ import annotations

import math
from time import process_time
from typing import Any

import numpy as np
import pymunk
import scenes

ITERATIONS = 10


def _space() -> Any:
    space = pymunk.Space()
    space.gravity, space.iterations = (0.0, -scenes.GRAVITY), ITERATIONS
    return space


def _wall(space: Any, start: tuple[float, float], end: tuple[float, float], friction: float) -> None:
    wall = pymunk.Segment(space.static_body, start, end, 0.0)
    wall.friction = friction
    space.add(wall)


def settling(step: float) -> dict[str, Any]:
    return min((_settling(step) for _ in range(3)), key=lambda row: row["seconds"])


def _settling(step: float) -> dict[str, Any]:
    space, bodies = _space(), []
    width = scenes.WIDTH
    for start, end in (((0, 0), (width, 0)), ((0, 0), (0, 50)), ((width, 0), (width, 50))):
        _wall(space, start, end, 1.0)  # frictions are multiplied
    centres, radii = scenes.circles()
    for (x, y), r in zip(centres, radii, strict=True):
        body = pymunk.Body(1.0, 0.5 * r * r)
        body.position = (float(x), float(y))
        circle = pymunk.Circle(body, float(r))
        circle.friction = math.sqrt(scenes.CIRCLE_FRICTION)
        space.add(body, circle)
        bodies.append(body)
    begin = process_time()
    for _ in range(round(scenes.SETTLING_TIME / step)):
        space.step(step)
    seconds = process_time() - begin
    end = np.array([[*b.position] for b in bodies])
    return {
        "seconds": seconds,
        "penetration_m": scenes.penetration(end, radii),
        "speed": max(max(map(abs, b.velocity)) for b in bodies),
        "note": f"{ITERATIONS} iterations",
    }


def creep(step: float) -> float:
    space = _space()
    c, s = math.cos(scenes.SLOPE), math.sin(scenes.SLOPE)
    _wall(space, (-50 * c, 50 * s), (50 * c, -50 * s), 1.0)
    width, height = scenes.BLOCK
    body = pymunk.Body(1.0, (width**2 + height**2) / 12)
    body.position, body.angle = scenes.block_centre(), -scenes.SLOPE
    box = pymunk.Poly.create_box(body, scenes.BLOCK)
    box.friction = scenes.SLOPE_FRICTION
    space.add(body, box)
    for _ in range(round(scenes.SLOPE_TIME / step)):
        space.step(step)
    return math.dist(body.position, scenes.block_centre())


def sphere(step: float) -> dict[str, Any]:
    space = _space()
    c, s = math.cos(scenes.INCLINE), math.sin(scenes.INCLINE)
    _wall(space, (-50 * c, 50 * s), (50 * c, -50 * s), 1.0)
    r = scenes.SPHERE_RADIUS
    body = pymunk.Body(1.0, 0.4 * r * r)
    body.position, body.velocity = (r * s, r * c), (scenes.SPHERE_SPEED * c, -scenes.SPHERE_SPEED * s)
    ball = pymunk.Circle(body, r)
    ball.friction = scenes.SPHERE_FRICTION
    space.add(body, ball)
    times, speeds, slips = [0.0], [scenes.SPHERE_SPEED], [scenes.SPHERE_SPEED]
    seconds = 0.0
    for k in range(round(scenes.SPHERE_TIME / step)):
        begin = process_time()
        space.step(step)
        seconds += process_time() - begin
        times.append((k + 1) * step)
        speeds.append(body.velocity.length)
        slips.append(body.velocity.length + r * body.angular_velocity)
    return {"seconds": seconds, "times": np.array(times), "speed": np.array(speeds), "slip": np.array(slips)}
