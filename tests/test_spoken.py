"""Questions as people type them are read as the question of the grammar that they mean, or not at all."""

from __future__ import annotations

import math
import re
from dataclasses import replace
from functools import cache
from pathlib import Path
from typing import cast

import pytest
from typer.testing import CliRunner

import freebody as fb
from freebody.cli import commands
from freebody.errors import InputError, ModelError
from freebody.present.report.formats.terminal import terminal_text
from freebody.questions.reading import Question
from freebody.questions.spoken import words
from freebody.questions.spoken.compounds import in_english_nouns
from freebody.questions.spoken.expressed import kinds_without_entry
from freebody.questions.spoken.inflecting import ENDS_CLAUSE, inflected
from freebody.questions.spoken.lexicon import languages, phrases_at, spelt_out, tables
from freebody.questions.spoken.words import in_own_letters, respelt
from freebody.system.system import System

EXAMPLES = Path(__file__).parents[1] / "examples"
TEXTBOOK = Path(__file__).parent / "spoken_models"  # as a textbook has them, with the names a user would give
TEMPLATES = Path(fb.__file__).parent / "templates"

STACKED = """
parameters: {F: 20 N}
ground: {lines: {floor: {along: right}}}
bodies:
  lower: {rectangle: {mass: 5 kg, width: 1 m, height: 0.2 m}, at: [0, 0.1 m]}
  upper: {rectangle: {mass: 2 kg, width: 0.4 m, height: 0.2 m}, at: [0, 0.3 m]}
connections:
  base: {contact: {between: [lower, floor], friction: 0.2}}
  top: {contact: {between: [upper, lower], friction: 0.4}}
loads: {weight: {gravity: 9.81 m/s^2}, pull: {force: {at: lower, along: right, magnitude: F}}}
"""

