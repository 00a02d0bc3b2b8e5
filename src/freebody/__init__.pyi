"""What the package has, for editors and type checkers. Written by tools/write_interface.py."""

from collections.abc import Mapping, Sequence
from typing import Any

from freebody.language.expression import Expr
from freebody.language.written import Written
from freebody.model.spec import Formula, Heading
from freebody.api import System as System
from freebody.budgets import effort as effort
from freebody.building import Model as Model
from freebody.connections.belt import Belt as _Belt
from freebody.connections.brake import Brake as _Brake
from freebody.connections.brake import FrictionAlongMeasure as _FrictionAlongMeasure
from freebody.connections.constant_velocity import ConstantVelocity as _ConstantVelocity
from freebody.connections.constraint import Constraint as _Constraint
from freebody.connections.constraint import VelocityConstraint as _VelocityConstraint
from freebody.connections.contact import Contact as _Contact
from freebody.connections.cylindrical import Cylindrical as _Cylindrical
from freebody.connections.driver import Driver as _Driver
from freebody.connections.gear_mesh import GearMesh as _GearMesh
from freebody.connections.gear_pair import GearPair as _GearPair
from freebody.connections.link import Link as _Link
from freebody.connections.pin import Pin as _Pin
from freebody.connections.planar import Planar as _Planar
from freebody.connections.point_on_line import PointOnLine as _PointOnLine
from freebody.connections.point_on_line import PointOnPlane as _PointOnPlane
from freebody.connections.prismatic import Prismatic as _Prismatic
from freebody.connections.rack_and_pinion import RackAndPinion as _RackAndPinion
from freebody.connections.revolute import Revolute as _Revolute
from freebody.connections.rolling import Rolling as _Rolling
from freebody.connections.screw import Screw as _Screw
from freebody.connections.slider import Slider as _Slider
from freebody.connections.slot import Slot as _Slot
from freebody.connections.spherical import Spherical as _Spherical
from freebody.connections.stop import Stop as _Stop
from freebody.connections.string.connection import String as _String
from freebody.connections.universal import Universal as _Universal
from freebody.connections.weld import Weld as _Weld
from freebody.errors import CannotAnswer as CannotAnswer
from freebody.errors import FreebodyError as FreebodyError
from freebody.errors import InputError as InputError
from freebody.errors import ModelError as ModelError
from freebody.errors import RoutesDisagree as RoutesDisagree
from freebody.loads.angular_impulse import AngularImpulse as _AngularImpulse
from freebody.loads.force import Force as _Force
from freebody.loads.gravity import Gravity as _Gravity
from freebody.loads.impulse import Impulse as _Impulse
from freebody.loads.law import Law as _Law
from freebody.loads.spring import Damper as _Damper
from freebody.loads.spring import Spring as _Spring
from freebody.loads.spring import TorsionalDamper as _TorsionalDamper
from freebody.loads.spring import TorsionalSpring as _TorsionalSpring
from freebody.loads.torque import Torque as _Torque
from freebody.model.shapes.composite import Composite as _Composite
from freebody.model.shapes.given import Body as _Body
from freebody.model.shapes.round import Cone as _Cone
from freebody.model.shapes.round import Cylinder as _Cylinder
from freebody.model.shapes.round import Disk as _Disk
from freebody.model.shapes.round import Ring as _Ring
from freebody.model.shapes.round import Sphere as _Sphere
from freebody.model.shapes.straight import Box as _Box
from freebody.model.shapes.straight import Particle as _Particle
from freebody.model.shapes.straight import Polygon as _Polygon
from freebody.model.shapes.straight import Rectangle as _Rectangle
from freebody.model.shapes.straight import Rod as _Rod
from freebody.narrative.explain import explain as explain
from freebody.narrative.marking.check import check as check
from freebody.numeric.options import SimulationOptions as SimulationOptions
from freebody.study.answering.answer import Answer as Answer
from freebody.study.answering.solution import Solution as Solution
from freebody.study.answering.solve import solve as solve
from freebody.study.conservation.conservation import Conservation as Conservation
from freebody.study.conservation.conserved import conserved as conserved
from freebody.study.eom import Equations as Equations
from freebody.study.eom import equations_of_motion as equations_of_motion
from freebody.study.fitting.fit import fit as fit
from freebody.study.fitting.result import Fit as Fit
from freebody.study.friction.report import Statics as Statics
from freebody.study.friction.report import statics as statics
from freebody.study.inverse_dynamics import inverse_dynamics as inverse_dynamics
from freebody.study.mobility.found import Mobility as Mobility
from freebody.study.mobility.mobility import mobility as mobility
from freebody.study.over_a_turn import over_a_turn as over_a_turn
from freebody.study.phases.result import phases as phases
from freebody.study.pictures.picture import draw as draw
from freebody.study.pictures.picture import free_body as free_body
from freebody.study.pictures.picture import picture as picture
from freebody.study.sensitivity.local import Gradient as Gradient
from freebody.study.sensitivity.local import gradient as gradient
from freebody.study.sensitivity.sensitivity import Sensitivity as Sensitivity
from freebody.study.sensitivity.sensitivity import sensitivity as sensitivity
from freebody.study.simulation.simulate import Simulation as Simulation
from freebody.study.simulation.simulate import simulate as simulate
from freebody.study.simulation.simulator import Simulator as Simulator
from freebody.study.small_motion.equilibrium import equilibria as equilibria
from freebody.study.small_motion.modes import modes as modes
from freebody.study.sweeps.result import Sweep as Sweep
from freebody.study.sweeps.sweep import sweep as sweep

