"""How high and how far something comes, where no instant is said: as far as where it turns back, or where it rests."""

from __future__ import annotations

from typing import TYPE_CHECKING

from freebody.measures.geometry import GROUND
from freebody.questions.spoken import along_lines, driving, joining, lookup, of_axles, poses, rubbing
from freebody.questions.spoken.composing import SILENT, Groups
from freebody.questions.spoken.keeping import n_freedoms
from freebody.questions.spoken.words import Clause

if TYPE_CHECKING:
    from freebody.model.names import Names


def is_settled(main: Clause) -> bool:
    """Whether it is asked how high something hangs, how deep it floats, how far it is moved in equilibrium."""
    is_still = main.has("instant", "in equilibrium") or main.all("verb") in (["hold"], ["hang", "hold"])
    return main.has("ask", "high", "far", "deep") and is_still and not main.has("quantity")


def where_it_settles(names: Names, main: Clause) -> Groups:
    """The equilibrium of a height, or of how far something has come."""
    who = next((name for _, name in main.names if name in lookup.moving(names)), "")
    known = main.only("ask", "verb", "name", "instant", *SILENT) and set(main.all("verb")) <= {"hold", "move", "hang"}
    found = lookup.ways(names, who)
    if main.has("ask", "high"):
        found = [name for name, _ in lookup.heights(names, who)]
    yield [f"equilibrium of {name}" for name in found] if known else []


def how_high(names: Names, main: Clause) -> Groups:
    """How high does it fly? As high as it is where it no longer rises."""
    who = next((name for _, name in main.names), "")
    if not (main.has("name") or main.has("pronoun")):  # somebody climbs, who is nothing of the model
        return
    if set(main.all("verb")) <= {"move", "fly", "rise", "roll", "turn", "slide", "reach"} and len(main.names) <= 1:
        yield [f"{height} when {top}" for height in lookup.rising(names, who) for top in poses.tops(names, who)]
        led = [name for name, _ in lookup.heights(names, who) if driving.is_led(names) and who]
        if main.has("verb", "rise") and led:  # how high the cam lifts it
            yield [f"stroke of {name}" for name in led]
            return
        if main.has("verb", "rise", "turn", "reach") and (risen := risen_from_below(names, who)):
            yield risen
            return
        yield [f"greatest height of {body}" for body in ([who] if who else lookup.moving(names))]


def risen_from_below(names: Names, who: str) -> list[str]:
    """How much higher than at the start something comes that starts where it hangs straight down."""
    below = poses.hangs_by_its_angle(names, who)
    if who not in lookup.moving(names) or not (names.hung or below or poses.begins_at(names, who, lowest=True)):
        return []
    strings = {row.connection for row in names.constraint_rows if row.unilateral and row.reaction == "tension"}
    slackens = any(joining.touches(names, joint, who) for joint in strings)
    if slackens or (
        (names.hung or below) and not poses.turning(names, who)
    ):  # and then it is not highest where its angle turns back
        return [f"(greatest height of {who}) - (height of {who} at start)"]
    return [f"change of height of {who} until {turns}" for turns in poses.turning(names, who)]


def after_bounce(names: Names, main: Clause, instant: str) -> Groups:
    """How high does it bounce the second time? As high as it is where it first turns behind that impact."""
    who = next((name for _, name in main.names if name in lookup.moving(names)), "")
    heights = [name for name, sense in lookup.heights(names, who) if sense > 0]
    if main.only("ask", "verb", "name", "instant", "degree", "quantity", *SILENT) and len(main.names) <= 1:
        yield [f"{height} when rate({height}) = 0 {instant}" for height in heights]


