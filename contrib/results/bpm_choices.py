#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Table of doc/results/bpm-choices.md: one small grain between two walls (gallery/one_grain_bpm.prm) with other time
steps, tolerances, gap corrections, cutoffs and exponents."""
import argparse
import sys
import tempfile

from running import RunFailed, run

LAW = "Materials/grain/Power law/"
CASES = {
    "step": [("Time/Time step", v) for v in ("1e-7", "2e-7", "5e-7", "1e-6", "2e-6", "5e-6", "1e-5")],
    "tolerance": [("Contact/Tolerance", v) for v in ("1e-1", "1e-2", "1e-3", "1e-4", "1e-5")],
    "wall": [("Contact/Wall tolerance", v) for v in ("1", "0.1", "0.03", "0.003")],
    "correction": [("Contact/Gap correction", v) for v in ("0", "0.1", "0.5", "1")],
    "cutoff": [(LAW + "Cutoff", v) for v in ("0.2", "0.5", "1", "2")],
    "exponent": [(LAW + "Exponent", v) for v in ("2", "4", "7", "12")],
}


def measure(rows, summary, diameter, width):
    plastic = [r for r in rows if 0.06 < r["axial_strain"] <= 0.2]
    force = sum(r["top_force_N_per_m"] * r["dt_s"] for r in plastic) / sum(r["dt_s"] for r in plastic)
    imbalance = sum((r["top_force_N_per_m"] - r["bottom_force_N_per_m"]) * r["dt_s"] for r in plastic) / sum(
        r["dt_s"] for r in plastic)
    return (force / width / 1e6, imbalance / force, max(r["max_penetration_m"] for r in rows) / diameter,
            summary["energy_balance_error"], summary["momentum_error"],
            sum(r["contact_sweeps"] for r in rows[1:]) / len(rows[1:]), summary["steps"], summary["wall_seconds"])


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("program", help="build/release/bin/softgrain")
    parser.add_argument("--only", choices=sorted(CASES), nargs="*", default=list(CASES))
    parser.add_argument("--threads", type=int, default=1)
    arguments = parser.parse_args()
    print("| changed | stress [MPa] | top - bottom | penetration / diameter | energy balance | momentum | sweeps / step | "
          "steps | seconds |\n|---|---|---|---|---|---|---|---|---|")
    for name in arguments.only:
        for key, value in CASES[name]:
            label = f"{key.split('/')[-1]} = {value}"
            with tempfile.TemporaryDirectory() as folder:
                try:
                    summary, rows = run(arguments.program, "gallery/one_grain_bpm.prm", folder,
                                        {key: value, "Output/Fields every": "0"}, arguments.threads)
                except RunFailed as trouble:
                    print(f"| {label} | {trouble} |")
                    continue
            numbers = measure(rows, summary, 2.0e-4, 4e-3)
            print("| {} | {:.3f} | {:+.1%} | {:.1e} | {:.1e} | {:.0e} | {:.0f} | {} | {:.0f} |".format(label, *numbers))
            sys.stdout.flush()


if __name__ == "__main__":
    main()
