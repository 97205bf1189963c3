#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""
Files that include others, files with many mistakes, files of somebody else: which line counts, what is told, and that
`check` writes nothing. Arguments: test_app_many_starts REPOSITORY WORK.
"""

import json
import os
import shutil
import sys
import unittest

from starts import Starts

PROGRAM, REPOSITORY, WORK = map(os.path.abspath, sys.argv[1:4])
shutil.rmtree(WORK, ignore_errors=True)
os.makedirs(WORK)
os.chdir(WORK)

DISK = """set Model = bpm
subsection Materials
  set Names = grain
end
subsection Bodies
  set Names = disk
  subsection disk
    set Radius = 1e-3
  end
end
subsection Primaries
  set Smallest diameter = 0.3e-3
  set Largest diameter  = 0.5e-3
end
"""
PACKED = DISK[:DISK.index("subsection Bodies")] + DISK[DISK.index("subsection Primaries"):] + """subsection Packing
  set Number = 3
  set Smallest diameter = 2e-3
  set Largest diameter  = 2e-3
  set Lower  = 0, 0
  set Upper  = 8e-3, 8e-3
  set Save to = {save_to}
end
subsection Stop
  set End time = 1e-7
end
"""


def end_at(time):
    return f"subsection Stop\n  set End time = {time}\nend\n"


def write(name, text):
    with open(name, "w", encoding="utf-8") as file:
        file.write(text)
    return name


def text_of(name):
    with open(name, encoding="utf-8") as file:
        return file.read()


softgrain = Starts(PROGRAM)


class Cases(unittest.TestCase):
    maxDiff = None

    def ends(self, *words):
        """When a run ends, as `check` says it."""
        status, printed, errors = softgrain("check", *words)
        self.assertEqual((status, errors), (0, ""))
        return next(line.split()[-2] for line in printed.splitlines() if line.strip().startswith("ends at"))

    def refused(self, *words):
        """The lines that are told, without what stands before each."""
        status, printed, errors = softgrain("check", *words)
        self.assertEqual((status, printed), (2, ""), errors)
        start = "softgrain: error: "
        self.assertTrue(all(line.startswith(start) for line in errors.splitlines()), errors)
        return [line.removeprefix(start) for line in errors.splitlines()]


class Includes(Cases):
    def test_the_including_file_counts_more(self):
        os.makedirs("parts", exist_ok=True)
        write("parts/deep.prm", DISK + end_at("1e-3"))
        write("parts/base.prm", end_at("2e-3") + "include deep.prm\n")
        write("other.prm", end_at("4e-3"))
        for lines, expected in ((end_at("3e-3") + "include parts/base.prm\n", "0.003"),
                                ("include parts/base.prm\n" + end_at("3e-3"), "0.003"),
                                ("include parts/base.prm\n", "0.002"), ("include parts/deep.prm\n", "0.001"),
                                ("include parts/base.prm\ninclude other.prm\n", "0.004"),
                                ("include other.prm\ninclude parts/base.prm\n", "0.002"),
                                ("include other.prm\ninclude parts/base.prm\n" + end_at("5e-3"), "0.005")):
            name = write("scene.prm", lines)
            self.assertEqual(self.ends(name), expected, lines)
            self.assertEqual(self.ends(name, "--set", "Stop/End time=6e-3"), "0.006")

    def test_python_reads_alike(self):
        sys.path.insert(0, os.path.join(REPOSITORY, "python"))
        from softgrain.prm_file import read_prm
        write("base.prm", end_at("2e-3"))
        for lines in (end_at("3e-3") + "include base.prm\n", "include base.prm\n" + end_at("3e-3")):
            self.assertEqual(read_prm(write("scene.prm", lines))["Stop", "End time"].text, "3e-3")

    def test_endless(self):
        """Files that include the next one twice would be read 2^n times; a circle for ever."""
        for n in range(12):
            write(f"double_{n}.prm", f"include double_{n + 1}.prm\n" * 2)
        write("double_12.prm", DISK)
        self.assertRegex(self.refused("double_0.prm")[0],
                         r"^double_\d+\.prm:[12]: this is include number 201, and 200 are allowed")
        for n in range(20):
            write(f"long_{n}.prm", f"include long_{n + 1}.prm\n")
        write("long_20.prm", DISK + end_at("1e-3"))
        self.assertEqual(self.refused("long_0.prm"), ["long_15.prm:1: more than 16 files that include each other"])
        self.assertEqual(self.ends("long_5.prm"), "0.001")  # 16 files
        write("here.prm", "include there.prm\n")
        write("there.prm", "include here.prm\n")
        self.assertEqual(self.refused("here.prm"), ["there.prm:1: 'here.prm' includes itself"])


STAGES = """subsection Walls
  set Names = top
  subsection top
    set Point = 0, 2e-3
  end
