# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a page about finished or running runs shows: numbers, pictures, curves, contacts, times, parameters."""

import os
import re
import tempfile
import time
from dataclasses import dataclass

import numpy as np

from . import film
from .contacts import NONE
from .curves import COLOURS, moves, run_labels
from .errors import InputError
from .measures import coordination
from .page import Page, chip, data_address, escape
from .picture import Options, Picture
from .report_data import add_tables
from .units import describe, scaled_unit

PLOTLY_DASHES = ["solid", "dash", "dot", "dashdot"]
PICTURE_DPI, FILM_DPI = 150, 110
FEW_PAIRS = 30  # of which no distribution can be told
OFF_BALANCE = 0.05  # of the energies, from which a run is to be looked at
FROM_STEPS = ("wall_seconds", "microseconds_per_point_step", "energy_balance_error", "momentum_error", "max_contact_residual",
              "max_penetration_m", "peak_memory_bytes")  # of summary.json; nothing at the start of a run
QUIET = 600.  # seconds without a word after which a run that should go on has probably ended


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
    entries = [Entry(run, label, COLOURS[number % len(COLOURS)]) for number, (run, label) in enumerate(zip(runs, labels))]
    title = choices.title or (labels[0] if len(labels) == 1 else f"{len(labels)} runs")
    page = Page(title, " ".join(f'<span>{entry.chip if len(entries) > 1 else ""} <span class="status {entry.status}">'
                                f"{entry.status}</span></span>" for entry in entries))
    problems = []
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
    page.foot = f"Made by softgrain report on {time.strftime('%-d %B %Y, %H:%M')}" + (
        f"; runs of softgrain {', '.join(versions)}" if versions else "") + "."
    return page


# --- numbers and warnings ---

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


NUMBERS = (
    ("status", "status", str), ("model", "model", str), ("bodies", "bodies", "{:,}".format),
    ("material_points", "material points", "{:,}".format), ("primaries", "primaries", "{:,}".format),
    ("steps", "steps", "{:,}".format), ("simulated_time_s", "simulated time", lambda value: with_prefix(value, "s")),
    ("wall_seconds", "time it took", in_words), ("threads", "threads", str),
    ("microseconds_per_point_step", "time per point and step", lambda value: f"{value:.3g} µs"),
    ("peak_memory_bytes", "most memory", lambda value: f"{value / 2**20:,.0f} MiB"),
    ("energy_balance_error", "error of the energy balance", lambda value: f"{value:.1e} of the largest term"),
    ("momentum_error", "error of the momentum", "{:.1e}".format),
    ("max_contact_residual", "largest residual of contact", "{:.1e}".format),
    ("max_penetration_m", "deepest penetration", lambda value: with_prefix(value, "m")),
    ("version", "softgrain", str),
)


def add_numbers(section, entries):
    rows = [(text, [form(entry.summary[key]) if key in entry.summary else "" for entry in entries], "")
            for key, text, form in NUMBERS if any(key in entry.summary for entry in entries)]
    last = [entry.run.history_table if os.path.exists(entry.run.path("history.csv")) else {} for entry in entries]
    for column in ("axial_strain", "packing_fraction", "coordination"):
        if any(moves(table.get(column)) for table in last):
            rows.append((re.sub(r"\s*\$.*?\$", "", describe(column)).lower() + " at the end",
                         [f"{table[column][-1]:.4g}" if column in table and len(table) and np.isfinite(table[column][-1]) else ""
                          for table in last], ""))
    rows.append(("folder", [entry.run.directory for entry in entries], ""))
    section.table(heads(entries), rows, "whole" if len(entries) > 1 else "facts")


def heads(entries, text=""):
    """The head of a table with a column for every run; of a single run there is nothing to say."""
    return [text, *(entry.chip for entry in entries)] if len(entries) > 1 else [text, ""]


def warnings_of(entries):
    return [(entry.colour, entry.label, text) for entry in entries for text in warnings_of_run(entry)]


