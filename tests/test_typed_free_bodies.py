"""Free-body diagrams as they are typed. The verdicts and what they name were written down by hand, from the mechanics
of the examples, before anything was run."""

from __future__ import annotations

import json
from functools import cache
from pathlib import Path

import numpy as np
import pytest

import freebody as fb
from command import freebody
from freebody.errors import ExpressionError, InputError
from freebody.language.typed.forces import read_forces
from freebody.narrative.marking.acting import Acting, free_bodies

EXAMPLES = Path(__file__).parents[1] / "examples"


@cache
def system(name: str) -> fb.System:
    return fb.System.load(EXAMPLES / f"{name}.yaml")


# example, body, answer, verdict, what the reason names
TABLE = [
    # Atwood machine: a mass hangs on its rope; the pulley on its axle, with two ropes and its weight
    ("atwood_machine", "left", "T up; m1 g down", "correct", ""),
    ("atwood_machine", "left", "T1 up at rope; m1 g down at G", "correct", ""),
    ("atwood_machine", "left", "T down; m1 g down", "incorrect", "a string only pulls"),
    ("atwood_machine", "left", "T up", "incorrect", "the weight of left is missing"),
    ("atwood_machine", "left", "T up; m2 g down", "incorrect", "'m2 g down' acts on right, not on left"),
    ("atwood_machine", "left", "T up; m1 g down; m1 a up", "incorrect", "'m1 a up'"),
    ("atwood_machine", "left", "T up; m1 down", "incorrect", "wrong magnitude: the weight of left is"),
    ("atwood_machine", "left", "T up; -m1 g up", "correct", ""),
    ("atwood_machine", "left", "T up at rope; H right at rope; m1 g down at G", "incorrect", "'H right at rope'"),
    ("atwood_machine", "left", "T; m1 g down", "unreadable", "in which direction"),
    ("atwood_machine", "left", "T up; m1 g down at", "unreadable", "at which point"),
    ("atwood_machine", "right", "S nach oben; m2 g nach unten im Schwerpunkt", "correct", ""),
    ("atwood_machine", "pulley", "A up at axle; M g down at center; T1 down at left; T2 down at right", "correct", ""),
    (
        "atwood_machine",
        "pulley",
        "A_x right at axle; A_y up at axle; M g down at G; T1 down at rope; T2 down at rope",
        "correct",  # A_x is zero, and may be drawn
        "",
    ),
    ("atwood_machine", "pulley", "A at axle; M g down at G; T1 down at left; T2 down at right", "correct", ""),
    ("atwood_machine", "pulley", "A up at axle; M g down at G; T1 down at left", "incorrect", "the tension of rope"),
    (
        "atwood_machine",
        "pulley",
        "A up at axle; M g down at G; T1 down at left; T1 up at left; T2 down at right",
        "incorrect",
        "action and reaction",
    ),
    # a disk that rolls: normal force and friction at the contact
    (
        "disk_rolling_down_incline",
        "disk",
        "N normal to incline at contact; F along incline at contact; m g down at G",
        "correct",
        "",
    ),
    ("disk_rolling_down_incline", "disk", "R at contact; m g down at center", "correct", ""),
    (
        "disk_rolling_down_incline",
        "disk",
        "N normal to incline at contact; m g down at G",
        "incorrect",
        "the friction force of contact is missing",
    ),
    (
        "disk_rolling_down_incline",
        "disk",
        "N normal to incline at contact; F along incline at contact; m g down at contact",
        "incorrect",
        "line of action of the weight of disk",
    ),
    (
        "disk_rolling_down_incline",
        "disk",
        "N normal to incline at contact; F along incline at center; m g down at G",
        "incorrect",
        "line of action of the friction force of contact",
    ),
    (
        "disk_rolling_down_incline",
        "disk",
        "N down normal to incline at contact; F along incline at contact; m g down at G",
        "incorrect",
        "a contact only pushes",
    ),
    # a massless rod may push or pull; a string may not
    ("simple_pendulum", "bob", "T along rod; m g down", "correct", ""),
    ("simple_pendulum", "bob", "T away from O; m g down", "correct", ""),
    ("simple_pendulum", "bob", "m g down", "incorrect", "the tension of rod is missing"),
    ("simple_pendulum", "bob", "S along rod; m g down; m L theta'^2 away from O", "incorrect", "'m L theta'^2 away"),
    ("simple_pendulum", "bob", "T towards O; m g down; F right", "incorrect", "'F right' is extra"),
    # pins between three bodies, and a torque
    (
        "slider_crank",
        "crank",
        "T counterclockwise; A_x right at main; A_y up at main; B_x left at crankpin; B_y down at crankpin",
        "correct",
        "",
    ),
    ("slider_crank", "crank", "T clockwise; A at main; B at crankpin", "incorrect", "wrong sense for the load drive"),
    ("slider_crank", "rod", "B at crankpin; C at wristpin", "correct", ""),
    (
        "slider_crank",
        "rod",
        "B_x right at start; B_y up at start; C_x right at end",
        "incorrect",
        "one component of the force of wristpin is missing",
    ),
    ("slider_crank", "rod", "B at crankpin; C at wristpin; T counterclockwise", "incorrect", "acts on crank"),
    ("slider_crank", "piston", "C at wristpin; N vertical at cylinder", "correct", ""),
    ("slider_crank", "piston", "C at wristpin; N along cylinder at cylinder", "incorrect", "cylinder is smooth"),
    # a ladder: both ends rough, or the wall smooth
    (
        "ladder_rough_wall",
        "ladder",
        "N1 up at floor; F1 right at floor; N2 left at wall; F2 up at wall; m g down at G",
        "correct",
        "",
    ),
    (
        "ladder_rough_wall",
        "ladder",
        "N1 up at floor; F1 right at floor; N2 left at wall; m g down at G",
        "incorrect",
        "the friction force of wall is missing",
    ),
    (
        "ladder_rough_wall",
        "ladder",
        "N1 up at floor; F1 right at floor; N2 right at wall; F2 up at wall; m g down at G",
        "incorrect",
        "a contact only pushes",
    ),
    (
        "ladder_against_wall",
        "ladder",
        "N_A up at start; F_A right at start; N_B left at end; m g down at G; M g down at rung",
        "correct",
        "",
    ),
    (
        "ladder_against_wall",
        "ladder",
        "N_A up at start; F_A right at start; N_B left at end; F_B up at end; m g down at G; M g down at rung",
        "incorrect",
        "wall is smooth",
    ),
    (
        "ladder_against_wall",
        "ladder",
        "N_A up at start; F_A right at start; N_B left at end; m g down at G",
        "incorrect",
        "the load person is missing",
    ),
    # particles on inclines: every force acts at the one point
    ("block_on_rough_incline", "block", "N normal to incline; F along incline; m g down", "correct", ""),
    ("block_on_rough_incline", "block", "N normal to incline; mu N down the incline; m g down", "correct", ""),
    (
        "block_on_rough_incline",
        "block",
        "N up; F along incline; m g down",
        "incorrect",
        "wrong direction for the normal force of contact",
    ),
    (
        "block_on_rough_incline",
        "block",
        "N normal to incline; F along incline; m g sin(theta) down the incline; m g cos(theta) down normal to incline",
        "undecided",
        "components of the weight of block",
    ),
    ("incline_with_pulley", "block", "N normal to incline; T up along incline; m1 g down", "correct", ""),
    ("incline_with_pulley", "block", "N normal to incline; T down along incline; m1 g down", "incorrect", "only pulls"),
    (
        "incline_with_pulley",
        "pulley",
        "A at axle; M g down; T1 along incline at rope; T2 down at rope",
        "correct",
        "",
    ),
    # springs: in the sense of their formula, or either way by name
    ("mass_on_spring", "block", "F_s up at spring; m g down at G", "correct", ""),
    ("mass_on_spring", "block", "F_s up at spring; k y down at G", "incorrect", ""),
    ("two_masses_three_springs", "A", "k x1 left at left; k (x2 - x1) right at middle", "correct", ""),
    ("two_masses_three_springs", "B", "k (x1 - x2) right at middle; k x2 left at right", "correct", ""),
    ("two_masses_three_springs", "A", "F1 right at left; F2 right at middle", "correct", ""),
    (
        "two_masses_three_springs",
        "A",
        "k x1 right at left; k (x2 - x1) right at middle",
        "incorrect",
        "wrong sense for the load left",
    ),
    # a massless pulley on a rope has no weight
    ("compound_atwood", "lower", "T1 up at center; T2 down at left; T3 down at right", "correct", ""),
    (
        "compound_atwood",
        "lower",
        "T1 up at center; T2 down at left; T3 down at right; m g down at G",
        "incorrect",
        "'m g down at G' is extra",
    ),
    # a band brake: two tensions are all that the band does to the drum
    ("band_brake", "drum", "A at axle; T counterclockwise; S1 down at left; S2 down at right", "correct", ""),
    ("band_brake", "drum", "A at axle; T counterclockwise; S1 down at left", "incorrect", "the tension of band"),
    ("band_brake", "lever", "A at hinge; F down at push; S up at band", "correct", ""),
    # of a belt the model knows the difference of the tensions alone
    ("belt_drive", "drum", "B at B; M clockwise at brake; S1 left at top; S2 left at bottom", "undecided", "belt"),
    # a cam pushes its follower, teeth each other
    ("cam_with_flat_follower", "disk", "A at axle; M moment at motor; N up at cam", "incorrect", "wrong sense"),
    ("planetary_gear_by_teeth", "planet", "A at planet_axle; F1 up at inner; F2 up at outer", "correct", ""),
    ("planetary_gear_by_teeth", "planet", "A at planet_axle; F1 up at inner", "incorrect", "the force of outer"),
    ("ball_in_bowl", "ball", "m g down; N at contact towards center; F right at contact", "correct", ""),
    # a hinge
    ("falling_hinged_rod", "rod", "A_x right at hinge; A_y up at hinge; m g down at G", "correct", ""),
    ("falling_hinged_rod", "rod", "A1 at 30 deg at hinge; A2 at 120° at hinge; 29.43 N down at G", "correct", ""),
    ("falling_hinged_rod", "rod", "A_y up at hinge; m g down at G", "incorrect", "one component"),
    ("falling_hinged_rod", "rod", "A at hinge; m g down at center; M counterclockwise at hinge", "incorrect", "extra"),
    ("falling_hinged_rod", "rod", "A at hinge; m g down at G; M about z at hinge", "incorrect", "transmits no moment"),
    ("slider_crank", "crank", "T about -z; A at main; B at crankpin", "incorrect", "wrong sense for the load drive"),
    ("slider_crank", "crank", "T about +z; A at main; B at crankpin", "correct", ""),
    ("falling_hinged_rod", "rod", "A_x right; A_y up; m g down", "unreadable", "at which point"),
    ("falling_hinged_rod", "rod", "A at hinge; m g at G", "unreadable", "in which direction"),
    ("falling_hinged_rod", "rod", "A at hinge; m g down at Q", "unreadable", "no point Q"),
    ("falling_hinged_rod", "rod", "A at hinge; 2 m g down at G", "incorrect", "wrong magnitude"),
    ("falling_hinged_rod", "rod", "A_x right at hinge; m g/4 up at hinge; m g down at G", "undecided", "hinge"),
    # a slider: normal force and moment
    (
        "cart_and_pendulum",
        "cart",
        "N up at track; moment M_T at track; M g down at G; F right at push; H at hinge",
        "correct",
        "",
    ),
    (
        "cart_and_pendulum",
        "cart",
        "N up at track; M g down at G; F right at push; H at hinge",
        "incorrect",
        "the moment of track is missing",
    ),
    (
        "cart_and_pendulum",
        "cart and rod",
        "N up at track; moment M_T at track; M g down at cart; m g down at rod; F right at push",
        "correct",
        "",
    ),
    (
        "cart_and_pendulum",
        "cart and rod",
        "N up at track; moment M_T at track; M g down at cart; m g down at rod; F right at push; H right at hinge",
        "incorrect",
        "is internal",
    ),
    # two ropes and a hook; a string on top of a rolling cylinder
    ("hoist", "block", "T1 up at left; T2 up at right; T3 down at hook", "correct", ""),
    (
        "cylinder_pulled_by_string",
        "cylinder",
        "M g down at G; N up at bottom; F left at bottom; T right at top",
        "correct",
        "",
    ),
    (
        "cylinder_pulled_by_string",
        "cylinder",
        "M g down at G; N up at bottom; F left at bottom; T right at center",
        "incorrect",
        "line of action of the tension of string",
    ),
    # what hangs on a travelling sheave is kept below it by the model; a rope itself transmits nothing across itself
    ("tower_crane", "left_sheave", "A at left_axle; T1 left at rope; T2 down at rope", "correct", ""),
    ("tower_crane", "left_sheave", "A at left_axle; T1 left at rope; T2 down at rope; H left at rope", "correct", ""),
    ("tower_crane", "left_sheave", "A at left_axle; T1 left at rope", "incorrect", "the tension of rope is missing"),
    ("tower_crane", "block", "T1 up at rope; T2 up at rope; S down at hook", "correct", ""),
    ("tower_crane", "load", "S up; m g down", "correct", ""),
    ("tower_crane", "load", "m g down", "incorrect", "the tension of hook is missing"),
    # a block on two corners: one force for both
    ("block_tips_or_slides", "block", "m g down at G; F right at pull; N up at floor; H left at floor", "correct", ""),
    ("block_tips_or_slides", "block", "m g down at G; F right at pull; N up at floor", "incorrect", "friction force"),
]