_Text = str | Written
_Formula = Formula | Expr
_Along = Heading | Expr | Written | Sequence[_Formula]
_List = Sequence[Any]
_Mapping = Mapping[str, Any]

__version__: str

class AngularImpulse(_AngularImpulse):
    """`angular_impulse: {on: wheel, magnitude: H}`, counter-clockwise positive, at the start or with `when: x = d` in
    mid-motion; `reacts_on` and `about` as of a torque."""

    def __init__(
        self,
        on: _Text,
        magnitude: _Formula,
        reacts_on: _Text = ...,
        about: _Along | None = ...,
        when: _Text = ...,
    ) -> None: ...

class Belt(_Belt):
    """`belt: [motor, drum]`, `belt: {first: motor, second: drum, crossed: true}`. An open belt turns both pulleys
    the same way, a crossed one opposite ways; bearings or a carrier keep the centres apart. The belt force is the
    difference of the tensions of its two runs (their sum is the pretension, which the motion does not fix),
    positive when it resists a counter-clockwise turn of the first pulley (1 row)."""

    def __init__(
        self,
        first: _Text,
        second: _Text,
        crossed: bool = ...,
        first_radius: _Formula | None = ...,
        second_radius: _Formula | None = ...,
    ) -> None: ...

class Body(_Body):
    """A body given by mass, moment of inertia about its mass centre, and the mass centre's place in the body's
    own frame, whose origin is the reference point `origin`. A `radius` makes its rim a circle about the origin.

    In space `inertia` is the three moments about its axes, [Ixx, Iyy, Izz], or the tensor as three rows, about the mass
    centre, or `about: origin`, or another place by components."""

    def __init__(
        self,
        mass: _Formula = ...,
        inertia: _Formula | _List = ...,
        center_of_mass: _List | None = ...,
        radius: _Formula | None = ...,
        about: _Formula | _List = ...,
    ) -> None: ...

class Box(_Box):
    """A homogeneous block with the sides `size: [a, b, c]` along its x, y and z; I_x = m (b^2 + c^2)/12. Points: the
    middles of its faces, `left`, `right` (x), `bottom`, `top` (y), `back`, `front` (z). For models in space."""

    def __init__(
        self,
        mass: _Formula = ...,
        size: _List = ...,
    ) -> None: ...

