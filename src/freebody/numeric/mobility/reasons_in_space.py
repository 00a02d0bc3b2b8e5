"""What a dependence of rows in space is owed to, in a sentence: how the axes and the centres of joints lie.

What a joint holds by whatever rows is seen in the motions that it leaves one of its bodies: an axis where the body can
turn about one direction alone, a centre where one of its points stays.
"""

from __future__ import annotations

import itertools
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from freebody.language.sentences import Message, further, listed
from freebody.measures.distance import Distance
from freebody.measures.geometry import GROUND, position
from freebody.model.elements import ConstraintRow
from freebody.numeric.jets import Array
from freebody.numeric.mobility.reasons import at_this_pose, in_groups
from freebody.numeric.mobility.scene import joined, leaves
from freebody.numeric.mobility.twists import ScrewLine, TwistSpace, freedom
from freebody.numeric.reference import Reference
from freebody.tolerances import SAME_PLACE

SAME = 1e-7  # the sine or the part of the size that counts as zero, at poses as good as they were assembled


@dataclass(frozen=True)
class SpatialScene:
    """The connections of one circuit at one pose."""

    reference: Reference
    q: Array
    t: float
    connections: Sequence[str]

    @property
    def size(self) -> float:
        return self.reference.sizes.length

    @cached_property
    def rows(self) -> Mapping[str, Sequence[ConstraintRow]]:
        held = self.reference.system.constraint_rows
        return {name: [row for row in held if row.connection == name] for name in self.connections}

    def bodies(self, connection: str) -> list[str]:
        """The bodies that it joins, moving ones first."""
        found = {body for row in self.rows[connection] for body in joined(row)}
        return sorted(found, key=lambda body: (body not in self.reference.frame.columns, body))

    @cached_property
    def freedoms(self) -> Mapping[str, TwistSpace]:
        """What every connection leaves one of its bodies."""
        return {
            name: freedom(self.reference, self.q, self.bodies(name)[0], self.rows[name], self.t)
            for name in self.connections
            if self.bodies(name)[0] in self.reference.frame.columns
        }

    @cached_property
    def lines(self) -> Mapping[str, ScrewLine]:
        """The lines about which alone connections let a body turn."""
        return {name: free.line for name, free in self.freedoms.items() if free.line is not None}

    @cached_property
    def axes(self) -> Mapping[str, Array]:
        """The directions about which alone connections let a body turn."""
        return {name: free.axis for name, free in self.freedoms.items() if free.axis is not None}

    @cached_property
    def centers(self) -> Mapping[str, Array]:
        return {name: free.center for name, free in self.freedoms.items() if free.center is not None}

    @cached_property
    def ends(self) -> Mapping[str, Array]:
        """Centres, and the points whose distance is held."""
        found = dict(self.centers)
        g = self.reference.geometry(self.q, np.zeros_like(self.q), self.t)
        for m in (m for rows in self.rows.values() for row in rows for m in leaves(row.measure)):
            for point in (m.start, m.end) if isinstance(m, Distance) else ():
                at = position(g, point)
                found[str(point)] = np.array([c.value for c in (at.x, at.y, at.z) if c is not None])
        return found


def why_special_in_space(scene: SpatialScene) -> str:
    """The special geometry on which the dependence rests, as far as it has a simple name."""
    for found in (_arranged, _alike_links):
        sentence = found(scene)
        if sentence:
            return Message("{what}.", what=sentence)
    bodies = dict.fromkeys(b for name in scene.connections for b in scene.bodies(name) if b != GROUND)
    return Message(
        "The rows are independent in other geometry; the sizes or places of {bodies} are special.",
        bodies=listed(list(bodies)),
    )


def why_momentary_in_space(scene: SpatialScene, *, is_shaky: bool) -> str:
    """What is special about this pose, as far as it has a simple name."""
    looked_for = (_in_line, _in_plane, _axes_in_plane, _arranged)
    sentences = (found(scene) for found in looked_for)
    what = next(filter(None, sentences), Message("the rows are independent at poses near by"))
    return at_this_pose(what, is_shaky=is_shaky)


# -- how axes lie -----------------------------------------------------------------------------
def _arranged(scene: SpatialScene) -> str:
    """How the axes of joints lie to each other."""
    sentences = [*_coaxial(scene)] or [*_concurrent(scene)] or [*_parallel(scene)]
    return further(*sentences)


def _coaxial(scene: SpatialScene) -> Iterator[str]:
    def one_line(a: tuple[str, ScrewLine], b: tuple[str, ScrewLine]) -> bool:
        return _is_parallel(a[1].direction, b[1].direction) and _passes(scene, b[1], a[1].point)

    groups = in_groups(scene.lines.items(), one_line)
    if len(scene.lines) == len(scene.freedoms) and len(groups) == 1 and len(groups[0]) > 1:
        yield Message("the axes of {joints} are one line", joints=listed([name for name, _ in groups[0]]))