# In space. A revolute joint holds a point and the direction of its axis: three forces, and moments about the two
# directions across its axis. A cylindrical one has no force along its axis either, a prismatic one two forces across it
# and three moments, a ball joint three forces, a point on a line two, a weld three and three. Wheels that roll have a
# normal force and friction along both directions of the plane.
CRANK = "m_crank g down at G; A_x +x at O; A_y +y at O; A_z +z at O; M_x about x at O; M_y about y at O"
BLOCK = (
    "m g down at G; S along rod at rod; N_x +x at guide; N_y +y at guide; M_x about x at guide; M_y about y at guide"
)
BOB = "m g down at G; A_x +x at hinge; A_y +y at hinge; A_z up at hinge; M_x about x at hinge; M_z about z at hinge"
SHAFT = (
    "A_x +x at bearing; A_y up at bearing; A_z +z at bearing; M_x about x at bearing; M_z about z at bearing; "
    "T about y at motor"
)
DISK = (
    "B_x +x at spindle; B_y up at spindle; B_z +z at spindle; M_1 about z at spindle; "
    "moment M_2 (sin(beta), cos(beta), 0) at spindle; N up at floor"
)
DRIVEN = "A_1 along x at support; A_2 along driven.y at support; M_1 about x at support; M_2 about driven.y at support"
CROSS = "A at yoke; moment M any at yoke; B_x +x at other_yoke; B_y +y at other_yoke; B_z +z at other_yoke"
PLANET = "P_x +x at pin; P_y +y at pin; P_z +z at pin; M_x about x at pin; M_z about z at pin"
INNER = "H at horizontal; M_y about y at horizontal; M_z about z at horizontal; S at spin"
ROD = "A at A; B_y +y at B; B_z +z at B; T about x at motor; H at hub"
IN_SPACE = [
    ("disk_on_angled_shaft", "shaft", f"{SHAFT}; B at spindle; moment M_B any at spindle", "correct", ""),
    ("disk_on_angled_shaft", "shaft", f"{SHAFT}; B any at B; M_B about any axis at spindle", "correct", ""),
    ("disk_on_angled_shaft", "shaft", f"{SHAFT}; B at spindle", "incorrect", "the moment of spindle is missing"),
    (
        "disk_on_angled_shaft",
        "shaft",
        f"{SHAFT}; B at spindle; moment M_B any at spindle; M_y about y at bearing",
        "incorrect",
        "bearing transmits no moment about this axis",
    ),
    ("disk_on_angled_shaft", "disk", f"{DISK}; F_1 along x at floor; F_2 along z at floor", "correct", ""),
    ("disk_on_angled_shaft", "disk", f"{DISK}; F_1 (1, 0, 1) at floor; F_2 (1, 0, -1) at floor", "correct", ""),
    ("disk_on_angled_shaft", "disk", "B at spindle; moment M any at spindle; R at floor", "correct", ""),
    ("disk_on_angled_shaft", "disk", "B at center; moment M any at spindle; N up at floor; F at floor", "correct", ""),
    (
        "disk_on_angled_shaft",
        "disk",
        "B at center; moment M any at spindle; N up at floor; F_1 +x at floor; F_2 +x at floor; F_3 +z at floor",
        "incorrect",
        "'F_2 +x at floor' and 'F_1 +x at floor' are the same force",
    ),
    (
        "disk_on_angled_shaft",
        "shaft",
        f"{SHAFT}; B at B; M_B about any axis at spindle; T' about -y at motor",
        "incorrect",
        "are the same moment",
    ),
    (
        "disk_on_angled_shaft",
        "disk",
        f"{DISK}; F_1 along x at floor",
        "incorrect",
        "one component of the friction force",
    ),
    (
        "disk_on_angled_shaft",
        "disk",
        f"{DISK}; F_1 (1, 0, 1) at floor; F_2 (-2, 0, -2) at floor",
        "incorrect",
        "action and reaction",
    ),
    (
        "disk_on_angled_shaft",
        "disk",
        f"{DISK.replace('up at floor', 'down at floor')}; F_1 along x at floor; F_2 along z at floor",
        "incorrect",
        "a contact only pushes",
    ),
    (
        "disk_on_angled_shaft",
        "disk",
        f"{DISK}; F_1 along x at floor; F_2 along z at floor; M_3 about shaft.arm at spindle",
        "incorrect",
        "spindle transmits no moment about this axis",
    ),
    (
        "disk_on_angled_shaft",
        "disk",
        f"{DISK}; F_1 along x at floor; F_2 along z at floor; M_3 about the axis of spindle at spindle",
        "incorrect",
        "spindle transmits no moment about this axis",
    ),
    (
        "disk_on_angled_shaft",
        "disk",
        f"{DISK.replace('M_1 about z', 'M_1 about -x')}; F_1 along x at floor; F_2 along z at floor",
        "incorrect",
        "one component of the moment of spindle is missing",
    ),
    ("cardan_joint", "driven", f"{DRIVEN}; B at other_yoke; M_B any axis at other_yoke moment", "correct", ""),
    (
        "cardan_joint",
        "driven",
        f"{DRIVEN}; A_3 along bent.z at support; B at other_yoke; moment M_B any at other_yoke",
        "incorrect",
        "support transmits no force in this direction",
    ),
    (
        "cardan_joint",
        "driven",
        f"{DRIVEN}; M_3 about axis of support at support; B at other_yoke; moment M_B any at other_yoke",
        "incorrect",
        "support transmits no moment about this axis",
    ),
    ("cardan_joint", "cross", f"{CROSS}; M_1 about x at other_yoke; M_2 about bent.z at other_yoke", "correct", ""),
    (
        "cardan_joint",
        "cross",
        f"{CROSS}; M_1 about x at other_yoke",
        "incorrect",
        "one component of the moment of other",
    ),
    (
        "cardan_joint",
        "cross",
        f"{CROSS}; M_1 about x at other_yoke; M_2 about bent.z at other_yoke; M_3 about driven.y at other_yoke",
        "incorrect",
        "other_yoke transmits no moment about this axis",
    ),
    (
        "cardan_joint",
        "drive, cross",
        "A at bearing; moment M any at bearing; B at other_yoke; moment M_B any at other_yoke; Y +x at yoke",
        "incorrect",
        "is internal",
    ),
    ("conical_pendulum", "bob", BOB, "correct", ""),
    (
        "conical_pendulum",
        "bob",
        "m g nach unten im Schwerpunkt; A bei hinge; Moment M beliebig bei hinge",
        "correct",
        "",
    ),
    ("conical_pendulum", "bob", BOB.replace("m g down", "m g up"), "incorrect", "wrong sense for the weight of bob"),
    ("conical_pendulum", "bob", BOB.replace("at G", "at top"), "incorrect", "line of action of the weight of bob"),
    ("conical_pendulum", "bob", BOB.removeprefix("m g down at G; "), "incorrect", "the weight of bob is missing"),
    ("conical_pendulum", "bob", BOB.replace("A_z up", "A_z (1, 1, 0)"), "incorrect", "made up of the other components"),
    (
        "conical_pendulum",
        "bob",
        f"{BOB}; M_y about y at hinge",
        "incorrect",
        "hinge transmits no moment about this axis",
    ),
    ("conical_pendulum", "bob", f"{BOB}; Z +x at G", "incorrect", "'Z +x at G' is extra"),
    ("conical_pendulum", "bob", f"{BOB}; M counterclockwise at hinge", "unreadable", "about which axis"),
    ("conical_pendulum", "bob", f"{BOB}; Z (1, 0) at G", "unreadable", "2 components, not 3"),
    ("conical_pendulum", "bob", f"{BOB}; Z at 30 deg at G", "unreadable", "in space an angle"),
    ("spatial_slider_crank", "crank", f"{CRANK}; S along rod at end", "correct", ""),
    ("spatial_slider_crank", "crank", f"{CRANK}; S towards block at end", "correct", ""),
    ("spatial_slider_crank", "crank", f"{CRANK}; S +z at end", "incorrect", "wrong direction for the tension of rod"),
    (
        "spatial_slider_crank",
        "crank",
        f"{CRANK}; S along rod at O",
        "incorrect",
        "line of action of the tension of rod",
    ),
    ("spatial_slider_crank", "crank", CRANK, "incorrect", "the tension of rod is missing"),
    (
        "spatial_slider_crank",
        "crank",
        f"{CRANK}; S along rod at end; M_z about z at O",
        "incorrect",
        "O transmits no moment about this axis",
    ),
    ("spatial_slider_crank", "block", f"{BLOCK}; M_z about z at guide", "correct", ""),
    ("spatial_slider_crank", "block", BLOCK, "incorrect", "one component of the moment of guide is missing"),
    (
        "spatial_slider_crank",
        "block",
        f"{BLOCK}; M_z about z at guide; N_z +z at guide",
        "incorrect",
        "guide transmits no force in this direction",
    ),
    ("spinning_top", "top", "m g down at G; A_x +x at tip; A_y +y at tip; A_z up at tip", "correct", ""),
    (
        "spinning_top",
        "top",
        "m g down at G; A_1 along top.x at tip; A_2 along top.y at tip; A_3 along top at tip",
        "unreadable",
        "no line top",
    ),
    (
        "spinning_top",
        "top",
        "m g down at G; A_1 along top.x at tip; A_2 along top.y at tip; A_3 along top.z at tip",
        "correct",
        "",
    ),
    ("spinning_top", "top", "m g down at G; A at tip", "correct", ""),
    ("spinning_top", "top", "m g cos(theta) down at G; A at tip", "incorrect", "magnitude"),
    (
        "spinning_top",
        "top",
        "m g down at G; A_x +x at tip; A_z up at tip",
        "incorrect",
        "one component of the force of tip",
    ),
    ("spinning_top", "top", "m g down at G; A along top.z at tip", "incorrect", "2 components of the force of tip are"),
    ("spinning_top", "top", "m g down at G; A at tip; M about z at tip", "incorrect", "tip transmits no moment"),
    ("spinning_top", "top", "m g down at G; A at tip; moment M any at tip", "incorrect", "tip transmits no moment"),
    (
        "bevel_differential",
        "carrier",
        "T about +x at engine; A at carrier_bearing; M_y about y at carrier_bearing; M_z about z at carrier_bearing; "
        "P at pin; moment M_P any at pin",
        "correct",
        "",
    ),
    (
        "bevel_differential",
        "carrier",
        "T about -x at engine; A at carrier_bearing; moment M any at carrier_bearing; P at pin; moment M_P any at pin",
        "incorrect",
        "wrong sense for the load engine",
    ),
    (
        "bevel_differential",
        "left",
        "T_left clockwise about x; A at left_bearing; moment M_A any at left_bearing; M about x at left_mesh",
        "correct",
        "",
    ),
    (
        "bevel_differential",
        "left",
        "T_left about -x at left_wheel; A at left_bearing; moment M_A any at left_bearing; F +z at left_mesh",
        "undecided",
        "left_mesh",
    ),
    ("bevel_differential", "planet", f"{PLANET}; M_1 about y at left_mesh; M_2 about y at right_mesh", "correct", ""),
    (
        "bevel_differential",
        "planet",
        f"{PLANET}; M_1 about y at left_mesh",
        "incorrect",
        "the moment of right_mesh is missing",
    ),
    (
        "bevel_differential",
        "planet",
        f"{PLANET}; M_y about y at pin; M_1 about y at left_mesh; M_2 about y at right_mesh",
        "incorrect",
        "pin transmits no moment about this axis",
    ),
    (
        "gyroscope_in_gimbals",
        "inner",
        f"{INNER}; T about +x at push; M_1 about x at spin; M_2 about inner.y at spin",
        "correct",
        "",
    ),
    (
        "gyroscope_in_gimbals",
        "inner",
        f"{INNER}; T about -x at push; M_1 about x at spin; M_2 about inner.y at spin",
        "incorrect",
        "wrong sense for the load push",
    ),
    (
        "gyroscope_in_gimbals",
        "outer",
        "V at vertical; moment M_V any at vertical; H at horizontal; moment M_H any at horizontal; T about -x at push",
        "correct",
        "",
    ),
    (
        "gyroscope_in_gimbals",
        "inner",
        f"{INNER}; T about +x at push; M_1 about x at spin; M_2 about inner.y at spin; M_3 about inner.z at spin",
        "incorrect",
        "spin transmits no moment about this axis",
    ),
    # the teeth of bevel wheels: one force, of which three components are usually given
    (
        "bevel_gears",
        "pinion",
        "T_1 about +x at motor; A at A; moment M any at A; F_t +z at mesh; F_r +y at mesh; F_a +x at mesh",
        "undecided",
        "components of the force of mesh",
    ),
    (
        "bevel_gears",
        "pinion",
        "T_1 about +x at motor; A at A; moment M any at A",
        "incorrect",
        "the force of mesh is missing",
    ),
    # a screw: whatever its thread does, as one force and one moment; its parts are known as a sum
    ("screw_jack", "spindle", "m g down at G; T about +z at lever; F at thread; moment M any at thread", "correct", ""),
    (
        "screw_jack",
        "spindle",
        "m g down at G; T about +z at lever; F +z at thread; M about z at thread",
        "undecided",
        "thread",
    ),
    ("tilted_disk_on_shaft", "shaft", f"{ROD}; moment M any at hub", "correct", ""),
    (
        "tilted_disk_on_shaft",
        "shaft",
        f"{ROD}; M_1 about x at hub; M_2 about y at hub; M_3 about z at hub",
        "correct",
        "",
    ),
    ("tilted_disk_on_shaft", "shaft", ROD, "incorrect", "the moment of hub is missing"),
    (
        "tilted_disk_on_shaft",
        "shaft",
        f"{ROD}; moment M any at hub; B_x +x at B",
        "incorrect",
        "B transmits no force in this direction",
    ),
    (
        "tilted_disk_on_shaft",
        "shaft",
        f"{ROD}; moment M any at hub; M_A about y at A",
        "incorrect",
        "A transmits no moment",
    ),
    ("tilted_disk_on_shaft", "disk", "H at hub; moment M any at hub", "correct", ""),
    (
        "tilted_disk_on_shaft",
        "disk",
        "H at hub; M_1 about disk.y at hub; M_2 about disk.z at hub",
        "incorrect",
        "one component",
    ),
]
TABLE += IN_SPACE


