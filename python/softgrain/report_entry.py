# SPDX-License-Identifier: LGPL-2.1-or-later
"""A run as an entry of a page, and how a page tells numbers."""

import math
import os
from dataclasses import dataclass
from typing import Optional

from .folder import Run
from .page import chip
from .units import scaled_unit

FROM_STEPS = (
    "wall_seconds",
    "microseconds_per_point_step",
    "energy_balance_error",
    "momentum_error",
    "max_contact_residual",
    "max_penetration_m",
    "peak_memory_bytes",
    "processor_seconds",
)  # of summary.json; nothing at the start of a run

STATUSES = ("running", "completed", "interrupted", "failed")
TEXTS = ("status", "model", "version")  # of summary.json; all else are numbers, but for the phases


@dataclass
class Entry:
    """A run with its name and its colour."""

    run: Run
    label: str
    colour: str

    @property
    def chip(self):
        return chip(self.colour, self.label)

    @property
    def summary(self):
        """
        summary.json. While the run goes on it is of the last checkpoint: then steps and time are
        those of history.csv, and what was not known at the start is left out.
        """
        found = proper(self.run.summary or {})
        if found.get("status") == "running" and os.path.exists(self.run.path("history.csv")):
            if not found.get("steps"):
                found = {key: found[key] for key in found if key not in FROM_STEPS}
            history = self.run.history_table
            if len(history) and "step" in history:
                found.update(
                    steps=int(history["step"][-1]), simulated_time_s=float(history["time_s"][-1])
                )
        return found

    @property
    def status(self):
        return self.summary.get("status") or "unknown"

    @property
    def kind(self):
        """The status as the style of a page knows it."""
        return self.status if self.status in STATUSES else "unknown"


def is_number(value):
    return isinstance(value, (int, float)) and not isinstance(value, bool) and math.isfinite(value)


def proper(summary):
    """
    What a page can show of summary.json: of another kind than the program writes it, it is left
    out.

    >>> proper({"status": "completed", "steps": "many", "threads": 2,
    ...         "phases": {"output": 0.1, "contact": None}})
    {'status': 'completed', 'threads': 2, 'phases': {'output': 0.1}}
    """
    found = {}
    for key, value in summary.items():
        if key == "phases" and isinstance(value, dict):
            found[key] = {
                name: seconds
                for name, seconds in value.items()
                if is_number(seconds) and seconds >= 0
            }
        elif isinstance(value, str) if key in TEXTS else is_number(value):
            found[key] = value
    return found


@dataclass
class Choices:
    """What the user may choose; the names are those of the options of `softgrain report`."""

    title: Optional[str] = None
    field: Optional[str] = None
    labels: Optional[list] = None
    film: bool = True
    frames: int = 40
    fps: float = 8.0


def in_words(seconds):
    """
    A duration.

    >>> in_words(0.51), in_words(83), in_words(7400)
    ('0.51 s', '1 min 23 s', '2 h 03 min')
    """
    if seconds < 60:
        return f"{seconds:.2g} s"
    whole = round(seconds)
    return (
        f"{whole // 60} min {whole % 60:02d} s"
        if whole < 3600
        else f"{whole // 3600} h {whole % 3600 // 60:02d} min"
    )


def with_prefix(value, unit):
    scale, text = scaled_unit(unit, abs(value))
    return f"{value / scale:.4g} {text}"


def heads(entries, text=""):
    """The head of a table with a column for every run; of a single run there is nothing to say."""
    return [text, *(entry.chip for entry in entries)] if len(entries) > 1 else [text, ""]