# by example: what is typed, and what it means
SPOKEN: dict[str, list[tuple[str, str]]] = {
    "atwood_machine": [
        ("What is the acceleration of the left block?", "acceleration of left"),
        ("what's the acceleration of left", "acceleration of left"),
        ("Find the acceleration of mass m1.", "acceleration of left"),
        ("acceleration of m1", "acceleration of left"),
        ("the left mass's acceleration", "acceleration of left"),
        ("left block acceleration", "acceleration of left"),
        ("How fast does the left mass accelerate?", "acceleration of left"),
        ("rope tension at left", "tension of rope at left"),
        ("What is the tension in the rope at the left mass?", "tension of rope at left"),
        ("tension in the string at m2", "tension of rope at right"),
        ("Calculate the tension in the cord on the side of the right block", "tension of rope at right"),
        ("the string tension between the pulley and the right mass", "tension of rope between pulley and right"),
        ("What is the angular acceleration of the pulley?", "angular acceleration of pulley"),
        ("How fast is the pulley spinning when x1 = 1 m?", "angular velocity of pulley when x1 = 1 m"),
        ("What is the reaction at the axle?", "reaction of axle"),
        ("force in the axle", "reaction of axle"),
        ("vertical reaction at the axle", "vertical reaction of axle"),
        ("bearing force at the axle", "reaction of axle"),
        ("How many degrees of freedom does the system have?", "degrees of freedom"),
        ("number of DOF", "degrees of freedom"),
        ("mobility of the mechanism", "degrees of freedom"),
        ("Is the total energy constant?", "is total energy conserved"),
        ("Does the mechanical energy stay constant?", "is total energy conserved"),
        ("kinetic energy of the system when x1 = 1 m", "kinetic energy when x1 = 1 m"),
        ("How long does it take until x1 = 2 m?", "time when x1 = 2 m"),
        ("time needed until x1 reaches 2 m", "time when x1 = 2 m"),
        ("How fast is the left block going once x1 reaches 1 m?", "speed of left when x1 = 1 m"),
        ("velocity of the left mass after 2 s", "velocity of left after 2 s"),
        ("What velocity does the left mass have at t = 2 s?", "velocity of left at t = 2 s"),
        ("Beschleunigung der linken Masse", "acceleration of left"),
        ("Wie groß ist die Beschleunigung von x1?", "acceleration of x1"),
        ("Wie groß ist die Seilkraft an der Masse m1?", "tension of rope at left"),
        ("Seilkraft im Seil am rechten Block", "tension of rope at right"),
        ("Winkelbeschleunigung der Rolle", "angular acceleration of pulley"),
        ("Wie viele Freiheitsgrade hat das System?", "degrees of freedom"),
        ("Bleibt die Gesamtenergie erhalten?", "is total energy conserved"),
        ("Geschwindigkeit von x1 nach 2 s", "velocity of x1 after 2 s"),
        ("Welche Geschwindigkeit hat die linke Masse, wenn x1 = 1 m?", "velocity of left when x1 = 1 m"),
        ("Wie lange dauert es, bis x1 = 2 m?", "time when x1 = 2 m"),
    ],
    "sphere_launched_down_incline": [
        ("When does the ball start rolling?", "time when ball begins to roll"),
        ("when does it begin to roll without slipping", "time when rolling begins"),
        ("After what time does the sphere roll?", "time when ball rolls"),
        ("How long does it take for the ball to start rolling?", "time when ball begins to roll"),
        ("time until rolling begins", "time when rolling begins"),
        ("How long does the ball slide?", "time when slip of ball ends"),
        ("velocity when pure rolling begins", "velocity of x when rolling begins"),
        ("With what speed does the sphere start to roll?", "speed of ball when ball begins to roll"),
        ("How far does the ball travel before it rolls without slipping?", "change of x until it rolls"),
        ("distance travelled by the ball until rolling begins", "distance travelled along x until rolling begins"),
        ("energy dissipated before pure rolling sets in", "energy lost until rolling begins"),
        ("How much energy is lost until the ball starts rolling?", "energy lost until ball begins to roll"),
        ("How much heat is produced until rolling begins?", "energy lost until rolling begins"),
        ("how many revolutions does the ball make until it starts rolling", "turns of ball until it begins to roll"),
        ("friction on the ball", "friction force of contact"),
        ("What is the normal force between the ball and the incline?", "normal force of contact"),
        ("normal reaction on the sphere", "normal force of contact"),
        ("the frictional force right after release", "friction force of contact at start"),
        ("initial acceleration of the sphere", "acceleration of ball at start"),
        ("acceleration of the ball along the incline", "acceleration of ball along incline"),
        ("acceleration down the incline", "acceleration of ball along incline"),
        (
            "angular speed of the sphere at the moment when rolling begins",
            "angular velocity of ball when rolling begins",
        ),
        ("speed of the ball after it has moved 0.5 m", "speed of ball when x = 0.5 m"),
        ("Wann beginnt die Kugel zu rollen?", "time when ball begins to roll"),
        ("Welche Geschwindigkeit hat die Kugel, wenn das Rollen beginnt?", "velocity of ball when rolling begins"),
        ("Reibkraft an der Kugel", "friction force of contact"),
        ("Wie weit rutscht die Kugel, bis sie rollt?", "change of x until it begins to roll"),
        ("Wie viele Umdrehungen macht die Kugel, bis sie rollt?", "turns of ball until it begins to roll"),
        ("Energieverlust bis das Rollen beginnt", "energy lost until rolling begins"),
    ],
    "slider_crank": [
        ("How fast is the piston moving?", "speed of piston"),
        ("speed of the piston", "speed of piston"),
        ("horizontal velocity of the piston", "velocity of piston along right"),
        ("x-component of acceleration of the piston", "acceleration of piston along right"),
        ("angular velocity of the connecting rod", "angular velocity of rod"),
        ("angular velocity of the rod", "angular velocity of rod"),
        ("rotational speed of the crank", "angular velocity of crank"),
        ("How fast is the crank rotating?", "angular velocity of crank"),
        ("reaction at the main bearing", "reaction of main"),
        ("force in the wristpin", "reaction of wristpin"),
        ("instantaneous center of rotation of the rod", "instant centre of rod"),
        ("velocity of the end of the crank", "velocity of crank.end"),
        ("velocity of point crank.end", "velocity of crank.end"),
        ("acceleration of the piston for theta = 90 deg", "acceleration of piston when theta = 90 deg"),
    ],
    "ladder_against_wall": [
        (
            "What is the smallest coefficient of friction so that the ladder does not slip?",
            "least mu so that it does not slip",
        ),
        ("minimum friction coefficient required for equilibrium", "least mu so that it stays at rest"),
        ("smallest mu for which the ladder stays at rest", "least mu so that it stays at rest"),
        ("maximum distance d such that the ladder does not slip", "largest d so that it does not slip"),
        ("largest d before the ladder slips", "largest d so that it does not slip"),
        ("minimum angle alpha so that nothing slips", "least alpha so that nothing slips"),
        ("Does the ladder stay at rest?", "does it hold"),
        ("normal force at the wall", "normal force of wall"),
        ("normal force from the floor", "normal force of floor"),
        ("friction at the floor", "friction force of floor"),
        ("Normalkraft an der Wand", "normal force of wall"),
        ("kleinste Haftreibungszahl, damit die Leiter nicht rutscht", "least mu so that it does not slip"),
    ],
    "disk_rolling_down_incline": [
        ("How long does it take until s = 2 m?", "time when s = 2 m"),
        ("acceleration of the disk's center", "acceleration of disk.center"),
        ("the disk's acceleration", "acceleration of disk"),
        ("What is the velocity of the disc after it has rolled a distance of 2 m?", "velocity of disk when s = 2 m"),
        ("friction force on the disk", "friction force of contact"),
        ("friction force between the disk and the incline", "friction force of contact"),
    ],
    "incline_with_pulley": [
        ("What is the tension in the rope at the block?", "tension of rope at block"),
        ("tension at the weight", "tension of rope at weight"),
        ("normal force on the block", "normal force of incline"),
        ("What force does the axle exert on the pulley?", "reaction of axle on pulley"),
        ("acceleration of the block up the incline", "acceleration of block along alpha"),
        ("acceleration of s", "acceleration of s"),
    ],
    "simple_pendulum": [
        ("tension in the rod when theta = 0", "tension of rod when theta = 0"),
        ("How fast is the bob when theta is 0?", "speed of bob when theta = 0"),
        ("period of small oscillations", "period of small oscillations"),
        ("What is the period for small oscillations?", "period of small oscillations"),
        ("natural frequency of the system", "natural frequency"),
        ("Schwingungsdauer kleiner Schwingungen", "period of small oscillations"),
    ],
    "mass_on_spring": [
        ("equilibrium position of y", "equilibrium of y"),
        ("What is the natural angular frequency?", "natural frequency"),
        ("force of the spring", "force in spring"),
        ("what is the spring force", "force in spring"),
        ("Eigenfrequenz des Systems", "natural frequency"),
        ("Ruhelage von y", "equilibrium of y"),
    ],
    "planetary_gear": [
        ("What is the angular acceleration of the sun?", "angular acceleration of sun"),
        ("tooth force of sun_P1", "tooth force of sun_P1"),
        ("tooth force in the gear mesh sun_P1", "tooth force of sun_P1"),
        ("tooth force between the sun and P1", "tooth force of sun_P1"),
        (
            "ratio of the angular velocity of P1 to the angular velocity of the sun",
            "ratio of angular velocity of P1 to angular velocity of sun",
        ),
        ("How many degrees of freedom are there?", "degrees of freedom"),
    ],
    "block_on_rough_incline": [
        ("When does the block stop?", "time when block stops"),
        ("How far does the block slide before it stops?", "change of x until it stops"),
        ("Where does the block stop?", "x when block stops"),
        ("energy lost to friction until the block comes to rest", "energy lost until block comes to rest"),
        ("initial friction force of the contact", "friction force of contact at start"),
        ("deceleration of the block", "-acceleration of x"),
    ],
    "cart_and_pendulum": [
        ("acceleration of the cart at the beginning", "acceleration of cart at start"),
        ("acceleration of the cart immediately after release", "acceleration of cart at start"),
        ("force in the hinge", "reaction of hinge"),
        ("momentum of the system along right", "linear momentum along right"),
        ("Is the horizontal momentum conserved?", "is linear momentum along right conserved"),
    ],
    "bouncing_ball": [
        ("When does the ball hit the floor?", "time when ball hits floor"),
        ("With what speed does the ball hit the floor?", "speed of ball when ball hits floor"),
        ("How long until the ball touches the floor?", "time when ball touches floor"),
        ("Mit welcher Geschwindigkeit trifft die Kugel auf den Boden?", "velocity of ball when ball hits floor"),
    ],
}
SPOKEN |= {
    "planetary_gear_by_teeth": [
        ("What torque must be applied to the ring gear to hold it fixed?", "moment of outer on ring"),
        ("torque to hold the ring", "moment of outer on ring"),
        ("Welches Moment hält das Hohlrad fest?", "moment of outer on ring"),
        ("Stützmoment am Hohlrad", "moment of outer on ring"),
        ("torque needed to hold the carrier", ""),
        ("omega_C/omega_S", "ratio of angular velocity of carrier to angular velocity of sun"),
        ("i sun carrier", "ratio of angular velocity of sun to angular velocity of carrier"),
    ],
    "planetary_gear_with_three_planets": [("torque to hold the ring", "")],  # a third of it is that of one planet
    "loop_the_loop": [
        ("v_top (m/s)", "velocity of car when theta = 180 deg"),
        ("v_oben", "velocity of car when theta = 180 deg"),
        ("T_max", "greatest tension of track"),
        ("inward acceleration of the car at theta = 90 deg", "normal acceleration of car when theta = 90 deg"),
        ("tangential velocity of the car at the top", "speed of car when theta = 180 deg"),
        ("radial velocity of the car", ""),
    ],
    "sliding_ladder": [
        ("N_wall(t=0)", "normal force of head at start"),
        ("at what height does the ladder leave the wall", "h when ladder leaves wall"),
        ("Find the angle phi at which the upper end of the ladder loses contact with the wall.", "phi when head opens"),
    ],
    "four_bar": [
        ("omega_2", ""),
        ("In welchen Stellungen der Kurbel befindet sich die Schwinge in ihren Totlagen?", "dead points of rocker"),
        ("greatest moment of the crank", ""),
    ],
    "two_masses_three_springs": [
        ("omega_1, omega_2", "first natural frequency; second natural frequency"),
        ("eigenfreqs", "natural frequencies"),
        ("beat period", "2*pi/(highest natural frequency - lowest natural frequency)"),
        ("Schwebungsfrequenz", "highest natural frequency - lowest natural frequency"),
        ("when do A and B collide?", ""),  # they are joined by a spring
    ],
    "damped_torsion_pendulum": [("zeta", "damping ratio")],
    "beam_with_overhang": [
        ("M_max of beam in kNm", "greatest bending moment of beam"),
        (
            "At which point of the beam does the bending moment attain its maximum?",
            "place of greatest bending moment of beam",
        ),
    ],
    "bead_on_turning_rod": [
        ("N(r) between bead and rod", "normal force of slot"),
        ("radial velocity of bead when r = 0.8 m", "velocity of r when r = 0.8 m"),
        ("radial acceleration of the bead", "acceleration of bead along rod.x"),
        ("transverse velocity of the bead", "velocity of bead along rod.y"),
    ],
    "planet_orbit": [
        ("Radialgeschwindigkeit des Planeten", "velocity of r"),
        ("radial acceleration of the planet", ""),  # less than the rate of that velocity
        (
            "For what initial speed would the orbit be circular?",
            "value of v_0 for which acceleration of r = 0 at start",
        ),
    ],
    "belt_drive": [
        ("speed of the belt", "r2*|angular velocity of drum|"),
        ("Riemengeschwindigkeit nach 2 s", "r2*|angular velocity of drum| after 2 s"),
    ],
    "hoist": [
        ("at which torque is the load accelerated at 2 m/s^2", "value of T for which acceleration of load = 2 m/s^2"),
        (
            "Bei welchem Moment wird die Last mit 2 m/s^2 nach oben beschleunigt?",
            "value of T for which acceleration of load along up = 2 m/s^2",
        ),
    ],
    "motorcycle_brakes": [
        ("for which mu does it brake with 6 m/s^2", "value of mu for which -acceleration of x = 6 m/s^2"),
        ("for which mu is the deceleration 0.6 g", "value of mu for which -acceleration of x = 0.6*g"),
        ("Bei welchem mu bremst das Motorrad mit 0,6 g?", "value of mu for which -acceleration of x = 0.6*g"),
    ],
    "quick_return": [
        ("sliding velocity in the slot", "velocity of crank.end relative to lever.mass_center along lever.x"),
        (
            "With what speed does the crank slide in the slot?",
            "velocity of crank.end relative to lever.mass_center along lever.x",
        ),
        ("omega_lever,max", "greatest angular velocity of lever"),
        ("zwischen welchen Winkeln schwingt der Hebel?", "extremes of psi"),
    ],
    "two_trains": [
        ("when do they crash", "time when x_A = x_B"),
        ("Wann begegnen sich A und B?", "time when x_A = x_B"),
        ("how fast is B when it meets A", "speed of B when x_A = x_B"),
        ("At what time and where do the two trains meet?", "time when x_A = x_B; x_B when x_A = x_B"),
    ],
    "suspension_bridge": [
        ("for which f is the greatest tension 30 MN", "value of f for which greatest tension of cable = 30 MN"),
        ("Horizontalzug des Tragkabels", "horizontal pull of cable"),
        ("Durchhang des Kabels", "sag of cable"),
    ],
    "wall_truss": [
        ("which bars are in compression?", "; ".join(f"tension of s{k}" for k in range(1, 7))),
        ("Bestimmen Sie alle Stabkräfte im Fachwerk.", "; ".join(f"tension of s{k}" for k in range(1, 7))),
    ],
    "servo_with_pid": [("ab welchem ki wird der regler instabil", "largest k_i so that the steady motion is stable")],
    "tilted_disk_on_shaft": [("reaction at bearing B in the rotating frame", "reaction of B on shaft in shaft")],
    "cam_with_flat_follower": [
        ("Antriebsmoment in Abhängigkeit vom Drehwinkel", "driving torque of motor"),
        ("rpm at which tappet jumps", "largest Omega so that cam stays on"),
    ],
}
SPOKEN["block_on_rough_incline"] += [
    ("wie schnell ist der Block, wenn er wieder unten ankommt?", "speed of block when x = 0"),
    ("W_friction up to standstill [J]", "energy lost until it stops"),
    ("F_N", "normal force of contact"),
]
SPOKEN["slider_crank"] += [("how far does the piston move per turn of the crank", "")]  # no way as long for each part
SPOKEN |= {
    "driven_slider_crank": [("acceleration of the piston at the lowest point", "")],
    "rack_and_pinion_drive": [
        (
            "how far does the rack move per turn of the pinion",
            "2*pi * ratio of velocity of x to angular velocity of pinion",
        )
    ],
}
SPOKEN["mass_on_spring"] += [
    ("beat period", ""),
    ("f_0 [Hz]", "natural frequency"),
    (
        "Wie groß ist die Geschwindigkeit der Masse beim Durchgang durch die statische Ruhelage?",
        "velocity of block when acceleration of y = 0",
    ),
]
MORE: dict[str, list[tuple[str, str]]] = {
    "crate_on_a_truck": [
        (
            "how fast is the truck after it has moved 1 m",
            "speed of truck when travel of truck along right has moved 1 m",
        ),
    ],
    "belt_drive": [
        (
            "how fast is the motor after it has turned once",
            "angular velocity of motor when angle of motor has moved 1 * 2*pi",
        ),
    ],
    "hoist": [
        ("how far does the load rise when the drum turns twice", "change of y until angle of drum has moved 2 * 2*pi"),
        (
            "Wie weit steigt die Last, wenn sich die Trommel einmal dreht?",
            "change of y until angle of drum has moved 1 * 2*pi",
        ),
    ],
    "driven_slider_crank": [
        ("acceleration of the piston at TDC", "acceleration of piston at the outer dead point"),
        ("Kolbenbeschleunigung im unteren Totpunkt", "acceleration of piston at the inner dead point"),
        ("max piston acceleration in g", "(greatest acceleration of piston)/(9.80665 m/s^2)"),
        ("Kolbenweg über dem Kurbelwinkel", ""),  # which is no stroke
    ],
    "beam_with_overhang": [
        ("For which load P does the beam lift off at A?", "value of P for which reaction of A along up = 0"),
        ("Bei welcher Kraft P hebt der Balken bei A ab?", "value of P for which reaction of A along up = 0"),
        ("shear force just left of B", "shear force of beam just before beam.B"),
        ("Querkraft rechts von B", "shear force of beam just behind beam.B"),
        ("Biegemoment kurz vor B", "bending moment of beam just before beam.B"),
    ],
    "screw_jack": [
        (
            "torque to raise the load and torque to lower the load",
            "largest T so that it stays at rest; least T so that it stays at rest",
        ),
    ],
    "ballistic_pendulum": [
        ("Wie hoch schwingt der Block?", "change of height of block until rate(theta) = 0"),
        ("common velocity immediately after the bullet hits", "speed of block at start"),
    ],
    "tower_crane": [
        ("torque needed at the winch", "driving torque of hoisting"),
        ("Welche Antriebskraft braucht die Laufkatze?", "driving force of travelling"),
    ],
    "spinning_balls_collide": [("closing speed", "-(velocity of distance from cue to target)")],
    "belt_with_slip_limit": [("T_1/T_2", "(tight tension of belt)/(slack tension of belt)")],
    "ladder_rough_wall": [("mu_min for equilibrium?", "least mu so that it stays at rest")],
    "suspension_bridge": [("horizontal component of cable tension", "horizontal pull of cable")],
    "wheel_that_locks": [("heat dissipated in the brake", "energy lost in brake until rate(x) = 0")],
    "yo_yo": [
        ("How much smaller is the tension than the weight?", "size of force of weight on yoyo - tension of string"),
        (
            "Um wie viel ist die Seilkraft kleiner als das Gewicht?",
            "size of force of weight on yoyo - tension of string",
        ),
        ("speed of the yoyo after one turn", "speed of yoyo when angle of yoyo has moved 1 * 2*pi"),
    ],
    "crate_onto_a_preloaded_buffer": [
        ("speed of the crate at impact with the buffer", "speed of crate when buffer is reached"),
    ],
    "chain_on_rough_table": [
        ("acceleration of the chain when half of it hangs over the edge", "acceleration of chain when x = L/2"),
    ],
}
MORE |= {
    "letter_scale": [("moment of inertia of the sector about its pivot", "moment of inertia of sector about axle")],
    "car_with_a_trailer": [("coupling force", "reaction of hitch")],  # and not the force that drives it
    "steepest_road": [("Normalkräfte an Vorder- und Hinterachse", "normal force of front; normal force of rear")],
    "bouncing_ball": [
        ("maximum height after the first bounce", "y when rate(y) = 0"),  # and not the height that it falls from
        ("Mit welcher Geschwindigkeit springt der Ball zurück?", "velocity of ball after the impact"),
        ("energy loss per bounce", "energy lost in the impact"),
    ],
    "atwood_machine": [
        (
            "Bestimme die Seilkräfte und die Beschleunigung der rechten Masse.",
            "tension of rope at left; tension of rope at right; acceleration of right",
        ),
    ],
    "falling_hinged_rod": [
        ("Geschwindigkeit des Stabendes in der Senkrechten", "velocity of rod.end when theta = 90 deg"),
    ],
    "capstan": [("What holding force is required?", "range of F that keeps it at rest")],
    "cart_and_pendulum": [("reaction left of the hinge", "")],
    "dominoes": [("does the first domino knock over the second", "")],
    "tumbling_cube": [("time until the cube hits the table", "time when cube hits")],
    "saturated_servo": [("settling time", "")],  # which is not when it first turns back
    "hydraulic_lift": [("Kraft F im Gleichgewicht", "range of F that keeps it at rest")],
    "rack_and_pinion_drive": [
        (
            "rack displacement per revolution of the pinion",
            "2*pi * ratio of velocity of x to angular velocity of pinion",
        ),
    ],
}
SPOKEN |= {name: [*SPOKEN.get(name, ()), *pairs] for name, pairs in MORE.items()}
SPOKEN["block_on_rough_incline"] += [("Verzögerung in g", "(-acceleration of x)/(g)")]
SPOKEN["loop_the_loop"] += [
    (
        "From what minimum height must the car start to complete the loop?",
        "least h so that tension of track >= 0 when theta = 180 deg",
    ),
    ("Geschwindigkeit nach einer Vierteldrehung", "velocity of car when theta = 0.25 * 2*pi"),
]
TYPED = [  # a longer list, many of which are to be refused
    cast("tuple[str, str, str]", tuple(line.split("\t")))
    for line in (Path(__file__).parent / "spoken.tsv").read_text("utf-8").splitlines()
    if not line.startswith("#")
]
CASES = [
    *(pytest.param(name, *pair, id=f"{name}-{pair[0]}", marks=()) for name, pairs in SPOKEN.items() for pair in pairs),
    *(  # every run has an eighth of the list
        pytest.param(name, said, meant, id=f"{name}-{said}", marks=pytest.mark.slow if k % 8 else ())
        for k, (name, said, meant) in enumerate(TYPED)
    ),
]


