#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs and tables of doc/results/thesis-4.md: compaction of soft disks by MPM and by BPM with other seeds, by MPM at half
the spacing and half the step, with other numbers of bodies and other contact solvers. A run that is there already is not repeated."""
import argparse
import math
import pathlib
import statistics
import sys

from running import RunFailed, run

WIDTH = 35.8e-3  # of the box of 300 disks [m]
QUIET = {"Output/Fields every": "0", "Output/Snapshots every": "2e-5", "Output/Measures": "all"}
# The force as attraction; doc/results/bonded-particles.md, "The step".
BONDED = {"Output/Snapshots every": "5e-5", "Time/Time step": "5e-7", "Materials/grain/Law": "power_law"}
# The thesis's energy, with primaries that are larger by .4 and the long steps of doc/results/thesis-5.md.
ENERGY = {"Output/Snapshots every": "5e-5", "Time/Time step": "7.5e-7", "Primaries/Smallest diameter": "0.10e-3",
          "Primaries/Largest diameter": "0.18e-3", "Contact/Tolerance": "3e-3", "Contact/Wall tolerance": "1",
          "Contact/Penetration tolerance": "3e-3"}
# A wall 25 times slower, by steps as much longer: .3 cells each, all of them written. See doc/results/quasi-static.md.
SLOW = {"Walls/top/Velocity": "0.2", "Time/Time step": "4.8e-4", "Output/Snapshots every": "4.8e-4", "Stop/End time": "0.1"}
# Without inertia: the same steps, every tenth in balance and written. See doc/results/thesis-4.md.
STATIC = {"Time/Scheme": "quasi_static", "Time/Time step": "1.92e-5", "Output/Snapshots every": "1.92e-4", "Output/History every": "10",
          "Stop/End time": "1"}
FINE = {"Mesh/Cell size": "1.6e-4", "Time/CFL multiple": "3"}  # the step goes with the cell


def box(number):
    """Changes that give the scene another number of disks at the same packing fraction."""
    width = WIDTH * math.sqrt(number / 300)
    mesh = f"{width + 1e-3:.6g}"
    return {"Packing/Number": str(number), "Packing/Upper": f"{width:.6g}, {width:.6g}", "Mesh/Upper": f"{mesh}, {mesh}",
            "Walls/top/Point": f"0, {width:.6g}", "Walls/right/Point": f"{width:.6g}, 0", "Stop/End time": "6e-3"}


SEEDS = range(1, 6)
ALGORITHMS = {"plain": {"Contact/Algorithm": "gauss_seidel"},
              "relaxed": {"Contact/Algorithm": "gauss_seidel", "Contact/Relaxation": "1.4"},
              "automatic": {}}  # of the contact solver, doc/results/contact-solvers.md
# Series: name of the run, its scene (thesis/uniaxial_compaction_*.prm) and what is changed.
SERIES = {
    "seeds": [(f"mpm-{seed}", "mpm", {"Packing/Seed": str(seed)}) for seed in SEEDS],
    "friction": [(f"mpm-friction-{seed}", "mpm_friction", {"Packing/Seed": str(seed)}) for seed in SEEDS],
    "slow": [(f"mpm-slow-{seed}", "mpm", {**SLOW, "Packing/Seed": str(seed)}) for seed in SEEDS],
    "slow-friction": [(f"mpm-slow-friction-{seed}", "mpm_friction", {**SLOW, "Packing/Seed": str(seed)}) for seed in SEEDS],
    "static": [(f"mpm-static-{seed}", "mpm", {**STATIC, "Packing/Seed": str(seed)}) for seed in SEEDS],
    "static-friction": [(f"mpm-static-friction-{seed}", "mpm_friction", {**STATIC, "Packing/Seed": str(seed)}) for seed in SEEDS],
    "fine": [(f"mpm-fine-{seed}", "mpm", {**FINE, "Packing/Seed": str(seed)}) for seed in SEEDS],
    "bodies": [(f"mpm-{number}-bodies", "mpm", {**box(number), "Output/Measures": "", "Stop/Packing fraction": "0.82"})
               for number in (30, 100, 300, 1000)],
    "contact": [(f"{scene}-contact-{name}", scene, {**box(100), **FINE, **algorithm, "Output/Measures": "",
                                                    "Stop/Packing fraction": "0.92"})
                for scene in ("mpm", "mpm_friction") for name, algorithm in ALGORITHMS.items()],
    "thesis-contact": [(f"thesis-contact-{seed}", "mpm_thesis_method",
                        {"Packing/Seed": str(seed), "Contact/Solver": "condensed", "Time/Time step": "0",
                         "Time/CFL multiple": "2"}) for seed in range(1, 4)],
    "bpm": [(f"bpm-{seed}", "bpm", {**BONDED, "Packing/Seed": str(seed)}) for seed in SEEDS],
    "bpm-energy": [(f"bpm-energy-{seed}", "bpm", {**ENERGY, "Packing/Seed": str(seed)}) for seed in SEEDS],
    "bpm-friction": [(f"bpm-friction-{seed}", "bpm_friction", {**BONDED, "Packing/Seed": str(seed)}) for seed in SEEDS],
}


def stress(rows, fractions):
    """Mean normal stress on the walls [MPa], averaged over +-0.01 of the packing fraction."""
    result = []
    for wanted in fractions:
        near = [r for r in rows if abs(r["packing_fraction"] - wanted) < 0.01]
        time = sum(r["dt_s"] for r in near)
        total = 0.0
        for r in near:
            width = r["right_position_m"] - r["left_position_m"]
            height = r["top_position_m"] - r["bottom_position_m"]
            total += r["dt_s"] * ((r["top_force_N_per_m"] + r["bottom_force_N_per_m"]) / width +
                                  (r["left_force_N_per_m"] + r["right_force_N_per_m"]) / height) / 4
        result.append(total / time / 1e6 if time > 0 else math.nan)
    return result


def compare(curves, fractions):
    """The mean stress of the seeds that were run at both spacings, one beside the other."""
    seeds = [seed for seed in SEEDS if f"mpm-{seed}" in curves and f"mpm-fine-{seed}" in curves]
    if not seeds:
        return
    coarse, fine = ([statistics.fmean(curves[f"{name}-{seed}"][i] for seed in seeds) for i in range(len(fractions))]
                    for name in ("mpm", "mpm-fine"))
    rms = math.sqrt(sum((a - b)**2 for a, b in zip(coarse, fine)) / len(fine))
    print(f"\nstress against packing fraction, 0.80 to 0.95, mean of {len(seeds)} seeds, at half the spacing and step: r.m.s. "
          f"difference {100 * rms / statistics.fmean(fine):.1f} % of the mean stress")
    for fraction, a, b in zip(fractions, coarse, fine):
        print(f"  {fraction:.2f}  {a:.4f}  {b:.4f} MPa")


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("program", help="build/release/bin/softgrain")
    parser.add_argument("folder", type=pathlib.Path, help="for the output folders of the runs")
    parser.add_argument("--only", choices=sorted(SERIES), nargs="*", default=list(SERIES))
    parser.add_argument("--first", type=int, help="only so many runs of a series")
    parser.add_argument("--threads", type=int, default=0)
    arguments = parser.parse_args()
    fractions = [0.80 + 0.01 * i for i in range(16)]
    curves = {}
    print("| run | points | steps | Newton / step | sweeps / step | contact solve [s] | seconds | us / point / step |\n"
          "|---|---|---|---|---|---|---|---|")
    for series in arguments.only:
        for name, scene, changes in SERIES[series][:arguments.first]:
            try:
                summary, rows = run(arguments.program, f"thesis/uniaxial_compaction_{scene}.prm", arguments.folder / name,
                                    {**QUIET, **changes}, arguments.threads, again=False)
            except RunFailed as trouble:
                print(f"{name}: {trouble}", file=sys.stderr)
                continue
            seconds, steps = summary["wall_seconds"], summary["steps"]
            points = summary.get("material_points", summary.get("primaries"))
            mean = lambda key: statistics.fmean(row[key] for row in rows[1:])
            phases = summary["phases"]
            print(f"| {name} | {points} | {steps} | {mean('newton_iterations'):.2f} | {mean('contact_sweeps'):.0f} | "
                  f"{phases['contact solve']:.1f} | {seconds:.1f} | {1e6 * seconds / points / steps:.2f} |", flush=True)
            curves[name] = stress(rows, fractions)
    compare(curves, fractions)


if __name__ == "__main__":
    main()