@pytest.mark.parametrize("example", sorted({row[0] for row in TABLE}))
def test_diagrams_of_the_table_have_their_verdicts(example: str) -> None:
    wrong = {}
    for name, body, answer, verdict, says in TABLE:
        if name == example:
            found = system(name).check(f"free body of {body}", answer)
            if found.verdict != verdict or says not in found.reason:
                wrong[body, answer] = (found.verdict, found.reason)
    assert wrong == {}


def test_the_table_is_wide() -> None:
    assert len(TABLE) >= 40
    assert len({row[0] for row in TABLE}) >= 10


# -- a massless member with two pins ----------------------------------------------------------
STRUT = """freebody: 1
title: Bracket
parameters: {m: 2 kg, L: 1 m, g: 9.81 m/s^2}
ground: {points: {A: [0, 0], B: [0, -1]}}
bodies:
  beam: {rod: {mass: m, length: L}, angle: 0}
  strut: {rod: {mass: 0, length: sqrt(2)*L}, angle: 45 deg}
connections:
  a: {pin: [ground.A, beam.start]}
  b: {pin: [ground.B, strut.start]}
  c: {pin: [beam.end, strut.end]}
loads:
  weight: {gravity: g}
"""


@pytest.mark.parametrize(
    ("body", "answer", "verdict"),
    [
        ("strut", "S along strut at b; S along strut at c", "correct"),
        ("strut", "S along strut at b", "incorrect"),
        ("strut", "S up at b; S down at c", "incorrect"),
        ("beam", "A at a; S along strut at c; m g down at G", "correct"),
        ("beam", "A at a; C_x right at c; C_y up at c; m g down at G", "correct"),
        ("beam", "A at a; C up at c; m g down at G", "incorrect"),
    ],
)
def test_a_massless_member_transmits_along_its_line(body: str, answer: str, verdict: str) -> None:
    found = fb.System.from_text(STRUT).check(answer=answer, free_body=body)
    assert found.verdict == verdict, found.reason


