"""Degrees of freedom: counted connection by connection, then what the count does not see, each with its reason."""

from __future__ import annotations

from freebody.errors import CannotAnswer
from freebody.language.expression import Expr, ProductOf, Sum, Symbol, negate, number
from freebody.language.sentences import Argument, Message, Sentence
from freebody.model.states import state_name
from freebody.narrative.context import Context, Method, refuse
from freebody.narrative.lines.glossary import World
from freebody.narrative.lines.naming import asked_as, asked_entry
from freebody.narrative.lines.script import DerivationStage, FormulaTable, Listing, Script, ready
from freebody.narrative.opening import coordinate_words, times
from freebody.numeric.mobility.kinds import Dependence
from freebody.questions.reading import Question
from freebody.study.answering.answer import Answer
from freebody.study.mobility.found import Mobility
from freebody.study.mobility.gruebler import Gruebler
from freebody.study.mobility.mobility import mobility
from freebody.study.setup import rank_freedoms
from freebody.system.system import System

MOST_ROWS = 6  # of a dependent set, that are listed one by one


def derive(context: Context, question: Question, answer: Answer, method: Method) -> list[DerivationStage]:
    """The count, the dependent constraints, the number. Raises CannotAnswer where the solver has no number."""
    refuse(method, (), Message("a count of freedoms"))
    if answer.value is None:
        raise CannotAnswer(answer.reason or Message("the solver found no number of freedoms"))
    found = mobility(context.system)
    n = int(answer.value) if not isinstance(answer.value, tuple) else 0
    script = context.script()
    with script.stage("mobility.counting", "mobility.counting_hint"):
        counted = _count(script, found.gruebler)
        _held_back(script, context.system, found.gruebler)
    with script.stage("mobility.checking", "mobility.checking_hint"):
        missing = _dependences(script, found, n)
    with script.stage("stage.value"):
        symbol = asked_as(context, question, _rank)
        script.add(asked_entry(symbol, question))
        _number(script, symbol, found, n, missing, counted)
        _what_moves(context, script, found)
    return script.stages


def _rank(world: World) -> float:
    """Coordinates minus the rank of the constraint Jacobian there."""
    return float(rank_freedoms(world.snapshot))


# -- what counts and what does not ------------------------------------------------------------
def _count(script: Script, count: Gruebler) -> int:
    """n L - K with the connections of a kind together, and its line."""
    script.say("mobility.kinds")
    alike: dict[tuple[str, int], list[str]] = {}
    for c in count.connections:
        alike.setdefault((c.kind, c.n), []).append(c.connection)
    header = tuple(Sentence(f"mobility.table_{name}") for name in ("kind", "connections", "each", "together"))
    kinds = {kind: Sentence("sheet.kind_of", {"kind": f"@kind.{kind}"}) for kind, _n in alike}
    rows = tuple(
        (kinds[kind], ", ".join(names), number(n), number(n * len(names))) for (kind, n), names in alike.items()
    )
    if rows:
        script.add(FormulaTable(header, rows))
    terms: list[Expr] = []
    if count.bodies or not count.particles:
        terms.append(times(count.n, len(count.bodies)))
    if count.particles:
        terms.append(times(count.n_point, len(count.particles)))
    for (_kind, n), names in alike.items():
        terms.append(ProductOf((number(-len(names)), number(n))) if len(names) > 1 else negate(number(n)))
    counted = terms[0] if len(terms) == 1 else Sum(tuple(terms))
    return script.line(counted, number(count.count), why="mobility.count", when="never")


def _held_back(script: Script, system: System, count: Gruebler) -> None:
    """Loads, drivers, constraints on velocities: how they count."""
    if count.loads:
        kinds = tuple(dict.fromkeys(system.loads[name].kind for name in count.loads))
        args: dict[str, Argument] = {"loads": count.loads}
        script.say("mobility.springs" if "spring" in kinds else "mobility.loads", **args)
    if count.drivers:
        script.say("mobility.drivers", names=count.drivers)
    rolling = tuple(c.connection for c in count.connections if c.is_nonholonomic)
    if rolling:
        script.say("mobility.velocities", names=rolling)


# -- where count and rank differ --------------------------------------------------------------
def _dependences(script: Script, found: Mobility, n: int) -> int:
    """Why the rank is smaller than the number of constraints; how many of these are superfluous."""
    count = found.gruebler
    if n == count.count and not found.dependences:
        script.say("mobility.independent", n=count.n_constraints)
        return 0
    missing = n - count.count
    script.say("mobility.differs", count=count.count, n=n, missing=missing, rank=found.rank.rank)
    circuits = found.dependences or tuple(Dependence(rows, (), "generic", "") for rows in found.rank.circuits)
    told: list[Sentence] = []
    for d in circuits:
        key = f"mobility.{d.kind.replace(' ', '_')}"
        connections = tuple(dict.fromkeys(row.split(".")[0] for row in d.rows))
        few = Sentence("mobility.rows", {"rows": d.rows})
        many = Sentence("mobility.of", {"connections": connections, "n": len(d.rows)})
        args: dict[str, Argument] = {"of": few if len(d.rows) <= MOST_ROWS else many, "reason": ready(d.why)}
        told.append(Sentence(key, args))
    if told:
        script.say("mobility.sets")
        script.add(Listing(tuple(told)))
    if any(d.is_shaky for d in circuits):
        script.say("mobility.shaky", n=n)
    return missing


def _number(script: Script, symbol: Expr, found: Mobility, n: int, missing: int, counted: int) -> None:
    count = found.gruebler.count
    if missing:
        added = Sum((number(count), number(missing)))
        many = "mobility.given_back" if missing > 0 else "mobility.taken_more"
        script.say("mobility.given_back_one" if missing == 1 else many, n=abs(missing))
        script.line(symbol, added, number(n), why="mobility.put_together", args={"line": counted}, uses=(counted,))
        return
    script.line(symbol, number(n), why="mobility.same", args={"line": counted}, uses=(counted,))


def _coordinate(context: Context, name: str) -> Argument:
    """A coordinate as it is read: by its symbol, by what a joint offers, or as it is called."""
    if name in context.introduced:
        return Symbol(name)
    words, _unit = coordinate_words(context, name)
    return name if words.key == "symbol.coordinate" else words


def _chosen(context: Context, found: Mobility) -> tuple[str, ...]:
    """Independent coordinates: in the plane those of the formulas, which the opening names, where there are as many."""
    if context.system.space:
        return found.independent_coordinates
    try:
        own = tuple(c.name for c in context.setup.model.coordinates if not state_name(c.name))
    except CannotAnswer:
        own = ()
    return own if len(own) == len(found.independent_coordinates) else found.independent_coordinates


def _what_moves(context: Context, script: Script, found: Mobility) -> None:
    if found.independent_coordinates:
        names = tuple(_coordinate(context, name) for name in _chosen(context, found))
        script.say("mobility.coordinates", names=names)
    for body, what in found.idle.items():
        script.say("mobility.idle", body=body, what=ready(what))
    if found.n_idle:
        script.say("mobility.useful", n=found.useful_freedom)
    if found.reachable is not None and found.reachable > found.finite_freedom:
        script.say("mobility.reachable", n=found.finite_freedom, reachable=found.reachable)
    if found.indeterminate:
        connections = tuple(dict.fromkeys(row.split(".")[0] for row in found.indeterminate))
        script.say("mobility.not_unique", connections=connections)
