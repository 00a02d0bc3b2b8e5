"""The system as users hold it in their hands: with every study as a method."""

from __future__ import annotations

from freebody.studies import Studies
from freebody.system.system import System as Description


class System(Studies, Description):
    """A mechanical system: immutable, from a file, from text or from Python objects."""

    __hash__ = Description.__hash__
