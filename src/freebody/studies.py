"""The table of studies: what can be found out about a system, from which its methods and the commands are made.

A study is a function of a system, in a file of its own, whose value is a `Result`. Its line here is a
method without a body: the signature, in a sentence what it does, and how it is given on the command line. `freebody`
has it as a function, `System` as a method, the command line as a command; nothing that a study needs is imported
before it is asked for.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from freebody.study_entry import STUDIES, Option, Study, study

if TYPE_CHECKING:
    from freebody.narrative.explain import Explanation
    from freebody.narrative.marking.found import CheckedAnswer
    from freebody.narrative.marking.working import CheckedWorking
    from freebody.numeric.options import SimulationOptions
    from freebody.present.picture.picture import Picture
    from freebody.study.answering.solution import Solution
    from freebody.study.conservation.conservation import Conservation
    from freebody.study.eom import Equations
    from freebody.study.fitting.result import Fit
    from freebody.study.friction.report import Statics
    from freebody.study.inverse_dynamics import InverseDynamics
    from freebody.study.mobility.found import Mobility
    from freebody.study.optimising.result import Optimum
    from freebody.study.over_a_turn import OverTurn
    from freebody.study.phases.result import Phases
    from freebody.study.sensitivity.local import Gradient
    from freebody.study.sensitivity.sensitivity import Sensitivity
    from freebody.study.simulation.simulate import Simulation
    from freebody.study.small_motion.found import Equilibria
    from freebody.study.small_motion.modes import At, NaturalModes
    from freebody.study.speed_table import SpeedTable
    from freebody.study.sweeps.result import Sweep

__all__ = ["SECONDS", "STUDIES", "Option", "Studies", "Study", "study"]

SECONDS = "freebody.study.given.seconds"
_GUESS = "freebody.study.given.guess_of"
_RANGES = "freebody.study.given.ranges_of"


class Studies:
    """Every study as a method of a system."""

    @study(
        "freebody.study.answering.solve",
        "solve",
        busy="reading the model",
        options=[
            Option(
                "question", ("--find",), "Answer this question instead of those in the file (repeatable).", list[str]
            )
        ],
        is_short=True,
    )
    def solve(self, question: str | Sequence[str] | None = None, *, language: str = "en") -> Solution:
        """Answer the questions of a model in closed form.

        question: in words, one or several, instead of those of the model."""
        ...

    @study(
        "freebody.narrative.explain",
        "explain",
        busy="reading the model",
        options=[
            Option(
                "question",
                ("--find",),
                "Only this question: its id in the file, or one in words (repeatable).",
                list[str],
            ),
            Option("method", ("--method",), "auto, newton, lagrange or energy.", default="auto"),
            Option("compare", ("--compare",), "A second method beside the first.", metavar="METHOD"),
        ],
    )
    def explain(
        self,
        question: str | Sequence[str] | None = None,
        *,
        method: str = "auto",
        compare: str | None = None,
        language: str = "en",
    ) -> Explanation:
        """Derive the answers step by step, with pictures.

        question: its id, or one in words, or several, instead of those of the model."""
        ...

    @study(
        "freebody.narrative.marking.check",
        "check",
        busy="solving the question",
        options=[
            Option(
                "question",
                ("--question",),
                "The question: its id in the file, or one in words; or equations of motion.",
            ),
            Option("answer", ("--answer",), "The answer as it is typed: plain text or LaTeX."),
            Option(
                "free_body",
                ("--free-body",),
                "Instead of a question: the answer is what acts on this body, as 'N up at contact; m g down at G'.",
                metavar="BODY",
            ),
            Option("working", ("--working",), "Instead of both: a file with a solution, one line a step.", Path),
            Option("form", ("--form",), "any, formula or number.", default="any"),
            Option("unit", ("--unit",), "Whether numbers need one: optional or required.", default="optional"),
            Option("tolerance", ("--tolerance",), "Of numbers: '1 %', '0.05 N' or '3 digits'.", default="1 %"),
            Option(
                "gravity",
                ("--gravity",),
                "A further value of g that is accepted, as 10; repeatable.",
                list[str],
                metavar="VALUE",
                read="freebody.study.given.gravity",
            ),
        ],
    )
    def check(
        self,
        question: str | None = None,
        answer: str | None = None,
        *,
        working: str | Path | None = None,
        free_body: str | None = None,
        form: str = "any",
        unit: str = "optional",
        tolerance: str = "1 %",
        gravity: Sequence[float] = (),
        language: str = "en",
    ) -> CheckedAnswer | CheckedWorking:
        """Judge an answer that somebody typed to a question.

        question: its id, or one in words; working: a file with a solution instead, one line a step; free_body: a
        body instead, and the answer is what acts on it; form: any, formula or number; unit: optional or required;
        tolerance: of numbers; gravity: further values of g that are accepted [m/s^2]."""
        ...

    @study("freebody.study.eom", "eom", busy="deriving the equations of motion")
    def equations_of_motion(self, *, language: str = "en") -> Equations:
        """Derive the equations of motion, the mass matrix and the constraint equations."""
        ...

    @study("freebody.study.simulation.simulate", "simulate")
    def simulate(
        self,
        until: float,
        *,
        options: SimulationOptions | None = None,
        values: Mapping[str, float] | None = None,
        events: Sequence[str] = (),
        language: str = "en",
        **given: Any,
    ) -> Simulation:
        """Simulate the motion of a model.

        until: [s]; options: how it is followed, as one value or by name: `tolerance=1e-12`."""
        ...

    @study("freebody.study.sweeps.sweep", "sweep")
    def sweep(
        self,
        vary: Mapping[str, Any] | None = None,
        *,
        over: Mapping[str, Any] | None = None,
        sample: str | None = None,
        seed: int = 0,
        find: str | Sequence[str] = (),
        record: str | Sequence[str] = (),
        until: float | None = None,
        events: str | Sequence[str] = (),
        options: SimulationOptions | None = None,
        threads: int | None = None,
        cluster: str | None = None,
        device: str = "engine",
        out: str | Path | Sequence[str | Path] = (),
        resume: bool = False,
        language: str = "en",
        **given: Any,
    ) -> Sweep:
        """Look at many cases: parameters and start values vary, answers and motions are found in each.

        vary: by name, a text as "1..3 kg:50" or numbers in SI; over: what every case is gone over; sample:
        "sobol:4096", a grid if nothing is said; find: questions; record: of the motion up to `until` [s], as
        "maximum of x"; options: how it is followed; cluster: "local:8",
        "tcp://scheduler:8786" or "slurm:job.sh"; device: "cpu" or "gpu" for smooth motions by equations of their own;
        out: files to write."""
        ...

    @study("freebody.study.sensitivity.local")
    def gradient(
        self,
        find: str | Sequence[str] = (),
        by: str | Sequence[str] = (),
        *,
        record: str | Sequence[str] = (),
        until: float | None = None,
        options: SimulationOptions | None = None,
        language: str = "en",
        **given: Any,
    ) -> Gradient:
        """The exact derivatives of answers and motions by parameters and start values.

        find: questions, by id or in words; by: names, else all parameters in a formula; record: of the motion up to
        `until` [s], as of `sweep`; options: how it is followed."""
        ...

    @study(
        "freebody.study.sensitivity.sensitivity",
        "sensitivity",
        busy="finding derivatives",
        options=[
            Option(
                "vary",
                ("--vary",),
                "For Sobol' indices: how a name varies, as 'm=normal(2 kg, 5 %)' (repeatable).",
                list[str],
                metavar="NAME=RANGE",
                read=_RANGES,
                is_joined=True,
            ),
            Option("sample", ("--sample",), "How many cases, as saltelli:1024."),
            Option("seed", ("--seed",), "The same seed draws the same cases.", int, 0),
            Option("find", ("--find",), "A question, by its id in the file or in words (repeatable).", list[str]),
            Option(
                "by", ("--by",), "Differentiate by this name (repeatable, or with commas).", list[str], is_list=True
            ),
            Option("record", ("--record",), "Of the motion, as 'final x' (repeatable).", list[str]),
            Option("until", ("--until",), "How long the motion is followed, as 10 or 200 ms.", read=SECONDS),
            Option("threads", ("--threads",), "For motions, and what has no formula; else as many as processors.", int),
        ],
    )
    def sensitivity(
        self,
        vary: Mapping[str, Any] | None = None,
        *,
        sample: str = "saltelli:1024",
        seed: int = 0,
        find: str | Sequence[str] = (),
        by: str | Sequence[str] = (),
        record: str | Sequence[str] = (),
        until: float | None = None,
        threads: int | None = None,
        language: str = "en",
        **given: Any,
    ) -> Sensitivity:
        """Tell how much answers and motions hang on parameters and start values.

        vary: with which distributions, for Sobol' indices; without it the gradient alone; find, record, until: as of
        `sweep`."""
        ...

    @study("freebody.study.fitting.fit", "fit")
    def fit(
        self,
        data: str | Path | Sequence[str | Path],
        free: str | Sequence[str],
        *,
        tolerance: float = 1e-11,
        method: str = "auto",
        language: str = "en",
    ) -> Fit:
        """Fit parameters and start values to measured motions, with their errors.

        data: a table for each run, `t [s]` and a column for each series; free: parameters, named measures (the start of
        each run), `offset(x)`."""
        ...

    @study("freebody.study.optimising.optimise", "optimise")
    def optimise(
        self,
        minimise: str | Sequence[str] = (),
        *,
        maximise: str | Sequence[str] = (),
        subject_to: str | Sequence[str] = (),
        over: Mapping[str, Any] | None = None,
        until: float | None = None,
        starts: int = 16,
        generations: int = 150,
        seed: int = 0,
        method: str = "auto",
        out: str | Path | Sequence[str | Path] = (),
        language: str = "en",
        **given: Any,
    ) -> Optimum:
        """Find the parameters at which a goal is best, under limits; of several goals the Pareto front.

        minimise, maximise: questions, formulas in parameters, "maximum of Q over theta", or, up to `until` [s], what is
        recorded of the motion; subject_to: limits, as "tension < 30 N"; over: bounds by name, as "0.1..0.5 m"."""
        ...

    @study(
        "freebody.study.pictures.picture",
        "draw",
        busy="drawing",
        options=[
            Option(
                "path",
                ("-o", "--out"),
                "The picture to write: .svg, .png, .pdf, or .tex with a tikzpicture.",
                Path,
                ...,
            ),
            Option(
                "free",
                ("--free-body",),
                "Cut this body free, with all that acts on it; several for a part of the system.",
                list[str],
                metavar="BODY",
                is_list=True,
            ),
            Option(
                "diagram",
                ("--diagram",),
                "Axial force, shear force and bending moment along this rod.",
                str,
                "",
                metavar="ROD",
            ),
            Option("at", ("--at",), "In motion at this time, as 2.5 or 200 ms.", read=SECONDS),
            Option(
                "show",
                ("--show",),
                "velocity, acceleration, force, instant-centres (repeatable, or with commas).",
                list[str],
                is_list=True,
            ),
            Option(
                "view",
                ("--view",),
                "In space: azimuth and elevation from which one looks, in degrees, as 30,20.",
                read="freebody.study.given.azimuth_and_elevation",
            ),
            Option("perspective", ("--perspective",), "In space: far things are smaller.", bool, default=False),
            Option("dark", ("--dark",), "For a dark page.", bool, default=False),
        ],
    )
    def draw(
        self,
        path: str | Path | None = None,
        *,
        at: float | None = None,
        show: Sequence[str] = (),
        free: Sequence[str] = (),
        diagram: str = "",
        view: tuple[float, float] | None = None,
        perspective: bool = False,
        dark: bool = False,
    ) -> Picture | Path:
        """Draw a model at its start or in motion, bodies of it cut free, or what a rod transmits.

        path: the file to write; without one the picture is returned, which shows itself in a notebook; diagram: axial
        force, shear force and bending moment along this rod; at: [s]; show: velocity, acceleration, force,
        instant-centres; view: in space, azimuth and elevation [deg], else from where most is seen."""
        ...

    @study("freebody.study.pictures.picture")
    def picture(self, *, at: float | None = None, show: Sequence[str] = (), **view: Any) -> Picture:
        """The model as a picture with `svg()`, `tikz()`, `png()`.

        at: [s]; show: as in `draw`."""
        ...

    @study("freebody.study.pictures.picture")
    def free_body(self, *bodies: str, at: float | None = None, **options: Any) -> Picture:
        """Bodies cut free with all that acts on them.

        at: [s]; labels: other symbols; show: "force" for values in that instant."""
        ...

    @study(
        "freebody.study.small_motion.equilibrium",
        "equilibrium",
        busy="searching for equilibria",
        options=[
            Option(
                "guesses",
                ("--guess",),
                "Search from here; 'theta=20 deg, x=0.1 m'. Repeatable.",
                list[str],
                metavar="NAME=VALUE",
                read=_GUESS,
            )
        ],
    )
    def equilibria(self, guesses: Sequence[Mapping[str, str | float]] = (), *, language: str = "en") -> Equilibria:
        """Find the equilibria of a model, their stability and the reactions.

        guesses: values of named measures from which to search; without any its poses are toured."""
        ...

    @study(
        "freebody.study.small_motion.modes",
        "modes",
        busy="finding natural frequencies",
        options=[
            Option("at", ("--at",), "equilibrium (the nearest one), or start.", default="equilibrium"),
            Option("guess", ("--guess",), "The equilibrium to which this leads.", metavar="NAME=VALUE", read=_GUESS),
        ],
    )
    def modes(
        self, at: At = "equilibrium", guess: Mapping[str, str | float] | None = None, *, language: str = "en"
    ) -> NaturalModes:
        """Find natural frequencies, damping and mode shapes of small motions."""
        ...

    @study("freebody.study.friction.report", "statics", busy="finding what holds the system at rest")
    def statics(self, *, language: str = "en") -> Statics:
        """Tell whether a model with contacts and dry friction stays at rest, its reactions, and what fails first."""
        ...

    @study("freebody.study.phases.result", "phases", busy="finding the phases of the motion")
    def phases(self, *, language: str = "en") -> Phases:
        """Find the phases of a motion with contacts or dry friction, as cases over the parameters."""
        ...

    @study(
        "freebody.study.mobility.mobility",
        "mobility",
        busy="counting degrees of freedom",
        options=[
            Option("along", ("--along",), "Follow the motion along a driver or measure to its limits.", metavar="NAME"),
            Option("assembly_modes", ("--modes",), "List assembly modes, however many bodies.", bool, default=False),
        ],
    )
    def mobility(self, along: str | None = None, *, assembly_modes: bool = False, language: str = "en") -> Mobility:
        """Count degrees of freedom, name redundant constraints, singular poses and limits.

        assembly_modes: list them, however many bodies there are."""
        ...

    @study(
        "freebody.study.conservation.conserved",
        "conserved",
        busy="searching for what is conserved",
        options=[Option("question", ("--find",), "Judge this quantity, as 'angular momentum of body about roller'.")],
    )
    def conserved(self, question: str | None = None, *, language: str = "en") -> Conservation:
        """Tell what is conserved, and under which conditions; without a question in the file, search."""
        ...

    @study("freebody.study.inverse_dynamics")
    def inverse_dynamics(
        self, motion: Mapping[str, Any] | None, times: Sequence[float], *, language: str = "en"
    ) -> InverseDynamics:
        """The forces and torques for a prescribed motion of named measures."""
        ...

    @study(
        "freebody.study.over_a_turn",
        "turn",
        busy="turning once round",
        options=[
            Option("along", ("--along",), "The angle that is turned; else the one that is driven.", metavar="ANGLE"),
            Option(
                "rate",
                ("--rate",),
                "How fast, as '30 rad/s'; 0: slowly, without inertia. Else as the model says.",
                read="freebody.study.given.turning_rate",
            ),
            Option("n", ("--poses",), "Poses of the turn.", int, 72),
            Option("csv", ("--csv",), "Write all values as a table.", Path),
            Option("plot", ("--plot",), "Draw the torque over the angle: .png, .svg or .pdf.", Path),
        ],
    )
    def over_a_turn(
        self,
        along: str | None = None,
        *,
        rate: float | None = None,
        n: int = 72,
        csv: str | Path | None = None,
        plot: str | Path | None = None,
        language: str = "en",
    ) -> OverTurn:
        """Find the driving torque over a turn of an angle, as a table and as a picture.

        along: a named angle; rate: [rad/s], 0 for slowly; n: poses; csv, plot: files to write."""
        ...

    @study(
        "freebody.study.speed_table",
        "speeds",
        busy="finding the speeds of the train",
        options=[
            Option(
                "efficiency",
                ("--efficiency",),
                "Of the train whose carrier is held, as 0.98: then efficiencies and power flow are told, too.",
                float,
            ),
        ],
    )
    def speed_table(self, *, efficiency: float | None = None, language: str = "en") -> SpeedTable:
        """Find the speed table of a planetary gear (Willis), its ratios with one member held, and its efficiencies.

        efficiency: of the train whose carrier is held."""
        ...
