"""The bounds of what swings with several frequencies: each wave stays within its amplitude."""

from __future__ import annotations

from freebody.errors import CannotAnswer
from freebody.language.expression import Call, Symbol
from freebody.language.sentences import Argument, Message, Sentence
from freebody.narrative.context import Context
from freebody.narrative.lines.glossary import Meaning, World
from freebody.narrative.lines.naming import fresh, named
from freebody.narrative.lines.script import DerivationStage, Script
from freebody.questions.steady import Extremes
from freebody.study.steady.superposed import Superposed, bounds_in_numbers
from freebody.symbolic.tidy import tidy


def tell_superposed(
    context: Context, script: Script, q: Extremes, found: Superposed, uses: tuple[int, ...]
) -> list[DerivationStage]:
    """The quantity in the time, and the bounds by the amplitudes of its waves. uses: the lines that give it."""
    if q.what not in ("least", "greatest"):
        raise CannotAnswer(Message("of a motion the greatest and the least value are derived one by one"))
    side = 1 if q.what == "greatest" else -1
    with script.stage("steady.turn", "steady.turn_hint"):
        symbol = Symbol(fresh(context, "y", "y_turn"))
        named(context, script, Meaning(symbol, Sentence("steady.followed_in_time"), q.of))
        shown = Call("abs", tidy(found.x)) if found.is_size else tidy(found.x)
        line = script.line(symbol, shown, why="steady.in_time", args={"lines": uses}, uses=uses)
    with script.stage("stage.value"):
        extreme = Symbol(fresh(context, f"{symbol.name}_{'max' if side > 0 else 'min'}", f"{symbol.name}_bound"))

        def read(world: World) -> float:
            return bounds_in_numbers(context.setup, world.draw, q.of, found)[side > 0]

        named(context, script, Meaning(extreme, Sentence("steady.bound"), read))
        args: dict[str, Argument] = {"line": line}
        script.say("steady.waves_reached" if found.is_reached(side) else "steady.waves_approached", line=line)
        script.line(extreme, tidy(found.bound(side)), why="steady.bounded", args=args, uses=(line,), when="never")
    return script.stages
