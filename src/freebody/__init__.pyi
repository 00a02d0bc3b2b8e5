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
from freebody.connections.bevel_gears import BevelGears as _BevelGears
from freebody.connections.brake import Brake as _Brake
from freebody.connections.brake import FrictionAlongMeasure as _FrictionAlongMeasure
from freebody.connections.cam import Cam as _Cam
from freebody.connections.chain import Chain as _Chain
from freebody.connections.clothoid import Clothoid as _Clothoid
from freebody.connections.constant_velocity import ConstantVelocity as _ConstantVelocity
from freebody.connections.constraint import Constraint as _Constraint
from freebody.connections.constraint import VelocityConstraint as _VelocityConstraint
from freebody.connections.contact import Contact as _Contact
from freebody.connections.curved_rail import CurvedRail as _CurvedRail
from freebody.connections.cylindrical import Cylindrical as _Cylindrical
from freebody.connections.disc_clutch import DiscClutch as _DiscClutch
from freebody.connections.driver import Driver as _Driver
from freebody.connections.gear_mesh import GearMesh as _GearMesh
from freebody.connections.gear_pair import GearPair as _GearPair
from freebody.connections.hanging_cable import HangingCable as _HangingCable
from freebody.connections.heavy_rope import HeavyRope as _HeavyRope
from freebody.connections.helical_gears import HelicalGears as _HelicalGears
from freebody.connections.link import Link as _Link
from freebody.connections.pin import Pin as _Pin
from freebody.connections.planar import Planar as _Planar
from freebody.connections.point_on_line import PointOnLine as _PointOnLine
from freebody.connections.point_on_line import PointOnPlane as _PointOnPlane
from freebody.connections.point_on_surface import PointOnSurface as _PointOnSurface
from freebody.connections.prismatic import Prismatic as _Prismatic
from freebody.connections.rack_and_pinion import RackAndPinion as _RackAndPinion
from freebody.connections.revolute import Revolute as _Revolute
from freebody.connections.rolling import Rolling as _Rolling
from freebody.connections.rolling_on_curve import RollingOnCurve as _RollingOnCurve
from freebody.connections.rolling_on_surface import RollingOnSurface as _RollingOnSurface
from freebody.connections.screw import Screw as _Screw
from freebody.connections.slider import Slider as _Slider
from freebody.connections.slot import Slot as _Slot
from freebody.connections.spherical import Spherical as _Spherical
from freebody.connections.stop import Stop as _Stop
from freebody.connections.string.connection import String as _String
from freebody.connections.universal import Universal as _Universal
from freebody.connections.weld import Weld as _Weld
from freebody.connections.worm_gear import WormGear as _WormGear
from freebody.errors import CannotAnswer as CannotAnswer
from freebody.errors import FreebodyError as FreebodyError
from freebody.errors import InputError as InputError
from freebody.errors import ModelError as ModelError
from freebody.errors import RoutesDisagree as RoutesDisagree
from freebody.errors import SelfTestFailed as SelfTestFailed
from freebody.exercises.export import export as export
from freebody.functions import acos as acos
from freebody.functions import asin as asin
from freebody.functions import atan as atan
from freebody.functions import cos as cos
from freebody.functions import exp as exp
from freebody.functions import log as log
from freebody.functions import sin as sin
from freebody.functions import sqrt as sqrt
from freebody.functions import tan as tan
from freebody.loads.angular_impulse import AngularImpulse as _AngularImpulse
from freebody.loads.attraction import Attraction as _Attraction
from freebody.loads.buoyancy import Buoyancy as _Buoyancy
from freebody.loads.distributed import Distributed as _Distributed
from freebody.loads.drag import Drag as _Drag
from freebody.loads.elastic_string import ElasticString as _ElasticString
from freebody.loads.elastic_string import TensionedString as _TensionedString
from freebody.loads.force import Force as _Force
from freebody.loads.gravity import Gravity as _Gravity
from freebody.loads.impulse import Impulse as _Impulse
from freebody.loads.law import Law as _Law
from freebody.loads.motor import Motor as _Motor
from freebody.loads.spring import Damper as _Damper
from freebody.loads.spring import Spring as _Spring
from freebody.loads.spring import TorsionalDamper as _TorsionalDamper
from freebody.loads.spring import TorsionalSpring as _TorsionalSpring
from freebody.loads.torque import Torque as _Torque
from freebody.model.shapes.box import Box as _Box
from freebody.model.shapes.composite import Composite as _Composite
from freebody.model.shapes.cone import Cone as _Cone
from freebody.model.shapes.convex import Convex as _Convex
from freebody.model.shapes.cylinder import Cylinder as _Cylinder
from freebody.model.shapes.disk import Disk as _Disk
from freebody.model.shapes.ellipsoid import Ellipsoid as _Ellipsoid
from freebody.model.shapes.frustum import Frustum as _Frustum
from freebody.model.shapes.gear import Gear as _Gear
from freebody.model.shapes.given import Body as _Body
from freebody.model.shapes.hemisphere import Hemisphere as _Hemisphere
from freebody.model.shapes.hemisphere import HemisphericalShell as _HemisphericalShell
from freebody.model.shapes.hollow import Annulus as _Annulus
from freebody.model.shapes.hollow import HollowCylinder as _HollowCylinder
from freebody.model.shapes.hollow import HollowSphere as _HollowSphere
from freebody.model.shapes.hollow import SphericalShell as _SphericalShell
from freebody.model.shapes.mesh import Mesh as _Mesh
from freebody.model.shapes.particle import Particle as _Particle
from freebody.model.shapes.polygon import Polygon as _Polygon
from freebody.model.shapes.rectangle import Rectangle as _Rectangle
from freebody.model.shapes.ring import Ring as _Ring
from freebody.model.shapes.rod import Rod as _Rod
from freebody.model.shapes.rope import Rope as _Rope
from freebody.model.shapes.sector import Arc as _Arc
from freebody.model.shapes.sector import HalfDisk as _HalfDisk
from freebody.model.shapes.sector import HalfRing as _HalfRing
from freebody.model.shapes.sector import Sector as _Sector
from freebody.model.shapes.sphere import Sphere as _Sphere
from freebody.model.shapes.wedge import Wedge as _Wedge
from freebody.narrative.explain import explain as explain
from freebody.narrative.marking.check import check as check
from freebody.narrative.synthesised import synthesise as synthesise
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
from freebody.study.optimising.optimise import optimise as optimise
from freebody.study.optimising.result import Optimum as Optimum
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
from freebody.study.speed_table import speed_table as speed_table
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
    mid-motion; `reacts_on`, `about` and `clockwise` as of a torque."""

    def __init__(
        self,
        on: _Text,
        magnitude: _Formula,
        reacts_on: _Text = ...,
        about: _Along | None = ...,
        when: _Text = ...,
        clockwise: bool = ...,
    ) -> None: ...

class Annulus(_Annulus):
    """`annulus: {mass: m, radius: R, inner_radius: r}`: a uniform disk with a round hole in its middle (thick pipe,
    flange); I = m (R^2 + r^2)/2. Wheels may run on its outside. In space it is thin, about its `axis` (z)."""

    def __init__(
        self,
        mass: _Formula = ...,
        radius: _Formula = ...,
        inner_radius: _Formula = ...,
        axis: _Along = ...,
    ) -> None: ...

class Arc(_Arc):
    """`arc: {mass: m, radius: R, angle: 90 deg}`: a thin wire bent to an arc, alike on both sides of its own x axis.
    The reference point is the `center` of the circle, the mass centre R sin(beta)/beta from it along x, beta = angle/2.
    Points: `start`, `middle` and `end` of the wire."""

    def __init__(
        self,
        mass: _Formula = ...,
        radius: _Formula = ...,
        angle: _Formula = ...,
    ) -> None: ...

class Attraction(_Attraction):
    """`attraction: {center: ground.O, strength: mu}`: pulls the mass centre of every body of mass m to a point with
    m mu/r^2; mu = G M [m^3/s^2] of what is there. A body that carries the point feels the opposite force; `on: [moon]`
    names the bodies that are pulled."""

    def __init__(
        self,
        center: _Text,
        strength: _Formula,
        on: _List | None = ...,
    ) -> None: ...

class Belt(_Belt):
    """`belt: [motor, drum]`, `belt: {first: motor, second: drum, crossed: true}`. An open belt turns both pulleys
    the same way, a crossed one opposite ways; bearings or a carrier keep the centres apart. The belt force is the
    difference of the tensions of its two runs, positive when it resists a counter-clockwise turn of the first pulley
    (1 row). With `friction` (in a groove of the `groove_angle`) it slips on the smaller pulley where the force is too
    large for its `pretension`, the tension of both runs at rest, or for its `largest_tension`, which a tightener
    keeps in the tight run. The pretension pulls at the bearings, too. `mass_per_length` takes from both at speed.
    `wrap` is the angle of wrap, without which it follows from the places of the bearings, as the `length` does,
    which is compared if it is given. In space it runs round pulleys with parallel axes whose bearings are on one
    body. A tightener that moves, as on a lever with a weight, needs the way of both runs: write a `string` that is
    wound on one pulley at both ends."""

    def __init__(
        self,
        first: _Text,
        second: _Text,
        crossed: bool = ...,
        first_radius: _Formula | None = ...,
        second_radius: _Formula | None = ...,
        friction: _Formula = ...,
        pretension: _Formula | None = ...,
        largest_tension: _Formula | None = ...,
        mass_per_length: _Formula = ...,
        groove_angle: _Formula | None = ...,
        wrap: _Formula | None = ...,
        length: _Formula | None = ...,
    ) -> None: ...

class BevelGears(_BevelGears):
    """`bevel_gears: {first: pinion, second: crown, teeth: [z1, z2], radius: r, pressure_angle: 20 deg}`: two wheels in
    revolute joints on a common carrier (`on`, default the ground), whose axes meet. `radius` is the mean pitch radius
    of the first. The tooth force acts where the pitch cones touch, at the mean radius, and is positive when it resists
    a turn of the first that is right-handed about its axis, seen from the apex outwards; with a `pressure_angle` it is
    positive, or negative with `other_flank: true`. Radial and axial part are those on the first (1 row)."""

    def __init__(
        self,
        first: _Text,
        second: _Text,
        teeth: _List,
        radius: _Formula,
        on: _Text = ...,
        pressure_angle: _Formula | None = ...,
        other_flank: bool = ...,
    ) -> None: ...

class Body(_Body):
    """A body given by mass, moment of inertia about its mass centre, and the mass centre's place in the body's
    own frame, whose origin is the reference point `origin`; `radius_of_gyration: k` in place of the inertia. A `radius`
    makes its rim a circle about the origin, `hub: r` another one, on which a rope is wound (`wound on spool.hub`).

    In space `inertia` is the three moments about its axes, [Ixx, Iyy, Izz], or the tensor as three rows, about the mass
    centre, or `about: origin`, or another place by components."""

    def __init__(
        self,
        mass: _Formula = ...,
        inertia: _List = ...,
        center_of_mass: _List | None = ...,
        radius: _Formula | None = ...,
        hub: _Formula | None = ...,
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
        torque: _Mapping,
    ) -> None: ...

class Buoyancy(_Buoyancy):
    """`buoyancy: {at: buoy.bottom, density: rho, strength: g, area: A}`: pushes up with rho g A d, d how far the point
    is below the surface, which is level with `surface` (a point, default the origin of the ground); of what stays
    upright and floats. With `height: h` it may also dive (d more than h) or leave the water (d < 0). `volume: V` in
    place of area: wholly immersed, rho g V; with `surface` the answers say until when the point is in the water."""

    def __init__(
        self,
        at: _Text,
        density: _Formula,
        strength: _Formula,
        area: _Formula | None = ...,
        height: _Formula | None = ...,
        volume: _Formula | None = ...,
        surface: _Text | None = ...,
    ) -> None: ...

class Cam(_Cam):
    """`cam: {cam: disk, follower: valve.face, base_radius: r, lift: h/2*(1 - cos(phi)), along: up}`: the edge of a cam
    pushes a follower with a flat face, whose normal is `along` (a direction of the ground, or of the follower:
    `along: lever.y`). `form: edge`: the point of the follower itself runs on the edge; `form: roller` with a
    `roller_radius`: it is the middle of a roller; of these `along` says on which side of the cam they are; guided
    through its centre, they have plain formulas. The lift is a formula in phi, the angle of the cam from where its x
    axis points at the follower, or goes through `points: [[0 deg, 0 mm], [30 deg, 2 mm], ...]` of a turn, which a table
    in the folder of the model may hold (`points: lift.csv`, with the head `phi [deg], lift [mm]`):
    `through: cubic` (a periodic spline, smooth to the acceleration) or `pchip` (no overshoot beside dwells, but the
    acceleration jumps at the points). The contact force is positive where the cam pushes (1 row)."""

    def __init__(
        self,
        cam: _Text,
        follower: _Text,
        base_radius: _Formula,
        lift: _Formula | None = ...,
        points: _Text | _List | None = ...,
        through: _Text = ...,
        along: _Along | None = ...,
        form: _Text = ...,
        roller_radius: _Formula | None = ...,
    ) -> None: ...

class Chain(_Chain):
    """`chain: {first: crank, second: hub, pitch: 12.7 mm, teeth: [44, 16]}`: both sprockets turn the same way, with the
    ratio of their teeth; bearings keep the centres apart. The chain force is the tension of the tight run, as the other
    one is slack; it is positive when it resists a counter-clockwise turn of the first sprocket (1 row), or negative
    with `other_run: true`, where the other run is the tight one. It pulls at the bearings, too. In space it runs over
    sprockets with parallel axes whose bearings are on one body."""

    def __init__(
        self,
        first: _Text,
        second: _Text,
        pitch: _Formula,
        teeth: _List,
        length: _Formula | None = ...,
        other_run: bool = ...,
    ) -> None: ...

class Clothoid(_Clothoid):
    """`clothoid: {point: car, scale: A}`: a point stays on a clothoid of another body (`on`, default the ground), which
    starts straight along its x axis at its reference point and has the curvature s/A² after the length s; `bends: left`
    (the default) or `right` (1 row, in space 2). `parameter of track` is s, as a measure. The normal force is positive
    when it pushes to the left of the way. `leaves`, `friction` and `ends` are those of a `curved_rail`."""

    def __init__(
        self,
        on: _Text = ...,
        ends: _List | None = ...,
        point: _Text = ...,
        leaves: bool = ...,
        friction: _Mapping = ...,
        scale: _Formula = ...,
        bends: _Text = ...,
    ) -> None: ...

class Composite(_Composite):
    """`composite: {parts: {hub: {disk: {mass: M, radius: R}}, arm: {rod: {mass: m, length: L}, at: [R, 0]}}}`: every
    part is a shape whose reference point stands at `at` in the body's own frame, turned by `angle`, or, in space, by
    `turned`. Points: `origin`, and the reference point of every part by its name. Parts in a list, `parts: [{disk:
    ...}, {rod: ..., at: [R, 0]}]`, are called part1, part2 and so on.

    What is round about the origin can roll and touch, carry a string and gear as a disk can; where several parts are,
    `radius` says which is meant. A round part by its name, `wheel.hub`, is its circle in a contact.

    `holes` are written as parts and taken away, each with the mass of what was there: a plate of mass M with a hole
    where m has been cut out weighs M - m."""

    def __init__(
        self,
        parts: _List | _Mapping,
        holes: _List | _Mapping = ...,
    ) -> None: ...

class Cone(_Cone):
    """A homogeneous cone from its `apex` along its `axis` (z) to the middle of its `base`, its mass centre at three
    quarters of the height; `half_angle` in place of the radius is that at the apex. I = 3/10 m R^2 about the axis,
    3/80 m (4 R^2 + h^2) across, about the mass centre. The reference point is the apex. For models in space."""

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

    What touches is named by a body (its circle, its straight edges and corners, or, on lines, the round side of a half
    disk, a sector or an arc, while this faces the line), a point, a line (solid on the
    right of its direction, so below one that points to the right; `below: true` for the other side), or
    `inside bowl` for the inside of a ring. In space: a body on a plane of another one (see `planes`), a sphere on a
    sphere, inside one, on a box, a convex body, a cylinder, a disk, a ring, a rod or a point, a point on a sphere, a
    box or a convex body, a cylinder or a disk on a box or a convex body, cylinders across or along each other,
    and boxes and convex bodies on each other. friction: one coefficient, or {static: 0.5, kinetic: 0.4};
    restitution between 0 (default) and 1; rolling_resistance: the arm of the normal force [m]. A contact whose
    bodies have no place (`at`)
    starts touching, and `touching: true` moves the bodies there, or out of each other, by the least;
    `touching: false` leaves them where they are. Of two bodies with plane faces only `touching: true` does. A cylinder,
    or a disk, may stand flat on a plane or a face: it tips about its rim, and where it falls back without rebound the
    angular momentum about the other edge stays. Where it spins with friction there, a motion needs its
    spinning_resistance (2/3 of the coefficient of friction times the radius where the pressure is even and it only
    spins); else it ends, saying so."""

    def __init__(
        self,
        between: _List | None = ...,
        among: _Text | _List | None = ...,
        friction: _Mapping = ...,
        restitution: _Formula = ...,
        rolling_resistance: _Formula = ...,
        spinning_resistance: _Formula = ...,
        touching: bool | None = ...,
        below: bool = ...,
    ) -> None: ...

