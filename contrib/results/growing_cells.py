#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Cells that grow in a box that stays, for doc/results/laws.md: their pressures, and contacts won and lost, by packing fraction."""
import argparse
import pathlib

import numpy as np

from running import box, run, softgrain

WIDTH, HEIGHT = 19.6e-3, 20.7e-3  # of the box of a hundred cells [m]


def look(state):
    """Mean pressure of each cell [Pa], pairs of cells in contact, area [m^2] and centres of all."""
    area, body = np.asarray(state.points["area_m2"]), np.asarray(state.points["body"]).astype(int)
    pressure = np.bincount(body, area * np.asarray(state.points["pressure_Pa"])) / np.bincount(body, area)
    touching = np.asarray(state.contacts["normal_force_N_per_m"]) > 0
    first, second = (np.asarray(state.contacts[name]).astype(int)[touching] for name in ("body_a", "body_b"))
    cells = range(len(pressure))
    pairs = {(min(a, b), max(a, b)) for a, b in zip(first.tolist(), second.tolist()) if a in cells and b in cells}
    return pressure, pairs, area.sum(), np.asarray(state.bodies["center_m"])


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("program", help="build/release/bin/softgrain")
    parser.add_argument("folder", nargs="?", type=pathlib.Path, default=pathlib.Path("output/growing_cells"),
                        help="for the output folder of the run (default: %(default)s)")
    parser.add_argument("--number", type=int, default=100, help="cells (default: 100)")
    words = parser.parse_args()
    changes, width, height = box(words.number, 100, WIDTH, HEIGHT)
    room = width * height
    changes |= {"Mesh/Upper": f"{width + 1e-3:.6g}, {height + 1e-3:.6g}", "Output/Fields every": 0.015, "Output/Snapshots every": 0.015}
    summary, rows = run(words.program, "gallery/growing_cells_mpm.prm", words.folder, changes, threads=1, again=False)
    print("| Φ | mean pressure of the cells [Pa] | spread | least, largest [Pa] | neighbours | won | lost | way [µm] |\n" + "|---" * 8 + "|")
    before = None
    for state in softgrain.open(words.folder):
        pressure, pairs, area, centres = look(state)
        if area / room < 0.83 or (before and area / room < before[2] / room + 0.02 and area / room < 0.98):
            continue
        if before:
            way = 1e6 * np.sqrt(((centres - before[3]) ** 2).sum(axis=1).mean())
            print(f"| {area / room:.3f} | {pressure.mean():.0f} | {pressure.std() / pressure.mean():.2f} | {pressure.min():.0f}, "
                  f"{pressure.max():.0f} | {len(pairs)} | {len(pairs - before[1])} | {len(before[1] - pairs)} | {way:.0f} |")
        before = pressure, pairs, area, centres
        if area / room >= 0.98:
            break
    forces = {name: rows[-1][f"{name}_force_N_per_m"] for name in ("bottom", "top", "left", "right")}
    print("at the end the walls feel " + ", ".join(f"{name} {force:.1f}" for name, force in forces.items())
          + f" N/m; energy balance {summary['energy_balance_error']:.2g}")


if __name__ == "__main__":
    main()
