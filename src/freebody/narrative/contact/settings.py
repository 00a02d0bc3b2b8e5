"""The setup by which a system is opened: of a system with contacts or dry friction that of the law it begins with."""

from __future__ import annotations

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message
from freebody.questions.reading_when import is_of_start
from freebody.study.setup import Setup
from freebody.system.system import System


def setup_of(system: System) -> Setup:
    """Questions about rest look at the start pose with all that touches held there; motions in phases begin with the
    first phase."""
    asked = system.questions
    if asked and all(q.quantity.scope == "rest" for q in asked):
        from freebody.study.friction.answers import prepared

        return prepared(system).setup
    if not has_phases(system):
        return Setup(system)
    from freebody.study.phases.tree import tree_of
    from freebody.study.phases.without_phases import why_no_phases

    if why_no_phases(system):
        return Setup(system, 2)
    tree = tree_of(system)
    return tree.roots[0].phase.setup if tree.roots else tree.home


def first_mode(system: System) -> Setup:
    """The mode with which a motion begins, kept for good. Raises CannotAnswer where there is none."""
    from freebody.study.phases.kept import KeptMode
    from freebody.study.phases.tree import tree_of

    tree = tree_of(system)
    if not tree.roots:
        raise CannotAnswer(Message("no state of the contacts is consistent with the start"))
    return KeptMode(tree, tree.roots[0])


def changes_at_borders_alone(system: System) -> bool:
    """Whether nothing but loads that act beyond a border changes the law of motion on the way."""
    return bool(system.borders) and not (system.bounds or system.dry_friction or system.blows)


def has_phases(system: System) -> bool:
    """Whether the law of motion may change on the way, or something is asked of such a change: of an impact, where
    nothing is struck at the start."""
    return bool(system.bounds or system.dry_friction or system.blows or system.borders) or any(
        q.transition is not None or (is_of_start(q.quantity) and not system.is_struck) for q in system.questions
    )