end
subsection Stages
  set Names = gather, press, hold
  subsection gather
    subsection Stop
      set End time = 1e-3
    end
  end
  subsection press
    subsection Stop
      set End time = 2e-3
    end
  end
  subsection hold
    subsection Stop
      set End time = 4e-3
    end
  end
end
"""


def names(section, listed, more=""):
    return f"subsection {section}\n  set Names = {listed}\n{more}end\n"


class ReplacedNames(Cases):
    def setUp(self):
        write("staged.prm", DISK + STAGES)

    def stages(self, *words):
        """Names of the stages that are left, as `check` says them."""
        status, printed, errors = softgrain("check", *words)
        self.assertEqual((status, errors), (0, ""))
        return [line.split()[1] for line in printed.splitlines() if line.strip().startswith("stage ")]

    def test_dropped_stages(self):
        self.assertEqual(self.stages("staged.prm"), ["gather", "press", "hold"])
        for left in (["gather", "hold"], ["hold"], ["hold", "gather"]):
            listed = ", ".join(left)
            self.assertEqual(self.stages(write("fewer.prm", "include staged.prm\n" + names("Stages", listed))), left)
            self.assertEqual(self.stages("staged.prm", "--set", f"Stages/Names={listed}"), left)
        self.assertEqual(self.stages("fewer.prm", "--set", "Stages/Names=press"), ["press"])
        self.assertEqual(self.ends(write("none.prm", "include staged.prm\n" + names("Stages", "") + end_at("9e-3"))), "0.009")

    def test_another_stage(self):
        soon = "  subsection soon\n    subsection Stop\n      set End time = 3e-3\n    end\n  end\n"
        write("other.prm", "include staged.prm\n" + names("Stages", "gather, soon", soon))
        self.assertEqual(self.stages("other.prm"), ["gather", "soon"])
        self.assertEqual(self.stages("staged.prm", "--set", "Stages/Names=soon", "--set", "Stages/soon/Stop/End time=3e-3"), ["soon"])

    def test_other_sections(self):
        write("two.prm", DISK.replace("= disk\n", "= disk, far\n  subsection far\n    set Center = 9e-3, 0\n    set Radius = 1e-3\n"
                                      "  end\n") + end_at("1e-3"))
        write("one.prm", "include two.prm\n" + names("Bodies", "disk"))
        self.assertEqual(self.ends("one.prm"), "0.001")

    def test_refused(self):
        where = "'Stages/Names' has 'pres', of which nothing is set (did you mean 'press'?); staged.prm:22 has 'gather, press, hold'"
        self.assertEqual(self.refused(write("typo.prm", "include staged.prm\n" + names("Stages", "gather, pres"))),
                         ["typo.prm:3: " + where])
        self.assertEqual(self.refused("staged.prm", "--set", "Stages/Names=gather, pres"), ["--set: " + where])
        write("fewer.prm", "include staged.prm\n" + names("Stages", "hold"))
        # What one file says of a stage that it does not list, and what is said of it later, is a mistake.
        here = "  subsection press\n    subsection Stop\n      set End time = 1e-3\n    end\n  end\n"
        self.assertEqual(self.refused(write("here.prm", "include staged.prm\n" + names("Stages", "gather", here))),
                         ["here.prm:4: unknown section 'Stages/press'; sections here: gather"])
        self.assertEqual(self.refused("fewer.prm", "--set", "Stages/Names=hold", "--set", "Stages/press/Stop/End time=1"),
                         ["--set: unknown section 'Stages/press'; sections here: hold"])


class Mistakes(Cases):
    def test_seven_kinds(self):
        write("seven.prm", """set Model = mpm
set Threads = many
sett Fidelity = draft
subsection Materials
  set Names = gel
  subsection gel
    set Densty = 1000
  end
end
subsection Bodies
  set Names = left, right
  subsection left
    set Radius = 5e-3
    set Material = steel
  end
  subsection right
    set Radius = 1e999
  end
end
subsection Bodys
  set Names = none
end
subsection Walls
  set Names = oblique
  subsection oblique
    set Point = 0, -1
  end
end
subsection Stop
  set End time
