"""Studies of one law of motion, for systems whose motion may change it: the contact states of the start are kept."""

from __future__ import annotations

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message
from freebody.numeric.options import ImpactLaw
from freebody.study.answering.draws import SEED, draw_parameters
from freebody.system.modes import ContactMode, in_mode
from freebody.system.system import System


def settled(system: System, *, forces: bool = True) -> System:
    """The system with what touches at the start held in touch and what sticks held where it is; any other system
    as it is.

    forces: the study is about forces too. Then friction that slides at the start is refused: its force changes with the
    phases of the motion. Raises CannotAnswer, also where nothing consistent follows on the start."""
    if not system.bounds and not system.dry_friction:
        return system
    mode = start_mode(system)
    connections = {f.row.name: f.row.connection for f in system.dry_friction}
    sliding = dict.fromkeys(connections[name] for name, state in mode.dry_friction if state != 0)
    if sliding and forces:
        raise CannotAnswer(
            Message(
                "{names} slides at the start, and its force changes with the phases of the motion: "
                "freebody solve derives them one by one, with the equations of each; freebody simulate follows them",
                names=", ".join(sliding),
            )
        )
    kept = ContactMode.of(mode.closed, {name: state for name, state in mode.dry_friction if state == 0})
    return in_mode(system, kept)[0]


def without_friction(system: System) -> System:
    """The same for studies of equilibria. Raises CannotAnswer for dry friction: with it a system rests in whole ranges
    of poses and forces."""
    if system.dry_friction:
        raise CannotAnswer(
            Message(
                "with dry friction ({names}) there is no "
                "single equilibrium: a system rests in whole ranges of poses and forces. freebody statics tells "
                "whether it "
                "holds, and what fails first",
                names=", ".join(dict.fromkeys(rub.row.connection for rub in system.dry_friction)),
            )
        )
    return settled(system)


def start_mode(system: System) -> ContactMode:
    """The contact states at the start, at the values of the model, or at drawn ones where it gives none."""
    import random

    from freebody.numeric.contact.after import HELD_ALONE  # imported where a model has a contact
    from freebody.numeric.contact.transition import InstantTransition
    from freebody.study.simulation.simulator import Simulator

    given = None if system.has_values else draw_parameters(system, random.Random(SEED), 1.0)
    simulator = Simulator(system, given)
    bounded = simulator.bounded
    if bounded is None:  # nothing can part or slip
        return ContactMode.of(frozenset(), {})
    found = InstantTransition(bounded, ImpactLaw.NEWTON).after(simulator.start, 0.0, simulator.engine.near(), None)
    if found.mode is None:
        told = Message("no force is consistent at the start with {why}", why=found.why)
        raise CannotAnswer(told if found.why == HELD_ALONE else Message("{what} (Painleve's paradox)", what=told))
    ideal = {b.name for b in bounded.barriers if b.is_ideal}
    closed = {bounded.barriers[k].name for k in found.mode.closed} | ideal
    states = {d.name: s for d, s in zip(bounded.drags, found.mode.drags, strict=True) if s is not None}
    return ContactMode.of(closed, states)