def warnings_of_run(entry):
    summary, run = entry.summary, entry.run
    if not summary:
        yield "there is no summary.json: the folder may be no finished run"
    elif entry.status == "running":
        newest = max(os.stat(run.path(name)).st_mtime for name in ("summary.json", "history.csv")
                     if os.path.exists(run.path(name)))
        quiet = time.time() - newest
        yield ("the run goes on; this page shows it as it was" if quiet < QUIET else
               f"summary.json says that the run goes on, but nothing was written for {in_words(quiet)}: it may have been killed")
    elif entry.status != "completed":
        yield f"the run was {entry.status}; `softgrain run` with --restart goes on from its newest checkpoint" \
            if entry.status == "interrupted" else f"the run {entry.status}"
    if summary.get("energy_balance_error", 0) > OFF_BALANCE:
        yield f"the energy balance is off by {summary['energy_balance_error']:.2g} of its largest term"
    tolerance = run.parameters.get("Contact/Tolerance")
    if isinstance(tolerance, (int, float)) and summary.get("max_contact_residual", 0) > 1.001 * tolerance > 0:
        yield (f"contact was not solved to its tolerance in every step: the largest residual is "
               f"{summary['max_contact_residual']:.1e}, the tolerance {tolerance:g}")


# --- pictures ---

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
            picture = common or Picture(Options(field=choices.field), states)
            items = pictures_of(run, states, picture, ending, choices)
        except (InputError, OSError) as error:
            problems.append((entry.colour, entry.label, str(error)))
            continue
        if len(entries) > 1:
            section.add(f'<div class="run">{entry.chip}</div>')
        section.figures(items)
    if len(found) > 1:
        section.text("One scale of colours and one of forces for all runs." if common else
                     "Every run has its own scales: the scenes are of different kinds or sizes.")


def states_of(entry, run, choices, problems):
    """The states that are drawn, and the ending of a film, None without one."""
    numbers, ending = sorted({0, len(run) - 1}), None
    if choices.film and len(run) > 2:
        try:
            ending = film.best_ending()
            numbers = np.unique(np.linspace(0, len(run) - 1, min(choices.frames, len(run))).astype(int)).tolist()
        except InputError as error:
            problems.append((entry.colour, entry.label, f"there is no film: {error}"))
    return [run[number] for number in numbers], ending


def picture_of_all(series, choices, alike=0.2):
    """What pictures of several runs have in common; None when one run differs in model or by so much in size."""
    if len({(states[0].run.model, states[0].has("points")) for states in series}) > 1:
        return None
    try:
        sizes = [np.ptp(Picture.places(states[0]), axis=0) for states in series]
        if np.ptp(sizes, axis=0).max() > alike * np.max(sizes):
            return None
        return Picture(Options(field=choices.field), [state for states in series for state in states])
    except InputError:
        return None  # each run says for itself what is missing


def pictures_of(run, states, picture, ending, choices):
    """(address, caption) of a film and of the last and the first state."""
    items = []
    with tempfile.TemporaryDirectory(prefix="softgrain-report-") as folder:
        if ending:
            path = os.path.join(folder, "film" + ending)
            film.make(path, choices.fps, lambda number, file: picture.save(states[number], file, FILM_DPI), len(states))
            items.append((data_address(path), f"{len(states)} of {len(run)} states" if len(states) < len(run) else
                          f"all {len(run)} states"))
        for name, state in {"last": states[-1], "first": states[0]}.items() if len(states) > 1 else [("only", states[0])]:
            path = os.path.join(folder, f"{name}.png")
            picture.save(state, path, PICTURE_DPI)
            items.append((data_address(path), f"{name} state, t = {with_prefix(state.time, 's')}"))
    return items


# --- curves ---

PANELS = (  # heading, columns, options
    ("Forces on the walls", r".*(?<!normal)_force_N_per_m$", {}),
    ("Packing fraction", r"packing_fraction$", {}),
    ("Coordination", r"coordination$", {}),
    ("Energies", r"(kinetic|elastic|dissipated)_energy_J_per_m$", {}),
    ("Stress of the box", r"(mean_pressure|deviator)_Pa$", {}),
    ("Anisotropy", r"(contact|normal_force)_anisotropy$", {}),
    ("Work of the solvers", r"(newton_iterations|contact_sweeps)$", {}),
    ("Residual of contact", r"contact_residual$", {"logy": True}),
    ("Time step", r"dt_s$", {}),
)