class Brake(_Brake):
    """`brake: {between: [drum, ground], torque: T}`: dry friction against a relative turn; a clutch is one between two
    bodies that turn. torque: the largest torque, a formula in parameters, time `t` and named measures, or
    {static: ..., kinetic: ...}."""

    def __init__(
        self,
        between: _List,
        torque: _Formula | _Mapping,
    ) -> None: ...

class Composite(_Composite):
    """`composite: {parts: {hub: {disk: {mass: M, radius: R}}, arm: {rod: {mass: m, length: L}, at: [R, 0]}}}`: every
    part is a shape whose reference point stands at `at` in the body's own frame, turned by `angle`, or, in space, by
    `turned`. Points: `origin`, and the reference point of every part by its name."""

    def __init__(
        self,
        parts: _Mapping,
    ) -> None: ...

class Cone(_Cone):
    """A homogeneous cone from its `apex` along its `axis` (z) to the middle of its `base`, its mass centre at three
    quarters of the height: I = 3/10 m R^2 about the axis, 3/80 m (4 R^2 + h^2) across, about the mass centre. The
    reference point is the apex. For models in space."""

    def __init__(
        self,
        mass: _Formula = ...,
        radius: _Formula = ...,
        height: _Formula = ...,
        axis: _Along = ...,
    ) -> None: ...

class ConstantVelocity(_ConstantVelocity):
    """`constant_velocity: {first: drive.end, second: wheel.hub, about: z}`: the shafts meet in a point and turn equally
    fast (4 rows)."""

    def __init__(
        self,
        first: _Text,
        second: _Text,
        about: _Along,
        second_axis: _Along | None = ...,
    ) -> None: ...

class Constraint(_Constraint):
    """`constraint: x - 2*y`: an expression in named measures, held at zero (1 row, holonomic)."""

    def __init__(
        self,
        expression: _Text,
    ) -> None: ...

class Contact(_Contact):
    """`contact: {between: [ball, ground.floor], friction: mu, restitution: e}`; `among: [a, b, floor]` for every pair
    of several, `among: all` for all bodies and lines of the ground.

    What touches is named by a body (its circle, or its straight edges and corners), a point, a line (solid on the
    right of its direction, so below one that points to the right; `below: true` for the other side), or `inside bowl`
    for the inside of a ring. friction: one coefficient, or {static: 0.5, kinetic: 0.4}; restitution between 0 (default)
    and 1; rolling_resistance: the arm of the normal force [m]. A contact whose bodies have no place (`at`) starts
    touching, and `touching: true` moves the bodies there, or out of each other, by the least; `touching: false` leaves
    them where they are."""

    def __init__(
        self,
        between: _List | None = ...,
        among: _Text | _List | None = ...,
        friction: _Formula | _Mapping = ...,
        restitution: _Formula = ...,
        rolling_resistance: _Formula = ...,
        touching: bool | None = ...,
        below: bool = ...,
    ) -> None: ...

class Cylinder(_Cylinder):
    """A homogeneous cylinder about its `axis` (z): I = m R^2/2 about it, m (3 R^2 + L^2)/12 across. Points `start`,
    `end`: the middles of its ends. For models in space."""

    def __init__(
        self,
        mass: _Formula = ...,
        radius: _Formula = ...,
        length: _Formula = ...,
        axis: _Along = ...,
    ) -> None: ...

class Cylindrical(_Cylindrical):
    """`cylindrical: {first: ground.A, second: collar, about: x}`: the second point stays on the axis through the first,
    and the axes stay parallel (4 rows)."""

    def __init__(
        self,
        first: _Text,
        second: _Text,
        about: _Along,
        second_axis: _Along | None = ...,
    ) -> None: ...

class Damper(_Damper):
    """`damper: {first: ground.A, second: block, damping: c}`: pulls with c dl/dt."""

    def __init__(
        self,
        first: _Text,
        second: _Text,
        damping: _Formula,
    ) -> None: ...

