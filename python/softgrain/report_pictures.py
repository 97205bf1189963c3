# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pictures and films of a page about runs."""

import os
import re
import tempfile

import numpy as np

from . import film
from .errors import InputError
from .page import data_address, tag
from .picture import Options, Picture, picture_of

PICTURE_DPI, FILM_DPI = 150, 110


def add_pictures(page, entries, choices, problems):
    found = []
    for entry in entries:
        if not entry.run.source:
            continue
        try:
            run = entry.run.for_pictures()
            found.append((entry, run, *states_of(entry, run, choices, problems)))
        except (InputError, OSError) as error:
            problems.append((entry.colour, entry.label, str(error)))
    if not found:
        return
    section = page.section("Pictures")
    common = picture_of_all([states for *_, states, _ in found], choices)
    for entry, run, states, ending in found:
        try:
            picture = common or picture_of(Options(field=choices.field), states)
            items = pictures_of(run, states, picture, ending, choices)
        except (InputError, OSError) as error:
            problems.append((entry.colour, entry.label, str(error)))
            continue
        if len(entries) > 1:
            section.add(tag("div", entry.chip, class_="run"))
        section.figures(items)
    if len(found) > 1:
        section.text(
            "One scale of colours and one of forces for all runs."
            if common
            else "Every run has its own scales: the scenes are of different kinds or sizes."
        )


def states_of(entry, run, choices, problems):
    """The states that are drawn, and the ending of a film, None without one."""
    numbers, ending = sorted({0, len(run) - 1}), None
    if choices.film and len(run) > 2:
        try:
            ending = film.best_ending()
            numbers = np.unique(
                np.linspace(0, len(run) - 1, min(choices.frames, len(run))).astype(int)
            ).tolist()
        except InputError as error:
            problems.append((entry.colour, entry.label, f"there is no film: {error}"))
    return [run[number] for number in numbers], ending


def picture_of_all(series, choices, alike=0.2):
    """
    What pictures of several runs have in common; None when one run differs in model or by so much
    in size, and in space, where each picture has a view of its own.
    """
    if any(states[0].dimension == 3 for states in series):
        return None
    if len({(states[0].run.model, states[0].has("points")) for states in series}) > 1:
        return None
    try:
        sizes = [np.ptp(Picture.places(states[0]), axis=0) for states in series]
        if np.ptp(sizes, axis=0).max() > alike * np.max(sizes):
            return None
        return picture_of(
            Options(field=choices.field), [state for states in series for state in states]
        )
    except InputError:
        return None  # each run says for itself what is missing


def pictures_of(run, states, picture, ending, choices):
    """(address, caption) of a film and of the last and the first state."""
    items = []
    with tempfile.TemporaryDirectory(prefix="softgrain-report-") as folder:
        if ending:
            path = os.path.join(folder, "film" + ending)
            film.make(
                path,
                choices.fps,
                lambda number, file: picture.save(states[number], file, FILM_DPI),
                len(states),
            )
            items.append(
                (
                    data_address(path),
                    (
                        f"{len(states)} of {len(run)} states"
                        if len(states) < len(run)
                        else f"all {len(run)} states"
                    ),
                )
            )
        for name, state in (
            {"last": states[-1], "first": states[0]}.items()
            if len(states) > 1
            else [("only", states[0])]
        ):
            path = os.path.join(folder, f"{name}.png")
            picture.save(state, path, PICTURE_DPI)
            items.append((data_address(path), f"{name} state, {when(picture, state)}"))
        if shows_pressures(states[-1], picture, choices):
            path = os.path.join(folder, "pressures.png")
            pressures = picture_of(Options(field="contact_pressure"), [states[-1]])
            pressures.save(states[-1], path, PICTURE_DPI)
            items.append(
                (
                    data_address(path),
                    f"pressure along contacts, last state, {when(picture, states[-1])}",
                )
            )
    return items


def when(picture, state):
    """
    The time of a state, in the unit that the pictures have, and what else their titles say, without
    the signs of mathematics.
    """
    title = picture.title(state)
    for sign, text in {r"\Phi": "Φ", r"\varepsilon": "ε", r"_\mathrm{q}": "_q", "$": ""}.items():
        title = title.replace(sign, text)
    return re.sub(r" {2,}", ", ", title)


def shows_pressures(state, picture, choices):
    """Material points of the plane that touch, unless the page shows that already."""
    if state.dimension == 3:
        return False
    first = getattr(picture, "pictures", [picture])[0]
    return (
        (choices.field or "") != "contact_pressure"
        and not first.primaries
        and state.has("contacts")
        and state.has("outlines")
        and len(state.pairs) > 0
    )
