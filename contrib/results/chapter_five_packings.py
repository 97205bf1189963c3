# SPDX-License-Identifier: LGPL-2.1-or-later
"""Means over packings of doc/results/thesis-5.md: what chapter_five_tables.py takes from runs that differ in their seed alone, a row for every
run and part of its way; and the table of their means. A small file keeps the rows."""
import csv
import re
import statistics

import numpy as np
from running import softgrain  # its folder has to be known before the package is imported
from softgrain.contacts import NONE
from softgrain.figures.paths import stages_of

TOGETHER = 8  # states one after the other: contacts of bonded grains flicker, so one that bears a force in any of them counts
PARTS = {"at rest": None, "to 0.1": (0., 0.1), "0.2 to 0.4": (0.2, 0.4), "0.56 to 0.8": (0.56, 0.8)}  # shear strain
# Name in the file: (column of measures.csv, or None; how many digits).
COLUMNS = {"q_over_p": (None, 3), "packing_fraction": ("packing_fraction", 3), "Z_of_states": ("coordination_of_bodies", 2), "Z_of_eight": (None, 2), "Z_of_all": (None, 2),
           "a_c": ("contact_anisotropy", 2), "a_f": ("normal_force_anisotropy", 2), "half_sum": ("half_sum_of_anisotropies", 3), "half_sum_over_q_over_p": (None, 2),
           "S": ("specific_contact_surface", 3), "eta": ("shape_strain", 3), "A_eta": ("shape_anisotropy", 3)}


def contacts_of(snapshots, places):
    """Contacts between grains in any of some states, two for each over the number of grains."""
    found = set()
    for place in places:
        state = snapshots[int(place)]
        pairs = state.pairs
        kept = (pairs.wall == NONE) & (pairs.normal_force_N_per_m > 0)
        found.update((min(a, b), max(a, b)) for a, b in zip(pairs.body_a[kept], pairs.body_b[kept]))
    return 2 * len(found) / len(state.bodies.area_m2)


def coordination(path, begin, end):
    """Mean over groups of states between two times, and that of all of them together."""
    snapshots = path.output.snapshots
    places = np.flatnonzero((snapshots.times >= begin * (1 - 1e-9)) & (snapshots.times <= end * (1 + 1e-9)))
    groups = [places[k:k + TOGETHER] for k in range(0, len(places) - TOGETHER + 1, TOGETHER)]
    return np.mean([contacts_of(snapshots, group) for group in groups]), contacts_of(snapshots, places)


def row_of(path, walls_of, part, between):
    """Of the second half of the time at rest, or of a part of the shear. @walls_of: as that of chapter_five_tables.py"""
    stages, measures = stages_of(path.output), path.output.measures_table
    _, begin, end = next(stage for stage in stages if stage[0] == ("shear" if between else "compact"))
    times, strain, stress = walls_of(path.output, begin, end)
    if between:
        kept = (strain >= between[0]) & (strain <= between[1])
        begin, end = times[kept][0], times[kept][-1]
    else:
        begin = 0.5 * (begin + end)
        kept = times >= begin
    states = (measures["time_s"] >= begin * (1 - 1e-9)) & (measures["time_s"] <= end * (1 + 1e-9))
    down, aside = ((0.5 * (stress[a] + stress[b]))[kept].mean() for a, b in (("top", "bottom"), ("left", "right")))
    row = {name: float(np.nanmean(measures[column][states])) for name, (column, _) in COLUMNS.items() if column}
    row["q_over_p"] = (down - aside) / (down + aside)
    row["Z_of_eight"], row["Z_of_all"] = coordination(path, begin, end)
    row["half_sum_over_q_over_p"] = row["half_sum"] / row["q_over_p"]
    seed = re.search(r"-seed(\d+)", str(path.output.directory))
    return {"pressure_over_stiffness": path.kappa, "seed": int(seed[1]), "part": part, **{name: row[name] for name in COLUMNS}}