def how_far(names: Names, main: Clause) -> Groups:
    """How far does it swing, how far up does it slide? As far as where it turns back."""
    lines = [name for _, name in main.names if name in names.bodies[GROUND].lines]  # up the slope, down the ramp
    main = Clause([word for word in main.words if word.what not in lines])
    who = next((name for _, name in main.names), "")
    up = main.has("updown", "up") or main.has("part", "upward") or main.has("verb", "rise")
    if len(main.names) > 1:
        return
    if main.has("updown", "down") or main.has("verb", "fall"):
        ways = [way for way, sense in lookup.heights(names, who) if sense < 0]
        ways += [way for way, sense in lookup.inclined(names, who) if sense < 0 and way not in ways]
        if not up and set(main.all("verb")) <= {"fall", "move", "reach", "hang", "slide", "roll"}:
            yield [f"change of {way} until rate({way}) = 0" for way in ways]
        return
    if set(main.all("verb")) == {"move"} and not joining.strikes(names) and lookup.flies(names, who):
        yield [f"{way} when {height} = 0" for way in lookup.level(names, who) for height in lookup.rising(names, who)]
    if up:
        sloping = [f"{way} when rate({way}) = 0" for way, sense in lookup.inclined(names, who) if sense > 0]
        yield sloping or risen_from_below(names, who)
    elif (
        set(main.all("verb")) == {"move"}
        and lookup.rests(names)
        and joining.goes_on(names)
        and not names.struck_at_start
    ):
        yield [f"{way} when rate({way}) = 0" for way in lookup.ways(names, who) if who and lookup.springs(names)]
    elif set(main.all("verb")) == {"move"} and rubbing.is_rough(names) and not lookup.rests(names) and who:
        ways = lookup.ways(names, who) if not _slips_on_what_moves(names, who) else []
        yield [f"{way} when {who} stops" for way in ways]  # with the speed that it has
    elif set(main.all("verb")) - {"move"} == {"slide"} and (names.impulses or not lookup.rests(names)):
        if not _slips_on_what_moves(names, who):
            ways = lookup.ways(names, who) or along_lines.slid(names, who)
            yield [f"distance travelled along {way} until slipping ends" for way in ways]
    elif set(main.all("verb")) == {"turn"}:
        if lookup.is_forced(names) and lookup.springs(names) and n_freedoms(names):  # it vibrates as it is shaken
            yield [f"steady amplitude of {way}" for way in lookup.places(names, who) or lookup.angles(names, who)]
            return
        if _is_rocker(names, who):
            yield [f"stroke of angle of {who}"]
            return
        if who in names.hung:
            ways = [f"change of {angle} until rate({angle}) = 0" for angle in lookup.angles(names, who)]
            yield ways or [f"(greatest angle of {who}) - (angle of {who} at start)"]
            return
        is_let_go = who in lookup.turning(names) and not driving.is_driven(names)
        if is_let_go and {*lookup.angles(names, who)} <= names.counted_from_right:
            ways = [f"change of {angle} until rate({angle}) = 0" for angle in lookup.angles(names, who)]
            yield ways or [f"change of angle of {who} until angular velocity of {who} = 0"]
            return
        placed = {*names.placed_at_start, *names.started_at_zero} if n_freedoms(names) == 1 else set[str]()
        led = {  # by what is placed, or set in motion
            name
            for name in names.measures
            if (names.start_rates and name not in names.start_rates) or (placed and name not in placed)
        }
        is_led = lookup.is_forced(names) or (names.lets_go_from_rest and not names.applied_loads)
        yield [
            f"stroke of {angle}" if angle in led or is_led else f"{angle} when rate({angle}) = 0"
            for angle in lookup.angles(names, who)
        ]
        yield [lookup.farthest(names, angle) for angle in lookup.hung(names, who)]


def _is_rocker(names: Names, who: str) -> bool:
    """Whether a body turns to and fro, by an angle that no measure tells, as another one goes round."""
    turns = who in lookup.turning(names) and not lookup.angles(names, who) and bool(of_axles.axle_of(names, who))
    return turns and n_freedoms(names) <= 1 and bool(lookup.angles(names, ""))


def slipped(names: Names, main: Clause) -> Groups:
    """How far does the parcel slip on the belt? The way along what it touches there, until both move alike."""
    who = next((name for _, name in main.names), "")
    alone = rubbing.rough(names, who) if len(main.names) == 1 else []
    joint = alone[0] if len(alone) == 1 else rubbing.slipping_on(names, main.names)
    asks = main.all("ask") == ["far"] and set(main.all("verb")) - {"move"} == {"slide"}
    if asks and joint is not None and joining.is_between(names, joint) and main.only("ask", "verb", "name", *SILENT):
        ways = along_lines.slid(names, who)
        yield [f"distance travelled along {way} until slipping of {joint} ends" for way in ways if len(ways) == 1]
        others = [body for body in lookup.moving(names) if body != who and joining.touches(names, joint, body)]
        apart = lookup.alike(names, who, others[0]) if not ways and who and len(others) == 1 else []
        yield [f"change of {a} - change of {b} until slipping of {joint} ends" for a, b in apart]


def _slips_on_what_moves(names: Names, who: str) -> bool:
    """Whether something slips on a body that moves as well: its own way is not how far it slips."""
    joints = rubbing.rough(names, who)
    return any(sum(joining.touches(names, joint, body) for body in lookup.moving(names)) > 1 for joint in joints)
