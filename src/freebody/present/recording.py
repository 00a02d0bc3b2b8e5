"""Everything along a motion as arrays with names, dimensions and units: what plots, tables and datasets are made of."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from freebody.errors import InputError
from freebody.messages import Message
from freebody.present.figures import Array

if TYPE_CHECKING:
    import xarray


@dataclass(frozen=True)
class Series:
    """One quantity: over `time` alone, or over bodies and axes as well. attributes: `units`, `long_name` and others."""

    dimensions: tuple[str, ...]
    values: Array
    attributes: Mapping[str, Any]

    @property
    def unit(self) -> str:
        return str(self.attributes.get("units", ""))

    @property
    def long_name(self) -> str:
        words: str = self.attributes.get("long_name", "")
        return words


@dataclass(frozen=True)
class Recording:
    """A motion. labels: of the dimensions besides time, such as the names of the bodies."""

    times: Array  # (n_times,) [s]
    series: Mapping[str, Series]
    labels: Mapping[str, Sequence[str]]
    attributes: Mapping[str, Any]

    @property
    def over_time(self) -> list[str]:
        """The names of what is over time alone."""
        return [name for name, series in self.series.items() if series.dimensions == ("time",)]

    def of(self, name: str, **chosen: str) -> Array:
        """The values of a series where other dimensions have the given labels: `of("body_position", body="rod",
        axis="x")`. Raises KeyError or ValueError for what is not there."""
        series = self.series[name]
        places = tuple(self.labels[d].index(chosen[d]) if d in chosen else slice(None) for d in series.dimensions)
        return np.asarray(series.values[places])

    def dataset(self) -> xarray.Dataset:
        """As an xarray dataset. Raises InputError where xarray is not installed."""
        try:
            import xarray
        except ModuleNotFoundError:
            raise InputError(Message('datasets need xarray; pip install "freebody[data]"')) from None
        data = {name: (s.dimensions, s.values, _plain(s.attributes)) for name, s in self.series.items()}
        time = ("time", self.times, {"units": "s", "long_name": "time"})
        return xarray.Dataset(data, coords={"time": time, **self.labels}, attrs=dict(self.attributes))


def _plain(attributes: Mapping[str, Any]) -> dict[str, Any]:
    """Without messages, which file formats do not take for texts."""
    return {key: str.__str__(value) if isinstance(value, str) else value for key, value in attributes.items()}
