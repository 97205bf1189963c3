# SPDX-License-Identifier: LGPL-2.1-or-later
"""What pictures of the plane and of space share: options, text above them, how they are saved."""

from dataclasses import dataclass
from typing import Optional

import matplotlib.pyplot as plt
import numpy as np

from . import drawing
from .command import save_figure
from .coordinate import coordinate_at
from .units import scaled_unit


@dataclass
class Options:
    """What a picture shows; the names are those of the options of `softgrain render`."""

    field: Optional[str] = None
    range: Optional[tuple] = None
    colours: Optional[str] = None
    contacts: str = "auto"
    attraction: Optional[bool] = None
    style: Optional[str] = None
    title: Optional[str] = None
    width: Optional[float] = None  # inches
    zoom: Optional[tuple] = None
    view: Optional[tuple] = None  # in space: degrees about z, and above the plane of x and y
    cut: Optional[str] = None  # in space: "y=0.01"


def title_of(state, title, longest, several):
    """
    Time, in one unit for a series whose last is @longest, and packing fraction or strain where the
    scene goes by it; or the @title that is asked for.
    """
    if title is not None:
        return title
    scale, unit = scaled_unit("s", longest)
    time, longest = state.time / scale, longest / scale
    decimals = max(0, 3 - int(np.floor(np.log10(longest)))) if longest > 0 else 0
    text = f"$t$ = {time:.{decimals}f} {unit}" if several else f"$t$ = {time:.4g} {unit}"
    coordinate = coordinate_at(state.run, state.time) if getattr(state, "run", None) else ""
    return text + ("      " + coordinate if coordinate else "")


def save(picture, state, path, dpi):
    with plt.rc_context(drawing.STYLE):
        figure = picture.figure(state)
        try:
            save_figure(figure, path, dpi)
        finally:
            plt.close(figure)


__all__ = ["Options", "save", "title_of"]