def add_curves(page, entries):
    tables = add_tables(page, entries)
    if not tables:
        return
    section = page.section("Curves")
    columns = list(dict.fromkeys(name for names in tables.values() for table in names for name in page.tables[table]))
    x_choices = [name for name in ("axial_strain", "time_s", "packing_fraction", "step") if
                 any(moves(np.array(page.tables[table].get(name) or [0], dtype=float))
                     for names in tables.values() for table in names)] or ["time_s"]
    for heading, pattern, options in PANELS:
        shown = [name for name in columns if re.match(pattern, name)]
        shown = [name for name in shown if any(moves(np.array(page.tables[table].get(name) or [0], dtype=float))
                                               for names in tables.values() for table in names)]
        if shown:
            section.curves(heading, series_of(entries, tables, shown, page.columns), x_choices, shown[:1], follow=True,
                           **options)
    every = series_of(entries, tables, [None], page.columns)
    section.curves("Any column against any other", every, first(x_choices[0], columns), first("elastic_energy_J_per_m", columns),
                   wide=True)


def first(name, columns):
    """The columns with one of them before all others."""
    return [one for one in columns if one == name] + [one for one in columns if one != name]


def series_of(entries, tables, columns, described):
    """A run has one colour, a column one way of dashing; of a single run each column has its colour."""
    series = []
    for number, entry in enumerate(entries):
        if number not in tables:
            continue
        for position, column in enumerate(columns):
            label = described[column]["label"] if column else entry.label
            name = label if len(entries) == 1 and column else escape(entry.label) if len(columns) == 1 else \
                f"{escape(entry.label)}: {label}"
            colour = COLOURS[position % len(COLOURS)] if len(entries) == 1 else entry.colour
            dash = "solid" if len(entries) == 1 else PLOTLY_DASHES[position % len(PLOTLY_DASHES)]
            series.append({"name": name, "tables": tables[number], "colour": colour, "dash": dash,
                           **({"y": column} if column else {})})
    return series


# --- contacts ---

def add_contacts(page, entries, problems):
    found = []
    for entry in entries:
        try:
            state = last_with_contacts(entry.run)
            if state is not None:
                found.append((entry, state, state.pairs))
        except (InputError, OSError) as error:
            problems.append((entry.colour, entry.label, str(error)))
    if not found:
        return
    section = page.section("Contacts")
    numbers = [numbers_of_contacts(state, pairs) for _, state, pairs in found]
    names = list(dict.fromkeys(name for one in numbers for name in one))
    section.table(heads([entry for entry, *_ in found], "Of the last state"),
                  [(name, [one.get(name, "") for one in numbers], "") for name in names])
    inner = [(entry, *between_bodies(pairs)) for entry, _, pairs in found]
    inner = [(entry, normal, force) for entry, normal, force in inner if len(force) >= FEW_PAIRS and force.mean() > 0]
    if inner:
        section.traces("How strong contacts are", [distribution(*one) for one in inner], {
            "xaxis": {"title": {"text": "normal force over its mean, f / ⟨f⟩"}, "hoverformat": ".3g"},
            "yaxis": {"title": {"text": "probability density"}, "type": "log"}, "hovermode": "closest"})
        n = 9 if min(len(force) for *_, force in inner) < 300 else 18
        roses = [rose(entry, normal, n) for entry, normal, _ in inner]
        reach = 1.05 * max(np.abs(one[axis]).max() for one in roses for axis in "xy")
        section.traces("Where contacts point", roses, {
            "xaxis": {"title": {"text": f"share of contacts within {180 // n}°"}, "range": [-reach, reach], "constrain": "domain"},
            "yaxis": {"range": [-reach, reach], "scaleanchor": "x", "constrain": "domain"}, "hovermode": "closest"})


def last_with_contacts(run):
    """The last state, from the snapshots or from the fields, that has contacts; None without one."""
    for states in (run.snapshots, run.fields):
        if len(states) and states[-1].has("contacts"):
            return states[-1]
    return None


def between_bodies(pairs):
    """Normals and normal forces of contacts between bodies that press."""
    kept = (pairs["body_b"] != NONE) & (pairs["normal_force_N_per_m"] > 0)
    return pairs["normal"][kept], pairs["normal_force_N_per_m"][kept]


