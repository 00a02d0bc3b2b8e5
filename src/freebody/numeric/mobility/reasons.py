"""What a dependence of rows is owed to, in a sentence: bars that are equally long, joints in one line, lines that meet.

Special geometry is looked for in sizes and places that a change of shows to matter; special poses in how joints and
bars lie.
"""

from __future__ import annotations

import itertools
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from typing import TypeVar

import numpy as np

from freebody.language.expression import free_symbols
from freebody.language.sentences import Message, further, listed
from freebody.measures.base import Measure
from freebody.measures.combination import Combination
from freebody.measures.displacement import Displacement
from freebody.measures.distance import Distance
from freebody.measures.geometry import GROUND, Point
from freebody.model.elements import NonholonomicForm
from freebody.numeric.jets import Array
from freebody.numeric.mobility.scene import CHANGE, Bar, Change, CircuitScene, leaves
from freebody.tolerances import SAME_PLACE

N_PLACES = 30  # places up to which lines through three of them are searched
T = TypeVar("T")


def why_special(scene: CircuitScene) -> str:
    """The special geometry on which the dependence of the rows rests, as far as it has a simple name."""
    for found in (_parallel_bars, _guides_alike, _round_bodies, _equal_bars, _points_together, _points_in_line):
        sentences = list(found(scene))
        if sentences:
            return Message("{what}.", what=further(*sentences))
    bodies = [body for body in scene.bodies if body != GROUND]
    return Message(
        "The rows are independent in other geometry; the sizes or places of {bodies} are special.",
        bodies=listed(bodies),
    )


def why_momentary(scene: CircuitScene, *, is_shaky: bool) -> str:
    """What is special about this pose, as far as it has a simple name."""
    sentences = (
        _lie_in_line(scene.places, scene.size),
        _concurrent(scene),
        _in_line_here(scene),
        _stretched(scene),
        Message("the rows are independent at poses near by"),
    )
    return at_this_pose(next(filter(None, sentences)), is_shaky=is_shaky)


def at_this_pose(what: str, *, is_shaky: bool) -> str:
    if is_shaky:
        return Message("At this pose {what}; the freedom that comes with it is only infinitesimal.", what=what)
    return Message("At this pose {what}.", what=what)


# -- special geometry -------------------------------------------------------------------------
def _parallel_bars(scene: CircuitScene) -> Iterator[str]:
    for length, names in _bars_alike(scene, lambda a, b: _same_length(scene, a, b) and _is_parallel(a.along, b.along)):
        yield Message("{bodies} are equally long ({length}) and parallel", bodies=listed(names), length=length)


def _equal_bars(scene: CircuitScene) -> Iterator[str]:
    for length, names in _bars_alike(scene, lambda a, b: _same_length(scene, a, b)):
        yield Message("{bodies} are equally long ({length})", bodies=listed(names), length=length)


def _bars_alike(scene: CircuitScene, is_alike: Callable[[Bar, Bar], bool]) -> Iterator[tuple[str, list[str]]]:
    """The length of bars that are alike, and the names of those on which the dependence rests."""
    for group in in_groups(scene.bars, is_alike):
        names = [bar.name for bar in group if scene.rests_on(bar.change)]
        if len(names) > 1:
            yield f"{group[0].length:.6g} m", names


def _same_length(scene: CircuitScene, a: Bar, b: Bar) -> bool:
    return abs(a.length - b.length) <= SAME_PLACE * scene.size


def _guides_alike(scene: CircuitScene) -> Iterator[str]:
    for group in in_groups(scene.guides, lambda a, b: _is_parallel(a.along, b.along)):
        kept = [guide for guide in group if scene.rests_on(guide.change)]
        if len(kept) < 2:
            continue
        first = kept[0]
        is_one = all(abs(_cross(first.along, g.place - first.place)) <= SAME_PLACE * scene.size for g in kept)
        guides = listed([g.name for g in kept])
        if is_one:
            yield Message("the guides of {guides} are in one line", guides=guides)
        else:
            yield Message("the guides of {guides} are parallel", guides=guides)


def _round_bodies(scene: CircuitScene) -> Iterator[str]:
    bodies = scene.framework.model.system.bodies
    used = {s for row in scene.rows for m in _measures(row.measure) for s in _coefficients(m)}
    used |= {s for row in scene.rows if row.target is not None for s in free_symbols(row.target)}
    wheels = [
        (name, scene.number(radius), scene.place(bodies[name].center))
        for name in scene.bodies
        if (radius := bodies[name].radius) is not None and free_symbols(radius) & used
    ]
    for group in in_groups(wheels, lambda a, b: _is_near(scene, a[2], b[2])):
        names = [name for name, _r, _place in group]
        if len(group) > 1 and any(scene.rests_on(_recentred(scene, name)) for name in names):
            yield Message("{wheels} are concentric", wheels=listed(names))
    for group in in_groups(wheels, lambda a, b: abs(a[1] - b[1]) <= SAME_PLACE * scene.size):
        names = [
            name
            for name, radius, _place in group
            if scene.rests_on(dict.fromkeys(scene.columns(name, "radius"), CHANGE * radius))
        ]
        if len(names) > 1:
            yield Message("{wheels} have equal radii ({r})", wheels=listed(names), r=f"{group[0][1]:.6g} m")


def _measures(measure: Measure | NonholonomicForm) -> Iterator[Measure]:
    if not isinstance(measure, NonholonomicForm):
        yield measure
    yield from leaves(measure)


def _coefficients(measure: Measure) -> set[str]:
    """Symbols in the coefficients of a combination."""
    if not isinstance(measure, Combination):
        return set()
    return {symbol for coefficient, _term in measure.terms for symbol in free_symbols(coefficient)}