@cache
def example(name: str) -> System:
    return fb.System.load(path_of(name))


def path_of(name: str) -> Path:
    folders = (EXAMPLES, TEXTBOOK, TEMPLATES)
    return next(path for path in (folder / f"{name}.yaml" for folder in folders) if path.exists())


def meaning(question: Question) -> str:
    """What a question asks for, whatever its words."""
    event, transition = question.event, question.transition
    timed = None if event is None else replace(event, text="")
    changed = None if transition is None else replace(transition, text="")
    told = str((question.quantity, timed, question.at_start, changed))
    return re.sub(r"\btext='[^']*'", "", told)


@pytest.mark.parametrize(("name", "said", "meant"), CASES)
def test_a_question_in_ones_own_words_is_that_of_the_grammar_or_none(name: str, said: str, meant: str) -> None:
    system = example(name)
    if not meant:
        with pytest.raises(ModelError):
            system.asked(said)
        return
    found, expected = system.asked(said), system.asked(meant)
    assert [*map(meaning, found)] == [*map(meaning, expected)], [question.understood for question in found]


@pytest.mark.parametrize(
    ("said", "told"),
    [
        ("What is the angular velocity of the carrier?", "there is no body carrier"),
        ("tension of the ropee", "there is no connection ropee. Did you mean rope?"),
        ("friction in the axle", "axle has no friction force"),
        ("tension of the rope at the pulley", "rope has several values of tension at pulley; say which: at BODY"),
    ],
)
def test_what_the_model_lacks_is_said(said: str, told: str) -> None:
    with pytest.raises(ModelError, match=told):
        example("atwood_machine").question(said)