CANTILEVER = """freebody: 1
title: Cantilever
parameters: {m: 2 kg, L: 1 m, g: 9.81 m/s^2, F: 5 N}
bodies:
  beam: {rod: {mass: m, length: L}, angle: 0}
connections:
  wall: {weld: [ground.A, beam.start]}
loads:
  weight: {gravity: g}
  push: {force: {at: beam.end, along: down, magnitude: F}}
"""


@pytest.mark.parametrize(
    ("answer", "verdict", "says"),
    [
        ("A at wall; moment M at wall; m g down at G; F down at end", "correct", ""),
        ("A_x right at wall; A_y up at wall; M clockwise at start; m g down at G; F down at push", "correct", ""),
        ("A_x right at wall; A_y up at wall; m g down at G; F down at end", "incorrect", "the moment of wall"),
        ("A_x right at wall; A_y up at G; M ccw at wall; m g down at G; F down at end", "incorrect", "line of action"),
        ("A at wall; moment M at wall; m g down at G; P down at end", "correct", ""),
        ("A at wall; moment M at wall; m g down at G; F up at end", "incorrect", "wrong sense for the load push"),
        ("A at wall; moment M at wall; m g down at G; 5 N down at end; F down at end", "incorrect", "extra"),
    ],
)
def test_a_clamp_has_two_forces_and_a_moment(answer: str, verdict: str, says: str) -> None:
    found = fb.System.from_text(CANTILEVER).check(answer=answer, free_body="beam")
    assert found.verdict == verdict, found.reason
    assert says in found.reason


