#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""What `softgrain check --try` foretells of scenes that no constant was fitted to, and what the runs take: the table of doc/results/forecast.md."""
import argparse
import json
import pathlib
import re
import subprocess

BOX = """
subsection Packing
  set Number            = 16
  set Material          = gel
  set Smallest diameter = 1.6e-3
  set Largest diameter  = 2.4e-3
  set Upper             = 9e-3, 9e-3
  set Packing fraction  = 0.6
  set Seed              = 3
end
subsection Walls
  set Names = bottom, top, left, right
  subsection bottom
    set Point = 0, 0
  end
  subsection top
    set Point    = 0, 9e-3
    set Velocity = 0.3
  end
  subsection left
    set Point = 0, 0
  end
  subsection right
    set Point = 9e-3, 0
  end
end
subsection Stop
  set Packing fraction = 0.93
  set End time         = 10
end
subsection Output
  set Number of field outputs = 1
end
"""
SOFT = """
set Model = mpm
subsection Materials
  set Names = gel, stone
  subsection gel
    set Law     = neo_hookean
    set Density = 1000
    subsection Neo-Hookean
      set Young's modulus = 1e6
    end
  end
  subsection stone
    set Law     = neo_hookean
    set Density = 1000
    subsection Neo-Hookean
      set Young's modulus = 1e7
    end
  end
end
subsection Mesh
  set Lower     = -2e-3, -2e-3
  set Upper     = 11e-3, 11e-3
  set Cell size = 4e-4
end
"""
BONDED = """
set Model = bpm
subsection Materials
  set Names = gel
end
subsection Primaries
  set Smallest diameter = 1.2e-4
  set Largest diameter  = 2e-4
end
"""
ROUGH, STILL = ["Contact/Friction=0.5"], ["Time/Scheme=quasi_static", "Time/Wall way=0.2"]
POLYGONS = ["Packing/Shapes=polygon", "Packing/Corners=3, 6", "Mesh/Cell size=2.5e-4", "Stop/Packing fraction=0.9"]
MIXED = ["Packing/Material=", "Packing/Smallest diameter=1.4e-3", "Packing/Largest diameter=2.4e-3",  # (their defaults: classes have sizes of their own)
         "Packing/Classes=0.5: 1.6e-3 to 2.4e-3, gel; 0.5: 1.6e-3 to 2.4e-3, stone"]
SCENES = {
    "friction, slow wall": (SOFT, ROUGH),
    "friction, slower wall, .05 m/s": (SOFT, ROUGH + ["Walls/top/Velocity=0.05", "Time/Wall way=0.2"]),
    "40 grains, friction": (SOFT, ROUGH + ["Packing/Number=40", "Packing/Upper=14e-3, 14e-3", "Mesh/Upper=16e-3, 16e-3",
                                         "Walls/top/Point=0, 14e-3", "Walls/right/Point=14e-3, 0"]),
    "hard and soft, friction .2": (SOFT, MIXED + ["Contact/Friction=0.2"]),
    "Maxwell, friction .5": (SOFT, ROUGH + ["Materials/gel/Law=maxwell"]),
    "without inertia": (SOFT, STILL),
    "without inertia, friction": (SOFT, STILL + ROUGH),
    "without inertia, hard and soft, friction": (SOFT, STILL + ROUGH + MIXED),
    "64 grains without inertia, friction, to .95": (SOFT, STILL + ROUGH + [
        "Packing/Number=64", "Packing/Upper=18e-3, 18e-3", "Mesh/Upper=20e-3, 20e-3", "Mesh/Cell size=3e-4", "Walls/top/Point=0, 18e-3",
        "Walls/right/Point=18e-3, 0", "Stop/Packing fraction=0.95"]),
    "64 grains without inertia, hard and soft, friction .3": (SOFT, STILL + MIXED + [
        "Packing/Number=64", "Packing/Seed=5", "Packing/Upper=18e-3, 18e-3", "Mesh/Upper=20e-3, 20e-3", "Mesh/Cell size=3e-4",
        "Walls/top/Point=0, 18e-3", "Walls/right/Point=18e-3, 0", "Contact/Friction=0.3"]),
    "polygons, friction": (SOFT, POLYGONS + ROUGH),
    "polygons": (SOFT, POLYGONS),
    "polygons without inertia": (SOFT, POLYGONS + STILL),
    "bonded, with preparation": (BONDED, ["Walls/top/Velocity=3"]),
    "bonded, 40 grains, to .80": (BONDED, ["Walls/top/Velocity=3", "Packing/Number=40", "Packing/Upper=14e-3, 14e-3", "Stop/Packing fraction=0.8",
                                          "Walls/top/Point=0, 14e-3", "Walls/right/Point=14e-3, 0"]),
    # From here on, scenes that the rule of trials was not chosen with either.
    "new: friction .3, .1 m/s": (SOFT, ["Contact/Friction=0.3", "Packing/Seed=11", "Walls/top/Velocity=0.1", "Time/Wall way=0.2"]),
    "new: hard and soft, friction .5": (SOFT, MIXED + ROUGH + ["Packing/Seed=8"]),
    "new: Maxwell": (SOFT, ["Packing/Seed=6", "Materials/gel/Law=maxwell"]),
    "new: without inertia, hard and soft": (SOFT, STILL + MIXED + ["Packing/Seed=9"]),
    "new: polygons without inertia, friction .3": (SOFT, POLYGONS + STILL + ["Contact/Friction=0.3", "Packing/Seed=7"]),
}
UNITS = {"s": 1, "min": 60, "h": 3600, "MB": 1, "GB": 1e3}


