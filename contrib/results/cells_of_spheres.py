#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Balls without friction in a cell that repeats in three directions, pressed together at rest until at rest they would fill .95 of it: pressure
and coordination over the packing fraction, where they jam, and the exponents there. The tables of doc/results/three-dimensions.md."""
import numpy as np

from running import PARAMETERS, RunFailed, parser_of, rows_of, softgrain

SCENE = "gallery/sheared_cell_of_spheres.prm"
DIAMETER, YOUNG, FULL = 10e-3, 10e6, 0.95  # mean [m], [Pa], volume at rest over that of the cell at the end
SIDES = ("left", "right", "front", "back", "bottom", "top")


def changes_of(number, seed, fraction, cells, way):
    """Parameters of a run: a cubic cell that @number balls fill by @fraction, closed at 1 mm/s a side in steps of @way cells."""
    edge = DIAMETER * (number * np.pi / 6 / fraction) ** (1 / 3)
    last = edge * (fraction / FULL) ** (1 / 3)
    far = {"right": 0, "back": 1, "top": 2}
    points = {f"Walls/{name}/Point": ", ".join(f"{edge:.7g}" if d == axis else "0" for d in range(3)) for name, axis in far.items()}
    return {"Packing/Number": number, "Packing/Seed": seed, "Packing/Packing fraction": fraction,
            "Packing/Upper": ", ".join([f"{edge:.7g}"] * 3), **points, **{f"Walls/{name}/Velocity": "1e-3" for name in SIDES},
            "Walls/top/Tangential velocity": 0, "Contact/Friction": 0,
            "Mesh/Lower": ", ".join(["-7e-3"] * 3), "Mesh/Upper": ", ".join([f"{edge + 7e-3:.7g}"] * 3),
            "Mesh/Cell size": f"{0.5 * DIAMETER / cells:.6g}", "Time/Wall way": way, "Stop/End time": f"{0.5 * (edge - last) / 1e-3:.5g}",
            "Output/Number of field outputs": 0, "Output/Snapshots every": f"{way * 0.5 * DIAMETER / cells / 1e-3:.5g}"}


def coordination_without_rattlers(state):
    """Mean number of contacts of balls that have at least four, counted among themselves; and how many have fewer."""
    a, b = state.pairs.body_a, state.pairs.body_b
    alive = np.ones(len(state.bodies.center_m), dtype=bool)
    while True:
        both = alive[a] & alive[b]
        touching = np.bincount(a[both], minlength=len(alive)) + np.bincount(b[both], minlength=len(alive))
        rattlers = alive & (touching < 4)
        if not rattlers.any():
            break
        alive &= ~rattlers
    return (touching[alive].mean() if alive.any() else 0.0), int((~alive).sum())


def states_of(folder):
    """(volume at rest over that of the cell, pressure over E, coordination, rattlers) of every state."""
    run = softgrain.open(folder)
    rows = {row["time_s"]: row for row in rows_of(run)}
    found, solid = [], None
    for state in run:
        row = rows[min(rows, key=lambda time: abs(time - state.time))]
        edges = [row[f"{b}_position_m"] - row[f"{a}_position_m"] for a, b in (("left", "right"), ("front", "back"), ("bottom", "top"))]
        volume = np.prod(edges)
        solid = solid or row["packing_fraction"] * volume
        pressure = np.mean([row[f"{name}_force_N"] * edges[i // 2] / volume for i, name in enumerate(SIDES)])
        found.append((solid / volume, pressure / YOUNG, *coordination_without_rattlers(state)))
    return np.array(found)


def jammed(states):
    """Where the pressure begins, by a line through p^(2/3) of the light states, and the exponents of p and of Z - 6 over what is beyond."""
    light = states[(states[:, 1] > 2e-5) & (states[:, 1] < 3e-3)]
    if len(light) < 2:
        raise SystemExit("too few states under light pressure: take shorter steps (--way)")
    slope, start = np.polyfit(light[:, 0], light[:, 1] ** (2 / 3), 1)
    phi = -start / slope
    beyond = states[(states[:, 0] > phi + 0.005) & (states[:, 0] < phi + 0.12) & (states[:, 2] > 6)]
    if len(beyond) < 3:
        raise SystemExit("too few states beyond jamming: take shorter steps (--way)")
    of_p = np.polyfit(np.log(beyond[:, 0] - phi), np.log(beyond[:, 1]), 1)[0]
    of_z = np.polyfit(np.log(beyond[:, 0] - phi), np.log(beyond[:, 2] - 6), 1)
    return phi, of_p, of_z[0], np.exp(of_z[1])


def main():
    parser = parser_of(__doc__, "cells_of_spheres")
    parser.add_argument("--number", type=int, default=27)
    parser.add_argument("--seeds", type=int, nargs="+", default=(1, 2, 3))
    parser.add_argument("--fraction", type=float, default=0.45, help="packing fraction at the start")
    parser.add_argument("--cells", type=float, default=3.03, help="in the mean radius")
    parser.add_argument("--way", type=float, default=0.1, help="of a side in a step, in cells")
    parser.add_argument("--threads", type=int, default=2)
    arguments = parser.parse_args()
    print("| seed | jams at | exponent of p | of Z - 6, factor | last: volume at rest, p/E, Z, rattlers | steps | iterations | processor s |\n"
          + "|---" * 8 + "|")
    for seed in arguments.seeds:
        folder = arguments.folder / f"{arguments.number}-{seed}"
        try:
            softgrain.run(str(PARAMETERS / SCENE), set=changes_of(arguments.number, seed, arguments.fraction, arguments.cells, arguments.way),
                          output=str(folder), threads=arguments.threads, program=str(arguments.program), again=False, overwrite=True)
        except RunFailed as trouble:
            print(f"| {seed} | {str(trouble).strip().splitlines()[-1]} |", flush=True)
        run, states = softgrain.open(folder), states_of(folder)
        phi, of_p, of_z, factor = jammed(states)
        rows, last = rows_of(run), states[-1]
        print(f"| {seed} | {phi:.3f} | {of_p:.2f} | {of_z:.2f}, {factor:.1f} | {last[0]:.3f}, {last[1]:.4f}, {last[2]:.2f}, {last[3]:.0f} "
              f"| {len(rows) - 1} | {sum(row['newton_iterations'] for row in rows):.0f} | {run.summary['processor_seconds']:.0f} |", flush=True)
        np.savetxt(folder / "states.csv", states, fmt="%.6g", delimiter=",", header="rest_fraction,pressure_over_E,coordination,rattlers", comments="")


if __name__ == "__main__":
    main()
