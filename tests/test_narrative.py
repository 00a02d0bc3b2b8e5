"""Derivations are re-read: every line holds, names only what was introduced, and follows from lines before it."""

from __future__ import annotations

import math
from dataclasses import replace
from pathlib import Path

import pytest

import freebody as fb
from examples_told import explained
from freebody import System
from freebody.errors import InputError, RoutesDisagree
from freebody.language.expression import Call, Expr, Symbol, number
from freebody.language.parser import parse
from freebody.language.sentences import Sentence
from freebody.narrative.context import Context
from freebody.narrative.derivation import Derivation
from freebody.narrative.explain import Explanation, explain
from freebody.narrative.lines.script import DerivationStage, Legend, Listing, NumberedFormula, Script, names_in
from freebody.narrative.telling.catalogue import Catalogue
from goldens import assert_golden, digest

EXAMPLES = Path(__file__).parent.parent / "examples"


def load(name: str) -> System:
    return System.load(EXAMPLES / f"{name}.yaml")


def lines_of(stages: tuple[DerivationStage, ...]) -> list[NumberedFormula]:
    return [item for stage in stages for item in stage.items if isinstance(item, NumberedFormula)]


def sentences_of(stages: tuple[DerivationStage, ...]) -> list[Sentence]:
    return [item for stage in stages for item in stage.items if isinstance(item, Sentence)]


def legend_of(stages: tuple[DerivationStage, ...]) -> set[str]:
    entries = [e for stage in stages for item in stage.items if isinstance(item, Legend) for e in item.entries]
    return set().union(*(names_in(symbol) for symbol, _what, _unit in entries)) if entries else set()


def reread(explanation: Explanation) -> None:
    """Raises AssertionError at the first line that names what was not introduced or follows from a later one."""
    known = legend_of(explanation.opening) | {"t"}
    earlier = {line.number for line in lines_of(explanation.opening)}
    for derivation in explanation.derivations:
        for stages in (derivation.stages, derivation.compared):
            for stage in stages:
                for item in stage.items:
                    if isinstance(item, Legend):
                        known |= set().union(*(names_in(symbol) for symbol, _what, _unit in item.entries))
                    if (
                        isinstance(item, Listing) and stage.title.key == "stage.touching"
                    ):  # N >= 0, a contact cannot pull
                        told = (arg for entry in item.items for arg in entry.args.values() if isinstance(arg, Expr))
                        known |= set().union(*map(names_in, told))
                    if isinstance(item, NumberedFormula):
                        used = set().union(*(names_in(side) for side in item.sides))
                        defined = names_in(item.sides[0]) if stage.title.key == "stage.result" else set()
                        assert used - defined <= known, (
                            f"({item.number}) uses {used - known} before they are introduced"
                        )
                        assert set(item.uses) <= earlier, f"({item.number}) follows from {set(item.uses) - earlier}"
                        earlier.add(item.number)


def before_the_result(derivation: Derivation) -> tuple[DerivationStage, ...]:
    """The stages that lead to the result, which is not written again where only conditions and checks follow it."""
    keys = [stage.title.key for stage in derivation.stages]
    end = keys.index("stage.result") if "stage.result" in keys else len(keys)
    behind = ("stage.conditions", "stage.checks", "stage.options")
    n = next((k + 1 for k in reversed(range(end)) if keys[k] not in behind), 0)
    return derivation.stages[:n]


def the(name: str, question: str, **options: str) -> tuple[Explanation, Derivation]:
    found = explain(load(name), question, **options)
    (derivation,) = found.derivations
    assert not derivation.reason
    return found, derivation


def principles(derivation: Derivation) -> list[tuple[str, tuple[str, ...], str]]:
    """kind, bodies, and the key of the point or direction of each principle."""
    found: list[tuple[str, tuple[str, ...], str]] = []
    for s in sentences_of(derivation.stages):
        if s.key in ("principle.linear", "principle.angular"):
            where = s.args.get("point", s.args.get("direction"))
            assert isinstance(where, Sentence)
            bodies = s.args["bodies"]
            assert isinstance(bodies, tuple)
            found.append((s.key.removeprefix("principle."), tuple(map(str, bodies)), where.key))
    return found


example = pytest.mark.parametrize("name", sorted(path.stem for path in EXAMPLES.glob("*.yaml")))


@example
def test_the_derivation_of_an_example_is_the_golden_one(name: str) -> None:
    found = explained(name)
    assert_golden("explain", name, {"text": found.to_text().splitlines(), "page": digest(found.to_html())["text"]})


