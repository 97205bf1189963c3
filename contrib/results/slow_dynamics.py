#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs gallery/thirty_grains_mpm.prm with inertia and walls from 5 to 0.05 m/s, and prints the table of
doc/results/quasi-static.md: the range over the packings, or the worst."""
import resource

from quasi_static import LOOSE, at, friction
from running import parser_of, run

SPEEDS = {5: 4, 1: 20, 0.2: 100, 0.05: 400}  # velocity of the wall [m/s]: length of a step [CFL steps]
FRACTIONS = (0.84, 0.90, 0.94)


def measure(summary, rows, seconds):
    """What the table tells of one run."""
    full = max(row["dt_s"] for row in rows)
    gave = most = loose_spin = spin = 0.0
    for row in rows:
        most = max(most, row["contact_loss_J_per_m"])
        gave = max(gave, most - row["contact_loss_J_per_m"])
        share = row["rotational_energy_J_per_m"] / max(row["kinetic_energy_J_per_m"], 1e-30)
        if row["packing_fraction"] < 0.80:
            loose_spin = max(loose_spin, share)
        else:
            spin = max(spin, share)
    last = rows[-1]
    work = sum(last[f"{name}_energy_J_per_m"] for name in ("elastic", "kinetic", "dissipated"))
    return {"steps": len(rows) - 1, "cut": sum(row["dt_s"] < 0.9 * full for row in rows[1:-1]), "seconds": seconds,
            "gave": gave / work, "balance": summary["energy_balance_error"], "loose_spin": loose_spin, "spin": spin,
            "stress": [0.5 * (at(rows, "top_force_N_per_m", f) + at(rows, "bottom_force_N_per_m", f)) / 1e4 for f in FRACTIONS],
            "sides": max(abs(at(rows, "top_force_N_per_m", f) / at(rows, "bottom_force_N_per_m", f) - 1) for f in FRACTIONS)}


def line(name, runs):
    def span(key, form="{}"):
        return "–".join(dict.fromkeys(form.format(pick(one[key] for one in runs)) for pick in (min, max)))

    def worst(key):
        return f"{max(one[key] for one in runs):.1e}"

    means = [sum(one["stress"][k] for one in runs) / len(runs) for k in range(len(FRACTIONS))]
    return (f"| {name} | {span('steps')} | {span('cut')} | {span('seconds', '{:.1f}')} | {worst('gave')} | {worst('balance')} | "
            f"{worst('loose_spin')}, {worst('spin')} | {worst('sides')} | " + " | ".join(f"{mean:.3f}" for mean in means) + " |")


def main():
    parser = parser_of(__doc__, "slow_dynamics")
    parser.add_argument("--seeds", type=int, nargs="+", default=range(1, 6))
    parser.add_argument("--friction", type=float, nargs="+", default=(0.0, 0.5))
    options = parser.parse_args()
    print("| wall, steps of | steps | cut | CPU [s] | contact gave / work of walls | energy balance | rotational / kinetic energy "
          "below 0.80, above | top / bottom less 1 | " + " | ".join(f"σ at {f:.2f} [MPa]" for f in FRACTIONS) + " |")
    print("|" + "---|" * (8 + len(FRACTIONS)))
    for coefficient in options.friction:
        for speed, multiple in SPEEDS.items():
            runs = []
            for seed in options.seeds:
                changes = {**LOOSE, "Packing/Seed": seed, "Walls/top/Velocity": speed, "Time/CFL multiple": multiple}
                if coefficient > 0:
                    changes.update(friction(coefficient))
                before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
                summary, rows = run(options.program, "gallery/thirty_grains_mpm.prm",
                                    options.folder / f"{speed}-{coefficient}-{seed}", changes, threads=1)
                runs.append(measure(summary, rows, resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before))
            print(line(f"{speed} m/s, {multiple} CFL, μ = {coefficient:g}", runs), flush=True)


if __name__ == "__main__":
    main()