BEAM = """freebody: 1
title: Cantilever in space
space: {up: z}
parameters: {m: 2 kg, L: 1 m, g: 9.81 m/s^2, F: 5 N, beta: 30 deg}
bodies:
  beam: {rod: {mass: m, length: L}}
  strut: {rod: {mass: 0, length: L}, turned: [-90 deg about y]}
connections:
  wall: {weld: {first: ground.A, second: beam.start}}
  top: {spherical: [beam.end, strut.start]}
loads:
  weight: {gravity: g}
  push: {force: {at: beam.end, along: y, magnitude: F}}
"""


@pytest.mark.parametrize(
    ("answer", "verdict", "says"),
    [
        ("A at wall; moment M any at wall; m g down at G; F +y at end; S at top", "correct", ""),
        # a force acts anywhere on its line, here the vertical through the mass centre and the line along y at the end
        ("A at wall; moment M any at wall; m g (0, 0, -1) at G; F +y at push; S at end", "correct", ""),
        ("A at wall; m g down at G; F +y at end; S at top", "incorrect", "the moment of wall is missing"),
        (
            "A at wall; moment M any at wall; m g down at G; F -y at end; S at top",
            "incorrect",
            "wrong sense for the load",
        ),
        ("A at wall; moment M any at wall; m g down at G; F +y at G; S at top", "incorrect", "line of action"),
        ("A at wall; moment M any at wall; m g down at G; F +y at end", "incorrect", "the force of top is missing"),
        ("A at wall; moment M any at wall; m g +y at G; F +y at end; S at top", "incorrect", "wrong direction"),
        (
            "A at wall; moment M any at wall; F +y at end; S at top; m g cos(beta) (0, sin(beta), -cos(beta)) at G; "
            "m g sin(beta) (0, -cos(beta), -sin(beta)) at G",
            "undecided",
            "seem to be components of the weight of beam",
        ),
    ],
)
def test_a_clamp_in_space_has_three_forces_and_three_moments(answer: str, verdict: str, says: str) -> None:
    """g (cos b (0, sin b, -cos b) + sin b (0, -cos b, -sin b)) = (0, 0, -g)."""
    found = fb.System.from_text(BEAM).check(answer=answer, free_body="beam")
    assert found.verdict == verdict, found.reason
    assert says in found.reason


