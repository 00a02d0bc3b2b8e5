"""Coordinates that a file has where points are named: they are points of the ground, called by letters."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from functools import cached_property
from string import ascii_uppercase
from typing import Any, cast

from freebody.connections.base import Connection
from freebody.errors import InputError
from freebody.language.units import LENGTH, parse_quantity
from freebody.loads.base import Load
from freebody.measures.geometry import GROUND
from freebody.model.names import Names
from freebody.model.spec import ENDS, Spec
from freebody.model.written_kinds import written_kind


def _as_key(place: Sequence[Any]) -> tuple[str, ...]:
    return tuple(map(str, place))


def _in_order(coordinate: str) -> tuple[int, float, str]:
    """Numbers by their size, then formulas."""
    try:
        return 0, parse_quantity(coordinate).value, ""
    except (InputError, TypeError):
        return 1, 0.0, coordinate


class GroundPoints:
    """The points of the ground that coordinates make."""

    names: Names
    data: dict[str, Any]
    _words: set[str]  # of the file

    def _with_ground_points(self, kind: type[Spec], fields: dict[str, Any], *path: str | int) -> dict[str, Any]:
        """Fields in which coordinates stand where points are named: those are points of the ground, called by the next
        letters that a file does not use for names. Beside `on` of a body they might be those of the body."""
        read = dict(fields)
        for field, k, place in self._places_among(kind, fields):
            point = self._ground_point(place, *path, field, *(() if k is None else (k,)))
            if k is None:
                read[field] = point
            else:
                read[field] = [point if n == k else each for n, each in enumerate(read[field])]
        return read

    def _places_among(self, kind: type[Spec], fields: dict[str, Any]) -> Iterator[tuple[str, int | None, list[Any]]]:
        """Coordinates among the ends of something: the field, the place in the list there, and they themselves."""
        if GROUND not in self.names.bodies or str(fields.get("on", GROUND)).partition(".")[0] != GROUND:
            return
        types = kind.field_types()
        ends = {key: types[n] for n, f in kind.model_fields.items() if n in ENDS for key in (n, f.alias or n)}
        for field, given in fields.items():
            if ends.get(field) == "text" and self._is_a_place(given):
                yield field, None, given
            elif field in ends and isinstance(given, list):
                for k, each in enumerate(cast("list[Any]", given)):
                    if self._is_a_place(each):
                        yield field, k, each

    def _ground_point(self, place: list[Any], *path: str | int) -> str:
        points, name = self.names.bodies[GROUND].points, self._letters[_as_key(place)]
        points.setdefault(name, self.names.components(place, LENGTH, *path))
        self.names.by_coordinates.add(name)
        return f"{GROUND}.{name}"

    @cached_property
    def _letters(self) -> dict[tuple[str, ...], str]:
        """Names of the points that coordinates make, from left to right and from below upwards: whatever the order of
        the entries is."""
        places: dict[tuple[str, ...], list[Any]] = {}
        all_kinds = {"connections": Connection.kinds, "loads": Load.kinds}
        for section, kinds in cast("dict[str, Mapping[str, type[Spec]]]", all_kinds).items():
            entries = self.data.get(section)
            for entry in cast("dict[str, Any]", entries).values() if isinstance(entries, dict) else ():
                for word, value in cast("dict[str, Any]", entry).items() if isinstance(entry, dict) else ():
                    meant = written_kind(word, value, kinds, space=self.names.space)
                    if meant is not None:
                        found = self._places_among(kinds[meant], kinds[meant].from_plain(value))
                        places |= {_as_key(place): place for _field, _k, place in found}
        used = self._words | self.names.bodies[GROUND].points.keys() | self.names.parameters.keys()
        free = [letter for letter in ascii_uppercase if letter not in used]
        ordered = sorted(places, key=lambda key: [_in_order(each) for each in key])
        return {key: free[k] if k < len(free) else f"P{k}" for k, key in enumerate(ordered)}

    def _is_a_place(self, value: Any) -> bool:
        """Whether somebody wrote coordinates where names of points stand."""
        entries = cast("list[Any]", value) if isinstance(value, list) else []
        are_names = any(str(entry).partition(".")[0] in self.names.bodies for entry in entries)
        return len(entries) in (2, 3) and not are_names and all(isinstance(e, str | int | float) for e in entries)