class Convex(_Convex):
    """`convex: {mass: m, points: [[0, 0, 0], [a, 0, 0], [0, b, 0], [0, 0, c]]}`: a homogeneous body with plane faces,
    the convex hull of its points: a wedge, a prism, a pyramid, a tetrahedron. For models in space.

    The points count from its reference point, `origin`, and are points of the body: `corner1`, `corner2` ... in the
    order in which they stand, or by names of their own, `points: {A: [0, 0, 0], B: [a, 0, 0], ...}`. Its faces are
    `face1`, `face2` ... : each begins with its earliest corner and goes on counter-clockwise as seen from outside, and
    they are ordered as these lists are. `faces: {slope: [A, B, C]}` gives the face with these corners a name."""

    def __init__(
        self,
        mass: _Formula = ...,
        points: _List | _Mapping = ...,
        faces: _List | _Mapping = ...,
    ) -> None: ...

class CurvedRail(_CurvedRail):
    """`curved_rail: {point: bead, y: a*x^2}`: a point stays on the curve y = f(x) of another body (`on`, default the
    ground), x and y from its reference point along its axes (1 row, in space 2). f is a formula in x and parameters.
    `curved_rail: {point: bead, points: [[0 m, 2 m], [1 m, 1.2 m], ...]}`: through points with growing x, which a table
    in the folder of the model may hold (`points: track.csv`, with the head `x [m], y [m]`); `through: cubic` (a natural
    spline) or `pchip` (no overshoot, but the curvature jumps at the points); beyond them the curve goes on straight.
    `curved_rail: {point: bead, x: R*(s + sin(s)), y: R*(1 - cos(s))}`: on a curve in a parameter s, an angle or a
    length, in the plane; `parameter of rail` is it as a measure. The normal force is positive when it pushes to the
    left of the way of growing x or s, which is up where a curve to the right is level. `leaves: true`: the point lies
    on the curve and is not held from above. `friction`: mu, or {static: 0.5, kinetic: 0.4}. `ends: [x1, x2]`: from
    where to where the curve is drawn."""

    def __init__(
        self,
        on: _Text = ...,
        ends: _List | None = ...,
        point: _Text = ...,
        leaves: bool = ...,
        friction: _Mapping = ...,
        y: _Formula | None = ...,
        x: _Formula | None = ...,
        points: _Text | _List | None = ...,
        through: _Text = ...,
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
    """`damper: {first: ground.A, second: block, damping: c}`: pulls with c dl/dt. `only: compressed` resists while it
    is pressed together and gives way freely while it is pulled apart, as a door closer does; `only: stretched` resists
    while it is pulled apart. With a `length` it acts where the points are closer than that (`compressed`), or farther
    apart (`stretched`), and resists both ways there, as the damper beside a buffer of the same length."""

    def __init__(
        self,
        first: _Text,
        second: _Text,
        damping: _Formula,
        length: _Formula | None = ...,
        only: Any = ...,
    ) -> None: ...

class DiscClutch(_DiscClutch):
    """`disc_clutch: {between: [flywheel, shaft], force: F, friction: mu, inner_radius: r, outer_radius: R}`: faces that
    are pressed on each other with F resist a relative turn by mu F (R + r)/2; with the ground it is a brake. `faces: n`
    pairs of them (a plate between two disks has 2); `pressure: uniform` for new faces,
    2/3 mu F (R^3 - r^3)/(R^2 - r^2); `cone_angle: alpha`, the angle between the faces and the axis, for a cone. The
    force may depend on time `t`."""

    def __init__(
        self,
        between: _List,
        force: _Formula,
        friction: _Mapping,
        inner_radius: _Formula,
        outer_radius: _Formula,
        faces: _Formula = ...,
        pressure: _Text = ...,
        cone_angle: _Formula | None = ...,
    ) -> None: ...

class Disk(_Disk):
    """A uniform disk (or cylinder, pulley, gear wheel); I = m R^2/2 unless `inertia`, or `radius_of_gyration: k`, is
    given. `hub: r` is the radius of a second circle about its middle, on which a rope is wound (`wound on spool.hub`)
    or that touches something (`spool.hub`). In space it is thin, about its `axis` (z), with half of that inertia about
    its diameters."""

    def __init__(
        self,
        mass: _Formula = ...,
        radius: _Formula | None = ...,
        inertia: _Formula | None = ...,
        hub: _Formula | None = ...,
        axis: _Along = ...,
    ) -> None: ...

class Distributed(_Distributed):
    """`distributed: {between: [beam.start, beam.B], along: down, intensity: q}`: a force per length along the line from
    one point of a body to another; `intensity: [q0, q1]` rises or falls evenly from the first point to the second.
    `on: beam` is all of a rod, `on: beam, from: start, to: B` a part of it."""

    def __init__(
        self,
        between: Any,
        intensity: _List,
        along: _Along = ...,
    ) -> None: ...

class Drag(_Drag):
    """`drag: {body: ball, linear: c}`: resists the velocity of the mass centre with c v; `quadratic: k`: with k v^2;
    both may be given. `body: boat.bow` is a point of a body. `along` a direction: only the motion along it is resisted,
    as of what slides on a track."""

    def __init__(
        self,
        body: _Text,
        linear: _Formula | None = ...,
        quadratic: _Formula | None = ...,
        along: _Along | None = ...,
    ) -> None: ...

class Driver(_Driver):
    """`driver: {measure: theta, follows: omega*t}`. The driving force or torque does positive work when it pushes
    the measure up (1 row). `speed: omega` in place of a law: it goes on evenly from where it starts; `body: crank` in
    place of a measure: the angle of that body."""

    def __init__(
        self,
        measure: _Mapping | None = ...,
        follows: _Formula | None = ...,
        body: _Text | None = ...,
        speed: _Formula | None = ...,
    ) -> None: ...

class ElasticString(_ElasticString):
    """`elastic_string: {from: ground.A, over: [ground.B], to: ball, stiffness: k, length: l0}`: a rubber band, a bungee
    cord: pulls with k (l - l0) along all its way, through smooth rings and over small pulleys (`over`), and is slack
    where it is shorter than l0. Without a length it is relaxed at the start. `taut: true` leaves the case of slackness
    out: it stays taut.

    It also runs round the rims of wheels, `over: [wheel]`, and its way may be a `path` with drums, as that of a
    `string`; in space a joint guides what is at an end in the plane of the wheel beside it. It does not slip on the
    wheels that it `grips` (default: all bodies that can turn), and over the others it slides without friction (`grips:
    []` for all). At the start it is evenly stretched; from then on a section between grips has a tension of its own and
    the stiffness k L/L_section, L the length of all of it at the start, as long as it stretches little: what comes on a
    wheel and leaves it is not counted. From a drum on, l0 is that of what is off it at the start."""

    def __init__(
        self,
        start: _Text | None = ...,
        to: _Text | None = ...,
        over: _List = ...,
        under: _List = ...,
        path: _List = ...,
        stiffness: _Formula = ...,
        length: _Formula | None = ...,
        taut: bool = ...,
        grips: _List | None = ...,
    ) -> None: ...

class Ellipsoid(_Ellipsoid):
    """A body that is rounded as an ellipsoid with `semi_axes: [a, b, c]` along its x, y and z, about its `center`;
    homogeneous unless `inertia` gives its moments of inertia about the mass centre, [Ixx, Iyy, Izz] or three rows, and
    `center_of_mass` its mass centre from the `center`. Three equal semi-axes make it a ball: a tippe top has its mass
    centre below the middle, a rattleback other principal axes than its surface has. For models in space."""

    def __init__(
        self,
        mass: _Formula = ...,
        semi_axes: _List = ...,
        inertia: _List | None = ...,
        center_of_mass: _List | None = ...,
    ) -> None: ...

class Force(_Force):
    """`force: {at: rod.end, along: right, magnitude: F}`. The magnitude may depend on time `t` and on named
    measures and their rates; `along: rod.y` turns with the rod. A cord that is wound on a body and pulled at its outer
    end acts where it leaves the body, which does not turn with it: `at: wound on spool.hub at bottom`, or
    `wound on spool radius r at top`."""

    def __init__(
        self,
        at: _Text,
        along: _Along,
        magnitude: _Formula,
        at_most: _Formula | None = ...,
    ) -> None: ...

class FrictionAlongMeasure(_FrictionAlongMeasure):
    """`dry_friction: {measure: x, force: F}`: a Coulomb force (a torque for an angle) of a given size that resists
    the rate of a measure, and holds it where it can. force: as the torque of a brake."""

    def __init__(
        self,
        measure: _Mapping,
        force: _Mapping,
    ) -> None: ...

class Frustum(_Frustum):
    """`frustum: {mass: m, radius: R, top_radius: r, height: h}`: a homogeneous cone without its tip, from the middle
    of its `base` (radius R), the reference point, along its `axis` (z) to the middle of its `top` (radius r). For
    models in space."""

    def __init__(
        self,
        mass: _Formula = ...,
        radius: _Formula = ...,
        top_radius: _Formula = ...,
        height: _Formula = ...,
        axis: _Along = ...,
    ) -> None: ...

class Gear(_Gear):
    """`gear: {teeth: z, module: m, mass: M}`: a uniform disk of the radius m z/2 of its pitch circle, M r^2/2 unless
    `inertia` is given; gears of one module mesh (`gear_mesh: [sun, planet]`). `internal: true` for a ring gear, a thin
    ring, M r^2. A `radius` in place of teeth and module where only the ratio counts."""

    def __init__(
        self,
        mass: _Formula = ...,
        teeth: _Formula | None = ...,
        module: _Formula | None = ...,
        radius: _Formula | None = ...,
        internal: bool = ...,
        inertia: _Formula | None = ...,
        axis: _Along = ...,
    ) -> None: ...

class GearMesh(_GearMesh):
    """`gear_mesh: [sun, planet]`, `gear_mesh: {first: ring, second: planet, internal: true}` with the ring gear
    first. The tooth force acts along the common tangent of the pitch circles and is positive when it resists a
    counter-clockwise turn of the first gear. With a `pressure_angle` the teeth part the gears as well, by its tangent
    times the tooth force, which is positive then, or negative with `other_flank: true`. The distance of the centres is
    held too where no carrier or bearing holds it already (1 or 2 rows). `first_radius`, `second_radius` for a wheel
    with several gears on it, or `module: m, teeth: [z1, z2]`: the pitch circles have the diameters m z, as those of
    bodies that are gears (`gear: {teeth: z, module: m}`) have. `efficiency: eta` of the teeth, whichever of the two
    drives: of the power that goes through the mesh, as seen from the line of centres, so much comes out."""

    def __init__(
        self,
        first: _Text,
        second: _Text,
        internal: bool = ...,
        first_radius: _Formula | None = ...,
        second_radius: _Formula | None = ...,
        module: _Formula | None = ...,
        teeth: _List | None = ...,
        pressure_angle: _Formula | None = ...,
        other_flank: bool = ...,
        efficiency: _Formula | None = ...,
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

class HalfDisk(_HalfDisk):
    """`half_disk: {mass: m, radius: R}`: a uniform half disk (half cylinder, semicircular plate), its round side
    towards its own +x: the mass centre is 4 R/(3 pi) from the `center`, its reference point. It rolls with its rim.
    Points: `start`, `middle` and `end` of the rim."""

    def __init__(
        self,
        mass: _Formula = ...,
        radius: _Formula = ...,
    ) -> None: ...

class HalfRing(_HalfRing):
    """`half_ring: {mass: m, radius: R}`: a thin wire or hoop of half a circle, its middle on its own +x: the mass
    centre is 2 R/pi from the `center`, its reference point. Points: `start`, `middle` and `end` of the wire."""

    def __init__(
        self,
        mass: _Formula = ...,
        radius: _Formula = ...,
    ) -> None: ...

class HangingCable(_HangingCable):
    """`hanging_cable: {between: [ground.A, ground.B], weight: w, pull: H}`: a flexible cable, or a chain, that hangs
    between two points that stand still. `weight` is its own weight per length (a catenary), `load` in its place what
    hangs on it per length of the level, as the deck of a suspension bridge (a parabola). `pull` is the horizontal part
    of its tension; of a parabola the `sag` says it as well. Its supports are pulled by it. Ask for the `tension of
    cable at ground.A`, its `sag`, its `length`, its `horizontal pull` or its `greatest tension`, and for the pull that
    a length or a sag asks for: `value of H for which length of cable = s`."""

    def __init__(
        self,
        between: Any,
        weight: _Formula | None = ...,
        load: _Formula | None = ...,
        pull: _Formula | None = ...,
        sag: _Formula | None = ...,
    ) -> None: ...

class HeavyRope(_HeavyRope):
    """`heavy_rope: {rope: chain, over: [ground.edge], leads: [right, down]}`: a body `rope: {mass: m, length: L}` runs
    over points of the ground, and over wheels that are pinned to the ground, which it grips and turns. `leads` are the
    directions in which it runs, from its first end to its last, one more than places; the body is the last end. Without
    slack: its first lead becomes shorter as the last one grows. `from: block`, `to: load` are bodies tied to its ends,
    without these the ends are free. `wound_on: drum` in place of a free first lead: it unwinds from a drum, on the
    `side` of it, and there are as many leads as places. `friction: mu` is that of what its first lead lies on.
    Gravity drives every part along its own lead. Ask for the tension at a body, or in the rope at a place.
    `counterclockwise: true` where it comes back over a wheel from the right. In space leads run any way over points,
    and perpendicular to the axis over a wheel; `counterclockwise` is as seen against that axis."""

    def __init__(
        self,
        rope: _Text,
        over: _List = ...,
        leads: _List = ...,
        start: _Text | None = ...,
        to: _Text | None = ...,
        wound_on: _Text | None = ...,
        side: Any = ...,
        friction: _Mapping = ...,
        counterclockwise: bool = ...,
    ) -> None: ...

class HelicalGears(_HelicalGears):
    """`helical_gears: {first: pinion, second: wheel, teeth: [z1, z2], radius: r, helix_angle: beta}`: two wheels in
    revolute joints with parallel axes on a common carrier (`on`, default the ground), which mesh from outside. `radius`
    is the pitch radius of the first, whose teeth are right-handed (`left_handed: true`); they act in the middle of its
    face. The tooth force is positive when it resists a turn of the first that is right-handed about its axis; with a
    `pressure_angle`, that of the normal section, it is positive, or negative with `other_flank: true` (1 row)."""

    def __init__(
        self,
        first: _Text,
        second: _Text,
        teeth: _List,
        radius: _Formula,
        helix_angle: _Formula,
        on: _Text = ...,
        pressure_angle: _Formula | None = ...,
        other_flank: bool = ...,
        left_handed: bool = ...,
    ) -> None: ...

class Hemisphere(_Hemisphere):
    """`hemisphere: {mass: m, radius: R}`: a homogeneous half ball, its round side towards its own +x, seen from the
    side in the plane: the mass centre is 3 R/8 from the `center` of its flat face, its reference point; about the mass
    centre I = 2/5 m R^2 along x and 83/320 m R^2 across. It rolls with its round side. Points: `start`, `middle` and
    `end` of the rim."""

    def __init__(
        self,
        mass: _Formula = ...,
        radius: _Formula = ...,
    ) -> None: ...

class HemisphericalShell(_HemisphericalShell):
    """`hemispherical_shell: {mass: m, radius: R}`: a thin half ball (bowl, dome), its round side towards its own +x,
    seen from the side in the plane: the mass centre is R/2 from the `center`, its reference point; about the mass
    centre I = 2/3 m R^2 along x and 5/12 m R^2 across. Points: `start`, `middle` and `end` of the rim."""

    def __init__(
        self,
        mass: _Formula = ...,
        radius: _Formula = ...,
    ) -> None: ...

class HollowCylinder(_HollowCylinder):
    """`hollow_cylinder: {mass: m, radius: R, inner_radius: r, length: L}`: a homogeneous pipe about its `axis` (z):
    I = m (R^2 + r^2)/2 about it, m (3 (R^2 + r^2) + L^2)/12 across; a thin shell has inner_radius R. Points `start`,
    `end`: the middles of its ends. For models in space."""

    def __init__(
        self,
        mass: _Formula = ...,
        radius: _Formula = ...,
        inner_radius: _Formula = ...,
        length: _Formula = ...,
        axis: _Along = ...,
    ) -> None: ...

class HollowSphere(_HollowSphere):
    """`hollow_sphere: {mass: m, radius: R, inner_radius: r}`: a ball with a hollow in its middle;
    I = 2/5 m (R^5 - r^5)/(R^3 - r^3) about any axis through its centre."""

    def __init__(
        self,
        mass: _Formula = ...,
        radius: _Formula = ...,
        inner_radius: _Formula = ...,
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
    which the measure grows, as an expression in measures, their rates (`rate(x)`), states and time `t`. `at_most:
    F_max` where an actuator can give no more either way."""

    def __init__(
        self,
        measure: _Mapping,
        force: _Formula,
        at_most: _Formula | None = ...,
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

class Mesh(_Mesh):
    """`mesh: {file: part.stl, unit: mm, mass: 2 kg}`: a homogeneous body whose surface is a file of triangles, in the
    folder of the model: STL, OBJ, PLY or OFF. Its mass, or its `density`, is given; its mass centre and its moments of
    inertia follow from the triangles, which must be closed and go counter-clockwise as seen from outside. Such files
    have no unit: `unit` says it. Needs the extra `mesh`.

    Its frame is that of the file, its reference point the `origin` there. In contacts its convex hull touches, where
    that has at most 40 corners: they are points of the body, `corner1`, `corner2` ... , in space its faces `face1`,
    `face2` ... A planar model sees it against the z axis of the file and takes its moment of inertia about that;
    `normal: x` or `normal: y` for another axis, then x is the file's y or z."""

    def __init__(
        self,
        file: _Text,
        unit: _Text = ...,
        mass: _Formula | None = ...,
        density: _Formula | None = ...,
        normal: _Text = ...,
    ) -> None: ...

class Motor(_Motor):
    """`motor: {on: rotor, stall_torque: T_0, no_load_speed: omega_0}`: the torque T_0 (1 - omega/omega_0), omega the
    speed against `reacts_on` (default the ground), counter-clockwise positive; beyond omega_0 it brakes. Negative
    values of both turn it round. In space `about` says the axis, fixed in the body that it reacts on."""

    def __init__(
        self,
        on: _Text,
        stall_torque: _Formula,
        no_load_speed: _Formula,
        reacts_on: _Text = ...,
        about: _Along | None = ...,
    ) -> None: ...

class Particle(_Particle):
    """A point mass; it has no angle."""

    def __init__(
        self,
        mass: _Formula = ...,
    ) -> None: ...

class Pin(_Pin):
    """`pin: [ground.A, rod.start]`. Holds r_second - r_first = 0 (2 rows). `friction` with the `radius` of the journal:
    the torque that resists is mu r times the force in the pin. A node where several bodies meet is
    `pin: [ground.A, one.end, two.start, three.start]`: each of the `further` ones is pinned to the first by a pin of
    its own, called by the name of the node and its number (node_2, node_3)."""

    def __init__(
        self,
        first: _Text,
        second: _Text,
        friction: _Mapping = ...,
        radius: _Formula | None = ...,
        further: Any = ...,
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
    another body, along a direction of that body; a bearing that holds across its axis alone (2 rows).
    `friction: mu`: the force that resists along it is mu times the normal force, the resultant of both."""

    def __init__(
        self,
        point: _Text,
        through: _Text,
        along: _Along,
        friction: _Mapping = ...,
    ) -> None: ...

class PointOnPlane(_PointOnPlane):
    """`point_on_plane: {point: leg.foot, on: ground.floor}`: a point stays in a plane of another body, without friction
    (1 row)."""

    def __init__(
        self,
        point: _Text,
        on: _Text,
    ) -> None: ...

class PointOnSurface(_PointOnSurface):
    """`point_on_surface: {point: bead, z: k*rho^2}`: a point stays on the surface z = f(x, y) of another body (`on`,
    default the ground), counted from its reference point along its axes (1 row). f is a formula in x, y, parameters and
    rho, the distance from the z axis, rho^2 = x^2 + y^2: `k*rho^2` is a paraboloid of revolution, `rho/tan(alpha)` a
    cone, `-k*rho^2` a dome. For an axis that points up write `space: {up: z}`. The normal force is positive when it
    pushes to the side of growing z. `leaves: true`: the point lies on the surface and is not held from above.
    `friction`: mu, or {static: 0.5, kinetic: 0.4}. `reach`: how far from the axis the surface is drawn. The measures
    `distance of bead from the z axis` and `angle of line from ground.O to bead` make polar coordinates."""

    def __init__(
        self,
        point: _Text,
        z: _Formula,
        on: _Text = ...,
        leaves: bool = ...,
        friction: _Mapping = ...,
        reach: _Formula | None = ...,
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
    and the bodies keep their attitude to each other (5 rows). `friction: mu`: the force that resists is mu times the
    resultant of the forces across the axis; what the moments that it transmits press on its ends is not counted."""

    def __init__(
        self,
        first: _Text,
        second: _Text,
        along: _Along,
        second_axis: _Along | None = ...,
        friction: _Mapping = ...,
    ) -> None: ...

class RackAndPinion(_RackAndPinion):
    """`rack_and_pinion: {pinion: gear, rack: bar, along: right}`; the rack's teeth run `along` (a direction
    fixed in the rack; without it, along the guide of the rack or, where that is fixed, of the pinion; else to the
    rack's right). The rack is below the pinion for a direction to the right, to its right for one that goes up, unless
    the places of the two say otherwise; `above: true` puts it on the other side. Bearings hold the distance (1 row).
    The tooth force is positive when it drives the rack along its direction. With a `pressure_angle` the teeth part the
    two as well, by its tangent times the tooth force, which is positive then, or negative with `other_flank: true`."""

    def __init__(
        self,
        pinion: _Text,
        rack: _Text,
        along: _Along | None = ...,
        above: bool | None = ...,
        radius: _Formula | None = ...,
        pressure_angle: _Formula | None = ...,
        other_flank: bool = ...,
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
    """A thin ring or hoop; I = m R^2 unless `inertia`, or `radius_of_gyration: k`, is given. Wheels may run on its
    inside. `hub: r` is the radius of a second circle about its middle, on which a rope is wound."""

    def __init__(
        self,
        mass: _Formula = ...,
        radius: _Formula | None = ...,
        inertia: _Formula | None = ...,
        hub: _Formula | None = ...,
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

    In space: `on` a plane, of the rim of a disk, a sphere, an ellipsoid or a cone (3 rows; a cone 5); and of a
    sphere `on` or `inside` another one or a cylinder, fixed or moving (3 rows); on a cylinder between its ends. The
    rim of a disk or a ring rolls on a sphere or `inside` a hollow one as well (3 rows). A cylinder on or inside
    another one touches it along a line and stays parallel to it (5 rows); `crossed: true` where it lies across the
    other one and touches it in a point (3 rows), on the side on which both are put. On a curve see
    rolling_on_curve, on a surface z = f(x, y) rolling_on_surface."""

    def __init__(
        self,
        body: _Text,
        on: _Text | None = ...,
        inside: _Text | None = ...,
        below: bool = ...,
        radius: _Formula | None = ...,
        crossed: bool = ...,
    ) -> None: ...

class RollingOnCurve(_RollingOnCurve):
    """`rolling_on_curve: {body: ball, y: a*x^2}`: a round body rolls without slip on the curve y = f(x) of the ground
    (or of another body, `on`), on one in a parameter s, `x: ..., y: ...`, or through `points` as a `curved_rail`;
    `parameter of contact` is where on it they touch (2 rows). It lies on the left of the way of growing x or s, which
    is above a curve to the right; `below: true` puts it on the other side. `ends: [x1, x2]`: from where to where the
    curve is drawn. A circle that is too large for a curve is refused with the radius that would do."""

    def __init__(
        self,
        on: _Text = ...,
        ends: _List | None = ...,
        y: _Formula | None = ...,
        x: _Formula | None = ...,
        points: _Text | _List | None = ...,
        through: _Text = ...,
        body: _Text = ...,
        below: bool = ...,
    ) -> None: ...

class RollingOnSurface(_RollingOnSurface):
    """`rolling_on_surface: {body: ball, z: k*rho^2}`: a sphere rolls without slip on the surface z = f(x, y) of the
    ground (or of another body, `on`), counted from its reference point along its axes (3 rows). f is a formula in x, y,
    parameters and rho, the distance from the z axis, as of a `point_on_surface`. For an axis that points up write
    `space: {up: z}`. The sphere lies on the side of growing z; `below: true` puts it on the other one. `reach`: how far
    from the axis the surface is drawn. Where it touches, the measures `axis distance of bowl` and `azimuth of bowl`
    tell: with them as coordinates its steady motion round a bowl has a closed form. A sphere that is too large for it
    is refused with the radius that would do."""

    def __init__(
        self,
        body: _Text,
        z: _Formula,
        on: _Text = ...,
        below: bool = ...,
        reach: _Formula | None = ...,
    ) -> None: ...

class Rope(_Rope):
    """A uniform heavy rope or chain by its last end, which has no angle; `mass: m` of all of it, or
    `mass_per_length: rho`. A `heavy_rope` among the connections says over what it runs."""

    def __init__(
        self,
        length: _Formula,
        mass: _Formula | None = ...,
        mass_per_length: _Formula | None = ...,
    ) -> None: ...

class Screw(_Screw):
    """`screw: {first: ground.A, second: nut, about: x, pitch: 2 mm}`: a cylindrical joint in which a turn of the second
    body moves it by the pitch along the axis (5 rows). A negative pitch is a left-hand thread. `friction` in the thread
    needs its mean `radius`; the screw locks itself where the coefficient is at least pitch/(2 pi radius). The friction
    force is its part round the axis."""

    def __init__(
        self,
        first: _Text,
        second: _Text,
        about: _Along,
        pitch: _Formula,
        second_axis: _Along | None = ...,
        friction: _Mapping = ...,
        radius: _Formula | None = ...,
    ) -> None: ...

class Sector(_Sector):
    """`sector: {mass: m, radius: R, angle: 60 deg}`: a uniform plate cut from a disk, alike on both sides of its own x
    axis. The reference point is the `center` of the circle, the mass centre 2 R sin(beta)/(3 beta) from it along x,
    beta = angle/2. Points: `start`, `middle` and `end` of the rim."""

    def __init__(
        self,
        mass: _Formula = ...,
        radius: _Formula = ...,
        angle: _Formula = ...,
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
        friction: _Mapping = ...,
    ) -> None: ...

class Slot(_Slot):
    """`slot: {pin: rod.end, along: up}`; `on` is the slotted body (default the ground), `through` a point of
    the slot's centre line. Holds the displacement across the slot (1 row). `friction`: the force that resists is mu
    times the normal force. A support on rollers is `roller: {at: beam.end, on: floor}`, or `along: right`."""

    def __init__(
        self,
        pin: _Text,
        along: _Along,
        on: _Text = ...,
        through: _Text | None = ...,
        friction: _Mapping = ...,
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

class SphericalShell(_SphericalShell):
    """`spherical_shell: {mass: m, radius: R}`: a thin hollow ball (table tennis ball, football); I = 2/3 m R^2 about
    any axis through its centre."""

    def __init__(
        self,
        mass: _Formula = ...,
        radius: _Formula = ...,
    ) -> None: ...

class Spring(_Spring):
    """`spring: {first: ground.A, second: block, stiffness: k, length: l0}`: pulls with k (l - l0); without a
    natural length it is relaxed at the start. One of length 0 pulls with k r, also through the point itself.
    `preload: F0` in place of a length: it pulls with F0 at the start, or pushes where that is negative.
    `only: compressed` is a buffer on `first`: it pushes with k (l0 - l) where the points are closer than its length,
    and is not touched where they are farther apart; with a preload it pushes with that at once. `only: stretched` pulls
    alone."""

    def __init__(
        self,
        first: _Text,
        second: _Text,
        stiffness: _Formula,
        length: _Formula | None = ...,
        preload: _Formula | None = ...,
        only: Any = ...,
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

    The string does not slip on the pulleys that it `grips` (default: all bodies that can turn); over the others it
    slides without friction. Each stretch between grips keeps its length and has one tension, positive when it pulls.
    Between two points its length may be given; it is taut at the start, and what it carries swings: `{from: ground.O,
    to: ball, length: L}`. A body that nothing else holds hangs on the string and moves up and down, below the point
    where its lead leaves the pulley, if it has no position or is put there; a lead to a body on a straight guide runs
    along the guide if the body has no position, or one from which it does so whatever the parameters are; `leads`
    states the directions instead; otherwise leads are the common tangents of the circles, wherever these move
    (`swings: true` also for hanging bodies); along a guide on a body that turns, as of a trolley on a jib, it keeps
    the direction of that. In space it runs from point to point, through rings and over small pulleys, or over wheels
    in any plane: each turns about the axis of its revolute joint, which has to keep its direction, and what is at an
    end is guided in the plane of the wheel beside it or hangs. Between wheels whose axes are not parallel it runs
    along the line in which their planes meet, and from the ground to wheels on a jib that turns along the axis of
    that turn; a drum is wound `clockwise` or `counterclockwise` as seen against its axis, and `left` is where x is
    negative.
    `friction`: that of the drums and pulleys over which it slides, one coefficient or {drum: mu}. The tensions on both
    sides of a drum differ by up to e^(mu beta), beta the angle of wrap between leads with constant directions, or
    `wrap: {drum: 3*pi}`; ask for the tension at an end, or between two places.
    `falls: n`: of a tackle, whose blocks are the last two places on the way and whose sheaves stand side by side on two
    axles: the string runs n times between them, and all falls are parallel:
    `{from: hand, over: [upper], to: load, falls: 4}`. `efficiency`: by how much each of the n sheaves lets the tension
    fall; that of the falls is their mean."""

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
        length: _Formula | None = ...,
        friction: _Mapping = ...,
        wrap: _Mapping | None = ...,
        falls: _Formula = ...,
        efficiency: _Formula | None = ...,
    ) -> None: ...

class TensionedString(_TensionedString):
    """`tensioned_string: {from: ground.winch, over: [ground.B], to: block, tension: S}`: pulls with the tension S along
    all its way, through smooth rings and over small pulleys (`over`). The tension may depend on time `t` and on named
    measures and their rates."""

    def __init__(
        self,
        start: _Text | None = ...,
        to: _Text | None = ...,
        over: _List = ...,
        under: _List = ...,
        path: _List = ...,
        tension: _Formula = ...,
    ) -> None: ...

class Torque(_Torque):
    """`torque: {on: sun, magnitude: T}`, counter-clockwise positive; `direction: clockwise` (`clockwise: true`) is the
    other way round. `reacts_on: arm` where the motor sits on a body, which feels the opposite torque. A couple turns a
    rigid body alike wherever it acts, but the bending moment of a rod needs its place: `on: beam.C`. In space `about`
    says the axis: a direction fixed in the ground, or in a body (`about: rotor.x`). `at_most: T_max` where a motor can
    give no more either way."""

    def __init__(
        self,
        on: _Text,
        magnitude: _Formula,
        reacts_on: _Text = ...,
        about: _Along | None = ...,
        at_most: _Formula | None = ...,
        clockwise: bool = ...,
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

class Wedge(_Wedge):
    """`wedge: {mass: M, angle: alpha, length: L}`: a right-angled triangle on its base of the length L, with a slope
    that rises to the right, or `rises: left`; `height` in place of the length. Points: the corners `toe`, `heel` (of
    the right angle) and `top`, and the middles `base`, `back` and `face` of its sides, which others may lie on or slide
    along (`along: wedge.face`). A length that is left out is zero, unless one of these points is used."""

    def __init__(
        self,
        mass: _Formula = ...,
        angle: _Formula = ...,
        length: _Formula | None = ...,
        height: _Formula | None = ...,
        rises: Any = ...,
    ) -> None: ...

class Weld(_Weld):
    """`weld: [ground.A, beam.start]`. Two points coincide and the angle between the bodies stays as it is at
    the start (3 rows). In space the second body is `turned` from the first by known rotations, such as [30 deg about
    x]; without any it stays as both are `turned` at the start, else parallel to the first (6 rows)."""

    def __init__(
        self,
        first: _Text,
        second: _Text,
        turned: _List | None = ...,
    ) -> None: ...

class WormGear(_WormGear):
    """`worm_gear: {worm: screw, wheel: wheel, starts: 2, teeth: 40, radius: r, lead_angle: lambda, friction: mu}`: a
    right-handed worm (`left_handed: true`) of the mean radius r, both in revolute joints on a common carrier (`on`,
    default the ground) whose axes cross at a right angle (1 row). The tooth force is the tangential one of the wheel,
    and is positive when it resists a right-handed turn of the worm about its axis. `pressure_angle` is that of the
    normal section; with it the tooth force is positive, or negative with `other_flank: true`. The worm locks itself
    where mu/cos(alpha) is at least tan(lambda); the friction force is its part round the axis of the worm."""

    def __init__(
        self,
        worm: _Text,
        wheel: _Text,
        teeth: _Formula,
        radius: _Formula,
        lead_angle: _Formula,
        starts: _Formula = ...,
        on: _Text = ...,
        friction: _Mapping = ...,
        pressure_angle: _Formula | None = ...,
        other_flank: bool = ...,
        left_handed: bool = ...,
    ) -> None: ...
