"""Whether each word of a question is expressed by what is understood: what was dropped could change the quantity.

Every verb, instant, degree, mark and quantity that the lexicon knows is either empty (it says nothing that another
word does not say: the force that *acts*) or has words of the grammar of which one must stand in the text. A word that
none of them expresses has been dropped, and then another quantity is understood than was asked for: the force *while
it slides* is not that at the start.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from functools import cache
from itertools import takewhile

from freebody.measures.geometry import GROUND
from freebody.questions.spoken.lexicon import ENGLISH, Word, tables

# classes of words of the grammar: a question about a choice, what lasts, what ends it, an instant, an equation
_CHOICE = r"value of|range of|largest|least|critical"
_REST = r"at rest|hold|equilibrium|stable|stability|\bzero\b|= 0\b|-> 0"
_SLIP = r"slip|slid|roll|friction|belt|clutch|lost|lossless|tip|lift|grow"
_INSTANT = r"\b(?:when|until|after|before|at|as|while|during|between|in|over) |~"
_EQUAL = r"(?<![<>])=|reach|within"
_IMPACT = r"impact|blow|collision|bounce|catch|caught|hit|touch|struck|at start|taut|clos|jerk|lost"
_WAY = (
    r"change of|distance|displacement|turns|degrees|stroke|travel|path|\bwhen\b|\bafter\b|position|"
    r"greatest|least|largest"
)
_MOVES = r"speed|velocity|rate|acceleration|frequency|period|ratio|turns"
_POSE = r"\b(?:when|until|before|after) .*="
_END_OF_SWING = rf"{_POSE}|turn|dead|top|highest|greatest|farthest|extreme|amplitude|largest"

# kinds of words of which each must be expressed, and how: by words of the grammar, one of which the text must have.
# An empty string: it says nothing by itself
EXPRESSED: dict[str, dict[str, str]] = {
    "instant": {
        "at start": rf"start|begin|once|initial|release|blow|time |until|change of|before|after |{_CHOICE}",
        "in steady motion": r"steady|grows|terminal|stationary|resonance|mean",
        "when t grows": r"^whether |grows|steady|end|terminal|stop|until|limit|when",
        "at the end": r"grows|steady|end|terminal|stop|until|limit|when|=|equilibrium",
        "over the motion": r"over|until|greatest|least|work|period|^(?!.*\b(?:when|at start)\b)",
        "for a full turn": r"turn|cycle|period|round|stroke|range of|largest|least .* so that|pi \* ratio",
        "over a turn": r"turn|cycle|period|range|stroke|mean|greatest|least|ratio|pi\b|extremes",
        "at once": r"once|immediately|start|before it (?:tips|slides)",
        "at the top": rf"{_END_OF_SWING}|height|start",
        "at the bottom": rf"{_POSE}|bottom|lowest|least|greatest|start|equilibrium",
        "at the top of the loop": rf"{_END_OF_SWING}|start",
        "at the dead points": rf"{_POSE}|dead",
        "at the outer dead point": rf"{_POSE}|dead",
        "at the inner dead point": rf"{_POSE}|dead",
        "in equilibrium": rf"{_REST}|steady|static",
        "level": rf"{_POSE}|level|horizontal|start",
        "upright pose": rf"{_POSE}|upright|vertical|start",
        "turning point": _END_OF_SWING,
        "after engagement": r"slip|engage|common|after|until",
        "at separation": r"leav|open|contact|lost|lift|separat|taut|slack|relaxed",
        "after the impact": rf"{_IMPACT}|after|greatest|height|rate\(|relaxed",
        "before the impact": rf"{_IMPACT}|before|value",
        "at the impact": rf"{_IMPACT}|{_POSE}|is reached",
        "in the impact": rf"{_IMPACT}|{_POSE}",
    },
    "degree": {
        "greatest": r"greatest|largest|most|steady amplitude|highest|maximum|max|range|value|farthest|top|extremes|"
        r"when rate|when .*turns back|until|first|stop|limit|critical|resonance|lowest|dead|equilibrium",
        "least": r"least|smallest|lowest|minimum|min\b|range|value|ratio of \||critical|equilibrium|stop|"
        r"extremes|first|shortest|\|.*friction|closest|when .*rate|over a turn|largest .* so that",
        "range": r"range|for which|least|largest|value|extremes|limits",
        "value": rf"{_CHOICE}|equilibrium|for which| over | when ",
        "first": r"first|tip|when|until|before|mode|lowest",
    },
    "mark": {
        "when": rf"{_INSTANT}|{_CHOICE}|so that|for which|keeps|time|{_REST}|{_IMPACT}|->|grow|terminal|resonance|"
        r"tip or slide|critical|flight|escape|[*] ratio|efficiency",
        "until": rf"{_INSTANT}|{_CHOICE}|so that|time|lost|{_REST}|stopping|turns",
        "after": rf"{_INSTANT}|{_CHOICE}|time|{_IMPACT}",
        "while": r"while|until|during|over|so that|for which|lost|work|greatest|least|at start|^(?!.*\bwhen\b)",
        "so_that": rf"so that|for which|keeps|{_CHOICE}|time|ratio|{_REST}|needed|driving|friction force|\bto\b|"
        rf"until|when",
        "to": rf"so that|for which|keeps|{_CHOICE}|time|ratio|{_REST}|force|torque|moment|power|work|energy|reaction|"
        rf"tension|until",
        "without": r"not|no |without|->|roll|rest|so that|hold|for which|= 0|least|largest|range|static",
    },
    "not": {
        "not": rf"not|no |{_REST}|least|largest|range|roll|stay|keep|lossless|independent|without|same|never|stands|"
        r"greatest|-> |value of .* for which|when .*(?:rate|stops)|ratio of [|]|friction force",
    },
    "part": {
        "angular": r"angular|turns|angle",
        "horizontal": rf"horizontal|right|along|\bx\b|component|{_CHOICE}|{_EQUAL}|range|change of|distance|"
        r"when|steady|"
        rf"level|\by\b|tension",
        "vertical": rf"vertical|\bup\b|down|along|\by\b|component|{_CHOICE}|{_EQUAL}|height|change of|steady|upright|"
        rf"level|tension|when",
        "initial": rf"start|initial|before the blow|{_CHOICE}|\d",
        "mean": r"average",
        "size": r"size|\||speed|magnitude|of|greatest|largest",
        "small": r"small|frequenc|period|damp|stab|mode|decrement|swing|natural|equation|acceleration",
        "driving": r"driving|motor|torque|force|power",
        "in own axes": r" in \w+$",
        "upright": r"=|upright|vertical|stable|stability|equilibrium|start",
        "hanging": r"=|upright|vertical|stable|stability|equilibrium|start",
        "to the right": r"=|upright|vertical|stable|stability|equilibrium|start",
        "to the left": r"=|upright|vertical|stable|stability|equilibrium|start",
        "only": "",
        "upward": "",
        "downward": "",
        "downhill": "",
        "uphill": "",
    },
    "quantity": {
        "acceleration": rf"acceler|decel|rate|{_CHOICE}|does it",
        "normal acceleration": r"normal acceleration|\^2",
        "tangential acceleration": r"tangential|acceleration",
        "beat period": r"natural frequency",
        "beat frequency": r"natural frequency",
        "radial velocity": r"velocity|speed",
        "radial acceleration": r"acceleration",
        "transverse velocity": r"velocity|speed",
        "radius of curvature": r"curvature",
        "velocity": rf"velocity|speed|rate|{_CHOICE}|ratio|does it",
        "speed": rf"velocity|speed|rate|{_CHOICE}|ratio|turns|[*]|time|steady|does it",
        "impact speed": r"velocity|speed|rate",
        "impact angle": r"angle of velocity",
        "angle of descent": r"angle of velocity",
        "angle to the horizontal": r"angle of velocity",
        "direction of motion": r"direction of velocity",
        "common speed": r"velocity|speed|rate",
        "relative velocity": r"velocity|speed|rate",
        "closing speed": r"velocity of distance",
        "tension ratio": r"tension",
        "slip speed": r"velocity|speed|rate|slip",
        "angular velocity": rf"velocity|speed|rate|{_CHOICE}|ratio|turns|[*]|time|steady|frequency|angular|does it",
        "spin rate": r"velocity|rate",
        "angular acceleration": rf"acceleration|rate|{_CHOICE}",
        "angular deceleration": rf"acceleration|rate|{_CHOICE}",
        "deceleration": rf"acceler|decel|rate|{_CHOICE}",
        "kinetic energy": r"kinetic|lost|work",
        "potential energy": r"potential|energy",
        "total energy": r"total|energy|conserved",
        "spring energy": r"spring|energy|\^2",
        "rotational energy": r"kinetic energy",
        "translational energy": r"translational",
        "energy": r"energy|work|lost",
        "energy lost": r"lost|heat|work|loss",
        "kinetic energy lost": r"lost|kinetic|work",
        "heat of kinetic energy": r"lost",
        "power": rf"power|{_CHOICE}",
        "transmitted power": r"force of .* [*] .*velocity|greatest power",
        "work": r"work|energy|lost",
        "work of friction": r"work|lost",
        "linear momentum": r"linear momentum|impulse of",
        "angular momentum": r"angular momentum",
        "impulse": rf"impulse|{_CHOICE}",
        "angular impulse": rf"impulse|{_CHOICE}",
        "natural frequency": rf"frequenc|period|2 ?[*] ?pi|{_CHOICE}",
        "natural frequencies": rf"frequenc|period|{_CHOICE}",
        "cycles per second": r"frequency|period",
        "damped frequency": rf"frequency|period|{_CHOICE}",
        "damped period": rf"period|{_CHOICE}",
        "period": rf"period|time|{_CHOICE}",
        "period of small oscillations": rf"period|{_CHOICE}",
        "period of the motion": rf"period|{_CHOICE}",
        "tension": rf"tension|force|(?:work|power) of|pull of|reaction|{_CHOICE}|"
        r"theta when|speed of|slack|taut|ratio|conserved",
        "normal force": rf"normal|tension|contact|reaction|{_CHOICE}|leav|open|lost|speed of",
        "friction force": rf"friction|lost|work|slip|{_CHOICE}|does it|hold",
        "bending moment": r"bending moment",
        "shear force": r"shear",
        "transverse force": r"shear|normal",
        "contact force": rf"force|reaction|tension|impulse|{_CHOICE}|leav|open|lost",
        "bearing reaction": rf"reaction|{_CHOICE}|force in|impulse",
        "reaction": rf"reaction|normal|tension|force|{_CHOICE}|moment|impulse",
        "tooth force": rf"tooth|belt|chain|force|{_CHOICE}",
        "driving torque": rf"torque|{_CHOICE}|moment",
        "friction coefficient": rf"ratio of [|]|{_CHOICE}|friction coefficient",
        "mass": rf"\bmass of|{_CHOICE}",
        "weight": r"\bon \w",
        "amplitude decay": r"decrement",
        "amplitude loss": r"decrement",
        "stiffness": _CHOICE,
        "efficiency": r"efficiency|ratio",
        "basic efficiency": r"efficiency",
        "damping ratio": rf"damp|{_CHOICE}",
        "phase lag": r"phase",
        "stroke": r"stroke",
        "time ratio": r"time ratio",
        "transmission angle": r"transmission",
        "pressure angle": r"pressure angle",
        "gear ratio": rf"ratio|{_CHOICE}",
        "mechanical advantage": rf"advantage|ratio|{_CHOICE}",
        "ratio": rf"ratio|/|{_CHOICE}",
        "difference": r" - |belt force|relative",
        "sum": r" [+] ",
        "fraction": r"ratio|/",
        "change": r"change|kinetic energy| - |lost|sensitivity|derivative",
        "instant centre": r"instant centre",
        "degrees of freedom": r"degrees of freedom",
        "terminal velocity": r"grows|terminal|steady|rolling|when |final",
        "terminal angular velocity": r"(?:angular|theta|phi|rate|velocity of \w+) .*(?:grows|terminal|steady|when )|"
        r"final",
        "steady amplitude": r"amplitude|greatest",
        "free amplitude": r"amplitude|greatest|=",
        "resonance frequency": rf"resonance|frequency|{_CHOICE}",
        "transmissibility": r"transmissib",
        "magnification factor": r"magnification",
        "quality factor": r"quality",
        "equilibrium": rf"{_REST}|{_CHOICE}|speed|velocity|static",
        "time": rf"time|{_CHOICE}|period|until|when",
        "stopping time": r"time",
        "flight time": rf"time|{_CHOICE}",
        "turns": r"turns|ratio|angle",
    },
    "verb": {
        # of motion itself, which what is asked of it says already
        **dict.fromkeys(("move", "turn", "exert", "act", "become", "carry", "suffice", "compare", "change"), ""),
        "accelerate": rf"acceler|{_CHOICE}|force|torque|reaction|tension|as \w+ grows|terminal|steady",
        "slide": rf"{_SLIP}|{_REST}|{_WAY}|{_CHOICE}|{_MOVES}|time|flow|\bx\b|reaction|tension|energy",
        "roll": rf"{_SLIP}|{_REST}|{_WAY}|{_CHOICE}|{_MOVES}|time|force|reaction|energy|torque|tension",
        "fly": rf"{_SLIP}|{_WAY}|time|speed|velocity|{_EQUAL}|height|{_CHOICE}|leaves|range|open|energy|acceleration",
        "fall": rf"{_WAY}|time|{_MOVES}|{_EQUAL}|height|{_CHOICE}|tip|{_REST}|changed|tension|force|reaction|"
        rf"energy|work|down|lower",
        "rise": rf"{_WAY}|time|{_MOVES}|{_EQUAL}|height|{_CHOICE}|{_REST}|changed|tension|force|torque|reaction|"
        rf"energy|work|power|up|efficiency|lift|tip|leaves|whether",
        "hit": rf"{_IMPACT}|reach|{_EQUAL}|\bwhen\b|until|turns back|value of|range of|least|largest",
        "leave": r"leav|open|contact|lost|lift|stays on|keeps|off|after the|>= 0|= 0|until|at once|slack|run|taut|"
        r"range|"
        r"when|tip|value of|largest|least|relaxed|after",
        "be_open": r"=|open",
        "lock": rf"lock|rate\(|= 0|slip|{_CHOICE}|first|hold",
        "stop": rf"stop|dead|rest|rate\(|= 0|hold|equilibrium|{_CHOICE}|slip|end|until|turns back|upright|=|roll",
        "remain": rf"{_REST}|stops|turns back",
        "turn_back": r"dead|rate\(|turns? back|highest|greatest|top|stop|farthest|until|=",
        "return": rf"return|back|{_EQUAL}|changed|rate\(|{_CHOICE}|period",
        "reach": rf"{_EQUAL}|reach|greatest|largest|{_CHOICE}|highest|when|until|hit|touch|at the|terminal|"
        r"grows|period|time|resonance|over|acceleration|equilibrium",
        "start": rf"start|begin|at once|roll|slip|{_REST}|time|{_CHOICE}|leav|open|slack|tip|motion|lift|"
        r"unstable|grow|when|until|keeps|after",
        "from_rest": r"start|rest|stands|zero|initial|when|after|time|until|=",
        "begin_roll": r"roll|slip",
        "end": rf"end|stop|{_REST}|until|when|over|{_CHOICE}|slip|after",
        "stay_on": r"relaxed$|stays on|keeps|contact|leav|open|>= ?0|= ?0|normal force|force|tension|range|least|taut",
        "slack": r"slack|taut|tension|relaxed|= 0|loose|free|>= 0|length|force",
        "stay_taut": r"slack|taut|tension|tight|>= 0",
        "taut": r"slack|taut|tension|tight|>= 0|jerk|stretched|blow|impact",
        "hold": rf"{_REST}|friction|force|torque|moment|reaction|tension|{_EQUAL}|time|slip|tip|{_CHOICE}|steady|stay|"
        rf"normal|stop|held|never leaves",
        "tip": rf"tip|turn over|lift|topple|{_CHOICE}|angular|=|open",
        "conserved": r"conserved|constant|is ",
        "stable": r"stable|stability|equilib|steady|does it hold",
        "unstable": r"stable|stability|equilib|steady",
        "turn_fully": rf"fully|tips|crank|grashof|degrees|turn|round|taut|reach|{_CHOICE}|can|is ",
        "assemble": r"assembl|close|built|degrees|range",
        "grow": r"grow|increas|->|as |rate|acceleration|derivative|sensitivity|does|steady| - ",
        "top": rf"{_END_OF_SWING}|reach|height|rate\(|>= 0|time",
        "bottom": r"=|bottom|lowest|least|greatest|reach|rate\(|turns back",
        "damped": r"damp",
        "critical": r"critical|damp",
        "massless": r"->|= 0|massless|zero",
        "smooth": r"->|= 0|smooth|friction|conserved",
        "bounce": rf"{_IMPACT}|after|rate\(|greatest|height|velocity|speed|highest",
        "lost": r"lost|loss|energy|heat|friction|efficiency|work|power|dissipat",
        "vanish": r"= 0|zero|vanish|rate\(|relaxed|slack|open|stop|free|equilibrium|-> 0",
        "self_locking": r"lock|hold|rest|efficiency|friction|slip|range|least|largest",
        "no_slip": r"slip|roll|rest|hold|slid|lossless|tip",
        "no_accel": rf"acceler|steady|{_REST}|{_CHOICE}|constant|rate|torque|force",
        "halve": r"/ ?2|half|halv|0\.5",
        "hang": rf"{_REST}|=|{_CHOICE}|start|when|below|down|tension|reaction",
        "run_off": r"=|run|off|unwound|end|leav",
        "no_move": rf"{_REST}|{_CHOICE}|slip|mov",
        "engage": r"slip|common|engage|after|blow|impact|until|velocity of \w+ = velocity",
        "infinite": r"->|infin|grow",
        "shrink": r"->|shrink|decreas|grow|as |rate",
    },
}
_NTH = re.compile(r"(second|third|fourth|fifth)")
_WHEN, _AFTER, _LEAST = Word("mark", "when"), Word("mark", "after"), Word("degree", "least")
_FRICTION, _ROUGH = Word("quantity", "friction force"), Word("ask", "rough")
_AXES = (Word("preposition", "along"), *(Word("updown", way) for way in ("up", "down")))
_TURNS = (Word("preposition", "over"), Word("instant", "over a turn"), Word("instant", "for a full turn"))
_OF_SIDE = [Word("preposition", side) for side in ("just before", "just behind", "left of", "right of")]
_AT_REST = re.compile(r"^range of \w+ that keeps it at rest$")
_MOTIONS = {"move", "fall", "rise", "slide", "roll", "turn", "fly"}
_LIMITING = (  # of which one is said where it is asked how much of something is enough
    *(Word("filler", what) for what in ("may", "must")),
    *(Word("mark", what) for what in ("so_that", "to", "until", "when", "without", "while")),
    *(Word("ask", what) for what in ("from", "up_to", "for", "with")),
    *(Word("verb", what) for what in ("suffice", "no_slip", "no_move")),
)
_STARTS, _WHICH_WAY = Word("verb", "start"), Word("ask", "way")
_POSES = {"horizontal": "level", "vertical": "upright pose"}  # and the instant at which something is so
_TURNED_ROUND = ("flat", "small")  # question words of which at most is the least
_BY_ITSELF = ("long",)  # asks for how long something is done
_AT_AN_INSTANT = {"hit"}  # done in no time: how long does it touch is no time until it does
_LEADS = ("until", "after", "to", "when", "while", "so_that")


@cache
def _pattern(kind: str, what: str) -> re.Pattern[str]:
    return re.compile(EXPRESSED[kind][what])


def dropped(words: Sequence[Word], text: str) -> list[Word]:
    """The words that nothing in words of the grammar expresses."""
    others = (
        _of_a_turn,
        _without_end,
        _of_other_end,
        _up_to_what_was_before,
        _without_axis,
        _without_side,
        _of_what_lasts,
        _of_both_failures,
        _against_another,
    )
    return [*_unexpressed(words, text), *(word for told in others for word in told(words, text))]


def _against_another(words: Sequence[Word], text: str) -> list[Word]:
    """That something turns so fast relative to another body is not how fast it turns; to the ground it is."""
    relative, own = Word("preposition", "relative"), [word for word in words if word.kind not in ("filler", "value")]
    if relative not in own or re.search(r"relative|slip|displacement| - |ratio", text):
        return []
    behind = own[own.index(relative) + 1 :]
    is_body = bool(behind) and behind[0].kind in ("name", "pronoun") and not behind[0].what.startswith(GROUND)
    return [relative] if is_body and Word("mark", "when") in own else []


def _of_both_failures(words: Sequence[Word], text: str) -> list[Word]:
    """What tips and slides at once does not do the one alone; that it does neither is that it rests."""
    failures = {"tip": r"tip", "slide": r"slid|slip"}
    said = [word for word in words if word.kind == "verb" and word.what in failures]
    if {word.what for word in said} != {*failures} or re.search(_REST, text):
        return []
    return [word for word in said if re.search(failures[word.what], text) is None]


def _unexpressed(words: Sequence[Word], text: str) -> list[Word]:
    found: list[Word] = []
    for k, word in enumerate(words):
        if _goes_on(words, k) or (word == _STARTS and words[0] == _WHICH_WAY):  # as it is accelerated
            continue
        if word.kind == "degree" and words[0].what in _TURNED_ROUND and text.startswith(("least ", "largest ")):
            continue  # how flat at most is the least angle
        word = Word("instant", _POSES[word.what]) if _is_pose(words, k) else word
        if word.kind == "instant" and (nth := _NTH.search(word.what)):
            is_there = nth[1] in text
        else:
            is_there = word.what not in EXPRESSED.get(word.kind, ()) or bool(
                _pattern(word.kind, word.what).search(text)
            )
        if not is_there:
            found.append(word)
    return found


def _is_pose(words: Sequence[Word], k: int) -> bool:
    """Whether a word says in which pose something is, behind `when`, and no part of a quantity."""
    behind = [*takewhile(lambda word: word.kind in ("name", "pronoun", "filler", "verb"), reversed(words[:k]))]
    before = words[k - len(behind) - 1] if len(behind) < k else None
    return words[k].kind == "part" and words[k].what in _POSES and before == _WHEN


def _goes_on(words: Sequence[Word], k: int) -> bool:
    """Whether a clause only says that a motion goes on, and no instant of it: as the bucket falls."""
    clause = [word for word in words[k + 1 :] if word.kind not in ("filler", "pronoun", "name", "preposition")]
    return words[k] == _WHEN and [word.kind for word in clause] == ["verb"] and clause[0].what in _MOTIONS


def _of_other_end(words: Sequence[Word], text: str) -> list[Word]:
    """The least that moves something is the most that does not: but without a verb least is least."""
    is_least = text.startswith("largest ") and not any(word.kind == "verb" for word in words)
    return [word for word in words if is_least and word == _LEAST]


def _up_to_what_was_before(words: Sequence[Word], text: str) -> list[Word]:
    """How far it goes on after something has happened is no way until that happens."""
    k = words.index(_AFTER) if _AFTER in words and re.search(r" until |^time when ", text) else len(words)
    clause = list(takewhile(lambda word: word.kind not in ("mark", "ask"), words[k + 1 :]))
    is_event = any(word.kind == "verb" for word in clause)
    is_counted = any(word.kind in ("value", "turns", "relation") for word in words[k + 1 :])
    return [_AFTER] if is_event and not is_counted else []


def _of_a_turn(words: Sequence[Word], text: str) -> list[Word]:
    """The range that something has over a turn is none of values with which it stays at rest."""
    over = [word for word in words if word in _TURNS]
    return over if _AT_REST.search(text) else []


def _of_what_lasts(words: Sequence[Word], text: str) -> list[Word]:
    """The friction force while something sticks, that holds it, or on a body when something is so, is a force, and not
    how much friction that takes."""
    lasts = words[0] == _FRICTION and Word("mark", "while") in words
    behind = words[words.index(_FRICTION) + 1 :] if _FRICTION in words else ()
    acts = next((word.what for word in behind if word.kind != "filler"), "") in ("on", "at", "in")  # a body, or a place
    limiting = set(_LIMITING) - ({_WHEN, Word("mark", "until")} if acts else set())
    is_force = lasts or (_FRICTION in words and not any(word in limiting or word.kind == "not" for word in words))
    is_limit = any(word.kind == "degree" or word == _ROUGH for word in words)
    return [_FRICTION] if is_force and not is_limit and re.match("range|least|largest|value", text) else []


def _without_axis(words: Sequence[Word], text: str) -> list[Word]:
    """A momentum along something, or about an axis, is one component of it."""
    is_asked = any(word.kind == "quantity" and word.what.endswith(" momentum") for word in words)
    axes = [word for word in words if word in _AXES]
    return axes if is_asked and not re.search(r"\balong\b|generalized", text) else []


def _without_side(words: Sequence[Word], text: str) -> list[Word]:
    """Left of a point, or just before it, is one side of it."""
    sides = [word for word in words if word in _OF_SIDE]
    return sides if not re.search(r"\bjust (?:before|behind)\b|\bbetween\b", text) else []


def _without_end(words: Sequence[Word], text: str) -> list[Word]:
    """How long something lasts that is over as soon as it happens is another time than that at which it happens."""
    is_long = any(word.kind == "ask" and word.what in _BY_ITSELF for word in words)
    is_led = any(word.kind == "mark" and word.what in _LEADS for word in words)
    if not is_long or is_led or not text.startswith("time when "):
        return []
    return [word for word in words if word.kind == "verb" and word.what in _AT_AN_INSTANT]


def kinds_without_entry() -> list[Word]:
    """The words of the lexicon of which the table does not say how they are expressed."""
    return [
        Word(kind, what)
        for kind, entries in EXPRESSED.items()
        if kind
        != "quantity"  # of those that are not in it, the words of the grammar are the same, or names of measures
        for what in tables(ENGLISH)[kind]
        if what not in entries and not _NTH.search(what)
    ]
