"""How the bodies move: velocities, accelerations, and the partial velocities S = dV/du by the independent speeds."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cached_property

from freebody.symbolic.bodies import Bodies, Parts
from freebody.symbolic.configuration import Configuration
from freebody.symbolic.speeds import Speeds


class SymbolicKinematics:
    """The motion of every body along its slots, each part when it is first asked for."""

    def __init__(
        self,
        bodies: Bodies,
        configuration: Configuration,
        speeds: Speeds,
        velocities: Mapping[str, Parts] | None = None,
        body_accelerations: Mapping[str, Parts] | None = None,
    ) -> None:
        """velocities and body_accelerations: taken instead of the rates of the poses."""
        self._bodies, self._configuration, self._speeds = bodies, configuration, speeds
        if velocities is not None:
            self.velocities = velocities
        if body_accelerations is not None:
            self.body_accelerations = body_accelerations

    @cached_property
    def velocities(self) -> Mapping[str, Parts]:
        """Velocity of the mass centre and angular velocity of every body."""
        return self._bodies.velocities(self._configuration.poses, self._configuration.express, self._speeds.rate)

    @cached_property
    def partial_velocities(self) -> dict[str, list[Parts]]:
        """d(velocity of the mass centre, angular velocity)/du_k, for every body and independent speed."""
        return {
            name: [tuple(self._speeds.slope(part, c) for part in v) for c in self._speeds.coordinates]
            for name, v in self.velocities.items()
        }

    @cached_property
    def body_accelerations(self) -> Mapping[str, Parts]:
        """With the accelerations du/dt as generators."""
        return {name: tuple(map(self._speeds.rate, v)) for name, v in self.velocities.items()}