class Disk(_Disk):
    """A uniform disk (or cylinder, pulley, gear wheel); I = m R^2/2 unless `inertia` is given. In space it is thin,
    about its `axis` (z), with half of that inertia about its diameters."""

    def __init__(
        self,
        mass: _Formula = ...,
        radius: _Formula | None = ...,
        inertia: _Formula | None = ...,
        axis: _Along = ...,
    ) -> None: ...

class Driver(_Driver):
    """`driver: {measure: theta, follows: omega*t}`. The driving force or torque does positive work when it pushes
    the measure up (1 row)."""

    def __init__(
        self,
        measure: _Mapping,
        follows: _Formula,
    ) -> None: ...

class Force(_Force):
    """`force: {at: rod.end, along: right, magnitude: F}`. The magnitude may depend on time `t` and on named
    measures and their rates; `along: rod.y` turns with the rod."""

    def __init__(
        self,
        at: _Text,
        along: _Along,
        magnitude: _Formula,
    ) -> None: ...

class FrictionAlongMeasure(_FrictionAlongMeasure):
    """`dry_friction: {measure: x, force: F}`: a Coulomb force (a torque for an angle) of a given size that resists
    the rate of a measure, and holds it where it can. force: as the torque of a brake."""

    def __init__(
        self,
        measure: _Mapping,
        force: _Formula | _Mapping,
    ) -> None: ...

class GearMesh(_GearMesh):
    """`gear_mesh: [sun, planet]`, `gear_mesh: {first: ring, second: planet, internal: true}` with the ring gear
    first. The tooth force acts along the common tangent of the pitch circles (pressure angle 0) and is positive
    when it resists a counter-clockwise turn of the first gear. The distance of the centres is held too where no
    carrier or bearing holds it already (1 or 2 rows). `first_radius`, `second_radius` for a wheel with several
    gears on it."""

    def __init__(
        self,
        first: _Text,
        second: _Text,
        internal: bool = ...,
        first_radius: _Formula | None = ...,
        second_radius: _Formula | None = ...,
    ) -> None: ...

class GearPair(_GearPair):
    """`gear_pair: {first: pinion, second: crown, on: carrier, first_axis: x, second_axis: y, ratio: -1/3}`: the second
    wheel turns `ratio` times as fast as the first, both seen from the body that carries their bearings (`on`, default
    the ground), right-handed about their axes, given by components on that body. `teeth: [z1, z2]` for bevel gears
    whose axes point away from where they meet: ratio -z1/z2. The teeth react on the carrier too (1 row)."""

    def __init__(
        self,
        first: _Text,
        second: _Text,
        first_axis: _Along,
        second_axis: _Along,
        on: _Text = ...,
        ratio: _Formula | None = ...,
        teeth: _List | None = ...,
    ) -> None: ...

class Gravity(_Gravity):
    """`gravity: g`, `gravity: {strength: g, along: down}`. Pushes each mass centre with m g."""

    def __init__(
        self,
        strength: _Formula,
        along: _Along = ...,
    ) -> None: ...

class Impulse(_Impulse):
    """`impulse: {at: rod.end, along: right, magnitude: J}`: at the start the point is struck. The section `start` says
    how everything moves just before; what is asked at the start is so just after. With `when: x = d` it is struck in
    mid-motion, the first time that x reaches d."""

    def __init__(
        self,
        at: _Text,
        along: _Along,
        magnitude: _Formula,
        when: _Text = ...,
    ) -> None: ...

class Law(_Law):
    """`law: {measure: stretch, force: -k*stretch^3}`: the force (or torque, for an angle) in the direction in
    which the measure grows, as an expression in measures, their rates (`rate(x)`) and time `t`."""

    def __init__(
        self,
        measure: _Mapping,
        force: _Formula,
    ) -> None: ...

class Link(_Link):
    """`link: [ground.A, bob, L]`; without a length, the distance at the start. The force in
    it is positive when it pulls (1 row)."""

    def __init__(
        self,
        first: _Text,
        second: _Text,
        length: _Formula | None = ...,
    ) -> None: ...

