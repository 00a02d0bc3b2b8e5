"""What the start of a model in space says about speeds; angular velocities along the axes that they are given by."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from freebody.errors import CannotAnswer
from freebody.language.expression import Expr
from freebody.language.sentences import Message
from freebody.measures.geometry import Vector
from freebody.symbolic.linear import RHS, Row, solve
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.speeds import total_of
from freebody.symbolic.start_speeds import StartSpeeds, WantedRates
from freebody.symbolic.unknowns import Coordinate


class SpatialStartSpeeds(StartSpeeds):
    """The speeds at the start in space, all together."""

    def _wanted_of_bodies(self) -> WantedRates:
        f, scalar = self.field, self.scalar
        wanted: WantedRates = []
        for body in self.system.all_moving:
            velocity, pose = self.kinematics.velocities[body.name], self.configuration.poses[body.name]
            wanted += [(v, scalar(e)) for v, e in zip(velocity, body.start.velocity or (), strict=False)]
            if body.start.rates is not None:
                omega = velocity[3:]
                if not body.start.rates_in_body:
                    turned = pose.turn(Vector(*omega))
                    omega = (turned.x, turned.y, f.zero if turned.z is None else turned.z)
                wanted += [(w, scalar(e)) for w, e in zip(omega, body.start.rates, strict=True)]
        return wanted

    def together(self, known: Mapping[str, Expr], start: Mapping[int, Ratio]) -> dict[int, Ratio]:
        """From equations that are linear in the speeds. What nobody said starts at rest."""
        f = self.field
        speeds = [c.speed for c in self.speeds.coordinates]
        rows: list[Row] = []
        for rate, value in self.wanted_rates(known):
            here = f.follow(self.speeds.in_independent_speeds(rate), start)
            row: Row = {s: x for s in speeds if not (x := f.lowest_terms(f.partial(here, s))).is_zero()}
            rest = f.lowest_terms(value - here + total_of(f, row))
            if not rest.is_zero():
                row[RHS] = rest
            rows.append(row)
        solved = solve(f, rows, speeds, lambda x: x.is_zero())
        if solved.contradictory:
            self._require_place(rows)
            raise CannotAnswer(Message("the velocities of the start contradict each other"))
        found = dict.fromkeys(solved.free, f.zero)
        for speed, row in solved.pivots.items():
            found[speed] = f.lowest_terms(row.get(RHS, f.zero))
        return found

    def _require_place(self, rows: Sequence[Row]) -> None:
        """Velocities that depend on where something is that has no closed form there agree only at that place."""
        used = {g for row in rows for x in row.values() for g in x.generators()}
        open_ones = sorted(used & self.unknowns.speeds.keys(), key=lambda g: str(self.field.generators[g].display))
        if open_ones:
            name = str(getattr(self.field.generators[open_ones[0]].display, "name", ""))
            raise CannotAnswer(Message("what {name} is at the start has no closed form; give it in start", name=name))

    def of_coordinate(self, c: Coordinate, start: Mapping[int, Ratio]) -> Ratio | None:
        return None  # all of them are found together
