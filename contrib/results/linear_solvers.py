#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Times the linear solvers over the size of one body, with and without contact rows: tables of doc/results/linear-solvers.md.

Usage: linear_solvers.py SOFTGRAIN_EXECUTABLE [OUTPUT_FOLDER]
"""
import json
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
TYPES = ("banded_cholesky", "cholesky", "trilinos_direct", "cg_ilu", "cg_amg")
LIMIT = 400  # seconds a run may take
WIDE_MESH = ["Mesh/Lower=-8e-3, -6e-3", "Mesh/Upper=8e-3, 6e-3"]
# Scene, what to change, and cell sizes [m].
SCENES = {
    "with contact": ("verification/line_contact.prm", WIDE_MESH + ["Stop/End time=0.01"], (5.8e-4, 2.9e-4, 1.45e-4, 7.25e-5)),
    "without contact": ("verification/spinning_disk.prm", ["Stop/End time=2e-3"], (2.5e-3, 1.25e-3, 6.25e-4, 3.125e-4)),
}


def run(program, scene, changes, output):
    """Summary and number of unknowns of one run; nothing when it took too long or failed."""
    command = [program, "run", str(ROOT / "parameters" / scene), "--output", str(output)]
    for change in changes + ["Output/Fields every=0", "Output/Number of field outputs=0"]:
        command += ["--set", change]
    try:
        done = subprocess.run(command, capture_output=True, text=True, timeout=LIMIT)
    except subprocess.TimeoutExpired:
        return None, f"over {LIMIT} s"
    if done.returncode != 0:
        return None, (done.stderr.strip().splitlines() or [f"ended with status {done.returncode}"])[-1]
    unknowns = next(line.split()[1] for line in done.stdout.splitlines() if line.strip().startswith("unknowns"))
    with open(output / "summary.json", encoding="utf-8") as file:
        return {**json.load(file), "unknowns": unknowns}, ""


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    folder = pathlib.Path(sys.argv[2] if len(sys.argv) > 2 else "output/linear_solvers")
    for name, (scene, changes, sizes) in SCENES.items():
        print(f"\n{scene}, {name}\n\n| unknowns | type | factorisation [s] | condensation [s] | solves [s] | all [s] | peak memory [MB] |\n"
              "|---|---|---|---|---|---|---|")
        for size in sizes:
            for kind in TYPES:
                these = changes + [f"Mesh/Cell size={size}", f"Linear solver/Type={kind}"]
                summary, trouble = run(sys.argv[1], scene, these, folder / f"{pathlib.Path(scene).stem}-{size}-{kind}")
                if summary is None:
                    print(f"| h = {size} m | `{kind}` | {trouble} | | | | |", flush=True)
                    continue
                phase = lambda key: f"{summary['phases'].get(key, 0.):.2f}"
                print(f"| {summary['unknowns']} | `{kind}` | {phase('factorisation')} | {phase('condensation')} | "
                      f"{phase('linear solves')} | {summary['wall_seconds']:.1f} | {summary['peak_memory_bytes'] / 1e6:.0f} |",
                      flush=True)


if __name__ == "__main__":
    main()
