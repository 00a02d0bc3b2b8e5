"""What a question word and a verb ask for together, and which verbs say no more than a quantity does.

How fast does it turn: its angular velocity. How hard does the wall push on the ladder: a normal force. What speed does
it reach: its speed. A frame is taken from the meanings of words alone; their order is of no account.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from freebody.language.units import FORCE
from freebody.questions.spoken import joining, lookup, of_axles, rubbing
from freebody.questions.spoken.composing import SILENT
from freebody.questions.spoken.lexicon import Word
from freebody.questions.spoken.words import Clause

if TYPE_CHECKING:
    from freebody.model.names import Names

_PLAIN_ASKS = frozenset({"what", "large", "much", "with", "for", "many"})
_GOING = frozenset({"move", "turn", "roll", "fly", "slide", "fall", "rise", "reach"})
_ACTING = frozenset({"act", "exert"})
MOTION = ("velocity", "speed", "acceleration", "angular velocity", "angular acceleration")
OSCILLATION = ("natural frequency", "natural frequencies", "period", "period of small oscillations", "damped frequency")
FORCES = (
    *("force", "contact force", "tension", "normal force", "friction force", "reaction", "bearing reaction"),
    *("spring force", "axial force", "tooth force", "moment", "torque", "driving torque", "driving force", "impulse"),
)
_KINDS_OF_FORCE = ("tension", "normal force", "contact force")  # which a verb tells: it pulls, it presses
_WHERE = ("equilibrium", "instant centre", "dead points", "position", "resonance frequency")
# verbs that say no more than a quantity does: the speed that it reaches, the force that acts
_LIGHT = {
    **dict.fromkeys(MOTION, _GOING),
    **dict.fromkeys(("angular velocity", "angular acceleration"), _GOING | {"tip"}),
    **dict.fromkeys(OSCILLATION, frozenset({"move", "turn"})),
    **dict.fromkeys(FORCES, _ACTING | {"move", "carry", "hang", "reach"}),
    **dict.fromkeys(("highest place", "lowest place"), _GOING),
    "friction force": _ACTING | {"move", "carry", "hang", "reach", "hold"},
    "terminal velocity": _GOING,
    "terminal angular velocity": _GOING,
    "bounce height": frozenset({"move", "fly", "rise", "reach", "bounce"}),
    **dict.fromkeys(("free amplitude", "steady amplitude"), frozenset({"move", "turn"})),
    "links": frozenset({"move", "become"}),
    "flight time": frozenset({"move", "fly", "hold", "stay_on"}),
    "dead points": frozenset({"move", "reach", "stop"}),
    "deceleration": frozenset({"move", "stop", "slide", "roll", "rise", "fall", "reach"}),
    "angular deceleration": frozenset({"move", "stop", "turn"}),
}
# the quantity to which another one changes, by the time
_RATES = {
    **dict.fromkeys(("velocity", "speed"), "acceleration"),
    **dict.fromkeys(("position", "displacement", "height"), "velocity"),
    "angular velocity": "angular acceleration",
    "angle": "angular velocity",
}


_HAPPENING = {"end", "leave", "hit", "slack", "taut", "begin_roll", "turn_back", "return", "stop"}


@dataclass(frozen=True)
class Frame:
    """asks: question words, of which one leads it ("" where none need); verbs: of which one is in it; beside: verbs
    that may be in it as well, None where all but one may that ends it."""

    quantity: str
    asks: frozenset[str]
    verbs: frozenset[str] = frozenset()
    beside: frozenset[str] | None = frozenset()

    def fits(self, asks: set[str], verbs: set[str]) -> bool:
        is_asked = asks <= self.asks if asks else "" in self.asks
        is_done = bool(verbs & self.verbs) if self.verbs else True
        is_beside = not verbs & _HAPPENING if self.beside is None else verbs <= self.verbs | self.beside
        return is_asked and is_done and is_beside


_FRAMES = (
    Frame("acceleration", frozenset({"", "fast", "much", "large", "with"}), frozenset({"accelerate"}), _GOING),
    Frame("angular velocity", frozenset({"fast"}), frozenset({"turn"}), None),
    Frame("speed", frozenset({"fast"}), frozenset(), None),
    Frame("horizontal range", frozenset({"far"}), frozenset({"fly", "hit"})),
    Frame("deceleration", frozenset({"large", "much"}), frozenset({"stop"})),
    Frame("position", frozenset({"where"}), frozenset(), frozenset({"move"})),
    Frame("height", frozenset({"high"})),
    Frame("equilibrium", frozenset({"where"}), frozenset({"hold"}), frozenset({"move"})),
    Frame("force", frozenset({"large", "much", "what", "with"}), frozenset({"exert"}), _ACTING | {"move"}),
    Frame("force", frozenset({"large", "much"}), frozenset({"taut"}), _ACTING),
)


def framed(names: Names, clause: Clause) -> Clause:
    """The clause with the quantity that its question words and its verbs stand for, and without what says no more."""
    clause = _changing(clause)
    if rubbing.is_still(names) and clause.has("ask", "with") and clause.has("verb"):
        return clause  # the speed at which it slides is no speed of a motion
    asked, asks, verbs = clause.all("quantity"), set(clause.all("ask")), set(clause.all("verb"))
    if asks & {"with", "what"} and asked in (["force", kind] for kind in _KINDS_OF_FORCE):  # with what force it pulls
        clause, asked = clause.without("quantity", "force"), asked[1:]
    if not asked and asks == {"fast"} and verbs == {"start"}:
        return clause  # how quickly it starts is no speed, which is none at first
    kept = [w for w in clause.words if w.kind not in ("ask", "verb")]
    if joining.sloping(names) and verbs & {"slide", "roll"}:  # up the slope on which it slides
        ways = {Word("part", "upward"): "uphill", Word("part", "downward"): "downhill"}
        kept = [Word("part", ways[word]) if word in ways else word for word in kept]
    if asked in (["deflection"], ["extension"]) and asks <= {"large", "much"} and asks and _are_strings(names, clause):
        return _with_quantity(
            names, "tension", [w for w in kept if w.kind != "quantity"]
        )  # how strongly is it stretched
    if not asked and not verbs and asks and asks <= {"large", "much", "what"} and _is_push(names, clause):
        return _with_quantity(names, "force", kept)  # how large is the push
    if not asked and not asks and verbs == {"exert"} and _is_noun(clause):  # the push of the arm
        return _with_quantity(names, "force", kept)
    if not asked:
        frame = next((frame for frame in _FRAMES if frame.fits(asks, verbs)), None)
        return clause if frame is None else _with_quantity(names, frame.quantity, kept)
    climbs = bool(verbs) and verbs <= {"reach", "rise", "move", "fly"} and not clause.has("degree")
    if asked == ["height"] and climbs and asks <= _PLAIN_ASKS | {"high"}:
        return _with_quantity(names, "highest place", [w for w in kept if w.kind != "quantity"])
    if asks == {"up_to"} and asked in (["angle"], ["height"]) and verbs and verbs <= _GOING:  # to what angle
        things = [w for w in kept if w.kind != "quantity" and w.what not in names.connections]
        return Clause([Word("degree", "greatest"), Word("quantity", asked[0]), *things])
    if asked == ["velocity"] and verbs == {"accelerate"} and asks <= _PLAIN_ASKS:  # at what rate does it speed up
        return _with_quantity(names, "acceleration", [w for w in kept if w.kind != "quantity"])
    is_turned = "turn" in verbs and any(word.what in lookup.turning(names) for word in clause.words)
    if is_turned and asked[0] in ("velocity", "speed") and len(asked) == 1:  # at what rate does it turn
        kept = [w for w in kept if w.kind != "quantity"]
        return _with_quantity(names, "angular velocity", kept) if asks <= _PLAIN_ASKS else clause
    is_where = "where" in asks and bool({*asked} & {*_WHERE})
    light: frozenset[str] = frozenset[str]().union(*(_LIGHT.get(quantity, frozenset({"move"})) for quantity in asked))
    is_plain = asks <= _PLAIN_ASKS and verbs <= light
    is_far = (
        asked[0] in ("deflection", "sag", *lookup.STRETCHED)
        and len(asked) == 1
        and asks <= {"far", "much", "large"}
        and not verbs
    )
    is_fast = asked == ["angular velocity"] and asks <= {"fast"}  # how fast does it spin
    is_slowed = asked[0] in ("deceleration", "angular deceleration") and asks <= {"fast", *_PLAIN_ASKS}
    if is_where or is_plain or is_far or (is_fast and verbs <= light) or (is_slowed and verbs <= light):
        return Clause(kept)
    return clause


def _are_strings(names: Names, clause: Clause) -> bool:
    """Whether all that is named are ropes."""
    pulling = {row.connection for row in names.constraint_rows if row.reaction == "tension"}
    of = [name for _, name in clause.names]
    return bool(of) and set(of) <= pulling


def _is_push(names: Names, clause: Clause) -> bool:
    """Whether a load that is a force stands there, and nothing else."""
    of = [name for _, name in clause.names]
    return len(of) == 1 and names.loads.get(of[0]) == FORCE and clause.only("ask", "name", *SILENT)


def _is_noun(clause: Clause) -> bool:
    """Whether a verb stands where a noun does: before all that is named."""
    kinds = [word.kind for word in clause.words if word.kind in ("verb", "name", "part")]
    return kinds[:1] == ["verb"] or kinds[:2] == ["part", "verb"]


def _with_quantity(names: Names, quantity: str, words: list[Word]) -> Clause:
    """Words with the quantity of a frame, as what is named has it."""
    of = [word.what for word in words if word.kind == "name"]
    if quantity == "acceleration":
        is_turned = Word("part", "angular") in words or any(of_axles.axle_of(names, name) == "center" for name in of)
        words = [word for word in words if word != Word("part", "angular")]
        quantity = "angular acceleration" if is_turned else quantity
    elif quantity == "force":
        quantity = _exerted(names, of)
        if words and words[-1] == Word("preposition", "with"):  # what does the wall push with
            words = words[:-1]
    return Clause([Word("quantity", quantity), *words])


def _exerted(names: Names, of: list[str]) -> str:
    """The force that something exerts: a rope pulls, a wall pushes."""
    for name in of:
        own = {row.reaction for row in names.constraint_rows if row.connection == name}
        for kind in ("tension", "normal force"):
            if kind in own:
                return kind
    if any(name in names.loads or name in names.connections for name in of):
        return "force"
    return "contact force"


def _changing(clause: Clause) -> Clause:
    """The rate at which a quantity changes is another quantity."""
    asked = clause.all("quantity")
    rate = Word("quantity", "rate of")
    if asked == [rate.what] and len(clause.names) == 1:  # wie schnell steigt der Klotz
        return Clause([Word("ask", "fast"), *clause.without("quantity").words])
    if len(asked) != 2 or rate not in clause.words:
        return clause
    [of] = [quantity for quantity in asked if quantity != rate.what] or [""]
    if of not in _RATES:
        return clause
    kept = [word for word in clause.words if word != rate]
    return Clause([Word("quantity", _RATES[of]) if word == Word("quantity", of) else word for word in kept])