def numbers_of_contacts(state, pairs):
    """Numbers of a state in words, {name: text}."""
    inner = pairs["body_b"] != NONE
    result = {"time": with_prefix(state.time, "s"), "contacts between bodies": f"{inner.sum():,}",
              "contacts with walls": f"{(~inner).sum():,}"}
    force = pairs["normal_force_N_per_m"][inner]
    if len(force):
        result["mean normal force"] = with_prefix(force.mean(), "N/m")
        result["largest normal force"] = with_prefix(force.max(), "N/m")
    if state.has("bodies"):
        found = coordination(state)
        result["contacts per body, walls too"] = f"{found['coordination']:.3g}"
        result["bodies with less than two contacts"] = f"{100 * found['rattler_fraction']:.3g} %"
    return result


def distribution(entry, _normal, force):
    """Probability density of the normal force over its mean."""
    ratio = force / force.mean()
    counts, edges = np.histogram(ratio, bins=min(24, max(8, len(ratio) // 12)), density=True)
    return {"type": "scatter", "mode": "lines+markers", "name": escape(entry.label), "x": 0.5 * (edges[1:] + edges[:-1]),
            "y": [value or None for value in counts], "line": {"color": entry.colour, "width": 2}}


def rose(entry, normal, n):
    """Share of contacts by direction, as a closed line around the middle; both ends of a contact count."""
    angle = np.arctan2(normal[:, 1], normal[:, 0]) % np.pi
    share = np.histogram(angle, bins=n, range=(0, np.pi))[0] / len(angle)
    share = np.concatenate([share, share])
    edges = np.linspace(0, 2 * np.pi, len(share) + 1)
    radius, way = np.repeat(share, 2), np.stack([edges[:-1], edges[1:]], axis=1).ravel()
    x, y = radius * np.cos(way), radius * np.sin(way)
    return {"type": "scatter", "mode": "lines", "name": escape(entry.label), "x": np.append(x, x[0]), "y": np.append(y, y[0]),
            "line": {"color": entry.colour, "width": 2}, "hoverinfo": "skip"}


# --- times, parameters, log ---

def add_phases(page, entries):
    found = [entry for entry in entries if sum((entry.summary.get("phases") or {}).values()) > 0]
    if not found:
        return
    section = page.section("Where the time went")
    totals = {}
    for entry in found:
        for name, seconds in entry.summary["phases"].items():
            totals[name] = totals.get(name, 0) + seconds
    names = sorted(totals, key=totals.get, reverse=True)
    palette = [*COLOURS, "#999933", "#882255", "#44AA99", "#DDCC77", "#332288", "#AA4499"]
    traces = [{"type": "bar", "orientation": "h", "name": name, "y": [escape(entry.label) for entry in found],
               "x": [entry.summary["phases"].get(name, 0) for entry in found],
               "marker": {"color": palette[number % len(palette)]}, "hovertemplate": "%{x:.3g} s<extra>" + name + "</extra>"}
              for number, name in enumerate(names)]
    section.traces("", traces, {"barmode": "stack", "xaxis": {"title": {"text": "time [s]"}},
                                "yaxis": {"autorange": "reversed"}, "hovermode": "closest"}, wide=True,
                   height=130 + 46 * len(found))
    rows = []
    for name in names:
        shares = [(entry.summary["phases"].get(name, 0), sum(entry.summary["phases"].values())) for entry in found]
        rows.append((name, [f"{one:.3g} s ({100 * one / total:.1f} %)" for one, total in shares], ""))
    section.table(heads(found), rows)


def add_parameters(page, entries):
    found = [entry for entry in entries if len(entry.run.parameters)]
    if not found:
        return
    section = page.section("Parameters")
    names = list(dict.fromkeys(name for entry in found for name in entry.run.parameters))
    groups = {}
    for name in names:
        groups.setdefault(name.rpartition("/")[0], []).append(name)
    rows = []
    for group, members in sorted(groups.items(), key=lambda item: item[0] != ""):  # those outside of sections first
        rows += [(group.replace("/", " / "),)] if group else []
        for name in members:
            values = [entry.run.parameters.text(name) if name in entry.run.parameters else "" for entry in found]
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
            section.add(f'<div class="run">{entry.chip}</div>')
        shown = lines if len(lines) <= most else [f"… {len(lines) - most} lines before", *lines[-most:]]
        section.add("<pre>" + escape("\n".join(shown)) + "</pre>")