end
""")
        lines = self.refused("seven.prm")
        for number, said in ((3, "'sett Fidelity = draft' is not understood"), (30, "'set End time' has no '='"),
                             (2, "'Threads' = 'many' is not allowed: it must be a whole number"),
                             (7, "unknown parameter 'Materials/gel/Densty' (did you mean 'Density'?)"),
                             (17, "'Bodies/right/Radius' = '1e999' is not allowed"), (20, "unknown section 'Bodys'"),
                             (14, "'Bodies/left/Material' = 'steel' is not the name of a material"),
                             ("", "'Walls/oblique/Normal' is missing")):
            found = [line for line in lines if line.startswith(f"seven.prm:{number}") and said in line]
            self.assertEqual(len(found), 1, (said, lines))
        self.assertEqual(len(lines), 8, lines)

    def test_nothing_twice(self):
        """What follows from a mistake is no other one; of what lies in an unknown section nothing is said."""
        write("one.prm", DISK.replace("Radius", "Raduis") + end_at("1e-3"))
        self.assertEqual(len(self.refused("one.prm")), 1)
        write("two.prm", DISK.replace("subsection disk", "subsection dsik\n  set Shape = none\n") + end_at("1e-3"))
        self.assertEqual(len(self.refused("two.prm")), 1)
        write("three.prm", DISK.replace("subsection disk", "subsektion disk") + end_at("1e-3"))
        self.assertEqual([line.split(":")[1] for line in self.refused("three.prm")], ["7"])

    def test_parts_of_the_scene(self):
        """Bodies, walls and stages are looked at one by one, with the place of each."""
        write("parts.prm", DISK.replace("disk\n", "disk, b, c\n", 1).replace("    set Radius = 1e-3\n", """    set Radius = 0
  end
  subsection b
    set Radius = 1e-3
    set Velocity = 1; 2; 3
  end
  subsection c
    set Radius = 1e-3
    set Velocity = spin; 0
