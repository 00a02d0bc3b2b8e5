"""freebody: rigid-body mechanics that shows its work and proves it.

    import freebody as fb

    system = fb.System.load("atwood_machine.yaml")
    solution = fb.solve(system)
    solution["acceleration"].expression

Descriptions (`fb.Disk`, `fb.Pin`, `fb.Gravity` ...) make the same systems in Python; see `System.from_data`.
Everything is imported on first use.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from freebody.api import System
    from freebody.budgets import effort
    from freebody.building import Model
    from freebody.errors import CannotAnswer, FreebodyError, InputError, ModelError, RoutesDisagree, SelfTestFailed
    from freebody.exercises.export import export
    from freebody.functions import acos, asin, atan, cos, exp, log, sin, sqrt, tan
    from freebody.narrative.explain import explain
    from freebody.narrative.marking.check import check
    from freebody.narrative.synthesised import synthesise
    from freebody.numeric.options import SimulationOptions
    from freebody.study.answering.answer import Answer
    from freebody.study.answering.solution import Solution
    from freebody.study.answering.solve import solve
    from freebody.study.conservation.conservation import Conservation
    from freebody.study.conservation.conserved import conserved
    from freebody.study.eom import Equations, equations_of_motion
    from freebody.study.fitting.fit import fit
    from freebody.study.fitting.result import Fit
    from freebody.study.friction.report import Statics, statics
    from freebody.study.inverse_dynamics import inverse_dynamics
    from freebody.study.mobility.found import Mobility
    from freebody.study.mobility.mobility import mobility
    from freebody.study.optimising.optimise import optimise
    from freebody.study.optimising.result import Optimum
    from freebody.study.over_a_turn import over_a_turn
    from freebody.study.phases.result import phases
    from freebody.study.pictures.picture import draw, free_body, picture
    from freebody.study.sensitivity.local import Gradient, gradient
    from freebody.study.sensitivity.sensitivity import Sensitivity, sensitivity
    from freebody.study.simulation.simulate import Simulation, simulate
    from freebody.study.simulation.simulator import Simulator
    from freebody.study.small_motion.equilibrium import equilibria
    from freebody.study.small_motion.modes import modes
    from freebody.study.speed_table import speed_table
    from freebody.study.sweeps.result import Sweep
    from freebody.study.sweeps.sweep import sweep

_HOMES = {
    "System": "freebody.api",
    "Solution": "freebody.study.answering.solve",
    "Answer": "freebody.study.answering.answer",
    "Conservation": "freebody.study.conservation.conservation",
    "Mobility": "freebody.study.mobility.mobility",
    "Model": "freebody.building",
    "Statics": "freebody.study.friction.report",
    "SimulationOptions": "freebody.numeric.options",
    "Simulation": "freebody.study.simulation.simulate",
    "Simulator": "freebody.study.simulation.simulate",
    "Equations": "freebody.study.eom",
    "Sweep": "freebody.study.sweeps.result",
    "Fit": "freebody.study.fitting.result",
    "Optimum": "freebody.study.optimising.result",
    "synthesise": "freebody.narrative.synthesised",
    "Gradient": "freebody.study.sensitivity.local",
    "Sensitivity": "freebody.study.sensitivity.sensitivity",
    "effort": "freebody.budgets",
    "export": "freebody.exercises.export",
    "FreebodyError": "freebody.errors",
    "InputError": "freebody.errors",
    "ModelError": "freebody.errors",
    "CannotAnswer": "freebody.errors",
    "RoutesDisagree": "freebody.errors",
    "SelfTestFailed": "freebody.errors",
    **dict.fromkeys(("acos", "asin", "atan", "cos", "exp", "log", "sin", "sqrt", "tan"), "freebody.functions"),
}

__all__ = [
    "Answer",
    "CannotAnswer",
    "Conservation",
    "Equations",
    "Fit",
    "FreebodyError",
    "Gradient",
    "InputError",
    "Mobility",
    "Model",
    "ModelError",
    "Optimum",
    "RoutesDisagree",
    "SelfTestFailed",
    "Sensitivity",
    "Simulation",
    "SimulationOptions",
    "Simulator",
    "Solution",
    "Statics",
    "Sweep",
    "System",
    "acos",
    "asin",
    "atan",
    "check",
    "conserved",
    "cos",
    "draw",
    "effort",
    "equations_of_motion",
    "equilibria",
    "exp",
    "explain",
    "export",
    "fit",
    "free_body",
    "gradient",
    "inverse_dynamics",
    "log",
    "mobility",
    "modes",
    "optimise",
    "over_a_turn",
    "phases",
    "picture",
    "sensitivity",
    "simulate",
    "sin",
    "solve",
    "speed_table",
    "sqrt",
    "statics",
    "sweep",
    "synthesise",
    "tan",
]


def __getattr__(name: str) -> Any:
    from freebody.studies import STUDIES

    if name == "__version__":
        from importlib.metadata import version

        return version("freebody")
    if name in _HOMES:
        return getattr(import_module(_HOMES[name]), name)
    if name in STUDIES:
        return STUDIES[name].function
    if name in ("load", "read", "from_file", "from_yaml"):  # what one tries first
        raise AttributeError(
            f"module 'freebody' has no attribute {name!r}. A model file is read by freebody.System.load"
        )
    if name in ("from_dict", "from_data", "from_text", "loads"):
        raise AttributeError(
            f"module 'freebody' has no attribute {name!r}. A model of plain data is read by freebody.System.from_data, "
            "YAML text by freebody.System.from_text"
        )
    if not name[:1].isupper():
        # also what `from freebody import progress` asks first: is it an attribute? Then it is imported as a module
        raise AttributeError(f"module 'freebody' has no attribute {name!r}")
    found = _descriptions().get(name)
    if found is None:
        also = [kind for kind, spec in _descriptions().items() if name.lower() in spec.also]
        meant = f": write freebody.{' or freebody.'.join(also)}" if also else ""
        raise AttributeError(f"module 'freebody' has no attribute {name!r}{meant}")
    return found


def __dir__() -> list[str]:
    """What there is: the studies, their results, and the descriptions of shapes, connections and loads."""
    return sorted({*__all__, *_descriptions(), "__doc__", "__version__"})


def _descriptions() -> dict[str, Any]:
    """Shapes, connections and loads by their class names."""
    homes = {
        "Shape": "freebody.model.shapes.base",
        "Connection": "freebody.connections.base",
        "Load": "freebody.loads.base",
    }
    kinds = [getattr(import_module(home), base).kinds.values() for base, home in homes.items()]
    return {kind.__name__: kind for own in kinds for kind in own}
