#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""
Two programs of softgrain in turns: the table "Before and after" of doc/results/rivals.md.

    before_and_after.py BEFORE AFTER FOLDER [--rounds 3] [--only NAME ...]

BEFORE and AFTER are programs, each in the build folder where its library is. Every case runs --rounds times with both, one after the other, on one
thread. The table has medians of processor time in seconds, and the median of the ratios after/before with the smallest and the largest.
"""
import argparse
import pathlib
import statistics

from processor import seconds_of

PARAMETERS = pathlib.Path(__file__).resolve().parents[1] / "parameters"
SPARSE = {"Output/Fields every": 1, "Output/Snapshots every": 1, "Output/Number of field outputs": 1}
PRIMARIES = "thesis/uniaxial_compaction_bpm_friction.prm"
SMALLER = {"Primaries/Smallest diameter": 6.12e-5, "Primaries/Largest diameter": 1.137e-4}  # 100 000 in place of 76 500
CASES = {
    "start": None,
    "one disk": ("thesis/diametral_compression_mpm.prm", {}),
    "thirty at 5 m/s": ("gallery/thirty_grains_mpm.prm", {}),
    "thirty at rest": ("gallery/thirty_grains_quasi_static_mpm.prm", {}),
    "300 at 5 m/s": ("thesis/uniaxial_compaction_mpm.prm", {"Stop/End time": 3e-4, **SPARSE}),
    "100 000 primaries, one step": (PRIMARIES, {**SMALLER, "Stop/End time": 1e-7, **SPARSE}),
    "100 000 primaries, 40 steps": (PRIMARIES, {**SMALLER, "Stop/End time": 4e-6, **SPARSE}),
    "eight spheres": ("gallery/eight_spheres.prm", {}),
}


def command_of(program, case, folder):
    """The words of one run; without a case the program says its version."""
    if case is None:
        return [program, "--version"]
    scene, changes = case
    words = [program, "run", PARAMETERS / scene, "--threads", 1, "--overwrite", "--output", folder]
    return words + [word for name, value in changes.items() for word in ("--set", f"{name}={value}")]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("before", type=pathlib.Path)
    parser.add_argument("after", type=pathlib.Path)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--only", nargs="+", choices=CASES, default=list(CASES))
    arguments = parser.parse_args()
    folder = arguments.folder.resolve()
    folder.mkdir(parents=True, exist_ok=True)
    programs = [arguments.before.resolve(), arguments.after.resolve()]
    for name in arguments.only:
        pairs = [[seconds_of(command_of(program, CASES[name], folder / f"{side} {name}")) for side, program in zip(("before", "after"), programs)]
                 for _ in range(arguments.rounds)]
        medians = [statistics.median(side) for side in zip(*pairs)]
        ratios = [after / before for before, after in pairs]
        print(f"| {name} | {medians[0]:.2f} | {medians[1]:.2f} | {statistics.median(ratios):.2f} ({min(ratios):.2f} to {max(ratios):.2f}) |", flush=True)


if __name__ == "__main__":
    main()
