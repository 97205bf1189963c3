# SPDX-License-Identifier: LGPL-2.1-or-later
"""
The page of a study: error against cost, orders, curves, pictures, and what every point is and took.
"""

import os
import tempfile
import time

import matplotlib
import numpy as np

from .curves import COLOURS
from .errors import InputError
from .page import Page, data_address, escape, joined, tag
from .picture import Options, picture_of
from .report import add_parameters
from .report_curves import thinned
from .report_entry import Entry, in_words
from .study_picture import COST_TEXTS, bars_of, groups_of, usable
from .study_quantities import curve_of, exact_curve
from .study_text import (
    about_places,
    cost_in_words,
    in_doubt,
    percent,
    place_rows,
    told_error,
    what_would_decide,
)
from .units import describe, html_of, scaled_unit, split_unit

PICTURES = 24  # most on a page
SYMBOLS = ("circle", "square", "triangle-up", "diamond", "triangle-down", "cross", "star")
FRONT_COLOUR = "#8a949e"


def study_page(findings, pictures=True):
    """The page about a study."""
    study = findings.study
    states = [record["status"] for one in findings.results for record in one.records]
    page = Page(
        study.title,
        joined(
            (tag("span", f"{states.count(state)} runs {state}") for state in dict.fromkeys(states)),
            " ",
        ),
    )
    entries = entries_of(findings)
    overview = page.section("Overview")
    overview.warnings(warnings_of(findings, entries))
    add_levels(overview, findings)
    add_trade(page, findings)
    add_orders(page, findings)
    add_curves(page, findings, entries)
    if pictures:
        add_pictures(page, findings, entries)
    add_points(page, findings)
    add_parameters(page, [entry for entry in entries.values() if entry is not None])
    versions = sorted(
        {
            str(entry.summary["version"])
            for entry in entries.values()
            if entry and "version" in entry.summary
        }
    )
    page.foot = (
        f"Made by softgrain study on {time.strftime('%-d %B %Y, %H:%M')} of {study.path}, scene"
        f" {study.scene}"
        + (f"; softgrain {', '.join(versions)}" if versions else "")
        + "."
    )
    return page


def entries_of(findings):
    """
    {number of the point: Entry of its first finished run, None without one}, the colours from dark
    to light.
    """
    colours = matplotlib.colormaps["viridis"](np.linspace(0.0, 0.88, max(len(findings.results), 2)))
    result = {}
    for number, one in enumerate(findings.results):
        run = next((run for run in one.runs if run is not None), None)
        result[number] = (
            Entry(run, one.point.label, matplotlib.colors.to_hex(colours[number]))
            if run is not None
            else None
        )
    return result


def warnings_of(findings, entries):
    lines = []
    for number, one in enumerate(findings.results):
        colour = entries[number].colour if entries[number] else "#b3261e"
        lines += [(colour, one.point.label, note) for note in one.notes]
        if one.status not in ("completed",) and not one.notes:
            lines.append((colour, one.point.label, f"this point is {one.status}"))
    return lines


def add_levels(section, findings):
    """The cheapest point for every level of the error."""
    study = findings.study
    rows = []
    for quantity in study.quantities:
        for level in study.levels:
            found = findings.verdict(quantity, level)
            one = found.result
            decides = what_would_decide(findings, quantity, found)
            doubt = (
                "" if found.sure else f"{in_doubt(findings, quantity)} ({decides}); it would say: "
            )
            cells = [
                f"≤ {percent(level)}",
                doubt + (one.point.label if one else "no point of this study"),
                told_error(one, quantity) if one else "",
                cost_in_words(study.cost, one.cost(study.cost)) if one else "",
            ]
            rows.append((quantity.name, cells, ""))
    section.table(
        ["quantity", "error", "cheapest point", "its error", COST_TEXTS[study.cost][0]], rows
    )
    for quantity in study.quantities:
        if places := place_rows(findings, quantity):
            about = about_places(findings, quantity)
            section.text(
                "One packing: grains that rearrange a little earlier or later change"
                f" {quantity.name} at one place. ± is how much the error of a point, or of one that"
                " costs more, changes when single places are left out. Another packing may have"
                " other errors: several of them tell more. Errors place by place:"
                if findings.has_one_packing(quantity)
                else f"{about[:1].upper()}{about[1:]}:"
            )
            section.table(places[0], [(row[0], row[1:], "") for row in places[1:]])
    exact = [quantity.name for quantity in study.quantities if not quantity.needs_run]
    told = (
        "An error is relative: to the reference at each place, or in a window to the largest value"
        " of the reference there."
    )
    if exact:
        told += f" The reference of {' and '.join(exact)} is a formula or a curve."
    if study.reference:
        others = [quantity.name for quantity in study.quantities if quantity.needs_run]
        told += (
            f" The reference of {' and '.join(others)} is the run with "
            f"{', '.join(f'{name} = {value}' for name, value in study.reference.items())}."
        )
    section.text(told)