@example
def test_every_example_is_derived_and_its_derivation_reads_well(name: str) -> None:
    """Each line holds (else it would not be there), names what was introduced, follows from earlier ones; the last one
    is the answer."""
    found = explained(name)
    assert [d.question.id for d in found.derivations] == [q.id for q in found.system.questions]
    reread(found)
    for derivation in found.derivations:
        assert not derivation.reason, f"{derivation.question.text}: {derivation.reason}"
        expected = derivation.answer.expression
        if expected is not None:
            lines = lines_of(before_the_result(derivation))
            if not lines:  # an earlier derivation has found it
                assert any(s.key == "result.found" for s in sentences_of(derivation.stages))
                continue
            last = lines[-1]
            sides = [s for side in last.sides for s in (side if isinstance(side, tuple) else (side,))]
            ends = expected if isinstance(expected, tuple) else (expected,)
            assert set(ends) <= set(sides), derivation.question.text
    for language in ("en", "de"):
        told = replace(found, language=language).to_text()
        assert "{" not in told


def test_a_rolling_disk_takes_moments_about_its_contact_point() -> None:
    _found, derivation = the("disk_rolling_down_incline", "acceleration")
    assert principles(derivation) == [("angular", ("disk",), "point.only_contact")]


def test_an_atwood_machine_takes_two_momenta_and_one_moment() -> None:
    _found, derivation = the("atwood_machine", "acceleration")
    assert [(kind, bodies) for kind, bodies, _where in principles(derivation)] == [
        ("linear", ("left",)),
        ("linear", ("right",)),
        ("angular", ("pulley",)),
    ]


def test_of_the_constraints_those_are_cited_that_lead_to_a_rate() -> None:
    """The drum gives w' from x1' alone; x2' needs both parts of the string, whichever rate is told first."""
    for question in ("total energy", "energy"):
        found = explained("atwood_machine") if question == "energy" else the("atwood_machine", question)[0]
        lines = [line for d in found.derivations for line in lines_of(d.stages)]
        cited = {line.sides[0]: len(line.uses) for line in lines if line.why and line.why.key == "kinematics.follows"}
        assert cited == {Call("rate", Symbol("w")): 1, Call("rate", Symbol("x2")): 2}


def test_no_root_stands_in_all_terms_of_an_equation_without_inertia() -> None:
    """The massless cross of a Cardan joint: cos(alpha) M_y = sin(alpha) cos(psi) M_z, whatever the axis is long."""
    _found, derivation = the("cardan_joint", "alpha_2")
    (line,) = (line for line in lines_of(derivation.stages) if line.sides[0] == number(0))
    assert "sqrt" not in str(line.sides[1])
    assert line.sides[1] in (
        parse("cos(alpha)*M_yoke_y - cos(psi)*sin(alpha)*M_yoke_z"),
        parse("cos(psi)*sin(alpha)*M_yoke_z - cos(alpha)*M_yoke_y"),
    )


def test_a_symbol_is_explained_before_a_sentence_names_it() -> None:
    known: set[str] = set()
    for derivation in explained("cardan_joint").derivations:
        for stage in derivation.stages:
            for item in stage.items:
                if isinstance(item, Legend):
                    known |= set().union(*(names_in(symbol) for symbol, _what, _unit in item.entries))
                if isinstance(item, Sentence) and item.key.startswith("space.turns_about"):
                    assert names_in(item.args["name"]) <= known | {"psi"}  # type: ignore[arg-type]
    assert "phi_support" in known or "support_angle" in known


def test_a_name_that_begins_a_sentence_keeps_its_spelling() -> None:
    axes = Sentence("space.axes_body", {"body": "drive"})
    for language, begin in (("en", "drive turns about"), ("de", "drive dreht sich")):
        said = Catalogue(language).plain(Sentence("space.one_axis", {"body": "drive", "axes": axes}))
        assert said.startswith(begin)
        assert said.rstrip(":").endswith("drive")


def test_a_planetary_gear_takes_one_planet_about_its_contact_with_the_ring_and_the_sun() -> None:
    _found, derivation = the("planetary_gear", "acceleration")
    assert sorted(principles(derivation)) == [
        ("angular", ("P1",), "point.contact"),
        ("angular", ("sun",), "point.named"),
    ]
    said = next(s for s in sentences_of(derivation.stages) if s.key == "symmetry.said")
    assert said.args["bodies"] == ("P1", "P2", "P3")


def test_a_cart_and_its_pendulum_are_taken_together_where_the_pin_need_not_be_known() -> None:
    _found, derivation = the("cart_and_pendulum", "cart")
    assert ("linear", ("cart", "rod"), "direction.measure") in principles(derivation)