def test_a_moment_that_a_joint_does_not_transmit_is_told_in_german() -> None:
    answer = "m g nach unten im Schwerpunkt; A bei hinge; Moment M beliebig bei hinge; M_y um y bei hinge"
    found = system("conical_pendulum").check(answer=answer, free_body="bob", language="de")
    assert found.reason == "„M_y um y bei hinge“ ist zu viel: hinge überträgt um diese Achse kein Moment"


HUB = """freebody: 1
title: Shaft with two cross pins
space: true
bodies:
  shaft: {body: {mass: 2 kg, inertia: [1, 1, 1]}, points: {left: [-1, 0, 0], right: [1, 0, 0]}}
  one: {body: {mass: 1 kg, inertia: [1, 1, 1]}}
  other: {body: {mass: 1 kg, inertia: [1, 1, 1]}}
connections:
  bearing: {revolute: {first: ground.O, second: shaft, about: x}}
  left: {revolute: {first: shaft.left, second: one, about: y}}
  right: {revolute: {first: shaft.right, second: other, about: z}}
"""


def test_a_couple_at_a_name_of_a_point_and_of_a_joint_is_that_of_the_joint() -> None:
    """A revolute about y transmits moments about x and z, one about z those about x and y: four on the shaft beside the
    bearing's two, each drawn once at its own joint, in any order."""
    moments = ["about y at right", "about x at right", "about x at left", "about z at left"]
    rest = "A at bearing; moment M any at bearing; L at left; R at right"
    drawn = "; ".join(f"M_{k} {one}" for k, one in enumerate(moments))
    found = fb.System.from_text(HUB).check(answer=f"{rest}; {drawn}", free_body="shaft")
    assert found.verdict == "correct", found.reason
    found = fb.System.from_text(HUB).check(
        answer=f"{rest}; {drawn.replace('about z at left', 'about y at left')}", free_body="shaft"
    )
    assert found.verdict == "incorrect"
    assert "left transmits no moment" in found.reason


