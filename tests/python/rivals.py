# SPDX-License-Identifier: LGPL-2.1-or-later
"""
Decks of benchmarks/ for other codes still run, where a code is here, and come to the forces of the reference as far as their coarse
meshes allow; and the meshes that they share are disks.

    rivals.py WORK
"""
import csv
import importlib.util
import os
import pathlib
import shutil
import subprocess
import sys
import unittest

import numpy as np

BENCHMARKS = pathlib.Path(__file__).resolve().parents[2] / "benchmarks"
WORK = pathlib.Path(sys.argv.pop(1))


def table(path):
    with open(path, encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    return {name: np.array([float(row[name]) for row in rows]) for name in rows[0]}


def run(deck, *words):
    done = subprocess.run([sys.executable, str(BENCHMARKS / deck), *map(str, words)], capture_output=True, text=True, check=False,
                          env={**os.environ, "OMP_NUM_THREADS": "1"})
    if done.returncode != 0:
        raise AssertionError(f"{deck}: {(done.stdout + done.stderr)[-2000:]}")


def off(found, reference):
    """Largest relative difference of the forces from d/R = .06 on."""
    exact = table(BENCHMARKS / "reference" / reference)
    ways = found["way_over_R"][found["way_over_R"] > 0.059]
    forces = np.interp(ways, found["way_over_R"], found["force_over_E_R"])
    return np.abs(forces / np.interp(ways, exact["way_over_R"], exact["force_over_E_R"]) - 1).max()


class Decks(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        shutil.rmtree(WORK, ignore_errors=True)
        WORK.mkdir(parents=True)

    @unittest.skipUnless(importlib.util.find_spec("getfem"), "GetFEM is not here")
    def test_getfem(self):
        run("getfem_disk.py", "--rings", "5,6", "--steps", 5, "--to", 0.3, "--out", WORK / "disk.csv")
        self.assertLess(off(table(WORK / "disk.csv"), "disk.csv"), 0.02)
        run("getfem_disk.py", "--rings", "5,6", "--plates", 4, "--steps", 5, "--to", 0.15, "--out", WORK / "plates.csv")
        self.assertLess(off(table(WORK / "plates.csv"), "plates.csv"), 0.02)

    @unittest.skipUnless(shutil.which("ccx"), "CalculiX is not here")
    def test_calculix(self):
        run("calculix_disk.py", WORK / "calculix", "--rings", "5,6", "--steps", 5, "--to", 0.15, "--out", WORK / "calculix.csv")
        self.assertLess(off(table(WORK / "calculix.csv"), "disk-ciarlet.csv"), 0.05)

    @unittest.skipUnless(shutil.which("lmp"), "LAMMPS is not here")
    def test_lammps(self):
        """One disk between the walls of a box as wide as it: two springs in a row."""
        (WORK / "one.csv").write_text("x_m,y_m,radius_m\n5e-3,5e-3,5e-3\n", encoding="utf-8")
        run("lammps_grains.py", WORK / "one.csv", WORK / "lammps", "--height", 10e-3, "--to", 9.8e-3, "--speed", 0.05, "--out", WORK / "one-out.csv")
        found = table(WORK / "one-out.csv")
        way = 5e-3 - found["height_m"] / 2
        self.assertAlmostEqual(found["force_N_per_m"][-1] / (2 * 0.323 * 10e6 * way[-1]), 1, delta=0.02)

    def test_mesh(self):
        sys.path.insert(0, str(BENCHMARKS))
        from calculix_disk import disk_mesh
        places, cells, rim = disk_mesh(12, 13)
        self.assertEqual(len(cells), 4 * 12**2 + 8 * 12 * 13)
        corners = places[np.array(cells)]
        areas = 0.5 * sum(corners[:, n, 0] * corners[:, (n + 1) % 4, 1] - corners[:, (n + 1) % 4, 0] * corners[:, n, 1] for n in range(4))
        self.assertGreater(areas.min(), 0)
        sides = len(rim)
        self.assertAlmostEqual(areas.sum(), 0.5 * sides * np.sin(2 * np.pi / sides), places=9)


if __name__ == "__main__":
    unittest.main()