def amount(text):
    return sum(float(value) * UNITS.get(unit, 1) for value, unit in re.findall(r"([\d.e+]+) ?([A-Za-z]*)", text.removeprefix("about ")))


def softgrain(program, *words):
    done = subprocess.run([program, *words, "--threads", "1"], capture_output=True, text=True, check=False)
    return done.returncode, done.stdout, done.stderr.strip()


def told(program, scene, changes, *words):
    status, printed, error = softgrain(program, "check", scene, *changes, *words)
    if status:
        raise SystemExit(error)
    lines = dict(re.split(r"\s{2,}", line.strip(), maxsplit=1) for line in printed.splitlines() if line.startswith("  "))
    return [amount(lines[name]) for name in ("steps", "processor time", "memory")], lines.get("trial", "")


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("program")
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("scenes", nargs="*", help="parts of the names of scenes (default: all)")
    parser.add_argument("--again", action="store_true", help="take the runs that are there, make the trials anew")
    arguments = parser.parse_args()
    arguments.folder.mkdir(parents=True, exist_ok=True)
    print("| scene | steps: formula, trial, made | processor time [s]: formula, trial, made | memory [MB]: foretold, made | the trial went |\n|---|---|---|---|---|")
    for name, (model, settings) in SCENES.items():
        if arguments.scenes and not any(word in name for word in arguments.scenes):
            continue
        stem = re.sub(r"\W+", "_", name)
        scene = arguments.folder / f"{stem}.prm"
        scene.write_text(model + BOX, encoding="utf-8")
        changes = [word for setting in settings for word in ("--set", setting)]
        formula, _ = told(arguments.program, scene, changes)
        trial, way = told(arguments.program, scene, changes, "--try")
        summary, error = arguments.folder / stem / "summary.json", ""
        if not (arguments.again and summary.is_file()):
            _, _, error = softgrain(arguments.program, "run", scene, *changes, "--output", arguments.folder / stem, "--overwrite")
        found = json.loads(summary.read_text(encoding="utf-8"))
        rows = [found["steps"], found["processor_seconds"], found["peak_memory_bytes"] / 1e6]
        steps, seconds = (f"{formula[k]:.3g}, {trial[k]:.3g}, {rows[k]:.3g}" for k in (0, 1))
        way = re.search(r"\d+ % of the way|to the end", way)
        print(f"| {name} | {steps} | {seconds} | {trial[2]:.0f}, {rows[2]:.0f} | {way.group(0) if way else ''} | {error}", flush=True)


if __name__ == "__main__":
    main()
