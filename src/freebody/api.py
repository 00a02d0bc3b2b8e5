"""The system as users hold it in their hands: with every study as a method."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from freebody.system.system import System as Description

if TYPE_CHECKING:
    from freebody.narrative.explain import Explanation
    from freebody.numeric.options import SimulationOptions
    from freebody.present.picture.picture import Picture
    from freebody.study.answering.solution import Solution
    from freebody.study.conservation.conservation import Conservation
    from freebody.study.eom import Equations
    from freebody.study.friction.report import Statics
    from freebody.study.inverse_dynamics import InverseDynamics
    from freebody.study.mobility.mobility import Mobility
    from freebody.study.phases.result import Phases
    from freebody.study.simulation.simulate import Simulation
    from freebody.study.small_motion.equilibrium import Equilibria
    from freebody.study.small_motion.modes import At, NaturalModes


class System(Description):
    """A mechanical system: immutable, from a file, from text or from Python objects."""

    __hash__ = Description.__hash__

    def solve(self, question: str | None = None) -> Solution:
        """Answers its questions, or one more, in closed form; see `freebody.solve`."""
        from freebody.study.answering.solve import solve

        return solve(self, question)

    def explain(
        self, question: str | None = None, *, method: str = "auto", compare: str | None = None, language: str = "en"
    ) -> Explanation:
        """The worked solutions of its questions, or of one; see `freebody.narrative.explain.explain`."""
        from freebody.narrative.explain import explain

        return explain(self, question, method=method, compare=compare, language=language)

    def equations_of_motion(self) -> Equations:
        """Equations of motion, mass matrix and constraint equations."""
        from freebody.study.eom import equations_of_motion

        return equations_of_motion(self)

    def mobility(self, along: str | None = None, *, assembly_modes: bool = False) -> Mobility:
        """Degrees of freedom, redundant constraints by name, singular poses and limits; see
        `freebody.study.mobility.mobility.mobility`."""
        from freebody.study.mobility.mobility import mobility

        return mobility(self, along, modes=assembly_modes)

    def conserved(self, question: str | None = None) -> Conservation:
        """What is conserved, and under which conditions; see `freebody.study.conservation.conserved.conserved`."""
        from freebody.study.conservation.conserved import conserved

        return conserved(self, question)

    def simulate(
        self,
        until: float,
        *,
        options: SimulationOptions | None = None,
        values: Mapping[str, float] | None = None,
        events: Sequence[str] = (),
        **given: Any,
    ) -> Simulation:
        """The motion from the start to the time `until` [s]; see `freebody.study.simulation.simulate.simulate`.
        options: how it is followed, as one value or by name: `tolerance=1e-12`."""
        from freebody.study.simulation.simulate import simulate

        return simulate(self, until, options=options, values=values, events=events, **given)

    def draw(
        self,
        path: str | Path,
        *,
        at: float | None = None,
        show: Sequence[str] = (),
        free: Sequence[str] = (),
        view: tuple[float, float] = (30.0, 20.0),
        perspective: bool = False,
        dark: bool = False,
    ) -> Path:
        """Draws the system into a file: .svg, .png, .pdf or .tex; at its start or at a time [s], the whole or
        bodies cut `free`; see `freebody.study.pictures.picture.draw`. view: in space, azimuth and elevation [deg]."""
        from freebody.study.pictures.picture import draw

        return draw(self, path, at=at, show=show, free=free, view=view, perspective=perspective, dark=dark)

    def picture(self, *, at: float | None = None, show: Sequence[str] = (), **view: Any) -> Picture:
        """The system as a picture with `svg()`, `tikz()`, `png()`; see `freebody.study.pictures.picture.picture`."""
        from freebody.study.pictures.picture import picture

        return picture(self, at=at, show=show, **view)

    def free_body(self, *bodies: str, at: float | None = None, **options: Any) -> Picture:
        """Bodies cut free with all that acts on them; see `freebody.study.pictures.picture.free_body`."""
        from freebody.study.pictures.picture import free_body

        return free_body(self, bodies, at=at, **options)

    def equilibria(self, guesses: Sequence[Mapping[str, str | float]] = ()) -> Equilibria:
        """Its equilibria, from guesses of named measures or from a tour of its poses, with their stability."""
        from freebody.study.small_motion.equilibrium import equilibria

        return equilibria(self, guesses)

    def phases(self) -> Phases:
        """The phases of its motion in closed form, as a case distinction over the parameters."""
        from freebody.study.phases.result import phases

        return phases(self)

    def statics(self) -> Statics:
        """Whether it stays at rest with its contacts and dry friction, its reactions, and what fails first."""
        from freebody.study.friction.report import statics

        return statics(self)

    def modes(self, at: At = "equilibrium", guess: Mapping[str, str | float] | None = None) -> NaturalModes:
        """Natural frequencies, damping and mode shapes about the nearest equilibrium, or "start"."""
        from freebody.study.small_motion.modes import modes

        return modes(self, at, guess)

    def inverse_dynamics(self, motion: Mapping[str, Any] | None, times: Sequence[float]) -> InverseDynamics:
        """The forces and torques for a prescribed motion of named measures; see
        `freebody.study.inverse_dynamics.inverse_dynamics`."""
        from freebody.study.inverse_dynamics import inverse_dynamics

        return inverse_dynamics(self, motion, times)