def _recentred(scene: CircuitScene, body: str) -> Change:
    """What moves the centre of a wheel on the ground: its own place, or that of its bearing."""
    if body in scene.framework.others:
        return {scene.framework.others[body][0]: CHANGE * scene.size}
    for joint in scene.joints:
        for point, other in (joint.points, joint.points[::-1]):
            if point.body == body and other.body == GROUND:
                return scene.shift(other)
    return {}


def _points_together(scene: CircuitScene) -> Iterator[str]:
    """Points of one body that have different names and the same place."""
    points = {str(point): point for row in scene.rows for m in leaves(row.measure) for point in _points(m)}
    placed = [(name, point, scene.place(point)) for name, point in points.items()]
    for group in in_groups(placed, lambda a, b: a[1].body == b[1].body and _is_near(scene, a[2], b[2])):
        if len(group) > 1 and any(scene.rests_on(scene.shift(point)) for _name, point, _place in group):
            yield Message("{joints} are at the same place", joints=listed([name for name, *_rest in group]))


def _points(measure: Measure) -> Iterator[Point]:
    if isinstance(measure, Displacement):
        yield from (measure.of, measure.origin)
    elif isinstance(measure, Distance):
        yield from (measure.start, measure.end)


def _points_in_line(scene: CircuitScene) -> Iterator[str]:
    at: dict[str, dict[str, Array]] = {}
    for joint in scene.joints:
        for point in joint.points:
            at.setdefault(point.body, {})[joint.name] = joint.place
    for body, places in at.items():
        if len(places) > 2 and _in_line(list(places.values()), scene.size):
            joints = listed(list(places))
            if body == GROUND:
                yield Message("the joints {joints} on the ground are in line", joints=joints)
            else:
                yield Message("the joints {joints} of {body} are in line", joints=joints, body=body)


# -- special poses ----------------------------------------------------------------------------
def _in_line_here(scene: CircuitScene) -> str:
    """The longest line of places that no single body holds in line."""
    places = scene.places
    if len(places) > N_PLACES:
        return ""
    on: dict[str, set[str]] = {joint.name: {p.body for p in joint.points} for joint in scene.joints}
    best: dict[str, Array] = {}
    for a, b in itertools.combinations(places, 2):
        line = {name: c for name, c in places.items() if _in_line([places[a], places[b], c], scene.size)}
        bodies = [on.get(name, {name.partition(".")[0]}) for name in line]
        if len(line) > max(2, len(best)) and not any(all(body in some for some in bodies) for body in bodies[0]):
            best = line
    return _lie_in_line(best, scene.size)


def _stretched(scene: CircuitScene) -> str:
    """Two bars with a common joint that are in line."""
    for a, b in itertools.combinations(scene.bars, 2):
        if set(a.ends) & set(b.ends) and _in_line([a.start, a.end, b.start, b.end], scene.size):
            return Message("{links} are in line", links=listed([a.name, b.name]))
    return ""


def _concurrent(scene: CircuitScene) -> str:
    """Three bars or more whose lines meet in one point, or that are parallel."""
    if len(scene.bars) < 3:
        return ""
    for some in [scene.bars, *itertools.combinations(scene.bars[:12], 3)]:
        directions = [bar.along / bar.length for bar in some]
        lines = np.array([[*e, _cross(bar.start / scene.size, e)] for bar, e in zip(some, directions, strict=True)])
        U, singular, _Vt = np.linalg.svd(lines.T, full_matrices=True)
        if singular[1] > 1e-6 * singular[0] and (len(singular) < 3 or singular[2] <= SAME_PLACE * singular[0]):
            a, b, c = U[:, 2]
            # (x, y) with  x e_y - y e_x = m  for every line (e_x, e_y, m)
            names = listed([bar.name for bar in some])
            if abs(c) <= SAME_PLACE:
                return Message("{links} are parallel", links=names)
            x, y = (0.0 if abs(k) <= SAME_PLACE else float(k) * scene.size for k in (-b / c, a / c))
            point = f"{x:.6g}, {y:.6g}"
            return Message("the lines of {links} meet in one point ({point}) m", links=names, point=point)
    return ""


# -- how things lie ---------------------------------------------------------------------------
def _cross(u: Array, v: Array) -> float:
    return float(u[0] * v[1] - u[1] * v[0])


def _is_parallel(u: Array, v: Array) -> bool:
    return abs(_cross(u, v)) <= SAME_PLACE * float(np.linalg.norm(u) * np.linalg.norm(v))


def _is_near(scene: CircuitScene, a: Array, b: Array) -> bool:
    return float(np.linalg.norm(a - b)) <= SAME_PLACE * scene.size


def _in_line(places: Sequence[Array], size: float) -> bool:
    """Whether places lie in one line, to what coordinates of a pose are good for where rows depend on each other."""
    if len(places) < 3:
        return True
    centred = (np.array(places) - np.mean(places, axis=0)) / size
    singular = np.asarray(np.linalg.svd(centred, compute_uv=False), np.float64)
    return bool(singular[-1] <= SAME_PLACE * max(1.0, float(singular[0])))


def _lie_in_line(places: Mapping[str, Array], size: float) -> str:
    """That places lie in line, three of them or more, if they do."""
    is_line = len(places) > 2 and _in_line(list(places.values()), size)
    return Message("{links} lie in line", links=listed(list(places))) if is_line else ""


def in_groups(items: Iterable[T], alike: Callable[[T, T], bool]) -> list[list[T]]:
    """Items in groups, each like the first of its group."""
    groups: list[list[T]] = []
    for item in items:
        for group in groups:
            if alike(group[0], item):
                group.append(item)
                break
        else:
            groups.append([item])
    return groups
