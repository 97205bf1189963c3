# SPDX-License-Identifier: LGPL-2.1-or-later
"""A run as an entry of a page, and how a page tells numbers."""

import os
from dataclasses import dataclass

from .page import chip
from .units import scaled_unit

FROM_STEPS = ("wall_seconds", "microseconds_per_point_step", "energy_balance_error", "momentum_error", "max_contact_residual",
              "max_penetration_m", "peak_memory_bytes")  # of summary.json; nothing at the start of a run


@dataclass
class Entry:
    """A run with its name and its colour."""
    run: object
    label: str
    colour: str

    @property
    def chip(self):
        return chip(self.colour, self.label)

    @property
    def summary(self):
        """
        summary.json. While the run goes on it is of the last checkpoint: then steps and time are those of history.csv, and what
        was not known at the start is left out.
        """
        found = dict(self.run.summary or {})
        if found.get("status") == "running" and os.path.exists(self.run.path("history.csv")):
            if not found.get("steps"):
                found = {key: found[key] for key in found if key not in FROM_STEPS}
            history = self.run.history_table
            if len(history) and "step" in history:
                found.update(steps=int(history["step"][-1]), simulated_time_s=float(history["time_s"][-1]))
        return found

    @property
    def status(self):
        return self.run.status or "unknown"


@dataclass
class Choices:
    """What the user may choose; the names are those of the options of `softgrain report`."""
    title: str = None
    field: str = None
    labels: list = None
    film: bool = True
    frames: int = 40
    fps: float = 8.


def in_words(seconds):
    """
    A duration.

    >>> in_words(0.51), in_words(83), in_words(7400)
    ('0.51 s', '1 min 23 s', '2 h 03 min')
    """
    if seconds < 60:
        return f"{seconds:.2g} s"
    whole = round(seconds)
    return f"{whole // 60} min {whole % 60:02d} s" if whole < 3600 else f"{whole // 3600} h {whole % 3600 // 60:02d} min"


def with_prefix(value, unit):
    scale, text = scaled_unit(unit, abs(value))
    return f"{value / scale:.4g} {text}"


def heads(entries, text=""):
    """The head of a table with a column for every run; of a single run there is nothing to say."""
    return [text, *(entry.chip for entry in entries)] if len(entries) > 1 else [text, ""]
