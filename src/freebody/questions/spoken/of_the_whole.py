"""What is asked of the system itself: whether it stays at rest, is stable, can be assembled; what is conserved."""

from __future__ import annotations

from typing import TYPE_CHECKING

from freebody.questions.spoken import (
    given,
    joining,
    lookup,
    rubbing,
    transmitting,
)
from freebody.questions.spoken.asking import quantities
from freebody.questions.spoken.composing import SILENT, Groups
from freebody.questions.spoken.lexicon import Word
from freebody.questions.spoken.sentence import Sentence
from freebody.questions.spoken.so_that import stands
from freebody.questions.spoken.throughout import is_throughout
from freebody.questions.spoken.words import Clause

if TYPE_CHECKING:
    from freebody.model.names import Names


_HOLDS = ({"friction force"}, {"friction coefficient"}, {"force"}, {"tension"})  # what may be enough to hold something
_FAILS = {"leave": "tip", "rise": "tip", "turn": "slide"}  # how what stands on wheels fails


def structure(names: Names, sentence: Sentence) -> Groups:
    """What is asked of the system itself: whether it stays at rest, turns fully, is stable, can be assembled."""
    main = sentence.main
    whole = Clause([*main.words, *(word for _, own in sentence.others for word in own.words)])
    growing = [name for _, name in whole.names if name in names.parameters]
    bodies = [name for _, name in whole.names if name in names.bodies]
    kinds = [given.KIND_OF[what] for what in whole.all("quantity") if given.is_by_unit(what)]
    if not growing and whole.has("verb", "grow") and all(lookup.is_all_that_moves(names, name) for name in bodies):
        growing = given.growing(names, [name for _, name in whole.names])
        growing = [name for name in growing if all(kind.has(names.parameters[name]) for kind in kinds)]
    doing = set(whole.all("verb")) - {"start", "move"}
    if {"tip", "slide", "rise"} == doing:  # when the ramp is raised
        doing, growing = {"tip", "slide", "grow"}, growing or given.growing(names, [])
        bodies = []
    if rubbing.is_still(names) and whole.has("degree", "first"):  # whether wheels spin, or others lift off first
        spin = {"turn"} if whole.has("quantity", "angular velocity") else set[str]()
        doing = {_FAILS.get(verb, verb) for verb in doing | spin}
    if doing == {"tip", "slide"} and not (sentence.others or whole.has("ask")):  # of the only force
        growing = growing or given.growing(names, [])
        doing |= {"grow"}
    if doing == {"tip", "slide", "grow"} and not growing and len(kinds) == 1:  # as the acceleration increases
        growing = given.chosen(names, kinds[0], [])
        bodies = []
    fails = doing == {"tip", "slide", "grow"} and not whole.has("value")
    fails = fails and lookup.rests(names)
    if fails and len(growing) == 1 and not whole.has("not") and set(whole.all("degree")) <= {"first"}:
        yield [f"does it tip or slide as {growing[0]} grows"]
    verbs, of = set(main.all("verb")), [name for _, name in main.names]
    grown = [
        own.names[0][1] for mark, own in sentence.others if mark == "when" and own.has("verb", "grow") and own.names
    ]
    if verbs & {"tip"} and verbs & {"slide"} and len(verbs - {"start", "move"}) == 2 and len(grown) == 1:
        yield [f"does it tip or slide as {grown[0]} grows"]
    doing = set(whole.all("verb"))
    is_enough = "suffice" in doing <= {"hold", "suffice"} or (doing == {"slide", "suffice"} and whole.has("not"))
    holding = (Word("verb", "hold"), Word("quantity", "friction force"))
    is_held = doing == {"hold"} and main.words[:1] and main.words[0] in holding  # does friction hold it
    is_plain = whole.only("verb", "quantity", "mark", "name", "not", *SILENT) and set(whole.all("quantity")) in _HOLDS
    if (is_enough or is_held) and is_plain and lookup.rests(names):
        yield ["does it hold"]
    if sentence.others or main.has("value") or main.has("relation") or main.has("turns"):
        return
    slips_not = verbs == {"slide"} and main.has("not") and main.only("verb", "name", "not", *SILENT)
    if slips_not and all(rubbing.is_all_that_slips(names, name) for name in of) and not rubbing.rolls(names):
        yield ["does it hold"] if lookup.rests(names) else []
    asks_when = main.words[:1] and main.words[0].kind == "ask" and main.words[0].what in ("when", "soon", "with")
    if asks_when and verbs == {"stable"} and main.all("quantity") == ["equilibrium"] and not of:
        yield ["stability of equilibrium"]  # whose answer says when
    if asks_when and verbs == {"stable"} and not main.has("quantity") and not of and lookup.is_controlled(names):
        yield ["stability of steady motion"]
    if main.all("ask") == ["long"] and len(of) == 1 and main.only("ask", "name", *SILENT):  # how long is the cable
        yield [f"length of {name}" for name in of if name in transmitting.having(names, "length")]
    if main.has("quantity", "degrees of freedom") and main.only("quantity", "ask", "pronoun", "preposition", "verb"):
        yield ["degrees of freedom"]
    asks_nothing = not (main.has("ask") or main.has("not") or main.has("degree") or main.has("quantity"))
    everything = all(lookup.is_all_that_moves(names, name) or rubbing.is_all_that_slips(names, name) for name in of)
    comes_to_rest = "stop" in verbs and joining.comes_to_strike(names) and not rubbing.is_rough(names)  # let fall
    if verbs and verbs <= {"hold", "move", "stop", "remain"} and verbs - {"move"} and asks_nothing and everything:
        yield ["does it hold"] if lookup.rests(names) and not comes_to_rest else []
    at_rest = main.all("instant") == ["in equilibrium"] and main.only("instant", "name", "pronoun") and everything
    if lookup.rests(names) and at_rest:
        yield ["does it hold"]
    begins = verbs - {"start"}
    is_other = "slide" in begins and (rubbing.rolls(names) or not rubbing.is_rough(names))
    is_begun = begins and begins <= {"move", "slide", "turn"} and main.only("verb", "name", *SILENT)
    if is_begun and everything and not is_other:
        yield ["does it hold"] if lookup.rests(names) else []
    if verbs & {"stable", "unstable"} and main.only("verb", "quantity", "pronoun", "preposition", "name", "instant"):
        asked = main.all("quantity")
        is_all = len(of) <= 1 or "in equilibrium" in main.all("instant")  # what a part is at is that of all
        spins = names.space and not lookup.rests(names) and not asked
        if not asked and (lookup.is_controlled(names) or spins) and is_all:
            yield ["stability of steady motion"]
        is_held = rubbing.is_rough(names) and lookup.rests(names) and verbs == {"stable"} and not main.has("ask")
        if is_held and not asked and everything and not main.all("instant"):  # of what friction holds
            yield ["does it hold"]
        if asked == ["equilibrium"] or (not asked and is_all and not spins):
            yield ["stability of equilibrium"]
    if "turn_fully" in verbs and main.only("verb", "name", "ask") and len(of) == 1 and not main.has("ask"):
        yield [f"does {of[0]} turn fully"] if not stands(names, of[0]) else []
    is_chosen = any(name in names.parameters for name in of)  # for which b it locks itself
    if (
        verbs == {"self_locking"} and main.only("verb", "name", "ask", *SILENT) and not is_chosen
    ):  # rest needs no torque
        yield [f"is {name} self-locking" for name in joining.threads(names, of)]
        locks = rubbing.locking_itself(names, of)
        yield [each.replace("it stays at rest", "does it hold") for each in locks if "at rest" in each]
        yield [f"whether {each}" for each in locks if "at rest" not in each]
        pushes = [
            name
            for name in given.of_kind(names, "torque")
            if joining.threads(names, []) and name in given.chosen(names, given.KIND_OF["torque"], [])
        ]
        yield [f"range of {push} that keeps it at rest" for push in pushes]
    if "assemble" in verbs and not main.has("quantity") and not of:
        yield ["when does the loop assemble"]
    if verbs == {"damped"} and main.only("verb", "name", "pronoun"):
        yield ["damping ratio"]
    if verbs & {"tip"} and verbs & {"slide"} and len(verbs - {"start", "move"}) == 2:
        grows = [name for name in of if name in names.parameters]
        yield [f"does it tip or slide as {name} grows" for name in grows]


def conserved(names: Names, sentence: Sentence) -> Groups:
    """Is the total energy conserved? When is it?"""
    main = sentence.main
    if main.words[:1] == [Word("verb", "change")]:  # does the energy change: whether it is conserved tells that
        main = Clause([Word("verb", "conserved"), *main.words[1:]])
    if not main.has("verb", "conserved") or main.has("not"):
        return
    asks_when = main.has("ask", "when", "with")
    others = [clause for mark, clause in sentence.others if not is_throughout(names, mark, clause)]
    if (main.has("ask") and not asks_when) or others:
        return
    in_blow = [w for w in main.words if w in (Word("instant", "in the impact"), Word("instant", "at the impact"))]
    struck = [w for w in main.words if in_blow and w.kind == "name" and w.what in names.connections][-1:]
    silent = (Word("verb", "conserved"), Word("verb", "move"), *in_blow, *struck)
    kept = Clause([w for w in main.words if w.kind not in ("ask",) and w not in silent])
    when = "".join(f" of {w.what}" for w in struck)
    when = f" in the blow{when}" if in_blow else ""
    for group in quantities(names, kept):
        yield [f"{'when is' if asks_when and not in_blow else 'is'} {text} conserved{when}" for text in group]
