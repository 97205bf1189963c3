# SPDX-License-Identifier: LGPL-2.1-or-later
"""
What a page about finished or running runs shows: numbers, pictures, curves, contacts, times,
parameters.
"""

import os
import re
import time
from typing import Any, Callable, Dict, List, Tuple

import numpy as np

from .curves import COLOURS, moves, run_labels
from .page import Page, escape, joined, tag
from .report_contacts import add_contacts
from .report_curves import add_curves
from .report_entry import Choices, Entry, heads, in_words, with_prefix
from .report_pictures import add_pictures
from .units import describe

OFF_BALANCE = 0.05  # of the energies, from which a run is to be looked at
QUIET = 600.0  # seconds without a word after which a run that should go on has probably ended


def report(runs, choices=None):
    """
    The page about some runs.

    >>> from softgrain.page import read_data
    >>> data = read_data(report([example], Choices(film=False)).html())
    >>> data["tables"]["0/history"]["time_s"] == example.history_table["time_s"].tolist()
    True
    """
    choices = choices or Choices()
    labels = choices.labels or run_labels([run.directory for run in runs])
    entries = [
        Entry(run, label, COLOURS[number % len(COLOURS)])
        for number, (run, label) in enumerate(zip(runs, labels))
    ]
    title = choices.title or (labels[0] if len(labels) == 1 else f"{len(labels)} runs")
    page = Page(
        title,
        joined(
            (
                tag(
                    "span",
                    entry.chip if len(entries) > 1 else "",
                    " ",
                    tag("span", entry.status, class_=f"status {entry.kind}"),
                )
                for entry in entries
            ),
            " ",
        ),
    )
    problems: List[str] = []
    overview = page.section("Overview")
    add_pictures(page, entries, choices, problems)
    add_curves(page, entries)
    add_contacts(page, entries, problems)
    add_phases(page, entries)
    add_parameters(page, entries)
    add_logs(page, entries)
    overview.warnings(warnings_of(entries) + problems)
    add_numbers(overview, entries)
    versions = sorted({entry.summary["version"] for entry in entries if "version" in entry.summary})
    page.foot = (
        f"Made by softgrain report on {time.strftime('%-d %B %Y, %H:%M')}"
        + (f"; runs of softgrain {', '.join(versions)}" if versions else "")
        + "."
    )
    return page


# --- numbers and warnings ---

NUMBERS: Tuple[Tuple[str, str, Callable[[Any], str]], ...] = (
    ("status", "status", str),
    ("model", "model", str),
    ("bodies", "bodies", "{:,}".format),
    ("material_points", "material points", "{:,}".format),
    ("primaries", "primaries", "{:,}".format),
    ("steps", "steps", "{:,}".format),
    ("simulated_time_s", "simulated time", lambda value: with_prefix(value, "s")),
    ("wall_seconds", "time it took", in_words),
    ("processor_seconds", "processor time", in_words),
    ("threads", "threads", str),
    ("microseconds_per_point_step", "time per point and step", lambda value: f"{value:.3g} µs"),
    ("peak_memory_bytes", "most memory", lambda value: f"{value / 2**20:,.0f} MiB"),
    (
        "energy_balance_error",
        "error of the energy balance",
        lambda value: f"{value:.1e} of the largest term",
    ),
    ("momentum_error", "error of the momentum", "{:.1e}".format),
    ("max_contact_residual", "largest residual of contact", "{:.1e}".format),
    ("max_penetration_m", "deepest penetration", lambda value: with_prefix(value, "m")),
    ("version", "softgrain", str),
)


def add_numbers(section, entries):
    rows = [
        (
            text,
            [
                form(entry.summary[key]) if entry.summary.get(key) is not None else ""
                for entry in entries
            ],
            "",
        )
        for key, text, form in NUMBERS
        if any(key in entry.summary for entry in entries)
    ]
    last = [
        entry.run.history_table if os.path.exists(entry.run.path("history.csv")) else {}
        for entry in entries
    ]
    for column in ("axial_strain", "packing_fraction", "coordination"):
        if any(moves(table.get(column)) for table in last):
            rows.append(
                (
                    re.sub(r"\s*\$.*?\$", "", describe(column)).lower() + " at the end",
                    [
                        (
                            f"{table[column][-1]:.4g}"
                            if column in table and len(table) and np.isfinite(table[column][-1])
                            else ""
                        )
                        for table in last
                    ],
                    "",
                )
            )
    rows.append(("folder", [entry.run.directory for entry in entries], ""))
    section.table(heads(entries), rows, "whole" if len(entries) > 1 else "facts")


def warnings_of(entries):
    return [
        (entry.colour, entry.label, text) for entry in entries for text in warnings_of_run(entry)
    ]