@pytest.mark.parametrize(
    ("name", "said", "meant"),
    [
        ("atwood_machine", "tension in the rope", ["tension of rope at left", "tension of rope at right"]),
        (
            "atwood_machine",
            "greatest tension in the rope",
            [f"greatest tension of rope at {x}" for x in ("left", "right")],
        ),
        ("compound_atwood", "accelerations of all three masses", [f"acceleration of {x}" for x in "ABC"]),
        (
            "belt_drive",
            "angular acceleration of both pulleys",
            [f"angular acceleration of {x}" for x in ("motor", "drum")],
        ),
        (
            "incline_with_pulley",
            "x and y component of the reaction at the axle",
            [f"{x} of reaction of axle" for x in ("x component", "y component")],
        ),
        (
            "slider_crank",
            "velocity and acceleration of the piston when theta = 90 deg",
            [f"{x} of piston when theta = 90 deg" for x in ("velocity", "acceleration")],
        ),
        (
            "block_on_rough_incline",
            "How long does it take until the block stops, and how far does it get in this time?",
            ["time when block stops", "change of x until block stops"],
        ),
        (
            "simple_pendulum",
            "(a) the period of small oscillations, (b) the tension in the rod at the lowest point",
            ["period of small oscillations", "tension of rod when theta = 0"],
        ),
        (
            "atwood_machine",
            "Ist die Seilkraft auf beiden Seiten der Rolle gleich groß?",
            ["tension of rope at left", "tension of rope at right"],
        ),
        (
            "bungee_jump",
            "Wie schnell ist der Springer, wenn das Seil straff wird, und wie groß ist seine Beschleunigung am "
            "tiefsten Punkt?",
            ["speed of jumper when cord goes taut", "acceleration of y when rate(y) = 0"],
        ),
        (
            "slider_crank",
            "Wie groß sind Geschwindigkeit und Beschleunigung des Kolbens bei theta = 90 Grad?",
            [f"{x} of piston when theta = 90 deg" for x in ("velocity", "acceleration")],
        ),
    ],
)
def test_several_questions_in_one_are_each_answered(name: str, said: str, meant: list[str]) -> None:
    system = example(name)
    found = system.asked(said)
    assert [*map(meaning, found)] == [meaning(system.question(one)) for one in meant], [q.text for q in found]
    with pytest.raises(InputError, match="asks for several things"):
        system.question(said)


def test_the_pin_of_a_crank_slides_in_its_slot_as_its_distance_from_the_hinge_grows() -> None:
    """s^2 = r^2 + d^2 + 2 r d sin(phi) from the hinge, d below the crank, so that at phi = 0 its rate is r d w/s."""
    system = fb.System.from_text(
        """
parameters: {r: 0.1 m, d: 0.3 m, L: 0.6 m, w: 5 rad/s}
ground: {points: {O: [0, 0], Q: [0, -d]}}
bodies:
  crank: {rod: {mass: 0, length: r}}
  lever: {rod: {mass: 2 kg, length: L}, near: {angle: 70 deg}}
connections:
  O: {pin: [ground.O, crank.start]}
  Q: {pin: [ground.Q, lever.start]}
  slot: {slot: {pin: crank.end, along: lever.x, on: lever}}
  motor: {driver: {measure: phi, follows: w*t}}
measures: {phi: {angle of crank}}
"""
    )
    [answer] = fb.solve(system, question="sliding velocity of the pin in the slot at the start").answers
    assert answer.value == pytest.approx(0.1 * 0.3 * 5 / math.hypot(0.1, 0.3))