def add_trade(page, findings):
    study = findings.study
    text, _, unit = COST_TEXTS[study.cost]
    many, groups = groups_of(findings)
    section = page.section("Error against cost")
    for quantity in study.quantities:
        shown = {id(one): (cost, error) for one, cost, error in usable(findings, quantity.name)}
        if not shown:
            section.text(f"{quantity.name}: no point has an error and a cost.")
            continue
        front = sorted(
            shown[id(one)]
            for one in findings.results
            if id(one) in shown and one.front[quantity.name]
        )
        traces = [
            {
                "type": "scatter",
                "mode": "lines",
                "name": (
                    "best points" if findings.is_front_sure(quantity) else "perhaps the best points"
                ),
                "x": [a for a, _ in front],
                "y": [b for _, b in front],
                "line": {"color": FRONT_COLOUR, "dash": "dash", "width": 1.5, "shape": "hv"},
                "hoverinfo": "skip",
            }
        ]
        for number, (others, group) in enumerate(groups.items()):
            points = [one for one in group if id(one) in shown]
            if not points:
                continue
            trace = {
                "type": "scatter",
                "mode": "markers+text",
                "name": escape(others or quantity.name),
                "x": [shown[id(one)][0] for one in points],
                "y": [shown[id(one)][1] for one in points],
                "text": [escape(one.point.values[many.name]) for one in points] if many else [],
                "textposition": "top right",
                "textfont": {"size": 11},
                "customdata": [escape(one.point.label) for one in points],
                "marker": {
                    "size": 10,
                    "color": COLOURS[number % len(COLOURS)],
                    "symbol": SYMBOLS[number % len(SYMBOLS)],
                    "line": {"color": "#fff", "width": 1},
                },
                "hovertemplate": (
                    "%{customdata}<br>error %{y:.3g}<br>"
                    + f"{text} %{{x:.3g}} {unit}<extra></extra>"
                ),
            }
            if (bars := bars_of(points, quantity)) is not None:
                trace["error_y"] = {"type": "data", "visible": True, "thickness": 1, "array": bars}
            traces.append(trace)
        section.traces(
            quantity.name.replace("_", " "),
            traces,
            {
                "xaxis": {
                    **logarithmic([cost for cost, _ in shown.values()]),
                    "title": {"text": f"{text} [{unit}]"},
                },
                "yaxis": error_axis([error for _, error in shown.values()]),
                "hovermode": "closest",
            },
            wide=len(study.quantities) == 1,
        )
    section.text(
        ("Numbers beside the points are values of " + many.name + ". " if many else "")
        + "The dashed line joins the points that no other beats in both. A bar is what an error may"
        " be off by: the standard error of a mean over runs, and of one packing four times what"
        " leaving out places changes."
    )


def logarithmic(values):
    """An axis with numbers at 1, 2 and 5 where there is room for them."""
    wide = max(values) / min(values) > 1e3
    return {
        "type": "log",
        "dtick": 1 if wide else "D2",
        "tickformat": "~g" if max(values) > 0.01 else "~e",
        "minorloglabels": "complete",
    }


def error_axis(values):
    return {**logarithmic(values), "title": {"text": "relative error"}, "tickformat": "~%"}


def add_orders(page, findings):
    if not findings.orders:
        return
    section = page.section("Convergence")
    names = list(dict.fromkeys((order.quantity, order.knob) for order in findings.orders))
    for quantity, knob in names:
        group = [
            order for order in findings.orders if (order.quantity, order.knob) == (quantity, knob)
        ]
        traces = []
        for number, order in enumerate(group):
            others = ", ".join(f"{name} = {value}" for name, value in order.others.items())
            told = f"order {order.order:.2g}" if order.good else "no order"
            traces.append(
                {
                    "type": "scatter",
                    "mode": "lines+markers",
                    "name": escape(f"{others}: {told}" if others else told),
                    "x": order.values,
                    "y": order.errors,
                    "line": {"color": COLOURS[number % len(COLOURS)], "width": 2},
                }
            )
        section.traces(
            f"{quantity.replace('_', ' ')} over {knob}",
            traces,
            {
                "xaxis": {
                    **logarithmic([value for order in group for value in order.values]),
                    "title": {"text": escape(knob)},
                },
                "yaxis": error_axis([error for order in group for error in order.errors]),
                "hovermode": "closest",
                "showlegend": True,
            },
        )
    section.text(
        "The order p is that of error = C |value^p - reference^p|, or of C value^p where the"
        " reference is exact; it is told where this leaves less than a hundredth of the variance of"
        " the logarithms."
    )