# -- reading ----------------------------------------------------------------------------------
@pytest.mark.parametrize(
    ("text", "name", "way", "of", "place"),
    [
        ("N up at contact", "N", "compass", (), "contact"),
        ("N at contact to the left", "N", "compass", (), "contact"),
        ("F along incline at contact", "F", "along", ("incline",), "contact"),
        ("F up the incline at the contact", "F", "along", ("incline",), "contact"),
        ("T at 30 deg at A", "T", "angle", ("30 deg",), "A"),
        ("F (cos(alpha), sin(alpha)) at A", "F", "components", ("cos(alpha)", "sin(alpha)"), "A"),
        ("S in Richtung B bei A", "S", "towards", ("B",), "A"),
        ("N senkrecht zu ebene im Punkt A", "N", "normal", ("ebene",), "A"),
        ("T down at left", "T", "compass", (), "left"),
        ("M about x at A", "M", "about", ("x",), "A"),
        ("M about -z axis at A", "M", "about", ("-z",), "A"),
        ("M um die Achse von lager bei A", "M", "about", ("Achse von lager",), "A"),
        ("F (a, b, c) at A", "F", "components", ("a", "b", "c"), "A"),
        ("F in +z direction at A", "F", "compass", (), "A"),
    ],
)
def test_entries_are_read(text: str, name: str, way: str, of: tuple[str, ...], place: str) -> None:
    [found] = read_forces(text)
    assert (found.name, found.way, found.of, found.place) == (name, way, of, place)


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("N up towards B at A", "two directions"),
        ("N up left at A", "two directions"),
        ("N at A up, F at A right", "two points"),
        ("M clockwise up at A", "is a moment"),
        ("; ;", "empty"),
    ],
)
def test_what_is_no_one_force_is_refused(text: str, told: str) -> None:
    with pytest.raises(ExpressionError, match=told):
        read_forces(text)