def test_what_holds_a_ring_gear_bears_its_tooth_force_at_its_radius() -> None:
    [moment, force] = fb.solve(
        example("planetary_gear_by_teeth"), question="torque that holds the ring gear fixed; tooth force of outer"
    ).answers
    assert moment.value is not None
    assert abs(moment.value) == pytest.approx(abs(force.value or 0.0) * 2e-3 * 60 / 2)


def test_several_questions_in_one_have_ids_and_no_options(tmp_path: Path) -> None:
    text = re.sub(r"\nquestions:.*\Z", "\n", path_of("atwood_machine").read_text("utf-8"), flags=re.DOTALL)
    asked = f"{text}questions: [{{id: T, find: tension in the rope on both sides}}]\n"
    found = fb.solve(fb.System.from_text(asked)).answers
    assert [(a.id, a.question) for a in found] == [
        ("T_1", "tension of rope at left"),
        ("T_2", "tension of rope at right"),
    ]
    with pytest.raises(ModelError, match="options are of one quantity"):
        fb.System.from_text(asked.replace("sides}", "sides, options: {a: m1*g}}"))


def test_what_cannot_be_read_is_answered_with_questions_of_this_model() -> None:
    system = example("atwood_machine")
    with pytest.raises(ModelError) as error:
        system.question("tell me more about the tension")
    suggested = [line.strip() for line in str(error.value).splitlines()[1:]]
    assert 1 <= len(suggested) <= 5
    for question in suggested:
        assert system.question(question).understood == question
    assert any(question.startswith("tension of rope at ") for question in suggested)


@pytest.mark.parametrize(
    ("name", "said", "meant"),
    [
        (
            "valve_spring",
            "At what cam speed does the valve begin to lift off?",
            "value of Omega for which driving force of cam at t = pi/Omega = 0",
        ),
        (
            "valve_spring",
            "Bei welcher Drehzahl beginnt das Ventil abzuheben?",
            "value of Omega for which driving force of cam at t = pi/Omega = 0",
        ),
        (
            "loop_the_loop",
            "Up to what height may the car start if the track only bears S at the bottom?",
            "largest h so that tension of track <= S at start",
        ),
        ("conical_pendulum", "Wie schnell läuft das Pendel um?", "rate of psi in steady motion at start"),
        (
            "throw_at_target",
            "At what launch angle does the ball strike the target?",
            "value of theta for which y = h when x = s",
        ),
    ],
)
def test_a_question_of_the_file_that_is_about_the_same_is_among_those_suggested(
    name: str, said: str, meant: str
) -> None:
    with pytest.raises(ModelError) as error:
        example(name).question(said)
    suggested = [line.strip() for line in str(error.value).splitlines()[1:]]
    assert len(suggested) <= 5
    assert meant in suggested


@pytest.mark.parametrize(
    ("written", "language", "form"),
    [
        ("~ab|sinken", "de", "abgesunken"),
        ("~ab|sinken", "de", "sank _ ab$"),  # the mark: no noun that it would lead follows the prefix
        ("~verlassen", "de", "verliess"),
        ("~hinauf|steigen", "de", "hinaufzusteigen"),
        ("~slide off", "en", "slid off"),
        ("~fall", "en", "fallen"),
        ("~leave", "en", "leaving"),
    ],
)
def test_strong_verbs_have_all_their_forms(written: str, language: str, form: str) -> None:
    assert form in {said for phrase in inflected(written, language) for said in spelt_out(phrase)}


@pytest.mark.parametrize(
    ("said", "strange"),
    [("What wibbles the left mass?", "wibbles"), ("Wie groß ist die Verkrümmung der linken Masse?", "Verkrümmung")],
)
def test_a_word_that_nothing_is_known_of_is_told(said: str, strange: str) -> None:
    with pytest.raises(ModelError, match=rf"not understood: {strange}\)"):
        example("atwood_machine").question(said)


def test_no_word_of_a_rule_is_told_as_one_that_was_typed() -> None:
    with pytest.raises(ModelError) as error:
        example("atwood_machine").question("how many oscillations until the amplitude is 10 %")
    assert "decayswings" not in str(error.value)


def test_a_force_on_a_body_on_which_a_connection_does_not_act_is_refused() -> None:
    system = fb.System.from_text(
        """
bodies:
  a: {particle: {mass: 1 kg}, velocity: [2 m/s, 0]}
  b: {particle: {mass: 1 kg}}
  c: {particle: {mass: 1 kg}, at: [1 m, 0]}
connections: {hit: {pin: [a, b], closes: at start}}
"""
    )
    assert system.question("impulse of hit on b").understood == "impulse of hit on b"
    for asked in ("impulse of hit on c", "reaction of hit on c"):
        with pytest.raises(ModelError, match="hit does not act on c; it acts on a, b"):
            system.question(asked)


@pytest.mark.parametrize(
    "said",
    [
        "angular velocity of body when the wheel turns at 100 rad/s relative to the body",
        "angular velocity of body when wheel spins at 100 rad/s relative to it",
    ],
)
def test_how_fast_something_turns_relative_to_another_is_not_how_fast_it_turns(said: str) -> None:
    system = fb.System.from_text(
        """
bodies: {body: {body: {inertia: 10 kg m^2}}, wheel: {body: {inertia: 0.5 kg m^2}}}
connections: {axle: {pin: [body, wheel]}, p: {pin: [ground, body]}}
loads: {motor: {torque: {between: [wheel, body], magnitude: 2 N m}}}
"""
    )
    with pytest.raises(ModelError):
        system.question(said)
    of_ground = "angular velocity of body when wheel turns at 100 rad/s relative to the ground"
    assert system.question(of_ground).understood.endswith("when angular velocity of wheel = 100 rad/s")


def test_how_far_something_has_slid_is_a_condition_where_no_measure_tells_it() -> None:
    system = fb.System.from_text(
        """
parameters: {L: 1 m}
bodies: {wedge: {particle: 8 kg}, block: {particle: 3 kg}}
connections:
  floor: {slider: {body: wedge, along: right}}
  face: {slider: {body: block, on: wedge, along: -30 deg}}
loads: {weight: {gravity: 9.81 m/s^2}}
"""
    )
    assert system.question("speed of wedge while block slides").understood == "speed of wedge"
    with pytest.raises(ModelError, match="cannot read the condition 'block has slid L'"):
        system.question("speed of wedge when block has slid L")


@pytest.mark.parametrize(
    "said",
    [
        "größte Kraft F, damit upper nicht rutscht",
        "largest F so that upper does not slide on lower",
        "maximum force F for which both blocks move together",
        "How large may F be so that the upper block sticks to the lower one?",
        "größte Kraft F, sodass sich beide Blöcke gemeinsam bewegen",
    ],
)
def test_that_one_of_two_bodies_does_not_slip_is_not_that_nothing_moves(said: str) -> None:
    """Both have the acceleration F/M - mu1 g, which friction can give the upper one up to mu2 g."""
    system = fb.System.from_text(STACKED)
    assert system.question(said).understood == "largest F so that top does not slip"
    [answer] = fb.solve(system, question=said).answers
    assert answer.value == pytest.approx((0.2 + 0.4) * (5 + 2) * 9.81)