class Particle(_Particle):
    """A point mass; it has no angle."""

    def __init__(
        self,
        mass: _Formula = ...,
    ) -> None: ...

class Pin(_Pin):
    """`pin: [ground.A, rod.start]`. Holds r_second - r_first = 0 (2 rows). `friction` with the `radius` of the journal:
    the torque that resists is mu r times the force in the pin."""

    def __init__(
        self,
        first: _Text,
        second: _Text,
        friction: _Formula | _Mapping = ...,
        radius: _Formula | None = ...,
    ) -> None: ...

class Planar(_Planar):
    """`planar: {body: plate}`: its reference point stays in the plane through `through` (the ground's origin) across
    the `normal` (z), about which it may turn (3 rows; 1 for a particle). Connections of the plane, such as pin, slider,
    string or contact, may join bodies that stay in the plane of x and y."""

    def __init__(
        self,
        body: _Text,
        through: _Text = ...,
        normal: _Along = ...,
        second_axis: _Along | None = ...,
    ) -> None: ...

class PointOnLine(_PointOnLine):
    """`point_on_line: {point: shaft.B, through: ground.A, along: x}`: a point stays on the line through a point of
    another body, along a direction of that body; a bearing that holds across its axis alone (2 rows)."""

    def __init__(
        self,
        point: _Text,
        through: _Text,
        along: _Along,
    ) -> None: ...

class PointOnPlane(_PointOnPlane):
    """`point_on_plane: {point: leg.foot, on: ground.floor}`: a point stays in a plane of another body, without friction
    (1 row)."""

    def __init__(
        self,
        point: _Text,
        on: _Text,
    ) -> None: ...

class Polygon(_Polygon):
    """A uniform plate with straight edges; corners in order (either way round) in the body's own frame,
    whose origin is the reference point `origin`; points `corner1`, `corner2` ... Area, centroid and polar
    second moment by the shoelace formulas (Green's theorem)."""

    def __init__(
        self,
        mass: _Formula = ...,
        corners: _List = ...,
    ) -> None: ...

class Prismatic(_Prismatic):
    """`prismatic: {first: ground.A, second: block, along: x}`: the second point stays on the line through the first,
    and the bodies keep their attitude to each other (5 rows)."""

    def __init__(
        self,
        first: _Text,
        second: _Text,
        along: _Along,
        second_axis: _Along | None = ...,
    ) -> None: ...

class RackAndPinion(_RackAndPinion):
    """`rack_and_pinion: {pinion: gear, rack: bar, along: right}`; the rack's teeth run `along` (a direction
    fixed in the rack; without it, along the guide of the rack or, where that is fixed, of the pinion; else to the
    rack's right). The rack is below the pinion for a direction to the right, to its right for one that goes up, unless
    the places of the two say otherwise; `above: true` puts it on the other side. Bearings hold the distance (1 row).
    The tooth force is positive when it drives the rack along its direction."""

    def __init__(
        self,
        pinion: _Text,
        rack: _Text,
        along: _Along | None = ...,
        above: bool | None = ...,
        radius: _Formula | None = ...,
    ) -> None: ...

class Rectangle(_Rectangle):
    """A uniform rectangular plate or block; I = m (w^2 + h^2)/12. Points: the corners `bottom_left` ...
    and the middles `left`, `right`, `top`, `bottom` of its sides. A side that is left out is zero, unless one of
    these points is used."""

    def __init__(
        self,
        mass: _Formula = ...,
        width: _Formula | None = ...,
        height: _Formula | None = ...,
    ) -> None: ...

class Revolute(_Revolute):
    """`revolute: {first: ground.A, second: rod.start, about: z}`: the axis on the first body, on the second one
    `second_axis` (the same components). Holds the points and the direction of the axis (5 rows)."""

    def __init__(
        self,
        first: _Text,
        second: _Text,
        about: _Along,
        second_axis: _Along | None = ...,
    ) -> None: ...

