#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""A hundred thousand bonded primaries by one process and by two ranks, in seconds on the clock: the figures of doc/ranks.md. Needs
two cores with nothing else to do, and three minutes."""
import json
import os
import shutil
import statistics
import subprocess
import time

from running import PARAMETERS, box, parser_of

SCENE = "thesis/uniaxial_compaction_bpm_friction.prm"
STEP = 1e-7  # [s]
# Ranks (0: no mpirun) and threads of each.
WAYS = {"one thread": (0, 1), "two threads": (0, 2), "two ranks": (2, 1)}


def scene(grains):
    """Equal grains of two kinds, so that their preparation takes no time."""
    changes, _, _ = box(grains, 300, 34.5e-3, 34.5e-3)
    return {**changes, "Packing/Smallest diameter": 1.9e-3, "Packing/Largest diameter": 1.9e-3, "Primaries/Variants": 2,
            "Output/Fields every": 0, "Output/Snapshots every": 0, "Stop/Packing fraction": 0}


def seconds(program, folder, way, changes):
    """On the clock, of a whole run."""
    ranks, threads = WAYS[way]
    launcher = ["mpirun", "--oversubscribe", "-n", str(ranks)] if ranks else []
    sets = [word for name, value in changes.items() for word in ("--set", f"{name}={value}")]
    shutil.rmtree(folder, ignore_errors=True)
    begin = time.monotonic()
    subprocess.run([*launcher, program, "run", PARAMETERS / SCENE, "--threads", str(threads), "--output", folder, *sets], check=True,
                   stdout=subprocess.DEVNULL, timeout=300,
                   env={**os.environ, "OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"})
    return time.monotonic() - begin


def main():
    parser = parser_of(__doc__, "bonded_ranks")
    parser.add_argument("--grains", type=int, default=418, help="of some 240 primaries (default: %(default)s)")
    parser.add_argument("--steps", type=int, default=30, help="default: %(default)s")
    parser.add_argument("--turns", type=int, default=3, help="default: %(default)s")
    arguments = parser.parse_args()
    changes = scene(arguments.grains)
    long, short = {**changes, "Stop/End time": arguments.steps * STEP}, {**changes, "Stop/End time": 1e-9}
    whole, start = {way: [] for way in WAYS}, {way: [] for way in WAYS}
    for _ in range(arguments.turns):
        for way in WAYS:
            start[way].append(seconds(arguments.program, arguments.folder / "start", way, short))
            whole[way].append(seconds(arguments.program, arguments.folder / way, way, long))
    histories = {(arguments.folder / way / "history.csv").read_bytes() for way in WAYS}
    primaries = json.loads((arguments.folder / "two ranks" / "summary.json").read_text())["primaries"]
    print(f"{primaries} primaries, {arguments.steps} steps, the same history: {len(histories) == 1}\n\n"
          "| | whole run [s] | a run of one step of 1 ns [s] |\n|---|---|---|")
    for way in WAYS:
        print(f"| {way} | " + " | ".join(", ".join(f"{one:.2f}" for one in times[way]) for times in (whole, start)) + " |")
    middle = {way: (statistics.median(whole[way]), statistics.median(whole[way]) - statistics.median(start[way])) for way in WAYS}
    for text, above, below, asked in (("two ranks over two threads", "two ranks", "two threads", "at most 1.1"),
                                      ("one thread over two ranks", "one thread", "two ranks", "at least 1.8")):
        ratios = [first / second for first, second in zip(middle[above], middle[below])]
        print(f"{text}: {ratios[0]:.2f}, less the start {ratios[1]:.2f} ({asked} is asked for)")


if __name__ == "__main__":
    main()