@pytest.mark.parametrize(
    "said",
    [
        "largest F so that the upper stays at rest",
        "range of F that the upper does not move",
        "Does the upper hold?",
        "range of F for which upper stays at rest",
    ],
)
def test_that_one_of_two_bodies_rests_is_not_that_nothing_moves(said: str) -> None:
    with pytest.raises(ModelError):
        fb.System.from_text(STACKED).question(said)


@pytest.mark.parametrize("said", ["friction force between the blocks", "Reibkraft zwischen den Blöcken"])
def test_the_contact_between_two_bodies_is_that_which_joins_both(said: str) -> None:
    assert fb.System.from_text(STACKED).question(said).understood == "friction force of top"


def test_of_two_strings_of_which_one_has_two_tensions_none_is_dropped() -> None:
    found = [question.understood for question in example("compound_atwood").asked("tension in the rope")]
    assert found == ["tension of rope1", "tension of rope2 at B", "tension of rope2 at C"]


def test_what_can_be_meant_in_two_ways_is_refused_with_both() -> None:
    with pytest.raises(ModelError, match=r"can be meant in several ways. Ask for\s+speed of left\s+speed of right"):
        example("atwood_machine").question("How fast is the block moving?")


def test_the_sense_of_a_measure_does_not_make_its_speed_negative() -> None:
    text = "speed of x1 when x1 = -1 m"
    system = example("atwood_machine").with_parameters(m1="1 kg")
    [answer] = fb.solve(system, question=text).answers
    assert answer.understood == "|velocity of x1| when x1 = -1 m"
    assert isinstance(answer.value, float)
    assert answer.value > 0.0


def test_questions_are_shown_as_they_were_understood() -> None:
    found = fb.solve(example("atwood_machine"), question="What is the acceleration of the left block?")
    [answer] = found.answers
    assert answer.to_plain()["understood"] == "acceleration of left"


@pytest.mark.parametrize("text", ["a" * 100_000, "the " * 20_000, "when " * 60, "(" * 250, "of left " * 30])
def test_hostile_questions_are_refused(text: str) -> None:
    with pytest.raises(InputError):
        example("atwood_machine").question(text)


ROLLS_UP = """
freebody: 1
title: wheel that rolls up a slope
parameters: {m: 1 kg, R: 0.2 m, v0: 2 m/s, mu: 0.5, g: 9.81 m/s^2}
ground: {lines: {slope: {along: 20 deg}}}
bodies: {wheel: {disk: {mass: m, radius: R}}}
connections: {touch: {contact: {between: [wheel, slope], friction: mu}}}
loads: {weight: {gravity: g}}
measures: {x: {travel of wheel along slope}}
start: {x: 0, rate(x): v0}
"""


@pytest.mark.parametrize("text", ["time when wheel stops", "When does the wheel stop?", "x when it comes to rest"])
def test_a_wheel_that_no_longer_slips_has_not_stopped(text: str) -> None:
    with pytest.raises(ModelError, match="wheel may roll on when it no longer slips"):
        fb.System.from_text(ROLLS_UP).question(text)


def test_kinetic_energy_that_is_lost_is_more_than_the_heat_of_friction() -> None:
    # up the slope m v0^2/2 is lost, of which mu m g cos(theta) x turns into heat
    system = example("block_on_rough_incline")
    [lost] = fb.solve(system, question="kinetic energy lost by the time it stops").answers
    [heat] = fb.solve(system, question="energy lost until it stops").answers
    m, v0, theta, mu = 3.0, 4.0, math.radians(25.0), 0.3
    assert lost.value == pytest.approx(m * v0**2 / 2)
    share = mu * math.cos(theta) / (mu * math.cos(theta) + math.sin(theta))
    assert heat.value == pytest.approx(share * m * v0**2 / 2)


def test_a_body_leaves_the_surface_that_is_named() -> None:
    system = example("sliding_ladder")
    for name, contact in (("wall", "head"), ("floor", "foot")):
        assert meaning(system.question(f"When does the ladder leave the {name}?")) == meaning(
            system.question(f"time when {contact} opens")
        )


@pytest.mark.parametrize(
    ("name", "said"),
    [
        ("atwood_machine", "How fast is the left block going once x1 reaches 1 m?"),
        ("atwood_machine", "Wie groß ist die Seilkraft an der schwereren Masse?"),
        ("block_pushed_on_incline", "How hard can you push before the block starts moving up the incline?"),
        ("wheel_brake", "Wie viele Umdrehungen macht das Rad noch bis zum Stillstand?"),
        ("slider_crank", "Kolbenbeschleunigung bei 30 Grad Kurbelwinkel"),
        ("throw", "How long is the ball in the air before it lands at y = 0?"),
    ],
)
def test_a_question_reads_the_same_in_the_file_on_the_command_line_and_in_python(
    tmp_path: Path, name: str, said: str
) -> None:
    path = path_of(name)
    text = re.sub(r"\nquestions:.*\Z", "\n", path.read_text("utf-8"), flags=re.DOTALL)
    file = tmp_path / "asked.yaml"
    file.write_text(f'{text}questions: [{{find: "{said}"}}]\n', "utf-8")
    [written] = fb.System.load(file).questions
    in_python = example(name).question(said)
    found = CliRunner().invoke(commands(), ["solve", str(path), "--find", said])
    assert written.understood == in_python.understood
    assert meaning(written) == meaning(in_python)
    assert f"understood  {in_python.understood}" in found.output


def test_when_a_question_of_a_file_is_meant_is_read_as_people_speak() -> None:
    text = re.sub(r"\nquestions:.*\Z", "\n", path_of("hoist").read_text("utf-8"), flags=re.DOTALL)
    asked = "questions: [{find: speed of the load, when: it has moved 2 m}]\n"
    [question] = fb.System.from_text(f"{text}{asked}").questions
    assert meaning(question) == meaning(example("hoist").question("speed of load when y has changed by 2 m"))


@pytest.mark.parametrize("said", ["tension in the hinge", "Seilkraft im Gelenk"])
def test_a_force_that_a_connection_has_not_is_told_so(said: str) -> None:
    with pytest.raises(ModelError, match="hinge has no tension"):
        example("cart_and_pendulum").question(said)


def test_no_two_suggestions_ask_for_the_same() -> None:
    system = example("cart_and_pendulum")
    with pytest.raises(ModelError) as error:
        system.question("what about the force in hinge against track")
    suggested = [line.strip() for line in str(error.value).splitlines()[1:]]
    assert "reaction of hinge" in suggested
    assert "force of hinge" not in suggested
    assert len({meaning(system.question(question)) for question in suggested}) == len(suggested)


def test_as_long_as_it_does_not_slip_is_a_limit() -> None:
    system = example("box_on_slope")
    found = system.question("How large may F be as long as the box does not slip?")
    assert meaning(found) == meaning(system.question("largest F so that it does not slip"))


@pytest.mark.parametrize(
    ("written", "meant"),
    [
        ("velocty", "velocity"),  # a letter is missing
        ("veloocity", "velocity"),
        ("froce", "force"),  # two have changed places
        ("velovity", "velocity"),  # c and v are neighbours on the keyboard
        ("oscillate", "oscillate"),  # a word of its own: no `oscillator`
        ("level", "level"),  # no `leave`
    ],
)
def test_a_slip_of_the_hand_is_put_right_and_no_other_word(written: str, meant: str) -> None:
    assert respelt(written, "en", set[str]()) == meant