class Ring(_Ring):
    """A thin ring or hoop; I = m R^2 unless `inertia` is given. Wheels may run on its inside."""

    def __init__(
        self,
        mass: _Formula = ...,
        radius: _Formula | None = ...,
        inertia: _Formula | None = ...,
        axis: _Along = ...,
    ) -> None: ...

class Rod(_Rod):
    """A slender uniform rod from `start` to `end`, along its own x axis; I = m L^2/12."""

    def __init__(
        self,
        mass: _Formula = ...,
        length: _Formula | None = ...,
    ) -> None: ...

class Rolling(_Rolling):
    """`rolling: {body: disk, on: ground.incline}`; `on` a line or a round body, or `inside` a ring. Holds the
    gap and the slip (2 rows). The circle lies on the left of the line as its direction points, which is above it
    for a line that points to the right; `below: true` puts it on the other side. `radius` where it rolls on another
    circle than its rim (the hub of a spool on a rail).

    On a line, with s the travel of the centre along it: slip = d(s + R theta)/dt.

    In space: `on` a plane, of the rim of a disk, a sphere or a cone (3 rows; a cone 5)."""

    def __init__(
        self,
        body: _Text,
        on: _Text | None = ...,
        inside: _Text | None = ...,
        below: bool = ...,
        radius: _Formula | None = ...,
    ) -> None: ...

class Screw(_Screw):
    """`screw: {first: ground.A, second: nut, about: x, pitch: 2 mm}`: a cylindrical joint in which a turn of the second
    body moves it by the pitch along the axis (5 rows). A negative pitch is a left-hand thread."""

    def __init__(
        self,
        first: _Text,
        second: _Text,
        about: _Along,
        pitch: _Formula,
        second_axis: _Along | None = ...,
    ) -> None: ...

class Slider(_Slider):
    """`slider: {body: block, along: right}`; `on` is the guiding body (default the ground), `through` a point
    of the guide. Holds the displacement across the guide and the angle (2 rows).
    `friction`: the force that resists is mu times the normal force."""

    def __init__(
        self,
        body: _Text,
        along: _Along,
        on: _Text = ...,
        through: _Text | None = ...,
        friction: _Formula | _Mapping = ...,
    ) -> None: ...

class Slot(_Slot):
    """`slot: {pin: rod.end, along: up}`; `on` is the slotted body (default the ground), `through` a point of
    the slot's centre line. Holds the displacement across the slot (1 row). `friction`: the force that resists is mu
    times the normal force."""

    def __init__(
        self,
        pin: _Text,
        along: _Along,
        on: _Text = ...,
        through: _Text | None = ...,
        friction: _Formula | _Mapping = ...,
    ) -> None: ...

class Sphere(_Sphere):
    """A homogeneous ball; I = 2/5 m R^2 about any axis through its centre."""

    def __init__(
        self,
        mass: _Formula = ...,
        radius: _Formula | None = ...,
    ) -> None: ...

class Spherical(_Spherical):
    """`spherical: [ground.A, rod.start]`. Holds r_second - r_first = 0 (3 rows)."""

    def __init__(
        self,
        first: _Text,
        second: _Text,
    ) -> None: ...

class Spring(_Spring):
    """`spring: {first: ground.A, second: block, stiffness: k, length: l0}`: pulls with k (l - l0); without a
    natural length it is relaxed at the start. One of length 0 pulls with k r, also through the point itself."""

    def __init__(
        self,
        first: _Text,
        second: _Text,
        stiffness: _Formula,
        length: _Formula | None = ...,
    ) -> None: ...

class Stop(_Stop):
    """`stop: {measure: theta, min: 0, max: 60 deg, restitution: 0.3}`: min <= measure <= max; one of the two may be
    left out."""

    def __init__(
        self,
        measure: _Mapping,
        min: _Formula | None = ...,
        max: _Formula | None = ...,
        restitution: _Formula = ...,
    ) -> None: ...