@pytest.mark.parametrize(
    ("name", "question", "first", "second"),
    [
        ("atwood_machine", "acceleration", "newton", "lagrange"),
        ("atwood_machine", "acceleration", "lagrange", "energy"),
        ("cart_and_pendulum", "cart", "newton", "lagrange"),
        ("double_pendulum", "acceleration", "newton", "lagrange"),
        ("disk_rolling_down_incline", "speed", "newton", "energy"),
        ("hoist", "acceleration", "newton", "energy"),
        ("body_on_driven_roller", "equation", "newton", "lagrange"),
    ],
)
def test_two_methods_end_in_the_same_result(name: str, question: str, first: str, second: str) -> None:
    found, derivation = the(name, question, method=first, compare=second)
    reread(found)
    assert derivation.compared
    assert lines_of(derivation.compared)[-1].sides[-1] == derivation.answer.expression


def test_a_method_that_does_not_know_a_reaction_says_so() -> None:
    found = explain(load("atwood_machine"), "tension", method="lagrange")
    assert "reactions" in found.derivations[0].reason
    assert not found.is_complete


def test_a_line_that_does_not_hold_is_not_taken() -> None:
    context = Context(load("atwood_machine"))
    script = Script(context.glossary)
    script.line(parse("rate(x2)"), parse("-rate(x1)"))
    with pytest.raises(RoutesDisagree, match="does not hold"):
        script.line(parse("rate(x2)"), parse("rate(x1)"))
    with pytest.raises(RoutesDisagree):
        script.line(parse("rate(rate(x1))"), parse("(m1 - m2)/(m1 + m2)*g"))
    assert script.next_number == 2


def test_a_symbol_without_a_meaning_is_not_taken() -> None:
    context = Context(load("atwood_machine"))
    with pytest.raises(InputError, match="has no value"):
        Script(context.glossary).line(Symbol("nobody"), number(0))


def test_unknown_methods_and_languages_are_told_with_a_suggestion() -> None:
    with pytest.raises(InputError, match=r"no method lagrnge.*lagrange"):
        explain(load("atwood_machine"), method="lagrnge")
    with pytest.raises(InputError, match=r"language xx\. There is: de, en"):
        explain(load("atwood_machine"), "acceleration", language="xx")
    with pytest.raises(InputError, match=r"id tenson\. Did you mean tension"):
        explain(load("atwood_machine"), "tenson")


def test_limiting_cases_of_the_atwood_machine_are_told() -> None:
    found = explain(load("atwood_machine"), "acceleration").to_text()
    assert "m₁ = m₂: 0" in found
    assert "m₁ → ∞: g" in found


def test_a_redundant_constraint_is_named_where_freedoms_are_counted() -> None:
    said = sentences_of(explain(load("planetary_gear"), "planet_rate").opening)
    assert any(s.key == "freedom.redundant" for s in said)


def test_a_moving_point_with_a_term_of_its_own_is_explained() -> None:
    _found, derivation = the("cart_and_pendulum", "rod")
    assert any(s.key == "moving_point.instant" for s in sentences_of(derivation.stages))
    _found, derivation = the("disk_rolling_down_incline", "acceleration")
    assert any(s.key == "moving_point.parallel" for s in sentences_of(derivation.stages))