@pytest.mark.parametrize(
    ("written", "meant"),
    [
        ("waehrend", "während"),
        ("Hoechstgeschwindigkeit", "Höchstgeschwindigkeit"),
        ("Kraefte", "Kräfte"),
        ("steuert", "steuert"),
        ("does", "does"),
    ],
)
def test_letters_that_are_written_as_two_are_put_right_and_no_others(written: str, meant: str) -> None:
    assert in_own_letters(written, "de", set[str]()) == meant


def test_a_german_word_with_another_first_part_is_no_misspelling() -> None:
    assert respelt("anfangsbeschleunigung", "de", set[str]()) == "anfangsbeschleunigung"


@pytest.mark.parametrize(
    ("word", "parts"),
    [
        ("Kolbengeschwindigkeit", "piston geschwindigkeit"),
        ("Anfangsbeschleunigung", "anfängliche beschleunigung"),
        ("Kurbelzapfen", "crank pin"),
        ("Stahlkugel", "ball"),
        ("Bremsleistung", "brake leistung"),
        ("Gegenscheibe", "Gegenscheibe"),  # what `gegen` says of it is not known
        ("rollenden", "rollenden"),  # no end of a pulley
    ],
)
def test_words_written_as_one_are_taken_apart(word: str, parts: str) -> None:
    assert in_english_nouns(word, "de") == parts


def test_every_word_of_the_lexicon_says_how_it_is_expressed() -> None:
    assert kinds_without_entry() == []


def test_every_language_means_what_english_means() -> None:
    """A word of a file that no rule knows would be read and lost."""
    for language in languages():
        for table, meanings in tables(language).items():
            known = tables("en")[table]
            assert meanings.keys() <= known.keys(), (language, table, meanings.keys() - known.keys())


def test_phrases_are_found_whatever_their_order_in_a_file() -> None:
    """Every phrase of a file, spelt out, is found from its first word on, and nothing shorter is preferred to it."""
    for language in languages():
        for table in tables(language).values():
            for phrases in table.values():
                written = (text.rstrip(ENDS_CLAUSE) for text in phrases if "*" not in text and "_" not in text)
                for said in (next(spelt_out(text)) for text in written):
                    found = phrases_at(said, 0, language)
                    assert found, (language, said)
                    assert len(found[0][1]) == len(said.split()), (language, said, found[0])


@pytest.mark.parametrize(
    "said",
    ["if mu is 0.3, when does it roll?", "Wann rollt die Kugel für mu = 0.3?", "wann rollt sie, wenn mu 0.3 beträgt"],
)
def test_another_value_of_a_parameter_in_passing_is_refused_with_the_way_to_set_it(said: str) -> None:
    with pytest.raises(ModelError, match=r"--set 'mu=0\.3'"):
        example("bowling_ball").question(said)


@pytest.mark.parametrize("said", ["what happens if mu is doubled", "Was passiert, wenn mu verdoppelt wird?"])
def test_what_a_change_of_a_parameter_does_is_told_by_asking_twice(said: str) -> None:
    with pytest.raises(ModelError, match=r"--set 'mu=0\.24'"):
        example("bowling_ball").question(said)


THROWN = """
parameters: {m: 0.2 kg, R: 3 cm, h: 1 m, u: 2 m/s, w: 10 1/s, mu: 0.2, e: 0.6, g: 9.81 m/s^2}
ground: {lines: {floor: {along: right}}}
bodies: {ball: {sphere: {mass: m, radius: R}, at: [0, R + h], velocity: [u, 0], angular_velocity: w}}
connections: {touch: {contact: {between: [ball, floor], friction: mu, restitution: e}}}
loads: {weight: {gravity: g}}
"""


@pytest.mark.parametrize(
    "said",
    [
        "range of mu for which the slip ends in the impact",
        "least mu so that it does not slip in the impact",
        "least mu so that the ball does not slip after the impact",
        "does the ball slip in the impact",
        "Für welche mu endet das Gleiten im Stoß?",
        "kleinstes mu, damit die Kugel im Stoß nicht gleitet",
        "kleinstes mu, damit die Kugel nach dem Aufprall rollt",
        "Gleitet die Kugel im Stoß?",
    ],
)
def test_that_slip_ends_in_an_impact_is_no_rest_and_the_way_to_it_is_told(said: str) -> None:
    system = fb.System.from_text(THROWN)
    with pytest.raises(ModelError, match=r"ask for the energy lost in the impact.*\(touch does not slip\)"):
        system.question(said)


BRAKED = """
parameters: {m: 1200 kg, a: 1.2 m, b: 1.4 m, h: 0.5 m, mu: 0.8, A: 1 m/s^2, g: 9.81 m/s^2}
ground: {lines: {road: {along: right}}}
bodies:
  car: {rectangle: {mass: m, width: 3.8 m, height: 2*h}, points: {rear: [-b, -h], front: [a, -h]}, at: [0, h], angle: 0}
connections:
  rear: {contact: {between: [car.rear, road], friction: mu, touching: true}}
  front: {contact: {between: [car.front, road], touching: true}}
loads: {weight: {gravity: g}, inertia: {force: {at: car, along: right, magnitude: m*A}}}
"""


@pytest.mark.parametrize("said", ["which wheel locks first", "Welches Rad blockiert zuerst?", "largest deceleration"])
def test_a_car_whose_rear_wheels_brake_is_limited_by_them(said: str) -> None:
    """N_rear (a + b) = m g a - m A h, and m A = mu N_rear at the limit: A = mu g a/(a + b + mu h)."""
    [answer] = fb.solve(fb.System.from_text(BRAKED), question=said).answers
    assert answer.value == pytest.approx(0.8 * 9.81 * 1.2 / (1.2 + 1.4 + 0.8 * 0.5))


@pytest.mark.parametrize(
    ("model", "said", "told"),
    [
        ("braking_car", "which wheel locks first", "which wheel slips or lifts first as A grows"),
        ("braking_car", "Welches Rad blockiert zuerst?", "which wheel slips or lifts first as A grows"),
        ("traction_limits", "kürzester Bremsweg", "value of F for which normal force of rear = F/mu"),
    ],
)
def test_what_a_braked_car_in_motion_leaves_open_is_refused_with_what_to_ask(model: str, said: str, told: str) -> None:
    with pytest.raises(ModelError, match=re.escape(told)):
        example(model).question(said)


def test_the_cases_of_an_impact_tell_where_its_slip_ends() -> None:
    """The slip u + R w ends while 2/7 m (u + R w) <= mu (1 + e) m v: so it is told where the refusal points to."""
    [answer] = fb.solve(fb.System.from_text(THROWN), question="energy lost in the impact").answers
    v = math.sqrt(2 * 9.81)
    assert answer.value == pytest.approx(0.2 * 9.81 * (1 - 0.6**2) + 0.2 * (2 + 0.03 * 10) ** 2 / 7)
    assert 0.2 * 1.6 * v >= 2 / 7 * (2 + 0.03 * 10)
    solved = fb.solve(fb.System.from_text(THROWN), question="energy lost in the impact")
    lines = terminal_text(solved.report)
    assert "(touch does not slip)" in " ".join(lines.split())


@pytest.mark.parametrize("said", ["efficiency of the gears", "Wirkungsgrad"])
def test_teeth_that_lose_nothing_are_said_to_be_ideal(said: str) -> None:
    with pytest.raises(ModelError, match="the teeth of first are taken as ideal"):
        example("compound_gear_train").question(said)
    assert example("worm_gear").question(said).text == said  # a worm loses by friction


