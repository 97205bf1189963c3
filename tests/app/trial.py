# SPDX-License-Identifier: LGPL-2.1-or-later
"""
`softgrain check --try` against the run itself: steps, processor time and memory within a factor of two, on scenes that no constant of a
forecast was fitted to. Arguments: program, root of the repository, folder to work in.
"""

import json
import os
import re
import shutil
import subprocess
import sys
import unittest

PROGRAM, WORK = os.path.abspath(sys.argv[1]), os.path.abspath(sys.argv[3])
BOX = """
subsection Walls
  set Names = bottom, top, left, right
  subsection bottom
    set Point = 0, 0
  end
  subsection top
    set Point    = 0, 6e-3
    set Velocity = {speed}
  end
  subsection left
    set Point = 0, 0
  end
  subsection right
    set Point = 6e-3, 0
  end
end
subsection Packing
  set Number            = 5
  set Smallest diameter = 1.6e-3
  set Largest diameter  = 2.4e-3
  set Upper             = 6e-3, 6e-3
  set Packing fraction  = 0.5
end
subsection Stop
  set Packing fraction = 0.88
  set End time         = 10
end
subsection Output
  set Number of field outputs = 1
end
"""
SOFT = """
set Model = mpm
subsection Materials
  set Names = gel
  subsection gel
    set Law     = {law}
    set Density = 1000
  end
end
subsection Mesh
  set Lower     = -1e-3, -1e-3
  set Upper     = 7e-3, 7e-3
  set Cell size = 2.5e-4
end
subsection Contact
  set Friction = {friction}
end
"""
BONDED = """
set Model = bpm
subsection Materials
  set Names = grain
  subsection grain
    set Density = 1000
  end
end
subsection Primaries
  set Smallest diameter = 1.5e-4
  set Largest diameter  = 2.5e-4
end
"""


def softgrain(*words):
    done = subprocess.run([PROGRAM, *words], cwd=WORK, capture_output=True, text=True, check=False)
    return done.returncode, done.stdout, done.stderr


def seconds_of(text):
    return sum(float(number) * {"h": 3600, "min": 60, "s": 1}[unit] for number, unit in re.findall(r"([\d.]+) (h|min|s)\b", text))


def told(printed, name):
    return re.search(rf"^  {name} +(.*)$", printed, re.M).group(1)


class Trials(unittest.TestCase):
    def compare(self, name, text, *settings, seconds=2):
        path = f"{name}.prm"
        with open(os.path.join(WORK, path), "w", encoding="utf-8") as file:
            file.write(text)
        words = [word for setting in settings for word in ("--set", setting)]
        before = sorted(os.listdir(WORK))
        status, printed, errors = softgrain("check", path, *words, "--try", str(seconds), "--threads", "1")
        self.assertEqual((status, errors, sorted(os.listdir(WORK))), (0, "", before))
        status, _, errors = softgrain("run", path, *words, "--output", name, "--threads", "1")
        self.assertEqual((status, errors), (0, ""))
        with open(os.path.join(WORK, name, "summary.json"), encoding="utf-8") as file:
            made = json.load(file)
        steps = float(told(printed, "steps").split()[-1])
        megabytes = float(re.search(r"([\d.]+) MB", told(printed, "memory")).group(1))
        for what, foretold, found in (("steps", steps, made["steps"]),
                                      ("processor time", seconds_of(told(printed, "processor time")), made["processor_seconds"]),
                                      ("memory", megabytes, made["peak_memory_bytes"] / 1e6)):
            self.assertTrue(0.5 <= foretold / found <= 2., f"{name}: {what} {foretold:g} for {found:g}\n{printed}")
        # The formula has walls that are through each other in a thousandth of 'End time', and ends where 'Packing fraction' does.
        _, by_formula, _ = softgrain("check", path, *words)
        steps = float(told(by_formula, "steps").split()[1])
        self.assertTrue(0.5 <= steps / made["steps"] <= 2., f"{name}: {steps:g} steps by formula for {made['steps']}\n{by_formula}")
        # Of one thread, with what the program needs to start.
        self.assertLess(made["processor_seconds"], made["wall_seconds"] + 1.)
        return printed

    def test_polygons_that_rub(self):
        self.compare("polygons", SOFT.format(law="neo_hookean", friction=0.5) + BOX.format(speed=0.3), "Packing/Shapes=polygon",
                     "Packing/Corners=3, 6", "Packing/Packing fraction=0.4", "Stop/Packing fraction=0.6")

    def test_matter_that_forgets(self):
        self.compare("maxwell", SOFT.format(law="maxwell", friction=0.2) + BOX.format(speed=1), "Stop/Packing fraction=0.8", seconds=1)

    def test_no_inertia(self):
        printed = self.compare("still", SOFT.format(law="neo_hookean", friction=0.3) + BOX.format(speed=1), "Time/Scheme=quasi_static",
                               "Time/Wall way=0.5")
        self.assertIn("trial ", printed)
        self.assertNotIn("--try computes", printed)

    def test_bonded_with_preparation(self):
        printed = self.compare("bonded", BONDED + BOX.format(speed=3), "Packing/Packing fraction=0.4",
                               "Stop/Packing fraction=0.45")
        # A trial of larger primaries was soon at its end, and the scene itself was tried.
        self.assertNotIn("Primaries", told(printed, "trial"))
        _, printed, _ = softgrain("check", "bonded.prm", "--set", "Packing/Packing fraction=0.4", "--set", "Stop/Packing fraction=0.45",
                                  "--try", "0.2", "--threads", "1")
        self.assertIn("'Primaries/Smallest diameter' = ", told(printed, "trial"))

    def test_refused(self):
        with open(os.path.join(WORK, "any.prm"), "w", encoding="utf-8") as file:
            file.write(BONDED + BOX.format(speed=3))
        status, _, errors = softgrain("check", "any.prm", "--try", "0")
        self.assertEqual((status, errors.count("--try"), errors.count("\n")), (2, 1, 1), errors)


