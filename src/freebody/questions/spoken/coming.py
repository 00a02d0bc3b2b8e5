"""How far something has come, as a condition of the grammar: it has moved 2 m, fallen by h, turned 3 times."""

from __future__ import annotations

from typing import TYPE_CHECKING

from freebody.measures.geometry import GROUND
from freebody.questions.spoken import along_lines, dimensions, joining, lookup, of_axles, poses, strings
from freebody.questions.spoken.composing import SILENT, Groups
from freebody.questions.spoken.words import Clause

if TYPE_CHECKING:
    from freebody.model.names import Names


def _angles_at(names: Names, who: str) -> list[str]:
    """The angles that tell where something is: of what turns, else of the line that it hangs on."""
    if who in names.measures or who not in lookup.moving(names):
        return []
    return lookup.angles(names, who) if who in lookup.turning(names) else lookup.hung(names, who)


def angles_of(names: Names, who: str) -> list[str]:
    """The angles of something, or of the line on which it hangs; of a rod without mass that of what hangs on it."""
    found = lookup.angles(names, who) or lookup.hung(names, who)
    hung = names.connections[who].mentions(names) if who in names.connections and not found else set[str]()
    return found or [angle for body in sorted(hung) if body in names.bodies for angle in lookup.hung(names, body)]


def _turning_in(names: Names, who: str) -> str:
    """The only body of a connection that turns by a measured angle: the cam's, where the connection is called cam."""
    if who not in names.connections or who in names.bodies or lookup.angles(names, who):
        return who
    turning = [body for body in sorted(names.connections[who].mentions(names)) if lookup.angles(names, body)]
    return turning[0] if len(turning) == 1 else who


def going_at(names: Names, who: str, value: str, measures: list[str]) -> list[str]:
    """The condition that something goes so fast: by the rate of what measures it, which on a curve is only a part."""
    bodies = [who] if who else lookup.moving(names)
    if len(bodies) == 1 and joining.follows_curve(names, bodies[0]):
        return [f"speed of {bodies[0]} = {value}"]
    return [f"rate({measure}) = {value}" for measure in measures]


def come_so_far(names: Names, clause: Clause, verbs: list[str]) -> Groups:
    """It has moved 2 m; x reaches d; the crank has turned 90 deg; 3 revolutions."""
    if not clause.only("name", "value", "turns", "verb", "part", *SILENT):
        return
    turns = clause.all("turns")
    values = [value for _, value in clause.values] + [f"{turn} * 2*pi" for turn in turns]
    of = [name for _, name in clause.names]
    if not values and of and of[-1] in names.parameters:
        values = [of.pop()]
    if len(values) != 1 or len(of) > 3:
        return
    lines = [
        name for before, name in clause.names if before in ("along", "up", "down") and joining.direction(names, name)
    ]
    acting = [name for name in of if name in names.loads] if len(of) > 1 else []  # the motor lifts the crate by 2 m
    [value], of = values, [name for name in of if name not in (*lines, *acting)]
    who = next(iter(of), "")
    if who in names.loads:  # the motor: what it turns
        driven = {body for p in names.applied_loads if p.load == who for body in p.measure.bodies()} - {GROUND}
        who = next(iter(driven)) if len(driven) == 1 else who
    if clause.has("part", "horizontal") and dimensions.is_length(value, names):
        yield [lookup.gone_either_way(names, way, value) for way in lookup.level(names, who)]
        return
    if dimensions.is_speed(value, names) or dimensions.is_turning_speed(value, names):
        is_turning = dimensions.is_turning_speed(value, names)
        found = (lookup.angles if is_turning else lookup.places)(names, who)
        yield going_at(names, who, value, found)
        able = lookup.turning(names) if is_turning else lookup.moving(names)
        if not found and (who in able or (not who and len(able) == 1)):  # of which none is measured
            yield [f"{'angular velocity' if is_turning else 'speed'} of {who or able[0]} = {value}"]
        return
    if dimensions.is_time(value, names):
        return
    if set(verbs) <= {"reach"} and clause.names[-1:] == [("from", of[-1] if of else "")]:  # it is 0.8 m from the axle
        yield along_lines.counted_from(names, who if len(of) > 1 else "", of[-1], value)
        return
    way = next((part for part in clause.all("part") if part in ("horizontal", "vertical")), "")
    if way and dimensions.is_angle(value):  # 30 deg to the vertical
        yield [f"{angle} = {value}" for angle in poses.counting_from(names, angles_of(names, who), way)]
        return
    doing = {"reach" if verb == "hold" and dimensions.is_angle(value) else verb for verb in verbs} - {"start"}
    if doing and doing <= {"move", "slide", "fly"} and dimensions.is_angle(value):  # the bead has run through 60 deg
        doing = {"turn"}
    who = _turning_in(names, who) if doing == {"turn"} or dimensions.is_angle(value) else who
    sense = -1 if clause.has("updown", "down") or clause.has("part", "downward") else 0
    sense = 1 if clause.has("updown", "up") or clause.has("part", "upward") else sense
    if sense and doing <= {"move", "slide", "roll", "fly", "fall", "rise"}:
        yield lookup.gone(names, who, value, sense)
        return
    if not doing and dimensions.is_angle(value) and who not in names.measures:
        yield [f"{angle} = {value}" for angle in lookup.angles(names, who)]
    elif doing == {"reach"} and dimensions.is_angle(value) and not turns and (angles := _angles_at(names, who)):
        yield [f"{angle} = {value}" for angle in angles]  # the crank has reached 90 deg, the car is at 90 deg
    elif turns or doing == {"turn"}:
        turned = [lookup.gone_either_way(names, angle, value) for angle in of_axles.turned(names, who)]
        yield turned or [f"{angle} has moved {value}" for angle in _unmeasured_angles(names, who)]
    elif doing == {"hang"}:
        yield strings.hung_down(names, who, value) if dimensions.is_length(value, names) else []
    elif doing == {"fall"}:
        yield lookup.climbed(names, who, value, -1)
    elif doing == {"rise"}:
        yield lookup.climbed(names, who, value, 1)
    elif doing == {"reach"} and value in names.parameters and names.parameters[value].is_angle:
        yield [f"{angle} = {value}" for angle in (*lookup.angles(names, who), *lookup.hung(names, who))]
    elif doing <= {"reach"} and of and of[-1] in names.measures:
        yield [f"{of[-1]} = {value}"]
    elif (doing and doing <= {"move", "slide", "roll", "fly", "reach"}) or not doing:
        went = [lookup.gone_either_way(names, way, value) for way in lookup.went(names, who)]
        yield went or [f"{way} has moved {value}" for way in along_lines.unmeasured(names, who)]


def _unmeasured_angles(names: Names, who: str) -> list[str]:
    """The angle by which a body in the plane turns, where no measure of the file is one."""
    turning = [body for body in along_lines.alone(names, who) if body in lookup.turning(names)]
    return [] if names.space or lookup.angles(names, who) else [f"angle of {body}" for body in turning]
