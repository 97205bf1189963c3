#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Storage and loss modulus of a packing of viscoelastic grains over four decades of frequency, packings/oscillating_cell.prm, prepared once:
a fit of the stress to the strain and what the solid itself has, for doc/results/confluence.md."""
import math
import pathlib

import numpy as np
from running import RunFailed, parser_of, run, softgrain

import moduli

SCENE = "packings/oscillating_cell.prm"
YOUNG, POISSON, SHARES, TIMES = 10e6, 0.45, (0.4, 0.4), (0.1, 10.)  # of the scene
STEPS, PERIODS = 24, 1.5
FREQUENCIES = tuple(10 ** (0.5 * k) for k in range(-4, 5))  # angular [1/s]
COLUMNS = ("packing", "frequency_per_s", "storage_over_solid_at_once", "loss_over_solid_at_once", "solid_storage", "solid_loss", "misfit")


def solid(frequency):
    """Complex shear modulus of the solid over that at once."""
    relaxed = [g * 1j * frequency * t / (1 + 1j * frequency * t) for g, t in zip(SHARES, TIMES)]
    return 1 - sum(SHARES) + sum(relaxed)


def fit(time, strain, stress, frequency):
    """Complex modulus: sine and cosine of the stress over the sine of the strain, beside a constant, a drift and what relaxes from the start;
    misfit over the amplitude."""
    amplitude = np.linalg.lstsq(np.column_stack([np.sin(frequency * time), np.ones_like(time)]), strain, rcond=None)[0][0]
    columns = [np.sin(frequency * time), np.cos(frequency * time), np.ones_like(time), time / time[-1]]
    # What has relaxed at the first step, or not at all at the last, cannot be told from the rest.
    columns += [np.exp(-time / t) for t in TIMES if 0.5 * time[0] < t < 0.5 * time[-1]]
    found = np.linalg.lstsq(np.column_stack(columns), stress, rcond=None)[0]
    left = stress - np.column_stack(columns) @ found
    return complex(found[0], found[1]) / amplitude, np.sqrt(np.mean(left**2)) / math.hypot(found[0], found[1])


def measured(folder, frequency):
    """The modulus of one run. Of the state that it goes on from there are no contacts."""
    states = softgrain.open(folder).snapshots
    start, *rows = [moduli.State(state) for state in states]
    time = np.asarray(states.times)[1:] - states.times[0]
    strain = np.array([(row.offset - start.offset) / row.height for row in rows])
    return fit(time, strain, np.array([row.shear_stress for row in rows]), frequency)


def main():
    parser = parser_of(__doc__, "rheology")
    parser.add_argument("--seeds", type=int, nargs="+", default=(1,))
    parser.add_argument("--frequencies", type=float, nargs="+", default=FREQUENCIES, help="angular [1/s]")
    parser.add_argument("--amplitude", type=float, default=0.005, help="of the shear strain (default: %(default)s)")
    parser.add_argument("--set", action="append", default=[], metavar="PATH=VALUE", help="for all runs")
    parser.add_argument("--limit", type=float, default=1800, help="wall seconds of one run (default: %(default)s)")
    parser.add_argument("--table", type=pathlib.Path, help="all rows are written there")
    arguments = parser.parse_args()
    more = dict(item.split("=", 1) for item in arguments.set)
    glass = YOUNG / (2 * (1 + POISSON))
    rows = []
    print("| packing | ω [1/s] | G' | G'' | tan δ | of the solid: G' | G'' | tan δ | G' over solid | G'' over solid | misfit |\n" + "|---" * 11 + "|", flush=True)
    for seed in arguments.seeds:
        first = arguments.folder / f"prepared-{seed}"
        run(arguments.program, SCENE, first, {"Packing/Seed": seed, "Time/Time step": 2.5, "Output/Snapshots every": 1000,
                                              "Stages/oscillate/Stop/End time": 2.5, **more}, threads=1, limit=arguments.limit, again=False)
        height = moduli.State(softgrain.open(first).snapshots[-1]).height
        for frequency in arguments.frequencies:
            period = 2 * math.pi / frequency
            changes = {"Packing/Seed": seed, "Time/Time step": period / STEPS, "Output/Snapshots every": period / STEPS,
                       "Stages/oscillate/Stop/End time": PERIODS * period,
                       "Stages/oscillate/top/Tangential velocity": f"{-arguments.amplitude * height * frequency:.8g}*cos({frequency:.8g}*t)", **more}
            folder = arguments.folder / f"seed-{seed}-{frequency:.4g}-{arguments.amplitude:g}"
            try:
                run(arguments.program, SCENE, folder, changes, threads=1, limit=arguments.limit, again=False, prepared=str(first / "stage-rest.h5"))
            except RunFailed as trouble:
                print(f"| {seed} | {frequency:.4g} | {trouble} |", flush=True)
                continue
            value, misfit = measured(folder, frequency)
            value, exact = value / glass, solid(frequency)
            rows.append((seed, frequency, value.real, value.imag, exact.real, exact.imag, misfit))
            print(f"| {seed} | {frequency:.4g} | {value.real:.4f} | {value.imag:.4f} | {value.imag / value.real:.3f} | {exact.real:.4f} | {exact.imag:.4f} "
                  f"| {exact.imag / exact.real:.3f} | {value.real / exact.real:.3f} | {value.imag / exact.imag:.3f} | {misfit:.1e} |", flush=True)
    if arguments.table:
        np.savetxt(arguments.table, np.array(rows), delimiter=",", fmt="%.6g", comments="", header=",".join(COLUMNS))


if __name__ == "__main__":
    main()