def test_freedoms_are_confirmed_by_the_rank_and_not_by_the_formulas_alone(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("freebody.narrative.opening.rank_freedom", lambda _setup: 2)
    with pytest.raises(RoutesDisagree, match="rank leaves 2"):
        explain(load("atwood_machine"), "acceleration")


def test_an_equilibrium_that_exists_for_some_parameters_only_is_derived() -> None:
    """cos(theta) = (L + sqrt(L^2 + 128 R^2))/(16 R) for a rod over the rim of a bowl: no angle where L > 4 R."""
    text = """
parameters: {m: 2 kg, L: 1.2 m, R: 0.5 m, g: 9.81 m/s^2}
bodies: {rod: {rod: {mass: m, length: L}, near: {at: {start: [-0.4, -0.3]}}}}
ground: {points: {O: [0, 0], rim: [R, 0]}}
connections:
  bowl: {link: {first: ground.O, second: rod.start, length: R}}
  edge: {slot: {pin: ground.rim, along: rod.x, on: rod}}
loads: {w: {gravity: g}}
measures: {th: angle of rod}
start: {th: 20 deg}
questions: [equilibrium of th]
"""
    (derivation,) = fb.System.from_text(text).explain().derivations
    assert not derivation.reason
    assert derivation.answer.value == pytest.approx(math.acos((1.2 + math.sqrt(1.44 + 32)) / 8))


def test_an_equilibrium_beside_what_is_driven_from_rest_is_derived() -> None:
    """In a car that starts with a0 a pendulum hangs at tan(th) = -a0/g and swings with w^2 = sqrt(g^2 + a0^2)/L."""
    text = """
parameters: {m: 2 kg, L: 1.2 m, a0: 3 m/s^2, g: 9.81 m/s^2}
bodies: {car: {particle: {mass: 10 kg}}, bob: {particle: {mass: m}}}
connections:
  track: {slider: {body: car, along: right}}
  motor: {driver: {measure: x of car, follows: a0*t^2/2}}
  rope: {link: [car, bob, L]}
loads: {w: {gravity: g}}
measures: {th: angle of line from car to bob from down}
start: {th: 0}
questions: [equilibrium of th, natural frequency]
"""
    place, swing = fb.System.from_text(text).explain().derivations
    assert not place.reason
    assert not swing.reason
    assert place.answer.value == pytest.approx(-math.atan(3 / 9.81))
    assert swing.answer.value == pytest.approx(math.sqrt(math.hypot(3, 9.81) / 1.2))


def test_velocity_constraints_that_bind_less_at_the_start_are_told() -> None:
    # rate(cos(angle)) is held; with the angle at zero that holds nothing to first order
    system = fb.System.from_text("""
bodies: {p: {rod: {mass: 1 kg, length: 1 m}}}
measures: {u: alignment of right and p.x, x: x of p}
connections: {hold: {velocity_constraint: {expression: rate(u)}}}
questions: [{find: acceleration of x}]
""")
    with pytest.raises(fb.CannotAnswer, match="singular pose"):
        system.explain()


def test_what_is_supposed_of_a_sticking_contact_is_said_and_its_limit_is_solved() -> None:
    """Rolling on takes F = 2/7 m g sin(theta), and at most mu m g cos(theta) is there: mu >= 2/7 tan(theta)."""
    text = " ".join(explained("sphere_launched_down_incline").to_text().split())
    supposed = text.index("Suppose that contact does not slip.")
    solved = text.index("2⋅tan(θ) μ ≥ ──────── 7")
    assert supposed < text.index("Rolling without slip, hence") < solved


def test_gears_roll_on_each_other_by_their_radii_alone() -> None:
    """m z_1/2 omega_1 + m z_2/2 omega_2 = 0 has the factor m/2 in both terms."""
    _found, derivation = the("compound_gear_train", "ratio")
    lines = [line for line in lines_of(derivation.stages) if line.why and line.why.key == "constraint.tooth_force"]
    assert [line.sides for line in lines] == [
        (parse("z_1*omega_input + z_2*rate(theta_shaft)"), number(0)),
        (parse("z_3*rate(theta_shaft) + z_4*omega_output"), number(0)),
    ]


def test_how_a_planet_moves_is_told_before_its_constraints_are_differentiated() -> None:
    """Two meshes bind three unknowns: the turning of sun and planet, and how the centre of the planet moves."""
    _found, derivation = the("planetary_gear", "acceleration")
    lines = lines_of(derivation.stages)
    (place,) = [line for line in lines if line.why and line.why.key == "kinematics.seen"]
    assert place.sides[1] == parse("-rate(phi_1)*(r_S + r_P)")
    assert all(place.number in line.uses for line in lines if line.why and line.why.key == "kinematics.differentiated")


def test_a_planet_that_another_speaks_for_is_named_where_it_is_asked_about() -> None:
    _found, derivation = the("planetary_gear", "place_2")
    assert Sentence("symmetry.alike", {"first": "P1", "other": "P2"}) in sentences_of(derivation.stages)


def test_the_force_of_an_axle_is_found_along_its_two_components() -> None:
    """Not along a string, in which both components stand."""
    found = explain(load("incline_with_pulley"), "axle")
    (derivation,) = found.derivations
    directions = [s.args["direction"] for s in sentences_of(derivation.stages) if s.key == "principle.linear"]
    assert {"direction.right", "direction.up"} <= {d.key for d in directions if isinstance(d, Sentence)}


def test_energy_lost_in_a_blow_is_what_was_before_less_what_is_after() -> None:
    found, derivation = the("ballistic_pendulum", "lost")
    (line,) = lines_of(derivation.stages)
    assert line.sides[1] == parse("m*v^2/2 - L^2*rate(theta)^2*(m + M)/2")
    assert line.uses == (lines_of(found.opening)[-1].number,)


def test_a_count_is_not_said_again_as_a_value() -> None:
    _found, derivation = the("multi_bar_platform", "degrees of freedom")
    assert not [s for s in sentences_of(derivation.stages) if s.key == "result.value"]