@pytest.mark.parametrize(
    ("name", "said", "suggested"),
    [
        ("slider_crank", "quick return ratio", "time ratio of position of piston along cylinder"),
        ("differential_hoist", "what is the efficiency", "ratio of power of weight to power of crank"),
    ],
)
def test_what_lacks_an_operand_is_answered_with_complete_questions(name: str, said: str, suggested: str) -> None:
    with pytest.raises(ModelError) as error:
        example(name).question(said)
    assert suggested in [line.strip() for line in str(error.value).splitlines()]


def test_a_spring_is_longer_by_what_it_pulls_with_over_its_stiffness() -> None:
    """At y = 0.6 m the spring of 0.5 m is longer by 0.1 m."""
    [answer] = fb.solve(example("mass_on_spring"), question="extension of the spring when y = 0.6 m").answers
    assert answer.value == pytest.approx(0.1)


HUMP = """
parameters: {m: 1000 kg, R: 50 m, v: 20 m/s, g: 9.81 m/s^2}
bodies:
  hill: {disk: {radius: R}, fixed: true, at: [0, 0]}
  car: {particle: {mass: m}, at: [0, R], velocity: [v, 0]}
connections: {road: {contact: {between: [car, hill]}}}
loads: {weight: {gravity: g}}
measures: {phi: angle of line from ground.O to car from up clockwise}
"""


def test_the_speed_at_which_a_car_leaves_a_hump_at_its_top_is_that_of_a_circle_of_no_force() -> None:
    """m v^2/R = m g."""
    system = fb.System.from_text(HUMP)
    [answer] = fb.solve(system, question="At what speed does the car leave the road at the top?").answers
    assert answer.value == pytest.approx(math.sqrt(50 * 9.81))


@pytest.mark.parametrize(
    ("name", "said", "value"),
    [
        # Willis: omega_P = omega_C (1 - z_R/z_P) in a fixed ring
        ("planetary_gear_by_teeth", "planet turns how fast if the carrier turns with 3 rad/s", 3 * (1 - 60 / 18)),
        # one turn winds up 2 pi R and unwinds 2 pi r, of which the block in the loop rises half
        ("differential_hoist", "how far does the block rise per turn of the shaft", math.pi * (0.12 - 0.1)),
        ("mass_on_spring", "extension of the spring in equilibrium", 2 * 9.81 / 200),  # m g/k
        ("mass_on_spring", "amplitude of the vibration", 2 * 9.81 / 200),  # let go where the spring is relaxed
        ("mass_on_spring", "how many oscillations per second", 10 / (2 * math.pi)),  # sqrt(k/m)/(2 pi)
        ("mass_on_spring", "energy in the spring when y = 0.6 m", 200 * 0.1**2 / 2),
        ("mass_on_spring", "speed of the block when it passes the equilibrium", 9.81 / 10),  # g/omega
        # it swings by as much again as it hangs down at rest: 2 m g = 50 N
        ("mass_on_spring", "Wie groß darf m höchstens sein, damit die Federkraft 50 N nicht überschreitet?", 25 / 9.81),
        # A a - (m g/L) a^2/2 with A = P (L - a)/L + m g/2
        ("beam", "Biegemoment bei C", (1000 * 4 / 6 + 98.1) * 2 - 196.2 / 6 * 2),
    ],
)
def test_what_words_stand_for_is_what_a_hand_derives(name: str, said: str, value: float) -> None:
    [answer] = fb.solve(example(name), question=said).answers
    assert answer.value == pytest.approx(value)


def test_a_parameter_that_nobody_gives_is_told_where_a_formula_uses_it_and_in_no_question() -> None:
    text = """
bodies: {block: {particle: {mass: m}}}
connections: {rail: {slider: {body: block, along: right}}}
measures: {x: x of block}
questions: [value of m for which x = 0 when t = 1 s, "m*acceleration of x", acceleration of x when x = d]
"""
    with pytest.raises(ModelError) as raised:
        System.from_text(text)
    assert [problem.path[0] for problem in raised.value.problems] == ["bodies", "questions"]
    assert raised.value.problems[1].path[1] == 2


def test_the_mass_center_of_a_body_is_not_its_reference_point() -> None:
    system = fb.System.from_text(
        """
freebody: 1
parameters: {m: 2 kg, I: 1 kg m^2, e: 0.2 m, w: 2 rad/s}
bodies: {wheel: {body: {mass: m, inertia: I, center_of_mass: [e, 0]}}}
connections: {axle: {pin: [ground.O, wheel]}}
measures: {phi: angle of wheel}
start: {phi: 0, rate(phi): w}
"""
    )
    for asked in ("mass center speed of wheel at start", "how fast is the mass center at start"):
        answer = system.solve(asked).answers[0]
        assert answer.understood == "speed of wheel.mass_center at start"
        assert answer.value == pytest.approx(0.4)  # e w; the axle, which the body's plain name means, rests
    assert system.solve("mass center position of wheel at start").answers[0].value == pytest.approx((0.2, 0))


def test_what_has_strange_words_is_not_read_in_every_part() -> None:
    """Of three sentences with words that nothing knows, each part was tried with the words of all others."""
    text = (
        "The truck is driving and a crate stands on it. The driver then sees a red light and steps on the pedal. "
        "How far will it slide and when does it lie still?"
    )
    system = fb.System.load(str(EXAMPLES / "crate_on_a_truck.yaml"))
    words._read.cache_clear()  # pyright: ignore[reportPrivateUsage]
    with pytest.raises(ModelError, match="pedal"):
        system.asked(text)
    told = words._read.cache_info()  # pyright: ignore[reportPrivateUsage]
    assert told.hits + told.misses < 600  # texts read; 1068 without the look at each part


def test_when_there_is_an_equilibrium_its_conditions_tell() -> None:
    with pytest.raises(ModelError, match="ask for the equilibrium of theta: the conditions"):
        fb.System.load(EXAMPLES / "simple_pendulum.yaml").asked("when is there an equilibrium?")


def test_a_force_is_compared_with_a_value() -> None:
    """At the pinned end of a beam that stands out by b beyond its other support: q a/2 - P b/a."""
    system = fb.System.load(EXAMPLES / "beam_with_overhang.yaml")
    q, P, a, b = (system.parameters[name].value for name in ("q", "P", "a", "b"))
    [answer] = fb.solve(system, question="Is the reaction at A larger than 1 kN?").answers
    assert answer.value == pytest.approx(abs(q * a / 2 - P * b / a) - 1000)


def test_the_speed_at_which_a_power_is_greatest_is_not_that_of_the_start() -> None:
    """(M0 - b w) w is greatest at w = M0/(2 b), which the arm passes; with that speed it need not begin."""
    system = fb.System.from_text(
        """
parameters: {omega_0: 1 rad/s, M0: 20 N m, b: 2 N m s}
bodies: {arm: {body: {inertia: 0.3 kg m^2}}}
connections: {axle: {pin: [ground.O, arm]}}
measures: {phi: angle of arm}
loads: {motor: {torque: {on: arm, magnitude: M0 - b*rate(phi)}}}
start: {phi: 0, rate(phi): omega_0}
"""
    )
    asked = "at which angular velocity is the power of the motor greatest?"
    assert [q.understood for q in system.asked(asked)] == ["angular velocity of arm when power of motor is greatest"]
    with pytest.raises(ModelError):
        system.asked("Bei welcher Winkelgeschwindigkeit ist die Leistung des Motors am größten?")
    for asked in ("for which omega_0", "for which initial angular velocity"):
        [question] = system.asked(f"{asked} is the power of the motor greatest at the start?")
        assert question.understood == "value of omega_0 for which power of motor at start is largest"
