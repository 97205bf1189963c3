#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a step costs with every law of finite strain: the table of doc/results/laws.md. The grains of gallery/thirty_grains_mpm.prm, explicit and
implicit; user seconds of a long run less those of a short one, laws one after the other in each round, medians of the rounds. Also what a scene without
adhesion pays for there being adhesion: the same with a law of contact that adheres with no strength."""
import argparse
import pathlib
import resource
import statistics

from law_packings import LAWS, scene_of
from running import run

SCENE = "gallery/thirty_grains_mpm.prm"
QUIET = {"Output/Fields every": 0, "Output/Snapshots every": 0, "Stop/Packing fraction": 1}
EXPLICIT = {"Time/Scheme": "explicit", "Time/CFL multiple": 0.3, "Contact/Solver": "lumped"}
ENDS = (2e-5, 2e-4)  # of the short run and of the long one [s]
PLAIN = "without adhesion"
ADHESION = {
    PLAIN: {},
    "`cohesive`, strength 0": {"Contact/Law": "cohesive", "Contact/Adhesion": 0, "Contact/Adhesion range": 1e-5},
    "`cohesive`, a table of pairs that none is in": {"Contact/Law": "cohesive", "Contact/Adhesion": 0, "Contact/Adhesion range": 1e-5,
                                                     "Contact/Adhesion of pairs": "gel / top: 0"},
}


def timed(program, scene, folder, changes):
    """User seconds and steps, or iterations of Newton's method where a step has some, of a run."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    summary, rows = run(program, scene, folder, {**QUIET, **changes}, threads=1)
    seconds = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before
    iterations = sum(row["newton_iterations"] for row in rows[1:])
    return seconds, iterations or summary["steps"]


def of_a_step(program, scene, folder, changes):
    """User seconds of a step or an iteration, the start of the program left out."""
    short, long = (timed(program, scene, folder, {**changes, "Stop/End time": end}) for end in ENDS)
    return (long[0] - short[0]) / (long[1] - short[1])


def table(rounds, names, measure):
    """Medians of @measure(name) of every name over @rounds, in which names take turns; and their scatter (median deviation)."""
    found = {name: [] for name in names}
    for _ in range(rounds):
        for name in names:
            found[name].append(measure(name))
    middle = {name: statistics.median(values) for name, values in found.items()}
    return {name: (middle[name], statistics.median(abs(value - middle[name]) for value in values)) for name, values in found.items()}


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("program", help="build/release/bin/softgrain")
    parser.add_argument("folder", nargs="?", type=pathlib.Path, default=pathlib.Path("output/law_costs"))
    parser.add_argument("--library", dest="plug_in", help="with the law energy_only: test_constitutive_module_energy_only of the build")
    parser.add_argument("--rounds", type=int, default=5)
    parser.add_argument("--only", nargs="+", choices=("laws", "adhesion"), default=("laws", "adhesion"))
    words = parser.parse_args()
    words.folder.mkdir(parents=True, exist_ok=True)
    loaded = {"Additional shared libraries": words.plug_in} if words.plug_in else {}
    laws = [law for law in LAWS if law != "energy_only" or words.plug_in]
    schemes = {"explicit step": EXPLICIT, "implicit iteration": {}}
    for title, scheme in schemes.items():
        if "laws" in words.only:
            scenes = {law: scene_of(law, words.folder, SCENE).resolve() for law in laws}
            found = table(words.rounds, laws, lambda law: of_a_step(words.program, scenes[law], words.folder / "run", {**scheme, **loaded}))
            print(f"{title}: law, ms, ±, over neo_hookean")
            for law, (seconds, scatter) in found.items():
                print(f"| `{law}` | {1e3 * seconds:.2f} | {1e3 * scatter:.2f} | {seconds / found['neo_hookean'][0]:.2f} |", flush=True)
        if "adhesion" in words.only:
            found = table(words.rounds, ADHESION,
                          lambda name: of_a_step(words.program, SCENE, words.folder / "run", {**scheme, **ADHESION[name]}))
            print(f"{title}: adhesion, ms, ±, over none")
            for name, (seconds, scatter) in found.items():
                print(f"| {name} | {1e3 * seconds:.2f} | {1e3 * scatter:.2f} | {seconds / found[PLAIN][0]:.3f} |", flush=True)


if __name__ == "__main__":
    main()
