#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Chapter 4 at 5 m/s and without inertia: stress and coordination over the packing fraction, from runs that assemblies.py has made
(--only seeds friction static static-friction), for a table and the figure of doc/results/thesis-4.md."""
import argparse
import pathlib
import statistics

from graded_grains import mean_near
from quasi_static import at
from running import as_rows, softgrain

# Name of the series, beginning of the names of its runs, style of its curve.
SERIES = (("5 m/s", "mpm", dict(color="C0", lw=0.8)), ("5 m/s, μ = 0.5", "mpm-friction", dict(color="C1", lw=0.8)),
          ("no inertia", "mpm-static", dict(color="C0", marker="o")), ("no inertia, μ = 0.5", "mpm-static-friction", dict(color="C1", marker="s")))
FRACTIONS = (0.80, 0.82, 0.85, 0.88, 0.90, 0.92, 0.94)
HALF = 0.005  # of the range of the packing fraction over which waves of the fast wall are averaged


def curves(folder, name):
    """States of every packing, with the mean stress of top and bottom wall [MPa]."""
    found = []
    for run in sorted(folder.glob(f"{name}-[0-9]")):
        found.append(as_rows(softgrain.open(run).measures_table))
        for state in found[-1]:
            state["stress"] = (state["top_pressure_Pa"] + state["bottom_pressure_Pa"]) / 2e6
    return found


def value(name, curve, column, fraction):
    """Of the fast wall, which sends waves, a mean; without inertia states are few, and the value is between two of them."""
    if "static" in name:
        return at(curve, column, fraction)
    return mean_near(curve, "packing_fraction", fraction, HALF, lambda state: state[column])


def told(values):
    spread = f" ± {statistics.stdev(values):.3f}" if len(values) > 1 else ""
    return f"{statistics.fmean(values):.3f}{spread}"


def draw(picture, found):
    import matplotlib
    matplotlib.use("Agg")
    import matplotlib.pyplot as pyplot
    figure, axes = pyplot.subplots(1, 2, figsize=(9, 3.6))
    for label, name, style in SERIES:
        for curve in found[name][:1]:
            for axis, column in zip(axes, ("stress", "coordination")):
                axis.plot([state["packing_fraction"] for state in curve], [state[column] for state in curve], markersize=4, label=label, **style)
    axes[0].set(xlabel="packing fraction Φ", ylabel="stress of top and bottom wall [MPa]", yscale="log", ylim=(0.005, 3))
    axes[1].set(xlabel="packing fraction Φ", ylabel="contacts of a grain Z")
    axes[0].legend(frameon=False, fontsize=8)
    figure.tight_layout()
    figure.savefig(picture, dpi=110)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", type=pathlib.Path, help="with the output folders of the runs")
    parser.add_argument("--picture", type=pathlib.Path, help="PNG file for the figure, of the first packing")
    arguments = parser.parse_args()
    found = {name: curves(arguments.folder, name) for _, name, _ in SERIES}
    there = [(label, name) for label, name, _ in SERIES if found[name]]
    if not there:
        parser.error(f"no runs of assemblies.py in {arguments.folder}")
    for column, title in (("stress", "stress [MPa] at Φ"), ("coordination", "Z at Φ")):
        print(f"\n| {title} | " + " | ".join(f"{label} ({len(found[name])})" for label, name in there) + " |\n" + "|---" * (len(there) + 1) + "|")
        for fraction in FRACTIONS:
            print(f"| {fraction:.2f} | " + " | ".join(told([value(name, curve, column, fraction) for curve in found[name]]) for _, name in there) + " |")
    if arguments.picture:
        draw(arguments.picture, found)


if __name__ == "__main__":
    main()
