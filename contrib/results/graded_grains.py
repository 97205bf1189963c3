#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Grains of bonded primaries with a hard core in a soft skin, and the reverse: gallery/one_grain_bpm.prm crushed and
gallery/thirty_grains_bpm.prm compacted, for the tables and the figure of doc/results/laws.md."""
import pathlib

from running import parser_of, run

# Both have the mean strength of 1.72 over the area of a disk: 0.36 of it is core.
STRENGTHS = {"even": "1.72", "hard core": "r < 0.6 ? 3 : 1", "hard skin": "r < 0.6 ? 0.6667 : 2.3125"}
STRAINS = (0.05, 0.10, 0.15, 0.20)
FRACTIONS = (0.80, 0.85, 0.90, 0.94)
WIDTH = 10e-3  # of the box of thirty grains [m]


def mean_near(rows, column, value, half, what):
    """Mean of @what(row) over rows in which @column is within @half of @value."""
    found = [what(row) for row in rows if abs(row[column] - value) <= half]
    return sum(found) / len(found) if found else float("nan")


def table(title, names, lines):
    print(f"\n| {title} | " + " | ".join(names) + " |\n" + "|---" * (len(names) + 1) + "|")
    print("\n".join(lines), flush=True)


def draw(picture, one, thirty):
    import matplotlib
    matplotlib.use("Agg")
    import matplotlib.pyplot as pyplot
    figure, (left, right) = pyplot.subplots(1, 2, figsize=(8, 3.2))
    for name, rows in one.items():
        left.plot([row["axial_strain"] for row in rows], [row["top_force_N_per_m"] / 1e3 for row in rows], lw=0.8, label=name)
    left.set(xlabel="axial strain", ylabel="force on the wall [kN/m]", title="one grain crushed")
    for name, rows in thirty.items():
        right.plot([row["packing_fraction"] for row in rows],
                   [(row["top_force_N_per_m"] + row["bottom_force_N_per_m"]) / 2 / WIDTH / 1e6 for row in rows], lw=0.8, label=name)
    right.set(xlabel="packing fraction", ylabel="stress [MPa]", title="thirty grains compacted", xlim=(0.76, 0.95))
    right.legend(frameon=False)
    figure.tight_layout()
    figure.savefig(picture, dpi=110)


def main():
    parser = parser_of(__doc__, "graded_grains")
    parser.add_argument("--picture", type=pathlib.Path, help="PNG file for the figure")
    arguments = parser.parse_args()
    quiet = {"Output/Fields every": 0, "Output/Snapshots every": 0}
    one, thirty = {}, {}
    for name, formula in STRENGTHS.items():
        changes = {"Primaries/Strength": formula, **quiet}
        for scene, found in (("one_grain_bpm", one), ("thirty_grains_bpm", thirty)):
            more = {"Output/History every": 1} if scene == "one_grain_bpm" else {}
            found[name] = run(arguments.program, f"gallery/{scene}.prm", arguments.folder / f"{scene}-{name.replace(' ', '-')}",
                              {**changes, **more}, threads=1, again=False)[1]
    table("force on the wall [kN/m] at a strain of", [f"{s:.2f}" for s in STRAINS],
          [f"| {name} | " + " | ".join(f"{mean_near(rows, 'axial_strain', s, 0.02, lambda r: r['top_force_N_per_m'] / 1e3):.2f}"
                                       for s in STRAINS) + " |" for name, rows in one.items()])
    table("stress [MPa] at Φ =", [f"{f:.2f}" for f in FRACTIONS],
          [f"| {name} | " + " | ".join(
              f"{mean_near(rows, 'packing_fraction', f, 0.01, lambda r: (r['top_force_N_per_m'] + r['bottom_force_N_per_m']) / 2 / WIDTH / 1e6):.3f}"
              for f in FRACTIONS) + " |" for name, rows in thirty.items()])
    if arguments.picture:
        draw(arguments.picture, one, thirty)


if __name__ == "__main__":
    main()
