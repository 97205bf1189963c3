#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""
A storm of random scenes, and relations between runs that must hold.

    storm.py --program build/release/bin/softgrain --seeds 1-500 --output DIR
    storm.py --program build/release/bin/softgrain --replay DIR/kept/17-mirror-differs/scene.prm
    storm.py --seeds 17-17 --output DIR --write      only writes the scene

In DIR are then table.md and table.json with all sums, results.jsonl with a line per scene (a storm that goes on in the same
folder leaves out what is there), and kept/ with the scenes that failed, made as small as they go. Exit code: 0 when nothing
failed but what --owed lists, 1 otherwise.
"""
import argparse
import concurrent.futures
import json
import pathlib
import shutil
import sys
import time

import shrink
import table
import trial
from generator import generate
from runs import Program
from scene import read


def seeds_in(text):
    """1-5,8 is 1, 2, 3, 4, 5, 8."""
    result = []
    for part in text.split(","):
        first, _, last = part.partition("-")
        result += range(int(first), int(last or first) + 1)
    return result


def wanted_by(conditions):
    """A question to a scene; "Time/Scheme=quasi_static" compares a value, "family=box" a note."""
    pairs = [condition.split("=", 1) for condition in conditions]
    return lambda scene: all((scene.get(key) or scene.note(key)) == value for key, value in pairs)


def one_seed(seed, options):
    program = Program(options.program, options.limit)
    asked = options.relations.split(",") if options.relations else None
    return trial.try_seed(seed, program, options.work / "work", options.most, asked, wanted_by(options.where))


def all_records(options):
    """Records of all seeds, written line by line as they come."""
    path = options.output / "results.jsonl"
    records = [json.loads(line) for line in path.read_text().splitlines()] if path.exists() else []
    there = {record["seed"] for record in records}
    records = [record for record in records if record["seed"] in set(options.seeds)]
    left = [seed for seed in options.seeds if seed not in there]
    begin = time.monotonic()
    with open(path, "a") as lines, concurrent.futures.ProcessPoolExecutor(options.jobs) as pool:
        for first in range(0, len(left), options.jobs):
            if options.seconds and time.monotonic() - begin > options.seconds:
                print(f"time is over after {first} of {len(left)} scenes")
                break
            for record in pool.map(one_seed, left[first:first + options.jobs], [options] * options.jobs):
                if record:
                    records.append(record)
                    lines.write(json.dumps(record) + "\n")
                    lines.flush()
    return records


def keep_failures(records, known, options):
    """Shrinks what is new, as long as there is time for it; what is not shrunk is kept as it is."""
    program = Program(options.program, options.limit)
    for (seed, relation, kind), _, verdict in table.failures(records):
        if (seed, relation, kind) in known or kind == "storm":
            continue
        scene, seen = program.fitted(generate(seed)), ""
        if program.seconds < options.shrink:
            scene, seen = shrink.shrink(scene, program, options.work / "shrinking", relation, kind,
                                        min(60, options.shrink - program.seconds))
        print("kept", shrink.keep(scene, options.output / "kept", relation, kind, seen or verdict["seen"]))


def replay(options):
    scene = read(options.replay)
    relation = scene.note("relation") or trial.RUN
    names = options.relations.split(",") if options.relations else [relation]
    found = trial.try_scene(scene, Program(options.program, options.limit), options.work / "replay", names)
    for verdict in found:
        print(f"{verdict['relation']}: {verdict['verdict']} {verdict['kind']} {verdict['seen']}")
    return any(verdict["verdict"] == "fails" for verdict in found)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", type=pathlib.Path)
    parser.add_argument("--seeds", type=seeds_in, default=[])
    parser.add_argument("--output", type=pathlib.Path, default=pathlib.Path("storm"))
    parser.add_argument("--work", type=pathlib.Path, help="folder for the runs, on a fast disk; default: in --output")
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--most", type=int, default=5, help="relations asked of a scene; 0: all that apply")
    parser.add_argument("--relations", help="names of the relations to ask, separated by commas; 'run' judges single runs")
    parser.add_argument("--where", action="append", default=[], help="only scenes with this value: Time/Scheme=quasi_static")
    parser.add_argument("--limit", type=int, default=20, help="seconds of processor time of a run")
    parser.add_argument("--seconds", type=float, default=0, help="begin no scene after so many seconds")
    parser.add_argument("--shrink", type=float, default=0, help="seconds of processor time for making failures small")
    parser.add_argument("--owed", type=pathlib.Path, help="known failures")
    parser.add_argument("--replay", type=pathlib.Path, help="a scene that was kept")
    parser.add_argument("--anew", action="store_true", help="remove the folder of an earlier storm first")
    parser.add_argument("--write", action="store_true", help="write the scenes, run nothing")
    options = parser.parse_args()
    if options.anew and (options.output / "results.jsonl").exists():
        shutil.rmtree(options.output)
    options.output.mkdir(parents=True, exist_ok=True)
    options.work = options.work or options.output
    if options.write:
        for seed in options.seeds:
            print(generate(seed).save(options.output / f"scene-{seed}"))
        return 0
    if options.replay:
        return int(replay(options))
    records = all_records(options)
    known = table.owed(options.owed)
    table.write(records, options.output)
    print((options.output / "table.md").read_text())
    lines, new = table.report(records, known)
    print("\n".join(lines))
    keep_failures(records, known, options)
    return int(new)


if __name__ == "__main__":
    sys.exit(main())