class String(_String):
    """`string: {from: left, over: [pulley], to: right}`; longer ways as a list, with hubs and drums:
    `string: {path: [wound on drum radius r at right, under moving, over fixed, ground.A]}`.

    The string does not slip on the pulleys that it `grips` (default: all that are bodies); over the others it
    slides without friction. Each stretch between grips keeps its length and has one tension, positive when it
    pulls. A body that nothing else holds hangs on the string and moves up and down, below the point where its lead
    leaves the pulley, if it has no position or is put there; a lead to a body on a straight guide runs along the
    guide if the body has no position, or one from which it does so whatever the parameters are; `leads` states the
    directions instead; otherwise leads are the common tangents of the circles, wherever these move (`swings: true`
    also for hanging bodies).
    `friction`: that of the drums and pulleys over which it slides, one coefficient or {drum: mu}. The tensions on both
    sides of a drum differ by up to e^(mu beta), beta the angle of wrap between leads with constant directions, or
    `wrap: {drum: 3*pi}`; ask for the tension at an end, or between two places."""

    def __init__(
        self,
        start: _Text | None = ...,
        to: _Text | None = ...,
        over: _List = ...,
        under: _List = ...,
        path: _List = ...,
        grips: _List | None = ...,
        leads: _List | None = ...,
        swings: bool = ...,
        friction: _Formula | _Mapping = ...,
        wrap: _Formula | _Mapping | None = ...,
    ) -> None: ...

class Torque(_Torque):
    """`torque: {on: sun, magnitude: T}`, counter-clockwise positive; `reacts_on: arm` where the motor sits on a
    body, which feels the opposite torque. In space `about` says the axis: a direction fixed in the ground, or in a body
    (`about: rotor.x`)."""

    def __init__(
        self,
        on: _Text,
        magnitude: _Formula,
        reacts_on: _Text = ...,
        about: _Along | None = ...,
    ) -> None: ...

class TorsionalDamper(_TorsionalDamper):
    """`torsional_damper: {body: rod, damping: c, on: ground}`: resists with c dtheta/dt. In space
    theta is the turn `about` an axis of the body that it is on."""

    def __init__(
        self,
        body: _Text,
        damping: _Formula,
        on: _Text = ...,
        about: _Along | None = ...,
    ) -> None: ...

class TorsionalSpring(_TorsionalSpring):
    """`torsional_spring: {body: rod, stiffness: k, on: ground, angle: 0}`: turns the body back with
    k (theta - angle). In space theta is the turn `about` an axis of the body that it is on."""

    def __init__(
        self,
        body: _Text,
        stiffness: _Formula,
        on: _Text = ...,
        angle: _Formula = ...,
        about: _Along | None = ...,
    ) -> None: ...

class Universal(_Universal):
    """`universal: {first: ground.A, second: shaft.start, arm: x, second_arm: y}`: a cross with two perpendicular arms,
    one in each yoke: `arm` by components on the first body, `second_arm` on the second. Holds the points and the right
    angle between the arms (4 rows)."""

    def __init__(
        self,
        first: _Text,
        second: _Text,
        arm: _Along,
        second_arm: _Along,
    ) -> None: ...

class VelocityConstraint(_VelocityConstraint):
    """`velocity_constraint: rate(y)*cos(theta) - rate(x)*sin(theta)`: an expression linear in the rates of
    named measures, held at zero (1 row; nonholonomic unless it can be integrated)."""

    def __init__(
        self,
        expression: _Text,
    ) -> None: ...

class Weld(_Weld):
    """`weld: [ground.A, beam.start]`. Two points coincide and the angle between the bodies stays as it is at
    the start (3 rows). In space the second body is `turned` from the first by known rotations, such as [30 deg about
    x], and parallel to it without any (6 rows)."""

    def __init__(
        self,
        first: _Text,
        second: _Text,
        turned: _List | None = ...,
    ) -> None: ...