def write(paths, walls_of, file_name):
    """The rows of runs of bonded grains, as a small file."""
    rows = [row_of(path, walls_of, part, between) for path in sorted(paths, key=lambda path: path.kappa) for part, between in PARTS.items()]
    with open(file_name, "w", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, rows[0].keys(), lineterminator="\n")
        writer.writeheader()
        writer.writerows({name: f"{value:.5g}" if isinstance(value, float) else value for name, value in row.items()} for row in rows)


def read(file_name):
    """The rows of a small file, and their pressures."""
    with open(file_name, newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    return rows, sorted({float(row["pressure_over_stiffness"]) for row in rows})


def values_of(rows, pressure, part, name):
    return [float(row[name]) for row in rows if float(row["pressure_over_stiffness"]) == pressure and row["part"] == part]


def draw(file_name, picture):
    """q/p, contacts and anisotropies over the pressure: means of packings, with a point for each."""
    import matplotlib
    matplotlib.use("Agg")
    import matplotlib.pyplot as pyplot
    rows, pressures = read(file_name)
    figure, axes = pyplot.subplots(1, 3, figsize=(10, 3.3))
    panels = (("q/p", (("q_over_p", part) for part in list(PARTS)[1:])), ("contacts of a grain", (("Z_of_eight", part) for part in PARTS)),
              ("last part of the shear", ((name, "0.56 to 0.8") for name in ("a_c", "a_f", "half_sum", "q_over_p"))))
    for panel, (title, lines) in zip(axes, panels):
        for k, (name, part) in enumerate(lines):
            mean = [statistics.mean(values_of(rows, pressure, part, name)) for pressure in pressures]
            panel.semilogx(pressures, mean, f"C{k}-", lw=1, label=name if title.startswith("last") else part)
            for pressure in pressures:
                values = values_of(rows, pressure, part, name)
                panel.plot([pressure] * len(values), values, f"C{k}o", ms=3)
        panel.set(xlabel="$p_c/p_I$", ylabel=title)
        panel.set_ylim(top=panel.get_ylim()[1] * (1.25 if title.startswith("last") else 1))
        panel.minorticks_off()
        panel.set_xticks(pressures, [f"{pressure:.2g}" for pressure in pressures])
        panel.legend(frameon=False, fontsize=7)
    figure.tight_layout()
    figure.savefig(picture, dpi=110)


def table(file_name):
    """Mean ± standard deviation over packings, of each quantity, part of the way and pressure."""
    rows, pressures = read(file_name)
    packings = {len({row["seed"] for row in rows if float(row["pressure_over_stiffness"]) == pressure}) for pressure in pressures}
    yield f"{' or '.join(map(str, sorted(packings)))} packings, mean ± standard deviation; p_c/p_I:\n"
    yield "| | " + " | ".join(f"{pressure:.2g}" for pressure in pressures) + " |\n|---" + "|---" * len(pressures) + "|"
    for name, (_, digits) in COLUMNS.items():
        for part in PARTS:
            if part == "at rest" and "q_over_p" in name or part != "at rest" and name == "Z_of_all":
                continue
            cells = []
            for pressure in pressures:
                values = values_of(rows, pressure, part, name)
                scatter = f" ± {statistics.stdev(values):.{digits}f}" if len(values) > 1 else ""
                cells.append(f"{statistics.mean(values):.{digits}f}{scatter}")
            yield f"| {name}, {part} | " + " | ".join(cells) + " |"
    yield from lines(rows, pressures)


def lines(rows, pressures):
    """(5.2) to (5.5) through the means of packings."""
    def means(name, part="at rest"):
        return np.array([statistics.mean(values_of(rows, pressure, part, name)) for pressure in pressures])
    log, void, steady = np.log10(pressures), 1 / means("packing_fraction") - 1, 1 / means("packing_fraction", "0.56 to 0.8") - 1
    for text, x, y, of in (("Φ (5.2)", log, means("packing_fraction"), "log"), ("e (5.3)", log, void, "log"), ("Z_of_all (5.4)", log, means("Z_of_all"), "log"),
                           ("Z_of_all (5.5)", void, means("Z_of_all"), "e"), ("e, 0.56 to 0.8", log, steady, "log")):
        slope, start = np.polyfit(x, y, 1)
        yield f"{text} = {start:.3f} {slope:+.3f} {of}"