def _concurrent(scene: SpatialScene) -> Iterator[str]:
    """All lines, three or more, through one point, in which all centres lie too."""
    if len(scene.lines) < 3 or len(scene.lines) + len(scene.centers) < len(scene.freedoms):
        return
    lines = list(scene.lines.values())
    across = [np.eye(3) - np.outer(line.direction, line.direction) for line in lines]
    A = np.vstack(across)
    b = np.concatenate([P @ line.point for P, line in zip(across, lines, strict=True)])
    found, _rest, rank, _S = np.linalg.lstsq(A, b, rcond=SAME_PLACE)
    place = np.asarray(found, np.float64)
    meets = rank == 3 and all(_passes(scene, line, place) for line in lines)
    if meets and all(float(np.linalg.norm(c - place)) <= SAME * scene.size for c in scene.centers.values()):
        yield Message(
            "the axes of {joints} meet in one point {point}",
            joints=listed(list(scene.lines)),
            point=_place(place, scene.size),
        )


def _parallel(scene: SpatialScene) -> Iterator[str]:
    groups = in_groups(scene.axes.items(), lambda a, b: _is_parallel(a[1], b[1]))
    names = [[name for name, _axis in group] for group in groups if len(group) > 1]
    if names:
        first, *others = map(listed, names)
        told = Message("the axes of {joints} are parallel", joints=first)
        for other in others:
            told = Message("{what}, and so are those of {joints}", what=told, joints=other)
        yield told


def _alike_links(scene: SpatialScene) -> str:
    """Bodies whose two axes are as far apart and as twisted as those of another."""
    links: dict[str, tuple[float, float]] = {}
    on: dict[str, list[ScrewLine]] = {}
    for name, line in scene.lines.items():
        for body in dict.fromkeys(b if b in scene.reference.frame.columns else GROUND for b in scene.bodies(name)):
            on.setdefault(body, []).append(line)
    for body, lines in on.items():
        if len(lines) == 2:
            links[body] = _distance_and_twist(*lines)
    alike = in_groups(
        links.items(),
        lambda a, b: abs(a[1][0] - b[1][0]) <= SAME * scene.size and abs(a[1][1] - b[1][1]) <= SAME,
    )
    pairs = [(listed([name for name, _ in group]), *group[0][1]) for group in alike if len(group) > 1]
    found = [
        Message(
            "{links} have axes equally far apart ({apart}) and at the same angle", links=names, apart=f"{apart:.6g} m"
        )
        for names, apart, _ in pairs
    ]
    if len(pairs) > 1 and len({round(sine / apart * scene.size, 6) for _, apart, sine in pairs if apart > 0.0}) == 1:
        found.append(Message("the sines of these angles are as the distances"))
    return "; ".join(found)


def _distance_and_twist(a: ScrewLine, b: ScrewLine) -> tuple[float, float]:
    """Between two lines: their distance, and the sine of their angle."""
    normal = np.cross(a.direction, b.direction)
    sine = float(np.linalg.norm(normal))
    apart = b.point - a.point
    if sine <= SAME:
        return float(np.linalg.norm(np.cross(a.direction, apart))), 0.0
    return abs(float(apart @ normal)) / sine, sine


def _in_line(scene: SpatialScene) -> str:
    """The longest line of centres and ends of links, three or more."""
    places = scene.ends
    best: list[str] = []
    for a, b in itertools.combinations(places, 2):
        along = places[b] - places[a]
        length = float(np.linalg.norm(along))
        if length <= SAME * scene.size:
            continue
        line = ScrewLine(along / length, places[a], 0.0)
        on = [name for name, place in places.items() if _passes(scene, line, place)]
        best = on if len(on) > max(2, len(best)) else best
    return Message("{links} lie in line", links=listed(best)) if best else ""


def _in_plane(scene: SpatialScene) -> str:
    """Centres and ends of links, four or more, if all lie in one plane."""
    places = np.array(list(scene.ends.values()))
    if len(places) < 4:
        return ""
    singular = np.asarray(np.linalg.svd(places - places.mean(axis=0), compute_uv=False), np.float64)
    return (
        Message("{joints} lie in one plane", joints=listed(list(scene.ends)))
        if singular[-1] <= SAME * scene.size
        else ""
    )


def _axes_in_plane(scene: SpatialScene) -> str:
    """Parallel lines, three or more, in one plane."""
    lines = list(scene.lines.values())
    if len(lines) < 3 or not all(_is_parallel(lines[0].direction, line.direction) for line in lines):
        return ""
    across = np.eye(3) - np.outer(lines[0].direction, lines[0].direction)
    places = np.array([across @ line.point for line in lines])
    singular = np.asarray(np.linalg.svd(places - places.mean(axis=0), compute_uv=False), np.float64)
    return (
        Message("the axes of {joints} lie in one plane", joints=listed(list(scene.lines)))
        if singular[1] <= SAME * scene.size
        else ""
    )


def _is_parallel(a: Array, b: Array) -> bool:
    return float(np.linalg.norm(np.cross(a, b))) <= SAME


def _passes(scene: SpatialScene, line: ScrewLine, place: Array) -> bool:
    return float(np.linalg.norm(np.cross(line.direction, place - line.point))) <= SAME * scene.size


def _place(place: Array, size: float) -> str:
    return f"({', '.join(f'{0.0 if abs(c) <= SAME * size else float(c):.6g}' for c in place)}) m"