class Advice(unittest.TestCase):
    """What is said of cells names the body that is meant."""

    def test_thinnest_of_a_table(self):
        with open(os.path.join(WORK, "grains.csv"), "w", encoding="utf-8") as file:
            file.write("x_m,y_m,shape,a_m,b_m,corners,angle_deg\n0.0015,0.0015,disk,0.0012,0.0012,0,0\n"
                       "0.0045,0.0045,polygon,0.0004,0.0004,3,0\n")
        with open(os.path.join(WORK, "table.prm"), "w", encoding="utf-8") as file:
            file.write(SOFT.format(law="neo_hookean", friction=0.5) + BOX.format(speed=0.3).replace("set Number            = 5", "set File = grains.csv")
                       .replace("set Packing fraction  = 0.5", ""))
        status, printed, errors = softgrain("check", "table.prm", "--set", "Mesh/Cell size=3e-4")
        self.assertEqual((status, errors), (0, ""))
        # The circle in an equilateral triangle has half the radius of the one around it.
        self.assertIn("is 0.75 of the width of body 'grain_2', 0.0004 m", printed)


class Words(unittest.TestCase):
    """What a scene says where it lies, and what rubs in it."""

    def write(self, name, *parts):
        path = os.path.join(WORK, name)
        os.makedirs(os.path.dirname(path), exist_ok=True)
        with open(path, "w", encoding="utf-8") as file:
            file.write("\n".join(parts))

    def test_paths_count_from_the_file(self):
        """A table beside an included file is found from there; that of --set from here; parameters.prm can be run from anywhere."""
        table = "x_m,y_m,radius_m\n0.0015,0.0015,0.0012\n0.0045,0.0045,0.0012\n"
        scene = SOFT.format(law="neo_hookean", friction=0.5) + BOX.format(speed=0.3).replace("set Number            = 5", "").replace(
            "set Packing fraction  = 0.5", "")
        self.write("far/tables/two.csv", table)
        self.write("far/tables/packing.prm", "subsection Packing", "  set File = two.csv", "end")
        self.write("far/scene.prm", "include tables/packing.prm", scene)
        status, printed, errors = softgrain("check", "far/scene.prm")
        self.assertEqual((status, errors, told(printed, "bodies")), (0, "", "2"))
        status, _, errors = softgrain("check", "far/scene.prm", "--set", "Packing/File=two.csv")
        self.assertEqual((status, "there is no file 'two.csv'" in errors), (2, True), errors)
        status, _, errors = softgrain("run", "far/scene.prm", "--set", "Stop/End time=1e-5", "--output", "far/out/run")
        self.assertEqual((status, errors), (0, ""))
        status, printed, errors = softgrain("check", "far/out/run/parameters.prm", "--output", "elsewhere")
        self.assertEqual((status, errors, told(printed, "bodies")), (0, "", "2"))

    def test_friction_of_walls(self):
        self.write("rough.prm", SOFT.format(law="neo_hookean", friction=0.5) + BOX.format(speed=0.3))
        for words, said in (([], "0.5 between bodies; none at bottom, top, left, right ('Contact/Friction at walls' = 'same' gives it to walls)"),
                            (["Contact/Friction at walls=same"], "0.5 everywhere"), (["Contact/Friction=0"], "none"),
                            (["Walls/top/Friction=0.2"], "0.5 between bodies; none at bottom, left, right; 0.2 at top"),
                            (["Contact/Friction at walls=same", "Contact/Friction of pairs=gel / top: 0"],
                             "0.5 between bodies; 0.5 at bottom, top, left, right; none of gel / top")):
            status, printed, errors = softgrain("check", "rough.prm", *(word for one in words for word in ("--set", one)))
            self.assertEqual((status, errors, told(printed, "friction")), (0, "", said))


if __name__ == "__main__":
    shutil.rmtree(WORK, ignore_errors=True)
    os.makedirs(WORK)
    unittest.main(argv=sys.argv[:1])
