#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Wall stress of thirty grains without inertia against half the step and against a slow wall with inertia, packing by
packing, for doc/results/quasi-static.md."""

from quasi_static import FRACTIONS, LOOSE, STATIC, stresses
from running import parser_of, run

PLAIN = {"Contact/Sub-grid compliance": "false"}  # which inertia has not
STEP = 6.54e-6  # of a tenth of a cell at 5 m/s [s]
KINDS = {
    "no inertia": {**STATIC, **PLAIN, "Time/Time step": STEP},
    "half the step": {**STATIC, **PLAIN, "Time/Time step": STEP / 2},
    "0.05 m/s, with inertia": {"Walls/top/Velocity": 0.05, "Time/Time step": 100 * STEP},
}


def main():
    parser = parser_of(__doc__, "static_against_slow")
    parser.add_argument("--seeds", type=int, nargs="+", default=(1, 2, 3, 4, 5))
    arguments = parser.parse_args()
    print("| packing | run | " + " | ".join(f"Φ = {f:.2f}" for f in FRACTIONS) + " |\n" + "|---" * (len(FRACTIONS) + 2) + "|")
    for seed in arguments.seeds:
        first = None
        for number, (name, changes) in enumerate(KINDS.items()):
            _, rows = run(arguments.program, "gallery/thirty_grains_mpm.prm", arguments.folder / f"seed-{seed}-{number}",
                          {**LOOSE, "Packing/Seed": seed, "Stop/Packing fraction": 0.95, **changes}, threads=1, again=False)
            here = stresses(rows)
            if first is None:
                first = here
                print(f"| {seed} | {name} [MPa] | " + " | ".join(f"{s:.4f}" for s in here) + " |", flush=True)
            else:
                print(f"| {seed} | {name}, change | " + " | ".join(f"{100 * (s / r - 1):+.1f} %" for s, r in zip(here, first))
                      + " |", flush=True)


if __name__ == "__main__":
    main()