def warnings_of_run(entry):
    summary, run = entry.summary, entry.run
    if not summary:
        yield "there is no summary.json: the folder may be no finished run"
    elif entry.status == "running":
        newest = max(
            os.stat(run.path(name)).st_mtime
            for name in ("summary.json", "history.csv")
            if os.path.exists(run.path(name))
        )
        quiet = time.time() - newest
        yield (
            "the run goes on; this page shows it as it was when the page was made"
            if quiet < QUIET
            else (
                "summary.json says that the run goes on, but nothing was written for"
                f" {in_words(quiet)}: it may have been killed"
            )
        )
    elif entry.status != "completed":
        yield (
            f"the run was {entry.status}; `softgrain run` with --restart goes on from its newest"
            " checkpoint"
            if entry.status == "interrupted"
            else f"the run {entry.status}"
        )
    if (summary.get("energy_balance_error") or 0) > OFF_BALANCE:
        yield (
            f"the energy balance is off by {summary['energy_balance_error']:.2g} of its largest"
            " term"
        )
    tolerance = run.parameters.get("Contact/Tolerance")
    if (
        isinstance(tolerance, (int, float))
        and (summary.get("max_contact_residual") or 0) > 1.001 * tolerance > 0
    ):
        yield (
            "contact was not solved to its tolerance in every step: the largest residual is "
            f"{summary['max_contact_residual']:.1e}, the tolerance {tolerance:g}"
        )


# --- times, parameters, log ---


def add_phases(page, entries):
    found = [entry for entry in entries if sum((entry.summary.get("phases") or {}).values()) > 0]
    if not found:
        return
    section = page.section("Where the time went")
    totals: Dict[str, float] = {}
    for entry in found:
        for name, seconds in entry.summary["phases"].items():
            totals[name] = totals.get(name, 0) + seconds
    names = sorted(totals, key=lambda name: totals[name], reverse=True)
    palette = [
        *COLOURS,
        "#999933",
        "#882255",
        "#44AA99",
        "#DDCC77",
        "#332288",
        "#AA4499",
        "#117733",
        "#88CCEE",
        "#CC6677",
    ]
    traces = [
        {
            "type": "bar",
            "orientation": "h",
            "name": escape(name),
            "y": [escape(entry.label) for entry in found],
            "x": [entry.summary["phases"].get(name, 0) for entry in found],
            "marker": {"color": palette[number % len(palette)]},
            "hovertemplate": f"%{{x:.3g}} s<extra>{escape(name)}</extra>",
        }
        for number, name in enumerate(names)
    ]
    section.traces(
        "",
        traces,
        {
            "barmode": "stack",
            "xaxis": {"title": {"text": "time [s]"}},
            "yaxis": {"autorange": "reversed"},
            "hovermode": "closest",
        },
        wide=True,
        height=130 + 46 * len(found),
    )
    rows = []
    for name in names:
        shares = [
            (entry.summary["phases"].get(name), sum(entry.summary["phases"].values()))
            for entry in found
        ]
        rows.append(
            (
                name,
                [
                    "" if one is None else f"{one:.3g} s ({100 * one / total:.1f} %)"
                    for one, total in shares
                ],
                "",
            )
        )
    section.table(heads(found), rows)


def add_parameters(page, entries):
    found = [entry for entry in entries if len(entry.run.parameters)]
    if not found:
        return
    section = page.section("Parameters")
    names = list(dict.fromkeys(name for entry in found for name in entry.run.parameters))
    groups: Dict[str, List[str]] = {}
    for name in names:
        groups.setdefault(name.rpartition("/")[0], []).append(name)
    rows: List[Tuple[Any, ...]] = []
    for group, members in sorted(
        groups.items(), key=lambda item: item[0] != ""
    ):  # those outside of sections first
        rows += [(group.replace("/", " / "),)] if group else []
        for name in members:
            values = [
                entry.run.parameters.text(name) if name in entry.run.parameters else ""
                for entry in found
            ]
            differs = "differs" if len(set(values)) > 1 and name != "Output directory" else ""
            rows.append((name.rpartition("/")[2], values, differs))
    section.table(heads(found), rows, "compared" if len(found) > 1 else "", search=True)


def add_logs(page, entries, most=40):
    found = [entry for entry in entries if os.path.exists(entry.run.path("run.log"))]
    if not found:
        return
    section = page.section("Log")
    for entry in found:
        with open(entry.run.path("run.log"), encoding="utf-8", errors="replace") as file:
            lines = file.read().splitlines()
        if len(found) > 1:
            section.add(tag("div", entry.chip, class_="run"))
        shown = (
            lines if len(lines) <= most else [f"… {len(lines) - most} lines before", *lines[-most:]]
        )
        section.add(tag("pre", "\n".join(shown)))
