"""An answer is of the kind that words ask for, and no word that tells one thing from another is dropped: all examples,
by words for quantities and by words that change what is meant."""

from __future__ import annotations

from functools import cache
from pathlib import Path

import pytest

import freebody as fb
from freebody.connections.pin import Pin
from freebody.connections.revolute import Revolute
from freebody.errors import ModelError
from freebody.language.units import DIMENSIONLESS, ENERGY, FORCE, LENGTH, MASS, POWER, TIME
from freebody.measures.geometry import GROUND
from freebody.system.system import System
from test_spoken import meaning
from thinned import thinned

EXAMPLES = sorted(path.stem for path in (Path(__file__).parents[1] / "examples").glob("*.yaml"))
FEW = {"ball_in_bowl", "crane_with_feedforward", "farthest_throw", "slider_crank"}
V, OMEGA, TORQUE = LENGTH / TIME, DIMENSIONLESS / TIME, FORCE * LENGTH

# what is typed of a body, and what its value can be measured in
OF_BODIES = {
    "velocity of the {}": {V},
    "how fast is the {} moving": {V, OMEGA},
    "Geschwindigkeit von {}": {V},
    "at what rate does the {} rotate": {OMEGA},
    "rotational speed of the {}": {OMEGA},
    "Drehzahl von {}": {OMEGA},
    "acceleration of the {}": {V / TIME},
    "angular acceleration of {}": {OMEGA / TIME},
    "Winkelbeschleunigung von {}": {OMEGA / TIME},
    "how far does the {} travel": {LENGTH, DIMENSIONLESS},
    "how high does the {} rise": {LENGTH},
    "how deep does the {} fall": {LENGTH},
    "zurückgelegter Weg von {}": {LENGTH},
    "through what angle does the {} turn": {DIMENSIONLESS},
    "Drehwinkel von {}": {DIMENSIONLESS},
    "how long does the {} move": {TIME},
    "Wann hält {} an?": {TIME},
    "how many turns does the {} make until it stops": {DIMENSIONLESS},
    "kinetic energy of the {}": {ENERGY},
    "Impuls von {}": {FORCE * TIME},
    "Drehimpuls von {}": {FORCE * TIME * LENGTH},
    "mass of the {}": {MASS},
}
OF_ALL = {
    "tension in the rope": {FORCE},
    "Normalkraft": {FORCE},
    "friction force": {FORCE},
    "required torque": {TORQUE},
    "power": {POWER},
    "Energieverlust": {ENERGY},
    "natural frequency": {OMEGA},
    "Schwingungsdauer": {TIME},
    "damping ratio": {DIMENSIONLESS},
    "Übersetzung": {DIMENSIONLESS},
    "braking distance": {LENGTH},
    "flight time": {TIME},
}
# words that say of which thing, or how much of it, is asked
TELLING = ("other", "upper", "lower", "left", "second", "last", "front", "inner", "opposite", "additional", "average")
TELLING_IN_GERMAN = ("andere", "obere", "unteren", "zweite", "mittlere", "äußeren", "halbe", "doppelte", "übrigen")
IN_ENGLISH = {"obere": "upper", "unteren": "lower", "zweite": "second", "mittlere": "middle", "äußeren": "outer"}


@cache
def example(name: str) -> System:
    return fb.System.load(Path(__file__).parents[1] / "examples" / f"{name}.yaml")


def moving(system: System) -> list[str]:
    return [body.name for body in system.moving]


def turns_about_its_centre(system: System, body: str) -> bool:
    """On an axle of the ground in its mass centre: its acceleration is an angular one."""
    axles = [c for c in system.connections.values() if isinstance(c, (Pin, Revolute))]
    joined = [[system.names.point(text) for text in (axle.first, axle.second)] for axle in axles]
    at = system.bodies[body].points["mass_center"]
    ends = [(own, other) for a, b in joined for own, other in ((a, b), (b, a))]
    return any(own.body == body and own.offset == at and other.body == GROUND for own, other in ends)


def understood(system: System, said: str) -> list[str] | None:
    try:
        return [*map(meaning, system.asked(said))]
    except ModelError:
        return None


@pytest.mark.parametrize("name", thinned(EXAMPLES, lambda name: name in FEW))
def test_an_answer_is_measured_in_what_the_words_ask_for(name: str) -> None:
    system = example(name)
    angles = {own for own, measure in system.measures.items() if measure.dimension == DIMENSIONLESS}
    is_all_angles = bool(angles) and len(angles) == len(system.measures)
    asked = [(said.format(body), of) for body in moving(system)[:2] for said, of in OF_BODIES.items()]
    on_axles = {f"acceleration of the {body}" for body in moving(system) if turns_about_its_centre(system, body)}
    for said, of in (*asked, *OF_ALL.items()):
        dimensions = {OMEGA / TIME} if said in on_axles else of
        try:
            found = system.asked(said)
        except ModelError:
            continue
        for question in found:
            by_angle = {of / LENGTH for of in dimensions} if is_all_angles else set()
            is_meant = question.quantity.dimension in dimensions | by_angle
            assert is_meant, (said, question.understood, str(question.quantity.dimension))


@pytest.mark.parametrize("name", thinned(EXAMPLES, lambda name: name in FEW))
def test_a_word_that_tells_things_apart_is_never_dropped(name: str) -> None:
    system = example(name)
    for body in moving(system)[:1]:
        for pattern, words in (("speed of the {} {}", TELLING), ("Geschwindigkeit der {} {}", TELLING_IN_GERMAN)):
            plain = understood(system, " ".join(pattern.format("", body).split()))
            for word in words if plain is not None else ():
                if IN_ENGLISH.get(word, word) not in body.lower():  # the upper `upper` is what it says
                    assert understood(system, pattern.format(word, body)) != plain, pattern.format(word, body)
