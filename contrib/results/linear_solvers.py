#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Times the linear solvers over the size of one body, with and without contact rows: tables of doc/results/linear-solvers.md."""
import pathlib

from running import RunFailed, parser_of, run

TYPES = ("banded_cholesky", "cholesky", "cg_amg")
LIMIT = 400  # seconds a run may take
WIDE_MESH = {"Mesh/Lower": "-8e-3, -6e-3", "Mesh/Upper": "8e-3, 6e-3"}
NO_OUTPUT = {"Output/Fields every": "0", "Output/Number of field outputs": "0"}
# Scene, what to change, and cell sizes [m].
SCENES = {
    "with contact": ("verification/line_contact.prm", {**WIDE_MESH, "Stop/End time": "0.01"}, (5.8e-4, 2.9e-4, 1.45e-4, 7.25e-5)),
    "without contact": ("verification/spinning_disk.prm", {"Stop/End time": "2e-3"}, (2.5e-3, 1.25e-3, 6.25e-4, 3.125e-4)),
}


def main():
    parser = parser_of(__doc__, "linear_solvers")
    arguments = parser.parse_args()
    for name, (scene, changes, sizes) in SCENES.items():
        print(f"\n{scene}, {name}\n\n| unknowns | type | factorisation [s] | condensation [s] | solves [s] | all [s] | peak memory [MB] |\n"
              "|---|---|---|---|---|---|---|")
        for size in sizes:
            for kind in TYPES:
                output = arguments.folder / f"{pathlib.Path(scene).stem}-{size}-{kind}"
                these = {**changes, **NO_OUTPUT, "Mesh/Cell size": size, "Linear solver/Type": kind}
                try:
                    summary, _ = run(arguments.program, scene, output, these, limit=LIMIT)
                except RunFailed as trouble:
                    print(f"| h = {size} m | `{kind}` | {trouble} | | | | |", flush=True)
                    continue
                log = (output / "log").read_text(encoding="utf-8").splitlines()
                unknowns = next(line.split()[1] for line in log if line.strip().startswith("unknowns"))
                phase = lambda key: f"{summary['phases'].get(key, 0.):.2f}"
                print(f"| {unknowns} | `{kind}` | {phase('factorisation')} | {phase('condensation')} | "
                      f"{phase('linear solves')} | {summary['wall_seconds']:.1f} | {summary['peak_memory_bytes'] / 1e6:.0f} |",
                      flush=True)


if __name__ == "__main__":
    main()