def add_curves(page, findings, entries):
    study = findings.study
    section = page.section("Curves")
    for quantity in study.quantities:
        y, x = quantity.name, quantity.x.text
        page.columns[x] = column_of(quantity.x.text)
        series, largest = [], 0.0
        for number, one in enumerate(findings.results):
            entry = entries[number]
            if entry is None:
                continue
            try:
                a, b = curve_of(entry.run, quantity)
            except InputError:
                continue
            largest = max(largest, np.abs(b).max(initial=0.0))
            name = f"{number}/{quantity.name}"
            page.tables[name] = {
                x: thinned({"x": a})["x"].tolist(),
                y: thinned({"y": b})["y"].tolist(),
            }
            told = (
                f"{one.point.label} (reference)"
                if quantity.needs_run and one.point.is_reference
                else one.point.label
            )
            series.append(
                {
                    "name": escape(told),
                    "tables": [name],
                    "colour": entry.colour,
                    "dash": "solid",
                    "y": y,
                }
            )
        if not quantity.needs_run:
            a, b = exact_curve(quantity, findings.results[0].point.values)
            page.tables[f"reference/{quantity.name}"] = {x: a.tolist(), y: b.tolist()}
            series.append(
                {
                    "name": "reference",
                    "tables": [f"reference/{quantity.name}"],
                    "colour": "#000000",
                    "dash": "dot",
                    "y": y,
                }
            )
        divisor, unit = scaled_unit(unit_of(quantity.y), largest)
        page.columns[y] = {
            "label": escape(quantity.name.replace("_", " ")),
            "unit": unit,
            "divisor": divisor,
        }
        section.curves(quantity.name.replace("_", " "), series, [x], [y], wide=True)


def unit_of(formula):
    """The unit of a column, or of a formula that only adds columns of one unit."""
    units = {split_unit(name)[1] for name in formula.names}
    return (
        units.pop()
        if len(units) == 1 and "/" not in formula.text and "^" not in formula.text
        else ""
    )


def column_of(name):
    return {"label": html_of(escape(describe(name))), "unit": split_unit(name)[1], "divisor": 1}


def add_pictures(page, findings, entries):
    """The last state of every point, the cheapest first, on one scale."""
    found = []
    for entry in entries.values():
        if entry is None or not entry.run.source:
            continue
        try:
            run = entry.run.for_pictures()
            found.append((entry, run[len(run) - 1]))
        except (InputError, OSError):
            continue  # a point without a picture is no fault of the study
    if not found:
        return
    section = page.section("Pictures")
    items = []
    chosen = (
        found
        if len(found) <= PICTURES
        else [found[i] for i in np.linspace(0, len(found) - 1, PICTURES).astype(int)]
    )
    with tempfile.TemporaryDirectory(prefix="softgrain-study-") as folder:
        picture = None
        for number, (entry, state) in enumerate(chosen):
            path = os.path.join(folder, f"{number}.png")
            try:
                picture = picture or picture_of(Options(), [one for _, one in chosen])
                picture.save(state, path, 90)
            except InputError:
                continue
            items.append((data_address(path), entry.label))
    section.figures(items)
    section.text(
        "The last state of the first run of every point, all with one scale of colours."
        + (f" {len(chosen)} of {len(found)} points." if len(chosen) < len(found) else "")
    )


def add_points(page, findings):
    study = findings.study
    section = page.section("Points")
    averaged = any(knob.average for knob in study.knobs)
    sure = {quantity.name: findings.is_front_sure(quantity) for quantity in study.quantities}
    head = ["point"]
    for quantity in study.quantities:
        head += [f"error of {quantity.name}"] + (["scatter of a run"] if averaged else [])
    head += ["processor", "time", "memory", "steps", "Newton / step", "sweeps / step", "status"]
    rows = []
    for one in findings.results:
        cells = []
        for found in one.differences.values():
            cells += [
                (
                    "reference"
                    if one.point.is_reference and found.error != found.error and not found.note
                    else percent(found.error)
                )
            ] + ([percent(found.scatter)] if averaged else [])
        cells += [
            in_words(value) if np.isfinite(value) else ""
            for value in (one.cost("cpu_seconds"), one.cost("wall_seconds"))
        ]
        memory = one.cost("peak_memory_bytes")
        cells += [f"{memory / 2**20:,.0f} MiB" if np.isfinite(memory) else ""]
        cells += [f"{one.steps:.0f}" if np.isfinite(one.steps) else ""]
        cells += [
            f"{value:.3g}" if np.isfinite(value) else ""
            for value in (one.per_step("newton_iterations"), one.per_step("contact_sweeps"))
        ]
        best = " and ".join(
            name.replace("_", " ") + ("" if sure[name] else " (perhaps)")
            for name, is_best in one.front.items()
            if is_best
        )
        cells += [one.status + (f"; best for {best}" if best else "")]
        rows.append((one.point.label, cells, "differs" if best else ""))
    section.table(head, rows, search=True)