# -- the faces --------------------------------------------------------------------------------
def test_a_body_that_there_is_not_is_refused() -> None:
    with pytest.raises(InputError, match="there is no body blok"):
        system("block_on_rough_incline").check(answer="N up", free_body="blok")


def test_the_command_tells_the_verdict() -> None:
    file = str(EXAMPLES / "atwood_machine.yaml")
    ran = freebody("check", file, "--free-body", "left", "--answer", "T up", "--json")
    assert ran.returncode == 1
    found = json.loads(ran.stdout)
    found = found.get("result", found)
    assert found["verdict"] == "incorrect"
    assert found["reason"] == "the weight of left is missing"
    assert found["reading"]["expression"] == ["T up"]
    assert freebody("check", file, "--free-body", "left", "--answer", "T up; m1 g down").returncode == 0


def test_in_german() -> None:
    found = system("atwood_machine").check(answer="T nach oben", free_body="left", language="de")
    assert found.reason == "es fehlt: das Gewicht von left"


# -- what the table says of itself ------------------------------------------------------------
ALL = [path.stem for path in sorted(EXAMPLES.glob("*.yaml"))]


def written(acting: Acting, k: int, sense: float = 1.0) -> str:
    """A force of the table, as somebody would type it."""
    vector = ", ".join(f"{x:.12f}" for x in sense * acting.way)
    if len(acting.moment) == 3:
        return f"{'moment ' if acting.is_couple else ''}Z_{k} ({vector}) at {acting.source}"
    if acting.is_couple:
        turn = "counterclockwise" if acting.moment[0] * sense > 0 else "clockwise"
        return f"Z_{k} moment {turn} at {acting.source}"
    return f"Z_{k} ({vector}) at {acting.source}"


@pytest.mark.parametrize("example", ALL)
def test_what_acts_is_correct_and_neither_less_nor_against_it(example: str) -> None:
    for body in system(example).moving:
        free = free_bodies(system(example), (body.name,))
        acting, wrong = free.outside, "undecided" if free.summed else "incorrect"
        entries = [written(a, k) for k, a in enumerate(acting)]
        if not entries:
            continue
        assert verdict_of(example, body.name, entries) == "correct", entries
        for k, a in enumerate(acting):
            if a.is_known and not any(is_either_way(a, b) for b in acting):
                turned = [*entries[:k], written(a, k, -1.0), *entries[k + 1 :]]
                assert verdict_of(example, body.name, turned) == wrong, turned
            others = [b for b in acting if b is not a and b.source == a.source]
            if a.is_needed and not others and len(entries) > 1:
                assert verdict_of(example, body.name, [e for e in entries if e != entries[k]]) == wrong


def is_either_way(a: Acting, b: Acting) -> bool:
    """Whether b is of the connection of a, along it, with either sense: of entries that name no line but the connection
    one is a and one b, whichever is which. So pulls a rope level at a sheave, while what hangs on it is kept below the
    sheave as that travels."""
    if b.is_known or b.source != a.source or b.is_couple != a.is_couple:
        return False
    return bool(np.allclose(abs(a.way @ b.way), 1.0))


def verdict_of(example: str, body: str, entries: list[str]) -> str:
    return system(example).check(answer="; ".join(entries), free_body=body).verdict