""") + end_at("1e-3"))
        lines = self.refused("parts.prm")
        self.assertEqual(len(lines), 3, lines)
        for line, name in zip(lines, ("disk", "b", "c")):
            self.assertRegex(line, rf"^parts\.prm:\d+: 'Bodies/{name}/", line)

    def test_columns_of_one_name(self):
        """A wall or an obstacle whose column of history.csv would be called as another is refused."""
        def scene(walls, obstacles):
            text = DISK + end_at("1e-3") + f"subsection Walls\n  set Names = {', '.join(walls)}\n"
            for k, wall in enumerate(walls):
                text += f"  subsection {wall}\n    set Point = 0, {-2e-3 - k * 1e-3}\n    set Normal = 0, 1\n  end\n"
            text += f"end\nsubsection Obstacles\n  set Names = {', '.join(obstacles)}\n"
            for k, obstacle in enumerate(obstacles):
                text += f"  subsection {obstacle}\n    set Points = {k + 3}e-3, 0; {k + 3}e-3, 1e-3\n  end\n"
            return write("columns.prm", text + "end\n")
        lines = self.refused(scene(["gravity", "floor", "external"], ["regularisation", "floor"]))
        for line, number, words in zip(
                lines, (19, 19, 34, 34),
                ("'Walls/Names': 'gravity' is not allowed: the column 'gravity_work_J_per_m' of history.csv has a meaning",
                 "'Walls/Names': 'external' is not allowed: the column 'external_work_J_per_m' of history.csv is the sum",
                 "'Obstacles/Names': 'regularisation' is not allowed: the column 'regularisation_work_J_per_m' of history.csv has",
                 "'Obstacles/Names': 'floor' is not allowed: the column 'floor_work_J_per_m' of history.csv is that of 'Walls/floor'")):
            self.assertTrue(line.startswith(f"columns.prm:{number}: {words}"), lines)
        self.assertEqual(len(lines), 4, lines)
        self.ends(scene(["left", "floor"], ["plate", "rake"]))

    def test_friction_of_a_folder(self):
        """`measure` reads the friction of a run from its parameters; a word there is told with its place."""
        os.makedirs("folder", exist_ok=True)
        for friction in ("rough", "-1", "nan", ""):
            write("folder/parameters.prm", f"subsection Contact\n  set Friction = {friction}\nend\n")
            status, printed, errors = softgrain("measure", "folder")
            self.assertEqual((status, printed), (2, ""))
            self.assertEqual(errors, "softgrain: error: folder/parameters.prm:2: 'Contact/Friction' = "
                             f"'{friction}' is not allowed: it must be a number of at least 0\n")
        write("folder/parameters.prm", "subsection Contact\n  set Friction = 0.3\nend\n")
        self.assertIn("has no snapshots.h5", softgrain("measure", "folder")[2])

    def test_many(self):
        text = DISK + end_at("1e-3") + "".join(f"set Wrong {n} = 1\n" for n in range(23))
        lines = self.refused(write("many.prm", text))
        self.assertEqual((len(lines), lines[-1]), (11, "and 13 more"))
        data = {f"Wrong {n}": None if n % 2 else 1 for n in range(12)}
        lines = self.refused(write("many.json", json.dumps(data, indent=1)))
        self.assertEqual((len(lines), lines[-1]), (11, "and 2 more"))
        lines = self.refused(write("many.prm", DISK + end_at("1e-3")), "--set", "Nonsense", "--set", "Threads=-1")
        self.assertEqual([line[:7] for line in lines], ["--set: "] * 2)

    def test_names(self):
        """Names that become parts of file names and columns."""
        for section, name, said in (("Materials", "y" * 300, "has 300 letters, 100 are allowed"), ("Bodies", "z" * 101, "has 101 letters"),
                                    ("Walls", "a/b", "cannot be a name"), ("Stages", "..", "cannot be a name"),
                                    ("Obstacles", "<b>", "cannot be a name")):
            lines = self.refused(write("named.prm", f"subsection {section}\n  set Names = {name}\nend\n"))
            self.assertEqual(len(lines), 1)
            self.assertIn(f"named.prm:2: '{section}/Names': '", lines[0])
            self.assertIn(said, lines[0])
            self.assertLess(len(lines[0]), 200)


class Writing(Cases):
    def test_check_writes_nothing(self):
        """Neither the file of the packing nor the library of aggregates, whether they are there or not."""
        scene = write("packed.prm", PACKED.format(save_to="packing.csv"))
        library = ["--set", "Primaries/Library=library.csv"]
        for there in (False, True):
            if there:
                write("packing.csv", "precious")
                write("library.csv", "key,x_m,y_m,radius_m\n")
            before = {name: (os.stat(name).st_mtime_ns, text_of(name)) for name in os.listdir(".") if os.path.isfile(name)}
            folders = sorted(os.listdir("."))
            for words in ([], ["--build"]):
                status, _, errors = softgrain("check", scene, *library, *words)
                self.assertEqual((status, errors), (0, ""))
            self.assertEqual(sorted(os.listdir(".")), folders)
            self.assertEqual({name: (os.stat(name).st_mtime_ns, text_of(name)) for name in before}, before)

    def test_run_overwrites_nothing_of_others(self):
        scene = write("packed.prm", PACKED.format(save_to="mine.csv"))
        write("mine.csv", "precious")
        status, _, errors = softgrain("run", scene, "--output", "first")
        self.assertEqual(status, 2)
        self.assertIn("packed.prm:15: 'Packing/Save to' = 'mine.csv' is not allowed: there is a file of that name", errors)
        self.assertEqual(text_of("mine.csv"), "precious")
        self.assertFalse(os.path.exists("first/history.csv"))
        for words in (["--overwrite"], []):  # then it is the same packing
            status, _, errors = softgrain("run", scene, "--output", "first" + "".join(words), *words)
            self.assertEqual((status, errors), (0, ""))
            self.assertTrue(text_of("mine.csv").startswith("x_m,y_m,radius_m\n"))
        write("mine.csv", "edited")
        status, _, errors = softgrain("run", scene, "--output", "first", "--restart", "--set", "Stop/End time=2e-7")
        self.assertEqual((status, errors), (0, ""))
        self.assertEqual(text_of("mine.csv"), "edited")  # a run that goes on wrote it when it began


class Libraries(Cases):
    def test_left_out(self):
        """Nothing is loaded; what only a library can know is listed, and other mistakes are still told."""
        scene = write("code.prm", "set Additional shared libraries = ./nothing.so\n" + DISK.replace(
            "set Names = grain\n", "set Names = grain\n  subsection grain\n    set Law = own\n    subsection Own law\n"
            "      set Strength = 3\n    end\n  end\n") + end_at("1e-3"))
        self.assertIn("'./nothing.so' cannot be loaded", self.refused(scene)[0])
        status, printed, errors = softgrain("check", scene, "--no-libraries")
        self.assertEqual((status, errors), (0, ""))
        self.assertEqual(printed.splitlines()[:3], [
            "library left out: ./nothing.so", "unknown without the libraries: code.prm:6: 'Materials/grain/Law' = 'own'",
            "unknown without the libraries: code.prm:7: 'Materials/grain/Own law'"])
        lines = self.refused(scene, "--no-libraries", "--set", "Bodies/disk/Radius=-1")
        self.assertEqual(len(lines), 1)
        self.assertIn("'Bodies/disk/Radius' = '-1' is not allowed", lines[0])
        # A library that nothing of the file needs.
        scene = write("code.prm", "set Additional shared libraries = ./nothing.so\n" + DISK + end_at("1e-3"))
        status, printed, errors = softgrain("check", scene, "--no-libraries")
        self.assertEqual((status, errors), (0, ""))
        self.assertIn("library left out: ./nothing.so", printed)
        self.assertIn("ends at", printed)


if __name__ == "__main__":
    unittest.addModuleCleanup(softgrain.end)
    unittest.main(argv=[sys.argv[0]])
