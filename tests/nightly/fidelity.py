# SPDX-License-Identifier: LGPL-2.1-or-later
"""
What `Fidelity` = draft, standard and reference is worth, for one grain and for an assembly: errors and cost that doc/results/trade.md states.

    fidelity.py PROGRAM PARAMETERS FOLDER
"""
import csv
import json
import math
import pathlib
import resource
import shutil
import subprocess
import sys
import unittest

PROGRAM, PARAMETERS, WORK = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])
PRESETS = ("draft", "standard", "reference")
WALLS = ("bottom", "top", "left", "right")


def without(text, *keys):
    """A parameter file that leaves these parameters to the program."""
    return "".join(line for line in text.splitlines(keepends=True)
                   if not any(line.split("=")[0].strip() == f"set {key}" for key in keys))


def computed(name, scene, *settings):
    """Columns of the history of a run, its summary and the processor time that it took."""
    folder = WORK / name
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    (folder / "scene.prm").write_text(scene)
    words = [PROGRAM, "run", folder / "scene.prm", "--threads", "1", "--output", folder / "out"]
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    done = subprocess.run([*words, *(word for setting in settings for word in ("--set", setting))],
                          capture_output=True, text=True, check=False)
    if done.returncode:
        raise RuntimeError(done.stderr)
    seconds = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before
    with open(folder / "out/history.csv", newline="") as file:
        rows = list(csv.DictReader(file))
    columns = {key: [float(row[key] or "nan") for row in rows] for key in rows[0]}
    return columns, json.loads((folder / "out/summary.json").read_text()), seconds


def mean_near(x, y, at, width):
    near = [value for place, value in zip(x, y) if abs(place - at) <= width]
    return sum(near) / len(near)


def difference(curve, reference):
    """Root mean square over that of the reference."""
    return math.sqrt(sum((a - b) ** 2 for a, b in zip(curve, reference)) / sum(b * b for b in reference))


def forces_of_one(preset):
    scene = without((PARAMETERS / "verification/four_plates.prm").read_text(), "Cell size")
    # A margin of two cells of the coarsest preset.
    columns, _, seconds = computed(f"one_{preset}", scene, f"Fidelity={preset}", "Mesh/Lower=-6.7e-3, -6.7e-3",
                                   "Mesh/Upper=6.7e-3, 6.7e-3")
    force = [sum(columns[f"{wall}_force_N_per_m"][i] for wall in WALLS) / 4 for i in range(len(columns["time_s"]))]
    times = (0.02, 0.04, 0.06, 0.08, 0.1)
    return [force[min(range(len(force)), key=lambda i: abs(columns["time_s"][i] - t))] for t in times], seconds


def stresses_of_assembly(preset, name="thirty_grains_mpm", kind="assembly", seeds=(1, 2), settings=("Stop/End time=2e-3",)):
    """Stress of a compacted assembly at four packing fractions, and seconds: means over packings."""
    scene = without((PARAMETERS / f"gallery/{name}.prm").read_text(), "Cell size", "CFL multiple")
    curve, cost = [0.] * 4, 0.
    for seed in seeds:
        columns, _, seconds = computed(f"{kind}_{preset}_{seed}", scene, f"Fidelity={preset}", f"Packing/Seed={seed}",
                                       "Contact/Friction=0.5", *(f"Walls/{wall}/Friction=0.5" for wall in WALLS),
                                       "Packing/Packing fraction=0.70", "Stop/Packing fraction=0.93",
                                       "Output/Fields every=0", "Output/Snapshots every=0", *settings)
        stress = [(top + bottom) / 2 for top, bottom in zip(columns["top_force_N_per_m"], columns["bottom_force_N_per_m"])]
        for i, at in enumerate((0.80, 0.84, 0.88, 0.92)):
            curve[i] += mean_near(columns["packing_fraction"], stress, at, 0.01) / len(seeds)
        cost += seconds / len(seeds)
    return curve, cost


class Presets(unittest.TestCase):
    def check(self, what, of_preset, limits):
        found = {preset: of_preset(preset) for preset in PRESETS}
        reference = found["reference"][0]
        for preset, limit in zip(PRESETS, limits):
            error = difference(found[preset][0], reference)
            print(f"{what}, {preset}: {100 * error:.2g} % from the reference, {found[preset][1]:.1f} s")
            self.assertLessEqual(error, limit, f"{what}, {preset}")
        self.assertLess(found["draft"][1], found["standard"][1])
        self.assertLess(found["standard"][1], found["reference"][1])

    def test_one_grain(self):
        self.check("one grain", forces_of_one, (0.03, 0.01, 0.))

    def test_assembly(self):
        self.check("assembly", stresses_of_assembly, (0.12, 0.06, 0.))

    def test_at_rest(self):
        """Without inertia: cells are those of the preset, the way of the wall in a step a tenth of a cell, half of that in the reference."""
        def of_preset(preset):
            way = "Time/Wall way=" + ("0.05" if preset == "reference" else "0.1")
            return stresses_of_assembly(preset, "thirty_grains_quasi_static_mpm", "rest", settings=(way, "Stop/End time=5e-3"))
        self.check("assembly at rest", of_preset, (0.12, 0.06, 0.))

    def test_bonded(self):
        """The step of bonded particles."""
        steps = []
        for preset in PRESETS:
            _, summary, _ = computed(f"bonded_{preset}", (PARAMETERS / "gallery/one_grain_bpm.prm").read_text(), f"Fidelity={preset}")
            steps.append(summary["steps"])
        self.assertLess(abs(steps[1] / steps[0] - 2), 0.1)
        self.assertLess(abs(steps[2] / steps[1] - 2), 0.1)

    def test_what_a_file_sets_counts(self):
        scene = (PARAMETERS / "gallery/two_disks.prm").read_text()
        for preset in PRESETS:
            computed(f"set_{preset}", scene, f"Fidelity={preset}", "Stop/End time=1e-5")
            text = (WORK / f"set_{preset}/out/parameters.prm").read_text()
            self.assertRegex(text, r"set Cell size *= 6e-4")
            self.assertRegex(text, r"set CFL multiple *= 2\n")


unittest.main(argv=[sys.argv[0], *sys.argv[4:]])
